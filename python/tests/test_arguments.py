"""Bad input is an error that names argument and row; good input may have any layout and type."""

import pickle
import types

import numpy as np
import pytest

import seamless
from conftest import assert_plain

V, F = seamless.examples.torus(20, 12)
EF, EUV = seamless.examples.inexact_map()


def bad(value, index, with_):
    result = np.array(value)
    result[index] = with_
    return result


@pytest.mark.parametrize("call, words", [
    (lambda: seamless.quad_remesh(bad(V, (5, 1), np.nan), F), "row 5 of V is not finite"),
    (lambda: seamless.quad_remesh(bad(V, (7, 2), np.inf), F), "row 7 of V is not finite"),
    (lambda: seamless.quad_remesh(V[:, :2], F), r"V has the shape \(240, 2\)"),
    (lambda: seamless.quad_remesh(V, bad(F, (9, 0), len(V))), "row 9 of F has the index 240"),
    (lambda: seamless.quad_remesh(V, bad(F, (9, 0), -1)), "row 9 of F has the index -1"),
    (lambda: seamless.quad_remesh(V, bad(F, 4, [1, 2, 1])), "row 4 of F has a vertex twice"),
    (lambda: seamless.quad_remesh(V, F.astype(float)), "F has the type float64"),
    (lambda: seamless.quad_remesh(V, np.zeros((3, 4), int)), "triangulate"),
    (lambda: seamless.quad_remesh(V, F[:0]), "F is empty"),
    (lambda: seamless.quad_remesh(V[:0], F), "V is empty"),
    (lambda: seamless.quad_remesh(V), "F is missing"),
    (lambda: seamless.quad_remesh("torus", F), "V has the type"),
    (lambda: seamless.quad_remesh([[1, 2, 3], [1, 2]], F), "V "),
    (lambda: seamless.quad_remesh(V, F, quads=-1), "quads is -1, but must be from 1"),
    (lambda: seamless.quad_remesh(V, F, quads=2.5), "quads must be an integer"),
    (lambda: seamless.quad_remesh(V, F, quads=5, coarsest=True), "exclude each other"),
    (lambda: seamless.quad_remesh(V, F, edge_length=0), "edge_length is 0, but must be more than 0"),
    (lambda: seamless.quad_remesh(V, F, edge_length=np.nan), "edge_length must be finite"),
    (lambda: seamless.quad_remesh(V, F, feature_loss=2), "feature_loss is 2"),
    (lambda: seamless.parametrize(V, F, curvature=1e-30), "'curvature' must be 0, or at least"),
    (lambda: seamless.quad_remesh(0 * V, F), "rows of V that triangles have are the same point"),
    (lambda: seamless.quad_remesh(V, F, sizes=np.ones(3)), r"sizes has the shape \(3,\)"),
    (lambda: seamless.quad_remesh(V, F, sizes=bad(np.ones(len(V)), 6, 0)), "row 6 of sizes is 0"),
    (lambda: seamless.quad_remesh(V, F, features=[[0, 500]]), "row 0 of features has the index 500"),
    (lambda: seamless.quad_remesh(V, F, features=[[0, 1], [0, 100]]),
     "row 1 of features: no triangle has an edge between the vertices 0 and 100"),
    (lambda: seamless.quad_remesh(V, F, field=np.ones((3, 3))), "field has the shape"),
    (lambda: seamless.quad_remesh(V, F, symmetry="w"), "symmetry is 'w'"),
    (lambda: seamless.quad_remesh(V, F, symmetry=[0, 0, 0, 1]), "symmetry is no plane"),
    (lambda: seamless.quad_remesh(V, F, progress=3), "progress must be a function"),
    (lambda: seamless.quad_remesh(V, F, report=3), "report must be True or False"),
    (lambda: seamless.quad_remesh(V, np.concatenate([F, [[0, 12, 20]]])), "not manifold"),
    (lambda: seamless.quad_remesh(V, bad(F, 3, F[3][::-1])), "orient the faces consistently"),
    (lambda: seamless.sharp_edges(V, F, angle=200), "angle is 200, but must be at most 180"),
    (lambda: seamless.snap(EF, EUV[:, :2]), "uv has the shape"),
    (lambda: seamless.snap(EF, np.zeros((96, 2))), r"pass uv\[F\]"),
    (lambda: seamless.snap(EF, bad(EUV, (8, 1, 1), np.nan)), "row 8 of uv is not finite"),
    (lambda: seamless.snap(EF, EUV, tolerance=0), "tolerance is 0"),
    (lambda: seamless.snap(EF, EUV, weld=True), "pass V, too"),
    (lambda: seamless.snap(EF, EUV, out=np.zeros(3)), "out must be a float64 array"),
    (lambda: seamless.snap(EF, EUV, align_border=1), "align_border must be True or False"),
    (lambda: seamless.read_field("a.png"), "directions are read from"),
])
def test_refused(call, words):
    with pytest.raises(seamless.Error, match=words) as caught:
        call()
    assert isinstance(caught.value, ValueError)
    assert_plain(caught.value)


def test_error_has_parts():
    with pytest.raises(seamless.Error) as caught:
        seamless.quad_remesh(bad(V, (5, 1), np.nan), F)
    assert caught.value.place == "row 5 of V" and caught.value.status == "not finite"
    with pytest.raises(seamless.Error) as caught:
        seamless.snap(EF, bad(EUV, (8, 1, 1), 0.77))
    error = pickle.loads(pickle.dumps(caught.value))
    for e in (caught.value, error):
        assert e.status == "not seamless" and e.remedy and e.report["status"] == e.status
        assert e.place and {int(w) for w in e.place.split() if w.isdigit()} <= set(range(96))


