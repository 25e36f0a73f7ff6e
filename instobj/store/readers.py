"""Files of stage results: their names, which of them users get, and how each is read.

A stage's files are declared here once. Makers write to `path`, everyone else calls `read`.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING:
    from design.build.manifest import BuildManifest
    from design.build.order_list import OrderLine
    from estimator.frames.dataset import FrameSet
    from estimator.information.scores import PlaceScores
    from estimator.inversion.inversion import Inversion
    from estimator.networks.face_model import FaceModel
    from estimator.signals.presses import Signals
    from estimator.tolerances.result import Robustness
    from fem.large_strain.correction import StrainCorrection
    from fem.linear.response import ResponseOperator
    from fem.mesh.tetrahedra import TetMesh
    from fem.presses.results import MagnetMotions, PressForces, ShearMotions

Content = TypeVar("Content")


@dataclass(frozen=True)
class ResultFile(Generic[Content]):
    """A file, or a pattern of files, in the folder of a stage's result.

    Attributes
    ----------
    stage : name of the stage that writes it
    name : in the stage's folder; with `*`, of several files
    load : reads it from its path
    published : whether it is copied to `runs/<name>` or `cad_out/<name>`, where users look
    """

    stage: str
    name: str
    load: Callable[[Path], Content]
    published: bool = False

    def path(self, folder: Path) -> Path:
        """Return where it lies in the stage's folder."""
        return folder / self.name

    def read(self, folder: Path) -> Content:
        """Return what it holds, from the stage's folder."""
        return self.load(self.path(folder))


def published_files(stage: str, folder: Path) -> list[Path]:
    """Files of a stage's folder that users get, in the order of their declaration."""
    names = [file.name for file in _published() if file.stage == stage]
    return [path for name in names for path in sorted(folder.glob(name))]


def published_tables() -> list[str]:
    """Names of the CSV files among all that users get."""
    return [file.name for file in _published() if file.name.endswith(".csv")]


def _published() -> list[ResultFile[Any]]:
    files = [file for file in globals().values() if isinstance(file, ResultFile)]
    return [file for file in files if file.published]


def face_model_path(folder: Path, face: int) -> Path:
    """Return where the estimator of a face lies in a folder of estimators."""
    return folder / f"face_{face}.safetensors"


def face_model_paths(folder: Path) -> list[Path]:
    """Estimators in a folder, one per face, in the order of the faces."""
    return sorted(folder.glob("face_*.safetensors"))


def collection_path(folder: Path, kind: str) -> Path:
    """Return where simulated recordings of a kind lie in the folder of their stage."""
    return folder / f"frames_{kind}.nc"


def _json(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text(encoding="utf-8"))


def _json_if_there(path: Path) -> dict[str, Any] | None:
    return _json(path) if path.exists() else None


def _rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _path(path: Path) -> Path:
    return path


def _reader(module: str, name: str) -> Callable[[Path], Any]:
    """Return a reader by its module and name, imported when it first reads: many are slow to load."""
    return lambda path: getattr(import_module(module), name)(path)


def _folder_reader(module: str, name: str) -> Callable[[Path], Any]:
    """The same of a reader that takes the folder of several files."""
    return lambda path: _reader(module, name)(path.parent)


def _correction(path: Path) -> StrainCorrection | None:
    """None where none was asked for."""
    from fem.large_strain.correction import StrainCorrection

    content = _json(path)["correction"]
    if content is None:
        return None
    lists = (tuple(content[name]) for name in ("force", "shift", "rotation"))
    return StrainCorrection(content["thickness_mm"], *lists)


def _face_models(path: Path) -> dict[int, FaceModel]:
    """Estimators by face."""
    models = [_face_model(model_path) for model_path in face_model_paths(path.parent)]
    return {model.face: model for model in models}


