"""Modulus of a silicone, and silicones that give way as a fruit does.

The modulus comes from a name, a hardness or a tensile test, with the fits and a figure.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.catalogue.fruits import FRUITS, Fruit
from design.catalogue.silicones import (
    SILICONES,
    ModulusEstimate,
    Silicone,
    modulus_from_shore,
)
from design.errors import InputError
from estimator.grasps.damage import Sphere, indentation_mm
from fem.contact.bonded_layer import layer_thickness_mm
from instobj.figures.saving import save_figure
from instobj.store.publish import file_rows, require_writable, run_folder

if TYPE_CHECKING:
    from design.catalogue.tensile import TensileFit
    from design.catalogue.tensile_files import TensileTest

_TIP_MM, _FORCE_N = 5.0, 5.0
"""Tip and force at which compliances are matched: the paper's probe, and the force of scores."""
_LAYER_MM, _USUAL_MM = (4.0, 20.0), 8.0
"""Thickness of shells that hold magnets and can be cast, and the paper's."""
_COLOURS = ("#1b6ca8", "#c8553d", "#6a994e")


def describe_material(source: str, out: Path) -> dict[str, Any]:
    """Modulus and spread of a preset's name, a hardness, or a CSV of a tensile test; of a fruit's name the
    layers of silicone that give way as it does.

    A test also gives the fitted solids, and a figure in `runs/material_<stem>/`.

    Raises
    ------
    InputError
        None of these, or data that cannot be fitted.
    """
    if source.lower().endswith(".csv"):
        return _describe_test(Path(source), out)
    if source.lower() in FRUITS:
        return _describe_fruit(FRUITS[source.lower()])
    named = {name.lower(): silicone for name, silicone in SILICONES.items()}
    silicone = named.get(source.lower())
    try:
        modulus = silicone.modulus if silicone else modulus_from_shore(source)
    except InputError:
        raise InputError(
            f"{source!r} is no silicone in the catalogue ({', '.join(SILICONES)}), no fruit "
            f"({', '.join(FRUITS)}), no hardness such as A10 or 00-30, and no CSV file. Give one of these"
        ) from None
    return _document(source, {"modulus": _modulus_row(modulus)}, [])


def _describe_fruit(fruit: Fruit) -> dict[str, Any]:
    """Silicones, and the thickness at which a bonded layer gives way to a tip as the fruit does by Hertz."""
    tip = Sphere(
        fruit.youngs_modulus_mpa, fruit.poisson_ratio, 1 / (1 / fruit.radius_mm + 1 / _TIP_MM)
    )
    depth_mm = float(indentation_mm(np.array([_FORCE_N]), tip)[0])

    def thickness_mm(modulus_mpa: float) -> float:
        return layer_thickness_mm(_FORCE_N, depth_mm, modulus_mpa, _TIP_MM)

    # a stiffer silicone needs the thicker layer
    rows = [
        {
            "silicone": name,
            "thickness mm": thickness_mm(silicone.modulus.youngs_modulus_mpa),
            "from": thickness_mm(silicone.modulus.low_mpa),
            "to": thickness_mm(silicone.modulus.high_mpa),
        }
        for name, silicone in SILICONES.items()
    ]
    fitting = [row for row in rows if _LAYER_MM[0] <= row["thickness mm"] <= _LAYER_MM[1]]
    best = min(fitting, key=lambda row: abs(np.log(row["thickness mm"] / _USUAL_MM)), default=None)
    answer = (
        f"no silicone of the catalogue, {_LAYER_MM[0]:g} to {_LAYER_MM[1]:g} mm thick, gives way"
        if best is None
        else f"{best['silicone']}, {best['thickness mm']:.2g} mm thick, gives way"
    )
    fruits = (
        f"as {fruit.name} of {fruit.youngs_modulus_mpa:g} MPa does; fruits have {fruit.low_mpa:g} to "
        f"{fruit.high_mpa:g} MPa"
    )
    transfer = (
        f"Matched is the depth of a round tip of {_TIP_MM:g} mm under {_FORCE_N:g} N, {depth_mm:.2g} mm: "
        "the fruit by Hertz as a soft sphere, the silicone as a layer on a rigid core. Skin, layers of the "
        "fruit, flat tips and slow yielding are left out. The range of a thickness is that of the silicone's "
        "modulus alone. A dash: no thickness does."
    )
    modulus = ModulusEstimate(fruit.youngs_modulus_mpa, fruit.low_mpa, fruit.high_mpa, fruit.source)
    summary = {"modulus": _modulus_row(modulus), "layers of silicone": rows}
    return {"texts": [f"{answer} {fruits}.", transfer]} | _document(fruit.name, summary, [])


