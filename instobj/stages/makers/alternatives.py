"""Alternatives to try next: the stored mechanics scored again after one change, two, and more."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from functools import partial, reduce
from itertools import combinations, product
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float

from design.catalogue.magnets import GRADES
from design.catalogue.silicones import SILICONES
from design.errors import InputError
from design.fit.everything import fits
from design.layout.body import core_frames, face_frames
from design.layout.places.contact_places import contact_places
from design.layout.places.measures import place_measures
from design.layout.pockets import lists_of_sensed_faces
from design.placement.patterns import sensor_patterns
from design.spec.object import ObjectSpec
from design.spec.silicone import SiliconeSpec
from design.spec_io import check
from estimator.information.scores import place_bounds, reached_places
from estimator.information.weak_areas import bound_of_most, thirds_of
from estimator.signals.presses import Signals, press_signals, saturation_margin
from estimator.tolerances.saturation import saturation
from fem.presses.results import load_presses
from instobj.report.remedies import softer_label
from instobj.report.verdict import LEAST_REACHED, worst_ratio
from instobj.stages.makers.next_options import next_options
from instobj.store.readers import ALTERNATIVES, PRESSES, SIGNALS
from instobj.store.stage import StageContext, write_json

Change = Callable[[ObjectSpec], ObjectSpec]
_OUT_FROM_THE_MIDDLE = 0.4
"""Share of a face's half extents: where a second sensor goes next to one in the middle, and it too."""
_WIDER = (0.0, 0.5, 0.6, 0.7)
"""The same at least, where more sensors find no room further in."""
_STRONGEST = max(GRADES.values(), key=lambda grade: grade.remanence_t)
_LEAST_GAIN = 1.05
"""Remanence after a change of grade over that before: makers' ranges within a grade span 5 %."""


@dataclass(frozen=True)
class Alternative:
    """Figures after no change, one or more: position bounds (mm), worst detectable force (N), share of the
    sensors' range that stays free, in the design and in 95 % of its virtual objects; magnets and sensors of
    the whole object; share of the judged locations that a press of `score.force_n` does not reach any more;
    position bound that 95 % of the third nearest the border keep, None where all lie as near.
    `settings` are the lines `key = value` that make the changes, by tables as in a specification."""

    changes: tuple[str, ...]
    weakest_bound_mm: float
    median_bound_mm: float
    worst_detectable_n: float
    saturation_margin: float
    objects_margin: float
    magnets: int
    sensors: int
    unreached: float = 0.0
    edge_bound_mm: float | None = None
    settings: tuple[str, ...] = ()


def make_alternatives(context: StageContext, folder: Path) -> None:
    """Scores after every change, every pair and, where those are not enough, larger sets, as a table."""
    signals = SIGNALS.read(context.inputs["signals"])
    presses = PRESSES.path(context.inputs["presses"])
    rows = alternatives(context.spec, signals, presses, context.step)
    # of a go nothing has to change: no option is shown, so none is forecast
    reached = reached_places(context.spec, signals).sum() / contact_places(context.spec).sum()
    go = _keeps_limits(context.spec, rows[0]) and reached >= LEAST_REACHED
    content = {
        "alternatives": [asdict(row) for row in rows],
        "next_options": [] if go else next_options(context.spec),
    }
    write_json(content, ALTERNATIVES.path(folder))


def alternatives(
    spec: ObjectSpec, signals: Signals, presses: Path, step: Callable[[str], None]
) -> list[Alternative]:
    """Score changes, single and in pairs, that leave the stored mechanics valid; none comes first.

    Where none of them keeps every limit, sets of three follow, then of four and so on until one does.
    A softer silicone scales every force by its modulus; more sensors and stronger magnets move no
    silicone. What the specification's own checks refuse is left out. All are judged at the same
    locations: where softer silicone does not reach `score.force_n`, at its deepest press, whose bound is
    larger.
    """
    read_by_source = {_source(spec): (signals, least_objects_margin(spec, signals, presses))}
    rows, possible = list[Alternative](), changes_of(spec)
    judged = reached_places(spec, signals)
    for size in range(len(possible) + 1):
        if size > 2 and any(map(partial(_keeps_limits, spec), rows)):
            break
        for changes in combinations(possible, size):
            if {*changes} >= _MORE_SENSORS:
                continue
            step(", ".join(changes) or "as specified")
            try:
                # one change after the other
                changed = check(reduce(lambda part, name: possible[name](part), changes, spec))
                source = _source(changed)
                if source not in read_by_source:
                    read = press_signals(changed, *load_presses(presses))
                    read_by_source[source] = read, least_objects_margin(changed, read, presses)
                read, margin = read_by_source[source]
                read = with_forces(spec, changed, read)
                row = alternative_of(changes, changed, read, margin, judged)
                rows.append(replace(row, settings=settings_of(spec, changed)))
            except ValueError:
                if not changes:
                    raise
    return rows


