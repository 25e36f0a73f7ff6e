"""A specification to start from: what is asked for, placed so that it can be made."""

from __future__ import annotations

import difflib
import re
import time
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from itertools import chain, islice, tee
from math import inf
from pathlib import Path
from typing import Any

import numpy as np

from design.body.imported import body_of_file
from design.body.kinds.registry import KINDS
from design.catalogue.printers import PRINTERS
from design.errors import InputError
from design.fabrication.finding import Finding
from design.files import atomic_path
from design.fit.roughness import roughness_in_words
from design.fit.seam import seam_azimuth_deg, windows_deg
from design.layout.body import body_of
from design.layout.mould.frame import (
    COMPLIANCE_FRACTION,
    mould_style,
    undercut_depth_mm,
)
from design.layout.places.coverage import covered_share
from design.placement.asked import placements
from design.placement.exact_kinds import exact_kind_in_words
from design.placement.hooking import (
    castable_request,
    hooked_by_azimuth_mm,
    turned,
)
from design.placement.objects import Request, Tables, relaid, spec_of
from design.placement.room import narrow_heads
from design.spec.body import BodySpec
from design.spec.fabrication import PrinterSpec
from design.spec_io import load_spec
from estimator.layouts.without_mesh import first_score
from instobj.commands.first_layout import parts_that_help, scored_first
from instobj.commands.outlook import (
    chosen_text,
    expected_text,
    memory_text,
    next_step_text,
    with_edges_that_fit,
)
from instobj.commands.specification_file import specification_text
from instobj.store.progress import ProgressLine
from instobj.store.publish import require_writable

Made = tuple[Tables, list[Finding]]
_TURNS_DEG = (6.0, -6.0, 12.0, -12.0, 18.0, -18.0, 30.0, -30.0, 45.0, -45.0, 60.0, -60.0, 90.0)
_MOST_TURNS = 2
"""Turns of a mould's seam that are tried (degrees), and how many of them for each shell."""
_MOST_RELAID, _MOST_CHECKED = 6, 2
"""Layouts of magnets that are tried of a shell where no seam leaves walls, and how many are checked."""
_BED = "fits the bed"
_OF_THE_BODY = {"undercut", _BED}
"""Checks that fail by the shape or size of a body, wherever its parts are."""


def new_specification(
    name: str,
    out: Path,
    request: Request | None = None,
    design: Callable[[Request], Made] | None = None,
) -> Path:
    """Write `NAME.toml`: the paper's cube, or what is requested, with the keys that matter first.

    A name that ends in ".toml" is taken without it. `design` gives tables of a request and what fails of
    them (`designed`).

    Raises
    ------
    InputError
        The name cannot be a folder's name, the file is already there, or the size does not work.
    StoreError
        Nothing can be written to `out`.
    """
    name = name.removesuffix(".toml")  # somebody names the file
    target = out / f"{name}.toml"
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,79}", name):
        raise InputError(
            f"{name!r} cannot name an object: start with a letter or digit, then letters, digits, "
            "'_', '.', '-' (80 at most)"
        )
    castable = out / f"{name}_castable.stl"
    for path in (target, castable) if request and request.file else (target,):
        if path.exists():
            raise InputError(f"{path} is already there. Choose another name, or move it away")
    require_writable(out)  # before parts are placed, which takes long
    tables: Tables | None = None
    if request is not None:
        try:
            if request.file:
                # asks for the file's unit first, if need be
                BodySpec(kind=request.kind, size_mm=request.size_mm, **dict(request.file))
                exact = exact_kind_in_words(request)
                request, changed = castable_request(request, castable)
                for text in filter(None, (changed, exact)):
                    warnings.warn(text, stacklevel=2)
            tables, failed = (design or designed)(request)
        except BaseException:
            if request.file:
                castable.unlink(missing_ok=True)
            raise
        tables = with_edges_that_fit(request, tables)
        usual, request = request.sensors, _with_sensors_of(request, tables)
        if request.sensors < usual:
            warnings.warn(
                f"{usual} sensors find no room on a face; {request.sensors} do",
                stacklevel=2,
            )
        if any(finding.check != _BED for finding in failed):
            warnings.warn(told_unmade(failed, tables), stacklevel=2)
        for text in roughness_in_words(spec_of(tables)) if request.file else ():
            warnings.warn(text, stacklevel=2)
        if "sensed_faces" in tables["body"]:
            warnings.warn(_left_out_faces(request, tables["body"]["sensed_faces"]), stacklevel=2)
        short_mm = max((-finding.value for finding in failed if finding.check == _BED), default=0.0)
        if short_mm > 0:
            tables, text = _with_larger_bed(tables, short_mm)
            warnings.warn(text, stacklevel=2)
    with atomic_path(target) as temporary:
        temporary.write_text(specification_text(name, out, tables), encoding="utf-8")
    return target


