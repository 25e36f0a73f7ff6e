"""Commands of the chain, as functions that return one JSON-able document."""

from __future__ import annotations

import warnings
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from design.errors import InputError, InstobjError
from design.spec.learning import SATURATION_MARGIN
from design.spec.object import ObjectSpec
from design.spec_io import check as require_fit
from design.spec_io import load_spec, spec_hash
from instobj.commands.buildable import require_makeable
from instobj.commands.compare import compare_scores
from instobj.commands.next_step import (
    assessing_text,
    next_step,
    no_go_step,
    training_step,
    verdict_step,
)
from instobj.stages.run import Run, with_needs
from instobj.stages.table import STAGES
from instobj.stages.tasks import tasks_of
from instobj.stages.workers import open_workers
from instobj.store.content import store_root
from instobj.store.progress import ProgressLine
from instobj.store.publish import (
    file_rows,
    object_row,
    publish,
    require_writable,
    run_folder,
    run_name,
)
from instobj.store.readers import FINDINGS, FRAMES, INVERSION
from instobj.store.run_bar import expected_seconds


@dataclass(frozen=True)
class SpecCheck:
    """Results of `check`: how many magnets and sensors, and the field where it is largest at rest.

    Attributes
    ----------
    largest_field_at_rest_mt, range_mt : on any chip axis, and full scale of the sensors, mT
    """

    magnets: int
    sensors: int
    largest_field_at_rest_mt: float
    range_mt: float


def check(spec: ObjectSpec) -> SpecCheck:
    """Check that everything fits, that no sensor saturates at rest or sits in a magnet, and that magnets
    stay in their pockets while they are set.

    Parameters
    ----------
    spec : ObjectSpec
        Unknown keys and the bounds of each value were checked when it was made.

    Returns
    -------
    SpecCheck

    Raises
    ------
    SpecError
        It says which sensor or magnet, by how much, and which key to change.

    Examples
    --------
    >>> import instobj
    >>> found = instobj.check(instobj.ObjectSpec(name="cube"))
    >>> found.sensors, found.largest_field_at_rest_mt < found.range_mt
    (15, True)
    """
    from design.layout.places.positions import magnet_layout, sensor_layout
    from estimator.signals.presses import checked_rest_counts

    require_fit(spec)
    sensors, magnets = sensor_layout(spec), magnet_layout(spec)
    counts = checked_rest_counts(spec)
    largest_mt = float(abs(counts).max()) / spec.sensors.counts_per_mt
    return SpecCheck(len(magnets.face), len(sensors.face), largest_mt, spec.sensors.range_mt)


def check_specifications(specs: list[Path], overrides: list[str]) -> dict[str, Any]:
    """Validate each specification as `check` does, and say what its surroundings do to it."""
    from design.build.masses import mass_text
    from design.fit.boards import boards_across_edges
    from design.fit.roughness import roughness_in_words
    from design.fit.seam import seam_in_words
    from design.layout.places.contact_places import contact_places
    from design.layout.places.coverage import cell_areas_mm2, covered_share
    from instobj.commands.outlook import memory_text, outlook_text
    from instobj.report.uncertainty import force_spread_text, modulus_text
    from instobj.stages.makers.surroundings import surroundings_row

    rows = []
    for path in specs:
        spec = load_spec(path, overrides)
        checked, cells = check(spec), cell_areas_mm2(spec)
        across = boards_across_edges(spec)
        if across is not None:
            warnings.warn(across, stacklevel=2)
        texts = *seam_in_words(spec), *roughness_in_words(spec), memory_text(spec)
        for text in (*texts, _little_range_text(checked)):
            if text:
                warnings.warn(text, stacklevel=2)
        rows.append(
            {
                "spec": str(path),
                "name": spec.name,
                "spec_hash": spec_hash(spec),
                "magnets": checked.magnets,
                "sensors": checked.sensors,
                "largest_field_at_rest_mt": round(checked.largest_field_at_rest_mt, 3),
                "range_mt": checked.range_mt,
                "contact_locations": int(contact_places(spec).sum()),
                "covered_share": round(covered_share(spec), 4),
                "mass": mass_text(spec),
                "outlook": outlook_text(spec),
                "cell_areas_mm2": [round(float(end), 3) for end in (cells.min(), cells.max())],
                "youngs_modulus_mpa": spec.silicone.youngs_modulus_mpa,
                "youngs_modulus_range_mpa": spec.silicone.youngs_modulus_range_mpa,
                "modulus": modulus_text(spec),
                "force_at_a_travel": force_spread_text(spec),
                "surroundings": surroundings_row(spec),
            }
        )
    return {"command": "check", "specifications": rows}


