# A parametrized ball of four blocks, as a file in the HEXEX format: a singular node at its center,
# from which four singular curves lead to the boundary. Each block has a chart of its own; all
# coordinates have noise.
#
#   ball.py OUT.hexex CUBES SPACING NOISE

import itertools
import sys

import numpy as np

# the other blocks, in an order that keeps the orientation
OTHERS = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
VERTICES = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)


def cells_of_cube():
    """Six tetrahedra along the diagonal, with positive orientation."""
    for order in itertools.permutations(range(3)):
        corners = [np.zeros(3, int)]
        for axis in order:
            corners.append(corners[-1] + np.eye(3, dtype=int)[axis])
        if np.linalg.det(np.array(corners[1:]) - corners[0]) < 0:
            corners[2], corners[3] = corners[3], corners[2]
        yield corners


def position(weights):
    """A tetrahedron, blown up to a ball."""
    b = np.array(weights, float) / sum(weights)
    p = b @ VERTICES
    length = np.linalg.norm(p)
    return p if length == 0 else (1 - 4 * b.min()) * p / length


def main(filename, cubes, spacing, noise):
    n = int(cubes)
    random = np.random.default_rng(1)
    names, points, lines = {}, [], []
    for block in range(4):
        offset = random.uniform(-3, 3, 3).round()
        axes = np.roll(range(3), block)
        for low in itertools.product(range(n), repeat=3):
            for cell in cells_of_cube():
                vertices, numbers = [], []
                for p in (np.array(low) + corner for corner in cell):
                    weights = [n] * 4
                    for c in range(3):
                        weights[OTHERS[block][c]] = int(p[c])
                    if tuple(weights) not in names:
                        names[tuple(weights)] = len(points)
                        points.append(position(weights))
                    vertices.append(names[tuple(weights)])
                    u = p[axes] / float(spacing) + offset
                    numbers.extend(u + random.uniform(-1, 1, 3) * float(noise))
                lines.append(" ".join(map(str, vertices)) + " " + " ".join(map(repr, numbers)))
    with open(filename, "w", encoding="utf-8") as out:
        print(len(points), file=out)
        for p in points:
            print(*map(repr, p.tolist()), file=out)
        print(len(lines), *lines, sep="\n", file=out)


if __name__ == "__main__":
    main(*sys.argv[1:])
