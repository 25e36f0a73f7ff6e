"""Shapes and types of every annotated function, enforced in its first calls in every test.

A check costs some 0.1 ms: inner loops, which call one function thousands of times, took most of
the time of the tests.
"""

from functools import wraps
from inspect import isfunction

import jaxtyping

CALLS = 30
"""Of a function in a test that are checked; and in each fixture's setup, as part of its test."""

_test = 0


def next_test():
    """Begin to count anew."""
    global _test
    _test += 1


def install(packages):
    """Check the functions of packages that are imported from now on."""
    jaxtyping.jaxtyped = _first_calls(jaxtyping.jaxtyped)
    jaxtyping.install_import_hook(packages, "beartype.beartype")


def _first_calls(jaxtyped):
    def decorator(*, typechecker):
        return lambda plain: _counted(plain, jaxtyped(plain, typechecker=typechecker))

    return decorator


def _counted(plain, checked):
    if not isfunction(plain):
        return checked
    test, calls = -1, 0

    @wraps(plain)
    def call(*args, **kwargs):
        nonlocal test, calls
        if test != _test:
            test, calls = _test, 0
        calls += 1
        return (checked if calls <= CALLS else plain)(*args, **kwargs)

    return call
