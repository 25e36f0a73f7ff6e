"""The estimator of a whole object that inverts its forward model."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from jaxtyping import Float, Int
from scipy.special import expit

from design.errors import InputError
from design.layout.tips import footprint_mm, tip_positions_mm
from design.spec.object import ObjectSpec
from estimator.field.device import card_tensor
from estimator.frames.dataset import NO_FACE
from estimator.frames.face_data import Channel
from estimator.information.shear import ShearSignals
from estimator.inversion.evidence import contact_blocks, joint_covariance
from estimator.inversion.explained import UNEXPLAINED, ErrorShare, excess
from estimator.inversion.jaws import JawFit, Jaws
from estimator.inversion.lying import log_evidence_without, lying_chips
from estimator.inversion.magnets import BesideMagnet, slip_columns
from estimator.inversion.model.forward import NONE, ContactModel, contact_model
from estimator.inversion.model.noise import Disturbances, disturbances
from estimator.inversion.priors import Priors
from estimator.inversion.problems import BLIND, Observations, Problems
from estimator.inversion.readings import (
    ContactSets,
    among_sets,
    contact_sets,
    doubted,
    jaw_set,
    widened,
)
from estimator.inversion.search import Hypotheses, Search
from estimator.signals.nuisances import magnet_columns
from estimator.signals.presses import Signals
from fem.contact.jaw import JawFace
from fem.presses.results import MagnetMotions, PressForces

_FRAMES_AT_ONCE, FRAMES_ON_A_CARD = 100, 1000
"""Frames inverted together, on the processor and on a graphics card."""
LEAST_FORCE_N = 0.2
"""Smallest force of a contact that is read: about the least that the paper's cube detects."""
MANY_FRAMES = 100
"""Fewest frames for which a graphics card saves time."""
_QUIET = 0.5
"""p value that the truth exceeds in one of two frames."""
SURE, _DOUBTFUL = 1.5, -3.0
"""Log of the odds of jaws over tips from which they are read, 4 to 1: weak tips came to 7 to 1 once in 126
frames. And from which they make tips less certain, 1 to 20."""
KNOWN_FORCE_SPREAD = 0.3
"""Relative standard deviation of the forces of one probe's tips."""


