"""The specification of an instrumented object: frozen, validated, with units in the field names.

Every later stage is a function of an `ObjectSpec`. Lengths are in mm, stresses in MPa, flux
densities in T (fields of sensors in mT), forces in N. Defaults are the paper's cube
(Knopke et al., RA-L 2024); docs/units.md gives the source of each figure.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.assembly import AsBuiltSpec, TolerancesSpec
from design.spec.base import SpecPart
from design.spec.body import BodySpec, CoreSpec, ShellSpec
from design.spec.environment import EnvironmentSpec
from design.spec.fabrication import MouldSpec, PrinterSpec
from design.spec.learning import (
    CollectionSpec,
    InversionSpec,
    LimitsSpec,
    ProtocolSpec,
    ScoreSpec,
    TrainingSpec,
)
from design.spec.load_cell import LoadCellSpec
from design.spec.magnets import MagnetSpec
from design.spec.mechanics import ContactGridSpec, IndenterSpec, MechanicsSpec, MeshSpec, PressSpec
from design.spec.search import SearchSpec
from design.spec.sensors import BUS_KHZ, FACES_OF_A_CUBE, SensorSpec, fastest_frame_rate_hz
from design.spec.silicone import SiliconeSpec

LARGEST_SEED = 2**31 - 1
"""NumPy, PyTorch and scikit-learn take it, and a little more for what is counted on from it."""
LARGEST_RATIO_WITHOUT_PRESSURE = 0.4999
"""Poisson's ratio beyond which λ = E ν / ((1 + ν)(1 − 2ν)) alone spoils the factorization's digits."""
LEAST_RATIO_WITH_PRESSURE, LARGEST_RATIO_OF_P2 = 0.01, 0.45
"""1/λ of the mixed form has no value at ν = 0; quadratic displacements alone lock near 0.5."""


class ObjectSpec(SpecPart):
    """A whole instrumented object with everything that its simulation needs.

    Every field and what fields say of each other is validated here. Whether core, pockets, sensors,
    presses and mould fit together needs geometry and is asked of `design.spec_io.check`, which
    `load_spec` and `parse_spec` do.
    """

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]*$", max_length=80)]
    seed: Annotated[int, Field(ge=0, le=LARGEST_SEED)] = 1
    arrangement: Literal["sensors-in-core", "sensors-in-shell"] = "sensors-in-core"
    imu: Literal["none", "LSM6DS3", "LSM6DS3TR-C", "ICM-42688"] = "none"
    body: BodySpec = BodySpec()
    shell: ShellSpec = ShellSpec()
    silicone: SiliconeSpec = SiliconeSpec()
    magnets: MagnetSpec = MagnetSpec()
    core: CoreSpec = CoreSpec()
    sensors: SensorSpec = SensorSpec()
    load_cell: LoadCellSpec = LoadCellSpec()
    environment: EnvironmentSpec = EnvironmentSpec()
    contact_grid: ContactGridSpec = ContactGridSpec()
    indenter: IndenterSpec = IndenterSpec()
    press: PressSpec = PressSpec()
    mesh: MeshSpec = MeshSpec()
    mechanics: MechanicsSpec = MechanicsSpec()
    score: ScoreSpec = ScoreSpec()
    protocol: ProtocolSpec = ProtocolSpec()
    collection: CollectionSpec = CollectionSpec()
    training: TrainingSpec = TrainingSpec()
    inversion: InversionSpec = InversionSpec()
    limits: LimitsSpec = LimitsSpec()
    tolerances: TolerancesSpec = TolerancesSpec()
    as_built: AsBuiltSpec = AsBuiltSpec()
    search: SearchSpec = SearchSpec()
    mould: MouldSpec = MouldSpec()
    printer: PrinterSpec = PrinterSpec()

    def __repr__(self) -> str:
        size = " × ".join(f"{edge:g}" for edge in self.body.size_mm)
        return (
            f"ObjectSpec {self.name}: {self.body.kind} of {size} mm, shell {self.shell.thickness_mm:g} mm; "
            f"{self.magnets.count} magnets and {self.sensors.count_per_face} sensors on each of "
            f"faces {list(self.body.sensed)}"
        )

    @property
    def core_size_mm(self) -> tuple[float, float, float]:
        """Edges of the core: the body less one shell thickness on every side."""
        x, y, z = self.body.size_mm
        t = 2 * self.shell.thickness_mm
        return (x - t, y - t, z - t)

    @property
    def scoring_forces_n(self) -> tuple[float, ...]:
        """Forces at which a search judges layouts: `search.forces_n`, or `score.force_n` alone."""
        return self.search.forces_n or (self.score.force_n,)

    @property
    def pressed_forces_n(self) -> tuple[float, ...]:
        """Forces to which the shell without magnets is pressed: those of a search and `score.force_n`, from
        the least to the largest."""
        return tuple(sorted({*self.scoring_forces_n, self.score.force_n}))

    @model_validator(mode="after")
    def _element_takes_the_material(self) -> ObjectSpec:
        nu, element = self.silicone.poisson_ratio, self.mechanics.element
        if element == "taylor-hood" and nu < LEAST_RATIO_WITH_PRESSURE:
            raise ValueError(
                'mechanics.element = "taylor-hood" has a pressure, −λ div u, and takes '
                f"silicone.poisson_ratio from {LEAST_RATIO_WITH_PRESSURE:g}; got {nu:g}. Use "
                'mechanics.element = "p2", which is for foams and lattices'
            )
        if element == "p2" and nu > LARGEST_RATIO_OF_P2:
            raise ValueError(
                'mechanics.element = "p2" locks in nearly incompressible bodies and takes '
                f"silicone.poisson_ratio up to {LARGEST_RATIO_OF_P2:g}; got {nu:g}. Use "
                'mechanics.element = "taylor-hood"'
            )
        if element != "taylor-hood" and nu > LARGEST_RATIO_WITHOUT_PRESSURE:
            raise ValueError(
                f'mechanics.element = "{element}" has no pressure unknowns and takes '
                f"silicone.poisson_ratio up to {LARGEST_RATIO_WITHOUT_PRESSURE:g}; got {nu:g}. Lower it, "
                'or use mechanics.element = "taylor-hood"'
            )
        return self

    @model_validator(mode="after")
    def _layers_fit(self) -> ObjectSpec:
        layers, thickness = self.silicone.layers, self.shell.thickness_mm
        if layers and self.mechanics.element == "taylor-hood":
            raise ValueError(
                "silicone.layers need an element whose pressure may jump between them; got "
                'mechanics.element = "taylor-hood". Use "p2-p0", or "p2" for foams and lattices'
            )
        total = sum(depth_mm for depth_mm, _ in layers)
        if layers and total >= thickness:
            raise ValueError(
                f"silicone.layers are {total:g} mm thick together; shell.thickness_mm is "
                f"{thickness:g}. Make them thinner: the body itself is what they leave"
            )
        return self

    @model_validator(mode="after")
    def _frames_can_be_read(self) -> ObjectSpec:
        sensors, faces = self.sensors, len(self.body.sensed)
        fastest = fastest_frame_rate_hz(sensors, faces)
        if sensors.frame_rate_hz > fastest:
            raise ValueError(
                f"sensors.frame_rate_hz = {sensors.frame_rate_hz:g} is beyond the {fastest:.4g} Hz at "
                f"which {faces * sensors.count_per_face} sensors with averaging = {sensors.averaging} "
                f"can be read over one bus of {BUS_KHZ:g} kHz. Lower it or the averaging"
            )
        return self

    @model_validator(mode="after")
    def _lists_for_every_face(self) -> ObjectSpec:
        faces, magnets = self.body.sensed, self.magnets.lists
        lists = {
            f"sensors.{key}": getattr(self.sensors, key)
            for key in ("positions_mm", "rotations_deg")
        }
        lists["magnets.positions_mm"] = magnets if len(magnets) > 1 else None
        for key, given in lists.items():
            # Five lists that differ are those of faces 1 to 5: face 6 would have none of its own.
            five = max(faces) <= FACES_OF_A_CUBE or len(set(given or ())) == 1
            enough = {len(faces), FACES_OF_A_CUBE} if five else {len(faces)}
            if given is not None and len(given) not in enough:
                raise ValueError(
                    f"{key} holds {len(given)} lists; the body's sensed faces are "
                    f"{list(faces)}. Give one list for all of them, or one for each; body.sensed_faces says "
                    "which faces there are"
                )
        return self

    @model_validator(mode="after")
    def _require_as_built_parts(self) -> ObjectSpec:
        magnets, sensors = self.magnets.count, self.sensors.count_per_face
        self.as_built.require_known(magnets, sensors, self.body.sensed)
        return self
