# Meshes of polygons that all have the same number of corners, for the renderer, and what is drawn of
# them.

import numpy as np

from renderer import visible_pieces


class Polygon_mesh:
    def __init__(self, points, polygons):
        self.points, self.polygons = np.array(points, float), np.array(polygons, int)
        corners = range(1, self.polygons.shape[1] - 1)
        self.faces = np.concatenate([self.polygons[:, [0, k, k + 1]] for k in corners])

    def face_normals(self):
        p = self.points[self.faces]
        return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])

    def edges(self):
        ends = [self.polygons, np.roll(self.polygons, -1, axis=1)]
        return np.unique(np.sort(np.stack(ends, axis=-1).reshape(-1, 2), axis=1), axis=0)

    def irregular_vertices(self, valence):
        valences = np.bincount(self.polygons.reshape(-1), minlength=len(self.points))
        return np.nonzero(valences != valence)[0]


def read_polygons(filename):
    """The mesh of an OBJ file, with the colors of its vertices, gray if the file has none."""
    numbers, polygons = [], []
    with open(filename, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                numbers.append([float(x) for x in words[1:]])
            elif words[:1] == ["f"]:
                polygons.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    numbers = np.array(numbers)
    mesh = Polygon_mesh(numbers[:, :3], polygons)
    mesh.colors = numbers[:, 3:6] if numbers.shape[1] >= 6 else np.full((len(numbers), 3), 0.95)
    return mesh


def draw_edges(axes, buffer, mesh, color, width):
    for edge in mesh.edges():
        for piece in visible_pieces(buffer, mesh.points[edge]):
            axes.plot(*piece.T, color=color, lw=width)


def draw_points(axes, buffer, camera, points, color):
    seen = camera.project(points[buffer.visible(points)])
    axes.plot(seen[:, 0], seen[:, 1], "o", color=color, ms=6)
