# The steps from triangles to quads: triangles, cross field, seamless map, integers between cones,
# the quads of the map, and the quads with their vertices moved.
#
#   remeshing_steps.py MAP.obj SCALED_MAP.obj QUADS.obj REMESHED.obj OUT.png

import sys

from matplotlib.lines import Line2D
from matplotlib.patches import FancyArrowPatch

from polygon_mesh import draw_edges, draw_points, read_polygons
from quads import draw_map
from renderer import Buffer, Camera, visible_pieces
from style import BLACK, BLUE, GRAY, ORANGE, VERMILLION, np, plt, save, show
from uv_mesh import read_obj


def draw_triangles(axes, mesh, camera):
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.95), is_smooth=False))
    done = set()
    for a, b in zip(mesh.source, mesh.target):
        if frozenset((a, b)) not in done:
            done.add(frozenset((a, b)))
            for piece in visible_pieces(buffer, mesh.points[[a, b]]):
                axes.plot(*piece.T, color=GRAY, lw=0.6)


def gradient_of_u(mesh, f):
    p, u = mesh.points[mesh.faces[f]], mesh.uv[f]
    e = np.array([p[1] - p[0], p[2] - p[0]])
    normal = np.cross(*e)
    return np.linalg.solve(np.vstack([e, normal]), [u[1, 0] - u[0, 0], u[2, 0] - u[0, 0], 0])


def draw_field(axes, mesh, camera, spacing=0.34):
    """Crosses along the gradients of the map, on faces that are apart from each other."""
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.95)))
    middles = mesh.points[mesh.faces].mean(axis=1)
    normals = mesh.face_normals()
    kept = []
    for f in np.random.default_rng(1).permutation(len(mesh.faces)):
        if all(np.linalg.norm(middles[f] - middles[g]) > spacing for g in kept):
            kept.append(f)
    for f in kept:
        d = gradient_of_u(mesh, f)
        d *= 0.4 * spacing / np.linalg.norm(d)
        across = np.cross(normals[f], d) / np.linalg.norm(normals[f])
        for arm in (d, across):
            for piece in visible_pieces(buffer, [middles[f] - arm, middles[f] + arm], 0.02, 0.05):
                axes.plot(*piece.T, color=BLUE, lw=1.6)
    draw_points(axes, buffer, camera, mesh.points[sorted(mesh.cones())], VERMILLION)


def draw_quads(axes, mesh, camera):
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.95), is_smooth=False))
    draw_edges(axes, buffer, mesh, BLACK, 0.8)
    draw_points(axes, buffer, camera, mesh.points[mesh.irregular_vertices(4)], VERMILLION)


def draw_triangle(axes, corners, color, texts):
    """With the vector of each edge beside it: below, at the right, and at the left."""
    closed = np.vstack([corners, corners[:1]])
    axes.plot(*closed.T, color=color, lw=2)
    axes.plot(*corners.T, "o", color=VERMILLION, ms=9, zorder=4)
    sides = (("center", "top", (0, -0.6)), ("left", "center", (0.4, 0.3)),
             ("right", "center", (-0.4, 0.3)))
    for i, (text, (ha, va, offset)) in enumerate(zip(texts, sides)):
        p = (closed[i] + closed[i + 1]) / 2 + offset
        axes.text(*p, text, color=color, fontsize=12, ha=ha, va=va,
                  bbox={"fc": "white", "ec": "none", "pad": 1.0}, zorder=3)


def draw_integers(axes):
    """A triangle of the coarse triangulation, before and after."""
    axes.set_aspect("equal")
    axes.set_xlim(-4.4, 24.4)
    axes.set_ylim(-2.2, 9.2)
    axes.axis("off")
    for first in (0, 14):
        x, y = np.meshgrid(np.arange(first, first + 9), np.arange(0, 8))
        axes.plot(x.ravel(), y.ravel(), "o", color="#c8c8c8", ms=3)
    real = np.array([[1, 1], [6.7, 1.4], [3.6, 6.3]])
    whole = np.array([[15, 1], [21, 1], [18, 6]])
    draw_triangle(axes, real, ORANGE, ["(5.7, 0.4)", "(−3.1, 4.9)", "(−2.6, −5.3)"])
    draw_triangle(axes, whole, BLUE, ["(6, 0)", "(−3, 5)", "(−3, −5)"])
    axes.add_patch(FancyArrowPatch((9.6, 1.5), (12.6, 1.5), arrowstyle="-|>", mutation_scale=20,
                                   lw=2, color=BLACK))


def main(map_name, scaled_name, quads_name, remeshed_name, out):
    mesh, scaled = read_obj(map_name), read_obj(scaled_name)
    quads, remeshed = read_polygons(quads_name), read_polygons(remeshed_name)
    camera = Camera((0.35, 1, -0.95), (0, 0, 1), mesh.points.mean(axis=0), 5.4, (490, 340))
    figure = plt.figure(figsize=(14, 8.9))
    panels = (
        ("1  Triangles", "the input", lambda a: draw_triangles(a, mesh, camera)),
        ("2  Cross field", "smooth; its singularities are the cones",
         lambda a: draw_field(a, mesh, camera)),
        ("3  Seamless map", "along the field, exact across the cuts; its grid\n"
         "does not fit there yet", lambda a: draw_map(a, scaled, camera)),
        ("4  Quantization", "the vectors between cones become integers,\n"
         "and all triangles still close", draw_integers),
        ("5  Extraction", "the grid of the integer map is a mesh of quads",
         lambda a: draw_quads(a, quads, camera)),
        ("6  Positions", "vertices move along the surface",
         lambda a: draw_quads(a, remeshed, camera)),
    )
    for i, (title, text, draw) in enumerate(panels):
        row, column = divmod(i, 3)
        left, bottom = 0.005 + 0.333 * column, 0.56 - 0.47 * row
        axes = figure.add_axes([left, bottom, 0.32, 0.35])
        draw(axes)
        if axes.get_legend():
            axes.get_legend().remove()
        figure.text(left + 0.01, bottom + 0.405, title, weight="bold", fontsize=15, va="top")
        figure.text(left + 0.01, bottom + 0.37, text, fontsize=12, va="top", linespacing=1.2)
    lines = [Line2D([], [], color=VERMILLION, marker="o", lw=0, ms=7)]
    lines += [Line2D([], [], color=c, lw=3) for c in (BLUE, ORANGE, BLACK)]
    figure.legend(
        lines,
        ["cone, irregular vertex", "$u$ is an integer", "$v$ is an integer", "cut"],
        loc="lower center",
        ncol=4,
        frameon=False,
    )
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
