"""Specification files: TOML read into a validated `ObjectSpec`, with errors a person can act on."""

from __future__ import annotations

import hashlib
import json
import re
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from design.catalogue.magnets import MAGNET_PARTS
from design.errors import SpecError
from design.files import require_regular_file
from design.fit.everything import require_fit
from design.layout.body import face_frames
from design.layout.places.fractions import with_places_in_mm
from design.spec.base import complaints
from design.spec.body import BodySpec, ShellSpec
from design.spec.magnets import MagnetSpec
from design.spec.object import ObjectSpec
from design.spec.silicone import is_test_file
from design.spec.uses import USES, require_used

_DEEP_KEY = re.compile(r"(?:\.[\w-]{1,80}){100}")
"""A key of more than a hundred tables."""
_LARGEST_BYTES = 250_000
_LARGEST_NUMBER = 10**30
"""Beyond 10^308 no float holds a whole number; no key takes more than 10^10."""
_NO_TOML = "is no specification. Give the TOML file of an object"


def load_spec(path: Path | str, overrides: Iterable[str] = (), table: bool = True) -> ObjectSpec:
    """Read a specification and apply `key=value` overrides (dotted keys, TOML values).

    Without `table`, the indenter need not fit at every contact location: for single presses.

    What was measured on the built object, `<specification>.as_built.toml` next to it, is read too.

    Raises
    ------
    SpecError
        The file is missing or not TOML, or a key, unit or bound is wrong.
    """
    path = Path(path)
    content = _read_toml(path, f"no specification at {{}}. {_likely_place(path)}")
    overrides = list(overrides)
    _require_used(content, str(path))
    content = with_overrides(content, overrides)
    # a file may hold sizes of a kind that an override replaces; what is overridden must be used
    _require_used(content, "--set", {override.partition("=")[0].strip() for override in overrides})
    content = _with_tensile_data(content, path.parent)
    content = _with_printer(_with_indenter_corners(content, path.parent), path.parent)
    content = _with_imported_body(content, path.parent)
    return parse_spec(_with_as_built(content, path), str(path), table)


def _require_used(content: dict[str, Any], source: str, keys: Iterable[str] = tuple(USES)) -> None:
    try:
        require_used(content, keys)
    except SpecError as error:
        raise SpecError(_listed(source, str(error).split("\n"))) from None


def _listed(source: str, problems: list[str]) -> str:
    lines = "\n".join(f"  - {problem}" for problem in problems)
    return f"{source} is not a valid specification:\n{lines}"


def _parsed(text: str) -> dict[str, Any]:
    """TOML; ValueError where a whole number is too long to be read, written or made a float."""
    content = tomllib.loads(text)
    values: list[Any] = [content]
    while values:
        value = values.pop()
        values += (
            value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
        )
        if isinstance(value, int) and abs(value) > _LARGEST_NUMBER:
            raise ValueError(value.bit_length())
    return content


def _likely_place(path: Path) -> str:
    whole = path.parent / f"{path.name}.toml"  # a path such as "." has no name
    beside = f"Did you mean {whole}?" if path.name and whole.is_file() else ""
    return beside or "`instobj new NAME` writes one to start from"


def _read_toml(path: Path, missing: str) -> dict[str, Any]:
    require_regular_file(path, missing.format(path))
    try:
        if path.stat().st_size > _LARGEST_BYTES:
            raise SpecError(
                f"{path} holds {path.stat().st_size} bytes; a specification has a few thousand, "
                f"{_LARGEST_BYTES} at most. Give the TOML file of an object"
            )
        text = path.read_text(encoding="utf-8-sig")  # Windows editors begin with a mark
        if _DEEP_KEY.search(text):  # tomllib takes minutes over it
            raise RecursionError
        return _parsed(text)
    except SpecError:
        raise
    except RecursionError:
        raise SpecError(f"{path} nests brackets or tables too deep. Fix that line") from None
    except OSError as error:
        raise SpecError(
            f"cannot read {path}: {error.strerror}. Give a readable TOML file"
        ) from None
    except UnicodeDecodeError:
        cause = _NO_TOML if path.suffix != ".toml" else "is not text in UTF-8. Save it as UTF-8"
        raise SpecError(f"{path} {cause}") from None
    except tomllib.TOMLDecodeError as error:
        if path.suffix != ".toml":  # a recording, or another file: no line of it is to fix
            raise SpecError(f"{path} {_NO_TOML}") from None
        twice = re.match(r"Cannot declare \((.*?),?\) twice (.*)", str(error))
        if twice:
            table = ".".join(re.findall(r"'(.*?)'", twice[1]))
            raise SpecError(
                f"{path}: the table [{table}] stands twice {twice[2]}. Move its keys into the first one"
            ) from None
        raise SpecError(f"{path} is not valid TOML: {error}. Fix that line") from None
    except ValueError:  # Python reads no integer of more than 4300 digits
        raise SpecError(f"{path} holds a whole number beyond 10^30. Fix it") from None


