# The rooms of the five packages, and which includes which: read from the #include lines, so that the
# picture shows the code as it is. Left out are the folders `types`, which all may include.
#
#   rooms.py INCLUDE_FOLDER OUT.svg

import pathlib
import re
import sys
import textwrap

from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

from style import BLACK, PALE_BLUE, PALE_GREEN, PALE_ORANGE, plt, save

PACKAGES = {  # and their colors
    "Linear_snapping": PALE_BLUE,
    "Seamless_snapping": PALE_GREEN,
    "Isocurves_and_layouts": PALE_ORANGE,
    "Quad_remeshing": "#f3e1ec",
    "Hexahedral_meshing": "#e4e4e4",
}
WIDTH, HEIGHT = 3.35, 1.25
WORDS = {  # what a room is for
    "exact": "checked integers, the grid, exact differences",
    "support": "refusals, threads, options, times",
    "transitions": "groups of rotations, sides of edges",
    "linear": "rows, elimination, lattice, target, solver",
    "complex": "cuts without a mesh: sectors, branches",
    "volume": "maps of tetrahedra",
    "untangling": "makes triangles positive, under constraints",
    "mesh": "reads meshes, their cuts, and rotations",
    "orientation": "signs of faces, moves, repair",
    "snapping": "the steps of snapping, integers, writing",
    "parametrization": "computes parametrizations",
    "charts": "exact maps as plain arrays",
    "tracing": "walks along isocurves",
    "layout": "motorcycle graphs, patches",
    "cells": "cells of a grid, extracted",
    "quantization": "integers for a coarse complex",
    "remeshing": "smooths and divides quads",
    "hexahedra": "hexahedra of integer-grid maps",
    "shape": "shapes of hexahedra, moves of vertices",
    "IO": "parses and writes files",
}


def read_rooms(include):
    """Room -> the rooms it includes, without itself; and room -> package."""
    root = pathlib.Path(include) / "CGAL"
    names = r"#\s*include <CGAL/((?:%s)/[^>]+)>" % "|".join(PACKAGES)

    package = {}

    def room(name):
        of, *folders, file = name.split("/")
        if folders == ["types"] or file == "packages_below.h":  # names, and no code
            result = "types"
        else:
            result = folders[1] if folders[1:] else of  # files in internal/ are of its callers
        package.setdefault(result, of)
        return result

    uses = {}
    for header in sorted(h for p in PACKAGES for h in (root / p).rglob("*.h")):
        text = header.read_text(encoding="utf-8")
        used = {room(n) for n in re.findall(names, text)}
        uses.setdefault(room(str(header.relative_to(root))), set()).update(used)
    del uses["types"]
    return {r: others - {r, "types"} for r, others in uses.items()}, package


def reachable(uses, start):
    seen, front = set(), [start]
    while front:
        for other in uses[front.pop()]:
            if other not in seen:
                seen.add(other)
                front.append(other)
    return seen


def levels(uses):
    """Each room above all that it uses."""
    level = {}

    def place(room):
        if room not in level:
            level[room] = 0
            below = [place(o) for o in uses[room] if room not in reachable(uses, o)]
            level[room] = 1 + max(below, default=-1)
        return level[room]

    for room in uses:
        place(room)
    return level


def without_detours(uses):
    """Enough arrows that all others follow from them."""
    kept = {room: set(others) for room, others in uses.items()}
    for a in sorted(kept):
        for b in sorted(kept[a]):
            kept[a].remove(b)
            if b not in reachable(kept, a):
                kept[a].add(b)
    return {(a, b) for a, others in kept.items() for b in others}


