"""What README and manual show in Python runs, and what is public has a description."""

import ast
import importlib.machinery
import importlib.util
import inspect
import pathlib
import re

import cut_locus
import meshes
import numpy as np
import pytest
from cut_locus import _core

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCED = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
DOXYGEN = re.compile(r"^\\code\{\.py\}\n(.*?)^\\endcode", re.MULTILINE | re.DOTALL)
TEXTS = {
    "README.md": FENCED,
    "python/README.md": FENCED,
    "doc/Surface_mesh_cut_locus/Python.txt": DOXYGEN,
    "doc/Surface_mesh_cut_locus/Logarithmic_map.txt": DOXYGEN,
    "doc/Surface_mesh_cut_locus/Isolines.txt": DOXYGEN,
    "doc/Surface_mesh_cut_locus/Voronoi.txt": DOXYGEN
}


@pytest.mark.parametrize("name", TEXTS)
def test_code(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # it writes files
    parts = TEXTS[name].findall((ROOT / name).read_text())
    assert parts
    names = {**dict(zip("VF", meshes.torus(24, 12))), "np": np}
    for part in parts:
        exec(part, names)


def test_table():
    """The tables of the README are those of the committed results."""
    name = "benchmark_python"
    loader = importlib.machinery.SourceFileLoader(name, str(ROOT / "scripts" / name))
    benchmark = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(benchmark)
    text = (ROOT / "python/README.md").read_text()
    assert "| faces | " + benchmark.table() in text
    assert "| faces of one mesh | " + benchmark.overhead_table() in text


def test_descriptions():
    for name in cut_locus.__all__:
        public = getattr(cut_locus, name)
        assert inspect.getdoc(public), name
        is_enumeration = hasattr(public, "__members__")  # their description has the members
        for member, value in vars(public).items() if inspect.isclass(public) and not is_enumeration else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member}"


def test_stubs():
    """The stubs of the C++ part name what it has, and nothing else."""
    stubs = ast.parse((pathlib.Path(cut_locus.__file__).parent / "_core.pyi").read_text())
    classes = {node.name: node for node in stubs.body if isinstance(node, ast.ClassDef) and node.name[0] != "_"}
    functions = {node.name for node in stubs.body if isinstance(node, ast.FunctionDef)}
    assert set(classes) | functions | {"solver_names"} == {name for name in vars(_core) if name[0] != "_"}
    for name, node in classes.items():
        functions = {f.name for f in node.body if isinstance(f, ast.FunctionDef)}
        if node.bases:  # enumerations and errors
            assert not functions
            continue
        assert functions - {"__init__"} == {f for f in vars(getattr(_core, name)) if f[0] != "_"}, name


def test_versions():
    versions = [re.search(pattern, (ROOT / name).read_text(), re.MULTILINE).group(1) for name, pattern in (
        ("CMakeLists.txt", r"^project\(.* VERSION ([\d.]+)"), ("pyproject.toml", r'^version = "(.*)"'))]
    assert versions == 2 * [cut_locus.__version__]


def test_installed_files():
    folder = pathlib.Path(cut_locus.__file__).parent
    assert (folder / "py.typed").exists() and (folder / "_core.pyi").exists()