def placed_text(path: Path, request: Request | None = None) -> str:
    """Say in few lines what a written specification holds, the bounds to expect, which parts would bring
    them within the limit where they were placed by a `request`, and what the next step takes."""
    spec, helps = load_spec(path, []), ""
    score = first_score(spec)
    if request is not None:
        if request.file:  # a scan may have been made castable
            file = (("file", spec.body.file), ("scale", spec.body.scale))
            request = replace(request, size_mm=spec.body.size_mm, file=file)
        request = replace(request, sensors=spec.sensors.count_per_face)
        with _timed_stage(ProgressLine(), "what more parts would bring"):
            helps = parts_that_help(request, spec, score)
    lines = (
        f"{spec!r}".removeprefix("ObjectSpec "),
        chosen_text(spec, placed=request is not None),
        expected_text(spec, score),
        f"contact locations cover {100 * covered_share(spec):.0f} % of the sensed surface",
        helps,
        next_step_text(spec),
        memory_text(spec),
    )
    return "\n".join(filter(None, lines))


def made(request: Request) -> tuple[Tables, list[Finding]]:
    """Placed tables that can be made, as `check --fabrication` says, and no findings; else those with the
    fewest that failed, and these.

    Of each shell a few seams of its mould are tried that neither hook the body nor, by their numbers,
    leave thin walls next to pins and holes; where no shell has one that can be made, magnets elsewhere.
    """
    best: tuple[Tables, list[Finding]] | None = None
    previous, tried = set[str](), list[Tables]()
    for placement in placements(request):
        tried.append(placement)
        checked = _checked_seams(placement)
        if checked is None:
            continue
        best = checked if best is None or len(checked[1]) < len(best[1]) else best
        checks = _checks(checked)
        if not checks or checks <= _OF_THE_BODY:
            return best
        if checks == previous and not all(map(_thin_mould, checked[1])):
            return best
        previous = checks
    if best is None or all(map(_thin_mould, best[1])):
        best = _made_with_magnets_elsewhere(request, tried) or best
    return best or _checked(islice(seams_of(tried[0]), 1)) or (tried[0], [])


def designed(request: Request) -> Made:
    """Tables of a request where its parts are seen best and can be made, and what fails of `check
    --fabrication` where nothing can.

    The most generous shell that takes everything is the start; where what is found under it cannot be
    made, what rules place so that it can.
    """
    progress = ProgressLine()
    with _timed_stage(progress, "places by rules"):
        placed = next(placements(request))
    request = _with_sensors_of(request, placed)
    layouts, again = tee(scored_first(request, placed))
    best = _first_that_can_be_made(layouts, _OF_THE_BODY, progress)
    if best is not None:
        return best
    with _timed_stage(progress, "other shells and seams, checked for fabrication"):
        by_rules = made(request)
    if by_rules[0] != placed or by_rules[1]:
        layouts = again if by_rules[0] == placed else scored_first(request, by_rules[0])
        best = _first_that_can_be_made(layouts, _checks(by_rules), progress)
    return by_rules if best is None or len(best[1]) > len(by_rules[1]) else best


def _with_sensors_of(request: Request, tables: Tables) -> Request:
    """Return a request that takes fewer sensors for as many as tables have."""
    if not request.takes_fewer:
        return request
    return replace(request, sensors=spec_of(tables).sensors.count_per_face)


@contextmanager
def _timed_stage(progress: ProgressLine, title: str) -> Iterator[None]:
    """Show a stage while it works, and afterwards its time."""
    began = time.perf_counter()
    with progress.stage(title):
        yield
    progress.say(f"{title}: {time.perf_counter() - began:.0f} s")


