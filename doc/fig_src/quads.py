# Quads: the grid of a seamless map, whose lines don't meet across the cuts, and the mesh of quads
# that its integer-grid map describes.
#
#   quads.py SNAPPED.obj QUADS.obj OUT.png

import sys

from matplotlib.lines import Line2D

from polygon_mesh import draw_edges, draw_points, read_polygons
from renderer import Buffer, Camera, distance_to_isolines, visible_pieces
from style import BLACK, BLUE, ORANGE, VERMILLION, np, plt, rgb, save, show
from uv_mesh import read_obj


def draw_map(axes, mesh, camera):
    buffer = Buffer(mesh, camera)
    colors = np.full(((buffer.face >= 0).sum(), 3), 0.95)
    near = distance_to_isolines(buffer, mesh.uv) < 0.009
    colors[near[:, 1]] = rgb(ORANGE)
    colors[near[:, 0]] = rgb(BLUE)
    show(axes, buffer.image(colors))
    for h in np.nonzero(mesh.is_cut)[0]:
        for piece in visible_pieces(buffer, mesh.points[[mesh.source[h], mesh.target[h]]]):
            axes.plot(*piece.T, color=BLACK, lw=2)
    lines = [Line2D([], [], color=c, lw=3) for c in (BLUE, ORANGE, BLACK)]
    axes.legend(
        lines,
        ["$u$ is an integer", "$v$ is an integer", "cut"],
        loc="upper center",
        bbox_to_anchor=(0.5, 0.03),
        ncol=3,
        frameon=False,
    )


def draw_quads(axes, mesh, camera):
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.95), is_smooth=False))
    draw_edges(axes, buffer, mesh, BLACK, 0.6)
    draw_points(axes, buffer, camera, mesh.points[mesh.irregular_vertices(4)], VERMILLION)
    axes.legend(
        [Line2D([], [], color=VERMILLION, marker="o", lw=0, ms=6)],
        ["vertices whose valence is not 4: the cones"],
        loc="upper center",
        bbox_to_anchor=(0.5, 0.03),
        frameon=False,
    )


def main(map_name, quads_name, out):
    mesh, quads = read_obj(map_name), read_polygons(quads_name)
    camera = Camera((0.35, 1, -0.95), (0, 0, 1), mesh.points.mean(axis=0), 5.5, (700, 520))
    figure = plt.figure(figsize=(14, 6))
    titles = (
        "A seamless map: its grid breaks where cuts\nhave translations that are not integers",
        "Its integer-grid map: the grid goes on everywhere,\nand is a mesh of %d quads"
        % len(quads.polygons),
    )
    for i, (draw, shown) in enumerate(((draw_map, mesh), (draw_quads, quads))):
        axes = figure.add_axes([0.5 * i, 0.07, 0.5, 0.8])
        draw(axes, shown, camera)
        figure.text(0.25 + 0.5 * i, 0.93, titles[i], ha="center", va="center", linespacing=1.3)
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
