# The isolines of maps with rotational symmetry of order 3 and 6 on a sphere: three directions,
# where u, v, and u + v are integers; and the cones.
#
#   symmetries.py DIAMOND.obj TRIANGLE.obj OUT.png
#
# The files have lattice coordinates.

import sys

from renderer import Buffer, Camera, distance_to_isolines
from style import BLUE, VERMILLION, np, plt, rgb
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


def main(diamond, triangle, out):
    pixels, size = 700, 2.1
    figure, axes = plt.subplots(1, 2, figsize=(8, 4))
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
        axis.plot(seen[:, 0], seen[:, 1], "o", color=CONE, markersize=4)
        axis.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    figure.savefig(out, dpi=100)


main(*sys.argv[1:])
