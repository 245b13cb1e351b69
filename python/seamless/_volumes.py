"""Functions on tetrahedral meshes, and on systems of linear equations."""

import fractions
import numbers

import numpy as np

from . import _checks, _core
from ._errors import Error, checked
from ._surfaces import _call


def _volume(T, uvw, feature_facets, feature_edges):
    T = _checks.indices(T, "T", 4, rows="four vertices for each tetrahedron")
    order = np.sort(T, axis=1)
    twice = (order[:, 1:] == order[:, :-1]).any(axis=1)
    if twice.any():
        raise Error(f"row {int(np.argmax(twice))} of T has a vertex twice; remove the tetrahedron")
    uvw = _checks.doubles(uvw, "uvw", (len(T), 4, 3),
                          "three coordinates for each corner of each tetrahedron")
    return T, uvw, _features(feature_facets, "feature_facets", 3), \
        _features(feature_edges, "feature_edges", 2)


def _features(value, name, size):
    if value is None:
        return None
    value = _checks.indices(value, name, size, rows=f"{size} vertices for each", may_be_empty=True)
    return value if len(value) > 0 else None


def snap_volume(T, uvw, *, feature_facets=None, feature_edges=None, align_boundary=True,
                tolerance=1e-4, repair_flips=False, integer_grid=False, grid_scale=1, rounding=0.01,
                progress=None, report=False):
    """Make the parametrization of a tetrahedral mesh exactly seamless.

    Afterwards the coordinates on the two sides of each facet differ by one of the 24 rotations of the
    cube and a translation, exactly, in the numbers that are returned.

    Parameters
    ----------
    T : array_like
        tetrahedra, ``(m, 4)``: numbers of vertices, from 0
    uvw : array_like
        coordinates of the corners, ``(m, 4, 3)``
    feature_facets : array_like, optional
        facets on which a coordinate is to be constant, ``(k, 3)``
    feature_edges : array_like, optional
        edges along which two coordinates are to be constant, ``(k, 2)``
    align_boundary : bool
        whether a coordinate is to be constant on each facet of the boundary
    tolerance : float
        the largest violation that counts as inaccuracy, relative to the extent of the coordinates
    repair_flips : bool
        whether to repair tetrahedra that are flipped
    integer_grid : bool
        whether to make an integer-grid map, of which programs extract hexahedra
    grid_scale : float
        a factor for the coordinates
    rounding : float
        with `integer_grid`: how far from integers translations and levels may be that are rounded to
        them
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    uvw : numpy.ndarray
        float64 ``(m, 4, 3)``
    report : dict, if `report` is True
        among others ``largest_change`` and ``lost_cells``

    Raises
    ------
    Error
        if an argument is not as above, or the coordinates are not seamless up to the tolerance

    Examples
    --------
    >>> import seamless
    >>> T, uvw = seamless.examples.inexact_volume()
    >>> seamless.measure_volume(T, uvw)["exact"]
    False
    >>> seamless.measure_volume(T, seamless.snap_volume(T, uvw))["exact"]
    True
    """
    T, uvw, facets, edges = _volume(T, uvw, feature_facets, feature_edges)
    result, figures = _call(
        _core.snap_volume, T, uvw, facets, edges, _checks.flag(align_boundary, "align_boundary"),
        _checks.number(tolerance, "tolerance", 0, 1, is_open=True),
        _checks.flag(repair_flips, "repair_flips"), _checks.flag(integer_grid, "integer_grid"),
        _checks.number(grid_scale, "grid_scale", 0, is_open=True),
        _checks.number(rounding, "rounding", 0), _checks.progress(progress))
    figures = checked(figures)
    return (result, figures) if _checks.flag(report, "report") else result


def measure_volume(T, uvw, *, feature_facets=None, feature_edges=None, align_boundary=True):
    """Measure how far the parametrization of a tetrahedral mesh is from being exactly seamless.

    Parameters
    ----------
    T, uvw, feature_facets, feature_edges, align_boundary
        as for `snap_volume`

    Returns
    -------
    dict
        ``exact`` tells whether all seams and alignments hold exactly, ``integer_grid`` whether this is
        an integer-grid map; counts and lengths

    Raises
    ------
    Error
        if an argument is not as for `snap_volume`

    Examples
    --------
    >>> import seamless
    >>> T, uvw = seamless.examples.inexact_volume()
    >>> seamless.measure_volume(T, uvw)["number_of_flipped_cells"]
    0
    """
    T, uvw, facets, edges = _volume(T, uvw, feature_facets, feature_edges)
    return _call(_core.measure_volume, T, uvw, facets, edges,
                 _checks.flag(align_boundary, "align_boundary"))