def _little_range_text(checked: SpecCheck) -> str:
    """Say that less of the range is free at rest than must be in a press; nothing where more is."""
    share = checked.largest_field_at_rest_mt / checked.range_mt
    if share <= 1 - SATURATION_MARGIN:
        return ""
    return (
        f"{share:.0%} of the sensors' range is used at rest, and a go needs {SATURATION_MARGIN:.0%} of it "
        "free in the deepest press: take a wider range (sensors.range_mt) or weaker magnets"
    )


def fabrication_of(specs: list[Path], overrides: list[str], out: Path) -> list[dict[str, Any]]:
    """Findings of every specification, published to `cad_out/<name>`."""
    require_writable(out)
    documents = []
    for path in specs:
        spec = load_spec(path, overrides)
        result = Run(spec).require("fabrication")
        content = FINDINGS.read(result.folder)
        documents.append(content | {"files": file_rows(publish(spec, result, out))})
    return documents


def run_chain(
    specs: list[Path],
    stages: tuple[str, ...],
    out: Path,
    overrides: list[str],
    workers: int = 1,
    scheduler: str | None = None,
) -> dict[str, Any]:
    """Bring each specification to the given stages and publish what users read.

    Stages are made in this process, or by as many processes or the workers of a Dask scheduler
    (`instobj.stages.workers`).
    """
    loaded = [load_spec(path, overrides) for path in specs]
    _require_distinct_names([spec.name for spec in loaded], specs)
    require_writable(out)
    for spec in loaded:
        _require_no_recording(spec, stages, out)
        if "slip" in stages and not spec.mechanics.slip.slipped:
            raise InputError(
                f"{spec.name} has no slip of its core. Give one, such as "
                "--set mechanics.slip.shift_mm=[1,0,0]"
            )
        if "sheet" in stages:
            require_makeable(spec)
    _make_by_workers(loaded, stages, workers, scheduler)
    progress = ProgressLine()
    # workers have made all stages by now: what is left is reading, which a bar would overstate
    watched = progress.watched and workers == 1 and scheduler is None
    with progress.whole_run(_due(loaded, stages)) if watched else nullcontext():
        objects = [run_one_object(spec, stages, out, progress) for spec in loaded]
    result: dict[str, Any] = {"command": "chain", "objects": objects}
    if "scores" in stages and len(loaded) > 1:
        result["comparison"] = compare_scores(loaded, out)
    return result


def run_to_target(
    specs: list[Path],
    target: tuple[str, ...],
    out: Path,
    overrides: list[str],
    workers: int = 1,
    scheduler: str | None = None,
) -> dict[str, Any]:
    """Bring each specification to the stages of a target as `run_chain` does, and say what comes next."""
    document = run_chain(specs, target, out, overrides, workers, scheduler)
    return document | {"next": verdict_step("run", specs, out, overrides, document)}


def build_objects(specs: list[Path], out: Path, overrides: list[str]) -> dict[str, Any]:
    """Write the parts and the assembly sheet of each specification, and say what comes next."""
    from design.wiring.bus_plan import first_plan

    no_goes = [path for path in specs if _warn_of_no_go(load_spec(path, overrides))]
    document = run_chain(specs, ("sheet",), out, overrides)
    if no_goes:
        return document | {"next": _no_go_step(no_goes[0], out, overrides)}
    spec = load_spec(specs[0], overrides)
    # parts of an object that was not scored may not be worth casting
    ready = Run(spec).stored("scores") is not None and first_plan(spec) is not None
    done, paths = ("build", specs[:1]) if ready else ("build unscored", specs)
    return document | {"next": next_step(done, *paths, out=out, overrides=overrides)}


