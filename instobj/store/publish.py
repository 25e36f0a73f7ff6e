"""Published results: copies of stored ones for their users, `cad_out/<name>` and `runs/<name>`."""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

from design.errors import StoreError
from design.files import atomic_path
from design.spec.learning import CollectionKind
from design.spec.object import ObjectSpec
from design.spec_io import spec_hash
from instobj.store.content import StoredResult
from instobj.store.readers import FRAMES, collection_path, published_files
from instobj.store.record import RECORD

_BESIDE_THE_PARTS = ("fabrication", "sheet")
"""Stages whose files go to the parts, not to the results."""
TWIN = "twin"
"""Folder below the results of a data set for estimators that saw presses of a twin (`--twin`)."""
OWN_FOLDERS = (TWIN,)


def run_folder(out: Path, name: str) -> Path:
    """`runs/<name>` below the output folder."""
    return out / "runs" / name


def run_name(data_set: Path) -> str:
    """Name of the results on a data set or recording: that of the file, of `frames.nc` its folder's.

    Simulated recordings, `frames_<kind>.nc`, are called so in every run: their results lie in a folder
    of that kind below the run's own (`cube/grasp`), next to what other runs and this one made.
    """
    folder, stem = data_set.absolute().parent.name, data_set.stem
    if stem == Path(FRAMES.name).stem:
        return folder
    kinds = {collection_path(Path(), kind).name: kind for kind in get_args(CollectionKind)}
    return f"{folder}/{kinds[data_set.name]}" if data_set.name in kinds else stem


def own_folder_of(model: Path) -> str:
    """Name of such a folder, by where a model's file lies; "" elsewhere."""
    name = model.absolute().parent.name
    return name if name in OWN_FOLDERS else ""


def cad_folder(out: Path, name: str) -> Path:
    """`cad_out/<name>` below the output folder."""
    return out / "cad_out" / name


def require_writable(out: Path) -> None:
    """Raise StoreError before any work is done where results could not be written afterwards."""
    for folder in (out, out / "runs", out / "cad_out"):
        if folder == out or folder.exists():
            require_writable_folder(folder)


def require_writable_folder(folder: Path) -> None:
    """Raise StoreError where a file cannot be written in this one folder."""
    if folder.exists() and not folder.is_dir():
        raise StoreError(
            f"cannot write into {folder}: it is a file, not a folder. Choose a folder with --out"
        )
    with atomic_path(folder / ".instobj-writable") as probe:
        probe.write_text("")
    (folder / ".instobj-writable").unlink(missing_ok=True)


def publish(spec: ObjectSpec, result: StoredResult, out: Path) -> list[Path]:
    """Copy the files of one stage that users read; returns where they are."""
    if result.stage == "build":
        return publish_parts(spec, result.folder, cad_folder(out, spec.name))
    folder = cad_folder if result.stage in _BESIDE_THE_PARTS else run_folder
    return publish_to(folder(out, spec.name), result)


def publish_to(target: Path, result: StoredResult) -> list[Path]:
    """Copy a stage's files for users into a folder; returns where they are."""
    return [
        _copy(source, target / source.relative_to(result.folder))
        for source in published_files(result.stage, result.folder)
    ]


def publish_parts(spec: ObjectSpec, source: Path, target: Path) -> list[Path]:
    """Parts first, the manifest last, with the hash of the whole specification of this run."""
    from design.build.manifest import MANIFEST_NAME, BuildManifest

    skip = {MANIFEST_NAME, RECORD}
    paths = [
        _copy(path, target / path.name)
        for path in sorted(source.iterdir())
        if path.name not in skip
    ]
    manifest = replace(BuildManifest.read(source), name=spec.name, spec_hash=spec_hash(spec))
    return [*paths, manifest.write(target)]


def _copy(source: Path, target: Path) -> Path:
    """Copy unless the target is already that file (same size and time of change)."""
    source_status, target_status = source.stat(), target.stat() if target.exists() else None
    if target_status and (target_status.st_size, target_status.st_mtime_ns) == (
        source_status.st_size,
        source_status.st_mtime_ns,
    ):
        return target
    with atomic_path(target) as temporary:
        shutil.copy2(source, temporary)
    return target


def stage_row(result: StoredResult) -> dict[str, Any]:
    """A stage result as JSON."""
    return {
        "stage": result.stage,
        "key": result.key[:16],
        "reused": result.reused,
        "seconds": round(result.seconds, 2),
    }


def object_row(
    spec: ObjectSpec, results: Iterable[StoredResult], summary: dict[str, Any], files: list[Path]
) -> dict[str, Any]:
    """Return what a command made of one object, as JSON."""
    return {
        "name": spec.name,
        "spec_hash": spec_hash(spec),
        "stages": [stage_row(result) for result in results],
        "summary": summary,
        "files": file_rows(files),
    }


def file_rows(files: list[Path]) -> list[dict[str, Any]]:
    """Written files with their sizes, each once, as JSON."""
    return [{"path": str(path), "bytes": path.stat().st_size} for path in dict.fromkeys(files)]
