# Target and evaluation of one equation, and the latter by itself as a small picture. The pictures of
# the steps use the drawings of a surface and of its system.
#
#   method.py EQUATION_OUT.png SMALL_OUT.png

import sys

from integer_map import sectors
from renderer import Buffer, Camera, visible_pieces
from style import BLACK, BLUE, GRAY, GREEN, ORANGE, PURPLE, VERMILLION, np, plt, save, show
from uv_mesh import next_of, rotated

COLORS = (BLUE, ORANGE, GREEN, PURPLE)


def reduced_rows(mesh):
    """u' = R u + t at both ends of each branch, as integer rows (lists of column -> entry)."""
    sector, _ = sectors(mesh)
    columns, rows = {}, []
    for b, branch in enumerate(mesh.branches()):
        first, last = branch[0], branch[-1]
        ends = [(first, next_of(mesh.opposite[first])), (next_of(last), mesh.opposite[last])]
        m = np.rint([rotated((1, 0), mesh.rotation[first]), rotated((0, 1), mesh.rotation[first])])
        for here, there in ends:
            for k in range(2):
                row = {}
                for name, entry in (
                    (("t", b, k), -1),
                    (("u", sector[there], k), 1),
                    (("u", sector[here], 0), -int(m[0, k])),
                    (("u", sector[here], 1), -int(m[1, k])),
                ):
                    column = columns.setdefault(name, len(columns))
                    row[column] = row.get(column, 0) + entry
                row = {c: x for c, x in row.items() if x != 0}
                if row:
                    rows.append(row)
    return rows, len(columns)


def eliminated(rows):
    """Echelon form by pivots of +-1, of least Markowitz cost; pivot rows and columns in order."""
    rows = [dict(row) for row in rows]
    result = []
    while True:
        count = {}
        for row in rows:
            for c in row:
                count[c] = count.get(c, 0) + 1
        candidates = [
            ((len(row) - 1) * (count[c] - 1), i, c)
            for i, row in enumerate(rows)
            for c, x in row.items()
            if abs(x) == 1
        ]
        if not candidates:
            return result
        _, i, c = min(candidates)
        pivot = rows.pop(i)
        result.append((c, pivot))
        for row in rows:
            if c in row:
                factor = row[c] * pivot[c]
                for d, x in pivot.items():
                    row[d] = row.get(d, 0) - factor * x
                    if row[d] == 0:
                        del row[d]
        rows = [row for row in rows if row]


def draw_matrix(axes, rows, order, free):
    """Entries as dots, the columns in the given order; free columns shaded."""
    place = {c: i for i, c in enumerate(order)}
    if free:
        axes.axvspan(len(order) - free - 0.5, len(order) - 0.5, color="#d5efe5", lw=0)
    for sign, color in ((1, BLUE), (-1, ORANGE)):
        points = [
            (place[c], i) for i, row in enumerate(rows) for c, x in row.items() if x * sign > 0
        ]
        axes.plot(*np.array(points).T, "s", color=color, ms=2.6, mew=0)
    axes.set_xlim(-1, len(order))
    axes.set_ylim(len(rows), -1)
    axes.set_xticks([])
    axes.set_yticks([])


def reduction(axes, mesh, is_by_rotation=False):
    """The cuts on the surface, colored by their rotation; or by branch, with the nodes."""
    camera = Camera((0.3, 1, -1.1), (0, 0, 1), mesh.points.mean(axis=0), 5.5, (740, 470))
    buffer = Buffer(mesh, camera)
    samples = (buffer.face >= 0).sum()
    show(axes, buffer.image(np.full((samples, 3), 0.93)))
    for i, branch in enumerate(mesh.branches()):
        line = mesh.points[[mesh.source[branch[0]]] + [mesh.target[h] for h in branch]]
        color = COLORS[(mesh.rotation[branch[0]] if is_by_rotation else i) % 4]
        for piece in visible_pieces(buffer, line):
            axes.plot(*piece.T, color=color, lw=3.5)
    if is_by_rotation:
        return
    nodes = mesh.points[sorted(mesh.nodes)]
    seen = camera.project(nodes)[buffer.visible(nodes)]
    axes.plot(seen[:, 0], seen[:, 1], "o", color=BLACK, ms=7, mec="white", mew=1.2)