def _first_that_can_be_made(
    layouts: Iterator[Tables], but: set[str], progress: ProgressLine
) -> Made | None:
    """The first of some layouts of which nothing fails `but` these checks; None of none."""
    while True:
        with _timed_stage(progress, "better places for magnets and sensors"):
            tables = next(layouts, None)
        if tables is None:
            return None
        with _timed_stage(progress, "checks of fabrication"):
            # a wall that numbers find thin may be thick enough as a solid
            checked = _checked_seams(tables, but) or _checked(islice(seams_of(tables), 1), but)
        if checked is not None and _checks(checked) <= but:
            return checked


def _badness(checked: Made, but: set[str] | None) -> tuple[bool, int]:
    """Return whether a check fails that may not, after which no more are made; and how many fail."""
    return bool(_checks(checked) - (but or set())), len(checked[1])


def _checks(checked: Made) -> set[str]:
    return {finding.check for finding in checked[1]}


def _checked_seams(tables: Tables, but: set[str] | None = None) -> Made | None:
    """The first of some seams that can be made."""
    return _checked(islice(filter(leaves_walls, seams_of(tables)), 1 + _MOST_TURNS), but)


def _made_with_magnets_elsewhere(
    request: Request, tried: list[Tables]
) -> tuple[Tables, list[Finding]] | None:
    """The first of some that can be made; None of none."""
    parted = filter(parts_somewhere, tried)
    layouts = chain.from_iterable(islice(relaid(request, old), _MOST_RELAID) for old in parted)
    seams = (next(filter(leaves_walls, seams_of(layout)), None) for layout in layouts)
    for tables in islice(filter(None, seams), _MOST_CHECKED):
        checked = _checked([tables])
        if checked is not None and not checked[1]:
            return checked
    return None


def _checked(seams: Iterable[Tables], but: set[str] | None = None) -> Made | None:
    """The first of these that can be made, else the one with the fewest failures, and these; None of none.

    The next is tried where walls of the mould alone are too thin. With `but`, what fails another check is
    not looked at further.
    """
    from design.fabrication.check import check_fabrication

    best: Made | None = None
    for tables in seams:
        findings = check_fabrication(spec_of(tables), but=but).findings
        failed = [finding for finding in findings if finding.status == "fail"]
        checked = tables, failed
        if best is None or _badness(checked, but) < _badness(best, but):
            best = checked
        if not failed or not all(map(_thin_mould, failed)):
            break
    return best


def seams_of(tables: Tables) -> Iterator[Tables]:
    """Yield the layout as placed, then with the seam of the mould turned either way.

    Turns that hook less of the body come first (a fluted vase's by a whole flute); none hooks it deeper than
    it gives way, or than as placed.
    """
    spec = spec_of(tables)
    if body_of(spec).from_file and mould_style(spec) == "split":
        yield from _seams_of_a_file(tables, COMPLIANCE_FRACTION * spec.shell.thickness_mm)
        return
    yield tables
    if mould_style(spec) != "split":
        return
    room_mm = max(undercut_depth_mm(spec), COMPLIANCE_FRACTION * spec.shell.thickness_mm)
    azimuths = [round(seam_azimuth_deg(spec) + turn, 1) for turn in _TURNS_DEG]
    yield from _least_hooked(tables, azimuths, room_mm)
    yield from _least_hooked(tables, windows_deg(spec), room_mm)


def _least_hooked(tables: Tables, azimuths: list[float], room_mm: float) -> Iterator[Tables]:
    """Yield the layout with its seam at azimuths that hook no deeper than the silicone has room; the least
    hooked first."""
    turns = [turned(tables, azimuth) for azimuth in azimuths]
    hooked = [undercut_depth_mm(spec_of(turn)) for turn in turns]
    # facets of a ball hook it by some hundredths
    order = np.argsort(np.round(hooked, 1), kind="stable")
    yield from (turns[k] for k in order if hooked[k] <= room_mm)


