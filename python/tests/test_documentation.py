"""What README and manual show in Python runs, and what is public has a description."""

import inspect
import pathlib
import re

import cut_locus
import meshes
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCED = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
DOXYGEN = re.compile(r"^\\code\{\.py\}\n(.*?)^\\endcode", re.MULTILINE | re.DOTALL)
TEXTS = {
    "README.md": FENCED,
    "python/README.md": FENCED,
    "doc/Surface_mesh_cut_locus/Surface_mesh_cut_locus.txt": DOXYGEN
}


@pytest.mark.parametrize("name", TEXTS)
def test_code(name):
    parts = TEXTS[name].findall((ROOT / name).read_text())
    assert parts
    names = dict(zip("VF", meshes.torus(24, 12)))
    for part in parts:
        exec(part, names)


def test_descriptions():
    for name in cut_locus.__all__:
        public = getattr(cut_locus, name)
        assert inspect.getdoc(public), name
        for member, value in vars(public).items() if inspect.isclass(public) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member}"
