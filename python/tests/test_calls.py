"""Threads, lines of progress, interruption, and calls with random faults."""

import copy
import os
import random
import signal
import subprocess
import sys
import threading
import time
import warnings

import numpy as np
import pytest

import seamless
from conftest import assert_plain

V, F = seamless.examples.torus()


class Stop(Exception):
    pass


def test_progress():
    lines = []
    expected = seamless.quad_remesh(V, F, 300)
    points, quads = seamless.quad_remesh(V, F, 300, progress=lines.append)
    assert lines and all(isinstance(line, str) for line in lines)
    assert (points == expected[0]).all() and (quads == expected[1]).all()

    def stop(line):
        raise Stop(line)

    for call in (lambda: seamless.quad_remesh(V, F, progress=stop),
                 lambda: seamless.parametrize(V, F, progress=stop),
                 lambda: seamless.snap(*seamless.examples.inexact_map(), progress=stop)):
        with pytest.raises(Stop):
            call()


def test_threads():
    """Results in threads are those of one call after the other, and other threads run meanwhile."""
    sizes = [(12 + 2 * i, 8 + i % 5) for i in range(12)]
    meshes = [seamless.examples.torus(*size) for size in sizes]
    expected = [seamless.quad_remesh(*mesh, quads=100) for mesh in meshes]
    found = [None] * len(meshes)

    def work(first):
        for i in range(first, len(meshes), 4):
            found[i] = seamless.quad_remesh(*meshes[i], quads=100)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for (points, quads), (other_points, other_quads) in zip(expected, found):
        assert (points == other_points).all() and (quads == other_quads).all()


def test_lock_is_released():
    ticks = 0
    done = threading.Event()

    def work():
        seamless.quad_remesh(V, F, 3000)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        ticks += 1
        time.sleep(0.001)
    thread.join()
    assert ticks > 10


def test_progress_is_called_in_the_thread_of_the_caller():
    threads = []
    seamless.quad_remesh(V, F, 300, progress=lambda line: threads.append(threading.get_ident()))
    assert set(threads) == {threading.get_ident()}


def inexact_grid(n):
    """A map of a torus whose cells are unit squares, with a little noise."""
    faces, uv = seamless.examples.inexact_map(n, n, noise=0)
    return faces, n * uv + 1e-9 * np.random.default_rng(1).standard_normal(uv.shape)


def threads_of_process():
    return set(os.listdir("/proc/self/task"))


def interrupted(call):
    """Whether a signal that comes when a call has begun ends the call before its work is done."""
    main = threading.main_thread().ident
    is_over = threading.Event()

    def interrupt():
        while not is_over.is_set():
            if sys._current_frames()[main].f_code.co_name == "call":
                os.kill(os.getpid(), signal.SIGINT)
                break
            time.sleep(0.001)

    before = threads_of_process()
    thread = threading.Thread(target=interrupt)
    thread.start()
    before.add(str(thread.native_id))
    was_interrupted = False
    try:
        call()
        is_over.set()
        thread.join()  # it may interrupt here, too
    except KeyboardInterrupt:
        was_interrupted = True
    is_at_work = was_interrupted and not threads_of_process() <= before
    thread.join()
    seamless._core.wait_for_interrupted_calls()
    while not threads_of_process() <= before:  # the system lists threads a little longer than they run
        time.sleep(0.001)
    return is_at_work


@pytest.mark.skipif(not os.path.exists("/proc/self/task"), reason="lists threads")
@pytest.mark.parametrize("name", ["quad_remesh", "parametrize", "measure", "layout"])
def test_interruption(name):
    """Ctrl-C ends a long call at once, also if the core tells nothing meanwhile, and changes no array.
    What is long depends on the machine: if the work is done first, a larger torus follows."""
    for n in (400, 800, 1600):
        points, faces = seamless.examples.torus(n, n)
        _, uv = inexact_grid(n)
        arguments = {"quad_remesh": (points, faces, 200000), "parametrize": (points, faces),
                     "measure": (faces, uv), "layout": (points, faces, np.round(uv))}[name]
        expected = copy.deepcopy(arguments)
        is_at_work = interrupted(lambda: getattr(seamless, name)(*arguments))
        for array, expected_array in zip(arguments, expected):
            assert np.array_equal(array, expected_array)
        if is_at_work:
            break
    assert is_at_work
    assert len(seamless.sharp_edges(V, F)) == 0  # the interpreter goes on


