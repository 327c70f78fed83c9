"""The examples run, and draw what they say."""

import os
import pathlib
import subprocess
import sys

import cut_locus
import pytest

examples = pathlib.Path(__file__).resolve().parents[1] / "examples"
with_module = {**os.environ, "PYTHONPATH": str(pathlib.Path(cut_locus.__file__).resolve().parents[1])}  # the one under test


@pytest.mark.parametrize("script", sorted(examples.glob("*.py")), ids=lambda script: script.stem)
def test_script(script, tmp_path):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "picture.png"
    subprocess.run([sys.executable, script, picture], check=True, cwd=tmp_path, env=with_module)
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("notebook", sorted(examples.glob("*.ipynb")), ids=lambda notebook: notebook.stem)
def test_notebook(notebook):
    pytest.importorskip("matplotlib")
    pytest.importorskip("ipykernel")
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    content = nbformat.read(notebook, as_version=4)
    code = [cell for cell in content.cells if cell.cell_type == "code"]
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code), "it is kept without outputs"
    nbclient.NotebookClient(content, timeout=300, kernel_name="python3").execute(env=with_module)  # which raises what a cell does
    pictures = [output for cell in code for output in cell.outputs if "image/png" in output.get("data", {})]
    assert len(pictures) >= 7