_mesh: Callable[[Path], TetMesh] = _reader("fem.mesh.tetrahedra", "load_mesh")
_response: Callable[[Path], ResponseOperator] = _folder_reader(
    "fem.linear.response", "load_response"
)
_presses: Callable[[Path], tuple[PressForces, MagnetMotions]] = _reader(
    "fem.presses.results", "load_presses"
)
_forces: Callable[[Path], PressForces] = _reader("fem.presses.results", "load_forces")
_shear: Callable[[Path], ShearMotions] = _reader("fem.presses.shear", "load_shear")
_signals: Callable[[Path], Signals] = _reader("estimator.signals.presses", "load_signals")
_scores: Callable[[Path], PlaceScores] = _reader("estimator.information.scores", "load_scores_csv")
_robustness: Callable[[Path], Robustness] = _reader(
    "estimator.tolerances.result", "load_robustness"
)
_frames: Callable[[Path], FrameSet] = _reader("estimator.frames.dataset", "load_frames")
_face_model: Callable[[Path], FaceModel] = _reader("estimator.networks.face_model", "load_model")
_orders: Callable[[Path], list[OrderLine]] = _reader("design.build.order_list", "load_orders")
_inversion: Callable[[Path], Inversion] = _reader("estimator.inversion.storage", "load_inversion")


def _manifest(folder_file: Path) -> BuildManifest:
    from design.build.manifest import BuildManifest

    return BuildManifest.read(folder_file.parent)


