"""The examples of all docstrings print what they say."""

import doctest
import importlib
import pkgutil

import pytest

import seamless

NAMES = [module.name for module in pkgutil.iter_modules(seamless.__path__)]


@pytest.mark.parametrize("name", NAMES)
def test_docstrings(name):
    result = doctest.testmod(importlib.import_module("seamless." + name))
    assert result.failed == 0


def test_all_functions_have_examples():
    for name in seamless.__all__:
        function = getattr(seamless, name)
        if callable(function) and not isinstance(function, type):
            assert ">>> " in function.__doc__, name
