# A cut solid, with the integer planes of its map and its singular curves.
#
#   volume.py SNAPPED.hexex OUT.png

import itertools
import sys

from matplotlib.lines import Line2D

from renderer import Buffer, Camera, distance_to_isolines, visible_pieces
from style import BLUE, VERMILLION, np, plt, rgb, save, show


class Triangles:
    """For the renderer: triangles of their own corners, with coordinates."""

    def __init__(self, triangles):
        corners = np.array(triangles)  # of points and coordinates
        self.points = corners[..., :3].reshape(-1, 3)
        self.faces = np.arange(len(self.points)).reshape(-1, 3)
        self.uv = corners[..., 3:]

    def face_normals(self):
        p = self.points[self.faces]
        return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])


def read_hexex(filename):
    """Points, cells, and the coordinates of their corners."""
    with open(filename, encoding="utf-8") as lines:
        words = iter(lines.read().split())
    points = [[float(next(words)) for _ in range(3)] for _ in range(int(next(words)))]
    cells, uvw = [], []
    for _ in range(int(next(words))):
        cells.append([int(next(words)) for _ in range(4)])
        uvw.append([[float(next(words)) for _ in range(3)] for _ in range(4)])
    return np.array(points), np.array(cells), np.array(uvw)


def clipped(polygon, normal):
    """The part of a polygon where a linear function of its points is positive."""
    result = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        s, t = a[:3] @ normal, b[:3] @ normal
        if s >= 0:
            result.append(a)
        if s * t < 0:
            result.append(a + (b - a) * s / (s - t))
    return result


def section(corners, normal):
    """The polygon in which the plane through the origin cuts a tetrahedron."""
    values = corners[:, :3] @ normal
    above, below = np.nonzero(values >= 0)[0], np.nonzero(values < 0)[0]
    ends = [(i, j) for i in above for j in below]
    if len(ends) == 4:
        ends[2], ends[3] = ends[3], ends[2]
    return [corners[i] + (corners[j] - corners[i]) * values[i] / (values[i] - values[j])
            for i, j in ends]


def fan(polygon):
    return [(polygon[0], polygon[k], polygon[k + 1]) for k in range(1, len(polygon) - 1)]


def facets_of(cells):
    """The corners, as places in `cells`, by the vertices of facets."""
    result = {}
    for c, cell in enumerate(cells):
        for k in range(4):
            places = [(c, i) for i in range(4) if i != k]
            places.sort(key=lambda place: cells[place])
            result.setdefault(tuple(cells[p] for p in places), []).append(places)
    return result


def singular_edges(cells, cuts, interior):
    """Interior edges with another number of cuts than none or two."""
    number = {}
    for facet in cuts:
        for edge in itertools.combinations(facet, 2):
            number[edge] = number.get(edge, 0) + 1
    return [edge for edge, count in number.items() if edge in interior and count > 2]


def main(filename, out):
    points, cells, uvw = read_hexex(filename)
    corners = np.concatenate([points[cells], uvw], axis=-1)
    facets = facets_of(cells)
    border = [places[0] for places in facets.values() if len(places) == 1]
    cuts = [facet for facet, places in facets.items() if len(places) == 2 and any(
        (uvw[a] != uvw[b]).any() for a, b in zip(*places))]
    border_edges = {edge for facet, places in facets.items() if len(places) == 1
                    for edge in itertools.combinations(facet, 2)}
    interior = {edge for facet in cuts for edge in itertools.combinations(facet, 2)} - border_edges

    # a wedge is taken away, where both products are positive; three singular curves lie just there
    a, b = np.array([0.012, 1.0, 1.0]), np.array([1.0, 1.0, 0.012])
    triangles = []
    for places in border:
        polygon = [corners[p] for p in places]
        for part in (clipped(polygon, -a), clipped(clipped(polygon, a), -b)):
            triangles += fan(part)
    number_of_outer = len(triangles)
    for cell in corners:
        for normal, other in ((a, b), (b, a)):
            triangles += fan(clipped(section(cell, normal), other))
    mesh = Triangles(triangles)
    camera = Camera((-0.75, -1.0, -0.45), (0, 0, 1), (0, 0, 0), 2.15, (760, 720))
    buffer = Buffer(mesh, camera)

    # where a coordinate is constant on the surface itself, its planes are not drawn
    is_constant = np.ptp(mesh.uv, axis=1) < 1e-6
    shown = buffer.face[buffer.face >= 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        near = (distance_to_isolines(buffer, mesh.uv) < 0.006) & ~is_constant[shown]
    colors = np.where((shown < number_of_outer)[:, None], rgb("#c9d8e4"), rgb("#f7f3e8"))
    colors[near.any(axis=1)] = rgb(BLUE)
    figure = plt.figure(figsize=(7.6, 7.7))
    axes = figure.add_axes([0, 0.06, 1, 0.94])
    show(axes, buffer.image(colors, is_smooth=False))
    for edge in singular_edges(cells, cuts, interior):
        for piece in visible_pieces(buffer, points[list(edge)], slack=0.03):
            axes.plot(*piece.T, color=VERMILLION, lw=4)
    axes.legend(
        [Line2D([], [], color=c, lw=w) for c, w in ((BLUE, 3), (VERMILLION, 4))],
        ["a coordinate is an integer", "singular curve"],
        loc="upper center",
        bbox_to_anchor=(0.5, 0.02),
        ncol=2,
        frameon=False,
    )
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
