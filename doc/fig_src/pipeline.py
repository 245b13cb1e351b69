# The steps of snapping, from the coordinates that are given to those that are written.
#
#   pipeline.py OUT.svg

import sys

from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

from style import BLACK, PALE_BLUE, PALE_GREEN, PALE_ORANGE, plt, save

MESH, EXACT, FLOATING = PALE_ORANGE, PALE_BLUE, PALE_GREEN
STEPS = (
    (MESH, "Transitions", "rotation and\ntranslation of\neach edge"),
    (MESH, "Cut complex", "sectors, nodes,\nbranches, aligned\nedges"),
    (EXACT, "Rows", "of the nodes and\nbranches alone,\nin integers"),
    (EXACT, "Elimination", "pivots of 1 and −1\nfirst, overflow is\ndetected"),
    (FLOATING, "Target", "the least-squares\nsolution"),
    (EXACT, "Evaluation", "rounded to a grid,\nback-substitution\nin integers"),
    (EXACT, "Expansion", "the sectors between\nthe nodes follow"),
    (MESH, "Orientation", "flipped faces\nare repaired"),
    (EXACT, "Verification", "of all equations, in\nexact arithmetic"),
    (MESH, "Writing", "all or nothing"),
)


def main(out):
    figure = plt.figure(figsize=(14, 5.2))
    axes = figure.add_axes([0, 0, 1, 1])
    axes.set_xlim(0, 14)
    axes.set_ylim(0, 5.2)
    axes.axis("off")
    width, height = 2.3, 1.55
    for i, (color, title, text) in enumerate(STEPS):
        row, column = divmod(i, 5)
        x, y = 1.45 + 2.77 * column, 4.25 - 2.1 * row
        axes.add_patch(
            FancyBboxPatch(
                (x - width / 2, y - height / 2),
                width,
                height,
                fc=color,
                boxstyle="round,pad=0,rounding_size=0.12",
                ec=BLACK,
                lw=1.4,
            )
        )
        axes.text(
            x,
            y + 0.5,
            "%d  %s" % (i + 1, title),
            weight="bold",
            fontsize=14,
            ha="center",
            va="center",
        )
        axes.text(x, y - 0.2, text, fontsize=12.5, ha="center", va="center", linespacing=1.25)
        style = {
            "arrowstyle": "-|>",
            "mutation_scale": 18,
            "lw": 2,
            "color": BLACK,
            "shrinkA": 0,
            "shrinkB": 0,
        }
        if column < 4:
            axes.add_patch(FancyArrowPatch((x + width / 2, y), (x + width / 2 + 0.47, y), **style))
        elif row == 0:
            way = [
                (x, y - height / 2),
                (x, y - 1.05),
                (1.45, y - 1.05),
                (1.45, y - 2.1 + height / 2),
            ]
            axes.plot(*zip(*way[:3]), color=BLACK, lw=2)
            axes.add_patch(FancyArrowPatch(way[2], way[3], **style))
    for i, (color, text) in enumerate(
        (
            (MESH, "knows the mesh"),
            (EXACT, "integers, no mesh"),
            (FLOATING, "floating point: proposes, never decides"),
        )
    ):
        x = (0.3, 3.1, 6.3)[i]
        axes.add_patch(
            FancyBboxPatch(
                (x, 0.37),
                0.5,
                0.3,
                fc=color,
                ec=BLACK,
                lw=1.2,
                boxstyle="round,pad=0,rounding_size=0.05",
            )
        )
        axes.text(x + 0.65, 0.52, text, fontsize=13, va="center")
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
