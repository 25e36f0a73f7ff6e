"""Predicted against recorded signals of presses, each figure with its permutation null.

The null hypothesis is that the model knows nothing of the place: the cases (which places are pressed
together) are exchanged among the presses, forces and recorded signals kept. All permutations are
tried up to eight cases, else a random sample. p is the share of permutations, the true one
included, that do at least as well; the smallest possible p is 1 / permutations.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations
from math import factorial
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int

from design.spec.object import ObjectSpec
from estimator.calibration.recorded_presses import (
    MODULUS_RATIOS,
    PredictedMotions,
    RecordedPresses,
    own_channels,
)
from estimator.field.models import MagnetsModel
from estimator.tolerances.assembly import Assembly, counts_of

SIGNIFICANCE = 0.05
SIZE_BAND = 1.25
"""A size or modulus within this factor counts as supported: hysteresis alone is about 10 %."""
_SAMPLED_PERMUTATIONS = 5000
"""Random permutations where all of them are too many."""
_LARGEST_ENUMERATED = 8
"""Number of things whose permutations are all tried."""
_SIGN_SIGMAS = 3.0
"""Signal over its noise from which its sign counts."""


@dataclass(frozen=True)
class Figure:
    """One figure of merit, the median of its null, the p of being no better than that, and of how many
    exchanges of places the null is made."""

    value: float
    null: float
    p: float
    exchanges: int

    @property
    def significant(self) -> bool:
        return self.p <= SIGNIFICANCE

    @property
    def judgement(self) -> str:
        """Few exchanges allow no small p, whatever the recordings say."""
        if untold := cannot_be_told(self.exchanges):
            return untold
        return "supported" if self.significant else "not supported"


def cannot_be_told(exchanges: int) -> str:
    """Return why a null of so few orders of the places (the true one among them) decides nothing, "" where
    it can: the smallest possible p is above `SIGNIFICANCE`."""
    if 1 / exchanges <= SIGNIFICANCE:
        return ""
    return f"cannot be told ({exchanges} exchanges of places allow no p below {1 / exchanges:.2g})"


@dataclass(frozen=True)
class Agreement:
    """Agreement of predictions with recordings on some channels.

    Attributes
    ----------
    what : "face 3" (its own channels, presses on it) or "all channels"
    presses, cases : how many enter
    cosine : mean over presses of the cosine between predicted and recorded change
    signs : mean share of clear channels (recorded change above 3 σ of a fresh zero) of the right sign
    size_ratio : geometric mean of recorded over predicted size, at the specification's modulus
    size_spread : factor of one standard deviation of that ratio over presses
    modulus_mpa : geometric mean of the moduli at which sizes agree
    modulus_spread : factor of one standard deviation of it
    modulus_bounded : share of presses whose modulus lies within the range searched
    """

    what: str
    presses: int
    cases: int
    cosine: Figure
    signs: Figure
    size_ratio: float
    size_spread: Figure
    modulus_mpa: float
    modulus_spread: Figure
    modulus_bounded: float


@dataclass(frozen=True)
class Predictions:
    """Predicted change (press, case, channel) of counts were each press any of the cases, and its
    size (press, case, ratio) on `channels` at `MODULUS_RATIOS`."""

    counts: Float[np.ndarray, "press case channel"]
    by_ratio: Float[np.ndarray, "ratio press case channel"]


def predict(
    spec: ObjectSpec,
    assembly: Assembly,
    moving: PredictedMotions,
    rest: Float[np.ndarray, "body 6"],
    model: MagnetsModel,
) -> Predictions:
    """Signals of all presses as all cases, for an assembly, at every tabulated modulus.

    The modulus of the assembly multiplies the specification's.
    """
    presses, cases = moving.motion.shape[:2]
    zero = counts_of(spec, assembly.scene, rest[None], model)[0]

    def change(ratio: float) -> Float[np.ndarray, "press case channel"]:
        motions = [moving.motion_of_cases(np.full(presses, case), ratio) for case in range(cases)]
        motion = np.stack(motions, axis=1).reshape(presses * cases, *rest.shape)
        counts = counts_of(spec, assembly.scene, motion, model) - zero
        return counts.reshape(presses, cases, -1)

    by_ratio = np.stack([change(ratio) for ratio in tried_ratios(assembly.modulus_ratio)])
    return Predictions(change(assembly.modulus_ratio), by_ratio)


def tried_ratios(modulus_ratio: float) -> list[float]:
    """Moduli about that of an assembly, over the specification's, within those of the mechanics."""
    return np.clip(MODULUS_RATIOS * modulus_ratio, MODULUS_RATIOS[0], MODULUS_RATIOS[-1]).tolist()


