"""A first layout by its score: places, magnets and range that a short search finds without a mesh."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from operator import itemgetter

import numpy as np

from design.body.kinds.registry import KINDS
from design.catalogue.hall_sensors import HALL_PARTS
from design.errors import InputError
from design.placement.objects import (
    COARSE,
    SHELL_VARIANTS,
    STRONGER,
    Request,
    ShellVariant,
    Tables,
    fitting_tables,
    shell_variant_of,
    spec_of,
)
from design.spec.object import ObjectSpec
from design.spec.sensors import SensorSpec
from estimator.field.seating import all_stay, gap_that_holds_mm
from estimator.layouts.without_mesh import (
    BROKEN,
    ROUNDS,
    FirstScore,
    LevelWithoutMesh,
    coarse,
    first_score,
)
from fem.candidates.layer import Layer
from instobj.commands.run import check
from instobj.report.cells import percent_text
from instobj.stages.makers.alternatives import settings_of, with_more_sensors

BRIEF = 2
"""Rounds of walks where layouts are compared that are not taken."""
_MANY = 9
"""Magnets of a face, where the usual number is seen too little."""
_WORTH = 0.1
"""Gain that more magnets must bring, in logarithms, to be taken."""
_FAR_OFF = 0.9
"""Share of locations within the limit after a brief search below which more magnets are searched at once."""
_SURE = 0.5
"""Gain of more magnets over the usual number after a brief search, in logarithms, with which that number is
searched no further: the rest of a search gained 0.17 to 0.49 in five bodies."""
_THICK_FROM_MM = ((60.0, 8.0), (80.0, 12.0), (120.0, 16.0), (200.0, 24.0))
"""Longest edge of a body from which a shell so thick is tried, all mm."""
_TRIED = 4
"""Layouts of a round that are checked, where those before break a check."""
_MORE = ((0, 9), (1, 9), (2, 9))
"""Sensors more on each face, and magnets at least, that are tried, the cheapest first in this list."""
_NAMED = 0.1
"""Sum of the shares by which both bounds fall, from which a better layout is named."""
_MORE_WITHIN = 0.05
"""Share of locations that must come within the limit to be named, or half of what misses it."""


def scored_first(request: Request, placed: Tables) -> Iterator[Tables]:
    """Yield layouts of a request from what rules `placed`, the best located first.

    Of stronger magnets, and where no number is asked for and the usual one does not keep
    `limits.position_bound_mm` everywhere, of more.
    """
    start = min(_starts(request, placed), key=itemgetter(0), default=None)
    if start is None:
        return
    brief, worth = improved(start[1], BRIEF)
    more = None
    if request.magnets is None and first_score(spec_of(brief)).within < _FAR_OFF:
        more = _with_more_magnets(request, brief)
        if more[1] < worth - _SURE:
            yield more[0]
    few, least = improved(brief, begin=BRIEF)
    if more is None and request.magnets is None and first_score(spec_of(few)).within < 1:
        more = _with_more_magnets(request, few)
    if more is not None and worth - _SURE <= more[1] < least - _WORTH:
        yield more[0]
    yield few
    # nearer to the start, where that cannot be made
    yield brief
    yield start[1]


def _with_more_magnets(request: Request, few: Tables) -> tuple[Tables, float]:
    """A layout of `_MANY` magnets a face under the same shell, searched from the chips' places of fewer, and
    what it is worth; infinity for none."""
    shell = shell_variant_of(few)
    more = next(fitting_tables(replace(request, magnets=_MANY), (shell,), COARSE), None)
    if more is None or _faces(more) != _faces(few):
        return few, np.inf
    return improved(more | {"sensors": few["sensors"]})


def _starts(request: Request, placed: Tables) -> Iterator[tuple[float, Tables]]:
    """Yield layouts that rules place, with each magnet and range, and what they are worth."""
    shell = shell_variant_of(placed)
    yield from _with_ranges(placed)
    for variant in STRONGER:
        if variant.thickness_mm not in _thicknesses(request, shell):
            continue
        tables = next(fitting_tables(request, (variant,), COARSE), None)
        if tables is not None and _faces(tables) == _faces(placed):
            yield from _with_ranges(tables)


def _faces(tables: Tables) -> list[int] | None:
    """Sensed faces of tables that name them."""
    return tables["body"].get("sensed_faces")


def _thicknesses(request: Request, shell: ShellVariant) -> tuple[float, ...]:
    """Shells that suit a body's size: that of the rules, and thicker ones of kinds that hook nothing."""
    if KINDS[request.kind].from_file:
        return (shell.thickness_mm,)
    thick = [t for edge, t in _THICK_FROM_MM if max(request.size_mm) >= edge]
    return (shell.thickness_mm, *thick)


