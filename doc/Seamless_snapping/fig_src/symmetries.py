# The isolines of maps with rotational symmetry of order 3 and 6 on a sphere: three directions,
# where u, v, and u + v are integers; and the cones. And a triangle mesh that was extracted.
#
#   symmetries.py DIAMOND.obj TRIANGLE.obj TRIANGLES.off OUT.png
#
# The maps have lattice coordinates.

import sys

from renderer import Buffer, Camera, distance_to_isolines, visible_pieces
from style import BLUE, VERMILLION, np, plt, rgb, save
from uv_mesh import read_obj

OMEGA = np.exp(1j * np.pi / 3)
SURFACE, LINE, CONE = rgb("#dceaf4"), rgb(BLUE), VERMILLION


def with_isolines(mesh, cones, number):
    """The first cone at the origin, and `number` units from there to the last, so that isolines
    meet across cuts; and u + v as a third coordinate."""
    z = mesh.uv[..., 0] + OMEGA * mesh.uv[..., 1]
    first, last = (z[mesh.faces == v][0] for v in cones)
    z = (z - first) / (last - first) * number
    b = z.imag / OMEGA.imag
    a = z.real - b / 2
    return mesh.with_uv(np.stack([a, b, a + b], axis=-1))


class Triangles:
    """What the renderer asks of a mesh, from an OFF file."""

    def __init__(self, filename):
        with open(filename, encoding="utf-8") as file:
            words = file.read().split()[1:]
        n, m = int(words[0]), int(words[1])
        self.points = np.array(words[3 : 3 + 3 * n], float).reshape(n, 3)
        self.faces = np.array(words[3 + 3 * n :], int).reshape(m, 4)[:, 1:]

    def face_normals(self):
        p = self.points[self.faces]
        return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])

    def edges(self):
        ends = np.stack([self.faces, np.roll(self.faces, -1, axis=1)], axis=-1).reshape(-1, 2)
        return np.unique(np.sort(ends, axis=1), axis=0)

    def irregular_vertices(self):
        return np.nonzero(np.bincount(self.faces.reshape(-1)) != 6)[0]


def draw_triangles(axis, mesh, camera):
    buffer = Buffer(mesh, camera)
    colors = np.tile(SURFACE, (np.count_nonzero(buffer.face >= 0), 1))
    axis.imshow(buffer.image(colors, is_smooth=False))
    for edge in mesh.edges():
        for piece in visible_pieces(buffer, mesh.points[edge]):
            axis.plot(*piece.T, color=BLUE, lw=0.5)
    cones = mesh.points[mesh.irregular_vertices()]
    seen = camera.project(cones[buffer.visible(cones)])
    axis.plot(seen[:, 0], seen[:, 1], "o", color=CONE, markersize=6)
    axis.set_axis_off()


def main(diamond, triangle, triangles, out):
    pixels, size = 700, 2.1
    figure, axes = plt.subplots(1, 3, figsize=(12, 4))
    for axis, name, number in zip(axes, (diamond, triangle), (12, 16)):
        mesh = with_isolines(read_obj(name), (0, 11), number)
        camera = Camera(-mesh.points[0] - mesh.points[8], mesh.points[5], (0, 0, 0), size,
                        (pixels, pixels))
        buffer = Buffer(mesh, camera)
        colors = np.tile(SURFACE, (np.count_nonzero(buffer.face >= 0), 1))
        colors[distance_to_isolines(buffer, mesh.uv).min(axis=1) < 0.006] = LINE
        axis.imshow(buffer.image(colors))
        cones = mesh.points[[0, 3, 11]]
        seen = camera.project(cones[buffer.visible(cones)])
        axis.plot(seen[:, 0], seen[:, 1], "o", color=CONE, markersize=6)
        axis.set_axis_off()
    mesh = Triangles(triangles)
    camera = Camera(-mesh.points[mesh.irregular_vertices()].sum(axis=0) - (0.2, 0.5, 0.1),
                    (0, 0, 1), (0, 0, 0), size, (pixels, pixels))
    draw_triangles(axes[2], mesh, camera)
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    save(figure, out)


main(*sys.argv[1:])
