# Rounds the translations of a seamless map to integers, so that a grid drawn on the surface goes on
# across the cuts. Only for pictures: a least-squares problem in floating point, with constraints as
# heavy weights, where one translation after the other is fixed to the nearest integer.

import sys

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from uv_mesh import next_of, read_obj, rotated, write_obj

HEAVY = 1e5


def sectors(mesh):
    """The index of the sector of each corner, and how many there are."""
    parent = np.arange(3 * len(mesh.faces))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for h, o in enumerate(mesh.opposite):
        if o >= 0 and not mesh.is_cut[h]:
            parent[root(h)] = root(next_of(o))
            parent[root(next_of(h))] = root(o)
    roots = np.array([root(i) for i in range(len(parent))])
    names, index = np.unique(roots, return_inverse=True)
    return index, len(names)


class Rows:
    """Rows of a least-squares problem; unknowns are numbers 0 to n - 1."""

    def __init__(self):
        self.i, self.j, self.x, self.right = [], [], [], []

    def add(self, terms, right, weight):
        for j, x in terms:
            self.i.append(len(self.right))
            self.j.append(j)
            self.x.append(weight * x)
        self.right.append(weight * right)

    def solution(self, n):
        matrix = coo_matrix((self.x, (self.i, self.j)), shape=(len(self.right), n)).tocsc()
        normal = (matrix.T @ matrix).tocsc()
        return splu(normal).solve(matrix.T @ np.array(self.right))


def integer_map(mesh, scale):
    """The map, times `scale`, with gradients changed as little as integer translations allow."""
    sector, count = sectors(mesh)
    branches = mesh.branches()
    n = 2 * count + 2 * len(branches)
    rows = Rows()
    p = mesh.points[mesh.faces]
    area = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
    for f in range(len(mesh.faces)):
        for i in range(3):
            a, b = 3 * f + i, 3 * f + (i + 1) % 3
            difference = scale * (mesh.uv[f, (i + 1) % 3] - mesh.uv[f, i])
            length = np.linalg.norm(p[f, (i + 1) % 3] - p[f, i])
            for k in range(2):
                rows.add(
                    [(2 * sector[b] + k, 1), (2 * sector[a] + k, -1)],
                    difference[k],
                    np.sqrt(area[f]) / length,
                )
    for k in range(2):
        rows.add([(2 * sector[0] + k, 1)], 0, 1)
    for b, branch in enumerate(branches):
        for h in branch:
            o = mesh.opposite[h]
            for here, there in ((h, next_of(o)), (next_of(h), o)):
                m = np.array(
                    [rotated((1, 0), mesh.rotation[h]), rotated((0, 1), mesh.rotation[h])]
                ).T
                for k in range(2):
                    rows.add(
                        [
                            (2 * sector[there] + k, 1),
                            (2 * sector[here], -m[k, 0]),
                            (2 * sector[here] + 1, -m[k, 1]),
                            (2 * count + 2 * b + k, -1),
                        ],
                        0,
                        HEAVY,
                    )
    fixed = set()
    while True:
        x = rows.solution(n)
        t = x[2 * count :]
        off = np.abs(t - np.rint(t))
        fixed.update(np.nonzero(off < 1e-4)[0])
        open_ones = [j for j in range(len(t)) if j not in fixed]
        if not open_ones:
            return mesh.with_uv(x[: 2 * count].reshape(-1, 2)[sector].reshape(-1, 3, 2))
        nearest = sorted(open_ones, key=lambda j: off[j])[: max(1, len(open_ones) // 6)]
        for j in nearest:
            rows.add([(2 * count + j, 1)], np.rint(t[j]), HEAVY)
            fixed.add(j)


if __name__ == "__main__":  # integer_map.py IN.obj OUT.obj SCALE
    given, written, scale = sys.argv[1:]
    write_obj(written, integer_map(read_obj(given), float(scale)))
