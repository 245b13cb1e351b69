# The words of the manual, one picture each: cut, sector, node, branch, transition, cone.
#
#   terms.py OUT.png

import heapq
import sys

from matplotlib.collections import PolyCollection
from matplotlib.patches import FancyArrowPatch
from scipy.spatial import Delaunay

from style import (
    BLACK,
    BLUE,
    GRAY,
    GREEN,
    ORANGE,
    PALE_BLUE,
    PALE_ORANGE,
    PURPLE,
    VERMILLION,
    np,
    plt,
    save,
)


class Patch:
    """A piece of a triangle mesh with three cuts that meet in one vertex, and one that ends."""

    def __init__(self):
        random = np.random.default_rng(4)
        rows = [(x + 0.5 * (j % 2), 0.87 * j) for j in range(-4, 5) for x in range(-5, 5)]
        points = np.array(rows) + random.uniform(-0.13, 0.13, (len(rows), 2))
        self.points = points[(np.abs(points[:, 0]) < 4.4) & (np.abs(points[:, 1]) < 3.3)]
        self.triangles = Delaunay(self.points).simplices
        self.neighbors = {}
        for t in self.triangles:
            for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
                self.neighbors.setdefault(a, set()).add(b)
                self.neighbors.setdefault(b, set()).add(a)
        self.node, self.end = self.nearest(-0.4, 0.2), self.nearest(2.1, 1.4)
        ends = [self.nearest(*p) for p in ((-4.2, 1.4), (-1.2, -3.3), (4.2, -1.6))]
        self.cuts = [self.path(self.node, e) for e in ends]
        self.cuts.append(self.path(self.node, self.end))

    def nearest(self, x, y):
        return int(np.linalg.norm(self.points - (x, y), axis=1).argmin())

    def path(self, a, b):
        best, queue, before = {a: 0}, [(0, a)], {}
        while queue:
            length, v = heapq.heappop(queue)
            for w in self.neighbors[v]:
                way = length + np.linalg.norm(self.points[v] - self.points[w]) ** 1.5
                if way < best.get(w, np.inf):
                    best[w], before[w] = way, v
                    heapq.heappush(queue, (way, w))
        result = [b]
        while result[-1] != a:
            result.append(before[result[-1]])
        return result[::-1]

    def sectors(self, v):
        """The triangles around a vertex, in groups between cuts."""
        cut_edges = {frozenset(e) for cut in self.cuts for e in zip(cut, cut[1:])}
        fan = [t for t in self.triangles if v in t]
        fan.sort(key=lambda t: np.arctan2(*(self.points[t].mean(axis=0) - self.points[v])[::-1]))
        groups, is_new = [[]], False
        for t, following in zip(fan, fan[1:] + fan[:1]):
            groups[-1].append(t)
            shared = (set(t) & set(following)) - {v}
            if frozenset((v, shared.pop())) in cut_edges:
                groups.append([])
        groups[0] = groups.pop() + groups[0]
        return groups


def axes_of(figure, column, row, title, text):
    left, top = 0.01 + 0.333 * column, 0.985 - 0.5 * row
    axes = figure.add_axes([left, top - 0.39, 0.313, 0.35])
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_xlim(-4.5, 4.5)
    axes.set_ylim(-3.2, 3.2)
    figure.text(left, top, title, weight="bold", fontsize=15, va="top")
    figure.text(left, top - 0.395, text, fontsize=12.5, va="top", linespacing=1.25)
    return axes


def draw_patch(axes, patch, color="#f2f2f2"):
    axes.add_collection(
        PolyCollection(patch.points[patch.triangles], facecolor=color, edgecolor="#b5b5b5", lw=0.9)
    )


def draw_cut(axes, patch, cut, color=BLACK, lw=3.5):
    axes.plot(*patch.points[cut].T, color=color, lw=lw, zorder=3)


def dot(axes, p, color=BLACK, size=11):
    axes.plot(*p, "o", color=color, ms=size, mec="white", mew=1.6, zorder=5)


def cuts(axes, patch):
    draw_patch(axes, patch)
    for cut in patch.cuts:
        draw_cut(axes, patch, cut)


def sectors(axes, patch):
    draw_patch(axes, patch)
    shown = [
        (patch.node, (BLUE, ORANGE, GREEN, PURPLE)),
        (patch.cuts[0][2], (BLUE, ORANGE)),
        (patch.end, (VERMILLION,)),
    ]
    for v, colors in shown:
        for group, color in zip(patch.sectors(v), colors):
            corners = [(0.55 * patch.points[t] + 0.45 * patch.points[v]) for t in group]
            axes.add_collection(
                PolyCollection(corners, facecolor=color, edgecolor="none", zorder=2)
            )
    for cut in patch.cuts:
        draw_cut(axes, patch, cut)


def nodes(axes, patch):
    cuts(axes, patch)
    dot(axes, patch.points[patch.node], VERMILLION, 15)
    dot(axes, patch.points[patch.end], VERMILLION, 15)
    axes.annotate(
        "cuts meet",
        patch.points[patch.node] + (0.2, -0.2),
        (2.2, -2.6),
        fontsize=12.5,
        ha="center",
        arrowprops={"arrowstyle": "-", "lw": 1.2},
        zorder=6,
        bbox={"fc": "white", "ec": "none", "pad": 2},
    )
    axes.annotate(
        "a cut ends",
        patch.points[patch.end] + (0.1, 0.2),
        (2.9, 2.75),
        fontsize=12.5,
        ha="center",
        arrowprops={"arrowstyle": "-", "lw": 1.2},
        zorder=6,
        bbox={"fc": "white", "ec": "none", "pad": 2},
    )


