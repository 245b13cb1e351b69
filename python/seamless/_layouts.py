"""Quads, layouts, and isocurves of parametrizations."""

import dataclasses

import numpy as np

from . import _checks, _core, _words
from ._calls import call, make
from ._errors import Error
from ._meshes import surface_map


def extract_quads(V, F, uv, quads=None, *, grid_scale=1, rounding=None, features=None,
                  align_border=False, repair_flips=False, allow_holes=False, weld=False,
                  progress=None, report=False):
    """Extract the quads of a parametrization: the cells of its integer grid.

    Without a number of quads, the coordinates must be near whole numbers at cones and translations; they
    are rounded to these first. With a number of quads, the coordinates need only be seamless, with no
    flipped triangle: the function chooses whole numbers so that about as many quads come out.

    Cells around cones between the lines of the grid have other than four corners. They are not in the
    array of quads, but in the report.

    Parameters
    ----------
    V, F : array_like
        points, ``(n, 3)``, and triangles, ``(m, 3)``
    uv : array_like
        coordinates of the corners, ``(m, 3, 2)``
    quads : int, optional
        about how many quads to make
    grid_scale : float
        without `quads`: a factor for the coordinates
    rounding : float, optional
        the largest distance to the next whole number at which translations, cones, and aligned edges
        are rounded: 0.01 by default, and with `quads` 0.5, or any distance if nothing else helps
    features : array_like, optional
        edges that the quads keep, ``(k, 2)``
    align_border : bool
        whether border edges that are nearly on isocurves become edges of quads
    repair_flips : bool
        whether to repair triangles that are flipped in the plane. If that inverts quads of the map, about
        as many quads are made of other whole numbers.
    allow_holes : bool
        whether to leave out the quads around triangles that are still flipped, instead of refusing
    weld : bool
        whether to join border edges in the same place, for example of a mesh that is cut open along its
        seams
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    V : numpy.ndarray
        float64 ``(l, 3)``: the points
    Q : numpy.ndarray
        int64 ``(k, 4)``: the quads
    report : dict, if `report` is True
        among others ``integers``, which tells the source of the whole numbers in words;
        ``number_of_inverted_quads``; ``number_of_folded_quads``, if vertices were smoothed;
        ``other_polygons``, lists of points of the faces that are no quads; and ``number_of_cut_cells``,
        pieces of cells at the border, which are left out

    Raises
    ------
    Error
        if an argument is not as above, the coordinates are not seamless, or not near integers

    Examples
    --------
    >>> import seamless
    >>> V, F = seamless.examples.torus()
    >>> uv = seamless.parametrize(V, F)
    >>> V2, Q = seamless.extract_quads(V, F, uv, quads=400)
    >>> Q.shape[1]
    4
    """
    F, uv, V, features = surface_map(F, uv, V, features, needs_points=True)
    if quads is not None and grid_scale != 1:
        raise Error("quads and grid_scale exclude each other", "pass one of them")
    return make(
        _core.extract_quads, V, F, uv, features, 0 if quads is None else _checks.count(quads, "quads"),
        _checks.number(grid_scale, "grid_scale", 0, is_open=True),
        _checks.optional(_checks.number, rounding, "rounding", 0),
        _checks.flag(align_border, "align_border"), _checks.flag(repair_flips, "repair_flips"),
        _checks.flag(allow_holes, "allow_holes"), _checks.flag(weld, "weld"), progress=progress,
        report=report)


