"""Trained estimators as ONNX files that hold all that a robot needs: scaling, units, channel order.

`estimator.deploy.runtime` uses such a file without torch.
"""

from __future__ import annotations

import json
import logging
import tempfile
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.files import atomic_path
from design.seal import SEAL, sealed
from estimator.deploy.runtime import open_session
from estimator.frames.face_data import channel_label
from estimator.networks.face_model import FaceModel, description
from estimator.networks.prediction import UNITS

OPSET = 18
"""Version of ONNX's operators."""
_EXAMPLE_FRAMES = 3
"""Frames of the example that the export traces."""
_PROBE_FRAMES_PER_SCALE = 64
"""Frames of each size by which the exported model is compared."""
_PROBE_SCALES_COUNTS = tuple(2.0**power for power in range(0, 17, 2))
"""From the noise of a channel to the range of a 16-bit chip."""
_PARITY = 1e-3
"""Share of an output's largest value among changes of one scale: single precision leaves 1e-4."""
_NOTHING = 1e-6
"""Difference (N, mm or a chance) that no reader sees: at rest an output may be 1e-17, of which single
precision leaves a tenth."""


def export_onnx(model: FaceModel, path: Path | str) -> None:
    """Write one self-contained ONNX file; input `counts` (frame, channel), changes against rest.

    Outputs agree with those of the trained model within 1e-5 of their size on its data (tested).
    Before the file gets its name it is run on random changes of 1 to 65 536 counts, and must be
    finite and within 1e-3 of the trained model's outputs on each scale of them (and 1e-6 N, mm).

    Raises
    ------
    InputError
        The exported graph does not do what the trained model does; no file is written.
    """
    import onnx

    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder) / "plain.onnx"
        _export(model, plain)
        graph = onnx.load(plain)
    onnx.helper.set_model_props(graph, _properties(model))
    onnx.checker.check_model(graph)
    with atomic_path(path) as temporary:
        temporary.write_bytes(sealed(graph.SerializeToString(deterministic=True)))
        require_parity(model, temporary, path)


def require_parity(model: FaceModel, written: Path, path: Path | str) -> None:
    """The written file against the trained model, on changes far beyond those of training too."""
    import torch

    counts = probe_counts(len(model.channels))
    outputs = open_session(written).run(None, {"counts": counts})
    with torch.no_grad():
        expected = model.network.cpu().eval()(torch.from_numpy(counts))
    for name, got, tensor in zip(UNITS, outputs, expected, strict=True):
        true = tensor.numpy()
        allowed = _PARITY * output_sizes(true) + _NOTHING
        wrong = ~np.isclose(got, true, rtol=0, atol=allowed, equal_nan=True)
        if wrong.any():
            frames = wrong.reshape(len(wrong), -1).any(axis=1).mean()
            raise InputError(
                f"{path} is not written: in {100 * frames:.2g} % of test frames the exported {name} is "
                "not that of the trained model (or not a number). Install the versions of torch, onnx, "
                "onnxscript and onnxruntime that constraints.txt pins, then export again"
            )


def output_sizes(output: np.ndarray) -> np.ndarray:
    """Largest value of an output among the frames of each frame's scale, as a column of frames."""
    finite = np.nan_to_num(np.abs(output), posinf=0.0).reshape(len(_PROBE_SCALES_COUNTS), -1)
    sizes = np.repeat(finite.max(axis=1), _PROBE_FRAMES_PER_SCALE)
    return sizes.reshape(-1, *[1] * (output.ndim - 1))


def probe_counts(channels: int) -> np.ndarray:
    """Random changes of counts, from a channel's noise to a 16-bit chip's range; (frame, channel)."""
    rng = np.random.default_rng(1)
    scale = np.repeat(_PROBE_SCALES_COUNTS, _PROBE_FRAMES_PER_SCALE)
    return (scale[:, None] * rng.normal(size=(len(scale), channels))).astype(np.float32)


def _export(model: FaceModel, path: Path) -> None:
    import torch

    network = model.network.cpu().eval()
    counts = torch.zeros(_EXAMPLE_FRAMES, len(model.channels))
    frame = torch.export.Dim("frame", min=1)
    logging.getLogger("torch.onnx").setLevel(logging.ERROR)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        torch.onnx.export(
            network,
            (counts,),
            path,
            input_names=["counts"],
            output_names=list(UNITS),
            dynamic_shapes={"counts": {0: frame}},
            opset_version=OPSET,
            dynamo=True,
            external_data=False,
            verbose=False,
            optimize=False,  # onnxscript's optimizer takes `+ 1e-12` for nothing: 0/0 afterwards
        )


def _properties(model: FaceModel) -> dict[str, str]:
    described: dict[str, Any] = description(model) | {
        "channel_names": [channel_label(channel) for channel in model.channels],
        "input": "counts: change of each channel against rest, raw counts, in channel order; dF: "
        "the channel's change over history_frames frames",
        "units": UNITS,
        "axes": "the face's x, y and inward normal; heatmaps hold the normal alone or all three",
    }
    return {"instobj": json.dumps(described), "seal": SEAL}
