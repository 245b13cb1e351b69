# The picture that opens the manual: a surface of genus 2 with the grid of its map, and a seam,
# enlarged, before and after snapping; and a small picture of the surface alone.
#
#   teaser.py COMPUTED.obj SNAPPED.obj OUT.png SMALL.png

import sys

from matplotlib.lines import Line2D
from matplotlib.patches import Circle, ConnectionPatch, Rectangle

from renderer import Buffer, Camera, distance_to_isolines, visible_pieces
from style import BLACK, BLUE, GREEN, ORANGE, VERMILLION, np, plt, rgb, save, show
from uv_mesh import Uv_mesh, next_of, read_obj, rotated

WRONG, RIGHT = VERMILLION, GREEN
QUAD, HOLE = "#cfe3f1", "#3c3c3c"
CHECKER = rgb("#ffffff"), rgb("#cfe3f1")
ALONG_U, ALONG_V = rgb(BLUE), rgb(ORANGE)


def grid_colors(buffer, uv, width):
    """Checker and isolines, for the shown samples."""
    u = buffer.interpolated(uv)
    is_dark = np.floor(u).sum(axis=1) % 2 == 0
    colors = np.where(is_dark[:, None], CHECKER[1], CHECKER[0])
    near = distance_to_isolines(buffer, uv) < width / 2
    colors[near[:, 1]] = ALONG_V
    colors[near[:, 0]] = ALONG_U
    return colors


def crossing(mesh, h):
    """Where an isocurve u = integer or v = integer crosses a cut edge: (point, component, level,
    how far it is from being tangent), or None."""
    flat = mesh.uv.reshape(-1, 2)
    a, b = flat[h], flat[next_of(h)]
    best = None
    for k in range(2):
        level = np.ceil(min(a[k], b[k]))
        if level < max(a[k], b[k]):
            w = (level - a[k]) / (b[k] - a[k])
            angle = abs(b[k] - a[k]) / np.linalg.norm(b - a)
            if best is None or angle > best[3]:
                p = (1 - w) * mesh.points[mesh.source[h]] + w * mesh.points[mesh.target[h]]
                best = (p, k, level, angle)
    return best


def best_crossing(mesh, camera, buffer):
    """A cut halfedge where an isocurve crosses it, in plain view on the flat top of the body, and
    far from other branches and from cones."""
    branches = mesh.branches()
    nodes = np.array(sorted(set(mesh.cones()) | mesh.nodes))
    middle = (mesh.points[mesh.source] + mesh.points[mesh.target]) / 2
    normal = mesh.vertex_normals()
    best, result = -1, None
    for b, branch in enumerate(branches):
        others = [h for c, other in enumerate(branches) if c != b for h in other]
        rivals = np.concatenate([middle[others], mesh.points[nodes]])
        for h in branch:
            found = crossing(mesh, h)
            if found is None or not buffer.visible(found[0][None])[0]:
                continue
            flatness = max(0, normal[mesh.source[h]][2] - 0.8)
            distance = np.linalg.norm(rivals - found[0], axis=1).min()
            score = min(distance, 0.6) * flatness * min(found[3], 0.75)
            if score > best:
                best, result = score, (h, branch, *found[:3])
    return result


