# The folders of the headers, and who includes whom: read from the #include lines, so that the
# picture shows the code as it is.
#
#   rooms.py INCLUDE_FOLDER OUT.svg

import pathlib
import re
import sys
import textwrap

from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

from style import BLACK, PALE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, plt, save

PACKAGE = "CGAL/Seamless_snapping"
WORDS = {  # what a room is for, and the color of its kind
    "public functions": ("what callers include", PALE_ORANGE),
    "public values": ("parameters, reports, statuses, constraints", PALE_ORANGE),
    "exact": ("checked integers, the grid, exact differences", PALE_BLUE),
    "transitions": ("groups, transitions, functionals", PALE_BLUE),
    "linear": ("rows, elimination, lattice, target, solver", PALE_BLUE),
    "algebra": ("rows, elimination, lattice, target, solver", PALE_BLUE),
    "complex": ("cuts without a mesh: sectors, branches, nodes", PALE_BLUE),
    "mesh": ("reads and writes meshes", PALE_GREEN),
    "surface": ("cuts of a mesh, the snapping, repair", PALE_GREEN),
    "orientation": ("exact signs, moves, the program", PALE_GREEN),
    "parameterization": ("computes parametrizations", PALE_GREEN),
    "tracing": ("traces isocurves", PALE_GREEN),
    "quads": ("layouts and quad meshes", PALE_GREEN),
    "IO": ("reads and writes files", PALE_GREEN),
}


def read_rooms(include):
    """Room -> the rooms it includes, without itself; and header counts."""
    root = pathlib.Path(include) / PACKAGE
    includes = {}
    for header in sorted(root.rglob("*.h")):
        text = header.read_text(encoding="utf-8")
        names = re.findall(r"#\s*include <%s/([^>]+)>" % PACKAGE, text)
        includes[str(header.relative_to(root))] = [n for n in names if (root / n).exists()]

    used_inside = {n for header, names in includes.items() for n in names
                   if header.startswith("internal/")}

    def room(name):
        parts = name.split("/")
        if parts[0] == "internal":
            return parts[1] if len(parts) > 2 else None  # single helpers are no room
        if parts[0] == "IO":
            return "IO"
        return "public values" if name in used_inside else "public functions"

    uses, sizes = {}, {}
    for header, names in includes.items():
        here = room(header)
        if here is None:
            continue
        sizes[here] = sizes.get(here, 0) + 1
        uses.setdefault(here, set()).update(room(n) for n in names)
    return {r: {o for o in others if o not in (None, r)} for r, others in uses.items()}, sizes


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
    """Arrows that are not implied by a way over a third room."""
    return {(a, b) for a in uses for b in uses[a]
            if not any(b in reachable(uses, c) and a not in reachable(uses, c)
                       for c in uses[a] if c != b)}


def main(include, out):
    uses, sizes = read_rooms(include)
    for room in uses:
        for other in uses[room]:
            if room in reachable(uses, other):
                print("a cycle of rooms:", room, "->", other)
    level = levels(uses)
    floors = [sorted(r for r in level if level[r] == i) for i in range(max(level.values()) + 1)]
    width, height, gap = 3.1, 1.25, 0.7
    figure = plt.figure(figsize=(14, 1.95 * len(floors)))
    axes = figure.add_axes([0, 0, 1, 1])
    axes.set_xlim(0, 14)
    axes.set_ylim(-0.3, (height + gap) * len(floors) - gap + 0.3)
    axes.axis("off")
    center = {}
    for i, rooms in enumerate(floors):
        # A room stands near the middle of what it uses.
        def wish(room):
            below = [center[o][0] for o in uses[room] if o in center]
            return sum(below) / len(below) if below else 7
        rooms.sort(key=lambda r: (wish(r), r))
        for k, room in enumerate(rooms):
            x = 7 + (k - (len(rooms) - 1) / 2) * (width + 0.35)
            center[room] = (x, (height + gap) * i + height / 2)
            words, color = WORDS.get(room, ("", PALE))
            axes.add_patch(FancyBboxPatch((x - width / 2, center[room][1] - height / 2), width, height,
                                          boxstyle="round,pad=0,rounding_size=0.12", fc=color,
                                          ec=BLACK, lw=1.4, zorder=3))
            name = room if room.startswith("public") else room + "/"
            axes.text(x, center[room][1] + 0.33, name, weight="bold", fontsize=14, ha="center",
                      va="center", zorder=4)
            axes.text(x, center[room][1] - 0.17, textwrap.fill(words, 27), fontsize=12, ha="center",
                      va="center", zorder=4, linespacing=1.2)
    for a, b in sorted(without_detours(uses)):
        (x0, y0), (x1, y1) = center[a], center[b]
        down = -1 if y1 < y0 else 1
        shift = max(-1.1, min(1.1, 0.18 * (x1 - x0)))
        axes.add_patch(FancyArrowPatch((x0 + shift, y0 + down * height / 2),
                                       (x1 - shift, y1 - down * height / 2), arrowstyle="-|>",
                                       mutation_scale=15, lw=1.5, color="#555555", zorder=2,
                                       shrinkA=0, shrinkB=0))
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
