"""Values: against exact arithmetic in Python, and against the program to the bit."""

from fractions import Fraction

import numpy as np
import pytest

import seamless
from conftest import Obj, write_off


def number_of_inexact_edges(F, uv):
    """By the definition, in rational numbers: edges whose sides differ by no quarter turns."""
    sides = {}
    for f, corners in enumerate(F):
        for k in range(3):
            a, b = int(corners[k]), int(corners[(k + 1) % 3])
            change = [Fraction(float(uv[f, (k + 1) % 3, i])) - Fraction(float(uv[f, k, i]))
                      for i in range(2)]
            sides.setdefault((min(a, b), max(a, b)), []).append(
                change if a < b else [-c for c in change])
    return sum(not any(pair[1] == turned for turned in quarter_turns(pair[0]))
               for pair in sides.values() if len(pair) == 2)


def quarter_turns(change):
    x, y = change
    return [[x, y], [-y, x], [-x, -y], [y, -x]]


@pytest.mark.parametrize("name", ["genus0.obj", "genus2.obj", "genus2_border.obj"])
def test_snapping_is_exact(load, name):
    mesh = load(name)
    assert number_of_inexact_edges(mesh.F, mesh.uv) == \
        seamless.measure(mesh.F, mesh.uv)["number_of_inexact_edges"]
    uv, report = seamless.snap(mesh.F, mesh.uv, report=True)
    assert number_of_inexact_edges(mesh.F, uv) == 0
    assert seamless.measure(mesh.F, uv)["exact"]
    assert np.abs(uv - mesh.uv).max() == report["largest_change"]
    assert (seamless.snap(mesh.F, uv) == uv).all()


def test_snapping_moves_what_noise_has_moved(load):
    mesh = load("genus2.obj")
    exact = seamless.snap(mesh.F, mesh.uv)
    rng = np.random.default_rng(7)
    noisy = exact + 1e-8 * rng.standard_normal(exact.shape)
    assert number_of_inexact_edges(mesh.F, noisy) > 0
    assert number_of_inexact_edges(mesh.F, seamless.snap(mesh.F, noisy)) == 0


def test_parametrization_is_exact():
    V, F = seamless.examples.torus()
    uv, report = seamless.parametrize(V, F, report=True)
    assert number_of_inexact_edges(F, uv) == 0
    assert report["genus"] == 1
    assert report["cones"][:, 1].sum() == 0 if len(report["cones"]) else True  # 4 times Euler's number


def test_features_are_isocurves():
    V, F = refined_box(3)
    E = seamless.sharp_edges(V, F)
    assert len(E) == 12 * 8
    uv = seamless.parametrize(V, F, features=E)
    corner = {(int(f[k]), int(f[(k + 1) % 3])): (i, k) for i, f in enumerate(F) for k in range(3)}
    for a, b in E:
        for side in ((a, b), (b, a)):
            i, k = corner[side]
            assert (uv[i, k] == uv[i, (k + 1) % 3]).any()
    measured = seamless.measure(F, uv, features=E)
    assert measured["exact"] and measured["number_of_aligned_edges"] == len(E)
    assert sorted(measured["cones"][:, 1]) == [1] * 8


def refined_box(rounds):
    V, F = seamless.examples.box()
    for _ in range(rounds):
        V, F = refined(V, F)
    return V, F


def refined(V, F):
    V, number, triangles = list(map(tuple, V)), {}, []

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in number:
            number[key] = len(V)
            V.append(tuple((x + y) / 2 for x, y in zip(V[a], V[b])))
        return number[key]

    for a, b, c in F.tolist():
        d, e, f = middle(a, b), middle(b, c), middle(c, a)
        triangles += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
    return np.array(V), np.array(triangles)


