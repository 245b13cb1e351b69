# Quads of several programs side by side: what quad_comparison --results has left in a folder.
#
#   comparison.py FOLDER NUMBER OUT.png MESH...

import sys
from pathlib import Path

from polygon_mesh import Polygon_mesh, draw_edges, draw_points
from renderer import Buffer, Camera
from style import BLACK, VERMILLION, np, plt, save, show

PROGRAMS = {"quad_remesh": "quad_remesh()", "quadriflow": "QuadriFlow"}
SIZE = (460, 380)


def read_off(filename, unit=1):
    words = iter(filename.read_text(encoding="utf-8").split()[1:])
    points, polygons, _ = (int(next(words)) for _ in range(3))
    return Polygon_mesh(
        [[float(next(words)) / unit for _ in range(3)] for _ in range(points)],
        [[int(next(words)) for _ in range(int(next(words)))] for _ in range(polygons)],
    )


def shown_area(mesh, camera):
    return (Buffer(mesh, camera, samples=1).face >= 0).sum() / camera.scale**2


def views(mesh, pixels):
    """From above, around the y-axis and the z-axis: files have one of them upwards."""
    for up in np.eye(3)[[2, 1]]:
        right = np.array([1.0, 0, 0])
        for angle in np.arange(8) * np.pi / 4 + 0.46:
            front = np.cos(angle) * np.cross(right, up) + np.sin(angle) * right
            direction = -0.9 * front - 0.42 * up
            camera = Camera(direction, up, np.zeros(3), 2, (2, 2))
            places = np.stack([mesh.points @ camera.right, mesh.points @ camera.up], axis=-1)
            extent, middle = np.ptp(places, axis=0), (places.max(axis=0) + places.min(axis=0)) / 2
            center = middle[0] * camera.right + middle[1] * camera.up
            width = 1.06 * max(extent[0], extent[1] * pixels[0] / pixels[1])
            yield up, Camera(direction, up, center, width, pixels)


def width_of_stand(mesh, up):
    """The spread of the lowest points, on which the mesh stands, if its middle is above them."""
    height = mesh.points @ up
    low = mesh.points[height < height.min() + 0.03 * np.ptp(height)]
    low, middle = low - np.outer(low @ up, up), mesh.points.mean(axis=0)
    across = [np.array([1.0, 0, 0]), np.cross(up, [1.0, 0, 0])]
    ranges = [((low @ a).min(), (low @ a).max(), middle @ a) for a in across]
    if any(not a < m < b for a, b, m in ranges):
        return 0
    area = np.prod([np.ptp(mesh.points @ a) for a in across])
    return np.prod([b - a for a, b, _ in ranges]) / area


def natural_view(mesh):
    """Upright, from the side that shows most."""
    upright = max(np.eye(3)[[2, 1]], key=lambda up: width_of_stand(mesh, up))
    small = [camera for up, camera in views(mesh, (92, 76)) if (up == upright).all()]
    large = [camera for up, camera in views(mesh, SIZE) if (up == upright).all()]
    return large[int(np.argmax([shown_area(mesh, camera) for camera in small]))]


def draw(axes, mesh, camera):
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.95), is_smooth=False))
    draw_edges(axes, buffer, mesh, BLACK, 0.7)
    draw_points(axes, buffer, camera, mesh.points[mesh.irregular_vertices(4)], VERMILLION)


def main(folder, number, out, *names):
    figure, grid = plt.subplots(
        len(PROGRAMS), len(names), figsize=(SIZE[0] / 110 * len(names), 7.8), squeeze=False
    )
    for column, name in zip(grid.T, names):
        mesh = read_off(Path(folder) / (name + ".off"))
        unit = np.ptp(mesh.points, axis=0).max() / 4
        mesh.points /= unit
        camera = natural_view(mesh)
        for axes, (program, title) in zip(column, PROGRAMS.items()):
            quads = read_off(Path(folder) / f"{name}_{number}_{program}.off", unit)
            draw(axes, quads, camera)
            axes.set_title(f"{name}, {title}: {len(quads.polygons)} quads", fontsize=11)
    figure.subplots_adjust(0.01, 0.01, 0.99, 0.94, 0.02, 0.1)
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
