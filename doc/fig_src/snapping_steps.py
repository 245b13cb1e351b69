# The steps of snapping a parametrization: transitions, reduction, solution, orientation.
#
#   snapping_steps.py MESH.obj OUT.png

import sys

from linear_steps import evaluation, panel
from method import COLORS, reduction
from repair import GIVEN, RING, SNAPPED_END, draw, kernel
from style import BLUE, GREEN, plt, save
from uv_mesh import read_obj


def orientation(axes):
    ring = RING.copy()
    ring[2] = SNAPPED_END
    moved = SNAPPED_END + (-0.12, 0.42)
    draw(axes, ring, moved)
    axes.fill(*kernel(ring).T, facecolor=GREEN, alpha=0.35, edgecolor=GREEN, lw=2, zorder=3)
    arrow = {"arrowstyle": "-|>", "lw": 2.2, "color": BLUE, "mutation_scale": 20, "shrinkB": 7}
    axes.annotate("", moved, GIVEN, zorder=7, arrowprops=arrow)


def main(mesh_name, out):
    mesh = read_obj(mesh_name)
    figure = plt.figure(figsize=(16, 4))
    axes = panel(
        figure,
        0,
        "Transitions",
        "The coordinates determine the cuts and\ntheir rotations.",
    )
    reduction(axes, mesh, is_by_rotation=True)
    for i, color in enumerate(COLORS):
        axes.text(10 + 115 * i, 30, "%d°" % (90 * i), fontsize=13, color=color, weight="bold")
    reduction(
        panel(
            figure,
            1,
            "Reduction",
            "Only the nodes and one translation for\neach branch enter the system.",
        ),
        mesh,
    )
    evaluation(
        panel(
            figure,
            2,
            "Solution",
            "A solution of the system on a grid, near\nthe least-squares optimum. The other\n"
            "vertices follow.",
        )
    )
    orientation(
        panel(
            figure,
            3,
            "Orientation",
            "If a face is flipped, a vertex moves\ninto the kernel of its ring. Then all\n"
            "equations are verified.",
        )
    )
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