def _with_ranges(tables: Tables) -> Iterator[tuple[float, Tables]]:
    """Yield tables with the narrowest range of the chips, and with the next where that is left."""
    for selectable in HALL_PARTS.named(SensorSpec().part).ranges[:2]:
        ranged = tables | {"sensors": tables["sensors"] | {"range_mt": selectable.range_mt}}
        spec = spec_of(ranged)
        level = LevelWithoutMesh.create(coarse(spec)) if _passes(spec) else None
        if level is None:
            continue
        loss = float(level.losses(level.point)[0])
        yield loss, tables if spec.sensors.range_mt == SensorSpec().range_mt else ranged
        if loss < BROKEN:
            return


def improved(
    tables: Tables, rounds: int = len(ROUNDS), seed: int = 0, begin: int = 0
) -> tuple[Tables, float]:
    """Tables with magnets and sensors where the score is best, and what they are worth, less for better.

    Rounds run from `begin` up to `rounds`: a layout that had the first two goes on from there.

    They stay as they are where nothing better passes `check`, and are worth nothing (infinity) where they
    break a limit and two rounds of walks do not mend it. As many layouts are scored on every machine, so
    that the result does not depend on its speed.
    """
    level = LevelWithoutMesh.create(coarse(spec_of(tables)))
    if level is None:
        return tables, np.inf
    best, worth, placed = level.point, float(level.losses(level.point)[0]), tables
    for number in range(begin, rounds):
        points = level.walked(best, number, seed)
        for _ in range(_TRIED):
            losses = level.losses(points)
            first = int(losses.argmin())
            if losses[first] >= worth:
                break
            broken = losses[first] > BROKEN
            laid = None if broken else level.layout_at(points[first])
            if broken or (laid is not None and _passes(laid)):
                best, worth = points[[first]], float(losses[first])
                placed = placed if laid is None else _with_places(tables, laid)
                break
            # Magnets that pull each other out are kept apart from now on.
            if laid is not None:
                level = level.with_gap(max(level.gap_mm, gap_that_holds_mm(laid)))
            points = np.delete(points, first, axis=0)
        if worth > BROKEN and number:
            break
    return placed, worth if worth < BROKEN else np.inf


def _passes(spec: ObjectSpec) -> bool:
    """Return whether `instobj check` lets a specification pass."""
    # `check` says what would mend magnets that do not stay, which takes a second.
    if not all_stay(spec):
        return False
    try:
        check(spec)
    except InputError:
        return False
    return True


def _with_places(tables: Tables, laid: ObjectSpec) -> Tables:
    """Tables with the places of magnets and sensors of a specification."""
    content = laid.model_dump(mode="json")
    parts = ("magnets", "sensors")
    places = {part: {"positions_mm": content[part]["positions_mm"]} for part in parts}
    return tables | {part: tables[part] | keys for part, keys in places.items()}


def gain_text(content: Tables) -> str:
    """Say what a better layout of an object's own parts would gain, found by brief walks without a mesh.

    Chips count as turned by the design: other turns change bounds by the ratio of the noisiest to the
    quietest axis at most (tests).
    """
    tables = content | {"sensors": dict(content["sensors"])}
    tables["sensors"].pop("rotations_deg", None)
    try:
        now, better = (first_score(spec_of(t)) for t in (tables, improved(tables, BRIEF)[0]))
    except InputError as error:
        return f"what a better layout of the same parts would gain cannot be said: {error}"
    fallen = (
        1 - better.median_mm / now.median_mm,
        1 - better.percentile_95_mm / now.percentile_95_mm,
    )
    if sum(fallen) < _NAMED:
        return "a better layout of the same parts: none was found in a brief search"
    median, high = (
        f"{percent_text(abs(share))} {'smaller' if share >= 0 else 'larger'}" for share in fallen
    )
    return (
        f"a better layout of the same parts would give position bounds {median} (median) and {high} (95th "
        "percentile), by a brief search without a mesh"
    )


