"""doc/python.md: its blocks run one after the other, as a reader would."""

import re

import pytest

from thelma import planar_exact, program


def test_document(tmp_path, monkeypatch):
    """In a folder that looks like the checkout."""
    pytest.importorskip("vtk")
    pytest.importorskip("pandas")
    for name in ("prm", "meshes"):
        (tmp_path / name).symlink_to(program.CHECKOUT / name)
    monkeypatch.chdir(tmp_path)
    text = (program.CHECKOUT / "doc/python.md").read_text(encoding="utf8")
    blocks = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert len(blocks) > 5
    names = {}
    for block in blocks:
        exec(compile(block, "doc/python.md", "exec"), names)  # pylint: disable=exec-used
    assert names["below"] < planar_exact.limit_point(names["material"], 353.0).e < names["above"]
    assert (tmp_path / "output/film.png").stat().st_size > 1e4
    assert names["found"].values[0] == pytest.approx(20.0, rel=0.05)
