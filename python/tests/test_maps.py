"""Quads of parametrizations; against counts, and the program to the bit."""

import numpy as np
import pytest

import seamless
from conftest import DATA, Obj


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
    with pytest.raises(seamless.Error, match="'rounding'|integer"):
        seamless.extract_quads(V, F, uv * [12.3, 8])
    V2, Q = seamless.extract_quads(V, F, uv * [6, 4], grid_scale=2)
    assert Q.shape == (96, 4)


def test_quantization(torus):
    V2, Q, report = seamless.extract_quads(*torus, quads=300, report=True)
    assert 200 < len(Q) < 450 and euler_number(V2, Q) == 0
    assert report["number_of_inverted_quads"] == 0


@pytest.mark.parametrize("name", ["genus0.obj", "genus2.obj", "genus2_border.obj"])
@pytest.mark.parametrize("number", [100, 1500])
def test_program_quads(program, load, tmp_path, name, number):
    program("quads", DATA / name, tmp_path / "out.obj", "--number", number)
    mesh, made = load(name), Obj(tmp_path / "out.obj")
    V, Q = seamless.extract_quads(mesh.V, mesh.F, mesh.uv, quads=number)
    assert (made.V == V).all() and (made.F == Q).all()