def _describe_test(path: Path, out: Path) -> dict[str, Any]:
    from design.catalogue.tensile import fit_tensile, fits_by_range, left_out
    from design.catalogue.tensile_files import read_tensile_test

    fit = fit_tensile(read_tensile_test(path), path.name)
    require_writable(out)
    figure = run_folder(out, f"material_{path.stem}") / "fit.png"
    draw_tensile_fit(fit, figure)
    rows = [
        {
            "solid": solid.solid,
            "constants": ",".join(f"{constant:.4g}" for constant in solid.constants),
            "E MPa": solid.youngs_modulus_mpa,
            "rms %": solid.residual_percent,
            "stable": solid.stable,
        }
        for solid in fit.solids
    ]
    summary: dict[str, Any] = {"modulus": _modulus_row(fit.modulus), "solids": rows}
    summary["ranges"] = [
        {
            "to stretch": fit_of_range.to_stretch,
            "points": fit_of_range.points,
            "solid": fit_of_range.fit.solid,
            "E MPa": fit_of_range.fit.youngs_modulus_mpa,
            "from": fit_of_range.low_mpa,
            "to": fit_of_range.high_mpa,
            "rms %": fit_of_range.fit.residual_percent,
            "stable": fit_of_range.fit.stable,
        }
        for fit_of_range in fits_by_range(fit.test)
    ]
    silicone = _catalogue_silicone(fit.test.details.get("Material", ""))
    if silicone is not None:
        summary["catalogue"] = _modulus_row(silicone.modulus)
    texts = [text for text in (left_out(fit.test), _crosshead_text(fit.test)) if text]
    return ({"texts": texts} if texts else {}) | _document(path.stem, summary, [figure])


def _catalogue_silicone(material: str) -> Silicone | None:
    """Silicone of the catalogue by its name in published files: no spaces, Ecoflex 00-30 as EcoFlex30."""

    def plain(name: str) -> str:
        return "".join(letter for letter in name.lower() if letter.isalnum()).replace("00", "")

    silicones = [silicone for name, silicone in SILICONES.items() if plain(name) == plain(material)]
    return silicones[0] if silicones else None


def _crosshead_text(test: TensileTest) -> str:
    """Return what a strain that is not measured on the specimen does to the modulus; empty where it is."""
    if "crosshead" not in test.details.get("Strain calculation", "").lower():
        return ""
    return (
        "the strain is that of the machine's crosshead, not of the specimen: it counts what gives at the "
        "grips and the specimen's wide ends, so that moduli read too small"
    )


def _modulus_row(modulus: ModulusEstimate) -> dict[str, Any]:
    return {
        "E MPa": modulus.youngs_modulus_mpa,
        "from": modulus.low_mpa,
        "to": modulus.high_mpa,
        "source": modulus.source,
    }


def _document(name: str, summary: dict[str, Any], files: list[Path]) -> dict[str, Any]:
    return {
        "command": "material",
        "objects": [{"name": name, "summary": summary, "files": file_rows(files)}],
    }


def draw_tensile_fit(fit: TensileFit, path: Path) -> None:
    """Measured points and the fitted solids, and their misfit (PNG)."""
    from matplotlib.figure import Figure

    from design.catalogue.tensile import nominal_stress_mpa
    from design.catalogue.tensile_files import FIT_TO_STRETCH

    stretch, stress = fit.test.stretch, fit.test.nominal_stress_mpa
    kept = stretch <= FIT_TO_STRETCH
    fine = np.linspace(1, stretch[kept][-1], 200)
    figure = Figure(figsize=(8.4, 3.6), layout="constrained")
    axes, rest = figure.subplots(1, 2)
    axes.plot(stretch[kept], 1e3 * stress[kept], "o", ms=4, color="#333333", label="measured")
    for solid, colour in zip(fit.solids, _COLOURS, strict=True):
        label = f"{solid.solid}, E {solid.youngs_modulus_mpa:.3g} MPa"
        curve = nominal_stress_mpa(solid.solid, solid.constants, fine)
        axes.plot(fine, 1e3 * curve, color=colour, label=label, ls="-" if solid.stable else ":")
        misfit = nominal_stress_mpa(solid.solid, solid.constants, stretch[kept]) - stress[kept]
        label = f"rms {solid.residual_percent:.1f} % of the largest stress"
        rest.plot(stretch[kept], 1e3 * misfit, ".-", lw=0.8, color=colour, label=label)
    axes.set(
        xlabel="stretch", ylabel="nominal stress (kPa)", title="Tensile test and fitted solids"
    )
    rest.set(xlabel="stretch", ylabel="residual, fit − measured (kPa)", title="Residual")
    for part in (axes, rest):
        part.grid(alpha=0.3)
        part.set_xlim(1)
        part.legend(frameon=False, fontsize=8)
    axes.set_ylim(0)
    save_figure(figure, path)