def with_overrides(content: dict[str, Any], overrides: Iterable[str]) -> dict[str, Any]:
    """Apply `key=value` overrides (dotted keys, TOML values) to parsed TOML, in place.

    Raises
    ------
    SpecError
        An override is not of that form, or names a value as if it were a table.
    """
    overrides = list(overrides)
    changed = {
        key.strip(): value
        for key, _, value in (assignment.partition("=") for assignment in overrides)
    }
    _make_room_for_the_part(content, changed)
    for override in overrides:
        _apply_override(content, override)
    return content


_SIZES = ("shape", "diameter_mm", "inner_diameter_mm", "size_mm", "height_mm")


def _make_room_for_the_part(content: dict[str, Any], changed: dict[str, str]) -> None:
    """Let another `magnets.part` go before what a file says of magnets and their pockets, in place.

    Pockets grow and shrink with the part. What is changed too stays: it may contradict the part.
    """
    name = _toml_value(changed.get("magnets.part", "").strip())
    magnets, shell = content.get("magnets", {}), content.setdefault("shell", {})
    if (
        not isinstance(name, str)
        or name not in MAGNET_PARTS
        or not isinstance(magnets, dict)
        or not isinstance(shell, dict)
    ):
        return
    part = MAGNET_PARTS[name]
    figures, replaced = part.figures(), {}
    for key in (*_SIZES, *(("grade", "remanence_t") if part.grade else ())):
        if f"magnets.{key}" not in changed:
            replaced[key] = magnets.pop(key, None)
    for of_magnet, of_pocket in (
        ("diameter_mm", "pocket_diameter_mm"),
        ("height_mm", "pocket_depth_mm"),
    ):
        size = _number(replaced.get(of_magnet), MagnetSpec.model_fields[of_magnet].default)
        pocket = _number(shell.get(of_pocket), ShellSpec.model_fields[of_pocket].default)
        if of_magnet in figures and f"shell.{of_pocket}" not in changed:
            shell[of_pocket] = round(pocket + figures[of_magnet] - size, 9)


def _number(given: Any, default: float) -> float:
    """The number, the largest of a list of them, or what a key that is left out has."""
    numbers = [
        entry
        for entry in (given if isinstance(given, list) else [given])
        if isinstance(entry, int | float)
    ]
    return float(max(numbers, default=default))


def parse_spec(content: dict[str, Any], source: str, table: bool = True) -> ObjectSpec:
    """Validate already parsed TOML and `check` it; `source` names it in errors."""
    try:
        return check(ObjectSpec.model_validate(with_places_in_mm(content)), table)
    except ValidationError as error:
        problems = complaints(error, ObjectSpec)
    except SpecError as error:
        problems = str(error).split("\n")
    raise SpecError(_listed(source, problems))


def check(spec: ObjectSpec, table: bool = True) -> ObjectSpec:
    """Check that core, pockets, sensors, presses and mould fit together; the specification again.

    Without `table`, the indenter need not fit at every contact location: for single presses.

    Raises
    ------
    SpecError
        All that does not fit, a line each: what was given and how to fix it.
    """
    _require_one_place_each(spec)
    try:
        require_fit(spec, table)
    except ValueError as error:
        raise SpecError(str(error)) from None
    # a rigid rectangle lies on flat faces with straight borders alone
    flat = [frame for frame in face_frames(spec) if frame.flat and not frame.round]
    if spec.inversion.probes == "flat" and not flat:
        raise SpecError(
            'inversion.probes = "flat" needs a flat sensed face with straight borders; this body has none. '
            'Set it to "free". A flat finger on a curved face is an indenter: indenter.kind = "cuboid", '
            "indenter.size_mm = [14, 14]"
        )
    return spec


def _require_one_place_each(spec: ObjectSpec) -> None:
    """Refuse magnets at one place, before thousands of their pairs are reported to touch.

    A search may hold such magnets for a moment, until a trial has given them their places.
    """
    for places in spec.magnets.lists:
        if len(set(places)) < len(places):
            x, y = next(place for place in places if places.count(place) > 1)
            raise SpecError(
                f"magnets.positions_mm names ({x:g}, {y:g}) twice on one face. Move one of the two, or "
                "leave it out"
            )


