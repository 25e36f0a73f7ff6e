"""The command `optimize`: search, promotion of the leaders, results."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from math import inf
from pathlib import Path
from typing import Any

from design.errors import InputError
from design.layout.body import body_of
from design.layout.places.contact_places import shared_counts
from design.layout.places.coverage import covered_share
from design.search.faces import layout_groups
from design.search.space import SearchSpace, start_params, with_layout
from design.search.structure import searched_size_variants
from design.spec.assembly import AsBuiltSpec
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from estimator.field.device import compute_device
from instobj.commands.next_step import next_step
from instobj.search.apart import answers
from instobj.search.joined import describe_merge, merge_restarts
from instobj.search.levels import Levels
from instobj.search.loop import Answer, layouts_at_once, run_search
from instobj.search.lowest_fidelity import TimedTrials, lowest_fidelity
from instobj.search.outcome.rows import promotion_tables
from instobj.search.outcome.write import BEST, RESULTS, write_best, write_outcome
from instobj.search.possible import require_possible
from instobj.search.promotion import Promoter, leaders
from instobj.search.time_limit import FIRST_LOOK_S, TRIALS_SHARE, TimeLimit, trial_ends
from instobj.search.trials import KeptTrials, open_trials
from instobj.search.verdict import Promotion, best_in_words, bounds_in_words
from instobj.stages.resources import search_seconds
from instobj.stages.run import Run
from instobj.stages.workers import Workers, open_workers
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows, require_writable, run_folder


def optimize(
    path: Path,
    out: Path,
    overrides: list[str],
    resume: bool,
    workers: int = 1,
    scheduler: str | None = None,
) -> dict[str, Any]:
    """Search, then promote the leaders; files in `runs/<name>/search`.

    Trials and stages of the higher levels are made by as many processes of this machine, or by the workers
    of a Dask scheduler.

    Raises
    ------
    InputError
        Of `require_possible` and `open_trials`; trials cannot be kept; the time is spent before there
        is a result; or no trial keeps every limit.
    """
    spec, space = _prepared(path, out, overrides)
    folder = run_folder(out, spec.name) / "search"
    progress = ProgressLine()
    limit = TimeLimit(spec.search.seconds)
    # refuses before there is a study to resume
    lowest_s, chain_s = _mechanics_seconds(spec)
    plans = [limit.mechanics_plan(lowest_s, chain_s), forces_plan(spec)]
    if limit.holds_trials(lowest_s):
        plans = [limit.plan, *plans]
    kept = open_trials(spec, folder / "trials.jsonl", resume)
    for plan in plans:
        progress.say(plan)

    def say(text: str) -> None:
        progress.step(f"{text}; {limit.left}")

    keep_best = partial(best_so_far, space, kept, folder, path.parent, out)
    keep_best()
    advised_s = limit.enough_s(lowest_s, chain_s) if lowest_s else 0.0
    with (
        _kept_on_interrupt(kept, progress),
        limit.enforced(keep_best, lambda: advised_s),
        open_workers(workers, scheduler, progress) as others,
    ):
        mechanics_s = _make_mechanics(space.spec, progress)
        if too_short := limit.measured_plan(mechanics_s):
            progress.say(too_short)
            advised_s = limit.measured_s(mechanics_s)
        _search(space, kept, progress, say, lambda: limit.left_of(TRIALS_SHARE), others, keep_best)
        with progress.stage("promotion"):
            levels = Levels(folder / "rungs.json", say, others)
            promotion = Promoter(space, limit, levels).promote(kept)
    kept_keys = [text for text in overrides if not text.startswith("search.seconds=")]
    again = [*kept_keys, f"search.seconds={2 * limit.seconds:g}"]
    if promotion is None:
        return nothing_better(
            spec, kept, limit, partial(write_best, folder=folder, beside=path.parent)
        ) | {"next": next_step("optimize again", path, out=out, overrides=again)}
    with progress.stage("report"):
        files = write_outcome(space, kept, promotion, folder, path.parent, progress.step)
    go_on = next_step("optimize again", path, out=out, overrides=again)
    if promotion.better:
        go_on = next_step("optimize", folder / BEST, out=out)
    return _document(spec, kept, promotion, files) | {"next": go_on}


def forces_plan(spec: ObjectSpec) -> str:
    """Say at which forces layouts are judged, and at which one `score` judges."""
    forces = ", ".join(f"{force:g}" for force in spec.scoring_forces_n)
    key = "search.forces_n" if spec.search.forces_n else "score.force_n"
    text = f"layouts are judged at presses of {forces} N ({key})"
    if spec.score.force_n in spec.scoring_forces_n:
        return text
    return f"{text}; `instobj score` judges at {spec.score.force_n:g} N (score.force_n)"


def nothing_better(
    spec: ObjectSpec,
    kept: KeptTrials,
    limit: TimeLimit,
    write: Callable[[ObjectSpec, str, str], Path],
) -> dict[str, Any]:
    """Return what is said where no trial but the start itself keeps every limit; `write` it as the best.

    Raises
    ------
    InputError
        Not even the start does; with the limit most in the way, or why trials failed.
    """
    (*_, start_trial), trials = (
        [None, *(trial for trial in kept.finished if trial.feasible)],
        kept.trials,
    )
    if start_trial is None:
        raise InputError(_describe_nothing(kept))
    verdict = (
        f"Nothing better was found in {limit.searching_s - limit.left_s:.0f} s of search: of "
        f"{len(trials)} trials, what keeps every limit is your own layout (trial {start_trial.number}), "
        f"which is best.toml, unchanged. Go on with --resume --set search.seconds={2 * limit.seconds:g} or "
        "more, or raise search.trials"
    )
    best = write(spec, "The layout that the search began with: nothing better was found", spec.name)
    return {
        "command": "optimize",
        "name": spec.name,
        "spec_hash": spec_hash(spec),
        "better": False,
        "verdict": verdict,
        "gains": "",
        "tables": {verdict: [_trial_counts(kept)]},
        "files": file_rows([best]),
    }


def _describe_nothing(kept: KeptTrials) -> str:
    """Return why no trial is a result, and what to do."""
    trials, finished = kept.trials, kept.finished
    if not finished:
        return (
            f"all {len(trials)} trials failed. The last reason: {trials[-1].failure}. Mend that, then go "
            "on with --resume"
        )
    nearest = min(finished, key=lambda trial: (trial.broken_mm, bool(trial.misfit)))
    way = nearest.misfit or f"its limits, by {nearest.broken_mm:.3g} mm"
    failed = len(trials) - len(finished)
    also = f" {failed} of them failed, the last because: {trials[-1].failure}." if failed else ""
    return (
        f"none of {len(trials)} trials keeps every limit.{also} Most in the way of the nearest, trial "
        f"{nearest.number}: {way}. Raise search.trials and search.seconds and go on with --resume, or loosen "
        "[search.limits]"
    )


def best_so_far(
    space: SearchSpace, kept: KeptTrials, folder: Path, beside: Path, out: Path | None = None
) -> str:
    """Write the best trial so far, which only the lowest level knows, or the start.

    Return where, what it gains there, the command that judges it (with `out`), and what else is kept, in
    words. What an earlier call took to higher levels stays.
    """
    layout, about = space.spec, "The layout that the search began with: no trial is better yet"
    said, judge = "the layout that the search began with", ""
    for best in leaders(space, kept, 1):
        layout = with_layout(space.spec, best.params)
        said = "by the lowest fidelity level alone"
        if gains := bounds_in_words(best.start_scores, best.scores):
            said += f" ({gains})"
        about = f"The best so far, {said}; not confirmed"
        judge = f" Judge it: {next_step('optimize cut', folder / BEST, out=out)}."
    if not (folder / RESULTS).is_file():
        write_best(layout, about, space.spec.name, folder, beside)
    ended = len(kept.trials)
    what = (
        f"Trials ({ended}), finished stages and scored layouts are kept"
        if ended
        else "No trial has ended; the mechanics made so far are kept"
    )
    return f" The best so far, {said}, is {folder / BEST}.{judge} {what}."


def _mechanics_seconds(spec: ObjectSpec) -> tuple[float, float]:
    """Return the time of mechanics of the lowest fidelity level that are not stored, and of a chain."""
    estimate = search_seconds(spec)
    missing = sum(
        Run(variant, checked=False).stored("candidates") is None
        for variant in searched_size_variants(spec)
    )
    return missing * estimate.lowest, estimate.chain


def _make_mechanics(spec: ObjectSpec, progress: ProgressLine) -> float:
    """Make mechanics of the lowest fidelity level; return what those of one size took, s, at most."""
    runs = (Run(variant, progress, checked=False) for variant in searched_size_variants(spec))
    return max(run.require("candidates").seconds for run in runs)


@contextmanager
def _kept_on_interrupt(kept: KeptTrials, progress: ProgressLine) -> Iterator[None]:
    """Say what an interrupt leaves behind."""
    try:
        yield
    except KeyboardInterrupt:
        progress.say(
            f"kept: {len(kept.trials)} trials in {kept.path}, and every layout that a higher fidelity "
            "level has scored. Go on with --resume"
        )
        raise


def _prepared(path: Path, out: Path, overrides: list[str]) -> tuple[ObjectSpec, SearchSpace]:
    """Another object is sought: what was measured on the built one goes. One layout serves all faces:
    it is judged at the contact locations that they share. A device that is not there is reported at once."""
    compute_device()
    spec = load_spec(path, overrides).changed(as_built=AsBuiltSpec())
    require_writable(out)
    shared = body_of(spec).cuboid and len(layout_groups(spec)) == 1
    if spec.contact_grid.count == "fill" and shared:
        spec = spec.changed(contact_grid=spec.contact_grid.changed(count=shared_counts(spec)))
    space = require_possible(spec)
    return space.spec, space


def _search(
    space: SearchSpace,
    kept: KeptTrials,
    progress: ProgressLine,
    say: Callable[[str], None],
    left_s: Callable[[], float],
    workers: Workers,
    keep_best: Callable[[], str],
) -> None:
    requested, content = space.spec.search, space.spec.model_dump_json()
    kept_generations = [trial.generations for trial in kept.trials]
    space = merge_restarts(space, layouts_at_once(requested, workers.count), kept_generations)
    if len(kept.trials) >= space.spec.search.trials:
        return
    if space.spec.search.trials < requested.trials:
        progress.say(describe_merge(requested, space.spec.search, len(kept.trials)))
    first = start_params(space)

    def waiting(trials: int) -> None:
        say("1 trial at work" if trials == 1 else f"{trials} trials at work")

    # a trial in less time than it has at least would end after the trials' time
    shortest_s = FIRST_LOOK_S if requested.polish_steps else 0.0

    def keep_and_stop() -> bool:
        keep_best()
        return left_s() <= shortest_s

    first_s = FIRST_LOOK_S if space.spec.search.trials > 1 else inf
    question = (content, space.spec.search.polish_steps, first_s)
    with answers(lowest_fidelity, question, workers, waiting) as ask, progress.stage("search"):

        def score(questions: list[list[dict[str, Any]]], seconds: float) -> list[Answer]:
            ends = trial_ends(len(questions), workers.count, left_s(), seconds)
            return ask([*map(TimedTrials, questions, ends)], seconds)

        run_search(space, kept, score, say, first, keep_and_stop, workers.count, progress.say)


def _document(
    spec: ObjectSpec, kept: KeptTrials, promotion: Promotion, files: list[Path]
) -> dict[str, Any]:
    verdict = f"best.toml is {best_in_words(spec.search, promotion)}"
    if not promotion.better:
        verdict = (
            "no layout is known to be better than the start at the highest fidelity level "
            f"({'; '.join(promotion.objections)}). {verdict}"
        )
    covered = f"{100 * covered_share(promotion.best.spec):.0f} % of the sensed surface"
    verdict += f". Judged at contact locations that cover {covered}"
    if promotion.shortened:
        verdict += f". {promotion.shortened}"
    return {
        "command": "optimize",
        "name": spec.name,
        "spec_hash": spec_hash(spec),
        "better": promotion.better,
        "verdict": verdict,
        "gains": promotion.gains,
        "tables": {f"search of {spec.name}: {verdict}": [_trial_counts(kept)]}
        | promotion_tables(promotion),
        "files": file_rows(files),
    }


def _trial_counts(kept: KeptTrials) -> dict[str, Any]:
    trials, finished = kept.trials, kept.finished
    return {
        "trials": len(trials),
        "within all limits": sum(trial.feasible for trial in finished),
        "failed": len(trials) - len(finished),
        "kept in": str(kept.path),
    }
