"""Quads of parametrizations."""

from . import _checks, _core
from ._errors import Error, checked
from ._surfaces import _call, _map


def extract_quads(V, F, uv, quads=None, *, grid_scale=1, rounding=None, features=None,
                  align_border=False, repair_flips=False, allow_holes=False, weld=False,
                  progress=None, report=False):
    """Extract the quads of a parametrization: the cells of its integer grid.

    Without a number of quads, the coordinates become an exact integer-grid map first, which they must
    be nearly. With a number of quads, the coordinates need only be seamless: integers that are near are
    taken if they make about as many quads, else a quantization finds some.

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
        how far from integers translations, cones, and aligned edges may be that are rounded to them:
        0.01 by default, and with `quads` 0.5, or any distance if nothing else helps
    features : array_like, optional
        edges that the quads keep, ``(k, 2)``
    align_border : bool
        whether border edges that are nearly on isocurves become edges of quads
    repair_flips : bool
        whether to repair triangles that are flipped in the plane
    allow_holes : bool
        whether to leave out the quads around triangles that are still flipped, instead of refusing
    weld : bool
        whether to join border edges in the same place, as of a mesh that is cut open along its seams
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
        among others ``integers``, which were taken; ``number_of_inverted_quads``;
        ``other_polygons``, lists of points of faces that are no quads, around cones between the lines
        of the grid; and ``number_of_cut_cells``, pieces of cells at the border, which are left out

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
    F, uv, V, features = _map(F, uv, V, features, needs_points=True)
    if quads is not None and grid_scale != 1:
        raise Error("quads and grid_scale exclude each other; pass one of them")
    points, polygons, figures = _call(
        _core.extract_quads, V, F, uv, features, 0 if quads is None else _checks.count(quads, "quads"),
        _checks.number(grid_scale, "grid_scale", 0, is_open=True),
        None if rounding is None else _checks.number(rounding, "rounding", 0),
        _checks.flag(align_border, "align_border"), _checks.flag(repair_flips, "repair_flips"),
        _checks.flag(allow_holes, "allow_holes"), _checks.flag(weld, "weld"),
        _checks.progress(progress))
    figures = checked(figures)
    return (points, polygons, figures) if _checks.flag(report, "report") else (points, polygons)
