"""Volumes and linear systems, checked in rational numbers."""

import itertools
from fractions import Fraction

import numpy as np
import pytest
import scipy.sparse

import seamless

T, UVW = seamless.examples.inexact_volume(3)


def rotations():
    """The 24 rotations of the cube, as signed permutations."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            matrix = np.zeros((3, 3), int)
            matrix[range(3), order] = signs
            if round(np.linalg.det(matrix)) == 1:
                yield order, signs


def is_exact(uvw):
    """By the definition: all facets, and a constant coordinate on each of the boundary."""
    facets = {}
    for c, cell in enumerate(T.tolist()):
        for omitted in range(4):
            corners = sorted((cell[k], k) for k in range(4) if k != omitted)
            values = [[Fraction(float(x)) for x in uvw[c, k]] for _, k in corners]
            facets.setdefault(tuple(v for v, _ in corners), []).append(values)
    all_rotations = list(rotations())
    for sides in facets.values():
        changes = [[[p[i] - s[0][i] for i in range(3)] for p in s[1:]] for s in sides]
        if len(sides) == 1:
            if not any(all(change[i] == 0 for change in changes[0]) for i in range(3)):
                return False
        elif not any(all([sign * a[axis] for axis, sign in zip(order, signs)] == b
                         for a, b in zip(*changes)) for order, signs in all_rotations):
            return False
    return True


def test_snapping_is_exact():
    rng = np.random.default_rng(2)
    turned = UVW.copy()
    for c in range(len(T)):  # charts of their own
        order, signs = list(rotations())[rng.integers(24)]
        turned[c] = turned[c][:, list(order)] * signs + rng.random(3)
    for uvw in (UVW, turned):
        assert not is_exact(uvw) and not seamless.measure_volume(T, uvw)["exact"]
        result, report = seamless.snap_volume(T, uvw, report=True)
        assert is_exact(result) and seamless.measure_volume(T, result)["exact"]
        assert np.abs(result - uvw).max() == report["largest_change"]
        assert report["lost_cells"] == []


def test_integer_grid():
    """The facets of the boundary come to integers, and vertices inside stay where they are."""
    assert not seamless.measure_volume(T, UVW)["integer_grid"]
    for scale in (1, 2):
        uvw = seamless.snap_volume(T, UVW, integer_grid=True, grid_scale=scale)
        assert seamless.measure_volume(T, uvw)["integer_grid"]
        assert np.abs(uvw - scale * np.round(UVW)).max() < 1e-7
        outside = (np.round(UVW) == 0) | (np.round(UVW) == 3)
        assert (uvw[outside] == scale * np.round(UVW)[outside]).all()


def test_features():
    facet, edge = T[0, :3], T[0, :2]
    uvw = seamless.snap_volume(T, UVW, feature_facets=[facet], feature_edges=[edge])
    measured = seamless.measure_volume(T, uvw, feature_facets=[facet], feature_edges=[edge])
    assert measured["exact"] and measured["number_of_aligned_edges"] == 1


@pytest.mark.parametrize("call, words", [
    (lambda: seamless.snap_volume(T[:, :3], UVW), "T has the shape"),
    (lambda: seamless.snap_volume(T, UVW[:-1]), "uvw has the shape"),
    (lambda: seamless.snap_volume(np.where(T == T[3, 1], T[3, 0], T), UVW), "of T has a vertex twice"),
    (lambda: seamless.snap_volume(-T - 1, UVW), "row 0 of T has the index"),
    (lambda: seamless.snap_volume(np.concatenate([T, T[:1]]), np.concatenate([UVW, UVW[:1]])),
     "not manifold"),
    (lambda: seamless.snap_volume(T, UVW, feature_edges=[[0, 63]]),
     "row 0 of feature_edges has the vertices 0, 63, but no tetrahedron has an edge of these"),
    (lambda: seamless.snap_volume(T, UVW * np.nan), "row 0 of uvw is not finite"),
    (lambda: seamless.snap_volume(T, UVW, rounding=-1), "rounding is -1"),
    (lambda: seamless.hexahedra(np.zeros((64, 2)), T, UVW), "V has the shape"),
    (lambda: seamless.hexahedra(np.zeros((63, 3)), T, UVW), "of T has the index 63, but V has 63 rows"),
    (lambda: seamless.hexahedra(np.full((64, 3), np.nan), T, UVW), "row 0 of V is not finite"),
    (lambda: seamless.hexahedra(np.zeros((64, 3)), T, UVW, 0), "hexahedra is 0, but must be from 1"),
    (lambda: seamless.hexahedra(np.zeros((64, 3)), T, UVW, moving_rounds=-1), "moving_rounds is -1"),
    (lambda: seamless.hexahedra(np.zeros((64, 3)), T, UVW, feature_edges=[[0, 64]]),
     "row 0 of feature_edges has the index 64"),
    (lambda: seamless.measure_hexahedra(np.zeros((8, 3)), [[0, 1, 2, 3]]), "H has the shape"),
    (lambda: seamless.measure_hexahedra(np.zeros((8, 3)), [range(1, 9)]), "row 0 of H has the index 8"),
    (lambda: seamless.measure_hexahedra(np.zeros((8, 3)), [[0, 1, 2, 3, 4, 5, 6, 0]]),
     "row 0 of H has a vertex twice"),
    (lambda: seamless.snap_linear([[1, 2]], [0], [1.]), "A has 2 columns, but x has 1"),
    (lambda: seamless.snap_linear([[1, 2]], [0, 1], [1., 2]), "b has 2 numbers, but A has 1"),
    (lambda: seamless.snap_linear([[1, 2]], [np.nan], [1., 2]), "row 0 of b is not finite"),
    (lambda: seamless.snap_linear([[1, np.inf]], [1], [1., 2]), "row 0 of A is not finite"),
    (lambda: seamless.snap_linear([[1, "a"]], [1], [1., 2]), "pass rows of numbers"),
    (lambda: seamless.snap_linear([[1, 2]], [1], [1., 2], weights=[1, 0]), "row 1 of weights"),
    (lambda: seamless.snap_linear([1, 2], [1], [1., 2]), "A has the shape"),
    (lambda: seamless.snap_linear([[1, 2j]], [1], [1., 2]), "pass rows of numbers"),
])
def test_refused(call, words):
    with pytest.raises(seamless.Error, match=words):
        call()


def faces_of(H):
    """The six quadrilaterals of each hexahedron, counterclockwise as seen from outside."""
    sides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    return H[:, sides].reshape(-1, 4)


def boundary_and_volume(V, H):
    """The faces of one hexahedron only, and six times the volume within them."""
    faces = faces_of(H)
    _, which, counts = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True,
                                 return_counts=True)
    assert counts.max() <= 2
    boundary = faces[counts[which] == 1]
    a, b, c, d = V[boundary].transpose(1, 0, 2)
    return boundary, sum(np.einsum("ni,ni->", p, np.cross(q, r)) for p, q, r in ((a, b, c), (a, c, d)))


def test_hexahedra_of_integers():
    """The cells of the grid: their corners are vertices of the tetrahedra."""
    V, cells, uvw = seamless.examples.volume(3)
    V2, H, report = seamless.hexahedra(V, cells, uvw, report=True)
    assert V2.dtype == np.float64 and H.dtype == np.int64 and H.shape == (27, 8)
    assert len(V2) == 64 and np.abs(V2[:, None] - V).max(axis=2).min(axis=1).max() < 1e-8
    boundary, volume = boundary_and_volume(V2, H)
    assert len(boundary) == 54 and report["number_of_boundary_quadrilaterals"] == 54
    sorted_rows = lambda rows: sorted(map(tuple, np.sort(rows, axis=1)))
    assert sorted_rows(report["quadrilaterals"]) == sorted_rows(boundary)
    assert volume > 0 and report["nonpositive_hexahedra"] == []
    assert sorted(set(report["patches"])) == [1, 2, 3, 4, 5, 6]
    assert report["edges"].shape == (36, 2) and report["irregular_edges"] == {}
    assert sorted(set(report["curves"])) == list(range(1, 13)) and len(report["curves"]) == 36
    assert (report["feature_facets"] == -1).all() and (report["feature_edges"] == -1).all()
    shapes = seamless.measure_hexahedra(V2, H)
    assert all(report[key] == value for key, value in shapes.items())
    turned = seamless.measure_hexahedra(V2, H[:, [4, 5, 6, 7, 0, 1, 2, 3]])
    assert turned["nonpositive_hexahedra"] == list(range(27))


def test_features_of_hexahedra():
    """Two triangles of a square within, and an edge: their rows are told."""
    V, cells, uvw = seamless.examples.volume(2)
    corner = lambda x, y, z: (x * 3 + y) * 3 + z
    facets = [[corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1)],
              [corner(0, 0, 1), corner(0, 1, 1), corner(1, 1, 1)]]
    edge = [corner(1, 1, 1), corner(1, 1, 2)]
    V2, H, report = seamless.hexahedra(V, cells, uvw, feature_facets=facets, feature_edges=[edge],
                                       report=True)
    inside = report["quadrilaterals"][report["feature_facets"] >= 0]
    assert len(report["quadrilaterals"]) == 24 + 1
    expected = V[[corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)]]
    assert np.abs(V2[inside[0]][:, None] - expected).max(axis=2).min(axis=1).max() < 1e-8
    (ends,) = report["edges"][report["feature_edges"] == 0]
    assert np.abs(V2[ends][:, None] - V[edge]).max(axis=2).min(axis=1).max() < 1e-8


def test_number_of_hexahedra():
    V, cells, uvw = seamless.examples.volume(2)
    cube = np.array(list(itertools.product((0., 1., 2.), repeat=3)))
    V2, H = seamless.hexahedra(cube, cells, uvw, 216)
    assert len(H) == 216 and abs(boundary_and_volume(V2, H)[1] / 6 - 8) < 1e-7
    assert np.abs(3 * V2 - np.round(3 * V2)).max() < 1e-7
    with pytest.raises(seamless.Error, match="ask for a number of .hexahedra."):
        seamless.hexahedra(V, cells, 0.3 * uvw)


def test_bad_hexahedra_are_told():
    V, cells, uvw = seamless.examples.volume(2)
    folded = V * [1, 1, 0]
    with pytest.warns(UserWarning, match="8 hexahedra have a corner that is not positive, the first is row 0"):
        seamless.hexahedra(folded, cells, uvw)


@pytest.mark.parametrize("number", [None, 1000])
def test_program_hexes(program, tmp_path, number):
    V, cells, uvw = seamless.examples.volume(3)
    with open(tmp_path / "in.hexex", "w", encoding="utf-8") as file:
        row = lambda numbers: " ".join(map(repr, numbers)) + "\n"
        file.write(f"{len(V)}\n")
        file.writelines(map(row, V.tolist()))
        file.write(f"{len(cells)}\n")
        file.writelines(row(c + u) for c, u in zip(cells.tolist(), uvw.reshape(-1, 12).tolist()))
    program("hexes", tmp_path / "in.hexex", tmp_path / "out.vtk",
            *(["--number", number] if number else []))
    words = (tmp_path / "out.vtk").read_text().split()
    table = lambda key, skip, columns: np.array(
        words[words.index(key) + skip:][:columns * int(words[words.index(key) + 1])],
        dtype=float).reshape(-1, columns)
    V2, H = seamless.hexahedra(V, cells, uvw, number)
    assert (table("POINTS", 3, 3) == V2).all()
    numbers = [int(word) for word in words[words.index("CELLS") + 3:words.index("CELL_TYPES")]]
    in_file = []  # after lines and quadrilaterals
    while numbers:
        if numbers[0] == 8:
            in_file.append(numbers[:9])
        del numbers[:1 + numbers[0]]
    in_file = np.array(in_file)
    assert (in_file[:, 0] == 8).all() and (in_file[:, 1:] == H).all()


def residuals(A, b, x):
    return [sum(Fraction(a) * Fraction(float(v)) for a, v in zip(row, x)) - Fraction(c)
            for row, c in zip(A, b)]


def test_linear_systems():
    rng = np.random.default_rng(4)
    for trial in range(20):
        A = rng.integers(-2, 3, (4, 9))
        b = (A @ rng.integers(-5, 6, 9)).tolist()
        x = np.linalg.lstsq(A, b, rcond=None)[0] + 1e-9 * rng.standard_normal(9)
        expected = seamless.snap_linear(A, b, x)
        assert not any(residuals(A.tolist(), b, expected))
        for same in (scipy.sparse.csr_matrix(A), scipy.sparse.coo_matrix(A), A.astype(float),
                     A.astype(np.int8), A.astype(object)):
            assert (seamless.snap_linear(same, b, x) == expected).all()


def test_fractions_of_any_size():
    A = [[Fraction(1, 3), 2**100, 0], [0, 1, Fraction(-2, 7)]]
    b = [0, Fraction(0)]
    x, report = seamless.snap_linear(A, b, [3.0 * 2**100, -1.0, -3.5000001], report=True)
    assert not any(residuals(A, b, x)) and report["status"] == "snapped"


def test_contradiction():
    with pytest.raises(seamless.Error) as caught:
        seamless.snap_linear([[1, 1], [0, 1], [1, 2]], [0, 1, 2], [1., 2.])
    assert caught.value.status == "inconsistent"
    assert sorted(caught.value.report["contradicting_rows"].tolist()) == [0, 1, 2]