def branches(axes, patch):
    draw_patch(axes, patch)
    for cut, color in zip(patch.cuts, (BLUE, ORANGE, GREEN, PURPLE)):
        draw_cut(axes, patch, cut, color, 5.5)
    for v in (patch.node, patch.end):
        dot(axes, patch.points[v])


def transition(axes):
    """Two charts in the plane; the same cut at the border of both."""
    side = np.array([(0.0, -1.9), (0.35, -0.9), (-0.05, 0.0), (0.3, 0.9), (0.0, 1.9)])
    left = np.concatenate([side, [(-2.3, 1.7), (-2.6, 0.1), (-2.2, -1.8)]]) + (-1.1, -0.7)
    turned = np.stack([-side[:, 1], side[:, 0]], axis=1)
    # Counterclockwise by 90 degrees, what was at the right of the cut is above it.
    right = np.concatenate([turned, [(-1.7, 1.8), (0.0, 2.2), (1.8, 1.7)]]) + (2.2, -0.4)
    for x in range(-5, 6):
        axes.plot([x, x], [-3.4, 3.4], color="#d9d9d9", lw=0.9, zorder=0)
    for y in range(-3, 4):
        axes.plot([-5, 5], [y, y], color="#d9d9d9", lw=0.9, zorder=0)
    for outline, color in ((left, PALE_BLUE), (right, PALE_ORANGE)):
        axes.fill(*outline.T, facecolor=color, edgecolor=GRAY, lw=1, alpha=0.9)
    axes.plot(*left[:5].T, color=BLACK, lw=3.5)
    axes.plot(*right[:5].T, color=BLACK, lw=3.5)
    axes.add_patch(
        FancyArrowPatch(
            (-0.55, 0.7),
            (1.1, 0.25),
            connectionstyle="arc3,rad=-0.5",
            arrowstyle="-|>",
            mutation_scale=22,
            lw=2.2,
            color=VERMILLION,
            zorder=6,
        )
    )
    axes.text(
        0.2,
        2.45,
        "$g(u) = R\\,u + t$",
        fontsize=15,
        color=VERMILLION,
        ha="center",
        bbox={"fc": "white", "ec": "none", "pad": 2},
    )
    axes.text(-2.5, -0.7, "chart of\nthis side", ha="center", va="center", fontsize=12.5)
    axes.text(2.3, 0.9, "chart of\nthe other side", ha="center", va="center", fontsize=12.5)


def cone(axes, quarters, middle, radius, name):
    """The isocurves around a cone with a number of quarter turns."""
    power = quarters / 4
    t = np.linspace(-6, 6, 800)
    for q in range(quarters):
        for level in np.arange(0.0, 3.0, 0.5):
            for u, color in ((level + 1j * t[t >= 0], BLUE), (t[t >= 0] + 1j * level, ORANGE)):
                turn = (np.angle(u + 1e-12) + q * np.pi / 2) / power
                z = np.abs(u) ** (1 / power) * np.exp(1j * turn)
                z = z[np.abs(z) < 2.0]
                axes.plot(
                    middle[0] + radius * z.real / 2,
                    middle[1] + radius * z.imag / 2,
                    color=color,
                    lw=1.8,
                )
    axes.plot(*middle, "o", color=VERMILLION, ms=14, mec="white", mew=1.6, zorder=5)
    axes.text(middle[0], middle[1] - radius - 0.35, name, ha="center", va="top", fontsize=12.5)


def main(out):
    figure = plt.figure(figsize=(14, 8.9))
    patch = Patch()
    cuts(
        axes_of(
            figure,
            0,
            0,
            "Cut",
            "Edges where the coordinates of the two faces\n" "differ: the mesh is cut open here.",
        ),
        patch,
    )
    sectors(
        axes_of(
            figure,
            1,
            0,
            "Sector",
            "The corners of a vertex between two cuts.\n" "Each color is one pair of coordinates.",
        ),
        patch,
    )
    nodes(
        axes_of(
            figure,
            2,
            0,
            "Node",
            "A vertex where cuts meet or end, or\n" "where the angle is not 360°.",
        ),
        patch,
    )
    branches(
        axes_of(
            figure,
            0,
            1,
            "Branch",
            "The cut edges between two nodes: all\n" "of them have the same transition.",
        ),
        patch,
    )
    transition(
        axes_of(
            figure,
            1,
            1,
            "Transition",
            "How coordinates go on across a cut: a rotation\n"
            "R by 0°, 90°, 180° or 270°, and a translation t.",
        )
    )
    axes = axes_of(
        figure,
        2,
        1,
        "Cone",
        "A singular vertex: the angle around it in the plane\n"
        "is a multiple of 90°, but not 360°.",
    )
    cone(axes, 3, (-2.3, 0.4), 2.1, "270°: three directions")
    cone(axes, 5, (2.3, 0.4), 2.1, "450°: five directions")
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
