"""Functions on surfaces: triangles, and coordinates of their corners."""

import numpy as np

from . import _checks, _core
from ._calls import call, make
from ._errors import Error
from ._fields import directions
from ._meshes import surface, surface_map


_MOST_QUADS = 10**7  # unless a maximum allows more


def sharp_edges(V, F=None, angle=40, *, minimum_length=0, weld=None):
    """Find the edges at which a surface is sharp.

    Parameters
    ----------
    V : array_like
        points, ``(n, 3)``; or a mesh with ``vertices`` and ``faces``, or ``points`` and ``cells``
    F : array_like, optional
        triangles, ``(m, 3)``: rows of `V`
    angle : float
        an edge is sharp if the normals of its faces differ by at least this angle, in degrees
    minimum_length : float
        leave out chains of sharp edges that are shorter than this and end freely, which are mostly
        noise; 0 keeps all
    weld : bool, optional
        what to do if border edges lie in the same place, for example along the seams of a texture:
        True joins them, False leaves them open. By default, such a mesh is refused.

    Returns
    -------
    numpy.ndarray
        int64 ``(k, 2)``: the vertices of each edge, as other functions take them for `features`

    Raises
    ------
    Error
        if an argument is not as above, or the triangles are no oriented surface: an edge has more than two
        triangles, or neighbors list their vertices in opposite directions

    Examples
    --------
    >>> import seamless
    >>> V, F = seamless.examples.box()
    >>> seamless.sharp_edges(V, F).shape
    (12, 2)
    """
    V, F = surface(V, F)
    return call(_core.sharp_edges, V, F, _checks.number(angle, "angle", 0, 180),
                _checks.number(minimum_length, "minimum_length", 0),
                _checks.optional(_checks.flag, weld, "weld"))


def parametrize(V, F=None, *, features=None, align_border=False, curvature=0, field=None, weld=None,
                progress=None, report=False):
    """Compute an exactly seamless parametrization of a surface.

    Parameters
    ----------
    V : array_like
        points, ``(n, 3)``; or a mesh with ``vertices`` and ``faces``, or ``points`` and ``cells``
    F : array_like, optional
        triangles, ``(m, 3)``: rows of `V`
    features : array_like, optional
        edges along which a coordinate is to be constant, ``(k, 2)``: rows of `V`. An edge is given up if
        it can't be kept without flipped triangles; the report lists it.
    align_border : bool
        whether a coordinate is to be constant along each border edge
    curvature : float
        how strongly the isocurves follow the principal directions of curvature: 0 (not), or at least
        1e-9; 0.5 is strong
    field : array_like or path, optional
        a direction for each triangle, ``(m, 3)``, or a file that `read_field` reads. For a triangle with
        the direction (0, 0, 0), the function chooses the direction.
    weld : bool, optional
        as for `sharp_edges`
    progress : callable, optional
        is called with a line of text after each step, and a few times a second in long ones. If it
        raises an exception, the call ends with this exception.
    report : bool
        whether to return a report, too

    Returns
    -------
    uv : numpy.ndarray
        float64 ``(m, 3, 2)``: two coordinates for each corner of each triangle
    report : dict, if `report` is True
        among others ``cones``, int64 ``(k, 2)``: a vertex, and the number of quarter turns that its angle
        is less than 360 degrees; and ``released_edges``, ``(k, 2)``

    Raises
    ------
    Error
        if an argument is not as above, the triangles are no oriented surface, or no parametrization
        is found

    Examples
    --------
    >>> import seamless
    >>> V, F = seamless.examples.torus()
    >>> uv = seamless.parametrize(V, F)
    >>> seamless.measure(F, uv)["number_of_inexact_edges"]
    0
    """
    V, F = surface(V, F)
    return make(
        _core.parametrize, V, F, _checks.features(features, "features", len(V)),
        _checks.flag(align_border, "align_border"), _checks.number(curvature, "curvature", 0),
        directions(field, len(F)), _checks.optional(_checks.flag, weld, "weld"), progress=progress,
        report=report)