def parts_that_help(request: Request, spec: ObjectSpec, score: FirstScore) -> str:
    """Say which number of parts on each face brings all locations within the limit, the fewest that do, or
    most of them; else what was tried, with figures. Nothing where all are.

    The most parts are tried first: where they are too few, so are fewer, which need no search.
    """
    if score.within == 1:
        return ""
    shell = ShellVariant(
        spec.shell.thickness_mm,
        spec.shell.pocket_diameter_mm,
        spec.shell.pocket_depth_mm,
        spec.magnets.sizes[0].height_mm,
    )
    best, help_text = score.within + min(_MORE_WITHIN, (1 - score.within) / 2), ""
    tried = dict[str, FirstScore]()
    for sensors_more, count in reversed(_MORE):
        # without a number asked for, more magnets were tried already: they were no better, or cannot be made
        magnets = spec.magnets.count if request.magnets is None else max(count, spec.magnets.count)
        if magnets == spec.magnets.count and not sensors_more:
            continue
        larger = replace(request, sensors=request.sensors + sensors_more, magnets=magnets)
        # more parts may need another shell: thinner, with smaller pockets
        placed = next(fitting_tables(larger, (shell, *SHELL_VARIANTS), COARSE), None)
        if placed is None or spec_of(placed).body.sensed != spec.body.sensed:
            continue
        placed["sensors"]["range_mt"] = spec.sensors.range_mt
        after = first_score(spec_of(improved(placed, BRIEF)[0]))
        within, more = after.within, magnets if magnets > spec.magnets.count else None
        name = _parts_text(sensors_more, (larger.sensors, more))
        tried[name + _otherwise_text(spec, spec_of(placed))] = after
        if within > best or within == 1:
            best, help_text = within, list(tried)[-1]
        if within < 1:  # and fewer parts see less
            break
    if best == 1:
        return (
            f"NO-GO is to be expected; {help_text} would bring every location within the limit, as a go "
            "needs"
        )
    if help_text:
        return (
            f"NO-GO is to be expected; {help_text} would bring {percent_text(best)} or more within the "
            "limit; a go needs all of them there"
        )
    added, _ = _MORE[-1]
    name, lines = f"{added} more sensors on each face under the same shell", ()
    try:
        changed = with_more_sensors(added, spec)
        tried[name], lines = first_score(changed), settings_of(spec, changed)
    except ValueError:
        pass  # no pattern of as many fits
    if name in tried and tried[name].within > best:
        return "\n".join(
            (
                f"NO-GO is to be expected at {_figures_text(score)}. {name}: {_figures_text(tried[name])}; a "
                "go needs all of them there. These lines go in place of the same keys:",
                *lines,
            )
        )
    figures = "; ".join(
        f"{parts.rstrip(',')}: {_figures_text(after)}" for parts, after in tried.items()
    )
    gains = any(a.within > score.within or a.median_mm < score.median_mm for a in tried.values())
    return (
        f"NO-GO is to be expected at {_figures_text(score)}: a go needs every location within the limit. "
        f"Tried: {figures or 'nothing, as more sensors do not fit'}. Take "
        f"{'more sensors, ' * gains}a smaller body{_softer_text(spec)} or raise limits.position_bound_mm"
    )


def _figures_text(score: FirstScore) -> str:
    """Return median bound and share within the limit."""
    return f"{score.median_mm:.2g} mm (median), {percent_text(score.within)} within"


def _softer_text(spec: ObjectSpec) -> str:
    """Return a softer silicone as a further change, by the rule of `score`'s "what to change": surely softer,
    and carrying the force by the deepest press (here of a flat layer); nothing where there is none."""
    surely, _ = spec.silicone.softer()
    for silicone in surely[:1]:
        modulus_mpa = silicone.modulus.youngs_modulus_mpa
        layer = Layer(spec.shell.thickness_mm, modulus_mpa, spec.indenter.radius_mm)
        if layer.force_at(max(spec.press.depths_mm)) >= spec.score.force_n:
            return f", a softer silicone (silicone.name = {silicone.name!r})"
    return ""


def _otherwise_text(spec: ObjectSpec, larger: ObjectSpec) -> str:
    """Say what else a larger number of parts changes; nothing where the shell and the magnets stay."""

    def figures(either: ObjectSpec) -> dict[str, str]:
        magnet = either.magnets.sizes[0]
        return {
            "a shell of": f"{either.shell.thickness_mm:g} mm",
            "magnets of": f"Ø{magnet.diameter_mm:g} × {magnet.height_mm:g} mm",
        }

    now, after = figures(spec), figures(larger)
    changed = [
        f"{what} {after[what]} (not {now[what]})" for what in now if after[what] != now[what]
    ]
    if not changed:
        return ""
    return f", which is another object with {' and '.join(changed)}, its range and places chosen again,"


def _parts_text(sensors_more: int, counts: tuple[int, int | None]) -> str:
    sensors, magnets = counts
    options = [f"--sensors {sensors}"] * bool(sensors_more)
    options += [f"--magnets {magnets}"] * (magnets is not None)
    several = "s" * (sensors_more > 1)
    words = [f"{sensors_more} more sensor{several} on each face"] * bool(sensors_more)
    words += [f"{magnets} magnets on each face"] * (magnets is not None)
    return f"{' and '.join(words)} ({' '.join(options)})"
