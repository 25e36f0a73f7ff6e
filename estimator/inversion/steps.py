"""State of an object between steps of a simulation: forces that relaxed, and frames under way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from jaxtyping import Float

from design.spec.silicone import PronyTerm
from estimator.inversion.model.arrays import Array, library, like


class Sampling:
    """Frames at the chips' rate, each read when it has arrived."""

    def __init__(self, rate_hz: float, delay_s: float) -> None:
        self._period_s, self._delay_s = 1 / rate_hz, delay_s
        self._now_s = self._next_s = 0.0
        self._under_way: list[tuple[float, Array]] = []

    def arrived(self, counts: Array, step_s: float) -> Array:
        """Return the last frame that has arrived, of the counts now and of former steps."""
        if not step_s:
            return counts
        self._now_s += step_s
        # sums of steps err in the last bits: a frame is due within a millionth of a period
        due_s = self._now_s + 1e-6 * self._period_s
        if due_s >= self._next_s:
            self._under_way.append((self._now_s + self._delay_s, counts))
            self._next_s = max(self._next_s + self._period_s, self._now_s)
        while len(self._under_way) > 1 and self._under_way[1][0] <= due_s:
            self._under_way.pop(0)
        # before the first frame arrives, that frame is all there is
        return self._under_way[0][1]


class Relaxation:
    """Forces that relaxed silicone bears, as forces of the elastic presses that move magnets as far.

    A Prony series (`fem.presses.viscoelastic`), by face: contacts of a simulator come and go, and
    the sum over a face is what lasts.
    """

    def __init__(self, prony: Sequence[PronyTerm]) -> None:
        self._fraction = np.array([fraction for fraction, _ in prony])
        self._time_s = np.array([time_s for _, time_s in prony])
        self._memory_n: Array = None
        self._elastic_n: Array = None

    def stiffening(
        self,
        on_face: Array,
        force_n: Float[Array, "object contact"],
        step_s: float,
    ) -> Any:
        """Return the factor on the force of each contact (object, contact, face) after a step."""
        felt = (on_face * force_n[..., None]).sum(1)
        fraction, time_s = (
            like(force_n, given)[:, None, None] for given in (self._fraction, self._time_s)
        )
        if self._memory_n is None:
            self._memory_n, self._elastic_n = 0 * fraction * felt, 0 * felt
        decay = library(fraction).exp(-step_s / time_s)
        # memory' = decay memory + gain (elastic' - elastic); gain of a linear rise within the step
        gain = (1 - decay) * time_s / step_s if step_s else 0 * decay + 1
        held = (fraction * (decay * self._memory_n - gain * self._elastic_n)).sum(0)
        lasting = 1 - fraction.sum() + (fraction * gain).sum()
        # felt = (1 - sum of fractions) elastic' + sum of fractions memory', solved for elastic'
        elastic = (felt - held).clip(0.0) / lasting
        self._memory_n = decay * self._memory_n + gain * (elastic - self._elastic_n)
        self._elastic_n = elastic
        factor = elastic / (felt + (felt == 0))
        return (on_face * factor[:, None]).sum(-1)
