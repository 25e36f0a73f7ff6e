"""A run: the results of one specification, each made when it is first asked for, then kept."""

from __future__ import annotations

import platform
from dataclasses import dataclass, field, fields
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from design.errors import InputError
from design.imports import missing_extra
from design.spec.object import ObjectSpec
from design.spec_io import check
from instobj.stages.inputs import stage_inputs
from instobj.stages.resources import require_memory
from instobj.stages.table import STAGES
from instobj.store import readers
from instobj.store.content import StoredResult, find, store_root, stored
from instobj.store.keys import stage_key
from instobj.store.progress import ProgressLine
from instobj.store.readers import ResultFile
from instobj.store.stage import Call, StageContext

if TYPE_CHECKING:
    import xarray as xr

    from estimator.frames.dataset import FrameSet
    from estimator.inversion.inversion import Inversion
    from estimator.networks.face_model import FaceModel
    from fem.mesh.tetrahedra import TetMesh
    from instobj.report.widget import ObjectView

Content = TypeVar("Content")
_LIBRARIES = ("instobj",)
WORTH_A_LINE_S = 30.0
"""Time of a stage above which it gets a line of its own in a log, s."""
_UNITS_BY_ENDING = {"n_per_mm": "N/mm", "mm": "mm", "n": "N", "deg": "deg"}
_UNITS_BY_NAME = {
    "delta_raw": "count^d/N",
    "delta_scaled": "1/N",
    "reaches_score_force": "1",
}


