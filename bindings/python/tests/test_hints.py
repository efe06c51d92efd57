"""Tests that all public names of the package have type hints and docstrings."""

import importlib
import inspect

import pytest

MODULES = ("case", "errors", "result", "table", "running", "datasets", "systems", "signals", "plot", "_signals_plot")


def functions(module):
    """Returns the public functions of a module and of its classes, by their names."""
    for name in module.__all__:
        offered = getattr(module, name)
        yield name, offered
        for own, member in vars(offered).items() if inspect.isclass(offered) else ():
            if not own.startswith("_") or own == "__init__":
                yield f"{name}.{own}", getattr(member, "fget", None) or getattr(member, "func", member)


@pytest.mark.parametrize("name", MODULES)
def test_public_functions_have_hints(name):
    module = importlib.import_module(f"whirl.{name}")
    seen = 0
    for title, function in functions(module):
        if not inspect.isfunction(function) or function.__module__ != module.__name__:
            continue
        signature = inspect.signature(function)
        for parameter in signature.parameters.values():
            free = parameter.name == "self" or parameter.kind is parameter.VAR_KEYWORD
            assert free or parameter.annotation is not parameter.empty, f"{title}: {parameter.name}"
        if not title.endswith("__init__"):
            assert signature.return_annotation is not signature.empty, title
            assert function.__doc__, title
        seen += 1
    assert seen > 0
