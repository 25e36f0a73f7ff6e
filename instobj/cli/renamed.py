"""Names of commands before 0.2.0: hidden, for one release, with the name that took their place."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import typer

from design.errors import InputError
from instobj.cli.bench import NAMES, run_on_bench
from instobj.cli.estimators import export_trained, train
from instobj.cli.options import HERE, TARGETS, AsJson, Out, Overrides, Specs, Workers, run_to

CHAIN = {
    "mesh": "mesh",
    "simulate": "presses",
    "compliance": "compliance",
    "identify": "identify",
    "robustness": "robustness",
    "report": "report",
}
"""Old command → its value of `run --to`."""

GONE = {
    "frames": "instobj run SPEC --to frames --set collection.kind=KIND",
    "grasp": "instobj press SPEC --jaw … --jaw … --force N",
    "slip": "instobj run SPEC --to slip --set mechanics.slip.shift_mm=[1,0,0]",
    "pretrain": "instobj train FRAMES --twin SPEC, or instobj train SPEC (no presses)",
    "twin": "instobj build SPEC --twin for simulators, instobj train FRAMES --twin SPEC for a built object",
    "worker": "instobj optimize SPEC --workers tcp://SCHEDULER:8786 (its Dask workers do the trials)",
    "experiment": "python -m studies NAME SPEC, in a checkout of the repository",
    "experiments": "python -m studies --help, in a checkout of the repository",
    "cycles": "instobj docs measured/validation (the study's figures stand there)",
    "interfaces": "instobj docs measured/validation (the study's figures stand there)",
    "conventions": "instobj adopt RECORDING --spec SPEC (order and axes of chips)",
}
"""Old commands whose arguments changed, and an option that is asked for as a command → what to write."""

OPTIONS = {
    "--address": "--page ADDRESS:PORT",
    "--baud": "--port PORT@BAUD",
    "--fault": "--simulated FAULT",
    "--join": "--workers tcp://SCHEDULER:8786",
    "--page-port": "--page PORT",
    "--seed": "--set seed=NUMBER",
    "--speed": "--replay FILE@SPEED",
    "build --mjcf": "--twin, which writes MJCF, URDF and USD",
    "build --urdf": "--twin, which writes MJCF, URDF and USD",
    "build --usd": "--twin, which writes MJCF, URDF and USD",
    "collect --cells": "--place - for each load cell",
    "collect --force": "--place FACE:X,Y=N",
    "collect --frames": "--stop 100",
    "collect --seconds": "--stop 10s",
    "collect --session": "another OUT: each recording is a session of its own",
    "collect --tips": "--place -:- for a load cell of two tips, -:-:- for three",
    "live --force": "--place FACE:X,Y=N",
    "live --remote": "--page ADDRESS:PORT alone: a token is made where other machines reach the address",
    "press --patch": "--at FACE:X,Y,DEPTH of an indenter",
    "rig --adaptive": "nothing: three strokes at all places leave as little",
    "rig --depth": "--plan depths_mm=1,2",
    "rig --dwell": "--plan dwell_s=0.5",
    "rig --full": "--plan full_n=15",
    "rig --load-scale": "--load-port PORT=SCALE",
    "rig --presses": "--plan presses=40",
    "rig --reference-every": "--plan reference_every=10",
    "rig --repeats": "--plan repeats=1",
    "rig --speed": "--plan speed_mm_s=1",
    "rig --strokes": "--plan strokes=9",
    "rig --turn": "--middle X,Y,Z,TURN",
    "score --body": "--also jaw",
    "score --shear": "--also shear",
    "train --on": "instobj train DATA, then instobj predict contacts.nc OTHER",
    "train --start": "--twin SPEC, or instobj train SPEC (no presses)",
    "store --older-than": "--free 30d",
    "validate --exchanges": "nothing: nulls have 19 permutations",
    "--storage": "--out FOLDER",
    "--unit": "--scale 10 for cm, 1000 for m, 25.4 for in",
    "--zero-frames": "--zero MODE:FRAMES",
}
"""Options before 0.2.0, of one command where it is named → what to write instead, or what holds now."""

ANYTHING = {"allow_extra_args": True, "ignore_unknown_options": True}
"""Settings of a command that takes whatever stands behind it."""


def add_renamed(app: typer.Typer, score: Callable[..., None]) -> None:
    """Add every old name to the command line, hidden."""
    for name, target in CHAIN.items():
        app.command(name, hidden=True)(_said(_chain(target), name, f"run --to {target}"))
    for name in NAMES:
        command = app.command(name, hidden=True, add_help_option=False, context_settings=ANYTHING)
        command(_bench_command(name))
    app.command("evaluate", hidden=True)(_said(train, "evaluate", "train"))
    app.command("export", hidden=True)(_said(export_trained, "export", "train --export"))
    app.command("compare", hidden=True)(_said(score, "compare", "score"))
    for name, instead in GONE.items():
        app.command(name, hidden=True, context_settings=ANYTHING)(_refusal(name, instead))


def _said(command: Callable[..., None], old: str, new: str) -> Callable[..., None]:
    """The command of the new name, which says so first."""

    @wraps(command)
    def renamed(*arguments: Any, **options: Any) -> None:
        _say(old, new)
        command(*arguments, **options)

    return renamed


def _say(old: str, new: str) -> None:
    typer.echo(f"warning: `instobj {old}` is now `instobj {new}`", err=True)


def _chain(target: str) -> Callable[..., None]:
    def command(
        specs: Specs,
        workers: Workers = "1",
        out: Out = HERE,
        as_json: AsJson = False,
        overrides: Overrides = None,
    ) -> None:
        run_to(TARGETS[target], specs, out, as_json, overrides, workers)

    return command


def _bench_command(name: str) -> Callable[..., None]:
    def command(context: typer.Context) -> None:
        _say(name, f"bench {name}")
        run_on_bench(context, name)

    return command


def _refusal(old: str, instead: str) -> Callable[..., None]:
    def command(context: typer.Context) -> None:
        raise InputError(f"`instobj {old}` is no command. Write: {instead}")

    return command
