# The steps of snapping to linear constraints: elimination, target, evaluation, verification. The
# numbers of the last panel are those of the example in the manual.
#
#   linear_steps.py MESH.obj OUT.png

import sys

from method import (
    GIVEN,
    TARGET,
    draw_matrix,
    eliminated,
    grid,
    labelled,
    plane,
    reduced_rows,
)
from style import BLACK, BLUE, GRAY, GREEN, VERMILLION, np, plt, save
from uv_mesh import read_obj

WIDTH, GAP, BOTTOM, HEIGHT = 0.225, 0.0265, 0.28, 0.55


def panel(figure, column, title, text):
    left = 0.01 + (WIDTH + GAP) * column
    figure.text(left, 0.97, "%d  %s" % (column + 1, title), weight="bold", fontsize=15, va="top")
    figure.text(left, BOTTOM - 0.05, text, fontsize=12, va="top", linespacing=1.3)
    if column > 0:
        figure.text(left - GAP / 2, BOTTOM + HEIGHT / 2, "▶", fontsize=14, ha="center", va="center")
    return figure.add_axes([left, BOTTOM, WIDTH, HEIGHT])


def elimination(axes, mesh):
    rows, n = reduced_rows(mesh)
    pivots = eliminated(rows)
    order = [c for c, _ in pivots]
    free = [c for c in range(n) if c not in set(order)]
    draw_matrix(axes, [row for _, row in pivots], order + free, len(free))
    axes.text(len(order) + len(free) / 2, -2, "free", fontsize=12, color=GREEN, ha="center")


def target(axes):
    plane(axes)
    axes.plot(*np.array([GIVEN, TARGET]).T, color=GRAY, lw=1.6, ls="--")
    labelled(axes, GIVEN, "$\\bar x$  given", VERMILLION, (-1.5, 0.3))
    labelled(axes, TARGET, "$x^*$  target", BLUE, (1.5, -0.75))


def evaluation(axes):
    plane(axes)
    grid(axes)
    arrow = {"arrowstyle": "-|>", "lw": 2, "color": BLUE, "shrinkA": 6, "shrinkB": 5}
    axes.annotate("", (5, 3), TARGET, arrowprops=arrow)
    labelled(axes, TARGET, "$x^*$", BLUE, (-0.55, 0.45))
    labelled(axes, np.array([5, 3]), "$x$  exact", GREEN, (1.3, -0.75))


def verification(axes):
    axes.axis("off")
    step = 2**50
    x1, x2 = 112589991707808, 5291729559089696
    assert 3 * x1 + x2 == 5 * step
    lines = (
        ("$x_1$", x1, ""),
        ("$x_2$", x2, ""),
        ("$3\\,x_1 + x_2$", 3 * x1 + x2, "$=$ 5"),
    )
    for i, (name, number, end) in enumerate(lines):
        y = 0.83 - 0.27 * i
        axes.text(0.04, y, name + "  $=$", fontsize=13)
        axes.text(0.11, y - 0.125, "{:,} $\\cdot$ 2$^{{-50}}$".format(number), fontsize=12)
        axes.text(0.04, y - 0.25, end, fontsize=13, color=GREEN, weight="bold")


def main(mesh_name, out):
    figure = plt.figure(figsize=(16, 4))
    elimination(
        panel(
            figure,
            0,
            "Elimination",
            "Integer rows in echelon form. The free\nunknowns can be chosen; the others\n"
            "follow.",
        ),
        read_obj(mesh_name),
    )
    target(
        panel(
            figure,
            1,
            "Target",
            "The nearest real solution, by least\nsquares in floating point. It need not\nbe exact.",
        )
    )
    evaluation(
        panel(
            figure,
            2,
            "Evaluation",
            "Free unknowns are rounded to a grid.\nThe others follow in integers, and are\n"
            "grid points too.",
        )
    )
    verification(
        panel(
            figure,
            3,
            "Verification",
            "Each equation is checked exactly on\nthe final values. Then all values are\nwritten.",
        )
    )
    figure.patches.append(
        plt.Rectangle(
            (0.01 + 3 * (WIDTH + GAP), BOTTOM), WIDTH, HEIGHT, fill=False, ec=BLACK, lw=1,
            transform=figure.transFigure,
        )
    )
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
