"""Small meshes to try things on."""

import numpy as np


def box():
    """Return the points and triangles of a cube."""
    V = np.array([[x, y, z] for x in (0., 1.) for y in (0., 1.) for z in (0., 1.)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    F = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return V, np.array(F)


def _grid(columns, rows):
    """Triangles of a periodic grid."""
    i, j = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    a, b = i * rows + j, (i + 1) % columns * rows + j
    c, d = (i + 1) % columns * rows + (j + 1) % rows, i * rows + (j + 1) % rows
    return np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], axis=2).reshape(-1, 3)


def torus(columns=48, rows=24, radius=1., small_radius=0.4):
    """Return the points and triangles of a torus."""
    s = 2 * np.pi * np.arange(columns) / columns
    t = 2 * np.pi * np.arange(rows) / rows
    s, t = np.meshgrid(s, t, indexing="ij")
    r = radius + small_radius * np.cos(t)
    V = np.stack([r * np.cos(s), r * np.sin(s), small_radius * np.sin(t)], axis=-1).reshape(-1, 3)
    return V, _grid(columns, rows)


def inexact_map(columns=12, rows=8, noise=1e-9, seed=1):
    """Return the triangles of a torus, and coordinates of their corners with some noise."""
    F = _grid(columns, rows)
    i, j = np.divmod(F, rows)
    u = i / columns + 1 * (np.ptp(i, axis=1) == columns - 1)[:, None] * (i == 0)
    v = j / rows + 1 * (np.ptp(j, axis=1) == rows - 1)[:, None] * (j == 0)
    uv = np.stack([u, v], axis=-1)
    return F, uv + noise * np.random.default_rng(seed).standard_normal(uv.shape)


def inexact_volume(n=2, noise=1e-9, seed=1):
    """Return the tetrahedra of a cube, and coordinates of their corners with some noise."""
    index = lambda x, y, z: (x * (n + 1) + y) * (n + 1) + z
    corners = np.array(np.meshgrid(*[np.arange(n)] * 3, indexing="ij")).reshape(3, -1).T
    axes = [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)]
    T, uvw = [], []
    for corner in corners:
        for order in axes:  # along three edges, from a corner to the opposite one
            path = [np.array(corner)]
            for axis in order:
                path.append(path[-1] + np.eye(3, dtype=int)[axis])
            T.append([index(*p) for p in path])
            uvw.append(path)
    uvw = np.array(uvw, dtype=float)
    return np.array(T), uvw + noise * np.random.default_rng(seed).standard_normal(uvw.shape)


def volume(n=2, noise=1e-9, seed=1):
    """Return the points and tetrahedra of a bent bar, and coordinates of their corners with some noise."""
    T, uvw = inexact_volume(n, noise, seed)
    x, y, z = np.array(np.meshgrid(*[np.arange(n + 1) / n] * 3, indexing="ij")).reshape(3, -1)
    angle, r = 0.5 * np.pi * x, 1 + y
    return np.stack([r * np.sin(angle), r * np.cos(angle), z], axis=1), T, uvw


def draw(V, Q, path, direction=(1, -1.5, 1)):
    """Draw the faces of a mesh, seen from a direction, as a file of the format SVG."""
    V, view = np.asarray(V, dtype=float), np.array(direction, dtype=float)
    view /= np.linalg.norm(view)
    right = np.cross([0., 0., 1.], view)
    right /= np.linalg.norm(right)
    plane = np.stack([V @ right, -V @ np.cross(view, right)], axis=1)
    plane = 20 + 560 * (plane - plane.min(axis=0)) / np.ptp(plane, axis=0).max()
    corners = V[Q]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, -1] - corners[:, 1])
    light = np.abs(normal @ view) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    width, height = plane.max(axis=0) + 20
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" '
                   f'height="{height:.0f}">\n')
        for i in np.argsort((corners @ view).mean(axis=1)):  # the farthest face first
            points = " ".join(f"{x:.1f},{y:.1f}" for x, y in plane[Q[i]])
            gray = int(110 + 140 * light[i])
            file.write(f'<polygon points="{points}" fill="rgb({gray},{gray},{gray})" '
                       'stroke="rgb(40,70,110)" stroke-linejoin="round"/>\n')
        file.write("</svg>\n")
