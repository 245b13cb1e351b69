# What quads can be told: sizes, a plane of symmetry; and colors that they have taken over.
#
#   control.py SIZES.obj SYMMETRIC.obj PAINTED.obj REMESHED.obj OUT.png

import sys

from polygon_mesh import draw_edges, draw_points, read_polygons
from renderer import Buffer, Camera, visible_pieces
from style import BLACK, VERMILLION, np, plt, rgb, save, show


def draw(axes, mesh, camera, width):
    buffer = Buffer(mesh, camera)
    colors = buffer.interpolated(mesh.colors[mesh.faces])
    show(axes, buffer.image(colors, is_smooth=False))
    draw_edges(axes, buffer, mesh, BLACK, width)
    return buffer


def draw_plane(axes, buffer, mesh, x):
    """The edges of quads that lie in the plane across the x-axis."""
    ends = mesh.points[mesh.edges()]
    for edge in ends[np.abs(ends[:, :, 0] - x).max(axis=1) < 1e-6]:
        for piece in visible_pieces(buffer, edge):
            axes.plot(*piece.T, color=VERMILLION, lw=3)


def main(sizes_name, symmetric_name, painted_name, remeshed_name, out):
    sizes, symmetric, painted, remeshed = (
        read_polygons(name) for name in (sizes_name, symmetric_name, painted_name, remeshed_name)
    )
    camera = Camera((0.2, 1, -0.95), (0, 0, 1), painted.points.mean(axis=0), 5.3, (700, 440))
    panels = (
        (sizes, "Sizes: edges four times as long at the right as at the left", 0.6),
        (symmetric, "Symmetry: the left half is the mirror image of the right one", 0.6),
        (painted, "Triangles with colors at their vertices", 0.15),
        (remeshed, "Quads that have taken them over", 0.6),
    )
    figure = plt.figure(figsize=(14, 9.4))
    for i, (mesh, title, width) in enumerate(panels):
        left, bottom = 0.5 * (i % 2), 0.5 * (1 - i // 2)
        axes = figure.add_axes([left, bottom, 0.5, 0.45])
        buffer = draw(axes, mesh, camera, width)
        if i < 2:
            draw_points(axes, buffer, camera, mesh.points[mesh.irregular_vertices(4)], VERMILLION)
        if i == 1:
            draw_plane(axes, buffer, mesh, mesh.points[:, 0].mean())
        figure.text(left + 0.25, bottom + 0.465, title, ha="center", va="center")
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
