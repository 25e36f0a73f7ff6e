"""The manifest of a build: what each written part is, readable without the CAD kernel."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from design.build.print_settings import PrintSettings
from design.errors import InputError
from design.files import atomic_path

MANIFEST_NAME = "manifest.json"

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class PartManifest:
    """One part: figures of the exact solid, and of the STL that was written from it.

    `material` is "printed" or "silicone"; `count` pieces of it are needed. `printing` are the settings
    in its 3MF, None where no printer by filament makes it.
    """

    name: str
    volume_mm3: float
    bounding_box_mm: tuple[Vector, Vector]
    centre_of_mass_mm: Vector
    face_count: int
    solid_count: int
    stl_volume_mm3: float
    stl_watertight: bool
    stl_triangles: int
    material: str = "printed"
    count: int = 1
    printing: PrintSettings | None = None

    @property
    def size_mm(self) -> Vector:
        """Edges of the bounding box."""
        (x0, y0, z0), (x1, y1, z1) = self.bounding_box_mm
        return (x1 - x0, y1 - y0, z1 - z0)


@dataclass(frozen=True)
class BuildManifest:
    """All parts of one build, the specification's hash and the libraries that made them."""

    name: str
    spec_hash: str
    parts: tuple[PartManifest, ...]
    library_versions: dict[str, str]

    def __repr__(self) -> str:
        listed = ", ".join(f"{part.name} {part.volume_mm3:.0f} mm³" for part in self.parts)
        return f"BuildManifest of {self.name}, {len(self.parts)} parts: {listed}"

    def part(self, name: str) -> PartManifest:
        """The part of that name; KeyError where the build has none."""
        return {part.name: part for part in self.parts}[name]

    def to_json(self) -> str:
        """The manifest as JSON text, one key per line."""
        return json.dumps(asdict(self), indent=2, ensure_ascii=False) + "\n"

    @classmethod
    def from_json(cls, text: str, source: str = "the manifest") -> BuildManifest:
        """Inverse of `to_json`; `source` names the text in errors.

        Raises
        ------
        InputError
            The text is not JSON, or keys are missing or unknown.
        """
        try:
            content = json.loads(text)
            parts = tuple(_part_from(part) for part in content.pop("parts"))
            return cls(parts=parts, **content)
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise InputError(
                f"{source} is not a build manifest: {error}. Build the object again"
            ) from None

    def write(self, folder: Path | str) -> Path:
        """Write manifest.json into the folder; raises InputError where that cannot be written."""
        target = Path(folder) / MANIFEST_NAME
        with atomic_path(target) as path:
            path.write_text(self.to_json(), encoding="utf-8")
        return target

    @classmethod
    def read(cls, folder: Path | str) -> BuildManifest:
        """Read manifest.json from the folder of a build.

        Raises
        ------
        InputError
            The folder holds no readable manifest.
        """
        source = Path(folder) / MANIFEST_NAME
        try:
            text = source.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(
                f"cannot read {source}: {error}. Name a folder that `instobj build` wrote"
            ) from None
        return cls.from_json(text, str(source))


def remove_manifest(folder: Path | str) -> None:
    """Remove a folder's manifest, if any, before its parts change.

    Raises
    ------
    InputError
        The folder cannot be written.
    """
    target = Path(folder) / MANIFEST_NAME
    try:
        target.unlink(missing_ok=True)
    except OSError as error:
        raise InputError(
            f"cannot write {target}: {error.strerror}. Choose a writable folder with --out"
        ) from None


def _part_from(content: dict[str, object]) -> PartManifest:
    low, high = content.pop("bounding_box_mm")  # type: ignore[misc]
    centre = content.pop("centre_of_mass_mm")
    printing = content.pop("printing", None)
    if isinstance(printing, dict):
        settings = PrintSettings(**{**printing, "down": _vector(printing["down"])})
    else:
        settings = None
    return PartManifest(
        printing=settings,
        bounding_box_mm=(_vector(low), _vector(high)),
        centre_of_mass_mm=_vector(centre),
        **content,  # type: ignore[arg-type]
    )


def _vector(values: object) -> Vector:
    x, y, z = (float(value) for value in values)  # type: ignore[union-attr]
    return (x, y, z)