def side_of_seam(mesh, start, center, radius):
    """The faces near `center` that are reached from halfedge `start` without crossing a cut."""
    middle = mesh.points[mesh.faces].mean(axis=1)
    seen, front = {start // 3}, [start // 3]
    while front:
        f = front.pop()
        for h in range(3 * f, 3 * f + 3):
            o = mesh.opposite[h]
            if (
                o >= 0
                and not mesh.is_cut[h]
                and o // 3 not in seen
                and np.linalg.norm(middle[o // 3] - center) < radius
            ):
                seen.add(o // 3)
                front.append(o // 3)
    return sorted(seen)


class Close_up:
    """The faces on both sides of a cut near a place, with coordinates in one chart."""

    def __init__(self, mesh, h, center, radius):
        self.near = side_of_seam(mesh, h, center, radius)
        self.far = side_of_seam(mesh, mesh.opposite[h], center, radius)
        self.faces = np.array(self.near + self.far)
        self.is_far = np.arange(len(self.faces)) >= len(self.near)
        self.rotation, self.translation = mesh.rotation[h], mesh.translation[h]
        self.mesh = Uv_mesh(mesh.points, mesh.faces[self.faces], mesh.uv[self.faces])
        self.normals = mesh.vertex_normals()

    def in_one_chart(self, uv, translation):
        result = uv[self.faces]
        result[self.is_far] = rotated(result[self.is_far] - translation, -self.rotation)
        return result


def cells_at_seam(buffer, cell, is_far):
    """Which samples are in a quad that reaches the seam from its own side."""
    side = np.full(buffer.face.shape, -1)
    side[buffer.face >= 0] = is_far
    key = np.full(buffer.face.shape, -1)
    key[buffer.face >= 0] = np.unique(2 * cell + is_far, return_inverse=True)[1]
    touching = set()
    for here, there in ((np.s_[1:, :], np.s_[:-1, :]), (np.s_[:, 1:], np.s_[:, :-1])):
        meets = side[here] + side[there] == 1
        touching.update(key[here][meets], key[there][meets])
    return np.isin(key[buffer.face >= 0], list(touching))


def draw_panel(axes, close_up, uv, camera, line, kind, is_exact):
    """Around a seam: the isolines, one of them marked, or the quads between them."""
    mesh = close_up.mesh.with_uv(uv)
    buffer = Buffer(mesh, camera, samples=4)
    u = buffer.interpolated(uv)
    is_far = close_up.is_far[buffer.face[buffer.face >= 0]]
    width = 0.014 * camera.width
    distance = distance_to_isolines(buffer, uv)
    if kind == "isolines":
        colors = grid_colors(buffer, uv, width)
        component, level = line
        chosen = (np.rint(u[:, component]) == level) & (distance[:, component] < 1.6 * width)
        if not is_exact:
            chosen &= ~is_far
        colors[chosen] = rgb(RIGHT if is_exact else WRONG)
    else:
        cell = np.floor(u).astype(int) @ np.array([1, 100003])
        broken = cells_at_seam(buffer, cell, is_far) & (not is_exact)
        colors = np.where(broken[:, None], rgb(HOLE), rgb(QUAD))
        near = (distance < 0.7 * width).any(axis=1)
        colors[near & ~broken] = rgb(BLACK)
    show(axes, buffer.image(colors))
    axes.add_patch(
        Rectangle((0, 0), *camera.pixels, fill=False, lw=5, color=RIGHT if is_exact else WRONG)
    )
    return buffer


def draw_seam(axes, buffer, mesh, branch, **style):
    points = [mesh.points[mesh.source[branch[0]]]] + [mesh.points[mesh.target[h]] for h in branch]
    for piece in visible_pieces(buffer, points):
        axes.plot(*piece.T, **style)


def draw_surface(axes, mesh, camera):
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(grid_colors(buffer, mesh.uv, 0.03)))
    for branch in mesh.branches():
        draw_seam(axes, buffer, mesh, branch, color="white", lw=4.4)
    for branch in mesh.branches():
        draw_seam(axes, buffer, mesh, branch, color=BLACK, lw=2.4)
    return buffer


def mean_gap(mesh, change, branch, center, radius):
    """Of the vertices of a branch near a place, in the chart on the near side; `mesh` is exact, and
    `change` was added."""
    flat = change.reshape(-1, 2)
    gaps = [
        rotated(flat[next_of(mesh.opposite[h])], -mesh.rotation[h]) - flat[h]
        for h in branch
        if np.linalg.norm(mesh.points[mesh.source[h]] - center) < radius
    ]
    return np.mean(gaps, axis=0)


def power_of_ten(x):
    exponent = int(np.floor(np.log10(x)))
    return r"$%.0f\cdot 10^{%d}$" % (x / 10**exponent, exponent)


def legend(axes):
    handles = [
        Line2D([], [], color=BLUE, lw=3),
        Line2D([], [], color=ORANGE, lw=3),
        Line2D([], [], color=BLACK, lw=3),
    ]
    axes.legend(
        handles,
        ["$u$ is an integer", "$v$ is an integer", "cuts (seams)"],
        ncol=3,
        loc="upper center",
        bbox_to_anchor=(0.5, 0.06),
        frameon=False,
        handlelength=1.6,
    )


def draw_close_ups(figure, mesh, camera, change, place):
    h, branch, center, *line = place
    gap = mean_gap(mesh, change, branch, center, 0.4)
    factor = 0.5 / np.abs(gap).max()
    close_up = Close_up(mesh, h, center, 0.8)
    uv = close_up.in_one_chart(mesh.uv, mesh.translation[h])
    moved = uv + factor * gap * close_up.is_far[:, None, None]
    close = Camera(-mesh.vertex_normals()[mesh.source[h]], camera.up, center, 0.85, (330, 250))
    corner = camera.project(center[None])[0][:2]
    figure.axes[0].add_patch(Circle(corner, 34, fill=False, color=BLACK, lw=3))
    titles = (
        r"$\bf{As\ solvers\ return\ it}$"
        + ": the two sides of a seam differ by\n"
        + power_of_ten(np.linalg.norm(gap))
        + " (drawn "
        + power_of_ten(factor)
        + " times as large)",
        r"$\bf{Snapped}$: the two sides agree" + "\nexactly, in doubles",
    )
    texts = (
        ("isocurves end at the seam", "the quads between them: a hole"),
        ("isocurves go on", "the quads between them: closed"),
    )
    for row, (shown, is_exact) in enumerate(((moved, False), (uv, True))):
        color = RIGHT if is_exact else WRONG
        top = 0.555 - 0.5 * row
        figure.text(0.5795, top + 0.345, titles[row], color=color, va="bottom", linespacing=1.3)
        for column, kind in enumerate(("isolines", "quads")):
            panel = figure.add_axes([0.5795 + 0.212 * column, top, 0.205, 0.335])
            seen = draw_panel(panel, close_up, shown, close, line, kind, is_exact)
            draw_seam(panel, seen, mesh, branch, color="white", lw=5)
            draw_seam(panel, seen, mesh, branch, color=BLACK, lw=2.6)
            panel.set_title(texts[row][column], y=-0.13, fontsize=12)
            if (row, column) == (0, 0):
                figure.add_artist(
                    ConnectionPatch(
                        (corner[0] + 34, corner[1]),
                        (0, close.pixels[1] / 2),
                        "data",
                        "data",
                        axesA=figure.axes[0],
                        axesB=panel,
                        color=BLACK,
                        lw=1.5,
                    )
                )


def draw_small(mesh, out):
    """The surface alone, as a picture of the package."""
    figure = plt.figure(figsize=(1.6, 1.15))
    camera = Camera((0.3, 1, -1.1), (0, 0, 1), mesh.points.mean(axis=0), 5.5, (176, 126))
    buffer = Buffer(mesh, camera, samples=8)
    show(figure.add_axes([0, 0, 1, 1]), buffer.image(grid_colors(buffer, mesh.uv, 0.05)))
    save(figure, out)


def main(computed_name, snapped_name, out, small_out):
    exact, computed = read_obj(snapped_name), read_obj(computed_name)
    draw_small(exact, small_out)
    figure = plt.figure(figsize=(14, 6.7))
    camera = Camera((0.3, 1, -1.1), (0, 0, 1), exact.points.mean(axis=0), 5.5, (860, 620))
    axes = figure.add_axes([0, 0.05, 0.56, 0.84])
    buffer = draw_surface(axes, exact, camera)
    figure.text(
        0.28,
        0.93,
        "A surface of genus 2, cut open and laid out in the plane:\nthe grid of "
        "the plane, drawn on the surface",
        ha="center",
        va="center",
        linespacing=1.3,
    )
    legend(axes)
    draw_close_ups(
        figure, exact, camera, computed.uv - exact.uv, best_crossing(exact, camera, buffer)
    )
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
