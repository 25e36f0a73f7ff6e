"""3MF of one part for the slicer, turned as it is printed, with the settings that the part needs.

Settings stand by the object, not by the project, so that the user's printer and filament stay chosen:
PrusaSlicer reads them from `Metadata/Slic3r_PE_model.config`, OrcaSlicer and Bambu Studio from
`Metadata/model_settings.config`. Other programs see a plain 3MF.
"""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr

import numpy as np

from design.build.print_settings import PrintSettings
from design.files import atomic_path

if TYPE_CHECKING:
    import trimesh

_MODEL = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_MODEL_TYPE = "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"
_FIRST_DATE = (1980, 1, 1, 0, 0, 0)
"""Earliest date that a ZIP file can hold: the same for all, so that equal parts give equal files."""
_XML = '<?xml version="1.0" encoding="UTF-8"?>'
PRUSA, ORCA = "Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"
_PRUSA_KEYS = (
    *("name", "layer_height", "perimeters", "fill_density"),
    *("support_material", "support_material_buildplate_only", "brim_type", "brim_width"),
)
_ORCA_KEYS = (
    *("name", "layer_height", "wall_loops", "sparse_infill_density"),
    *("enable_support", "support_on_build_plate_only", "brim_type", "brim_width"),
)
_TYPES = (
    f'{_XML}<Types xmlns="{_PACKAGE}/content-types">'
    '<Default Extension="rels" '
    'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    '<Default Extension="config" ContentType="text/xml"/>'
    f'<Default Extension="model" ContentType="{_MODEL_TYPE}"/></Types>'
)
_RELATIONS = (
    f'{_XML}<Relationships xmlns="{_PACKAGE}/relationships">'
    '<Relationship Id="rel0" Target="/3D/3dmodel.model" '
    'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
)


def write_3mf(
    mesh: trimesh.Trimesh,
    name: str,
    target: Path,
    settings: PrintSettings | None = None,
    bed_mm: tuple[float, float] = (0.0, 0.0),
) -> None:
    """One object in millimetres, by the 3MF core specification; equal meshes give equal files.

    With settings the part is turned and stands in the middle of the bed; vertices stay in its frame.

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    corners = "".join(f'<vertex x="{x:.6g}" y="{y:.6g}" z="{z:.6g}"/>' for x, y, z in mesh.vertices)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in mesh.faces)
    placed = "" if settings is None else f' transform="{_transform(mesh, settings, bed_mm)}"'
    model = (
        f'{_XML}<model unit="millimeter" xmlns="{_MODEL}"><resources>'
        f'<object id="1" name={quoteattr(name)} type="model"><mesh><vertices>{corners}</vertices>'
        f"<triangles>{triangles}</triangles></mesh></object></resources>"
        f'<build><item objectid="1"{placed}/></build></model>'
    )
    contents = {
        "[Content_Types].xml": _TYPES,
        "_rels/.rels": _RELATIONS,
        "3D/3dmodel.model": model,
    }
    if settings is not None:
        contents[PRUSA] = _prusa(name, len(mesh.faces), settings)
        contents[ORCA] = _orca(name, settings)
    with atomic_path(target) as path, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for inside, text in contents.items():
            entry = zipfile.ZipInfo(inside, _FIRST_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text)


def _transform(mesh: trimesh.Trimesh, settings: PrintSettings, bed_mm: tuple[float, float]) -> str:
    """Rotation by columns and shift, as the 3MF core specification orders them."""
    turned = np.asarray(mesh.vertices) @ settings.rotation.T
    low, high = turned.min(axis=0), turned.max(axis=0)
    shift = np.array([bed_mm[0] / 2, bed_mm[1] / 2, 0.0]) - (low + high) / 2
    shift[2] = -low[2]
    return " ".join(f"{value + 0.0:.6g}" for value in (*settings.rotation.T.ravel(), *shift))


def _prusa(name: str, triangles: int, settings: PrintSettings) -> str:
    volume = (
        f'<volume firstid="0" lastid="{triangles - 1}">'
        f'<metadata type="volume" key="name" value={quoteattr(name)}/></volume>'
    )
    rows = _rows(_PRUSA_KEYS, name, settings, ' type="object"')
    return f'{_XML}<config><object id="1" instances_count="1">{rows}{volume}</object></config>'


def _orca(name: str, settings: PrintSettings) -> str:
    part = (
        f'<part id="1" subtype="normal_part"><metadata key="name" value={quoteattr(name)}/></part>'
    )
    rows = _rows(_ORCA_KEYS, name, settings)
    return f'{_XML}<config><object id="1">{rows}{part}</object></config>'


def _rows(keys: tuple[str, ...], name: str, settings: PrintSettings, kind: str = "") -> str:
    """Name and settings of the object, by the names that a slicer has for them."""
    values = (
        name,
        f"{settings.layer_mm:g}",
        f"{settings.walls}",
        f"{settings.infill_percent}%",
        f"{settings.supports:d}",
        "1",
        "outer_only" if settings.brim_mm else "no_brim",
        f"{settings.brim_mm:g}",
    )
    return "".join(
        f'<metadata{kind} key="{key}" value={quoteattr(value)}/>'
        for key, value in zip(keys, values, strict=True)
    )
