#!/usr/bin/env python3
"""Prints the figures of the Python module that its page in the manual shows.

usage: PYTHONPATH=build/python python_figures.py [--million]

With --million, a mesh of a million triangles is remeshed, a call for it is interrupted, and a
hundred meshes are remeshed in two threads, too.
"""

import concurrent.futures
import os
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
import zipfile

import numpy as np

import seamless


def seconds(function, runs=5):
    """The time and the result of the fastest run of a function, which others disturbed least."""
    fastest = None
    for _ in range(runs):
        start = time.perf_counter()
        result = function()
        time_of_run = time.perf_counter() - start
        if fastest is None or time_of_run < fastest[0]:
            fastest = time_of_run, result
    return fastest


def cpu_seconds(code, runs=10):
    """The least time that the processor spends on a program, whatever else it does meanwhile."""
    times = []
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", code], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(times)


def print_import():
    nothing = cpu_seconds("pass")
    print(f"import: {cpu_seconds('import seamless') - nothing:.2f} s, "
          f"{cpu_seconds('import numpy') - nothing:.2f} s of these for NumPy")


def print_size():
    folder = os.path.dirname(seamless.__file__)
    with tempfile.TemporaryFile() as file:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for name in os.listdir(folder):
                if os.path.isfile(os.path.join(folder, name)):
                    archive.write(os.path.join(folder, name), name)
        print(f"archive: {file.tell() / 1e6:.1f} MB")


def print_overhead():
    """The time of a call beside the compiled core, which the report of the same call tells: for
    checks, conversions, and a thread."""
    V, F = seamless.examples.torus(250, 200)
    F2, uv = seamless.examples.inexact_map(250, 200)
    calls = {"quad_remesh": lambda: seamless.quad_remesh(V, F, quads=5000, report=True),
             "parametrize": lambda: seamless.parametrize(V, F, report=True),
             "snap": lambda: seamless.snap(F2, uv, report=True)}
    for name, call in calls.items():
        time_of_call, result = seconds(call)
        in_core = result[-1]["seconds_in_core"]
        print(f"{name}, {len(F)} triangles: {time_of_call:.3f} s, {in_core:.3f} s in the core, "
              f"{100 * (time_of_call / in_core - 1):.1f} % more")


def print_million():
    V, F = seamless.examples.torus(1000, 500)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    of_processor = time.process_time()
    time_of_call, (_, Q) = seconds(lambda: seamless.quad_remesh(V, F), 1)
    of_processor = time.process_time() - of_processor
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"quad_remesh, {len(F)} triangles to {len(Q)} quads: {time_of_call:.0f} s, "
          f"{of_processor:.0f} s of the processor, {(after - before) / 1e6:.1f} GB, "
          f"arrays {(V.nbytes + F.nbytes) / 1e9:.2f} GB")


def print_interruption():
    V, F = seamless.examples.torus(1000, 500)
    pressed = []

    def press():
        time.sleep(10)
        pressed.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    signal.signal(signal.SIGINT, signal.default_int_handler)  # which jobs in the background lack
    threading.Thread(target=press).start()
    try:
        seamless.quad_remesh(V, F)
        print("Ctrl-C: OTHER end")
    except KeyboardInterrupt:
        of_call = time.perf_counter() - pressed[0]
        seamless._core.wait_for_interrupted_calls()
        of_thread = time.perf_counter() - pressed[0]
        print(f"Ctrl-C after 10 s: the call ends after {of_call:.2f} s, its thread after "
              f"{of_thread:.1f} s")


def print_hundred():
    rng = np.random.default_rng(1)
    meshes = [seamless.examples.torus(int(n), 24) for n in rng.integers(30, 90, 100)]
    work = lambda mesh: seamless.quad_remesh(*mesh, quads=500)
    one, expected = seconds(lambda: list(map(work, meshes)), 1)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        two, found = seconds(lambda: list(pool.map(work, meshes)), 1)
    same = all((a == b).all() for x, y in zip(expected, found) for a, b in zip(x, y))
    print(f"a hundred meshes: {one:.1f} s in one thread, {two:.1f} s in two, "
          f"{'the same' if same else 'OTHER'} results")


print_import()
print_size()
print_overhead()
if "--million" in sys.argv[1:]:
    print_million()
    print_interruption()
    print_hundred()