def _seams_of_a_file(tables: Tables, room_mm: float) -> Iterator[Tables]:
    """Yield layouts whose halves hook the body no deeper than it gives way; the least hooked first.

    The layout as placed, where the seam hooks the least area, leads if it is among them or alone.
    """
    placed_yields = undercut_depth_mm(spec_of(tables)) <= room_mm
    if placed_yields:
        yield tables
    hooked = hooked_by_azimuth_mm(tables)
    yielding = sorted((depth, azimuth) for azimuth, depth in hooked.items() if depth <= room_mm)
    yield from (turned(tables, azimuth) for _, azimuth in yielding)
    if not (placed_yields or yielding):
        yield tables


def parts_somewhere(tables: Tables) -> bool:
    """Return whether any seam of a file's body hooks it no deeper than it gives way."""
    spec = spec_of(tables)
    if not body_of(spec).from_file or mould_style(spec) != "split":
        return True
    room = COMPLIANCE_FRACTION * spec.shell.thickness_mm
    return any(depth <= room for depth in hooked_by_azimuth_mm(tables).values())


def leaves_walls(tables: Tables) -> bool:
    """Return whether the mould's walls can be printed, and the heads on which its pins rest.

    Pins, pouring holes and vents leave thin walls to the seam or to each other.
    """
    from design.layout.mould.pins import pins_thin_the_seam
    from design.mould.openings import holes_thin_walls

    spec = spec_of(tables)
    return not (narrow_heads(spec) or pins_thin_the_seam(spec) or holes_thin_walls(spec))


def _thin_mould(finding: Finding) -> bool:
    return finding.check == "thinnest wall" and finding.part.startswith("mould")


def told_unmade(failed: list[Finding], tables: Tables) -> str:
    lines = "".join(f"\n  - {finding.told}. {finding.what}" for finding in failed)
    text = "check --fabrication fails on this body, in whatever of the ways of placing that help:"
    if all(map(_thin_mould, failed)):
        return f"{text}{lines}{_why_seams_do_not_help(tables)}"
    return f"{text}{lines}"


def _why_seams_do_not_help(tables: Tables) -> str:
    """Return why no turn of the mould's seam makes walls that are too thin thicker; empty without a seam."""
    if mould_style(spec_of(tables)) != "split":
        return ""
    most = f"turned by up to {max(_TURNS_DEG):g}°"
    if "mould" not in tables and not any(map(leaves_walls, seams_of(tables))):
        return (
            f"\nThe mould's seam, {most}, meets a pin, a pouring hole or a vent wherever it goes, and leaves "
            "a thin wall next to it"
        )
    return f"\nThe mould's seam, {most} to where pins and holes leave it walls, does not make them thicker"


def request_of(
    kind: str | None = None,
    size_mm: tuple[float, float, float] | None = None,
    sensors: int | None = None,
    magnets: int | None = None,
    file: Path | None = None,
    scale: float | None = None,
) -> Request | None:
    """Return what the options of `instobj new` ask for; None where none is given.

    Raises
    ------
    InputError
        Options that do not go together, or a file that holds no closed body.
    """
    if kind is None and file is not None:
        kind = next(name for name, body in KINDS.items() if body.from_file)
    if kind is None and size_mm is None and file is None:
        _refuse_alone("with --kind and --size, or with --from", sensors=sensors, magnets=magnets)
    if file is None:
        _refuse_alone("with --from FILE", scale=scale)
    if kind is None and size_mm is None:
        return None
    for option, count in (("sensors", sensors), ("magnets", magnets)):
        if count is not None and count < 1:
            raise InputError(
                f"--{option} must be 1 or more; got {count}. Leave it out for as many as fit"
            )
    kind = kind or BodySpec().kind
    if kind not in KINDS:
        raise InputError(f"--kind {kind} is not known. {_kind_that_is_meant(kind)}")
    if scale is not None and not 0 < scale < inf:
        raise InputError(f"--scale must be above 0 and finite; got {scale:g}. Leave it out for 1")
    if KINDS[kind].from_file != (file is not None):
        read = next(name for name, body in KINDS.items() if body.from_file)
        raise InputError(f"--from FILE goes with --kind {read}. Give both, or neither")
    if (size_mm is None) == (file is None):
        raise InputError(
            f"--size X Y Z (mm) is given for every kind but that of a file, which has it; got "
            f"--kind {kind}{'' if size_mm is None else ' and --size'}. "
            + ("Add --size" if size_mm is None else "Leave it out, or use --scale")
        )
    request = Request(kind, size_mm or (0.0, 0.0, 0.0), magnets=magnets)
    count = request.sensors if sensors is None else sensors
    request = replace(request, sensors=count, takes_fewer=sensors is None)
    if file is None:
        return request
    mm = 1.0 if scale is None else scale
    read = body_of_file(file, mm)
    keys = (("file", read["file"]), ("scale", mm))
    return replace(request, size_mm=tuple(read["size_mm"]), file=keys)


