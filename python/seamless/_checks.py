"""Checks and conversions of arguments: what passes goes to the compiled part as it is."""

import numbers
import operator

import numpy as np

from ._errors import Error

_LARGEST_INDEX = 2**31 - 2


def _array(value, name):
    try:
        result = np.asarray(value)
    except Exception as error:  # whatever an object does that is asked for an array
        raise Error(f"{name} is no array: {error}", "pass a NumPy array or nested lists") from error
    if result.dtype.kind not in "biufO":
        raise Error(f"{name} has the type {result.dtype.name}", "pass numbers")
    if result.dtype.kind == "O":
        raise Error(f"{name} is no array of numbers: rows may differ in length",
                    "pass a NumPy array of numbers")
    return result


def _check_shape(array, name, shape, rows):
    """`shape` has None for any size; `rows` says what the rows are."""
    sizes = ", ".join("n" if s is None else str(s) for s in shape)
    wanted = f"({sizes},)" if len(shape) == 1 else f"({sizes})"
    if array.ndim != len(shape) or any(s is not None and s != size
                                       for s, size in zip(shape, array.shape)):
        raise Error(f"{name} has the shape {array.shape}, but its shape must be {wanted}: {rows}")


def _row(name, bad):
    """The first row of an array in which something is bad, in words."""
    flat = bad.reshape(len(bad), -1).any(axis=1)
    return f"row {int(np.argmax(flat))} of {name}"


def doubles(value, name, shape, rows, may_be_empty=False):
    """Return finite float64 numbers of a shape."""
    array = _array(value, name)
    if array.dtype.kind == "b":
        raise Error(f"{name} has the type {array.dtype.name}", "pass numbers")
    _check_shape(array, name, shape, rows)
    if array.shape[0] == 0 and not may_be_empty:
        raise Error(f"{name} is empty", "pass at least one row")
    with np.errstate(over="ignore"):
        array = np.ascontiguousarray(array, dtype=np.float64)
    finite = np.isfinite(array)
    if not finite.all():
        row = _row(name, ~finite)
        raise Error(f"{row} is not finite: it has a NaN, or an infinite number", place=row,
                    status="not finite")
    return array


def indices(value, name, columns, size=None, of="V", rows="", may_be_empty=False):
    """Return int64 indices; `size` is the number of rows of what they are indices of."""
    array = _array(value, name)
    if array.size == 0 and may_be_empty:
        return np.empty((0, columns), dtype=np.int64)
    if array.dtype.kind not in "iu":
        raise Error(f"{name} has the type {array.dtype.name}", "pass integers")
    _check_shape(array, name, (None, columns), rows)
    if array.shape[0] == 0:
        raise Error(f"{name} is empty", "pass at least one row")
    most = _LARGEST_INDEX if size is None else min(size - 1, _LARGEST_INDEX)
    if array.min() < 0 or array.max() > most:
        bad = (array < 0) | (array > most)
        row = _row(name, bad)
        index = array[bad][0]
        limit = f"{of} has {size} rows" if size is not None else "indices are less than 2^31 - 1"
        raise Error(f"{row} has the index {index}, but {limit}", "count indices from 0", row)
    return np.ascontiguousarray(array, dtype=np.int64)


def cells(value, name, size=None, corners=3):
    """Return int64 triangles or tetrahedra, none of which has a vertex twice."""
    kind, words = {3: ("triangle", "three"), 4: ("tetrahedron", "four"),
                   8: ("hexahedron", "eight")}[corners]
    array = _array(value, name)
    if corners == 3 and array.ndim == 2 and array.shape[1] == 4:
        raise Error(f"{name} has the shape {array.shape}, but its shape must be (n, 3): three vertices "
                    "for each triangle", "triangulate quads first")
    result = indices(array, name, corners, size, rows=f"{words} vertices for each {kind}")
    twice = np.zeros(len(result), dtype=bool)
    for i in range(1, corners):  # a vertex and the one i places later
        for j in range(corners - i):
            twice |= result[:, j] == result[:, j + i]
    if twice.any():
        row = _row(name, twice)
        raise Error(f"{row} has a vertex twice", f"remove the {kind}", row)
    return result


def features(value, name, size=None, corners=2):
    """Return int64 edges or facets, or None."""
    if value is None:
        return None
    rows = "two vertices for each edge" if corners == 2 else "three vertices for each facet"
    value = indices(value, name, corners, size, rows=rows, may_be_empty=True)
    return value if len(value) > 0 else None


def points(value, name="V"):
    """Return float64 points."""
    return doubles(value, name, (None, 3), "three coordinates for each point")


def positive(value, name, size, rows):
    """Return positive float64 numbers."""
    array = doubles(value, name, (size,), rows)
    bad = array <= 0
    if bad.any():
        row = _row(name, bad)
        raise Error(f"{row} is {array[bad][0]}, but must be positive", place=row)
    return array


def optional(check, value, name, *bounds, **options):
    """Return None, or what the check returns."""
    return None if value is None else check(value, name, *bounds, **options)


def number(value, name, least=None, most=None, is_open=False):
    """Return a finite float; at least `least`, or more than that if `is_open`."""
    if isinstance(value, bool) or not isinstance(value, (numbers.Real, np.generic)):
        raise Error(f"{name} must be a number, not {value!r}")
    try:
        result = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise Error(f"{name} must be a number, not {value!r}") from error
    if not np.isfinite(result):
        raise Error(f"{name} must be finite, not {value!r}", status="not finite")
    if least is not None and (result < least or (is_open and result == least)):
        raise Error(f"{name} is {value!r}, but must be {'more than' if is_open else 'at least'} "
                    f"{least}")
    if most is not None and result > most:
        raise Error(f"{name} is {value!r}, but must be at most {most}")
    return result


def count(value, name, least=1, most=2**28):
    """Return an int; whole floats, as of a computation, are taken, too."""
    if isinstance(value, (float, np.floating)) and float(value).is_integer():
        value = int(value)
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        result = operator.index(value)
    except TypeError:
        raise Error(f"{name} must be an integer, not {value!r}") from None
    if not least <= result <= most:
        raise Error(f"{name} is {result}, but must be from {least} to {most}")
    return result


def flag(value, name):
    """Return a bool."""
    if not isinstance(value, (bool, np.bool_)):
        raise Error(f"{name} must be True or False, not {value!r}")
    return bool(value)


def progress(value):
    """Return a callable, or None."""
    if value is not None and not callable(value):
        raise Error(f"progress must be a function that takes a line, not {value!r}")
    return value