def test_numbers_of_vertices_are_rows():
    """Rows without triangles don't count in messages, but for their places."""
    moved = EF * 3 + 7
    for faces, factor, first in ((EF, 1, 0), (moved, 3, 7)):
        with pytest.raises(seamless.Error) as caught:
            seamless.snap(faces, bad(EUV, (8, 1, 1), 0.77))
        numbers = [int(w) for w in caught.value.place.replace("vertices", "").split() if w.isdigit()]
        if factor == 1:
            expected = numbers
        assert numbers == [n * factor + first for n in expected]
    assert (seamless.snap(moved, EUV) == seamless.snap(EF, EUV)).all()
    far = EF + 10**9
    assert (seamless.snap(far, EUV) == seamless.snap(EF, EUV)).all()


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.int16, np.int32, np.uint32, np.int64, np.uint64])
def test_any_integers(kind):
    faces = EF.astype(kind)
    assert (seamless.snap(faces, EUV) == seamless.snap(EF, EUV)).all()
    assert (seamless.snap(np.asfortranarray(faces), np.asfortranarray(EUV)) ==
            seamless.snap(EF, EUV)).all()
    wide = np.zeros((len(EF), 6), kind)
    wide[:, ::2] = faces
    assert (seamless.snap(wide[:, ::2], EUV[:, :, ::-1][:, :, ::-1]) == seamless.snap(EF, EUV)).all()
    assert (seamless.snap(EF.tolist(), EUV.tolist()) == seamless.snap(EF, EUV)).all()


def test_single_precision_is_converted():
    single = EUV.astype(np.float32)
    assert (seamless.snap(EF, single) == seamless.snap(EF, single.astype(np.float64))).all()
    assert (seamless.sharp_edges(V.astype(np.float32), F) == seamless.sharp_edges(V, F)).all()


def test_nothing_changes_but_out():
    faces, uv = EF.copy(), EUV.copy()
    for array in (faces, uv):
        array.flags.writeable = False
    expected = seamless.snap(faces, uv)
    assert (faces == EF).all() and (uv == EUV).all() and (expected != EUV).any()
    out = np.empty_like(EUV)
    assert seamless.snap(faces, uv, out=out) is out and (out == expected).all()
    uv = EUV.copy()
    seamless.snap(EF, uv, out=uv)
    assert (uv == expected).all()
    wrong = bad(EUV, (8, 1, 1), 0.77)
    out[...] = 3
    with pytest.raises(seamless.Error):
        seamless.snap(EF, wrong, out=out)
    assert (out == 3).all()


def test_mesh_objects():
    expected = seamless.quad_remesh(V, F, 200)
    like_trimesh = types.SimpleNamespace(vertices=V, faces=F)
    block = types.SimpleNamespace(type="triangle", data=F[:100])
    other = types.SimpleNamespace(type="triangle", data=F[100:])
    line = types.SimpleNamespace(type="line", data=F[:, :2])
    like_meshio = types.SimpleNamespace(points=V, cells=[block, line, other])
    for mesh in (like_trimesh, like_meshio):
        points, quads = seamless.quad_remesh(mesh, quads=200)
        assert (points == expected[0]).all() and (quads == expected[1]).all()
    block.type = "quad"
    with pytest.raises(seamless.Error, match="triangulate"):
        seamless.quad_remesh(like_meshio)


def test_texture_atlas():
    """Each triangle has its own chart somewhere."""
    rng = np.random.default_rng(3)
    uv = np.concatenate([rng.random((len(EF), 1, 2))] * 3, axis=1) + 0.01 * rng.random((len(EF), 3, 2))
    with pytest.raises(seamless.Error, match="texture atlas.*pass the mesh to parametrize()"):
        seamless.snap(EF, uv)


def test_cut_mesh_is_told():
    """Points that triangles have for themselves."""
    points, faces = V[F].reshape(-1, 3), np.arange(3 * len(F)).reshape(-1, 3)
    with pytest.raises(seamless.Error, match="weld=True") as caught:
        seamless.quad_remesh(points, faces)
    assert_plain(caught.value)
    V2, Q = seamless.quad_remesh(points, faces, 200, weld=True)
    expected = np.unique(np.sort(np.stack([Q, np.roll(Q, -1, 1)], -1).reshape(-1, 2), 1), axis=0,
                         return_counts=True)[1]
    assert (expected == 2).all()


def test_types_are_those_of_the_functions():
    """The file of types lists all functions, with the same parameters."""
    import ast
    import inspect
    import pathlib
    tree = ast.parse(pathlib.Path(seamless.__file__).with_suffix(".pyi").read_text())
    stubs = {}
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            names = [a.arg for a in node.args.args + node.args.kwonlyargs]
            assert stubs.setdefault(node.name, names) == names
        elif isinstance(node, ast.ClassDef):
            stubs[node.name] = None
    public = set(seamless.__all__) - {"examples"}
    assert set(stubs) == public
    for name in public:
        assert getattr(seamless, name).__doc__
        if stubs[name] is not None:
            assert list(inspect.signature(getattr(seamless, name)).parameters) == stubs[name]
