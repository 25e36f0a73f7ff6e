"""The functions of `import instobj`, apart from what lower rooms offer as they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec, TrainingSpec

if TYPE_CHECKING:
    import xarray as xr

    from design.build.manifest import BuildManifest
    from estimator.frames.dataset import FrameSet
    from estimator.metrics.heatmaps import FaceMetrics
    from estimator.networks.face_model import FaceModel
    from estimator.networks.prediction import Prediction
    from estimator.recordings.reading import Recording


def build_parts(spec: ObjectSpec, out: Path | str = "cad_out") -> BuildManifest:
    """Build core, shell, mould, probes and jig, and write their files to `out/<name of the object>`.

    Every part is written as STL, STEP and 3MF, the assembly as GLB; `manifest.json` lists them.
    Parts that the store holds are copied.

    Parameters
    ----------
    spec : ObjectSpec
    out : path
        Folder that gets a folder named after the object.

    Returns
    -------
    BuildManifest
        Name, volume (mm³), size (mm) and files of every part.

    Raises
    ------
    SpecError
        The dimensions give no valid part.
    StoreError
        A folder cannot be written.

    Examples
    --------
    >>> import instobj
    >>> tiny = instobj.ObjectSpec(name="tiny", body={"sensed_faces": [1]})
    >>> manifest = instobj.build_parts(tiny, "cad_out")
    >>> [part.name for part in manifest.parts][:2]
    ['core', 'shell']
    """
    from design.build.manifest import BuildManifest
    from instobj.stages.run import Run
    from instobj.store.publish import publish_parts

    folder = Path(out) / spec.name
    publish_parts(spec, Run(spec).require("build").folder, folder)
    return BuildManifest.read(folder)


def compare(specs: Sequence[ObjectSpec]) -> xr.Dataset:
    """Scores of several objects side by side.

    Each object is simulated as by `Run`, or read from the store.

    Parameters
    ----------
    specs : sequence of ObjectSpec
        Objects with different names.

    Returns
    -------
    Dataset (object, statistic)
        `position_bound_mm` (mm), `force_bound_n` (N) and `detectable_force_n` (N), freshly tared:
        the median and the largest over all contact locations where a press reaches
        `score.force_n`; `share_within_limit` (object): of these,
        those whose position bound is within `limits.position_bound_mm` of the specification.

    Raises
    ------
    InputError
        No object, or two of one name.

    Examples
    --------
    >>> import instobj
    >>> same = {
    ...     "body": {"sensed_faces": [1]}, "contact_grid": {"count": [3, 3], "pitch_mm": 6.0},
    ...     "press": {"depths_mm": [1.0, 2.0]}, "score": {"force_n": 2.0},
    ...     "mesh": {"edge_mm": 8.0, "surface_edge_mm": 3.0, "envelope_mm": 0.1},
    ... }
    >>> tiny = instobj.ObjectSpec(name="tiny", **same)
    >>> quiet = instobj.ObjectSpec(name="quiet", sensors={"noise_counts": (1, 1, 1)}, **same)
    >>> table = instobj.compare([tiny, quiet])
    >>> before, after = table.force_bound_n.sel(statistic="median").values
    >>> bool(after < before)
    True
    """
    from design.errors import InputError
    from instobj.stages.named import Results
    from instobj.stages.run import Run

    names = [spec.name for spec in specs]
    if not names or len(set(names)) < len(names):
        raise InputError(f"objects to compare need a name each; got {names}. Rename them")
    scores = [Run(spec).scores for spec in specs]
    columns = {
        name: (
            ("object", "statistic"),
            [_median_and_largest(score[name]) for score in scores],
            {"units": scores[0][name].attrs["units"]},
        )
        for name in ("position_bound_mm", "force_bound_n", "detectable_force_n")
    }
    limits = [spec.limits.position_bound_mm for spec in specs]
    within = [
        float(np.mean(score.position_bound_mm.values[score.reaches_score_force.values] <= limit))
        for score, limit in zip(scores, limits, strict=True)
    ]
    return Results(
        columns | {"share_within_limit": ("object", within, {"units": "1"})},
        coords={"object": names, "statistic": ["median", "largest"]},
    )


def _median_and_largest(score: xr.DataArray) -> list[float]:
    """Over the contact locations that are judged."""
    on_face = score.values[score.on_face.values]
    return [float(np.nanmedian(on_face)), float(np.nanmax(on_face))]


def fit_estimator(
    data: Recording | FrameSet,
    face: int,
    training: TrainingSpec | Mapping[str, Any] | None = None,
    seed: int = 1,
) -> FaceModel:
    """Train the contact estimator of one face on a recording or a data set.

    Three fifths of the presses train it, a fifth stops the training and calibrates its intervals;
    the last fifth is left for `evaluate`, which finds it by the same seed.

    Parameters
    ----------
    data : Recording or FrameSet
        What `read_recording` or `load_frames` gives, or `Run.frames`.
    face : int
        Number of the face.
    training : mapping or TrainingSpec, optional
        Settings, as in the table `[training]` of a specification, or that table of a specification
        (`spec.training`); by default a compact network.
    seed : int
        Of the split, the first weights and the order of the frames.

    Returns
    -------
    FaceModel
        The estimator; `save_model` writes it.

    Raises
    ------
    SpecError
        Settings that there are not, or out of their range.
    InputError
        No contact on the face, or fewer than three presses.

    Examples
    --------
    >>> import instobj
    >>> quick = {"epochs": 3, "hidden_units": [16, 16]}
    >>> frames = instobj.load_frames("frames.nc")
    >>> model = instobj.fit_estimator(frames, face=1, training=quick)
    >>> model
    FaceModel compact of face 1: reads 9 channels; heatmap 3 × 3 pixels, N; 90 % intervals from 9 presses
    >>> reading = instobj.predict(model, frames)
    >>> reading.force_n.shape == (len(frames),)
    True
    """
    from estimator.frames.splits import split_presses
    from estimator.networks.training.face import FitSettings
    from estimator.networks.training.face import fit_estimator as fit

    frames = _frames(data)
    split = split_presses(frames, seed)
    table = training if isinstance(training, TrainingSpec) else TrainingSpec(**(training or {}))
    settings = FitSettings(face, table, seed)
    return fit(frames.select(split.train), frames.select(split.validation), settings)


def predict(model: FaceModel, data: Recording | FrameSet) -> Prediction:
    """Contacts that an estimator reads in every frame.

    Parameters
    ----------
    model : FaceModel
    data : Recording or FrameSet
        Frames with the channels that the model was trained on.

    Returns
    -------
    Prediction
        Arrays over frames: `heatmap_n` (frame, axis, nx, ny) and `force_n`, N; `xy_mm` (frame, 2) in
        the face's frame (along a curved surface); `contact`, probability; half-widths of intervals, N and
        mm. NaN in frames that lack a reading.

    Raises
    ------
    InputError
        A channel that the model uses has no readings, or data of another object.

    Examples
    --------
    As of `fit_estimator`.
    """
    from estimator.frames.same_object import require_same_object
    from estimator.networks.face_model import predict_with_gaps

    frames = _frames(data)
    grid_mm = model.grid_x_mm, model.grid_y_mm
    require_same_object(model.channels, grid_mm, frames, "the data")
    return predict_with_gaps(model, frames)


def evaluate(model: FaceModel, data: Recording | FrameSet, seed: int = 1) -> FaceMetrics:
    """Metrics of an estimator on the presses that `fit_estimator` held out.

    Parameters
    ----------
    model : FaceModel
    data : Recording or FrameSet
        What the model was trained on.
    seed : int
        That of `fit_estimator`.

    Returns
    -------
    FaceMetrics
        Similarity of heatmaps, localisation error (pixels), force error (N, %), accuracy at rest.

    Raises
    ------
    InputError
        The held-out presses hold no usable frame of the face, or data of another object.

    Examples
    --------
    >>> import instobj
    >>> quick = {"epochs": 3, "hidden_units": [16, 16]}
    >>> frames = instobj.load_frames("frames.nc")
    >>> model = instobj.fit_estimator(frames, face=1, training=quick)
    >>> instobj.evaluate(model, frames).contact_frames > 0
    True
    """
    from estimator.evaluation.evaluation import evaluate_face
    from estimator.frames.same_object import require_same_object
    from estimator.frames.splits import split_presses

    frames = _frames(data)
    require_same_object(model.channels, (model.grid_x_mm, model.grid_y_mm), frames, "the data")
    held_out = frames.select(split_presses(frames, seed).test)
    return evaluate_face(model, held_out, dataset=frames)


def _frames(data: Recording | FrameSet) -> FrameSet:
    from design.errors import InputError
    from estimator.frames.dataset import FrameSet
    from estimator.recordings.reading import Recording

    if isinstance(data, Recording):
        return data.frames
    if not isinstance(data, FrameSet):
        raise InputError(
            f"data must be a recording or a data set; got {type(data).__name__}. Read a file with "
            "instobj.read_recording or instobj.load_frames"
        )
    return data