def snap(F, uv, *, V=None, features=None, align_border=False, tolerance=1e-4, repair_flips=False,
         weld=False, out=None, progress=None, report=False):
    """Make a parametrization exactly seamless, by changes of about the size of its errors.

    Afterwards the two sides of each edge differ by a rotation by a multiple of 90 degrees and a
    translation, exactly, in the numbers that are returned. This is verified in exact arithmetic.

    Parameters
    ----------
    F : array_like
        triangles, ``(m, 3)``: numbers of vertices, from 0
    uv : array_like
        coordinates of the corners, ``(m, 3, 2)``
    V : array_like, optional
        points, ``(n, 3)``; only `weld` needs them
    features : array_like, optional
        edges along which a coordinate is to be constant, ``(k, 2)``
    align_border : bool
        whether a coordinate is to be constant along each border edge
    tolerance : float
        the largest gap at a seam that counts as rounding error, relative to the extent of the
        coordinates; a larger gap raises an error
    repair_flips : bool
        whether to repair triangles that are flipped in the plane, by changing the coordinates around
        them if necessary
    weld : bool
        whether to join border edges in the same place, for example of a mesh that was cut open along
        its seams
    out : numpy.ndarray, optional
        receives the coordinates, if all goes well: float64, of the shape of `uv`; it may be `uv`
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    uv : numpy.ndarray
        float64 ``(m, 3, 2)``, or `out`
    report : dict, if `report` is True
        among others ``largest_change``, and ``status``: ``'already exact'`` if nothing had to be
        moved, ``'snapped'``, or ``'exact, but flips remain'``

    Raises
    ------
    Error
        if an argument is not as above, or the coordinates are not seamless up to the tolerance. Then
        nothing is written.

    Examples
    --------
    >>> import seamless
    >>> F, uv = seamless.examples.inexact_map()
    >>> seamless.measure(F, uv)["exact"]
    False
    >>> seamless.measure(F, seamless.snap(F, uv))["exact"]
    True
    """
    F, uv, V, features = surface_map(F, uv, V, features)
    if out is not None:
        _check_out(out, uv)
    result = make(
        _core.snap, F, uv, V, features, _checks.flag(align_border, "align_border"),
        _checks.number(tolerance, "tolerance", 0, 1, is_open=True),
        _checks.flag(repair_flips, "repair_flips"), _weld(weld, V), progress=progress, report=report)
    if out is None:
        return result
    out[...] = result[0] if report else result
    return (out, result[1]) if report else out


def measure(F, uv, *, V=None, features=None, align_border=False, weld=False):
    """Measure how far a parametrization is from being exactly seamless.

    Parameters
    ----------
    F, uv, V, features, align_border, weld
        as for `snap`

    Returns
    -------
    dict
        ``exact`` tells whether all seams and alignments hold exactly. Counts, which are exact:
        ``number_of_interior_edges``, ``number_of_mismatched_edges`` (with different coordinates on
        both sides), ``number_of_inexact_edges``, ``number_of_aligned_edges``,
        ``number_of_misaligned_edges``, ``number_of_flipped_faces``,
        ``number_of_degenerate_faces``. Lengths: ``extent``, the size of the coordinates; ``violation``,
        the widest gap at a seam; ``misalignment``, the largest change of a coordinate that should be
        constant. ``cones`` is as for `parametrize`, or None if the coordinates are not seamless at all.

    Raises
    ------
    Error
        if an argument is not as for `snap`

    Examples
    --------
    >>> import seamless
    >>> F, uv = seamless.examples.inexact_map()
    >>> seamless.measure(F, uv)["number_of_flipped_faces"]
    0
    """
    F, uv, V, features = surface_map(F, uv, V, features)
    return call(_core.measure, F, uv, V, features, _checks.flag(align_border, "align_border"),
                _weld(weld, V))


