"""The group `instobj bench`, whose commands are loaded when one of them is named."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import typer
from typer.core import TyperGroup
from typer.main import get_group

MODULE = "instobj.bench.cli"
"""Module of the commands: known by name alone, so that nothing outside the room imports it."""
NAMES = ("bringup", "collect", "firmware", "live", "material", "rig", "selftest")
"""Commands that stood at top level before 0.2.0."""


class Bench(TyperGroup):
    """Group that takes its commands from their module at the first question for them."""

    @property
    def commands(self) -> Any:
        """Return name → command."""
        return get_group(import_module(MODULE).app).commands

    @commands.setter
    def commands(self, given: Any) -> None:
        """Drop the empty dictionary that Typer gives."""


def run_on_bench(context: typer.Context, name: str) -> None:
    """Run `instobj bench NAME` with what stands behind the command of `context`."""
    bench = Bench(name="bench")
    with bench.make_context("bench", [name, *context.args], parent=context.parent) as inner:
        bench.invoke(inner)