@dataclass(eq=False, repr=False)
class Run:
    """The results of one specification: made when first asked for, stored, and reused.

    The store is the one of the commands (`INSTOBJ_STORE`, by default `.instobj` in the current
    folder): what `instobj run` has made is read, and a run that was interrupted goes on from its
    last complete stage. Progress is not printed, but by the command line.

    Parameters
    ----------
    spec : ObjectSpec
        The object. `load_spec` reads one from a file.
    checked : bool
        Whether its parts must fit together; False for mechanics of a shell whose layout is still sought.

    Raises
    ------
    SpecError
        The parts do not fit together; on asking for a result: it cannot be simulated as specified.
    SolverError
        On asking for a result: a mesh or a solve failed.
    StoreError
        On asking for a result: the store cannot be read or written.

    Examples
    --------
    A small object: one sensed face with 3 × 3 contact locations, on a coarse mesh.

    >>> import instobj
    >>> tiny = instobj.ObjectSpec(
    ...     name="tiny", body={"sensed_faces": [1]},
    ...     contact_grid={"count": [3, 3], "pitch_mm": 6.0}, press={"depths_mm": [1.0, 2.0]},
    ...     mesh={"edge_mm": 8.0, "surface_edge_mm": 3.0, "envelope_mm": 0.1},
    ...     score={"force_n": 2.0},
    ... )
    >>> run = instobj.Run(tiny)
    >>> run.scores.position_bound_mm.dims
    ('face', 'place')
    >>> run.scores.position_bound_mm.attrs["units"]
    'mm'
    >>> bool(run.scores.position_bound_mm.max() < 5.0)
    True
    """

    spec: ObjectSpec
    progress: ProgressLine = field(default_factory=ProgressLine)
    root: Path = field(default_factory=store_root)
    results: dict[str, StoredResult] = field(default_factory=dict)
    known_results: dict[str, StoredResult] = field(default_factory=dict)
    call: Call | None = None
    checked: bool = True

    def __post_init__(self) -> None:
        if self.checked:
            check(self.spec, table=False)

    def __getattr__(self, name: str) -> Any:
        """Called for names that a run has not."""
        names = [entry for entry in dir(type(self)) if not entry.startswith("_")]
        raise AttributeError(f"a Run has no {name!r}. It has {', '.join(names)}")

    def __repr__(self) -> str:
        stage_names = ", ".join(self.results) or "nothing asked for yet"
        return f"Run of {self.spec.name} in {self.root}: {stage_names}"

    def require(self, name: str) -> StoredResult:
        """The stage's result, after those of every stage that it needs."""
        if name in self.results:
            return self.results[name]
        if self.call is not None:
            return self._made(name, self.call)
        # Refused before anything is made: a mesh takes minutes.
        for stage in sorted(with_needs(name)):
            require_memory(stage, self.spec)
        self.call = Call(with_needs(name))
        try:
            return self._made(name, self.call)
        finally:
            self.call.end()
            self.call = None

    def stored(self, name: str) -> StoredResult | None:
        """The stage's result where it is stored with everything that it needs; nothing is made."""
        stage, origins = STAGES[name], {}
        for need in stage.needs:
            result = self.stored(need)
            if result is None:
                return None
            origins[need] = result.origin
        for need, (stage_of_other, spec) in stage.of_others(self.spec).items():
            result = self._run_of(spec).stored(stage_of_other)
            if result is None:
                return None
            origins[need] = result.origin
        key = stage_key(name, stage_inputs(stage, self.spec, origins, versions()))
        return self.known_results.get(key) or find(self.root, name, key, self.progress.say)

    def _made(self, name: str, call: Call) -> StoredResult:
        stage = STAGES[name]
        needs = {need: self.require(need) for need in stage.needs}
        for need, (stage_of_other, spec) in stage.of_others(self.spec).items():
            needs[need] = self._run_of(spec).require(stage_of_other)
        origins = {need: result.origin for need, result in needs.items()}
        inputs = stage_inputs(stage, self.spec, origins, versions())
        folders = {need: result.folder for need, result in needs.items()}
        key = stage_key(name, inputs)
        if key in self.known_results:
            self.results[name] = self.known_results[key]
            return self.results[name]

        def make(folder: Path) -> None:
            context = StageContext(self.spec, folders, key, self.progress.step, call)
            try:
                stage.make(context, folder)
            except MemoryError:
                raise InputError(
                    f"{stage.title}: the machine has no more memory. End other programs, or make the "
                    "object's mesh, contact grid or data sets smaller"
                ) from None

        with self.progress.stage(stage.title):
            result = stored(self.root, name, inputs, make, self.progress.say)
        self.results[name] = self.known_results[key] = result
        if result.reused:
            self.progress.step(f"{stage.title}: reused")
        elif result.seconds >= WORTH_A_LINE_S:
            self.progress.say(f"{stage.title}: made in {result.seconds:.1f} s")
        return result

    def _run_of(self, spec: ObjectSpec) -> Run:
        """The chain of another specification, on the same store; results that both have are asked
        for, verified and reported once."""
        if spec == self.spec:
            return self
        return Run(
            spec, self.progress, self.root, known_results=self.known_results, checked=self.checked
        )

    def read(self, file: ResultFile[Content]) -> Content:
        """A result file of `instobj.store.readers`, its stage made first where it is not stored."""
        return file.read(self.require(file.stage).folder)

    @property
    def mesh(self) -> TetMesh:
        """Tetrahedra of the sealed body, every magnet resolved; lengths in mm."""
        return self.read(readers.MESH)

    @property
    def presses(self) -> xr.Dataset:
        """Every simulated press: normal force, contact area and motion of every magnet.

        Dimensions: face, place (of the press lattice; `x_mm`, `y_mm` along the face's surface),
        step (with `depth_mm`), magnet, component (x, y, z displacement in mm; rotation vector in
        rad). Variables: `force_n` (N), `contact_area_mm2` (mm²), `motion`; NaN at places that a
        face has not.
        """
        from instobj.stages.named import Results

        forces, motions = self.read(readers.PRESSES)
        per_press = ("face", "place", "step")
        xy_mm = forces.lattice.xy_mm
        return Results(
            {
                "force_n": (per_press, forces.force_n, {"units": "N"}),
                "contact_area_mm2": (per_press, forces.contact_area_mm2, {"units": "mm2"}),
                "motion": (
                    (*per_press, "magnet", "component"),
                    motions.motion,
                    {"units": "mm mm mm rad rad rad"},
                ),
            },
            coords={"face": forces.faces, "depth_mm": ("step", forces.depth_mm, {"units": "mm"})}
            | _places(xy_mm),
        )

    @property
    def signals(self) -> xr.Dataset:
        """Return what every sensor reads in every press of a contact location.

        Dimensions: face, place (with `x_mm`, `y_mm`), step (with `depth_mm`), sensor (all faces,
        with `sensor_face`), axis (X, Y, Z of the chip). Variables: `force_n` (N), `delta_counts`,
        `baseline_counts` and `reading_counts`, a simulated noisy reading (counts). Places that a
        face has not are NaN, −2147483648 among the readings.
        """
        from instobj.stages.named import results_in

        return results_in(self.read(readers.GRID_SIGNALS))

    @property
    def scores(self) -> xr.Dataset:
        """Cramér–Rao bounds and sensitivity of every contact location.

        Dimensions: face, place (with `x_mm`, `y_mm` along the face's surface). Variables, each freshly
        tared and as `…_drifted_…` after 15 min: `position_bound_mm` (mm), `force_bound_n` (N),
        `detectable_force_n` (N); further `position_error_mm` (mm, root mean square of what maximum
        likelihood reads, freshly tared), `delta_raw`, `delta_scaled` (convex-hull sensitivity),
        `weakest_direction_deg`, `force_at_score_n`, `reaches_score_force`, `depth_at_score_mm`,
        `stiffness_n_per_mm`. The coordinate `on_face` (face, place) says which places of the grid a
        face has; variables are NaN at the others; bounds and
        δ also where no press `reaches_score_force`. Source: `estimator.information.scores`.
        """
        from instobj.stages.named import Results

        scores = self.read(readers.SCORES)
        names = [field.name for field in fields(scores)][2:]
        return Results(
            {
                name: (
                    ("face", "place"),
                    getattr(scores, name),
                    {"units": _unit(name)},
                )
                for name in names
            },
            coords={"face": scores.faces, "on_face": (("face", "place"), scores.places)}
            | _places(scores.grid.xy_mm),
        )

    @property
    def frames(self) -> FrameSet:
        """Simulated calibration presses as labelled frames, the data that estimators learn from."""
        return self.read(readers.FRAMES)

    @property
    def inversion(self) -> Inversion:
        """The estimator that inverts the design's forward model: contacts on all faces at once."""
        return self.read(readers.INVERSION)

    def estimator(self, face: int) -> FaceModel:
        """The estimator of a face, trained on `frames`.

        Raises
        ------
        InputError
            The face is not sensed.
        """
        models = self.read(readers.MODELS)
        if face not in models:
            raise InputError(
                f"there is no estimator of face {face}. Give one of the faces {sorted(models)}"
            )
        return models[face]

    def view(self) -> ObjectView:
        """The object in three dimensions, as in the report: a widget for a notebook.

        Press, slide and turn it there; numbers are those of `signals` and `scores`. Needs the extra
        `notebook`.

        Raises
        ------
        InputError
            anywidget is not installed.
        """
        try:
            from instobj.report.widget import object_view
        except ModuleNotFoundError as error:
            advice = missing_extra(error) or str(error)
            raise InputError(f"{advice}. Or open report.html of `instobj run`") from error
        return object_view(self.spec.name, self.read(readers.SCENE).read_bytes())


def _places(xy_mm: np.ndarray) -> dict[str, tuple[str, np.ndarray, dict[str, str]]]:
    x, y = xy_mm.T
    return {"x_mm": ("place", x, {"units": "mm"}), "y_mm": ("place", y, {"units": "mm"})}


def _unit(name: str) -> str:
    endings = (unit for end, unit in _UNITS_BY_ENDING.items() if name.endswith(f"_{end}"))
    return _UNITS_BY_NAME.get(name) or next(endings)


def with_needs(*names: str) -> frozenset[str]:
    """The stages, and all that they need of the same specification."""
    return frozenset(names).union(*(with_needs(*STAGES[name].needs) for name in names))


def versions() -> dict[str, str]:
    """Versions that a result depends on besides its specification."""
    return {name: version(name) for name in _LIBRARIES} | {"machine": platform.machine()}
