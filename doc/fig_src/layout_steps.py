# The steps of a motorcycle graph: the isocurves of an exact map, curves that have left all cones at
# the same time, at an early and a later time, and the rectangles between them.
#
#   layout_steps.py SNAPPED.obj LAYOUT.obj OUT.png

import sys

from layout_gaps import Race, draw_cones, draw_lines
from renderer import Buffer, Camera, distance_to_isolines
from style import BLUE, ORANGE, np, plt, rgb, save, show
from uv_mesh import read_obj


def read_patches(filename):
    """The points and faces of a layout, and the patch of each face."""
    points, faces, patches, arcs, patch = [], [], [], [], -1
    with open(filename, encoding="utf-8") as lines:
        for words in map(str.split, lines):
            if words[:1] == ["v"]:
                points.append([float(x) for x in words[1:4]])
            elif words[:1] == ["g"] and words[1].startswith("patch_"):
                patch = int(words[1][len("patch_"):])
            elif words[:1] == ["f"]:
                corners = [int(w.split("/")[0]) - 1 for w in words[1:]]
                for a, b in zip(corners[1:], corners[2:]):
                    faces.append([corners[0], a, b])
                    patches.append(patch)
            elif words[:1] == ["l"]:
                arcs.append([int(i) - 1 for i in words[1:]])
    return np.array(points), np.array(faces), np.array(patches), arcs


class Patch_mesh:
    def __init__(self, points, faces):
        self.points, self.faces = points, faces

    def face_normals(self):
        p = self.points[self.faces]
        return np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])


def until(race, time):
    """The curves as they are at a time."""
    lines = []
    for curve in race.curves:
        end, curve.end = curve.end, min(curve.end, time)
        line = race.polyline(curve)
        curve.end = end
        if line:
            lines.append(line)
    return lines


def main(map_name, layout_name, out):
    mesh = read_obj(map_name)
    race = Race(mesh, 60)
    points, faces, patches, arcs = read_patches(layout_name)
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    camera = Camera((0.35, 1, -0.95), (0, 0, 1), (low + high) / 2, 1.26 * (high - low).max(),
                    (640, 400))
    buffer = Buffer(mesh, camera)
    plain = np.full(((buffer.face >= 0).sum(), 3), 0.95)
    isolines = plain.copy()
    near = distance_to_isolines(buffer, mesh.uv) < 0.008
    isolines[near[:, 1]], isolines[near[:, 0]] = rgb(ORANGE), rgb(BLUE)
    longest = max(c.end for c in race.curves if c.end < np.inf)
    figure = plt.figure(figsize=(14, 9.6))
    titles = (
        ("1  Exactly seamless map", "blue: $u$ is an integer; orange: $v$ is an integer; dots: cones"),
        ("2  Start", "curves leave each cone in all directions, at the same time"),
        ("3  Meetings", "a curve stops at a point that another curve has passed before"),
        ("4  Layout", "the patches between the curves are rectangles"),
    )
    for i, (title, text) in enumerate(titles):
        row, column = divmod(i, 2)
        left, bottom = 0.005 + 0.5 * column, 0.51 - 0.49 * row
        axes = figure.add_axes([left, bottom, 0.485, 0.4])
        if i == 3:
            patch_buffer = Buffer(Patch_mesh(points, faces), camera)
            shades = np.random.default_rng(3).uniform(0.72, 1, (patches.max() + 1, 3))
            colors = shades[patches[patch_buffer.face[patch_buffer.face >= 0]]]
            show(axes, patch_buffer.image(colors, is_smooth=False))
            draw_lines(axes, patch_buffer, [points[arc] for arc in arcs], BLUE, 1.8)
        else:
            show(axes, buffer.image(isolines if i == 0 else plain, is_smooth=False))
        if i in (1, 2):
            draw_lines(axes, buffer, until(race, longest * (0.12, 0.45)[i - 1]), BLUE, 1.8)
        draw_cones(axes, mesh, buffer)
        figure.text(left + 0.01, bottom + 0.46, title, weight="bold", fontsize=15, va="top")
        figure.text(left + 0.01, bottom + 0.43, text, fontsize=12.5, va="top")
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