def plane(axes):
    axes.set_aspect("equal")
    axes.set_xlim(-0.3, 8.3)
    axes.set_ylim(0.3, 5.3)
    axes.set_xticks([])
    axes.set_yticks([])
    x = np.array([-0.3, 8.3])
    axes.plot(x, x / 2 + 0.5, color=BLACK, lw=2)


def name(axes):
    axes.text(7.0, 4.65, "$C x = 0$", fontsize=15, ha="right")


GIVEN = np.array([3.5, 4.15])
TARGET = GIVEN - np.array([1, -2]) * (GIVEN @ (1, -2) + 1) / 5  # on x - 2 y + 1 = 0


def labelled(axes, p, text, color, offset):
    axes.plot(*p, "o", color=color, ms=11, mec="white", mew=1.4, zorder=5)
    axes.text(
        p[0] + offset[0],
        p[1] + offset[1],
        text,
        color=color,
        fontsize=15,
        zorder=6,
        ha="center",
        va="center",
        bbox={"fc": "white", "ec": "none", "pad": 1.5, "alpha": 0.85},
    )


def target(axes):
    plane(axes)
    name(axes)
    axes.plot(*np.array([GIVEN, TARGET]).T, color=GRAY, lw=1.6, ls="--")
    labelled(axes, GIVEN, "$\\bar x$  given", VERMILLION, (0.3, 0.5))
    labelled(axes, TARGET, "$x^*$  nearest real solution", BLUE, (1.6, -0.7))


def grid(axes):
    x, y = np.meshgrid(np.arange(0, 9), np.arange(1, 6))
    axes.plot(x.ravel(), y.ravel(), "o", color="#b8b8b8", ms=4)
    exact = np.array([(2 * y - 1, y) for y in range(1, 5)])
    axes.plot(*exact.T, "o", color=GREEN, ms=8)


def evaluation(axes):
    plane(axes)
    name(axes)
    grid(axes)
    result = np.array([5, 3])
    labelled(axes, TARGET, "$x^*$", BLUE, (-0.45, 0.45))
    axes.annotate(
        "",
        result,
        TARGET,
        arrowprops={"arrowstyle": "-|>", "lw": 2, "color": BLUE, "shrinkA": 7, "shrinkB": 6},
    )
    labelled(axes, result, "$x$  exact, in doubles", GREEN, (1.5, -0.65))


def panel(figure, column, title, text):
    left = 0.01 + 0.5 * column
    axes = figure.add_axes([left, 0.2, 0.475, 0.67])
    figure.text(left, 0.97, title, weight="bold", fontsize=15, va="top")
    figure.text(left, 0.17, text, fontsize=12.5, va="top", linespacing=1.25)
    return axes


def equation(out, small_out):
    figure = plt.figure(figsize=(14, 5.75))
    target(
        panel(
            figure,
            0,
            "1. Least-squares solution",
            "The nearest solution in real numbers, by least squares, "
            "in floating point.\nIt is not exact, and need not be.",
        )
    )
    evaluation(
        panel(
            figure,
            1,
            "2. Rounding to a grid",
            "One unknown is rounded to a multiple of a power of two. "
            "The other one\nfollows in integers, and is such a multiple as well.",
        )
    )
    save(figure, out)
    small = plt.figure(figsize=(3, 2))
    axes = small.add_axes([0.01, 0.01, 0.98, 0.98])
    plane(axes)
    grid(axes)
    save(small, small_out)


if __name__ == "__main__":
    equation(*sys.argv[1:])
