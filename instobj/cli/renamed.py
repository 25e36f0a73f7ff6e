"""Names of commands and options before 0.2.0, for one release: errors that say what to write."""

from __future__ import annotations

import typer

from design.errors import InputError

_CHAIN = ("mesh", "compliance", "identify", "robustness", "report")
_BENCH = ("bringup", "collect", "firmware", "live", "material", "rig", "selftest")
COMMANDS = {
    **{name: f"instobj run SPEC --to {name}" for name in _CHAIN},
    **{name: f"instobj bench {name}" for name in _BENCH},
    "simulate": "instobj run SPEC --to presses",
    "evaluate": "instobj train",
    "export": "instobj train --export",
    "compare": "instobj score A.toml B.toml",
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
"""Command before 0.2.0, or an option that is asked for as one → what to write."""

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


def add_renamed(app: typer.Typer) -> None:
    """Add every old name to the command line, hidden."""
    takes_anything = {"allow_extra_args": True, "ignore_unknown_options": True}
    for name in COMMANDS:
        command = app.command(
            name, hidden=True, add_help_option=False, context_settings=takes_anything
        )
        command(_refuse)


def _refuse(context: typer.Context) -> None:
    name = str(context.info_name)
    raise InputError(f"`instobj {name}` is no command. Write: {COMMANDS[name]}")
