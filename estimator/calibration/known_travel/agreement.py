"""Predicted against recorded changes of presses of known travel, against nulls and simple rivals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import permutations
from typing import Any

import numpy as np
from jaxtyping import Float

from estimator.calibration.known_travel.fit import Fitted
from estimator.calibration.known_travel.model import TravelModel
from estimator.recordings.formats.travel import TravelRecording

SMALLEST_MT = 0.03
"""Recorded changes below have no sign: about four times the noise of a reading."""
ORDERS_OF_CHIPS = 120
"""Random orders of chips that are compared where all orders are too many."""

Changes = Float[np.ndarray, "press sensor 3"]


@dataclass(frozen=True)
class TravelFigures:
    """Figures over some presses.

    cosine : median cosine between predicted and recorded change, all channels of a press
    explained : 1 − Σ|recorded − predicted|² / Σ|recorded|², no gain fitted
    between : the same about the mean over these presses: what differs between places and travels
    signs : share of recorded changes beyond `SMALLEST_MT` whose sign is predicted
    size : factor on the prediction that fits best
    """

    presses: int
    cosine: float
    explained: float
    between: float
    signs: float
    size: float


@dataclass(frozen=True)
class TravelAgreement:
    """Figures of all judged presses, by travel, of the nulls and of the rivals."""

    all: TravelFigures
    beyond_mm: float
    beyond: TravelFigures
    by_travel: dict[str, TravelFigures]
    places_exchanged: list[TravelFigures]
    chips_permuted: list[TravelFigures]
    rivals: dict[str, TravelFigures]

    @property
    def order_of_chips(self) -> int:
        """Place of the true order of chips among all, by cosine: 1 is best."""
        return 1 + sum(permuted.cosine >= self.all.cosine for permuted in self.chips_permuted)

    def summary(self) -> dict[str, Any]:
        """Ready for JSON: nulls by median and best."""
        nulls = {
            name: {
                figure: [float(np.median(values)), float(np.max(values))]
                for figure in ("cosine", "explained", "between", "signs")
                if (values := [getattr(figures_of_null, figure) for figures_of_null in group])
            }
            for name, group in (
                ("places exchanged", self.places_exchanged),
                ("chips permuted", self.chips_permuted),
            )
        }
        return {
            "all": asdict(self.all),
            f"beyond {self.beyond_mm:g} mm": asdict(self.beyond),
            "by travel": {
                name: asdict(figures_of_null) for name, figures_of_null in self.by_travel.items()
            },
            "nulls, median and best": nulls,
            "order of chips": self.order_of_chips,
            "rivals": {
                name: asdict(figures_of_null) for name, figures_of_null in self.rivals.items()
            },
        }


def figures(predicted: Changes, recorded: Changes) -> TravelFigures:
    """Figures of any presses."""
    p, m = (given.reshape(len(given), -1) for given in (predicted, recorded))
    dots = np.sum(p * m, axis=1)
    lengths = np.linalg.norm(p, axis=1) * np.linalg.norm(m, axis=1)
    cosine = np.divide(dots, lengths, out=np.zeros(len(p)), where=lengths > 0)
    residual = np.sum((m - p) ** 2)
    signed = np.abs(m) > SMALLEST_MT
    return TravelFigures(
        len(p),
        float(np.median(cosine)),
        float(1 - residual / np.sum(m**2)),
        float(1 - residual / np.sum((m - m.mean(axis=0)) ** 2)),
        float(np.mean(np.sign(p[signed]) == np.sign(m[signed]))),
        float(np.sum(p * m) / max(np.sum(p**2), 1e-30)),
    )


def travel_agreement(
    model: TravelModel,
    fitted: Fitted,
    registered: TravelRecording,
    judged: TravelRecording,
    exchanges: int,
    beyond_mm: float = 1.0,
    seed: int = 0,
) -> TravelAgreement:
    """Judge a fit on other presses than it was made on.

    The null of exchanged places keeps every press's travel and resting level and gives it the place
    of another; that of permuted chips tries all other orders of the chips.
    """
    xy, travel = fitted.twin.pose.locate_tips(judged.tip_mm)
    recorded = judged.field_mt - fitted.resting_mt
    motion = model.motion(xy, travel)
    predicted = model.change(fitted.twin, motion)
    rng = np.random.default_rng((seed, 14))
    exchanged = [
        figures(model.change(fitted.twin, model.motion(rng.permutation(xy), travel)), recorded)
        for _ in range(exchanges)
    ]
    rivals = rival_figures(model, fitted, registered, judged)
    return agreement_of(predicted, recorded, travel, beyond_mm, exchanged, rivals)


def agreement_of(
    predicted: Changes,
    recorded: Changes,
    travel: Float[np.ndarray, "press"],
    beyond_mm: float,
    places_exchanged: list[TravelFigures],
    rivals: dict[str, TravelFigures],
) -> TravelAgreement:
    """Figures of changes at these travels (mm), of each millimetre, and of all orders of the chips."""
    deep, steps = travel > beyond_mm, np.arange(0, np.ceil(travel.max()))
    return TravelAgreement(
        figures(predicted, recorded),
        beyond_mm,
        figures(predicted[deep], recorded[deep]),
        {
            f"{low:g} to {low + 1:g} mm": figures(predicted[rows], recorded[rows])
            for low in steps
            if (rows := (travel >= low) & (travel < low + 1)).sum() > 1
        },
        places_exchanged,
        [figures(predicted[:, list(order)], recorded) for order in chip_orders(predicted.shape[1])],
        rivals,
    )


def chip_orders(sensors: int) -> Sequence[tuple[int, ...]]:
    """Orders of the chips other than the true one: all of up to five chips, else a random draw."""
    true = tuple(range(sensors))
    if sensors <= 5:
        return [order for order in permutations(true) if order != true]
    rng = np.random.default_rng(5)
    return [tuple(rng.permutation(sensors).tolist()) for _ in range(ORDERS_OF_CHIPS)]


def rival_figures(
    model: TravelModel,
    fitted: Fitted,
    registered: TravelRecording,
    judged: TravelRecording,
) -> dict[str, TravelFigures]:
    """Models that know no mechanics, fitted to the same registered presses, on the same travel.

    "all magnets sink alike" knows the magnets and one number, their sinking per travel; "mean of the
    registered presses" fifteen, the change of every channel per travel.
    """
    pose, recorded = fitted.twin.pose, judged.field_mt - fitted.resting_mt
    registered_change = registered.field_mt - fitted.resting_mt
    shown, travel = pose.locate_tips(registered.tip_mm)[1], pose.locate_tips(judged.tip_mm)[1]
    # Least squares through 0 of each channel over the travel: n press, s sensor, i axis
    slope = np.einsum("n,nsi->si", shown, registered_change) / np.sum(shown**2)
    share = [k / 20 for k in range(1, 21)]
    sunk = [_sunk(model, fitted, ratio * shown) for ratio in share]
    best = share[
        int(np.argmin([np.sum((registered_change - sunk_change) ** 2) for sunk_change in sunk]))
    ]
    return {
        "all magnets sink alike": figures(_sunk(model, fitted, best * travel), recorded),
        "mean of the registered presses": figures(travel[:, None, None] * slope, recorded),
    }


def _sunk(model: TravelModel, fitted: Fitted, by_mm: Float[np.ndarray, "press"]) -> Changes:
    motion = np.zeros((len(by_mm), model.scene.bodies, 6))
    motion[:, :, 2] = -by_mm[:, None]
    return model.change(fitted.twin, motion)