def agreement(
    spec: ObjectSpec,
    presses: RecordedPresses,
    predictions: Predictions,
    face: int | None,
    seed: int,
) -> Agreement:
    """Figures of merit on a face's own channels (and the presses on it), or on all."""
    rows, channels = _chosen(spec, presses, face)
    recorded = presses.signal_counts[rows][:, channels]
    is_recorded = np.isfinite(recorded)
    recorded = np.where(is_recorded, recorded, 0.0)
    predicted = np.where(is_recorded[:, None], predictions.counts[rows][:, :, channels], 0.0)
    by_ratio = np.where(is_recorded[:, None], predictions.by_ratio[:, rows][..., channels], 0.0)
    sizes = np.linalg.norm(by_ratio, axis=-1)
    clear = clear_changes(spec, presses, rows, channels) & is_recorded
    moduli, bounded = effective_ratios(np.linalg.norm(recorded, axis=1), sizes)
    case = presses.case[rows]
    used, number = np.unique(case, return_inverse=True)
    order = case_permutations(predicted[:, used], number, seed)
    cosine, signs, log_size = score_presses(recorded, predicted[:, used], clear)
    log_modulus = np.log(moduli[:, used] * spec.silicone.youngs_modulus_mpa)
    true_cases = np.arange(len(case)), number
    return Agreement(
        "all channels" if face is None else f"face {face}",
        len(case),
        len(used),
        mean_figure(cosine, number, order),
        mean_figure(signs, number, order),
        float(np.exp(log_size[true_cases].mean())),
        spread_figure(log_size, number, order),
        float(np.exp(log_modulus[true_cases].mean())),
        spread_figure(log_modulus, number, order),
        float(bounded[:, used][true_cases].mean()),
    )


def _chosen(
    spec: ObjectSpec, presses: RecordedPresses, face: int | None
) -> tuple[Int[np.ndarray, "some"], Int[np.ndarray, "channel"]]:
    if face is None:
        return np.arange(len(presses)), np.arange(presses.signal_counts.shape[1])
    return np.flatnonzero(presses.face_of_case(face)[presses.case]), own_channels(spec, face)