def simulate_recordings(
    specs: list[Path],
    out: Path,
    overrides: list[str],
    workers: int = 1,
    scheduler: str | None = None,
) -> dict[str, Any]:
    """Recordings as `[collection]` asks for them, with tangential forces where it does; workers as
    `run_chain`."""
    from estimator.frames.contact_cases import contact_groups

    loaded = [load_spec(path, overrides) for path in specs]
    _require_distinct_names([spec.name for spec in loaded], specs)
    require_writable(out)
    for spec in loaded:  # told before the minutes of mechanics
        contact_groups(spec)
    objects = []
    for spec in loaded:
        pulled = spec.collection.tangential_share > 0
        stages = ("pulled_collection" if pulled else "collection",)
        _make_by_workers([spec], stages, workers, scheduler)
        objects.append(run_one_object(spec, stages, out))
    return {"command": "frames", "objects": objects, "next": _frames_step(objects[0], out)}


def _frames_step(document: dict[str, Any], out: Path) -> str:
    """Return the next step: the simulated recording read by the object's estimator, or one trained on it."""
    frames = next(row["path"] for row in document["files"] if row["path"].endswith(".nc"))
    contacts = run_folder(out, document["name"]) / INVERSION.name
    if contacts.is_file():
        return next_step("train contacts", contacts, Path(frames), out=out)
    return next_step("recordings", Path(frames), out=out)


def _make_by_workers(
    specs: list[ObjectSpec], stages: tuple[str, ...], workers: int, scheduler: str | None
) -> None:
    """Stages into the store by others than this process, where there are any.

    Raises
    ------
    InputError
        A stage failed, or there are no such workers.
    """
    if workers == 1 and scheduler is None:
        return
    tasks, last = tasks_of(specs, stages)
    progress = ProgressLine()
    with progress.stage("stages"), open_workers(workers, scheduler, progress) as others:
        done = others.make(tasks, store_root(), progress.say)
    for spec, keys in zip(specs, last, strict=True):
        for key in keys.values():
            if done[key]["error"]:
                raise InputError(f"{spec.name}: {done[key]['error']}")


def _due(specs: list[ObjectSpec], stages: tuple[str, ...]) -> list[tuple[str, float]]:
    """Title and expected seconds of each stage that the objects' runs pass, one run after another."""
    names = [task.stage for spec in specs for task in tasks_of([spec], stages)[0].values()]
    seconds = {name: expected_seconds(store_root(), name) for name in set(names)}
    return [(STAGES[name].title, seconds[name]) for name in names]


def run_one_object(
    spec: ObjectSpec, stages: tuple[str, ...], out: Path, progress: ProgressLine | None = None
) -> dict[str, Any]:
    from instobj.report.summary import summarize

    run = Run(spec, progress or ProgressLine())
    _say_first_verdict(run, stages)
    files: set[Path] = set()
    for name in stages:
        run.require(name)
    for result in run.results.values():
        files.update(publish(spec, result, out))
    return object_row(spec, run.results.values(), summarize(run.results, spec), sorted(files))


def _say_first_verdict(run: Run, stages: tuple[str, ...]) -> None:
    """Say go or no-go as soon as the scores give it, where virtual objects are still to be judged."""
    from instobj.report.remedies import DESIGN_STAGES

    judges_objects = with_needs(*stages) >= {"robustness", *DESIGN_STAGES}
    if not judges_objects or run.stored("robustness"):
        return
    name, line = _verdict_of_design(run)
    run.progress.say(f"{name}: {line}. By the design; objects built within tolerances follow")


def _no_go_step(path: Path, out: Path, overrides: list[str]) -> str:
    """Return the next step of an object that is built though its scores say NO-GO: what to change, or a
    search where that was said."""
    changes_known = Run(load_spec(path, overrides)).stored("alternatives") is not None
    return no_go_step("run" if changes_known else "score", path, out, overrides)


def _warn_of_no_go(spec: ObjectSpec) -> bool:
    """Warn where stored scores say that an object to be built is not good enough; return whether they do."""
    from instobj.report.cells import NO_GO
    from instobj.report.remedies import DESIGN_STAGES

    run = Run(spec)
    if all(run.stored(name) for name in DESIGN_STAGES):
        name, line = _verdict_of_design(run)
        if name == NO_GO:
            warnings.warn(f"{spec.name} was scored {name}: {line}", stacklevel=2)
            return True
    return False