def snap_linear(A, b, x, *, weights=None, progress=None, report=False):
    """Move numbers to numbers near by that solve a sparse system of linear equations exactly.

    Parameters
    ----------
    A : scipy.sparse matrix or array_like
        the coefficients, ``(m, n)``: integers, floats, or, as an array of objects, `int` and
        `fractions.Fraction` of any size. A float is the rational number that it is.
    b : array_like
        the right-hand sides, ``(m,)``: numbers of these kinds
    x : array_like
        the numbers to move, ``(n,)``
    weights : array_like, optional
        positive numbers, ``(n,)``; large ones hold their numbers still
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    x : numpy.ndarray
        float64 ``(n,)``: ``A x = b`` holds exactly
    report : dict, if `report` is True
        among others ``largest_change`` and ``distance_ratio``

    Raises
    ------
    Error
        if an argument is not as above; if there is no solution, in which case
        ``report['contradicting_rows']`` of the error are equations that contradict each other; or if
        none is found near by

    Examples
    --------
    >>> import seamless
    >>> A = [[1, -1, 0], [0, 3, 1]]
    >>> seamless.snap_linear(A, [0, 5], [0.1, 0.10000001, 4.7])
    array([0.1, 0.1, 4.7])
    """
    x = _checks.doubles(x, "x", (None,), "one number for each column of A")
    begins, columns, values = _rows(A, len(x))
    m = len(begins) - 1
    sides = _numbers(b, "b")
    if len(sides) != m:
        raise Error(f"b has {len(sides)} numbers, but A has {m} rows; pass one number for each row")
    weights = np.ones(len(x)) if weights is None else \
        _checks.doubles(weights, "weights", (len(x),), "one number for each of x")
    if (weights <= 0).any():
        raise Error(f"row {int(np.argmax(weights <= 0))} of weights is not positive")
    is_integer = isinstance(values, np.ndarray)
    result, figures = _call(
        _core.snap_linear_integers if is_integer else _core.snap_linear_rationals, begins, columns,
        values, sides, x, weights, _checks.progress(progress))
    figures = checked(figures)
    return (result, figures) if _checks.flag(report, "report") else result


def _rows(A, n):
    """The rows of a matrix: where they begin, columns, and coefficients, as int64 or as words."""
    if hasattr(A, "tocsr"):
        A = A.tocsr()
        shape, begins, columns, values = A.shape, A.indptr, A.indices, A.data
    else:
        try:
            A = np.asarray(A)
        except ValueError as error:
            raise Error(f"A is no matrix: {error}") from None
        if A.ndim != 2 or A.dtype.kind not in "biufO":
            raise Error(f"A has the shape {A.shape} and the type {A.dtype}; pass rows of numbers")
        shape = A.shape
        rows, columns = np.nonzero(A)
        values = A[rows, columns]
        begins = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=shape[0]))])
    if shape[1] != n:
        raise Error(f"A has {shape[1]} columns, but x has {n} numbers; pass one number for each column")
    if shape[0] == 0:
        raise Error("A is empty; pass at least one row")
    columns = np.ascontiguousarray(columns, dtype=np.int64)
    begins = np.ascontiguousarray(begins, dtype=np.int64)
    if len(columns) > 0 and (columns.min() < 0 or columns.max() >= n):
        raise Error("A has an index of a column out of range; build it anew")
    if values.dtype.kind in "bi" or (values.dtype.kind == "u" and values.dtype.itemsize < 8):
        return begins, columns, np.ascontiguousarray(values, dtype=np.int64)
    return begins, columns, _numbers(values, "A", begins)


def _numbers(values, name, begins=None):
    """Integers and fractions in decimal digits, exactly."""
    try:
        values = np.asarray(values)
    except ValueError as error:
        raise Error(f"{name} is no array of numbers: {error}") from None
    if values.ndim != 1 or values.dtype.kind not in "biufO":
        raise Error(f"{name} has the shape {values.shape} and the type {values.dtype}; pass a row of "
                    "numbers")
    result = []
    for i, value in enumerate(values.tolist()):
        row = i if begins is None else int(np.searchsorted(begins, i, side="right")) - 1
        if not isinstance(value, numbers.Real):
            raise Error(f"row {row} of {name} has {value!r}, which is no integer, fraction, or float")
        try:
            result.append(str(fractions.Fraction(value)))
        except (ValueError, OverflowError, TypeError):
            raise Error(f"row {row} of {name} is not finite: it has {value!r}", "not finite") from None
    return result
