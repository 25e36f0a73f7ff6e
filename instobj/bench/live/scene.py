"""The object for the live page: its parts from a build, the cast shell as it is at rest."""

from __future__ import annotations

from pathlib import Path

from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from instobj.render.pieces import load_stl
from instobj.viewer.archive import pack
from instobj.viewer.scene import add_surface, object_scene
from instobj.viewer.surface import shaded_part


def live_scene(spec: ObjectSpec, build: Path, key: str) -> bytes:
    """The archive that the page fetches; `key` says below the picture what it shows."""
    content, arrays = object_scene(spec, build)
    arrays = {name: array for name, array in arrays.items() if not name.startswith("mould_")}
    add_surface(arrays, "silicone", shaded_part(load_stl(build / "shell.stl")))
    content |= {"mould": [], "live": {"channels": channel_names(spec), "key": key}}
    return pack(content, arrays)
