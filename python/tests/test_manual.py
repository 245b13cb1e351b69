"""The code that the manual and the README show runs, from the first line to the last."""

import re

import pytest

from conftest import SOURCE


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
    print(capsys.readouterr().out)
