# A triangle mesh with one coordinate pair per corner, read from an OBJ file, and what the figures
# ask of it: cut edges, rotations, cones, nodes, branches.
#
# Halfedge 3 f + i leads from corner i of face f to corner i + 1. All arrays are constant once the
# mesh is built; `with_uv` gives the same mesh with other coordinates.

import copy
import sys

import numpy as np


def rotated(u, turns):
    """The points, rotated by a number of quarter turns."""
    u, turns = np.asarray(u, float), np.asarray(turns) % 4
    c = np.array([1, 0, -1, 0])[turns]
    s = np.array([0, 1, 0, -1])[turns]
    return np.stack([c * u[..., 0] - s * u[..., 1], s * u[..., 0] + c * u[..., 1]], axis=-1)


def next_of(h):
    return h - h % 3 + (h + 1) % 3


class Uv_mesh:
    def __init__(self, points, faces, uv, is_feature=(), tolerance=1e-6):
        self.points, self.faces, self.uv = points, faces, uv
        self.source = faces.reshape(-1)
        self.target = np.roll(faces, -1, axis=1).reshape(-1)
        self.opposite = self._opposites()
        self.features = {frozenset(edge) for edge in is_feature}
        self._read_transitions(tolerance)

    def with_uv(self, uv):
        result = copy.copy(self)
        result.uv = uv
        return result

    def _opposites(self):
        of = {(a, b): h for h, (a, b) in enumerate(zip(self.source, self.target))}
        return np.array([of.get((b, a), -1) for a, b in zip(self.source, self.target)])

    def _read_transitions(self, tolerance):
        """Rotation and translation of each halfedge, from its chart to that of its opposite."""
        flat = self.uv.reshape(-1, 2)
        h = np.arange(len(self.source))
        o = self.opposite
        a, b = flat[h], flat[next_of(h)]
        a2, b2 = flat[next_of(o)], flat[o]  # the same ends on the other side
        residuals = np.stack([np.abs(rotated(b - a, k) - (b2 - a2)).max(axis=1) for k in range(4)])
        self.rotation = np.where(o < 0, 0, residuals.argmin(axis=0))
        self.translation = (
            (a2 - rotated(a, self.rotation)) + (b2 - rotated(b, self.rotation))
        ) / 2
        extent = np.ptp(flat, axis=0).max()
        differs = np.maximum(np.abs(a - a2), np.abs(b - b2)).max(axis=1) > tolerance * extent
        self.is_cut = (o >= 0) & differs

    def cones(self):
        """Vertex -> quarter turns of missing angle, where it is not 0 (angles, so no folds)."""
        t = self.uv
        angle = np.zeros(len(self.points))
        for i in range(3):
            a, b = t[:, (i + 1) % 3] - t[:, i], t[:, (i + 2) % 3] - t[:, i]
            turn = np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(axis=1))
            np.add.at(angle, self.faces[:, i], turn)
        border = set(self.source[self.opposite < 0])
        index = np.rint(4 - angle / (np.pi / 2)).astype(int)
        return {v: index[v] for v in np.nonzero(index)[0] if v not in border}

    def branches(self):
        """The cuts, as lists of halfedges from node to node."""
        border = set(self.source[self.opposite < 0])
        at = {}
        for h in np.nonzero(self.is_cut)[0]:
            at.setdefault(self.source[h], []).append(h)
        cones = self.cones()
        nodes = {v for v, hs in at.items() if len(hs) != 2 or v in border or v in cones}
        self.nodes = nodes
        done, result = set(), []

        def follow(h):
            branch = []
            while h not in done:
                done.update((h, self.opposite[h]))
                branch.append(h)
                v = self.target[h]
                if v in nodes:
                    break
                h = next(g for g in at[v] if g != self.opposite[branch[-1]])
            if branch:
                result.append(branch)

        for v in sorted(nodes):
            for h in at[v]:
                follow(h)
        for h in sorted(np.nonzero(self.is_cut)[0]):
            follow(h)
        return result

    def face_normals(self):
        """As long as twice the area."""
        p = self.points[self.faces]
        return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])

    def vertex_normals(self):
        normal = self.face_normals()
        result = np.zeros_like(self.points)
        for i in range(3):
            np.add.at(result, self.faces[:, i], normal)
        return result / np.maximum(np.linalg.norm(result, axis=1, keepdims=True), 1e-300)


def read_obj(filename, tolerance=1e-6):
    points, uvs, faces, corners, features = [], [], [], [], []
    with open(filename, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                points.append([float(x) for x in words[1:4]])
            elif words[0] == "vt":
                uvs.append([float(x) for x in words[1:3]])
            elif words[0] == "f":
                indices = [word.split("/") for word in words[1:4]]
                faces.append([int(i[0]) - 1 for i in indices])
                corners.append([int(i[1]) - 1 for i in indices])
            elif words[0] == "l":
                features.append([int(i) - 1 for i in words[1:3]])
    return Uv_mesh(
        np.array(points), np.array(faces), np.array(uvs)[np.array(corners)], features, tolerance
    )


def with_noise(mesh, size):
    """The same for all corners of a vertex that have the same coordinates."""
    random = np.random.default_rng(1)
    keys = np.column_stack([mesh.faces.reshape(-1, 1), mesh.uv.reshape(-1, 2)])
    _, index = np.unique(keys, axis=0, return_inverse=True)
    noise = size * random.uniform(-1, 1, (index.max() + 1, 2))
    return mesh.with_uv(mesh.uv + noise[index.reshape(-1)].reshape(-1, 3, 2))


def write_obj(filename, mesh):
    with open(filename, "w", encoding="utf-8") as out:
        for p in mesh.points:
            out.write("v %.17g %.17g %.17g\n" % tuple(p))
        for u in mesh.uv.reshape(-1, 2):
            out.write("vt %.17g %.17g\n" % tuple(u))
        for f, face in enumerate(mesh.faces):
            out.write(
                "f "
                + " ".join("%d/%d" % (v + 1, 3 * f + i + 1) for i, v in enumerate(face))
                + "\n"
            )
        for edge in sorted(sorted(edge) for edge in mesh.features):
            out.write("l %d %d\n" % (edge[0] + 1, edge[1] + 1))


if __name__ == "__main__":  # uv_mesh.py IN.obj OUT.obj NOISE
    write_obj(sys.argv[2], with_noise(read_obj(sys.argv[1]), float(sys.argv[3])))
