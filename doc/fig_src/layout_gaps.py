# Motorcycle graphs: curves that leave all cones at the same time and end where they meet one that
# has been there before; followed in floating point on a map with gaps at its cuts, as solvers leave
# them, where they pass by the cones that they should end at; and on the map made exact.
#
#   layout_gaps.py SNAPPED.obj LAYOUT.obj OUT.png

import heapq
import sys

from matplotlib.lines import Line2D

from renderer import Buffer, Camera, visible_pieces
from style import BLUE, GREEN, VERMILLION, np, plt, save, show
from uv_mesh import next_of, read_obj, with_noise

AXES = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])
NOISE = 0.025  # in units of the domain
NEAR = 0.1  # how near to a cone a curve must pass to be marked


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


class Curve:
    def __init__(self, start, h, point, direction):
        self.start, self.h, self.point, self.direction = start, h, point, direction
        self.length, self.end = 0.0, np.inf
        self.segments = []  # face, both ends in its chart, length before


class Race:
    def __init__(self, mesh, maximum):
        self.mesh, self.maximum = mesh, maximum
        self.cones = mesh.cones()
        self.curves, self.in_face, self.events, self.misses = [], {}, [], []
        for h, v in enumerate(mesh.source):
            if v in self.cones:
                self.launch(h, v)
        while self.events:
            time, kind, *what = heapq.heappop(self.events)
            if kind == 0:
                self.advance(self.curves[what[0]], what[0])
            else:
                self.meet(*what)

    def launch(self, h, v):
        flat = self.mesh.uv.reshape(-1, 2)
        first = flat[next_of(h)] - flat[h]
        last = flat[next_of(next_of(h))] - flat[h]
        for k in range(4):
            if cross(first, AXES[k]) >= 0 and cross(AXES[k], last) > 0:
                self.curves.append(Curve(v, h, flat[h], k))
                heapq.heappush(self.events, (0.0, 0, len(self.curves) - 1))

    def advance(self, curve, number):
        if curve.end < np.inf or curve.length > self.maximum:
            return
        flat, h = self.mesh.uv.reshape(-1, 2), curve.h
        d = AXES[curve.direction]
        sides = [next_of(h)] if not curve.segments else [next_of(h), next_of(next_of(h))]
        best = None
        for g in sides:
            a, b = flat[g], flat[next_of(g)]
            turn = cross(d, b - a)
            if turn > 0:  # the curve leaves the face there
                s = np.clip(cross(curve.point - a, d) / cross(b - a, d), 0, 1)
                x = a + s * (b - a)
                if best is None or (x - curve.point) @ d < best[3]:
                    best = (g, s, x, (x - curve.point) @ d)
        if best is None:
            return  # stuck
        g, s, x, step = best
        self.add_segment(curve, number, g // 3, x, max(step, 0))
        o = self.mesh.opposite[g]
        curve.length += max(step, 0)
        curve.h, curve.direction = o, (curve.direction + self.mesh.rotation[g]) % 4
        curve.point = (1 - s) * flat[next_of(o)] + s * flat[o]
        heapq.heappush(self.events, (curve.length, 0, number))

    def add_segment(self, curve, number, f, x, step):
        p, d = curve.point, AXES[curve.direction]
        n = np.array([-d[1], d[0]])
        for i in range(3):  # does it pass a cone by?
            v, q = self.mesh.faces[f, i], self.mesh.uv[f, i]
            if v in self.cones and v != curve.start and abs((q - p) @ n) < NEAR:
                if 0 <= (q - p) @ d <= step:
                    self.misses.append((number, curve.length + (q - p) @ d, v))
        for other, q, e, before, length in self.in_face.get(f, []):
            if e @ d == 0:
                here, there = (q - p) @ d, (p - q) @ e
                if 0 <= here <= step and 0 <= there <= length:
                    both = [(curve.length + here, number), (before + there, other)]
                    (first, winner), (second, loser) = sorted(both)
                    heapq.heappush(self.events, (second, 1, loser, winner, first, second))
        self.in_face.setdefault(f, []).append((number, p, d, curve.length, step))
        curve.segments.append((f, p, x, curve.length))

    def meet(self, loser, winner, first, second):
        if self.curves[loser].end == np.inf and self.curves[winner].end >= first:
            self.curves[loser].end = second

    def polyline(self, curve):
        """Up to its end, in space."""
        points = []
        for f, p, x, before in curve.segments:
            length = np.linalg.norm(x - p)
            if before >= curve.end:
                break
            if before + length > curve.end:
                x = p + (x - p) * (curve.end - before) / length
            points += [self.in_space(f, p), self.in_space(f, x)]
        return points

    def in_space(self, f, u):
        a, b, c = self.mesh.uv[f]
        w = np.array([cross(b - u, c - u), cross(c - u, a - u), cross(a - u, b - u)])
        return w / w.sum() @ self.mesh.points[self.mesh.faces[f]]


def draw_lines(axes, buffer, lines, color, width):
    for line in lines:
        for piece in visible_pieces(buffer, line):
            axes.plot(*piece.T, color=color, lw=width)


def legend(axes, entries):
    lines = [Line2D([], [], color=c, lw=w, marker=m, ms=6) for c, w, m, _ in entries]
    axes.legend(lines, [text for *_, text in entries], loc="upper center",
                bbox_to_anchor=(0.5, -0.01), ncol=len(entries), frameon=False)


def draw_cones(axes, mesh, buffer):
    cones = mesh.points[sorted(mesh.cones())]
    seen = buffer.camera.project(cones[buffer.visible(cones)])
    axes.plot(seen[:, 0], seen[:, 1], "o", color=GREEN, ms=6)


def main(map_name, layout_name, out):
    mesh = read_obj(map_name)
    raw = Race(with_noise(mesh, NOISE), 60)
    missing = {n for n, length, _ in raw.misses if length < raw.curves[n].end + NEAR}
    points, arcs = [], []
    with open(layout_name, encoding="utf-8") as lines:
        for words in map(str.split, lines):
            if words[:1] == ["v"]:
                points.append([float(x) for x in words[1:4]])
            elif words[:1] == ["l"]:
                arcs.append([int(i) - 1 for i in words[1:]])
    points = np.array(points)
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    width = 0.85 * (high - low).max()
    camera = Camera((0.35, 1, -0.95), (0, 0, 1), (low + high) / 2, width, (700, 480))
    buffer = Buffer(mesh, camera)
    background = buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.95))
    figure = plt.figure(figsize=(14, 6))
    axes = figure.add_axes([0.01, 0.07, 0.48, 0.8])
    show(axes, background)
    kept = [raw.polyline(c) for n, c in enumerate(raw.curves) if n not in missing]
    lost = [raw.polyline(c) for n, c in enumerate(raw.curves) if n in missing]
    draw_lines(axes, buffer, [line for line in kept if line], BLUE, 1.6)
    draw_lines(axes, buffer, [line for line in lost if line], VERMILLION, 1.6)
    draw_cones(axes, mesh, buffer)
    legend(axes, [(BLUE, 2, None, "curve"), (VERMILLION, 2, None, "curve that misses a cone"),
                  (GREEN, 0, "o", "cone")])
    figure.text(0.25, 0.93, "With gaps at the cuts: %d of %d curves miss a cone that they\nshould "
                "end at, and cut narrow strips off patches" % (len(missing), len(raw.curves)),
                ha="center", va="center", linespacing=1.3)
    axes = figure.add_axes([0.51, 0.07, 0.48, 0.8])
    show(axes, background)
    draw_lines(axes, buffer, [points[arc] for arc in arcs], BLUE, 1.6)
    draw_cones(axes, mesh, buffer)
    legend(axes, [(BLUE, 2, None, "arc"), (GREEN, 0, "o", "cone")])
    figure.text(0.75, 0.93, "The same map, exactly seamless and aligned:\n%d arcs, and only "
                "rectangles between them" % len(arcs), ha="center", va="center", linespacing=1.3)
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