@pytest.mark.skipif(os.name == "nt", reason="signals")
@pytest.mark.parametrize("number_of_signals", [1, 2])
def test_interruption_ends_a_program(number_of_signals):
    """Whether or not the user waits for the thread that is left behind."""
    code = ("import seamless\n"
            "mesh = seamless.examples.torus(400, 250)\n"
            "print('ready', flush=True)\n"
            "while True:\n"
            "  seamless.parametrize(*mesh)\n")
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True) as process:
        assert process.stdout.readline() == "ready\n"
        time.sleep(0.3)
        for _ in range(number_of_signals):
            process.send_signal(signal.SIGINT)
            for line in process.stderr:
                if line == "KeyboardInterrupt\n":
                    break
        assert process.wait(100) in (-signal.SIGINT, 128 + signal.SIGINT)
        assert process.stdout.read() == ""


# ---- random faults: nothing but an error comes out

def a_number(rng):
    return rng.choice([0, -1, 1, 2, 7, 1e-30, 1e30, -3.5, float("nan"), float("inf"), None, "x", True,
                       [], 2**40, np.float32(3), np.int8(-4), 1 + 2j, 10**400, {}, b"a"])


def an_array(rng, value):
    """An array with a fault, or something that is none."""
    array = np.array(value)
    kind = rng.randrange(12)
    if kind == 0:
        return a_number(rng)
    if kind == 1:
        return array[:rng.randrange(3)]
    if kind == 2:
        return array.astype(rng.choice(["float32", "int8", "uint64", "complex128", "U5", "O", "bool"]))
    if kind == 3:
        return array.reshape(-1)
    if kind == 4:
        return array[..., :1]
    if kind == 5:
        return np.full_like(array, rng.choice([0, 1, -1, 5]))
    if kind == 6:
        return array[rng.sample(range(len(array)), len(array))]
    flat = array.reshape(-1)
    for _ in range(rng.randrange(1, 4)):
        i = rng.randrange(len(flat))
        with np.errstate(all="ignore"):
            flat[i] = rng.choice([0, -1, 1, 3, 10**9, 2**62]) if array.dtype.kind == "i" else \
                rng.choice([0, np.nan, np.inf, 1e300, -1e-300, 5e-324, flat[i] + 1e-3])
    return array


