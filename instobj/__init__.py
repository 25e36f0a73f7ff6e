"""Names to use from Python: design, simulation and calibration of instrumented objects.

Each name is loaded when it is first used (PEP 562, SPEC 1), so that `import instobj` is quick.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from design.errors import (
        InputError,
        InstobjError,
        RecordingError,
        SolverError,
        SpecError,
        StoreError,
    )
    from design.spec.object import ObjectSpec
    from design.spec_io import load_spec
    from estimator.frames.dataset import FrameSet, load_frames
    from estimator.networks.face_model import FaceModel, load_model, save_model
    from estimator.recordings.reading import Recording, read_recording
    from instobj import fem, field, information, robot, sim
    from instobj.api import build_parts, compare, evaluate, fit_estimator, predict
    from instobj.commands.run import check
    from instobj.field import magnet_field
    from instobj.stages.run import Run

__all__ = [
    "FaceModel",
    "FrameSet",
    "InputError",
    "InstobjError",
    "ObjectSpec",
    "Recording",
    "RecordingError",
    "Run",
    "SolverError",
    "SpecError",
    "StoreError",
    "build_parts",
    "check",
    "compare",
    "evaluate",
    "fem",
    "field",
    "fit_estimator",
    "information",
    "load_frames",
    "load_model",
    "load_spec",
    "magnet_field",
    "predict",
    "read_recording",
    "robot",
    "save_model",
    "sim",
]

_HOMES = {
    "design.errors": (
        *("InputError", "InstobjError", "RecordingError"),
        *("SolverError", "SpecError", "StoreError"),
    ),
    "design.spec.object": ("ObjectSpec",),
    "design.spec_io": ("load_spec",),
    "estimator.frames.dataset": ("FrameSet", "load_frames"),
    "estimator.networks.face_model": ("FaceModel", "load_model", "save_model"),
    "estimator.recordings.reading": ("Recording", "read_recording"),
    "instobj": ("fem", "field", "information", "robot", "sim"),
    "instobj.api": ("build_parts", "compare", "evaluate", "fit_estimator", "predict"),
    "instobj.commands.run": ("check",),
    "instobj.field": ("magnet_field",),
    "instobj.stages.run": ("Run",),
}
HOME_OF = {name: module for module, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = HOME_OF[name]
    value = (
        import_module(f"{home}.{name}") if home == __name__ else getattr(import_module(home), name)
    )
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
