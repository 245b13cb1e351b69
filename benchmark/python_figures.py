#!/usr/bin/env python3
"""Prints the figures of the Python module that its page in the manual shows.

usage: PYTHONPATH=build/python python_figures.py [--million]

With --million, a mesh of a million triangles is remeshed, and a hundred meshes in two threads, too.
"""

import concurrent.futures
import os
import resource
import subprocess
import sys
import tempfile
import time
import zipfile

import numpy as np

import seamless


def seconds(function, runs=3):
    """The least time of a function, and its last result."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        result = function()
        times.append(time.perf_counter() - start)
    return min(times), result


def print_import():
    command = lambda code: [sys.executable, "-c", code]
    run = lambda code: seconds(lambda: subprocess.run(command(code), check=True), 5)[0]
    print(f"import: {run('import seamless') - run('pass'):.2f} s, "
          f"{run('import numpy') - run('pass'):.2f} s of these for NumPy")


def print_size():
    folder = os.path.dirname(seamless.__file__)
    with tempfile.TemporaryFile() as file:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for name in os.listdir(folder):
                if os.path.isfile(os.path.join(folder, name)):
                    archive.write(os.path.join(folder, name), name)
        print(f"archive: {file.tell() / 1e6:.1f} MB")


def print_overhead():
    """Time that is not that of the steps which the core reports: conversions, and a thread."""
    V, F = seamless.examples.torus(250, 200)
    F2, uv = seamless.examples.inexact_map(250, 200)
    calls = {"quad_remesh": lambda: seamless.quad_remesh(V, F, quads=5000, report=True),
             "parametrize": lambda: seamless.parametrize(V, F, report=True),
             "snap": lambda: seamless.snap(F2, uv, report=True)}
    for name, call in calls.items():
        time_of_call, result = seconds(call)
        steps = sum(result[-1]["step_times"].values())
        print(f"{name}, {len(F)} triangles: {time_of_call:.2f} s, "
              f"{steps:.2f} s in steps of the core, {100 * (time_of_call / steps - 1):.1f} % more")


def print_million():
    V, F = seamless.examples.torus(1000, 500)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    time_of_call, (_, Q) = seconds(lambda: seamless.quad_remesh(V, F), 1)
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(f"quad_remesh, {len(F)} triangles to {len(Q)} quads: {time_of_call:.0f} s, "
          f"{(after - before) / 1e6:.1f} GB, arrays {(V.nbytes + F.nbytes) / 1e9:.2f} GB")


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
    print_hundred()
