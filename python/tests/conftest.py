"""What all tests share: meshes of the C++ tests, and the program."""

import inspect
import os
import pathlib
import re
import subprocess

import numpy as np
import pytest

import seamless

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DATA = SOURCE / "test" / "Seamless_snapping" / "data"
# the named parameters of C++ that are no plain words
CPP_NAMES = {name for page in SOURCE.glob("include/CGAL/**/*.h") for name in
             re.findall(r"\\cgalParamNBegin\{(\w+_\w+)\}", page.read_text(encoding="utf-8"))}


def parameters(function):
    is_function = inspect.isfunction(function)
    return set(inspect.signature(function).parameters) if is_function else set()


def assert_plain(error, function=None):
    """A message has no words of C++, and names the argument, or the element, that is invalid.

    Without a function, the message may name the parameters of all.
    """
    message = str(error)
    names = parameters(function) if function else set()
    mentioned = set(re.findall(r"(\w+)\(\)", message)) if function else set(seamless.__all__)
    known = names.union(*map(parameters, (getattr(seamless, name) for name in
                                          mentioned.intersection(seamless.__all__))))
    for word in CPP_NAMES - known:
        assert not re.search(rf"\b{word}\b", message), message
    assert not re.search(r"::|<\w|\w>|\((?:true|false|\d+)\)|\b(?:std|size_t|halfedge)\b", message), message
    for part in (error.reason, error.remedy or "", error.place or ""):
        assert part in message
    assert error.reason
    if function and error.status in ("invalid argument", "not finite"):
        names_argument = any(re.search(rf"\b{name}\b", message) for name in names)
        assert names_argument or error.place or "the mesh" in message, message


class Obj:
    """The arrays of an OBJ file."""

    def __init__(self, path):
        points, coordinates, faces, corners, segments = [], [], [], [], []
        for line in open(path, encoding="utf-8"):
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                points.append([float(w) for w in words[1:4]])
            elif words[0] == "vt":
                coordinates.append([float(w) for w in words[1:3]])
            elif words[0] == "l":
                segments += [[int(a) - 1, int(b) - 1] for a, b in zip(words[1:], words[2:])]
            elif words[0] == "f":
                faces.append([int(w.split("/")[0]) - 1 for w in words[1:]])
                if "/" in words[1]:
                    corners.append([int(w.split("/")[1]) - 1 for w in words[1:]])
        self.V, self.F = np.array(points), np.array(faces)
        self.uv = np.array(coordinates)[np.array(corners)] if corners else None
        self.features = np.array(segments).reshape(-1, 2)


def write_off(path, V, F):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(V)} {len(F)} 0\n")
        file.writelines(" ".join(repr(float(x)) for x in p) + "\n" for p in V)
        file.writelines("3 " + " ".join(str(int(v)) for v in f) + "\n" for f in F)


@pytest.fixture
def load():
    """Reads a mesh of the C++ tests."""
    return lambda name: Obj(DATA / name)


@pytest.fixture
def program():
    """Runs the program; skips the test if it is not built."""
    path = os.environ.get("SEAMLESS_PROGRAM", "")
    if not os.path.exists(path):
        pytest.skip("the program is not built")

    def run(*arguments):
        return subprocess.run([path, *map(str, arguments)], check=True, capture_output=True,
                              text=True, timeout=600)

    return run
