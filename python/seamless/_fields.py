"""Directions for the faces of a mesh: arrays, and the files of other programs."""

import os

import numpy as np

from . import _checks
from ._errors import Error


def read_field(path):
    """Read a direction for each face from a file of another program.

    Parameters
    ----------
    path : str or os.PathLike
        A file whose suffix tells its format:

        ========== ==================================================================================
        .rosy      the number of faces, 4, and three coordinates for each face, as NeurCross and
                   programs built on VCGLib write them
        .rawfield  4, the number of faces, and three coordinates of four directions for each face, as
                   Directional writes them; the first direction is taken
        .dmat      a matrix with three or twelve columns and a row for each face, as libigl writes it
        .txt       three or twelve numbers on a line for each face
        ========== ==================================================================================

    Returns
    -------
    numpy.ndarray
        float64 ``(m, 3)``: a direction for each face

    Raises
    ------
    Error
        if the file is none of these
    OSError
        if it can't be read

    Examples
    --------
    >>> import seamless, tempfile, os
    >>> path = os.path.join(tempfile.mkdtemp(), "field.rosy")
    >>> with open(path, "w") as file:
    ...     _ = file.write("2 4  1 0 0  0 1 0")
    >>> seamless.read_field(path)
    array([[1., 0., 0.],
           [0., 1., 0.]])
    """
    path = os.fspath(path)
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in (".rosy", ".rawfield", ".dmat", ".txt"):
        raise Error(f"{path}: directions are read from .rosy, .rawfield, .dmat, and .txt files",
                    "convert others to an array")
    with open(path, encoding="utf-8", errors="replace") as file:
        words = file.read().split()
    try:
        values = np.array(words, dtype=np.float64)
    except ValueError:
        raise Error(f"{path}: a .{suffix[1:]} file holds numbers only, but this one has other words") \
            from None
    return _directions(values, suffix, path)


def _directions(values, suffix, path):
    if suffix == ".rosy":
        _check_head(values, path, "the number of faces, and 4", is_degree=1, columns=3)
        table = values[2:].reshape(-1, 3)
    elif suffix == ".rawfield":
        _check_head(values, path, "4, and the number of faces", is_degree=0, columns=12)
        table = values[2:].reshape(-1, 12)
    elif suffix == ".dmat":
        if len(values) < 2 or values[0] * values[1] != len(values) - 2 or values[0] not in (3, 12):
            raise Error(f"{path}: a .dmat file of directions begins with 3 or 12, the number of "
                        "columns, and the number of rows, and has as many numbers")
        table = values[2:].reshape(int(values[0]), -1).T  # column by column
    else:
        with open(path, encoding="utf-8") as file:
            columns = len(file.readline().split())
        if columns not in (3, 12) or len(values) % columns != 0:
            raise Error(f"{path}: a .txt file of directions has 3 or 12 numbers on each line")
        table = values.reshape(-1, columns)
    return np.ascontiguousarray(table[:, :3])


def _check_head(values, path, head, is_degree, columns):
    if len(values) < 2 or values[is_degree] != 4 or \
            columns * values[1 - is_degree] != len(values) - 2:
        raise Error(f"{path}: such a file begins with {head}, and {columns} numbers for each face follow")


def directions(field, number_of_faces):
    """Return float64 directions of faces, or None."""
    if field is None:
        return None
    if isinstance(field, (str, os.PathLike)):
        path, field = os.fspath(field), read_field(field)
        if len(field) != number_of_faces:
            raise Error(f"{path} has directions for {len(field)} faces, but the mesh has "
                        f"{number_of_faces}", "take the file of this mesh")
        return _checks.doubles(field, path, (None, 3), "a direction for each face")
    array = _checks._array(field, "field")
    if array.ndim >= 2 and array.shape in ((number_of_faces, 12), (number_of_faces, 4, 3)):
        array = array.reshape(number_of_faces, -1)[:, :3]  # the first of four directions
    return _checks.doubles(array, "field", (number_of_faces, 3), "a direction for each face")
