"""Simple regressions (scikit-learn) that an estimator must not lose to, compared press by press.

Each is fitted to the training presses of the model and the channels that it reads, changes over
time included: the total force to frames with and without contact, the centre of force to those with
contact. Frames of one press are alike, so presses are what differences are averaged over: the mean
of a press's errors counts once, and the scatter comes from presses drawn again (bootstrap).
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import Channel, FaceData, channel_counts, face_data, with_history
from estimator.frames.splits import Split
from estimator.metrics.heatmaps import force_reference
from estimator.networks.face_model import FaceModel, predict
from estimator.networks.prediction import ContactAnswers, HeldOutAnswers
from estimator.networks.training.data import thinned, with_contacts

MOST_FRAMES = 6000
"""Training frames that a baseline is fitted to at most, drawn from all training presses."""
MOST_FRAMES_OF_PROCESS = 2000
"""The same for the Gaussian process, whose time grows with their cube."""
FRAMES_OF_KERNEL = 400
"""Frames from which the kernel method learns, at most: its cost grows with their cube."""
_NEIGHBOURS, TREES, BOOSTS = 5, 200, 300
"""Sizes of the baselines: nearest neighbours, trees of a forest, rounds of boosting."""
_DRAWS = 2000
"""Bootstrap draws of an interval."""
_INTERVAL_PERCENT = (5.0, 95.0)
"""Percentiles of a 90 % interval."""


@dataclass(frozen=True)
class Difference:
    """Mean over presses of a baseline's error less that of the model, and 90 % of bootstrap means.

    Positive where the baseline is worse. The model is no worse within scatter where `high` ≥ 0.
    """

    mean: float
    low: float
    high: float


@dataclass(frozen=True)
class BaselineReport:
    """Errors in the contact frames of held-out presses, and how they differ from the model's.

    `total_force_percent` is of the range of force seen at the pressed pixels; NaN (None in JSON)
    where a pixel has no range.
    """

    face: int
    name: str
    fitted_frames: int
    presses: int
    total_force_n: float
    total_force_percent: float
    place_mm: float
    force_n_less_model: Difference
    place_mm_less_model: Difference

    def summary(self) -> dict[str, Any]:
        """Ready for JSON, None where a percentage is undefined."""
        percent = self.total_force_percent
        return asdict(self) | {"total_force_percent": None if np.isnan(percent) else percent}


def held_out_answers(model: FaceModel, frames: FrameSet, split: Split) -> HeldOutAnswers:
    """The model and every baseline on the test part; baselines learn from all other presses.

    Raises
    ------
    InputError
        No contact on the face in the training or in the test part.
    """
    whole = with_history(frames, model.history_frames)
    learned = with_contacts(face_data(whole.select(~split.test), model.face), "training")
    tested = with_contacts(face_data(whole.select(split.test), model.face), "tested")
    tested = tested.select(tested.contact)
    prediction = predict(model, tested.frames)
    answers = [ContactAnswers("model", prediction.force_n, prediction.xy_mm)]
    fitted_frames = {}
    for name, make in REGRESSORS.items():
        most = MOST_FRAMES_OF_PROCESS if name == "gaussian process" else MOST_FRAMES
        shown = drawn_frames(thinned(learned, 0), most)
        fitted_frames[name] = len(shown)
        answers.append(_answers(name, make, shown, tested.frames, model.channels))
    return HeldOutAnswers(
        face=model.face,
        true_force_n=tested.heatmap_n.sum(axis=(1, 2)),
        true_xy_mm=tested.centre_mm,
        span_n=_spans(tested, face_data(frames, model.face)),
        press_id=tested.frames.press_id,
        time_s=tested.frames.time_s,
        grid_x_mm=model.grid_x_mm,
        grid_y_mm=model.grid_y_mm,
        force_halfwidth_n=prediction.force_halfwidth_n,
        interval_cover=model.interval_cover,
        answers=tuple(answers),
        fitted_frames=fitted_frames,
    )


def simple_answers(
    training: FrameSet,
    read: FrameSet,
    face: int,
    channels: tuple[Channel, ...],
    history_frames: int,
) -> list[ContactAnswers]:
    """Read a face in frames by the baselines that fit in a second, with the channels of a model.

    `read` has readings of all of these, changes over time included (`frames_with_readings`).

    Raises
    ------
    InputError
        No contact on the face in `training`, or no reading of a channel.
    """
    whole = with_history(training, history_frames)
    learned = with_contacts(face_data(whole, face), "training")
    shown = drawn_frames(thinned(learned, 0), MOST_FRAMES)
    return [
        _answers(name, REGRESSORS[name], shown, read, channels)
        for name in ("ridge", "nearest neighbours")
    ]


def baseline_reports(held_out: HeldOutAnswers) -> list[BaselineReport]:
    """Errors of the model (named "model", no difference from itself) and of every baseline."""
    away = {
        answer.name: np.linalg.norm(answer.xy_mm - held_out.true_xy_mm, axis=1)
        for answer in held_out.answers
    }
    missed = {
        answer.name: np.abs(answer.force_n - held_out.true_force_n) for answer in held_out.answers
    }
    return [
        BaselineReport(
            face=held_out.face,
            name=answer.name,
            fitted_frames=held_out.fitted_frames.get(answer.name, 0),
            presses=len(np.unique(held_out.press_id)),
            total_force_n=float(missed[answer.name].mean()),
            total_force_percent=float(np.mean(100 * missed[answer.name] / held_out.span_n)),
            place_mm=float(away[answer.name].mean()),
            force_n_less_model=paired_difference(
                missed[answer.name], missed["model"], held_out.press_id
            ),
            place_mm_less_model=paired_difference(
                away[answer.name], away["model"], held_out.press_id
            ),
        )
        for answer in held_out.answers
    ]


def paired_difference(
    error: Float[np.ndarray, "frame"],
    of_model: Float[np.ndarray, "frame"],
    press_id: Int[np.ndarray, "frame"],
) -> Difference:
    """Mean difference over presses, with 90 % of the means of presses drawn again."""
    _, press, count = np.unique(press_id, return_inverse=True, return_counts=True)
    per_press = np.bincount(press, weights=error - of_model) / count
    drawn = np.random.default_rng(0).integers(len(count), size=(_DRAWS, len(count)))
    low, high = np.percentile(per_press[drawn].mean(axis=1), _INTERVAL_PERCENT)
    return Difference(float(per_press.mean()), float(low), float(high))


def _answers(
    name: str,
    make: Callable[[np.ndarray, np.ndarray], Any],
    shown: FaceData,
    tested: FrameSet,
    channels: tuple[Channel, ...],
) -> ContactAnswers:
    from sklearn.preprocessing import StandardScaler

    counts, tested_counts = (channel_counts(part, channels) for part in (shown.frames, tested))
    scaler = StandardScaler().fit(counts)
    counts, tested_counts = (np.asarray(scaler.transform(part)) for part in (counts, tested_counts))
    force, touched = shown.heatmap_n.sum(axis=(1, 2)), shown.contact
    force_n = make(counts, force).predict(tested_counts)
    centre = shown.centre_mm[touched]
    xy_mm = np.column_stack(
        [make(counts[touched], centre[:, axis]).predict(tested_counts) for axis in range(2)]
    )
    return ContactAnswers(name, force_n, xy_mm)


def drawn_frames(data: FaceData, most: int) -> FaceData:
    if len(data) <= most:
        return data
    chosen = np.random.default_rng(0).permutation(len(data))[:most]
    return data.select(np.sort(chosen))


def _spans(tested: FaceData, everything: FaceData) -> Float[np.ndarray, "frame"]:
    pressed: Bool[np.ndarray, "frame nx ny"] = tested.heatmap_n > 0
    range_n = force_reference(everything.heatmap_n).range_n
    return np.array([range_n[mask].sum() for mask in pressed])


def _ridge(counts: np.ndarray, target: np.ndarray) -> Any:
    from sklearn.linear_model import RidgeCV

    return RidgeCV(alphas=np.logspace(-2, 3, 11)).fit(counts, target)


def _nearest(counts: np.ndarray, target: np.ndarray) -> Any:
    from sklearn.neighbors import KNeighborsRegressor

    return KNeighborsRegressor(min(_NEIGHBOURS, len(counts)), weights="distance").fit(
        counts, target
    )


def _boosting(counts: np.ndarray, target: np.ndarray) -> Any:
    from sklearn.ensemble import HistGradientBoostingRegressor

    return HistGradientBoostingRegressor(
        max_iter=BOOSTS, learning_rate=0.05, max_leaf_nodes=15, random_state=0
    ).fit(counts, target)


def _extra_trees(counts: np.ndarray, target: np.ndarray) -> Any:
    from sklearn.ensemble import ExtraTreesRegressor

    return ExtraTreesRegressor(TREES, random_state=0).fit(counts, target)


def _gaussian_process(counts: np.ndarray, target: np.ndarray) -> Any:
    """Squared-exponential kernel and noise of greatest likelihood on a part of the frames."""
    from sklearn.exceptions import ConvergenceWarning
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

    kernel = ConstantKernel(1.0, (1e-2, 1e4)) * RBF(
        np.sqrt(counts.shape[1]), (1e-1, 1e3)
    ) + WhiteKernel(1e-2, (1e-6, 1e1))
    part = np.random.default_rng(0).permutation(len(counts))[:FRAMES_OF_KERNEL]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)  # noise at its bound is an answer
        rough = GaussianProcessRegressor(kernel, normalize_y=True).fit(counts[part], target[part])
    exact = GaussianProcessRegressor(
        rough.kernel_,
        optimizer=None,  # pyright: ignore[reportArgumentType]
        normalize_y=True,
    )
    return exact.fit(counts, target)


REGRESSORS: dict[str, Callable[[np.ndarray, np.ndarray], Any]] = {
    "ridge": _ridge,
    "nearest neighbours": _nearest,
    "boosting": _boosting,
    "extra trees": _extra_trees,
    "gaussian process": _gaussian_process,
}