def quad_remesh(V, F=None, quads=None, *, edge_length=None, coarsest=False, maximum=None,
                features=None, feature_loss=0, field=None, sizes=None, curvature=None, adaptivity=1,
                border_tolerance=None, area_threshold=None, symmetry=None, weld=None, progress=None,
                report=False):
    """Remesh a triangle mesh with quads only.

    Parameters
    ----------
    V : array_like
        points, ``(n, 3)``; or a mesh with ``vertices`` and ``faces``, or ``points`` and ``cells``
    F : array_like, optional
        triangles, ``(m, 3)``: rows of `V`
    quads : int, optional
        about how many quads to make; 10,000 by default. More than 10,000,000 need `maximum`.
    edge_length : float, optional
        instead, how long to make their edges
    coarsest : bool
        instead, make as few quads as the search finds
    maximum : int, optional
        the largest number of quads; if features force more, this is an error. The default is a
        hundred times the number wanted, and at least 100,000.
    features : array_like, optional
        edges that the quads should follow, ``(k, 2)``: rows of `V`, in the form that `sharp_edges`
        returns. None by default.
    feature_loss : float
        the part of the length of the features that may be given up if they force quads, from 0 to 1
    field : array_like or path, optional
        a direction of the quads for each triangle, ``(m, 3)``, or a file that `read_field` reads. For a
        triangle with the direction (0, 0, 0), the function chooses the direction.
    sizes : array_like, optional
        how long to make the edges at each vertex, ``(n,)``. With `quads`, only their ratios count; with
        `edge_length`, they are multiples of it; otherwise, they are lengths.
    curvature : float, optional
        how strongly the quads follow the principal directions of curvature: 0.002 by default, less on
        large meshes, 0 if sizes vary; 0.1 and more follow them strongly, with more irregular vertices
    adaptivity : float
        make quads on flat parts larger than on curved parts, by at most this factor
    border_tolerance : float, optional
        ignore steps and zigzags of the border that are smaller than this; by default half an edge of
        the quads
    area_threshold : float, optional
        leave out closed parts with less area than this; the largest part always stays. By default, the
        area of a quad, and a hundredth of the largest part, if that is less; a warning tells of it.
        0 keeps all.
    symmetry : str or array_like, optional
        keep the half on the positive side of a plane, and mirror it: ``'x'`` for the plane x = 0,
        ``'y'``, ``'z'``; four numbers ``a, b, c, d`` for the plane ``a x + b y + c z + d = 0``; or
        ``'auto'`` to find a plane by which the vertices are symmetric
    weld : bool, optional
        as for `sharp_edges`
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    V : numpy.ndarray
        float64 ``(l, 3)``: the points
    Q : numpy.ndarray
        int64 ``(k, 4)``: the quads, each of four rows of the points
    report : dict, if `report` is True
        measurements such as ``number_of_inverted_quads``, ``number_of_folded_quads``, and
        ``mean_scaled_jacobian``; ``faces_of_vertices`` and ``weights_of_vertices``, the triangle and the
        barycentric coordinates of the place on the input that is nearest to each point;
        ``faces_of_quads``, the same triangle for the middle of each quad; and ``feature_edges``, pairs
        of points

    Raises
    ------
    Error
        if an argument is not as above, the triangles are no oriented surface, or no quads are found

    Examples
    --------
    >>> import seamless
    >>> V, F = seamless.examples.torus()
    >>> V2, Q = seamless.quad_remesh(V, F, quads=500)
    >>> Q.shape[1]
    4
    """
    V, F = surface(V, F)
    if sum([quads is not None, edge_length is not None, coarsest is True]) > 1:
        raise Error("quads, edge_length, and coarsest exclude each other", "pass one of them")
    if sizes is not None:
        sizes = _checks.positive(sizes, "sizes", len(V), "a length for each row of V")
        if quads is None and edge_length is None and coarsest is not True:
            edge_length = 1
    number = _checks.count(10000 if quads is None else quads, "quads")
    if number > _MOST_QUADS and maximum is None:
        raise Error(f"quads is {number}, but so many are mostly a mistake, and take long",
                    "pass maximum, too")
    plane, finds_plane = _plane(symmetry)
    wishes = _core.Wishes(
        number_of_quads=number,
        edge_length=_checks.optional(_checks.number, edge_length, "edge_length", 0, is_open=True),
        coarsest=_checks.flag(coarsest, "coarsest"),
        maximum_number=_checks.optional(_checks.count, maximum, "maximum"),
        feature_loss=_checks.number(feature_loss, "feature_loss", 0, 1),
        curvature=_checks.optional(_checks.number, curvature, "curvature", 0),
        border_tolerance=_checks.optional(_checks.number, border_tolerance, "border_tolerance", 0),
        area_threshold=_checks.optional(_checks.number, area_threshold, "area_threshold", 0),
        adaptivity=_checks.number(adaptivity, "adaptivity", 1), plane=plane, finds_plane=finds_plane)
    return make(
        _core.quad_remesh, V, F, _checks.features(features, "features", len(V)),
        directions(field, len(F)), sizes, wishes, _checks.optional(_checks.flag, weld, "weld"),
        progress=progress, report=report)


def _weld(weld, V):
    if _checks.flag(weld, "weld") and V is None:
        raise Error("weld=True joins border edges between the same points", "pass V, too")
    return bool(weld)


def _check_out(out, uv):
    if not (isinstance(out, np.ndarray) and out.dtype == np.float64 and out.shape == uv.shape
            and out.flags.writeable):
        raise Error(f"out must be a float64 array of the shape {uv.shape} that can be written",
                    "make it by numpy.empty()")


def _plane(symmetry):
    """The four numbers of a plane, or None, and whether it is to be found."""
    if symmetry is None:
        return None, False
    if isinstance(symmetry, str):
        if symmetry == "auto":
            return None, True
        if symmetry not in ("x", "y", "z"):
            raise Error(f"symmetry is {symmetry!r}, but must be 'x', 'y', 'z', 'auto', or four numbers")
        return [float(symmetry == axis) for axis in "xyz"] + [0.], False
    plane = _checks.doubles(symmetry, "symmetry", (4,), "a, b, c, d of the plane a x + b y + c z + d = 0")
    if not plane[:3].any():
        raise Error("symmetry is no plane", "one of its first three numbers must not be 0")
    return plane.tolist(), False