def spec_hash(spec: ObjectSpec) -> str:
    """SHA-256 (hex) of the specification's canonical JSON: equal specifications, equal hashes.

    Defaults are not validated, so an integer default would differ from the same number read from
    a file; one round of validation makes them alike.
    """
    alike = ObjectSpec.model_validate(spec.model_dump(mode="json"))
    canonical = json.dumps(alike.model_dump(mode="json"), sort_keys=True)
    return hashlib.sha256(canonical.encode()).hexdigest()


def _with_as_built(content: dict[str, Any], path: Path) -> dict[str, Any]:
    """Read the file that `as_built` names, or `<specification>.as_built.toml` next to it."""
    named, beside = content.get("as_built"), path.with_name(f"{path.stem}.as_built.toml")
    if isinstance(named, str):
        file = path.parent / named
    elif named is None and beside.is_file():
        file = beside
    else:
        return content
    missing = "no as-built file at {}. Fix the key as_built, or leave it out"
    return content | {"as_built": _read_toml(file, missing)}


def _with_tensile_data(content: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Fit the tensile test that `silicone.modulus_from` names, a file next to the specification.

    An explicit modulus goes before it; the key is then dropped.
    """
    silicone = content.get("silicone")
    source = silicone.get("modulus_from") if isinstance(silicone, dict) else None
    if not isinstance(silicone, dict) or not isinstance(source, str) or not is_test_file(source):
        return content
    if "youngs_modulus_mpa" in silicone:
        return content | {"silicone": silicone | {"modulus_from": None}}
    from design.catalogue.tensile import fit_tensile
    from design.catalogue.tensile_files import read_tensile_test

    file = folder / source
    modulus = fit_tensile(read_tensile_test(file), file.name).modulus
    figures = {
        "youngs_modulus_mpa": modulus.youngs_modulus_mpa,
        "youngs_modulus_range_mpa": modulus.range_mpa,
    }
    return content | {"silicone": figures | silicone}


def _with_printer(content: dict[str, Any], folder: Path) -> dict[str, Any]:
    """`printer = "file.toml"`, a profile next to the specification, read as the table [printer]."""
    named = content.get("printer")
    if not isinstance(named, str):
        return content
    missing = "no printer profile at {}. Fix the key printer, or give a table [printer]"
    profile = _read_toml(folder / named, missing)
    return content | {"printer": profile}


def _with_indenter_corners(content: dict[str, Any], folder: Path) -> dict[str, Any]:
    """The indenter with the corners of its STL file, if there is one, read from `folder`."""
    indenter = content.get("indenter")
    if not isinstance(indenter, dict) or not isinstance(indenter.get("vertices_mm"), str):
        return content
    from design.layout.stl_tip import stl_tip_vertices_mm

    corners = stl_tip_vertices_mm(folder / indenter["vertices_mm"])
    return content | {"indenter": indenter | {"vertices_mm": corners}}


def _with_imported_body(content: dict[str, Any], folder: Path) -> dict[str, Any]:
    """An imported body with the size of what its file holds, read from `folder`."""
    body = content.get("body")
    if not isinstance(body, dict) or not isinstance(body.get("file"), str):
        return content
    from design.body.imported import body_of_file

    try:
        measured = BodySpec.model_validate(_IMPORTED | {k: body[k] for k in _FOREIGN if k in body})
    except ValidationError:
        return content  # told with all other problems of the specification
    return content | {"body": body | body_of_file(folder / body["file"], measured.scale)}


_IMPORTED = {"kind": "imported"}
_FOREIGN = ("file", "scale")


def _apply_override(content: dict[str, Any], override: str) -> None:
    key, equals, value = override.partition("=")
    if not equals or not key.strip():
        raise SpecError(f"a change is key=value; got {override!r}. Example: shell.thickness_mm=9")
    *tables, name = key.strip().split(".")
    table = content
    for part in tables:
        table = table.setdefault(part, {})
        if not isinstance(table, dict):
            raise SpecError(f"{override}: {part!r} is a value, not a table of the specification")
    table[name] = _toml_value(value.strip())


def _toml_value(text: str) -> Any:
    try:
        return _parsed(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text
    except RecursionError:
        raise SpecError("the value nests brackets too deep. Give a plainer one") from None
    except ValueError:
        raise SpecError("the value is a whole number beyond 10^30. Give a smaller one") from None