@dataclasses.dataclass(frozen=True)
class Layout:
    """A division of a surface into rectangles, as `layout` makes it.

    Nodes, arcs, and patches are numbered from 0. Arc ``a`` consists of the half-arcs ``2 a``, which
    runs from its first node to its second one, and ``2 a + 1``, which runs back. A patch lies at the left
    of its half-arcs, seen from outside.

    Attributes
    ----------
    nodes : float64 (k, 3)
        the places of the nodes
    node_kinds : list of str
        ``'cone'``, ``'corner'``, ``'given'``, ``'seed'`` (chosen in a part without any other node), or
        ``'junction'``, at which a curve ends at another one
    node_vertices : int64 (k,)
        the vertex that a node is, or -1
    node_faces, node_weights : int64 (k,), float64 (k, 3)
        a triangle that a node lies in, and its barycentric coordinates there
    arcs : int64 (a, 2)
        the nodes of each arc
    arc_lengths : float64 (a,)
        the lengths in units of u and v, rounded to floats; 0 for arcs along a border that is not aligned
    arc_is_constrained : bool (a,)
        whether an arc runs along the border or features
    arc_patches : int64 (a, 2)
        the patches at the left and at the right, or -1
    arc_paths : list of float64 (p, 3)
        the course of each arc on the surface
    patch_corners : int64 (p, 4)
        the nodes at the corners of each rectangle, counterclockwise; -1 for patches that are cut
    patch_sizes : float64 (p, 2)
        width and height in units of u and v, rounded to floats
    patch_is_cut : bool (p,)
        whether a border that is not aligned cuts the patch, so that it is no rectangle
    patch_half_arcs : list of int64 arrays
        the half-arcs around each patch
    message : str
        a remark about the border, if it cuts patches; else empty
    """

    nodes: np.ndarray
    node_kinds: list
    node_vertices: np.ndarray
    node_faces: np.ndarray
    node_weights: np.ndarray
    arcs: np.ndarray
    arc_lengths: np.ndarray
    arc_is_constrained: np.ndarray
    arc_patches: np.ndarray
    arc_paths: list
    patch_corners: np.ndarray
    patch_sizes: np.ndarray
    patch_is_cut: np.ndarray
    patch_half_arcs: list
    message: str


_KINDS = ("cone", "corner", "given", "seed", "junction")


def layout(V, F, uv, *, features=None, base_complex=False):
    """Divide a surface into rectangles along isocurves of an exactly seamless parametrization.

    Curves start at all cones and corners, and end at curves that have been there before.

    Parameters
    ----------
    V, F : array_like
        points, ``(n, 3)``, and triangles, ``(m, 3)``
    uv : array_like
        exactly seamless coordinates of the corners, ``(m, 3, 2)``, as `snap` and `parametrize` return
        them. If the border is aligned, all patches are rectangles.
    features : array_like, optional
        edges that are arcs, ``(k, 2)``: a coordinate must be constant along each, exactly
    base_complex : bool
        whether curves cross each other, and run on to a cone, corner, border, or feature

    Returns
    -------
    Layout

    Raises
    ------
    Error
        if an argument is not as above, the coordinates are not exactly seamless, or triangles are
        flipped in the plane

    Examples
    --------
    >>> import seamless
    >>> V, F = seamless.examples.torus()
    >>> uv = seamless.parametrize(V, F)
    >>> bool(seamless.layout(V, F, uv).patch_is_cut.any())
    False
    """
    F, uv, V, features = surface_map(F, uv, V, features, needs_points=True)
    d = call(_core.layout, V, F, uv, features, _checks.flag(base_complex, "base_complex"))
    paths = np.split(places(V, F, d["path_faces"], d["path_weights"]), d["path_offsets"][1:-1])
    halves = np.split(d["patch_half_arcs"], d["patch_offsets"][1:-1])
    return Layout(
        nodes=places(V, F, d["node_faces"], d["node_weights"]),
        node_kinds=[_KINDS[kind] for kind in d["node_kinds"]], node_vertices=d["node_vertices"],
        node_faces=d["node_faces"], node_weights=d["node_weights"], arcs=d["arcs"],
        arc_lengths=d["arc_lengths"], arc_is_constrained=d["arc_is_constrained"].astype(bool),
        arc_patches=d["arc_patches"], arc_paths=paths, patch_corners=d["patch_corners"],
        patch_sizes=d["patch_sizes"], patch_is_cut=d["patch_is_cut"].astype(bool),
        patch_half_arcs=halves, message=_words.sentence(d["message"], "layout"))