def test_quads_are_a_closed_surface():
    V, F = refined_box(3)
    E = seamless.sharp_edges(V, F)
    V2, Q, report = seamless.quad_remesh(V, F, quads=600, features=E, report=True)
    assert Q.dtype == np.int64 and V2.dtype == np.float64
    assert 400 < len(Q) < 900 and report["number_of_quads"] == len(Q)
    edges = np.sort(np.stack([Q, np.roll(Q, -1, axis=1)], -1).reshape(-1, 2), axis=1)
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    assert (counts == 2).all()
    assert len(V2) - len(unique) + len(Q) == 2
    assert np.abs(V2).max() <= 1 and {tuple(v) for v in V} >= {tuple(p) for p in V2
                                                              if set(p) <= {0., 1.}}
    places = np.einsum("ni,nij->nj", report["weights_of_vertices"],
                       V[F[report["faces_of_vertices"]]])
    assert np.abs(places - V2).max() < 1e-12
    on_two_sides = lambda p: ((p == 0) | (p == 1)).sum(axis=-1) >= 2
    assert on_two_sides(V2[report["feature_edges"]]).all()


def test_small_parts_are_told():
    V, F = refined_box(3)
    V2, F2 = np.concatenate([V, 0.01 * V + 2]), np.concatenate([F, F + len(V)])
    with pytest.warns(UserWarning, match="1 small closed parts were left out"):
        Q = seamless.quad_remesh(V2, F2, quads=300)[1]
    alone = seamless.quad_remesh(V, F, quads=300)[1]
    assert abs(len(Q) - len(alone)) < 30
    points, _, report = seamless.quad_remesh(V2, F2, quads=300, area_threshold=0, report=True)
    assert report["number_of_parts_left_out"] == 0 and points.max() > 1.5


def largest_inward_turn(V, Q):
    """In degrees, between the normals of two neighbors that face each other."""
    P = V[Q]
    normals = np.cross(P[:, 2] - P[:, 0], P[:, 3] - P[:, 1])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    middles = P.mean(axis=1)
    face_of = {(q[k], q[(k + 1) % 4]): i for i, q in enumerate(Q.tolist()) for k in range(4)}
    turns = [0]
    for (a, b), f in face_of.items():
        g = face_of.get((b, a))
        if g is not None and (normals[f] - normals[g]) @ (middles[g] - middles[f]) > 0:
            turns.append(np.degrees(np.arccos(np.clip(normals[f] @ normals[g], -1, 1))))
    return max(turns)


def test_few_quads_are_not_folded(tmp_path, program):
    # The body is thinner than a quad is long. Four quads around a hole turn by 90 degrees each.
    program("body", tmp_path / "body.obj", "--genus", 2)
    body = Obj(tmp_path / "body.obj")
    V, Q, report = seamless.quad_remesh(body.V, body.F, quads=25, report=True)
    assert report["number_of_inverted_quads"] == report["number_of_folded_quads"] == 0
    assert largest_inward_turn(V, Q) < 135


def test_too_many_quads_are_told(monkeypatch):
    V, F = refined_box(2)
    make = seamless._core.quad_remesh
    monkeypatch.setattr(seamless._core, "quad_remesh", lambda *arguments: tuple(
        {**x, "has_too_many_quads": True, "number_of_inverted_quads": 7, "number_of_folded_quads": 3}
        if isinstance(x, dict) else x for x in make(*arguments)))
    with pytest.warns(UserWarning) as told:
        seamless.quad_remesh(V, F, quads=100)
    words = " ".join(str(warning.message) for warning in told)
    assert "quads are more than twice as many as wanted" in words and "7 quads are inverted" in words
    assert "3 quads are folded" in words
    part = {"triangle": 5, "number_of_quads": 9, "number_wanted": 0.5, "number_needed": 4,
            "has_too_many_quads": True}
    monkeypatch.setattr(seamless._core, "quad_remesh", lambda *arguments: tuple(
        {**x, "has_too_many_quads": True, "parts_of_other_size": [part]}
        if isinstance(x, dict) else x for x in make(*arguments)))
    with pytest.warns(UserWarning, match="the part with triangle 5 has 9 quads, more than twice"):
        seamless.quad_remesh(V, F, quads=100)