@dataclass(frozen=True)
class Inversion:
    """Reads contacts anywhere on an object, from one frame or the mean of a hold, with no training.

    Attributes
    ----------
    model : what contacts do to the signals
    disturbances : what else does
    priors : what is believed of contacts
    jaw_tables : of the flat faces, which jaws may press; empty where none are looked for
    """

    model: ContactModel
    disturbances: Disturbances
    priors: Priors
    jaw_tables: tuple[JawFace, ...] = ()

    @cached_property
    def channels(self) -> tuple[Channel, ...]:
        """Return the live channels: face number, sensor and axis counted from 0."""
        faces = self.model.signals.faces.tolist()
        sensors = self.model.channels // (3 * len(faces))
        all_channels = list(product(faces, range(sensors), range(3)))
        return tuple(all_channels[channel] for channel in self.live_rows)

    @cached_property
    def live_rows(self) -> Int[np.ndarray, "live_rows"]:
        """Rows of `channels` among all channels of the object."""
        return np.flatnonzero(self.disturbances.noise_counts < BLIND)

    def chip_name(self, chip: int) -> str:
        """Return a chip's name as in a recording's channels, without the axis; empty for `NONE`."""
        if chip == NONE:
            return ""
        faces = self.model.signals.faces
        face, sensor = divmod(chip, self.model.channels // (3 * len(faces)))
        return f"F{faces[face]}-{sensor + 1}"

    @cached_property
    def lookalike_columns(self) -> tuple[Float[np.ndarray, "channel k"], ...]:
        """Return what looks like presses, counts per standard deviation: magnets near by, by their distance;
        last a small slip of the core."""
        magnets, slip = magnet_columns(self.model.spec), slip_columns(self.model)
        more = magnets[0].shape[1] - slip.shape[1]
        return *magnets, np.pad(slip, ((0, 0), (0, more)))

    @cached_property
    def jaws(self) -> Jaws:
        """Return the jaws that frames are read as."""
        return Jaws(self.model, self.jaw_tables, self.priors.number)

    @cached_property
    def search(self) -> Search:
        """Return the search from scratch."""
        return Search(self.model, self.priors)

    def search_for(self, frames: int) -> Search:
        """Return the search; many frames use the graphics card of `INSTOBJ_DEVICE`, where it names one."""
        device = card_tensor() if frames >= MANY_FRAMES else None
        if device is None:
            return self.search
        card = str(device.device)
        if card not in self._card_searches:
            self._card_searches[card] = Search(self.model.moved_to(device), self.priors)
        return self._card_searches[card]

    @cached_property
    def _card_searches(self) -> dict[str, Search]:
        return {}

    def error_share(self) -> ErrorShare:
        """Return the share of the model's error that frames show, before any frame was read."""
        return ErrorShare(self.model, self.priors)

    def read(
        self,
        counts: Float[np.ndarray, "frame channel"],
        averaged: Int[np.ndarray, "frame"] | None = None,
        progress: Callable[[int], None] | None = None,
    ) -> tuple[ContactSets, ContactSets]:
        """The most probable contacts of every frame by itself, and the next best answer, of odds 0 where
        there is none. Many frames are read on the graphics card that `INSTOBJ_DEVICE` names.

        Parameters
        ----------
        counts : changes against rest; NaN where a channel has no reading
        averaged : number of frames of a hold that each is the mean of; 1 by default
        progress : takes the number of frames done

        Raises
        ------
        InputError
            No frame, or no such graphics card.
        """
        if not len(counts):
            raise InputError("there is no frame to read contacts in. Give a file that holds frames")
        search = self.search_for(len(counts))
        at_once = _FRAMES_AT_ONCE if search is self.search else FRAMES_ON_A_CARD
        parts, error = [], self.error_share()
        for start in range(0, len(counts), at_once):
            part = slice(start, start + at_once)
            means_of = None if averaged is None else averaged[part]
            parts.append(
                self.read_part(search, self.disturbances.observed(counts[part], means_of), error)
            )
            if progress is not None:
                progress(min(start + at_once, len(counts)))
        best, second = zip(*parts, strict=True)
        return ContactSets.joined(best), ContactSets.joined(second)

    def read_part(
        self, search: Search, observations: Observations, error: ErrorShare
    ) -> tuple[ContactSets, ContactSets]:
        """Some frames at once. Those that nothing explains are read again without a chip that lies, those
        that a magnet near by explains better with its field as a nuisance: no contact explains these."""
        best, second, believed = self.read_once(search, observations, error)
        sets = [self._try_jaws(observations, best, believed), second]
        strange = np.flatnonzero(~sets[0].explained)
        if len(strange):
            chip = lying_chips(search, observations.select(strange), error)
            rows, chip = strange[chip != NONE], chip[chip != NONE]
            if len(rows):
                frames = observations.select(rows)
                *again, sound = self.read_once(search, frames.without(chip), error)
                lies = ~BesideMagnet(frames, self.lookalike_columns).is_likelier_than_chip(
                    search, believed.select(rows), log_evidence_without(search, frames, chip, sound)
                )
                sets = [
                    old.replaced(rows[lies], replace(new.select(lies), chip_out=chip[lies]))
                    for old, new in zip(sets, again, strict=True)
                ]
        return self._read_beside_magnet(search, observations, error, (sets[0], sets[1]), believed)

    def _try_jaws(
        self, observations: Observations, tips: ContactSets, believed: Hypotheses
    ) -> ContactSets:
        """The same sets, but for frames that jaws explain as well as the tips `believed`."""
        for row in np.flatnonzero(tips.number) if self.jaw_tables else ():
            only = np.array([row])
            frame, evidence = tips.select(only), float(believed.log_evidence[row])
            fit = self.rival_jaws(observations.select(only), frame, evidence)
            if fit is not None:
                tips = tips.replaced(only, self.weighed(fit, frame, evidence))
        return tips

    @property
    def flat(self) -> bool:
        """Return whether contacts are known to be jaws."""
        return self.model.spec.inversion.probes == "flat"

    def rival_jaws(
        self, observations: Observations, tips: ContactSets, log_evidence: float
    ) -> JawFit | None:
        """Return the jaws that explain one frame best; None where they are far less probable than its tips,
        whose evidence is given.

        Where one tip a face leaves no more than noise does, jaws must explain as much with signals taken for
        linear: strong ones do not pass for a tip.
        """
        faces = tips.face[0][tips.face[0] != NO_FACE]
        if not self.jaw_tables or not len(faces):
            return None
        quiet = len(faces) == len(np.unique(faces)) and bool(tips.p_value[0] > _QUIET)
        least = -np.inf if self.flat else _evidence_of_all(tips, log_evidence) + _DOUBTFUL
        return self.jaws.fit(observations, self.jaws.groups(faces.tolist()), least, quiet)

    def jaw_reading(self, fit: JawFit, tips: ContactSets) -> ContactSets:
        """Return a frame's jaws in place of its tips."""
        return jaw_set(fit, tips).with_force_error(self.disturbances.force_error)

    def weighed(
        self, fit: JawFit, tips: ContactSets, log_evidence: float, least: float = SURE
    ) -> ContactSets:
        """Return jaws in place of a frame's tips where the log of their odds exceeds `least`; else tips, as
        uncertain as jaws make them."""
        jaws = self.jaw_reading(fit, tips)
        log_odds = fit.log_evidence - _evidence_of_all(tips, log_evidence)
        if self.flat or log_odds > least:
            return jaws
        return tips if log_odds < _DOUBTFUL else doubted(tips, jaws, float(expit(log_odds)))

    def _read_beside_magnet(
        self,
        search: Search,
        observations: Observations,
        error: ErrorShare,
        sets: tuple[ContactSets, ContactSets],
        believed: Hypotheses,
    ) -> tuple[ContactSets, ContactSets]:
        """The same sets, but for frames that a magnet near by explains better than those `believed`."""
        fewer = BesideMagnet(observations, self.lookalike_columns).explains_with_fewer(
            search, believed
        )
        fewer &= ~sets[0].jaws
        rows = np.flatnonzero((~sets[0].explained | fewer) & (sets[0].chip_out == NONE))
        if not len(rows):
            return sets
        frames = BesideMagnet(observations.select(rows), self.lookalike_columns)
        *again, wide = self.read_once(search, frames.wide, error)
        better = frames.log_evidence(search, wide.problems) > believed.log_evidence[rows]
        best, second = (
            old.replaced(rows[better], replace(new.select(better), p_value=np.zeros(better.sum())))
            for old, new in zip(sets, again, strict=True)
        )
        return best, second

    def read_once(
        self, search: Search, observations: Observations, error: ErrorShare
    ) -> tuple[ContactSets, ContactSets, Hypotheses]:
        """Some frames at once, all that is seen believed; also what the best sets were read from."""
        hypotheses = search.contacts(observations)
        best = hypotheses.best()
        second = hypotheses.second(best)
        odds_of_second = np.where(second == best, 0.0, hypotheses.odds[second])
        best_sets, second_sets = (
            hypotheses.problems.select(rows).to_host() for rows in (best, second)
        )
        spread = among_sets(hypotheses, best, self.priors)
        error.learn(observations, best_sets)
        return (
            self.reading(observations, best_sets, hypotheses.odds[best], error, spread),
            self.reading(observations, second_sets, odds_of_second, error),
            Hypotheses(best_sets, hypotheses.log_evidence[best]),
        )

    def reading(
        self,
        observations: Observations,
        problems: Problems,
        odds: Float[np.ndarray, "frame"],
        error: ErrorShare,
        covariance: Float[np.ndarray, "frame contact 3 3"] | None = None,
    ) -> ContactSets:
        """Contacts with all that is uncertain of them; `covariance` as in `contact_sets`.

        Where nothing explains a frame, regions are as wide as what is left unexplained asks for.
        """
        p_value = error.refitted_p_values(observations, problems, error.share)[:, 0]
        joint = joint_covariance(problems, self.priors)
        if covariance is None:
            covariance = contact_blocks(joint)
        if np.any(p_value < UNEXPLAINED):
            factor = np.where(p_value < UNEXPLAINED, excess(observations, problems), 1.0)
            covariance = widened(covariance, factor, self.priors)
        sets = contact_sets(
            self.model, self.priors, observations, problems, odds, p_value, covariance, joint
        )
        units = self.disturbances.deviations
        # The unknowns of a magnet near by stand behind them and are left out.
        change, sigma = (
            units * column[:, : len(units)] for column in (sets.since_zero, sets.since_zero_sigma)
        )
        sets = replace(sets, since_zero=change, since_zero_sigma=sigma)
        return sets.with_force_error(self.disturbances.force_error)


def _evidence_of_all(tips: ContactSets, log_evidence: float) -> float:
    """Log evidence of tips of any places and numbers: those of other numbers share the rest of the odds."""
    return log_evidence - float(np.log(tips.odds[0]))


def inversion(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    signals: Signals,
    model_error: float | Float[np.ndarray, "sensor 1"],
    force_error: float,
    shear: ShearSignals | None = None,
) -> Inversion:
    """The estimator of an object whose single presses give `signals` on the design's mechanics.

    `model_error` counts where `inversion.model_error` is left out; `force_error` comes from the
    modulus. `shear` holds the signals of tangential forces.

    Raises
    ------
    InputError
        A force that does not grow with depth, known probes that do not fit on the faces, or
        tangential forces without `shear`.
    """
    model = contact_model(spec, forces, motions, signals, shear)
    error = model_error if spec.inversion.model_error is None else spec.inversion.model_error
    return Inversion(model, disturbances(spec, error, force_error), contact_priors(model))


def contact_priors(model: ContactModel) -> Priors:
    """Return the priors that `[inversion]` asks for.

    Every number of contacts is equally likely, and so is every location of the table and every force
    up to the table's largest. Tips of the specification's indenter stand apart.
    """
    options, (_, high) = model.spec.inversion, model.bounds
    faces, radius = (
        len(model.signals.faces),
        float(np.ptp(footprint_mm(model.spec.indenter), axis=0).min()),
    )
    known_probes = options.probes == "known"
    return Priors(
        tuple(np.full(options.contacts + 1, 1 / (options.contacts + 1)).tolist()),
        faces,
        model.area_mm2,
        (LEAST_FORCE_N, float(high[2])),
        radius,
        KNOWN_FORCE_SPREAD if known_probes else None,
        probe_spacing_mm(radius / 2) if known_probes else (),
        options.jaws,
    )


def probe_spacing_mm(tip_radius_mm: float) -> tuple[float, ...]:
    """Return the distances (mm) between the tips of the paper's probes of two and three."""
    places = (tip_positions_mm(tips, tip_radius_mm) for tips in (2, 3))
    return tuple(float(np.linalg.norm(xy[1] - xy[0])) for xy in places)