def _keeps_limits(spec: ObjectSpec, row: Alternative) -> bool:
    margins = row.saturation_margin, row.objects_margin
    return worst_ratio(spec.limits, row.weakest_bound_mm, row.worst_detectable_n, *margins) <= 1


def settings_of(spec: ObjectSpec, changed: ObjectSpec) -> tuple[str, ...]:
    """Return the lines (TOML) that turn `spec` into `changed`, each table's under its name; keys to leave out
    say so."""
    lines = list[str]()
    keys_now, after = (either.model_dump(mode="json") for either in (spec, changed))
    named = _figures_of_names(spec.silicone, changed.silicone)
    for table, keys in after.items():
        if not isinstance(keys, dict):
            continue
        changes = {
            key: value
            for key, value in keys.items()
            if value != keys_now[table][key] and not (table == "silicone" and key in named)
        }
        if changes:
            lines.append(f"[{table}]")
        for key, value in changes.items():
            lines.append(f"# leave out {key}" if value is None else f"{key} = {_toml(value)}")
    return tuple(lines)


def _figures_of_names(*silicones: SiliconeSpec) -> set[str]:
    """Return the figures that every one of these has from its name, so that the name alone changes them."""
    keys = set(SiliconeSpec.model_fields) - {"name"}
    for silicone in silicones:
        preset = SiliconeSpec(name=silicone.name) if silicone.name in SILICONES else None
        keys = {key for key in keys if preset and getattr(preset, key) == getattr(silicone, key)}
    return keys


def _toml(value: object) -> str:
    """Return a value as TOML writes it; lengths and counts to a thousandth."""
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    return repr(round(value, 3)) if isinstance(value, float) else json.dumps(value)


def _source(spec: ObjectSpec) -> str:
    """Return what signals of given mechanics depend on, of all that is changed here."""
    return f"{spec.magnets.model_dump_json()} {spec.sensors.positions_mm} {spec.sensors.count_per_face}"


def _quieter(spec: ObjectSpec) -> ObjectSpec:
    x, y, z = (noise / 2 for noise in spec.sensors.noise_counts)
    return _with_sensors(spec, noise_counts=(x, y, z))


def with_more_sensors(added: int, spec: ObjectSpec) -> ObjectSpec:
    """Return a specification with sensors added on every face, checked: on the same ring; where each sensor
    has a place, on a pattern of as many that fits. An error where none does."""
    sensors, count = spec.sensors, spec.sensors.count_per_face + added
    if sensors.positions_mm is None:
        return check(_with_sensors(spec, count_per_face=count))
    in_core = spec.arrangement == "sensors-in-core"
    frames = core_frames(spec) if in_core else face_frames(spec)
    halves = [np.array(frame.half_extents_mm) for frame in frames]
    faces = zip(lists_of_sensed_faces(spec, sensors.positions_mm), halves, strict=True)
    out = [float(np.hypot(*(np.array(places) / half).T).mean()) for places, half in faces]
    even, lopsided = sensor_patterns(count)
    for wider, pattern in product(_WIDER, [*even, *lopsided]):
        places = tuple(
            tuple(
                (float(x), float(y))
                for x, y in max(share or _OUT_FROM_THE_MIDDLE, wider) * half * pattern
            )
            for share, half in zip(out, halves, strict=True)
        )
        try:
            more = _with_sensors(spec, count_per_face=count, positions_mm=places)
            # most patterns do not fit, which the first fault decides
            if fits(more):
                return check(more)
        except ValueError:
            continue
    raise InputError(f"no pattern of {count} sensors fits")


