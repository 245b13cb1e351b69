"""Systems of linear equations."""

import fractions
import numbers

import numpy as np

from . import _checks, _core
from ._calls import make
from ._errors import Error


def snap_linear(A, b, x, *, weights=None, progress=None, report=False):
    """Move numbers to nearby numbers that solve a sparse system of linear equations exactly.

    Parameters
    ----------
    A : scipy.sparse matrix or array_like
        the coefficients, ``(m, n)``: integers, floats, or, as an array of objects, `int` and
        `fractions.Fraction` of any size. A float stands for its exact binary value: 0.1 is not
        ``Fraction(1, 10)``.
    b : array_like
        the right-hand sides, ``(m,)``: numbers of these kinds
    x : array_like
        the numbers to move, ``(n,)``
    weights : array_like, optional
        positive numbers, ``(n,)``; numbers with a large weight move less
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    x : numpy.ndarray
        float64 ``(n,)``: ``A x = b`` holds exactly
    report : dict, if `report` is True
        among others ``largest_change``, and ``distance_ratio``: how many times farther the numbers have
        moved than a solution in real numbers would have to

    Raises
    ------
    Error
        if an argument is not as above; if there is no solution, in which case
        ``report['contradicting_rows']`` of the error are equations that contradict each other; or if
        the search finds none nearby

    Examples
    --------
    >>> import seamless
    >>> from fractions import Fraction
    >>> 3 * Fraction(0.1) + Fraction(4.7) == 5
    False
    >>> x = seamless.snap_linear([[1, -1, 0], [0, 3, 1]], [0, 5], [0.1, 0.1, 4.7])
    >>> bool(x[0] == x[1]) and 3 * Fraction(x[1]) + Fraction(x[2]) == 5
    True
    """
    x = _checks.doubles(x, "x", (None,), "one number for each column of A")
    begins, columns, values = _rows(A, len(x))
    m = len(begins) - 1
    sides = _numbers(b, "b")
    if len(sides) != m:
        raise Error(f"b has {len(sides)} numbers, but A has {m} rows", "pass one number for each row")
    weights = np.ones(len(x)) if weights is None else \
        _checks.positive(weights, "weights", len(x), "one number for each of x")
    is_integer = isinstance(values, np.ndarray)
    return make(_core.snap_linear_integers if is_integer else _core.snap_linear_rationals, begins,
                columns, values, sides, x, weights, progress=progress, report=report)


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
            raise Error(f"A has the shape {A.shape} and the type {A.dtype.name}", "pass rows of numbers")
        shape = A.shape
        rows, columns = np.nonzero(A)
        values = A[rows, columns]
        begins = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=shape[0]))])
    if shape[1] != n:
        raise Error(f"A has {shape[1]} columns, but x has {n} numbers",
                    "pass one number for each column")
    if shape[0] == 0:
        raise Error("A is empty", "pass at least one row")
    columns = np.ascontiguousarray(columns, dtype=np.int64)
    begins = np.ascontiguousarray(begins, dtype=np.int64)
    if len(columns) > 0 and (columns.min() < 0 or columns.max() >= n):
        raise Error("A has an index of a column out of range", "build it anew")
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
        raise Error(f"{name} has the shape {values.shape} and the type {values.dtype.name}",
                    "pass a row of numbers")
    result = []
    for i, value in enumerate(values.tolist()):
        row = i if begins is None else int(np.searchsorted(begins, i, side="right")) - 1
        place = f"row {row} of {name}"
        if not isinstance(value, numbers.Real):
            raise Error(f"{place} has {value!r}, which is no integer, fraction, or float", place=place)
        try:
            result.append(str(fractions.Fraction(value)))
        except (ValueError, OverflowError, TypeError):
            raise Error(f"{place} is not finite: it has {value!r}", place=place,
                        status="not finite") from None
    return result
