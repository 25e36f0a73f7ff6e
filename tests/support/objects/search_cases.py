"""A made-up search: two choices and places of up to two magnets, with a known optimum.

Processes of searches import it: nothing heavy in here.
"""

from design.search.space import search_space
from design.spec_io import parse_spec
from instobj.search.apart import WorkerTimeout
from instobj.search.loop import run_search
from instobj.search.trials import Scored, open_trials

OBJECTIVES = ("worst_position_bound_mm", "worst_force_bound_n")


_KNOWN = {}
"""What a process asks for again and again, by what it asked for; all of it is frozen."""


def made_up_spec(name="cube", seed=1, reach=14.0, **search):
    vary = {"magnet_reach_mm": reach, "magnet_count": [1, 2], "sensor_chip": ["inward", "outward"]}
    content = {"trials": 300, "polish_steps": 0, "vary": vary} | search
    key = f"{name} {seed} {content}"
    if key not in _KNOWN:
        _KNOWN[key] = parse_spec({"name": name, "seed": seed, "search": content}, "made up")
    return _KNOWN[key]


def made_up_space(**search):
    key = f"space {search}"
    if key not in _KNOWN:
        _KNOWN[key] = search_space(made_up_spec(**search))
    return _KNOWN[key]


def made_up_score(trials, seconds):
    """Least at one magnet at (5, −3) with chips outward; the second objective's least is at (−5, 6)."""
    found = [_scores(trial) for trial in trials]
    return [
        Scored(trial, (scores["worst_position_bound_mm"],), scores, 0.0, "", 1)
        for trial, scores in zip(trials, found, strict=True)
    ]


def made_up_scores(trials, seconds):
    """Both objectives."""
    return [
        Scored(t, tuple(_scores(t)[name] for name in OBJECTIVES), _scores(t), 0.0, "", 1)
        for t in trials
    ]


def _scores(trial):
    x, y = trial["magnet1_x_mm"], trial["magnet1_y_mm"]
    worse = (trial["magnet_count"] == 2) + 0.5 * (trial["sensor_chip"] == "inward")
    return {
        "worst_position_bound_mm": 0.01 + ((x - 5) ** 2 + (y + 3) ** 2) / 100 + worse,
        "worst_force_bound_n": 0.01 + ((x + 5) ** 2 + (y - 6) ** 2) / 100 + worse,
    }


def answering(score):
    """A score of trials of one structure, asked for several."""

    def answers(questions, seconds):
        found = []
        for trials in questions:
            try:
                found.append(score(trials, seconds))
            except WorkerTimeout as error:
                found.append(error)
        return found

    return answers


def kept_lines(path):
    """Whole lines of a file of trials, one of them before the first trial; each trial is one."""
    return path.read_bytes().count(b"\n") if path.is_file() else 0


def searched(path, score=made_up_score, **search):
    """A search that was run to its end, or gone on with, kept in the file `path`."""
    space = made_up_space(**search)
    kept = open_trials(space.spec, path, resume=path.exists())
    run_search(space, kept, answering(score), lambda line: None)
    return kept