def test_symmetry():
    V, F = refined_box(3)
    V = V - 0.5
    V2, Q, report = seamless.quad_remesh(V, F, quads=300, symmetry="auto", report=True)
    assert report["symmetry_plane"] == [1, 0, 0, 0]
    points = {tuple(p) for p in V2}
    assert {(-x, y, z) for x, y, z in points} == points


def test_field_and_files(tmp_path):
    n = 16
    x, y = np.meshgrid(np.arange(n + 1.), np.arange(n + 1.), indexing="ij")
    V = np.stack([x, y, 0 * x], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a = (i * (n + 1) + j).reshape(-1)
    F = np.concatenate([np.stack([a, a + n + 1, a + n + 2], -1), np.stack([a, a + n + 2, a + 1], -1)])
    D = np.tile([1., 1., 0.], (len(F), 1))
    turned = [[-1., 1., 0.], [-1., -1., 0.], [1., -1., 0.]]
    four = np.concatenate([D] + [np.tile(t, (len(F), 1)) for t in turned], axis=1)
    expected = seamless.parametrize(V, F, field=D)
    change = expected[:, 1] - expected[:, 0]  # of triangles along x: turned by 45 degrees
    assert np.allclose(np.abs(change[:n * n]), np.sqrt(0.5), atol=1e-6)
    rows = lambda table: "\n".join(" ".join(map(repr, r)) for r in table.tolist())
    (tmp_path / "a.rosy").write_text(f"{len(F)}\n4\n" + rows(D))
    (tmp_path / "a.rawfield").write_text(f"4 {len(F)}\n" + rows(four))
    (tmp_path / "a.dmat").write_text(f"3 {len(F)}\n" + "\n".join(map(repr, D.T.reshape(-1).tolist())))
    (tmp_path / "a.txt").write_text(rows(D))
    for field in [four, four.reshape(-1, 4, 3)] + sorted(tmp_path.iterdir()):
        assert (seamless.parametrize(V, F, field=field) == expected).all()
    (tmp_path / "a.txt").write_text(rows(D[:-1]))
    with pytest.raises(seamless.Error, match=f"directions for {len(F) - 1} faces"):
        seamless.parametrize(V, F, field=tmp_path / "a.txt")


# ---- the same bits as the program

def test_program_parametrize(program, tmp_path):
    V, F = seamless.examples.torus(20, 12)
    write_off(tmp_path / "in.off", V, F)
    program("parametrize", tmp_path / "in.off", tmp_path / "out.obj")
    mesh = Obj(tmp_path / "out.obj")
    assert (mesh.F == F).all() and (mesh.uv == seamless.parametrize(V, F)).all()


@pytest.mark.parametrize("name", ["genus0.obj", "genus2.obj", "genus2_border.obj"])
def test_program_snap(program, load, tmp_path, name):
    from conftest import DATA
    program("snap", DATA / name, tmp_path / "out.obj")
    mesh = load(name)
    assert (Obj(tmp_path / "out.obj").uv == seamless.snap(mesh.F, mesh.uv)).all()


@pytest.mark.parametrize("options, arguments", [
    (["--feature-angle", "0"], {}),
    (["--feature-angle", "40", "--feature-length", "0"], {"features": True}),
    (["--feature-angle", "0", "--symmetry", "auto"], {"symmetry": "auto"}),
    (["--feature-angle", "0", "--curvature", "0", "--adaptivity", "3"],
     {"curvature": 0, "adaptivity": 3}),
])
def test_program_remesh(program, tmp_path, options, arguments):
    V, F = refined_box(3)
    V = V * [1, 1, 1.5] - 0.5
    write_off(tmp_path / "in.off", V, F)
    program("remesh", tmp_path / "in.off", tmp_path / "out.obj", "--number", 400, *options)
    if arguments.pop("features", False):
        arguments["features"] = seamless.sharp_edges(V, F, 40)
    V2, Q = seamless.quad_remesh(V, F, quads=400, **arguments)
    mesh = Obj(tmp_path / "out.obj")
    assert (mesh.V == V2).all() and (mesh.F == Q).all()
