# The isolines of maps with rotational symmetry of order 3 and 6 on a sphere: three directions,
# where u, v, and u + v are integers; and the cones. And a triangle mesh that was extracted.
#
#   symmetries.py DIAMOND.obj TRIANGLE.obj TRIANGLES.off OUT.png
#
# The maps have lattice coordinates.

import sys

from polygon_mesh import Polygon_mesh, draw_edges, draw_points
from renderer import Buffer, Camera, distance_to_isolines
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


def read_off(filename):
    with open(filename, encoding="utf-8") as file:
        words = file.read().split()[1:]
    n, m = int(words[0]), int(words[1])
    return Polygon_mesh(np.array(words[3 : 3 + 3 * n], float).reshape(n, 3),
                        np.array(words[3 + 3 * n :], int).reshape(m, 4)[:, 1:])


def draw_triangles(axis, mesh, cones, camera):
    buffer = Buffer(mesh, camera)
    colors = np.tile(SURFACE, (np.count_nonzero(buffer.face >= 0), 1))
    axis.imshow(buffer.image(colors, is_smooth=False))
    draw_edges(axis, buffer, mesh, BLUE, 0.5)
    draw_points(axis, buffer, camera, cones, CONE)
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
        draw_points(axis, buffer, camera, mesh.points[[0, 3, 11]], CONE)
        axis.set_axis_off()
    mesh = read_off(triangles)
    cones = mesh.points[mesh.irregular_vertices(6)]
    camera = Camera(-cones.sum(axis=0) - (0.2, 0.5, 0.1), (0, 0, 1), (0, 0, 0), size,
                    (pixels, pixels))
    draw_triangles(axes[2], mesh, cones, camera)
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    save(figure, out)


main(*sys.argv[1:])
