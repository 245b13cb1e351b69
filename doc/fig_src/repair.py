# How a face that snapping has flipped is repaired: a vertex moves into the kernel of its ring.
#
#   repair.py OUT.png

import sys

from style import BLACK, BLUE, GREEN, VERMILLION, np, plt, save

RING = np.array(
    [(-2.6, -1.1), (-1.5, -1.3), (0.5, -0.95), (2.6, -1.3), (2.4, 1.7), (-0.2, 2.3), (-2.5, 1.5)]
)
GIVEN = np.array([0.2, -0.62])  # just above the cut
SNAPPED_END = np.array([0.5, -0.15])  # where the vertex of the cut, RING[2], has moved to


def kernel(ring):
    """The points from which all edges of a counterclockwise ring are seen counterclockwise."""
    polygon = [np.array(p, float) for p in ((-9, -9), (9, -9), (9, 9), (-9, 9))]
    for a, b in zip(ring, np.roll(ring, -1, axis=0)):
        normal = np.array([a[1] - b[1], b[0] - a[0]])
        heights = [normal @ (p - a) for p in polygon]
        clipped = []
        for (p, x), (q, y) in zip(
            zip(polygon, heights), zip(polygon[1:] + polygon[:1], heights[1:] + heights[:1])
        ):
            if x >= 0:
                clipped.append(p)
            if (x >= 0) != (y >= 0):
                clipped.append(p + (q - p) * x / (x - y))
        polygon = clipped
    return np.array(polygon)


def area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def draw(axes, ring, center):
    for a, b in zip(ring, np.roll(ring, -1, axis=0)):
        is_turned = area(a, b, center) < 0
        axes.fill(
            *np.array([a, b, center]).T,
            facecolor="#f3c9a8" if is_turned else "#f2f2f2",
            edgecolor=VERMILLION if is_turned else "#999999",
            lw=2 if is_turned else 1.1,
            zorder=3 if is_turned else 2,
            hatch="///" if is_turned else None
        )
    axes.plot(*ring[[1, 2, 3]].T, color=BLACK, lw=4, zorder=4)
    axes.plot(*center, "o", color=BLUE, ms=12, mec="white", mew=1.5, zorder=6)
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_xlim(-2.8, 2.8)
    axes.set_ylim(-1.5, 2.4)


def main(out):
    figure = plt.figure(figsize=(14, 4.7))
    ring = RING.copy()
    ring[2] = SNAPPED_END
    inside = kernel(ring)
    moved = SNAPPED_END + (-0.12, 0.42)
    texts = (
        ("Given", "Thin faces between a vertex\nand a cut."),
        ("Snapped", "A vertex of the cut has moved:\ntwo faces are flipped."),
        ("Repaired", "The vertex moves into the kernel\nof its ring, in whole grid steps."),
    )
    for i, (title, text) in enumerate(texts):
        axes = figure.add_axes([0.01 + 0.33 * i, 0.2, 0.31, 0.7])
        draw(axes, RING if i == 0 else ring, moved if i == 2 else GIVEN)
        figure.text(0.01 + 0.33 * i, 0.985, title, weight="bold", fontsize=15, va="top")
        figure.text(0.01 + 0.33 * i, 0.165, text, fontsize=12.5, va="top", linespacing=1.25)
        if i == 1:
            axes.annotate(
                "",
                SNAPPED_END,
                RING[2],
                zorder=7,
                arrowprops={
                    "arrowstyle": "-|>",
                    "lw": 2.2,
                    "color": VERMILLION,
                    "mutation_scale": 20,
                },
            )
        if i == 2:
            axes.fill(*inside.T, facecolor=GREEN, alpha=0.35, edgecolor=GREEN, lw=2, zorder=3)
            axes.annotate(
                "",
                moved,
                GIVEN,
                zorder=7,
                arrowprops={
                    "arrowstyle": "-|>",
                    "lw": 2.2,
                    "color": BLUE,
                    "mutation_scale": 20,
                    "shrinkB": 7,
                },
            )
            axes.text(
                *(inside.mean(axis=0) + (0.1, 0.35)),
                "kernel",
                color="#00664b",
                ha="center",
                fontsize=13,
                zorder=5
            )
    handles = [
        plt.Line2D([], [], color=BLACK, lw=4),
        plt.Rectangle((0, 0), 1, 1, fc="#f3c9a8", ec=VERMILLION, hatch="///"),
    ]
    figure.legend(
        handles,
        ["cut", "flipped face"],
        ncol=2,
        frameon=False,
        loc="upper right",
        bbox_to_anchor=(1, 1.02),
    )
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