_MEANT = {
    "cube": "box",
    "cuboid": "box",
    "block": "box",
    "ball": "sphere",
    "globe": "sphere",
    "egg": "ellipsoid",
    "can": "cylinder",
    "tube": "cylinder",
    "pill": "capsule",
    "hemisphere": "dome",
    "stl": "imported",
    "step": "imported",
}
"""Words for shapes, and the kind of body that has them."""


def _kind_that_is_meant(word: str) -> str:
    kinds = f"Choose one of {', '.join(KINDS)}"
    close = difflib.get_close_matches(word.lower(), [*KINDS, *_MEANT], n=1)
    meant = _MEANT.get(close[0], close[0]) if close else None
    return f"Did you mean {meant}? {kinds}" if meant in KINDS else kinds


def size_of(text: str, kind: str | None) -> tuple[float, float, float]:
    """The three edges (mm) that options give: apart, or joined as 60x60x85; one of a sphere or a cube.

    Raises
    ------
    InputError
        Another number of edges, or something that is no length above 0.
    """
    words = re.split(r"[x×,; ]+", text.strip())
    example = "write --size 70 50 35"
    try:
        edges = [float(word.removesuffix("mm")) for word in words]
    except ValueError:
        raise InputError(f"--size is three lengths in mm; got {text}: {example}") from None
    if len(edges) == 1 and kind in ("sphere", "box"):
        edges *= 3
    if len(edges) != 3:
        raise InputError(
            f"--size is three lengths in mm, along x, y and z; got {len(edges)}: {text}. "
            f"For instance, {example}"
        )
    if not all(0 < edge < inf for edge in edges):
        raise InputError(f"--size is three lengths above 0 in mm; got {text}: {example}")
    return edges[0], edges[1], edges[2]


def _refuse_alone(goes_with: str, **options: Any) -> None:
    """Refuse options that would otherwise be without effect."""
    for name, value in options.items():
        if value is not None:
            raise InputError(
                f"--{name} {value} goes {goes_with}; got it alone. Add that, or leave it out"
            )


def _left_out_faces(request: Request, sensed: list[int]) -> str:
    """Return which faces a placement does without."""
    faces = f"{', '.join(map(str, sensed[:-1]))} and {sensed[-1]}" if sensed[1:] else str(sensed[0])
    sensors = f"{request.sensors} sensor{'s' * (request.sensors > 1)}"
    return (
        f"only face{'s' * (len(sensed) > 1)} {faces} can take {sensors} and the magnets; the others are "
        "not sensed (body.sensed_faces). Ask for fewer sensors or magnets to sense more"
    )


def _with_larger_bed(tables: Tables, short_mm: float) -> tuple[Tables, str]:
    """Return tables with the largest bed of the catalogue where parts may fit it, and what to do in words."""
    usual, large = PrinterSpec().bed_mm, max((p.bed_mm for p in PRINTERS.values()), key=min)
    beds = [" × ".join(f"{edge:g}" for edge in bed) for bed in (usual, large)]
    text = f"parts are up to {short_mm:.3g} mm too large for a printer of {beds[0]} mm"
    # which edge of a part is too long is not known here: the check says whether the large bed takes it
    if short_mm > max(b - a for a, b in zip(sorted(usual), sorted(large), strict=True)):
        return tables, f"{text}, and for one of {beds[1]} mm, which check --fabrication will say"
    changed = tables | {"printer": {"bed_mm": list(large)}}
    said = "as print services have; check --fabrication says whether that takes them"
    return changed, f"{text}: printer.bed_mm = {list(large)} is taken, {said}"
