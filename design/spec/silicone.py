"""The silicone in a specification: elastic constants with their spread, density, relaxation."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from design.catalogue.silicones import (
    SILICONES,
    Casting,
    ModulusEstimate,
    Silicone,
    modulus_from_shore,
)
from design.spec.base import Density, Length, SpecPart

Modulus = Annotated[float, Field(ge=0.001, le=50)]
"""Young's modulus (MPa): of soft foams and gels 0.001, of printed TPU 17."""


PronyTerm = tuple[Annotated[float, Field(gt=0, lt=1)], Annotated[float, Field(ge=1e-4, le=1e7)]]
"""Fraction of the instantaneous modulus that is lost, and its time, s."""
Layer = tuple[Length, Annotated[float, Field(ge=1e-3, le=1e3)]]
"""Thickness, mm, and Young's modulus over the body's; Poisson's ratio is the same."""


class SiliconeSpec(SpecPart):
    """Elastic constants and density of the cured silicone, or of what the soft body is made of.

    A printed lattice or a foam is described by the constants of a homogeneous body that yields as
    it does: its own modulus, far below that of its struts, and its own Poisson's ratio.

    Figures that are left out are those of the preset `name`, the modulus that of `modulus_from`, a Shore
    hardness or the CSV file of a tensile test, where it is given; an explicit modulus goes before all.
    `youngs_modulus_range_mpa` is the interval that the modulus may lie in, unknown where an explicit one
    lies outside its source's.
    0.414 MPa is Gent's (1958) relation at Shore A10; the public recordings fit 0.23 to 0.28 MPa.

    `cure` is its chemistry (what is not cast, as printed TPU, has "none"), Walls below
    `thinnest_wall_mm` tear.

    `layers` are others of its kind over the body, from the outer surface inwards: the closed skin of
    a printed lattice, a harder pour. Each is a thickness (mm) and its modulus over the body's. They
    end at equal distances from the core.

    With `prony` terms (fraction, time in s) the modulus is the instantaneous one,
    E(t) = E (1 − Σ fraction (1 − exp(−t/time))).
    """

    name: str = "Platsil Gel-10"
    modulus_from: str | None = None
    youngs_modulus_mpa: Modulus = 0.414
    youngs_modulus_range_mpa: tuple[Modulus, Modulus] | None = (0.15, 0.54)
    poisson_ratio: Annotated[float, Field(ge=-0.3, le=0.5)] = 0.4999
    density_g_per_cm3: Density = 1.07
    layers: tuple[Layer, ...] = ()
    prony: tuple[PronyTerm, ...] = ()
    cure: Literal["platinum", "tin", "none"] = "platinum"
    elongation_percent: Annotated[float, Field(ge=1, le=3000)] = 970.0
    thinnest_wall_mm: Annotated[float, Field(ge=0.05, le=50)] = 1.0

    @model_validator(mode="before")
    @classmethod
    def _figures_left_out(cls, given: Any) -> Any:
        return {**_figures(given), **given} if isinstance(given, dict) else given

    @model_validator(mode="after")
    def _range_holds_the_modulus(self) -> SiliconeSpec:
        if self.youngs_modulus_range_mpa is not None:
            low, high = self.youngs_modulus_range_mpa
            if not low <= self.youngs_modulus_mpa <= high:
                raise ValueError(
                    "silicone.youngs_modulus_range_mpa must be [lowest, highest] around "
                    f"youngs_modulus_mpa = {self.youngs_modulus_mpa:g}; got [{low:g}, {high:g}]. "
                    "Fix one of them"
                )
        return self

    @model_validator(mode="after")
    def _relaxes_to_a_solid(self) -> SiliconeSpec:
        lost = sum(fraction for fraction, _ in self.prony)
        if lost >= 1:
            raise ValueError(
                f"the fractions of silicone.prony must sum to less than 1; got {lost:g}. The rest is "
                "what the modulus relaxes to"
            )
        return self

    @property
    def surface_modulus_mpa(self) -> float:
        """Young's modulus right under the outer surface."""
        return self.youngs_modulus_mpa * (self.layers[0][1] if self.layers else 1.0)

    @property
    def casting(self) -> Casting | None:
        """Mixing ratio and times of the preset; None of a silicone of one's own: its maker's sheet has
        them."""
        return SILICONES[self.name].casting if self.name in SILICONES else None

    @property
    def modulus_source(self) -> str:
        """Return where the modulus comes from, in words."""
        estimate = _estimate(self.name, self.modulus_from)
        if estimate is not None and estimate.youngs_modulus_mpa == self.youngs_modulus_mpa:
            return estimate.source
        return f"fitted to {self.modulus_from}" if is_test_file(self.modulus_from) else "given"

    @property
    def relative_spread(self) -> tuple[float, float] | None:
        """Ends of the modulus's interval over the modulus; forces at a depth scale with it."""
        if self.youngs_modulus_range_mpa is None:
            return None
        low, high = self.youngs_modulus_range_mpa
        return low / self.youngs_modulus_mpa, high / self.youngs_modulus_mpa

    @property
    def modulus_interval_mpa(self) -> tuple[float, float]:
        """Ends of the modulus's interval, the modulus itself twice where none is known."""
        return self.youngs_modulus_range_mpa or (self.youngs_modulus_mpa, self.youngs_modulus_mpa)

    def softer(self) -> tuple[list[Silicone], list[Silicone]]:
        """Return the casting silicones of the same cure that are surely softer, and the ones that may be;
        each the firmest first.

        Sources differ by more than neighbours in the catalogue do: of two moduli whose intervals overlap
        nobody knows which is the lower one.
        """
        lower = [
            silicone
            for silicone in SILICONES.values()
            if silicone.casting is not None
            and silicone.casting.cure == self.cure
            and silicone.modulus.youngs_modulus_mpa < self.youngs_modulus_mpa
        ]
        lower.sort(key=lambda silicone: -silicone.modulus.youngs_modulus_mpa)
        least_mpa, _ = self.modulus_interval_mpa
        surely = [silicone for silicone in lower if silicone.modulus.high_mpa < least_mpa]
        return surely, [silicone for silicone in lower if silicone not in surely]


