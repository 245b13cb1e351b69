# Hexahedra in a MEDIT file, cut open: the half behind a plane through the middle, colored by shape
# where the cut shows it, with the edges inside around which there are other than four hexahedra.
#
#   hexahedra.py IN.mesh OUT.png

import sys

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize

from style import VERMILLION, plt

FACETS = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]]
NEIGHBORS = [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]]
VIEW = np.array([0.5, -0.72, 0.48])  # towards the viewer
SHAPES = LinearSegmentedColormap.from_list("shapes", ["#cc3311", "#eedd88", "#4477aa"])
BOUNDARY = np.array([0.9, 0.91, 0.93])


def read(filename):
    """The points and hexahedra."""
    words = open(filename, encoding="ascii").read().split()

    def numbers(keyword, columns, kind):
        begin = words.index(keyword) + 2
        count = int(words[begin - 1])
        return np.array(words[begin : begin + count * columns], kind).reshape(count, columns)

    points = numbers("Vertices", 4, float)[:, :3]
    return points, numbers("Hexahedra", 9, int)[:, :8] - 1


def scaled_jacobians(points, hexahedra):
    result = np.ones(len(hexahedra))
    for corner, ends in enumerate(NEIGHBORS):
        edges = [points[hexahedra[:, k]] - points[hexahedra[:, corner]] for k in ends]
        edges = [e / np.linalg.norm(e, axis=1)[:, None] for e in edges]
        result = np.minimum(result, np.einsum("ij,ij->i", edges[0], np.cross(edges[1], edges[2])))
    return result


def sides(hexahedra, chosen):
    """The quadrilaterals that a single one of the chosen hexahedra has, by sorted vertices."""
    result = {}
    for i in chosen:
        for facet in FACETS:
            quad = hexahedra[i][facet]
            key = tuple(sorted(quad))
            if result.pop(key, None) is None:
                result[key] = (i, quad)
    return result


def irregular_edges(hexahedra, boundary):
    """The edges inside with other than four hexahedra."""
    count = {}
    for h in hexahedra:
        for edge in {tuple(sorted((h[i], h[j]))) for i in range(8) for j in NEIGHBORS[i]}:
            count[edge] = count.get(edge, 0) + 1
    outside = {tuple(sorted((quad[i - 1], quad[i]))) for _, quad in boundary.values() for i in range(4)}
    return [edge for edge, n in count.items() if n != 4 and edge not in outside]


def main():
    points, hexahedra = read(sys.argv[1])
    shapes = scaled_jacobians(points, hexahedra)
    normal = VIEW / np.linalg.norm(VIEW)
    depth = points[hexahedra].mean(axis=1) @ normal
    boundary = sides(hexahedra, range(len(hexahedra)))
    middle = (depth.min() + depth.max()) / 2
    cut = sides(hexahedra, np.flatnonzero(depth <= middle + 1e-9))

    across = np.cross([0, 0, 1], normal)
    across /= np.linalg.norm(across)
    frame = np.stack([across, np.cross(normal, across)])
    light = normal + [0.1, -0.1, 0.6]
    light /= np.linalg.norm(light)
    polygons, colors, depths = [], [], []
    for key, (i, quad) in cut.items():
        corners = points[quad]
        n = np.cross(corners[2] - corners[0], corners[3] - corners[1])
        if n @ normal <= 0:
            continue
        color = BOUNDARY if key in boundary else np.array(SHAPES(shapes[i])[:3])
        polygons.append(corners @ frame.T)
        colors.append(color * (0.72 + 0.28 * abs(n @ light) / np.linalg.norm(n)))
        depths.append(corners.mean(axis=0) @ normal)
    order = np.argsort(depths)
    figure, axes = plt.subplots(figsize=(6, 5))
    axes.add_collection(PolyCollection([polygons[k] for k in order], edgecolors="#334455",
                                       facecolors=[colors[k] for k in order], linewidths=0.5))
    lines = [points[list(edge)] @ frame.T for edge in irregular_edges(hexahedra, boundary)]
    axes.add_collection(LineCollection(lines, colors=VERMILLION, linewidths=2.5))
    axes.autoscale()
    bar = figure.colorbar(ScalarMappable(Normalize(0, 1), SHAPES), ax=axes, shrink=0.6, pad=0.02)
    bar.set_label("scaled Jacobian")
    axes.set_aspect("equal")
    axes.axis("off")
    figure.savefig(sys.argv[2], dpi=150, bbox_inches="tight", pad_inches=0.05)


main()
