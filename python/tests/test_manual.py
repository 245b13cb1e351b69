"""The code that the manual and the README show runs, from the first line to the last, and prints what
their comments say."""

import re

import pytest

from conftest import SOURCE


def assert_prints(printed, told):
    """The words are the same; numbers may change by a fifth with the code."""
    number = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
    assert re.split(number, printed) == re.split(number, told)
    assert [float(n) for n in re.findall(number, printed)] == \
        pytest.approx([float(n) for n in re.findall(number, told)], rel=0.2)


def test_of_prints():
    assert_prints("2 quads, 3e-09\n", "2 quads, 3e-09\n")
    for wrong in ("3 quads, 3e-09\n", "2 quads, 3e-08\n", "2 cells, 3e-09\n", ""):
        with pytest.raises(AssertionError):
            assert_prints(wrong, "2 quads, 3e-09\n")


@pytest.mark.parametrize("name, pattern", [
    ("doc/outside_of_CGAL/python.txt", r"\\code\{\.py\}\n(.*?)\\endcode"),
    ("README.md", r"```python\n(.*?)```"),
])
def test_code(name, pattern, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(pattern, (SOURCE / name).read_text(encoding="utf-8"), re.S)
    assert blocks
    names = {}
    for block in blocks:
        exec(compile(block, name, "exec"), names)
        assert_prints(capsys.readouterr().out, "".join(
            line + "\n" for line in re.findall(r"^# prints: (.*)$", block, re.M)))
