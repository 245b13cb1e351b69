"""What counts as a mesh: two arrays, or an object of another library that has them."""

import itertools

import numpy as np

from . import _checks
from ._errors import Error


def _from_object(mesh):
    """The arrays of an object like those of trimesh (vertices, faces) and meshio (points, cells)."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "points") and hasattr(mesh, "cells"):
        return mesh.points, _cells(mesh, "triangle", 3)
    raise Error(f"V is a {type(mesh).__name__}, and F is missing", "pass points and triangles, or a "
                "mesh with vertices and faces, as of trimesh, or with points and cells, as of meshio")


def _cells(mesh, kind, corners):
    """All cells of a kind of a meshio mesh."""
    blocks = []
    for block in mesh.cells:
        block_kind, data = (block.type, block.data) if hasattr(block, "type") else block
        if block_kind == kind:
            blocks.append(np.asarray(data))
        elif kind == "triangle" and block_kind in ("quad", "polygon"):
            raise Error(f"the mesh has cells of the kind {block_kind!r}", "triangulate them first")
    if not blocks:
        raise Error(f"the mesh has no cells of the kind {kind!r}, of {corners} corners")
    return np.concatenate(blocks)


def surface(V, F):
    """Return float64 points and int64 triangles."""
    if F is None:
        V, F = _from_object(V)
    V = _checks.points(V)
    F = _checks.cells(F, "F", len(V))
    if all((V[F[:, k]] == V[F[0, 0]]).all() for k in range(3)):
        raise Error("all rows of V that triangles have are the same point")
    return V, F


def surface_map(F, uv, V, features, needs_points=False):
    """Return the arrays of a parametrized surface; without points, `V` may be None."""
    size = None
    if V is not None or needs_points:
        V = _checks.points(V)
        size = len(V)
    F = _checks.cells(F, "F", size)
    return F, corner_uv(uv, F), V, _checks.features(features, "features", size)


def volume_map(T, uvw, feature_facets, feature_edges, size=None):
    """Return the arrays of a parametrized tetrahedral mesh."""
    T = _checks.cells(T, "T", size, 4)
    uvw = _checks.doubles(uvw, "uvw", (len(T), 4, 3),
                          "three coordinates for each corner of each tetrahedron")
    return T, uvw, _volume_features(feature_facets, "feature_facets", T, size, 3), \
        _volume_features(feature_edges, "feature_edges", T, size, 2)


def _volume_features(features, name, T, size, corners):
    """Return int64 facets or edges of tetrahedra, or None."""
    features = _checks.features(features, name, size, corners)
    if features is None:
        return None
    sides = np.concatenate([T[:, c] for c in itertools.combinations(range(4), corners)])
    sides = sides[np.isin(sides, features).all(axis=1)]
    known = set(map(tuple, np.sort(sides, axis=1).tolist()))
    for i, side in enumerate(np.sort(features, axis=1).tolist()):
        if tuple(side) not in known:
            row = f"row {i} of {name}"
            raise Error(f"{row} has the vertices {', '.join(map(str, features[i]))}, but no tetrahedron "
                        f"has {'an edge' if corners == 2 else 'a facet'} of these", place=row)
    return features


def corner_uv(uv, F):
    """Return float64 coordinates of the corners of triangles."""
    array = _checks._array(uv, "uv")
    if array.ndim == 2 and array.shape == (3 * len(F), 2):
        array = array.reshape(len(F), 3, 2)
    if array.ndim == 2 and array.shape[1:] == (2,):
        raise Error(f"uv has the shape {array.shape}, but its shape must be ({len(F)}, 3, 2): two "
                    "coordinates for each corner of each triangle",
                    "for coordinates of vertices, pass uv[F]")
    return _checks.doubles(array, "uv", (len(F), 3, 2),
                           "two coordinates for each corner of each triangle")