def _verdict_of_design(run: Run) -> tuple[str, str]:
    """Return go or no-go, and the sentence behind it."""
    from instobj.report.remedies import DESIGN_STAGES, verdict_summary

    for name in DESIGN_STAGES:
        run.require(name)
    return next(iter(verdict_summary(run.spec, run.results).items()))


def run_estimator(
    sources: list[Path],
    stages: tuple[str, ...],
    out: Path,
    overrides: list[str],
    twin: Path | None = None,
) -> dict[str, Any]:
    """Train or evaluate on specifications (simulated presses) and on data sets (.nc) alike.

    On data sets training gets presses of the calibrated twin of the specification `twin`, if given.
    """
    from instobj.commands.inversion import invert_on_data_set
    from instobj.commands.training import run_on_data_set, settings_of

    require_writable(out)
    if len(sources) > 1:
        _require_distinct_names([_results_name(path, overrides) for path in sources], sources)
    objects = []
    for path in sources:
        _require_trainable(path, twin)
        if path.suffix == ".nc" and settings_of(overrides)[0].model == "inversion":
            objects.append(invert_on_data_set(path, stages, out, overrides, twin))
        elif path.suffix == ".nc":
            objects.append(run_on_data_set(path, stages, out, overrides, twin))
        else:
            spec = load_spec(path, overrides)
            inverting = spec.training.model == "inversion"
            chosen = tuple(_INVERTING.get(stage, stage) for stage in stages)
            chosen = chosen if inverting else stages
            _require_no_recording(spec, chosen, out)
            objects.append(run_one_object(spec, chosen, out))
    texts = list(map(assessing_text, objects)) if sources[0].suffix == ".nc" else []
    return {
        "command": "estimator",
        "texts": list(filter(None, texts)),
        "objects": objects,
        "next": training_step(sources[0], objects[0], out, overrides),
    }


def _results_name(path: Path, overrides: list[str]) -> str:
    """Name of the folder below `runs` that gets what is trained on a specification or a data set."""
    is_data = path.suffix in (".nc", ".csv")
    return run_name(path) if is_data else load_spec(path, overrides).name


def _require_trainable(path: Path, twin: Path | None) -> None:
    """A data set or a specification, and no options that are not for it."""
    if path.suffix == ".csv":
        raise InputError(
            f"{path} is a recording, not a data set. Run `instobj recordings {path}` first and "
            "give the frames.nc that it writes"
        )
    if path.suffix != ".nc" and twin is not None:
        raise InputError(
            f"--twin is for data sets (.nc); got the specification {path}. Leave it out, or give the "
            "data set of the object"
        )


_INVERTING = {"networks": "inversion", "metrics": "contact_metrics"}
"""Stages that stand for those of networks where the forward model is inverted."""


def _require_distinct_names(names: list[str], paths: list[Path]) -> None:
    path_of: dict[str, Path] = {}
    for name, path in zip(names, paths, strict=True):
        if name in path_of:
            raise InputError(
                f"{path_of[name]} and {path} are both named {name!r}, and would write to the "
                "same folders. Rename one"
            )
        path_of[name] = path


_TRAINED = {"frames", "networks", "metrics", "inversion", "contact_metrics"}
"""Stages whose files have the names of files that `instobj recordings` and training on them write."""


def _require_no_recording(spec: ObjectSpec, stages: tuple[str, ...], out: Path) -> None:
    """Simulated presses, and estimators of them, do not take the place of recorded ones.

    Raises
    ------
    InputError
        The object's folder of results holds the data set of a recording.
    """
    from estimator.frames.dataset import load_frames

    path = run_folder(out, spec.name) / FRAMES.name
    if not path.is_file() or not _TRAINED & with_needs(*stages):
        return
    try:
        recorded = load_frames(path).source == "recorded"
    except InstobjError:
        return
    if recorded:
        raise InputError(
            f"{path} is the data set of a recording; {spec.name} would write simulated presses, and "
            "estimators of these, over it and what was trained on it. Give another folder with --out, or "
            "another name to the object or its recording"
        )
