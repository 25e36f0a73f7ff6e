"""File of an estimator that inverts the forward model: all that a robot needs, without torch."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from design.errors import DAMAGED_CONTENT, StoreError
from design.netcdf import FileKind, holds, read_netcdf, write_netcdf
from design.spec.object import ObjectSpec
from estimator.inversion.inversion import Inversion
from estimator.inversion.model.forward import ContactModel
from estimator.inversion.model.noise import Disturbances
from estimator.inversion.model.spline import cubic_axis
from estimator.inversion.model.table import PressTable
from estimator.inversion.priors import Priors
from estimator.signals.nuisances import Nuisance
from fem.contact.jaw import JawFace

_KIND = FileKind(
    "estimators that invert the forward model",
    {
        "signals": ("face nx ny nf channel", "count"),
        "motions": ("face nx ny nf component", "mm or rad"),
        "skin": ("face nx ny nf skin_channel", "mm^1.5 or mm^3"),
        "shear": ("shear_face shear_nx shear_ny nf pull", "count/N"),
        "shear_x_mm": ("shear_nx", "mm"),
        "shear_y_mm": ("shear_ny", "mm"),
        "x_mm": ("nx", "mm"),
        "y_mm": ("ny", "mm"),
        "root_n": ("nf", "N^0.5"),
        "faces": ("face", "1"),
        "rest": ("body six", "mm or rad"),
        "noise_counts": ("channel", "count"),
        "offset_counts": ("channel", "count"),
        "model_error": ("channel", "1"),
        "nuisances": ("channel unknown", "count"),
        "jaws": ("jaw cell jaw_column", "mm^3/MPa, mm/N or rad/N"),
        "jaw_faces": ("jaw", "1"),
        "jaw_half_mm": ("jaw axis", "mm"),
    },
    optional=(
        *("shear", "shear_x_mm", "shear_y_mm", "nuisances"),
        *("jaws", "jaw_faces", "jaw_half_mm"),
    ),
    attributes=("specification", "priors", "force_error", "nearest_mm", "nuisances"),
    schema=("inversion_schema", 4),
    origin="`instobj train SPEC` makes one",
    remedy="Train it anew",
    others={
        "signal_counts": "a data set, not an estimator. Give the contacts.nc that `instobj train SPEC` "
        "wrote"
    },
)


def save_inversion(inversion: Inversion, path: Path | str) -> None:
    """Write an estimator as NetCDF with checksums; `load_inversion` reads it."""
    model, table = inversion.model, inversion.model.signals
    shear, disturbances = model.shear, inversion.disturbances
    values = {
        "shear": None if shear is None else shear.coefficients,
        "shear_x_mm": None if shear is None else shear.x.nodes,
        "shear_y_mm": None if shear is None else shear.y.nodes,
        "skin": model.skin.coefficients,
        "signals": table.coefficients,
        "motions": model.motions.coefficients,
        "x_mm": table.x.nodes,
        "y_mm": table.y.nodes,
        "root_n": table.root.nodes,
        "faces": table.faces,
        "rest": model.rest,
        "noise_counts": disturbances.noise_counts,
        "offset_counts": disturbances.offset_counts,
        "model_error": disturbances.model_error,
        "nuisances": disturbances.columns if disturbances.nuisances else None,
        **_jaw_values(inversion.jaw_tables),
    }
    attributes = {
        "specification": json.dumps(model.spec.model_dump(mode="json")),
        "priors": json.dumps(asdict(inversion.priors)),
        "force_error": disturbances.force_error,
        "nuisances": json.dumps(
            [
                (nuisance.name, nuisance.unit, nuisance.deviation, nuisance.columns.shape[1])
                for nuisance in disturbances.nuisances
            ]
        ),
        "nearest_mm": model.nearest_mm,
    }
    write_netcdf(_KIND, path, values, attributes)


def _jaw_values(tables: tuple[JawFace, ...]) -> dict[str, np.ndarray | None]:
    if not tables:
        return dict.fromkeys(("jaws", "jaw_faces", "jaw_half_mm"))
    return {
        "jaws": np.stack(
            [np.hstack([jaw.compliance, jaw.motion.reshape(len(jaw.motion), -1)]) for jaw in tables]
        ).astype(np.float32),
        "jaw_faces": np.array([jaw.face for jaw in tables]),
        "jaw_half_mm": np.stack([jaw.half_mm for jaw in tables]),
    }


def _compliance_and_motion(table: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    compliance, motion = np.split(table, [len(table)], axis=1)
    return compliance, motion.reshape(len(table), -1, 6)


def load_inversion(path: Path | str) -> Inversion:
    """Read what `save_inversion` wrote.

    Raises
    ------
    InputError
        No such file, or a data set.
    StoreError
        Damaged, or not such an estimator.
    """
    values, attributes = read_netcdf(_KIND, path)
    try:
        return _assembled(values, attributes)
    except ValidationError as error:
        keys = ", ".join(".".join(map(str, fault["loc"])) for fault in error.errors()[:3])
        raise StoreError(
            f"{path}: its specification is of another version of instobj ({keys}). Train it anew"
        ) from None
    except DAMAGED_CONTENT as error:
        raise StoreError(
            f"{path}: tables and description do not belong together ({error}). Train it anew"
        ) from None


def is_inversion(path: Path | str) -> bool:
    """Return whether a file is such an estimator, by what it holds."""
    return holds(path, _KIND.schema[0])


def _nuisances(values: dict[str, np.ndarray], described: list[list[Any]]) -> tuple[Nuisance, ...]:
    ends = np.cumsum([size for *_, size in described])[:-1]
    columns = np.split(values["nuisances"], ends, axis=1) if described else []
    return tuple(
        Nuisance(name, unit, deviation, nuisance_columns)
        for (name, unit, deviation, _), nuisance_columns in zip(described, columns, strict=True)
    )


def _assembled(values: dict[str, np.ndarray], attributes: dict[str, Any]) -> Inversion:
    spec = ObjectSpec.model_validate(json.loads(attributes["specification"]))
    x, y, root = (cubic_axis(values[name]) for name in ("x_mm", "y_mm", "root_n"))
    signals, motions, skin = (
        PressTable(values["faces"], x, y, root, values[name].astype(np.float32))
        for name in ("signals", "motions", "skin")
    )
    shear = None
    if "shear" in values:
        along_x, along_y = (cubic_axis(values[name]) for name in ("shear_x_mm", "shear_y_mm"))
        per_n = values["shear"].astype(np.float32)
        shear = PressTable(values["faces"], along_x, along_y, root, per_n)
    jaw_tables = ()
    if "jaws" in values:
        columns = (values[name] for name in ("jaw_faces", "jaw_half_mm", "jaws"))
        jaw_tables = tuple(
            JawFace(int(face), half, *_compliance_and_motion(table.astype(float)))
            for face, half, table in zip(*columns, strict=True)
        )
    described = json.loads(attributes["priors"])
    for name in ("number", "force_n", "spacing_mm"):
        described[name] = tuple(described[name])
    return Inversion(
        ContactModel(
            spec, signals, motions, values["rest"], float(attributes["nearest_mm"]), skin, shear
        ),
        Disturbances(
            values["noise_counts"],
            values["offset_counts"],
            values["model_error"],
            float(attributes["force_error"]),
            _nuisances(values, json.loads(attributes["nuisances"])),
        ),
        Priors(**described),
        jaw_tables,
    )