@dataclasses.dataclass(frozen=True)
class Curve:
    """An isocurve, as `trace` returns it.

    Attributes
    ----------
    faces : int64 (k,)
        a triangle for each point of the curve
    weights : float64 (k, 3)
        the barycentric coordinates of each point there, rounded
    direction : int
        0, 1, 2, or 3 if the curve starts along +u, +v, -u, or -v in the plane of its first triangle
    end : str
        how it ends: ``'singular vertex'``, ``'border'``, ``'closed'``, ``'maximum length'``,
        ``'maximum number'`` (it has crossed three times as many edges as there are triangles), or
        ``'constant on a face'`` (at a degenerate triangle)
    """

    faces: np.ndarray
    weights: np.ndarray
    direction: int
    end: str

    def points(self, V, F):
        """Return the points of the curve on a surface, ``(k, 3)``."""
        V = _checks.points(V)
        return places(V, _checks.cells(F, "F", len(V)), self.faces, self.weights)


def trace(F, uv, start=None, *, maximum_length=None, progress=None):
    """Trace isocurves of an exactly seamless parametrization, across its cuts, without a tolerance.

    Parameters
    ----------
    F : array_like
        triangles, ``(m, 3)``
    uv : array_like
        exactly seamless coordinates of the corners, ``(m, 3, 2)``
    start : optional
        where the curves start: vertices, ``(k,)``; or places inside of triangles, as a pair of arrays:
        triangles, ``(k,)``, and barycentric coordinates, ``(k, 3)``. Curves start in all directions
        along which a coordinate is constant. By default, they start at all singular vertices.
    maximum_length : float, optional
        the length in the plane after which a curve ends
    progress : callable, optional
        as for `parametrize`

    Returns
    -------
    list of Curve

    Raises
    ------
    Error
        if an argument is not as above, or the coordinates are not exactly seamless

    Examples
    --------
    >>> import seamless
    >>> F, uv = seamless.examples.inexact_map()
    >>> uv = seamless.snap(F, uv)
    >>> [curve.end for curve in seamless.trace(F, uv, [0], maximum_length=0.5)]
    ['maximum length', 'maximum length', 'maximum length', 'maximum length']
    """
    F, uv, _, _ = surface_map(F, uv, None, None)
    d = call(_core.trace, F, uv, *_start(start, F),
             _checks.optional(_checks.number, maximum_length, "maximum_length", 0, is_open=True),
             _checks.progress(progress))
    offsets = d["offsets"]
    return [Curve(d["path_faces"][i:j], d["path_weights"][i:j], int(direction), end)
            for i, j, direction, end in zip(offsets, offsets[1:], d["directions"], d["ends"])]


def _start(start, F):
    """Vertices, or None; triangles and weights, or None."""
    if start is None:
        return None, None, None
    if isinstance(start, (tuple, list)) and len(start) == 2 and np.ndim(start[1]) == 2:
        faces = _checks.indices(np.reshape(_checks._array(start[0], "start[0]"), (-1, 1)), "start[0]", 1,
                                len(F), "F", "one triangle for each place")[:, 0]
        weights = _checks.doubles(start[1], "start[1]", (len(faces), 3),
                                  "three barycentric coordinates for each place")
        bad = (weights <= 0).any(axis=1) | (np.abs(weights.sum(axis=1) - 1) > 1e-6)
        if bad.any():
            row = f"row {int(np.argmax(bad))} of start[1]"
            raise Error(f"{row} is no place inside of a triangle", "pass positive weights whose sum is 1",
                        row)
        return None, np.ascontiguousarray(faces), weights
    vertices = _checks.indices(np.reshape(_checks._array(start, "start"), (-1, 1)), "start", 1,
                               int(F.max()) + 1, "the mesh", "one vertex for each start")[:, 0]
    missing = ~np.isin(vertices, F)
    if missing.any():
        row = f"row {int(np.argmax(missing))} of start"
        raise Error(f"{row} is the vertex {vertices[missing][0]}, which no triangle has",
                    "pass vertices of triangles", row)
    return np.ascontiguousarray(vertices), None, None


def places(V, F, faces, weights):
    """Points of a surface, by triangles and barycentric coordinates."""
    return np.einsum("ni,nij->nj", weights, V[F[faces]])