class Layout:
    """Floors of rooms; arrows across several floors pass them through gaps between the rooms."""

    def __init__(self, uses):
        level = levels(uses)
        self.floors = [
            sorted(r for r in level if level[r] == i) for i in range(max(level.values()) + 1)
        ]
        self.arrows = []  # lists of places, from the user to the used
        for a, b in sorted(without_detours(uses)):
            between = range(level[a] - 1, level[b], -1) if level[a] > level[b] else ()
            gaps = [(a, b, i) for i in between]
            for i, gap in zip(between, gaps):
                self.floors[i].append(gap)
            self.arrows.append([a] + gaps + [b])
        self.x = {p: float(k) for floor in self.floors for k, p in enumerate(floor)}
        for sweep in range(30):
            for floor in self.floors if sweep % 2 == 0 else self.floors[::-1]:
                self._order(floor)

    def _order(self, floor):
        """By the mean of the places that arrows connect them to; then apart, and in the middle."""
        neighbors = {p: [] for p in floor}
        for way in self.arrows:
            for p, q in zip(way, way[1:]):
                if p in neighbors:
                    neighbors[p].append(self.x[q])
                if q in neighbors:
                    neighbors[q].append(self.x[p])
        wish = {p: sum(n) / len(n) if n else self.x[p] for p, n in neighbors.items()}
        floor.sort(key=lambda p: (wish[p], str(p)))
        at = 0.0
        for p, q in zip([None] + floor, floor):
            at += 0 if p is None else (self._width(p) + self._width(q)) / 2
            self.x[q] = at
        shift = sum(wish.values()) / len(wish) - sum(self.x[p] for p in floor) / len(floor)
        for p in floor:
            self.x[p] += shift

    @staticmethod
    def _width(place):
        return WIDTH + 0.35 if isinstance(place, str) else 0.7


def draw_room(axes, room, x, y, color):
    words = WORDS.get(room, "public functions")
    axes.add_patch(
        FancyBboxPatch(
            (x - WIDTH / 2, y - HEIGHT / 2),
            WIDTH,
            HEIGHT,
            fc=color,
            ec=BLACK,
            boxstyle="round,pad=0,rounding_size=0.12",
            lw=2.4 if room in PACKAGES else 1.2,
            zorder=3,
        )
    )
    axes.text(
        x,
        y + 0.33,
        room if room in PACKAGES else room + "/",
        weight="bold",
        fontsize=14 if len(room) < 20 else 13,
        ha="center",
        va="center",
        zorder=4,
    )
    axes.text(
        x,
        y - 0.17,
        textwrap.fill(words, 27),
        fontsize=12,
        ha="center",
        va="center",
        zorder=4,
        linespacing=1.2,
    )


def draw_arrow(axes, points):
    """From the bottom of a room to the top of another, through gaps between rooms."""
    down = 1 if points[-1][1] < points[0][1] else -1
    lean = [
        max(-1.1, min(1.1, 0.2 * (q[0] - p[0])))
        for p, q in ((points[0], points[1]), (points[-1], points[-2]))
    ]
    way = [(points[0][0] + lean[0], points[0][1] - down * HEIGHT / 2)]
    for x, y in points[1:-1]:
        way += [(x, y + HEIGHT / 2), (x, y - HEIGHT / 2)]
    way.append((points[-1][0] + lean[1], points[-1][1] + down * HEIGHT / 2))
    axes.plot(*zip(*way[:-1]), color="#555555", lw=1.5, zorder=2)
    axes.add_patch(
        FancyArrowPatch(
            way[-2],
            way[-1],
            arrowstyle="-|>",
            mutation_scale=15,
            lw=1.5,
            color="#555555",
            zorder=2,
            shrinkA=0,
            shrinkB=0,
        )
    )


def main(include, out):
    uses, package = read_rooms(include)
    for room in uses:
        for other in uses[room]:
            if room in reachable(uses, other):
                print("a cycle of rooms:", room, "->", other)
    layout = Layout(uses)
    center = {p: (layout.x[p], 1.95 * i) for i, floor in enumerate(layout.floors) for p in floor}
    left, right = (f(x for (x, _), p in zip(center.values(), center)) for f in (min, max))
    figure = plt.figure(figsize=(14, 1.95 * len(layout.floors)))
    axes = figure.add_axes([0, 0, 1, 1])
    span = max(14, right - left + WIDTH + 0.2)
    axes.set_xlim((left + right - span) / 2, (left + right + span) / 2)
    axes.set_ylim(-HEIGHT / 2 - 0.1, 1.95 * len(layout.floors) - 1.95 + HEIGHT / 2 + 0.1)
    axes.axis("off")
    for way in layout.arrows:
        draw_arrow(axes, [center[p] for p in way])
    for floor in layout.floors:
        for room in floor:
            if isinstance(room, str):
                draw_room(axes, room, *center[room], PACKAGES[package[room]])
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