def a_call(rng):
    points, faces = seamless.examples.box()
    map_faces, uv = seamless.examples.inexact_map(4, 3)
    random_array = lambda value: an_array(rng, value) if rng.random() < 0.4 else value
    options = {}

    def maybe(name, value):
        if rng.random() < 0.3:
            options[name] = value()

    number = lambda: a_number(rng)
    name = rng.choice(["quad_remesh", "sharp_edges", "parametrize", "snap", "measure",
                       "extract_quads", "layout", "trace", "snap_volume", "measure_volume",
                       "hexahedra", "measure_hexahedra", "snap_linear"])
    edges = lambda: an_array(rng, [[0, 1], [1, 3]])
    if name in ("snap_volume", "measure_volume"):
        arguments = list(map(random_array, seamless.examples.inexact_volume(1)))
        maybe("feature_facets", lambda: an_array(rng, [[0, 1, 3]]))
        maybe("feature_edges", lambda: an_array(rng, [[0, 1]]))
        maybe("align_boundary", number)
        if name == "snap_volume":
            for key in ("tolerance", "repair_flips", "integer_grid", "grid_scale", "rounding"):
                maybe(key, number)
    elif name == "hexahedra":
        arguments = list(map(random_array, seamless.examples.volume(1)))
        for key in ("hexahedra", "maximum"):
            maybe(key, lambda: rng.choice([1, 8, 30, number()]))
        maybe("feature_facets", lambda: an_array(rng, [[0, 1, 3]]))
        for key in ("tolerance", "moving_rounds"):
            maybe(key, number)
    elif name == "measure_hexahedra":
        arguments = [random_array(points), random_array([[0, 4, 6, 2, 1, 5, 7, 3]])]
    elif name == "snap_linear":
        arguments = list(map(random_array, ([[1, -1, 0], [0, 3, 1]], [0, 5], [0.1, 0.2, 4.7])))
        maybe("weights", lambda: an_array(rng, [1., 2., 3.]))
    elif name == "trace":
        arguments = [random_array(map_faces), random_array(seamless.snap(map_faces, uv))]
        maybe("start", lambda: rng.choice([an_array(rng, [0, 5]), number(),
                                           (an_array(rng, [0, 1]), an_array(rng, np.full((2, 3), 1 / 3)))]))
        maybe("maximum_length", number)
    elif name in ("layout", "extract_quads"):
        plane = np.arange(36.).reshape(12, 3)**1.5
        arguments = [random_array(plane), random_array(map_faces),
                     random_array(seamless.snap(map_faces, uv * [4, 3]))]
        maybe("features", lambda: an_array(rng, [[0, 1], [1, 2]]))
        maybe("base_complex" if name == "layout" else "align_border", number)
        if name == "extract_quads":
            maybe("quads", lambda: rng.choice([1, 12, 50]))
            for key in ("grid_scale", "rounding", "repair_flips", "allow_holes", "weld"):
                maybe(key, lambda: rng.choice([0.5, 1, 2, True, False, number()]))
    elif name in ("snap", "measure"):
        maybe("features", lambda: an_array(rng, [[0, 1], [1, 2]]))
        maybe("align_border", number)
        maybe("V", lambda: an_array(rng, np.arange(36.).reshape(12, 3)))
        maybe("weld", number)
        arguments = [random_array(map_faces), random_array(uv)]
    else:
        arguments = [random_array(points), random_array(faces)]
        maybe("weld", number)
    if name == "snap":
        for key in ("tolerance", "repair_flips", "out", "progress"):
            maybe(key, number)
    if name == "sharp_edges":
        for key in ("angle", "minimum_length"):
            maybe(key, number)
    if name in ("parametrize", "quad_remesh"):
        maybe("features", edges)
        maybe("curvature", number)
        maybe("field", lambda: an_array(rng, np.ones((12, 3))))
    if name == "quad_remesh":
        options["quads"] = rng.choice([1, 5, 20, 50])
        maybe("quads", number)
        for key in ("edge_length", "coarsest", "maximum", "feature_loss", "adaptivity",
                    "border_tolerance", "symmetry"):
            if rng.random() < 0.5:
                maybe(key, number)
        maybe("sizes", lambda: an_array(rng, np.ones(8)))
        if options.get("maximum") is None:
            options["maximum"] = 2000
    return name, arguments, options


def test_random_calls():
    """SEAMLESS_RANDOM_CALLS sets how many; with 10,000 it takes some minutes."""
    seed = int(os.environ.get("SEAMLESS_RANDOM_SEED", "1"))
    number = int(os.environ.get("SEAMLESS_RANDOM_CALLS", "300"))
    print("seed", seed, "calls", number)
    refused = 0
    warnings.simplefilter("ignore")
    for i in range(number):
        name, arguments, options = a_call(random.Random(seed * 1000003 + i))
        try:
            with np.errstate(all="ignore"):
                getattr(seamless, name)(*arguments, **options)
        except seamless.Error as error:
            refused += 1
            assert_plain(error, getattr(seamless, name))
        except BaseException as error:
            raise AssertionError(f"call {i}: {name}: {error!r}") from error
    assert refused > number / 4
