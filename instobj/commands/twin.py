"""The object for physics simulators: its masses, meshes, frames and contacts (`build --twin`)."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np

from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.stages.run import Run
from instobj.store.publish import TWIN, file_rows, run_folder
from instobj.store.readers import PRESSES

_TOLERANCE_MM, _MOST_PIECES = 0.5, 64
"""Distance by which convex pieces may reach beyond the surface, where that number is enough."""
_LOSS_TANGENT = 0.1
"""Share of damping in the stiffness of cast silicone without measured relaxation. An estimate: soft
platinum silicones have 0.05 to 0.3 at 1 to 100 Hz."""


def write_twins(specs: list[Path], overrides: list[str], out: Path, result: dict[str, Any]) -> None:
    """Write the files for simulators of each specification, and add them to a chain's result."""
    for path, row in zip(specs, result["objects"], strict=True):
        row["files"] += file_rows(write_twin(load_spec(path, overrides), out))


def write_twin(spec: ObjectSpec, out: Path) -> list[Path]:
    """Write MJCF, URDF and USD of one object to `runs/NAME/twin`; return the paths.

    Raises
    ------
    InputError
        The parts cannot be built.
    StoreError
        The folder cannot be written.
    """
    import trimesh

    from design.build.masses import masses_of, total
    from design.build.simulator_body import (
        SimulatorBody,
        collision_pieces,
        frames_of,
        visual_surfaces,
    )
    from design.build.simulator_files import write_simulator_files

    run = Run(spec)
    parts = run.require("build").folder
    core, shell = (trimesh.load_mesh(parts / f"{name}.stl") for name in ("core", "shell"))
    mass = total(masses_of(spec).values())
    body = SimulatorBody(
        name=re.sub(r"\W|^(?=\d)", "_", spec.name, flags=re.ASCII),
        mass=mass,
        visual=visual_surfaces(spec, core, shell),
        collision=collision_pieces(spec, core, _TOLERANCE_MM, _MOST_PIECES),
        frames=frames_of(spec),
        contact=contact_spring(run, mass.mass_g),
    )
    return write_simulator_files(body, run_folder(out, spec.name) / TWIN)


def contact_spring(run: Run, mass_g: float) -> Any:
    """Return stiffness and damping of a contact of the object's tip, of stored presses where there are.

    Without them a flat layer gives the stiffness, in the range of the silicone's modulus.
    """
    from design.build.simulator_body import ContactSpring
    from estimator.grasps.measures import Conditions

    spec = run.spec
    presses = run.stored("presses")
    if presses is None:
        middle, low, high = _layer_n_per_mm(spec)
        source = "of a flat layer, in the range of the silicone's modulus"
    else:
        middle, low, high = _pressed_n_per_mm(presses.folder)
        source = "median and 5 to 95 % of the places of the simulated presses"
    # a spring K that bears m swings with ω = √(K / m); a loss tangent t damps with C = t K / ω
    omega = np.sqrt(middle * 1e3 / (mass_g * 1e-3))
    damping = _loss_tangent(spec, omega) * middle / omega
    return ContactSpring(middle, low, high, damping, Conditions.friction, source)


def _pressed_n_per_mm(folder: Path) -> tuple[float, float, float]:
    """Return median, 5 % and 95 % of the secant stiffness over all places."""
    from fem.presses.compliance_map import compliance_map

    stiffness = 1 / compliance_map(PRESSES.read(folder)[0]).mm_per_n
    middle, low, high = np.nanpercentile(stiffness, [50, 5, 95])
    return float(middle), float(low), float(high)


def _layer_n_per_mm(spec: ObjectSpec) -> tuple[float, float, float]:
    """Return the secant stiffness of a flat layer at the depth of the compliance map, with its range.

    The layer keeps its volume: at a Poisson's ratio of 0.45 it is a tenth too stiff.
    """
    from fem.candidates.layer import Layer
    from fem.presses.compliance_map import DEPTH_MM

    silicone, thickness, radius = spec.silicone, spec.shell.thickness_mm, spec.indenter.radius_mm
    moduli = silicone.youngs_modulus_mpa, *silicone.modulus_interval_mpa
    middle, low, high = (
        Layer(thickness, young, radius).force_at(DEPTH_MM) / DEPTH_MM for young in moduli
    )
    return middle, low, high


def _loss_tangent(spec: ObjectSpec, omega: float) -> float:
    """Return the ratio of loss to storage modulus at an angular frequency (1/s)."""
    terms = spec.silicone.prony
    if not terms:
        return _LOSS_TANGENT
    fraction, time_s = np.array(terms).T
    phase = omega * time_s
    # generalised Maxwell solid: E'' = Σ g φ / (1 + φ²), E' = 1 − Σ g + Σ g φ² / (1 + φ²)
    loss = (fraction * phase / (1 + phase**2)).sum()
    storage = 1 - (fraction / (1 + phase**2)).sum()
    return float(loss / storage)
