"""Lets CMake build the extension cut_locus._core; all else is in pyproject.toml."""

import pathlib
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        source = pathlib.Path(__file__).resolve().parent / "python"
        build = pathlib.Path(self.build_temp).resolve()
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        options = ["-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}",
                   f"-DCUT_LOCUS_PYTHON_FOLDER={target.parent.parent}"]
        try:
            import pybind11
            options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:
            pass  # it may be one of the system
        build.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cmake", str(source), *options], cwd=build, check=True)
        subprocess.run(["cmake", "--build", ".", "--target", "cut_locus_python"], cwd=build, check=True)


setup(ext_modules=[Extension("cut_locus._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
