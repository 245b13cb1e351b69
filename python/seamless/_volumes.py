"""Functions on tetrahedral meshes."""

from . import _checks, _core
from ._calls import call, make
from ._meshes import volume_map


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
        the largest gap at a facet that counts as rounding error, relative to the extent of the
        coordinates
    repair_flips : bool
        whether to repair tetrahedra that are flipped
    integer_grid : bool
        whether to make an integer-grid map, of which programs extract hexahedra
    grid_scale : float
        a factor for the coordinates
    rounding : float
        with `integer_grid`: the largest distance to the next whole number at which translations, and
        coordinates that are constant on facets or along edges, are rounded
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    uvw : numpy.ndarray
        float64 ``(m, 4, 3)``
    report : dict, if `report` is True
        among others ``largest_change``, and ``lost_cells``: tetrahedra that became flipped

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
    return make(
        _core.snap_volume, *volume_map(T, uvw, feature_facets, feature_edges),
        _checks.flag(align_boundary, "align_boundary"),
        _checks.number(tolerance, "tolerance", 0, 1, is_open=True),
        _checks.flag(repair_flips, "repair_flips"), _checks.flag(integer_grid, "integer_grid"),
        _checks.number(grid_scale, "grid_scale", 0, is_open=True),
        _checks.number(rounding, "rounding", 0), progress=progress, report=report)


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
        an integer-grid map. Counts, which are exact: ``number_of_interior_facets``,
        ``number_of_mismatched_facets`` (with different coordinates on both sides),
        ``number_of_inexact_facets``, ``number_of_aligned_facets``, ``number_of_aligned_edges``,
        ``number_of_misalignments``, ``number_of_flipped_cells``, ``number_of_degenerate_cells``.
        Lengths: ``extent``, the size of the coordinates; ``violation``, the widest gap at a facet;
        ``misalignment``, the largest change of a coordinate that should be constant.

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
    return call(_core.measure_volume, *volume_map(T, uvw, feature_facets, feature_edges),
                _checks.flag(align_boundary, "align_boundary"))


def hexahedra(V, T, uvw, hexahedra=None, *, maximum=None, feature_facets=None, feature_edges=None,
              tolerance=1e-4, moving_rounds=20, progress=None, report=False):
    """Make a mesh of hexahedra from a tetrahedral mesh with a seamless parametrization.

    The coordinates come from another program, such as AlgoHex. They become an exact integer-grid map: the
    cubes of its grid are the hexahedra. Then vertices move to mend hexahedra that are inverted. The
    hexahedra fill the body and meet face to face.

    Parameters
    ----------
    V : array_like
        points, ``(n, 3)``
    T : array_like
        tetrahedra, ``(m, 4)``: rows of `V`
    uvw : array_like
        coordinates of the corners, ``(m, 4, 3)``, seamless up to `tolerance`
    hexahedra : int, optional
        about how many hexahedra to make, or more if cells collapse. By default, the
        coordinates are not scaled, and must be near whole numbers.
    maximum : int, optional
        the number of hexahedra above which to give up; 64 times `hexahedra` by default
    feature_facets : array_like, optional
        facets on which a coordinate is to be an integer, ``(k, 3)``
    feature_edges : array_like, optional
        edges along which two coordinates are to be integers, ``(k, 2)``
    tolerance : float
        the largest gap at a facet that counts as rounding error, relative to the extent of the
        coordinates
    moving_rounds : int
        the largest number of rounds in which vertices move; 0 leaves all vertices in their places
    progress : callable, optional
        as for `parametrize`
    report : bool
        whether to return a report, too

    Returns
    -------
    V : numpy.ndarray
        float64 ``(l, 3)``: the points
    H : numpy.ndarray
        int64 ``(k, 8)``: the hexahedra, each of eight rows of the points: 0, 1, 2, 3 around the bottom, and
        4, 5, 6, 7 above them, counterclockwise as seen from above. This is the order of VTK and meshio.
    report : dict, if `report` is True
        the measurements of `measure_hexahedra`; ``irregular_edges``, counts of interior edges by the number
        of hexahedra around them, if that is not four; ``quadrilaterals`` on the boundary and on
        feature facets, ``(q, 4)``, with the numbers of their ``patches``, from 1, and the rows of
        ``feature_facets``, or -1; ``edges`` on feature edges and between patches, ``(e, 2)``, with the
        numbers of their ``curves``, from 1, and the rows of ``feature_edges``, or -1

    Raises
    ------
    Error
        if an argument is not as above, the coordinates are not seamless, or no integers are found

    Examples
    --------
    >>> import seamless
    >>> V, T, uvw = seamless.examples.volume()
    >>> V2, H = seamless.hexahedra(V, T, uvw)
    >>> H.shape
    (8, 8)
    """
    V = _checks.points(V)
    return make(
        _core.hexahedra, V, *volume_map(T, uvw, feature_facets, feature_edges, len(V)),
        0 if hexahedra is None else _checks.count(hexahedra, "hexahedra"),
        _checks.optional(_checks.count, maximum, "maximum"),
        _checks.number(tolerance, "tolerance", 0, 1, is_open=True),
        _checks.count(moving_rounds, "moving_rounds", 0, 10**6), progress=progress, report=report)


def measure_hexahedra(V, H):
    """Measure the shapes of hexahedra, of this module or of another program.

    Parameters
    ----------
    V : array_like
        points, ``(n, 3)``
    H : array_like
        hexahedra, ``(k, 8)``: rows of `V`, in the order of `hexahedra`

    Returns
    -------
    dict
        ``least_scaled_jacobian`` and ``mean_scaled_jacobian``, which are 1 for cubes;
        ``number_by_tenths``, counts of hexahedra by their scaled Jacobian; and
        ``nonpositive_hexahedra``, the rows of hexahedra with a corner that is flat or turned inside
        out, which is decided exactly

    Raises
    ------
    Error
        if an argument is not as above

    Examples
    --------
    >>> import seamless
    >>> V, _ = seamless.examples.box()
    >>> seamless.measure_hexahedra(V, [[0, 4, 6, 2, 1, 5, 7, 3]])["mean_scaled_jacobian"]
    1.0
    """
    V = _checks.points(V)
    return call(_core.measure_hexahedra, V, _checks.cells(H, "H", len(V), 8))
