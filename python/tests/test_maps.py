"""Quads, layouts, and isocurves of parametrizations; against counts, and the program to the bit."""

import numpy as np
import pytest

import seamless
from conftest import DATA, Obj, assert_plain


@pytest.fixture(scope="module")
def torus():
    V, F = seamless.examples.torus()
    return V, F, seamless.parametrize(V, F)


def euler_number(V, Q):
    edges = np.unique(np.sort(np.stack([Q, np.roll(Q, -1, 1)], -1).reshape(-1, 2), 1), axis=0)
    return len(V) - len(edges) + len(Q)


def test_own_integers():
    """A grid map of 12 times 8 cells."""
    F, uv = seamless.examples.inexact_map()
    V = np.random.default_rng(5).random((96, 3))
    V2, Q, report = seamless.extract_quads(V, F, uv * [12, 8], report=True)
    assert Q.shape == (96, 4) and euler_number(V2, Q) == 0
    assert np.allclose(sorted(V2.tolist()), sorted(V.tolist()), atol=1e-5)  # the noise is left inside
    with pytest.raises(seamless.Error, match="'rounding' is 0.01; ask for a number of 'quads'") as caught:
        seamless.extract_quads(V, F, uv * [12.3, 8])
    assert_plain(caught.value, seamless.extract_quads)
    V2, Q = seamless.extract_quads(V, F, uv * [6, 4], grid_scale=2)
    assert Q.shape == (96, 4)


def test_refused_maps():
    F, uv = seamless.examples.inexact_map()
    V = np.random.default_rng(5).random((96, 3))
    with pytest.raises(seamless.Error, match="enclose no area") as caught:
        seamless.extract_quads(V, F, 0 * uv, quads=20)
    assert caught.value.status == caught.value.report["status"] == "not positive"
    assert caught.value.remedy == "parametrize() computes others"
    uv[8, 1, 1] = 0.77
    for options in ({}, {"quads": 100}):
        with pytest.raises(seamless.Error, match="cut edges don't fit") as caught:
            seamless.extract_quads(V, F, uv, **options)
        assert caught.value.status == "not seamless" and "snap()" in caught.value.remedy
        assert {int(w) for w in caught.value.place.split() if w.isdigit()} <= set(F[8].tolist())
        assert_plain(caught.value, seamless.extract_quads)
    atlas = np.random.default_rng(3).random((len(F), 3, 2))
    with pytest.raises(seamless.Error, match="texture atlas"):
        seamless.extract_quads(V, F, atlas, quads=100)


def test_quantization(torus):
    V2, Q, report = seamless.extract_quads(*torus, quads=300, report=True)
    assert 200 < len(Q) < 450 and euler_number(V2, Q) == 0
    assert report["number_of_inverted_quads"] == 0


@pytest.mark.parametrize("name", ["genus0.obj", "genus2.obj", "genus2_border.obj"])
@pytest.mark.parametrize("number", [150, 1500])
def test_program_quads(program, load, tmp_path, name, number):
    program("quads", DATA / name, tmp_path / "out.obj", "--number", number)
    mesh, made = load(name), Obj(tmp_path / "out.obj")
    V, Q = seamless.extract_quads(mesh.V, mesh.F, mesh.uv, quads=number)
    assert (made.V == V).all() and (made.F == Q).all()


def test_layout(load):
    mesh = load("genus2.obj")
    uv = seamless.snap(mesh.F, mesh.uv)
    parts = seamless.layout(mesh.V, mesh.F, uv)
    cones = seamless.measure(mesh.F, uv)["cones"]
    assert parts.node_kinds.count("cone") == len(cones)
    assert {int(v) for v in parts.node_vertices if v >= 0} >= set(cones[:, 0].tolist())
    assert not parts.patch_is_cut.any() and not parts.arc_is_constrained.any()
    # Euler's formula, and the area of the plane
    assert len(parts.nodes) - len(parts.arcs) + len(parts.patch_corners) == -2
    a, b = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    area = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2
    assert np.isclose(parts.patch_sizes.prod(axis=1).sum(), area, rtol=1e-12)
    lengths = np.zeros(len(parts.patch_corners))
    for p, halves in enumerate(parts.patch_half_arcs):
        lengths[p] = parts.arc_lengths[halves // 2].sum()
        assert (parts.arc_patches[halves // 2, halves % 2] == p).all()
    assert np.allclose(lengths, 2 * parts.patch_sizes.sum(axis=1), rtol=1e-12)
    for arc, path in zip(parts.arcs, parts.arc_paths):
        assert np.allclose(path[[0, -1]], parts.nodes[arc], atol=1e-9)
    with pytest.raises(seamless.Error, match="leave out base_complex=True"):  # curves are very long
        seamless.layout(mesh.V, mesh.F, uv, base_complex=True)
    with pytest.raises(seamless.Error, match="exactly seamless") as caught:
        seamless.layout(mesh.V, mesh.F, mesh.uv)
    assert caught.value.status == "not seamless" and "snap" in str(caught.value)


def test_base_complex():
    """A cube: its corners are cones, which its edges connect."""
    from test_surfaces import refined_box
    V, F = refined_box(2)
    uv = seamless.parametrize(V, F, features=seamless.sharp_edges(V, F))
    parts = seamless.layout(V, F, uv, features=seamless.sharp_edges(V, F), base_complex=True)
    assert parts.node_kinds.count("cone") == 8 and parts.patch_corners.shape == (6, 4)
    assert parts.arc_is_constrained.all() and len(parts.arcs) == 12
    assert (parts.patch_corners >= 0).all() and np.allclose(parts.arc_lengths, parts.arc_lengths[0])


def test_traces(load):
    mesh = load("genus2.obj")
    uv = seamless.snap(mesh.F, mesh.uv)
    cones = seamless.measure(mesh.F, uv)["cones"]
    curves = seamless.trace(mesh.F, uv)
    assert len(curves) == (4 - cones[:, 1]).sum()
    for curve in curves:
        points = curve.points(mesh.V, mesh.F)
        assert np.isin(points[0], mesh.V[cones[:, 0]]).all()
        assert (curve.weights >= 0).all() and np.allclose(curve.weights.sum(axis=1), 1)
        if curve.end == "singular vertex":
            assert np.isin(points[-1], mesh.V[cones[:, 0]]).all()
    v = int(mesh.F[0, 0])
    assert len(seamless.trace(mesh.F, uv, [v])) >= 3
    inside = seamless.trace(mesh.F, uv, ([3, 8], [[0.2, 0.3, 0.5]] * 2), maximum_length=0.1)
    assert len(inside) == 8 and {c.direction for c in inside} == {0, 1, 2, 3}
    assert np.allclose(inside[0].points(mesh.V, mesh.F)[0], [0.2, 0.3, 0.5] @ mesh.V[mesh.F[3]])


@pytest.mark.parametrize("start, words", [
    ([10**6], "row 0 of start has the index"),
    (([0], [[1., 0., 0.]]), r"row 0 of start\[1\] is no place inside"),
    (([10**6], [[0.2, 0.3, 0.5]]), r"start\[0\] has the index"),
    ("a", "start has the type"),
])
def test_bad_starts(start, words):
    F, uv = seamless.examples.inexact_map()
    with pytest.raises(seamless.Error, match=words):
        seamless.trace(F, seamless.snap(F, uv), start)


def test_inexact_map_is_not_traced():
    with pytest.raises(seamless.Error, match=r"snap\(\)"):
        seamless.trace(*seamless.examples.inexact_map())
