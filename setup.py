"""Builds the compiled part of the Python module by CMake; pyproject.toml says all else."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parent


def number_of_jobs():
    """As many as there are cores, and memory: a compiler takes up to 2.5 GB."""
    jobs = os.cpu_count() or 1
    try:
        memory = os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return jobs
    return max(1, min(jobs, int(memory / 2.5e9)))


class Build_by_CMake(build_ext):
    """In a folder of its own, or in the one that SEAMLESS_SNAPPING_BUILD_DIR names."""

    def build_extension(self, extension):
        given = os.environ.get("SEAMLESS_SNAPPING_BUILD_DIR")
        build = pathlib.Path(given or self.build_temp).resolve()
        if not given:
            build.mkdir(parents=True, exist_ok=True)
            options = [f"-DSEAMLESS_SNAPPING_{name}=OFF" for name in
                       ("BUILD_TESTS", "BUILD_EXAMPLES", "BUILD_PROGRAM", "BUILD_BENCHMARKS", "INSTALL")]
            options += ["-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG", f"-DPython_EXECUTABLE={sys.executable}"]
            if shutil.which("ninja"):
                options += ["-G", "Ninja"]
            subprocess.run(["cmake", "-S", str(SOURCE), "-B", str(build), *options], check=True)
        subprocess.run(["cmake", "--build", str(build), "--target", "seamless_python",
                        "--config", "Release", "--parallel", str(number_of_jobs())], check=True)
        (module,) = (build / "python" / "seamless").glob("_core.*")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(module, target)


VERSION = re.search(r"VERSION (\d+\.\d+\.\d+)\n", (SOURCE / "CMakeLists.txt").read_text()).group(1)
setup(version=VERSION, ext_modules=[Extension("seamless._core", [])],
      cmdclass={"build_ext": Build_by_CMake})