def clear_changes(
    spec: ObjectSpec, presses: RecordedPresses, rows: np.ndarray, channels: np.ndarray
) -> Bool[np.ndarray, "press channel"]:
    """Recorded changes that stand out of noise and of the error of a fresh zero."""
    noise = np.tile(presses.noise_counts, presses.signal_counts.shape[1] // 3)[channels]
    sigma = np.hypot(noise / np.sqrt(presses.frames[rows, None]), spec.sensors.zeroing_counts)
    with np.errstate(invalid="ignore"):
        return abs(presses.signal_counts[rows][:, channels]) > _SIGN_SIGMAS * sigma


def score_presses(
    recorded: Float[np.ndarray, "press channel"],
    predicted: Float[np.ndarray, "press case channel"],
    clear: Bool[np.ndarray, "press channel"],
) -> tuple[Float[np.ndarray, "press case"], ...]:
    """Cosine, share of right signs, and ln(recorded size / predicted size)."""
    size = np.linalg.norm(recorded, axis=1)[:, None]
    predicted_size = np.linalg.norm(predicted, axis=2)
    # p press, k case, c channel
    cosine = np.einsum("pc,pkc->pk", recorded, predicted) / (size * predicted_size)
    right = (recorded[:, None] * predicted > 0) & clear[:, None]
    signs = right.sum(axis=2) / np.maximum(clear.sum(axis=1), 1)[:, None]
    return cosine, signs, np.log(size / predicted_size)


def effective_ratios(
    recorded_size: Float[np.ndarray, "press"], sizes: Float[np.ndarray, "ratio press case"]
) -> tuple[Float[np.ndarray, "press case"], Bool[np.ndarray, "press case"]]:
    """Modulus over the specification's at which sizes agree (they fall with it), clamped."""
    ratio = np.empty(sizes.shape[1:])
    bounded = np.empty(sizes.shape[1:], bool)
    for press, case in np.ndindex(ratio.shape):
        falling = np.minimum.accumulate(np.log(sizes[:, press, case]))[::-1]
        wanted = np.log(recorded_size[press])
        ratio[press, case] = np.exp(np.interp(wanted, falling, np.log(MODULUS_RATIOS)[::-1]))
        bounded[press, case] = falling[0] <= wanted <= falling[-1]
    return ratio, bounded


def case_permutations(
    predicted: Float[np.ndarray, "press case channel"], case: Int[np.ndarray, "press"], seed: int
) -> Int[np.ndarray, "permutation case"]:
    """Exchanges of cases that press the same faces, the true order first."""
    count = predicted.shape[1]
    allowed = np.array(
        [np.isfinite(predicted[case == number]).all((0, 2)) for number in range(count)]
    )
    if factorial(count) <= factorial(_LARGEST_ENUMERATED):
        orders = np.array(list(permutations(range(count))))
    else:
        orders = sampled_exchanges(np.unique(allowed, axis=0, return_inverse=True)[1].ravel(), seed)
    return orders[allowed[np.arange(count), orders].all(axis=1)]


def sampled_exchanges(
    group: Int[np.ndarray, "case"], seed: int
) -> Int[np.ndarray, "permutation case"]:
    """The true order, then random exchanges within groups of cases that the same presses predict."""
    rng = np.random.default_rng((seed, 8))
    orders = np.tile(np.arange(len(group)), (1 + _SAMPLED_PERMUTATIONS, 1))
    for number in range(group.max() + 1):
        same = np.flatnonzero(group == number)
        orders[1:, same] = rng.permuted(orders[1:, same], axis=1)
    return orders


def mean_figure(
    values: Float[np.ndarray, "press case"], case: np.ndarray, order: np.ndarray
) -> Figure:
    """Mean over presses; larger is better."""
    means = _permuted_means(values, case, order)
    p = _share(means >= means[0] - 1e-12)
    return Figure(float(means[0]), float(np.median(means)), p, len(order))


def spread_figure(
    logarithms: Float[np.ndarray, "press case"], case: np.ndarray, order: np.ndarray
) -> Figure:
    """Factor of one standard deviation over presses; smaller is better."""
    mean = _permuted_means(logarithms, case, order)
    square = _permuted_means(logarithms**2, case, order)
    spread = np.exp(np.sqrt(np.maximum(square - mean**2, 0)))
    p = _share(spread <= spread[0] + 1e-12)
    return Figure(float(spread[0]), float(np.median(spread)), p, len(order))


def _permuted_means(
    values: Float[np.ndarray, "press case"], case: np.ndarray, order: np.ndarray
) -> Float[np.ndarray, "permutation"]:
    sums = np.zeros((order.shape[1], values.shape[1]))
    np.add.at(sums, case, np.nan_to_num(values))
    return sums[np.arange(order.shape[1]), order].sum(axis=1) / len(values)


def _share(good: Bool[np.ndarray, "permutation"]) -> float:
    return float(np.mean(good))


def channel_rows(
    presses: RecordedPresses, predictions: Predictions, names: list[str]
) -> list[dict[str, Any]]:
    """Each channel over all presses: correlation, share of right signs, recorded over predicted."""
    predicted = predictions.counts[np.arange(len(presses)), presses.case]
    rows = []
    for channel, name in enumerate(names):
        recorded, model = presses.signal_counts[:, channel], predicted[:, channel]
        if not np.isfinite(recorded).all():
            rows.append({"channel": name, "correlation": None, "signs": None, "gain": None})
            continue
        rows.append(
            {
                "channel": name,
                "correlation": rank_correlation(recorded, model),
                "signs": float(np.mean(recorded * model > 0)),
                "gain": float(recorded @ model / (model @ model)),
            }
        )
    return rows


def rank_correlation(recorded: np.ndarray, model: np.ndarray) -> float | None:
    """None where one of them is the same in all presses."""
    if np.ptp(recorded) == 0 or np.ptp(model) == 0:
        return None
    return float(np.corrcoef(recorded, model)[0, 1])


def verdict(spec: ObjectSpec, result: Agreement) -> str:
    """In words: what the recordings support of the model, and what not."""
    low, high = spec.silicone.modulus_interval_mpa
    inside = low <= result.modulus_mpa <= high
    near = 1 / SIZE_BAND <= result.size_ratio <= SIZE_BAND
    sized = result.size_spread.judgement if near else "not supported"
    scatter = _scatter_text(result.modulus_spread)
    return (
        f"{result.what}: pattern {result.cosine.judgement} (cosine {result.cosine.value:.2f}, null "
        f"{result.cosine.null:.2f}, p {result.cosine.p:.3g}); signs right in "
        f"{100 * result.signs.value:.0f} % (null {100 * result.signs.null:.0f} %, p "
        f"{result.signs.p:.3g}); absolute size {sized} (recorded "
        f"{result.size_ratio:.2f} of predicted, scatter ×/÷ {result.size_spread.value:.2f}, null "
        f"{result.size_spread.null:.2f}); effective modulus {result.modulus_mpa:.2f} MPa ×/÷ "
        f"{result.modulus_spread.value:.2f}, {'inside' if inside else 'outside'} "
        f"{low:g} to {high:g} MPa, {scatter}"
    )


def _scatter_text(figure: Figure) -> str:
    if untold := cannot_be_told(figure.exchanges):
        return f"whether its scatter is smaller than that of places exchanged {untold}"
    how = "smaller" if figure.significant else "no smaller"
    return f"its scatter {how} than that of places exchanged (p {figure.p:.3g})"