def _figures(given: dict[str, Any]) -> dict[str, Any]:
    """The source's figures where `given` has none; values of wrong types are left to pydantic."""
    name, source = given.get("name", "Platsil Gel-10"), given.get("modulus_from")
    modulus = given.get("youngs_modulus_mpa")
    if not isinstance(name, str) or not isinstance(source, str | None):
        return {}
    estimate = _estimate(name, source)
    if modulus is None:
        if is_test_file(source):
            raise ValueError(
                f"silicone.modulus_from = {source!r} is read where a specification is loaded from a "
                "file. Give silicone.youngs_modulus_mpa, or load the file"
            )
        estimate = estimate or SILICONES.named(name).modulus
        modulus = estimate.youngs_modulus_mpa
    numeric = isinstance(modulus, int | float)
    spread = (
        estimate.range_mpa if estimate and numeric and estimate.admits(float(modulus)) else None
    )
    return _preset_figures(name) | {
        "youngs_modulus_mpa": modulus,
        "youngs_modulus_range_mpa": spread,
    }


def is_test_file(modulus_from: str | None) -> bool:
    """Return whether `silicone.modulus_from` names the file of a tensile test, not a hardness."""
    return modulus_from is not None and modulus_from.lower().endswith(".csv")


def _estimate(name: str, modulus_from: str | None) -> ModulusEstimate | None:
    if modulus_from is not None and not is_test_file(modulus_from):
        return modulus_from_shore(modulus_from)
    return SILICONES[name].modulus if name in SILICONES else None


def _preset_figures(name: str) -> dict[str, Any]:
    if name not in SILICONES:
        return {}
    preset = SILICONES[name]
    figures = {
        "poisson_ratio": preset.poisson_ratio,
        "density_g_per_cm3": preset.density_g_per_cm3,
    }
    if preset.casting is not None:
        figures |= {"cure": preset.casting.cure}
        figures |= {"elongation_percent": preset.casting.elongation_percent}
    return figures