MANIFEST = ResultFile("build", "manifest.json", _manifest)
PARTS_PICTURE = ResultFile("build", "parts.png", _path)
FINDINGS = ResultFile("fabrication", "fabrication.json", _json, published=True)
FINDINGS_PICTURE = ResultFile("fabrication", "fabrication.png", _path, published=True)
ORDERS = ResultFile("sheet", "orders.csv", _orders, published=True)
EXPLODED_VIEW = ResultFile("sheet", "exploded.png", _path, published=True)
DEMOULDING = ResultFile("sheet", "demoulding.png", _path, published=True)
ASSEMBLY_SHEET = ResultFile("sheet", "assembly.html", _path, published=True)
MESH = ResultFile("mesh", "mesh.npz", _mesh)
MESH_QUALITY = ResultFile("mesh", "mesh_quality.json", _json, published=True)
RESPONSE = ResultFile("response", "surfaces.npz", _response)
RESPONSE_SIZE = ResultFile("response", "response.json", _json)
LARGE_STRAIN = ResultFile("large_strain", "large_strain.json", _json, published=True)
CORRECTION = ResultFile("large_strain", "large_strain.json", _correction)
SHAPES = ResultFile("shapes", "shapes/*", _path, published=True)
SECTION = ResultFile("shapes", "shapes/section.png", _path)
PRESSES = ResultFile("presses", "presses.nc", _presses)
CORE_TENSION = ResultFile("presses", "core_tension.json", _json_if_there)
PLAIN_MESH = ResultFile("plain_mesh", "mesh.npz", _mesh)
PLAIN_RESPONSE = ResultFile("plain_response", "surfaces.npz", _response)
PLAIN_FORCES = ResultFile("plain_presses", "forces.nc", _forces)
COMPLIANCE = ResultFile("compliance", "compliance.csv", _rows, published=True)
COMPLIANCE_MAPS = ResultFile("compliance", "maps/*.png", _path, published=True)
SECOND_FIDELITY = ResultFile("second_fidelity", "score.json", _json)
COARSE_RESPONSE = ResultFile("coarse_response", "surfaces.npz", _response)
DISCRETISATION = ResultFile("discretisation", "discretisation.json", _json, published=True)
SIGNALS = ResultFile("signals", "lattice_signals.nc", _signals, published=True)
GRID_SIGNALS = ResultFile("signals", "signals.nc", _path, published=True)
SCORES = ResultFile("scores", "scores.csv", _scores, published=True)
CROSS_FACE = ResultFile("scores", "cross_face.json", _json, published=True)
NUISANCE_COSTS = ResultFile("scores", "nuisance_costs.json", _json, published=True)
SCORE_MAPS = ResultFile("scores", "maps/*.png", _path, published=True)
BOUND_OVERVIEW = ResultFile("scores", "maps/position_bound_overview.png", _path)
WEAK_AREAS = ResultFile("weak_areas", "weak_areas.json", _json, published=True)
WEAK_PLACES = ResultFile("weak_areas", "weak_areas.csv", _rows, published=True)
WEAK_AREAS_PICTURE = ResultFile("weak_areas", "weak_areas.png", _path, published=True)
WEAK_MAPS = ResultFile("weak_areas", "maps/*.png", _path, published=True)
SHEAR = ResultFile("shear", "shear.nc", _shear)
SHEAR_SCORES = ResultFile("shear_scores", "shear_scores.csv", _rows, published=True)
SHEAR_MAPS = ResultFile("shear_scores", "maps/*.png", _path, published=True)
IDENTIFIABILITY = ResultFile("identify", "identifiability.csv", _rows, published=True)
IDENTIFIABILITY_PICTURE = ResultFile("identify", "identifiability.png", _path, published=True)
BLINDEST_PICTURE = ResultFile("identify", "blindest_contacts.png", _path, published=True)
ROBUSTNESS = ResultFile("robustness", "robustness.json", _robustness, published=True)
ROBUSTNESS_PICTURE = ResultFile("robustness", "robustness.png", _path, published=True)
FRAMES = ResultFile("frames", "frames.nc", _frames, published=True)
PROTOCOL = ResultFile("frames", "protocol.json", _json)
COLLECTION = ResultFile("collection", "frames_*.nc", _path, published=True)
COLLECTION_SUMMARY = ResultFile("collection", "frames.json", _json)
PULLED_COLLECTION = ResultFile("pulled_collection", "frames_*.nc", _path, published=True)
PULLED_SUMMARY = ResultFile("pulled_collection", "frames.json", _json)
MODELS = ResultFile("networks", "face_*.safetensors", _face_models, published=True)
CALIBRATION = ResultFile("networks", "calibration.json", _json_if_there, published=True)
CALIBRATION_PICTURE = ResultFile("networks", "calibration.png", _path, published=True)
METRICS = ResultFile("metrics", "metrics.json", _json, published=True)
HELD_OUT_PICTURE = ResultFile("metrics", "metrics/held_out.png", _path, published=True)
INVERSION = ResultFile("inversion", "contacts.nc", _inversion, published=True)
INVERTED_TWIN = ResultFile("inversion", "calibration.json", _json_if_there, published=True)
INVERTED_TWIN_PICTURE = ResultFile("inversion", "calibration.png", _path, published=True)
CONTACT_METRICS = ResultFile("contact_metrics", "contact_metrics.json", _json, published=True)
CONTACT_PICTURE = ResultFile("contact_metrics", "metrics/contacts.png", _path, published=True)
OVER_TIME_PICTURE = ResultFile("metrics", "metrics/over_time.png", _path, published=True)
SURROUNDINGS = ResultFile("surroundings", "surroundings.json", _json)
PRESS_CURVES = ResultFile("press_curves", "press_curves.json", _json)
PRESS_CURVES_PICTURE = ResultFile("press_curves", "press_curves.png", _path)
TIED_COMPLIANCE_MAP = ResultFile("press_curves", "compliance.png", _path)
ALTERNATIVES = ResultFile("alternatives", "alternatives.json", _json)
SLIP = ResultFile("slip", "slip.json", _json, published=True)
SLIP_PICTURE = ResultFile("slip", "slip.png", _path, published=True)
SCENE = ResultFile("scene", "scene.bin", _path)
STILL = ResultFile("scene", "object.png", _path, published=True)
REPORT = ResultFile("report", "report.html", _path, published=True)
PRESS_MESH = ResultFile("press_mesh", "mesh.npz", _mesh)
PRESS = ResultFile("press", "press.json", _json, published=True)
PRESS_FIELDS = ResultFile("press", "press.nc", _path, published=True)
PRESS_CURVE = ResultFile("press", "force_travel.png", _path, published=True)
PRESS_SECTION = ResultFile("press", "section.png", _path, published=True)
EXPERIMENT_MODEL = ResultFile("experiment_models", "model.safetensors", _face_model)
PRESS_SHAPES = ResultFile("press", "*.vtu", _path, published=True)