def _stronger(spec: ObjectSpec) -> ObjectSpec:
    """Every weaker magnet in the strongest grade on sale; an error where none gains `_LEAST_GAIN`."""
    given = spec.magnets.remanences_t
    strongest = tuple(max(value, _STRONGEST.remanence_t) for value in given)
    # Beyond the strongest grade no magnet can be bought: such a change would be none.
    if max(np.divide(strongest, given)) < _LEAST_GAIN:
        raise InputError(f"no grade is {_LEAST_GAIN - 1:.0%} stronger than these magnets")
    alike = not isinstance(spec.magnets.remanence_t, tuple)
    stronger = {"grade": None, "remanence_t": strongest[0] if alike else strongest}
    return spec.changed(magnets=spec.magnets.changed(**stronger))


def _cast_of(name: str, spec: ObjectSpec) -> ObjectSpec:
    """The object of another silicone. Poisson's ratio and layers stay, as the stored mechanics have them."""
    kept = spec.silicone.model_dump(
        include={"poisson_ratio", "layers", "prony", "thinnest_wall_mm"}
    )
    return spec.changed(silicone=SiliconeSpec(name=name, **kept))


def _with_sensors(spec: ObjectSpec, **update: object) -> ObjectSpec:
    return spec.changed(sensors=spec.sensors.changed(**update))


def changes_of(spec: ObjectSpec) -> dict[str, Change]:
    """Return what can be changed of an object, under the names that users read; silicone becomes the next
    one of the catalogue that is surely softer, with the same cure."""
    softer, _ = spec.silicone.softer()
    if not softer:
        return _CHANGES
    nearest = softer[0]
    return _CHANGES | {softer_label(nearest.name): partial(_cast_of, nearest.name)}


_CHANGES: dict[str, Change] = {
    "mean of four frames in your own program (sensors.noise_counts halved, a quarter of the rate)": _quieter,
    "one more sensor on every face": partial(with_more_sensors, 1),
    "two more sensors on every face": partial(with_more_sensors, 2),
    f"magnets of grade {_STRONGEST.name}, the strongest": _stronger,
}
_MORE_SENSORS = {"one more sensor on every face", "two more sensors on every face"}
"""Changes of which a set holds one at most."""


def with_forces(spec: ObjectSpec, changed: ObjectSpec, signals: Signals) -> Signals:
    """Signals of `changed`, whose mechanics differ from `spec`'s by the modulus at most."""
    ratio = changed.silicone.youngs_modulus_mpa / spec.silicone.youngs_modulus_mpa
    return replace(signals, force_n=signals.force_n * ratio)


def least_objects_margin(spec: ObjectSpec, signals: Signals, presses: Path) -> float:
    """Margin of the deepest press, over all virtual objects but the few that may leave the range."""
    _, motions = load_presses(presses)
    return saturation(spec, signals, motions, deepest_alone=True).margin[-1]


def alternative_of(
    changes: tuple[str, ...],
    spec: ObjectSpec,
    signals: Signals,
    objects_margin: float,
    judged: Bool[np.ndarray, "face place"],
) -> Alternative:
    """Figures of a changed object at the locations where the unchanged one is judged."""
    bounds = place_bounds(spec, signals)
    position_mm = bounds.position_bound_mm[judged]
    faces = len(spec.body.sensed)
    return Alternative(
        changes,
        float(position_mm.max()),
        float(np.median(position_mm)),
        float(bounds.detectable_force_n[judged].max()),
        saturation_margin(signals, spec),
        objects_margin,
        faces * spec.magnets.count,
        faces * spec.sensors.count_per_face,
        float(np.mean(~reached_places(spec, signals)[judged])),
        _edge_bound_mm(spec, position_mm, judged),
    )


def _edge_bound_mm(
    spec: ObjectSpec,
    position_mm: Float[np.ndarray, "judged"],
    judged: Bool[np.ndarray, "face place"],
) -> float | None:
    """Bound that 95 % of the third nearest the border keep, as `WeakAreas.edge_ratio` has it."""
    outer, *inner = thirds_of(place_measures(spec).border_mm[judged])
    return bound_of_most(position_mm[outer]) if inner else None
