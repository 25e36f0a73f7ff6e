"""Shapes and types of every annotated function and dataclass, enforced in its first calls in every test.

A check of shapes costs some 0.1 ms: inner loops, which call one function thousands of times, took
most of the time of the tests. Functions without shapes go to beartype alone, some 50 times as quick.
A function's check is built when it is first called: all of them would take 8 s of every process.
"""

from contextlib import suppress
from dataclasses import is_dataclass
from functools import wraps
from inspect import isasyncgenfunction, isfunction, isgeneratorfunction
from typing import get_type_hints

import jaxtyping
from beartype.roar import BeartypeCallHintViolation

CALLS = 5
"""Of a function in a test that are checked; and in each fixture's setup, as part of its test."""
TESTS = 20
"""Of a process, in which that many are; in later ones the first call alone, as many functions are
called in most tests."""

_test = 0
_called = {}
"""Name of a function → the test that called it last, calls left to check, and how many tests called it."""
_builders = []
"""Of checks; closures, which a line makes again and again, are left out."""


def next_test():
    """Begin to count anew."""
    global _test
    _test += 1


def called():
    """Module and name of each function that was called."""
    return {name for name, (_, _, tests) in _called.items() if tests}


def called_in_test():
    """Those of `called` that were called since the last test began."""
    return {name for name, (test, _, _) in _called.items() if test == _test}


def install(packages):
    """Check the functions of packages that are imported from now on."""
    jaxtyping.jaxtyped = _first_calls(jaxtyping.jaxtyped)
    jaxtyping.install_import_hook(packages, "beartype.beartype")


def _first_calls(jaxtyped):
    def decorator(*, typechecker):
        def with_shapes(plain):
            return jaxtyped(plain, typechecker=typechecker)

        def checked(plain):
            try:
                shapes = _names_shapes(plain)
            except NameError:  # stands for type checkers alone, which jaxtyping takes for any type
                return with_shapes(plain)
            if isgeneratorfunction(plain) or isasyncgenfunction(plain):
                return with_shapes(plain) if shapes else typechecker(plain)
            form = typechecker(plain)
            return _of_one_size(form, jaxtyped("context")) if shapes else form

        def counted(plain):
            if isfunction(plain):
                return _counted(plain, checked)
            if not is_dataclass(plain):
                return with_shapes(plain)
            plain.__init__ = _counted(plain.__init__, checked)
            return plain

        return counted

    return decorator


def _names_shapes(function):
    return "jaxtyping" in repr(get_type_hints(function))


def _of_one_size(form, context):
    """Names of axes stand for one size in a call.

    As jaxtyping's own decorator, which builds two checks of each function and looks at what is given
    to it twice, in order to say more of an error.
    """

    def call(*args, **kwargs):
        with context:
            try:
                return form(*args, **kwargs)
            except BeartypeCallHintViolation as error:
                raise jaxtyping.TypeCheckError(str(error)) from error

    return call


def _counted(plain, checked):
    """Functions that a line makes again and again, such as closures, count as one."""
    called = _called.setdefault((plain.__module__, plain.__qualname__), [-1, 0, 0])
    form = None

    def build():
        nonlocal form
        form = form or checked(plain)

    if "<locals>" not in plain.__qualname__:
        _builders.append(build)

    @wraps(plain)
    def call(*args, **kwargs):
        nonlocal form
        if called[0] != _test:
            called[:] = _test, CALLS if called[2] < TESTS else 1, called[2] + 1
        if not called[1]:
            return plain(*args, **kwargs)
        called[1] -= 1
        build()
        return form(*args, **kwargs)

    return call


def build_all():
    """Of all functions that are imported, for a process whose forks would each build their own."""
    while _builders:
        with suppress(NameError):  # of names for type checkers alone
            _builders.pop()()
