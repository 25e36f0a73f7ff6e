"""Random requests for `instobj new`, each answered and held against `check --fabrication`.

What a hand holds, of every kind by turns: edges of 20 to 110 mm, one to four sensors, magnets as fit or
one to nine; files of smooth and lumpy bodies in four units. Everything follows from the seed. A size
that is refused is asked again as the refusal names it.
"""

from __future__ import annotations

import re
import resource
import time
import traceback
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from design.errors import InputError
from design.fabrication.check import check_fabrication
from design.fit.seam import seam_in_words
from design.spec.body import MM
from design.spec_io import load_spec
from instobj.commands.new import new_specification, request_of
from instobj.commands.run import check
from tests.random_designs.draw import kind_of
from tests.random_designs.foreign_shapes import foreign_shape
from tests.random_designs.summary import LONGEST_S
from tests.support.objects.random_objects import made_surface

_STREAM = 3
"""So that seeds draw other numbers than the other generators'."""
_EDGES_MM, _FILES_MM = (20.0, 110.0), (35.0, 140.0)
_MOST_S = 15 * LONGEST_S
"""Processor time of a request and of all that its refusal names, after which the seed is given up."""
_SIZE = re.compile(r"([\d.]+) × ([\d.]+) × ([\d.]+) mm\b")
_KIND = re.compile(r"--kind (\w+)(?: --size ([\d.]+) ([\d.]+) ([\d.]+))?")
_SCALE = re.compile(r"\(scale = ([\d.]+)\)")
_FEWER = re.compile(r"(\d+) (sensors?|magnets?) per face would fit")

Options = dict[str, Any]


def drawn(seed: int, folder: Path) -> Options:
    """Options of `instobj new`; a file that they name is written to the folder."""
    rng, kind = np.random.default_rng([_STREAM, seed]), kind_of(seed)
    options: Options = {"kind": kind, "sensors": int(rng.integers(1, 5))}
    if rng.random() < 0.7:
        options["magnets"] = int(rng.integers(1, 10))
    if kind == "imported":
        return options | _file(rng, folder, smooth=bool(rng.random() < 0.4))
    return options | {"size_mm": _size_mm(rng, kind)}


def _file(rng: np.random.Generator, folder: Path, smooth: bool) -> Options:
    longest = _log_uniform(rng, *_FILES_MM)
    surface = _smooth(rng, longest) if smooth else foreign_shape(rng, longest)
    unit, path = list(MM)[rng.integers(len(MM))], folder / "body.stl"
    surface.apply_scale(1 / MM[unit]).export(path)
    return {"file": str(path), "scale": MM[unit]}


def _smooth(rng: np.random.Generator, longest_mm: float) -> trimesh.Trimesh:
    """An egg with shallow waves."""
    waves = [
        {
            "along": rng.uniform(-2, 2, 3).tolist(),
            "phase": float(rng.uniform(0, 6.28)),
            "height": float(rng.uniform(-0.03, 0.03)),
        }
        for _ in range(3)
    ]
    size = longest_mm * rng.uniform(0.6, 1.0, 3)
    return made_surface({"size_mm": size.round(1).tolist(), "waves": waves})


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return round(float(np.exp(rng.uniform(np.log(low), np.log(high)))), 1)


def _size_mm(rng: np.random.Generator, kind: str) -> list[float]:
    x, y, z = (_log_uniform(rng, *_EDGES_MM) for _ in range(3))
    if kind == "pad":
        return [x, y, _log_uniform(rng, 9.0, 22.0)]
    if kind == "dome":
        return [x, x, round(x / 2 + float(rng.uniform(3.6, 12)), 1)]
    if kind == "sphere":
        return [x, x, x]
    if kind == "capsule":
        return [min(x, z), min(x, z), round(max(x, z) + 2.0, 1)]
    return [x, x, z] if kind == "cylinder" else [x, y, z]


def asked(question: dict[str, Any]) -> dict[str, Any]:
    """What became of the request of the seed in `question`.

    `outcome` is "passes" (both checks), "refused" (no room, with what would work), "told" (`new` itself
    tells which check of fabrication fails), "fails" (a check fails that `new` did not tell), "false alarm"
    (`check` warns of what does not fail), "false advice" (refused, and what is named in its place does not
    pass) or "crash". `seconds` of processor time are those
    of `new` and both checks, without what is asked after a refusal.
    """
    used = time.process_time()
    _, hard = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (int(used + _MOST_S) + 1, hard))
    folder, seed = Path(question["folder"]), question["seed"]
    options = drawn(seed, folder)
    row = answered(options, folder)
    if row["outcome"] == "refused":
        row["named"] = [answered(other, folder) for other in named(row["why"], options)]
        if any(other["outcome"] != "passes" for other in row["named"]):
            row["outcome"] = "false advice"
    return {"generator": question["generator"], "seed": seed, "kind": kind_of(seed), **row}


def answered(options: Options, folder: Path) -> dict[str, Any]:
    """Outcome of one request, why, and the processor time of `new` and of the checks."""
    started, why = time.process_time(), ""
    (path := folder / "asked.toml").unlink(missing_ok=True)
    placed = None
    try:
        outcome, why, placed = _outcome(options, path)
    except Exception:
        outcome, why = "crash", traceback.format_exc(limit=-6)
    seconds = time.process_time() - started
    shown = {key: str(value) for key, value in options.items() if key != "file"}
    row = {"outcome": outcome, "seconds": round(seconds, 1), "options": shown, "why": why}
    return row | ({} if placed is None else {"seconds_of_new": round(placed - started, 1)})


def _outcome(options: Options, path: Path) -> tuple[str, str, float | None]:
    keys = dict(options)
    if "file" in keys:
        keys["file"] = Path(keys["file"])
    if "size_mm" in keys:
        keys["size_mm"] = tuple(keys["size_mm"])
    try:
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            new_specification(path.stem, path.parent, request_of(**keys))
    except InputError as error:
        return "refused", str(error), None
    placed = time.process_time()
    told = [str(one.message) for one in heard if "fails on this body" in str(one.message)]
    try:
        spec = load_spec(path)
        check(spec)
    except InputError as error:
        return "fails", f"check: {error}", placed
    failed = [one for one in check_fabrication(spec).findings if one.status == "fail"]
    if told and failed:
        return "told", told[0], placed
    if not failed and (warned := seam_in_words(spec)):
        return "false alarm", "; ".join(warned), placed
    wrong = [f"{one.told} at {one.place_mm}" for one in failed]
    return ("fails" if wrong else "passes"), "; ".join(wrong), placed


def named(refusal: str, options: Options) -> list[Options]:
    """Requests that a refusal names in place of the one that it refuses."""
    found = list[Options]()
    for way in re.split(r"; or |\. ", refusal.split(" per face", 1)[-1]):
        if fewer := _FEWER.search(way):
            found.append(options | {fewer[2].rstrip("s") + "s": int(fewer[1])})
        elif kind := _KIND.search(way):
            edges = {"size_mm": [float(edge) for edge in kind.groups()[1:]]} if kind[2] else {}
            plain = {key: options[key] for key in options if key not in ("file", "scale")}
            found.append(plain | {"kind": kind[1]} | edges)
        elif scale := _SCALE.search(way):
            found.append(options | {"scale": float(scale[1])})
        elif size := _SIZE.search(way):
            found.append(options | {"size_mm": [float(edge) for edge in size.groups()]})
    return found
