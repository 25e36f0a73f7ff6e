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

from design.files import atomic_path
from estimator.frames.face_data import channel_label
from estimator.networks.face_model import FaceModel, description
from estimator.networks.prediction import UNITS

OPSET = 18
_EXAMPLE_FRAMES = 3


def export_onnx(model: FaceModel, path: Path | str) -> None:
    """Write one self-contained ONNX file; input `counts` (frame, channel), changes against rest.

    Outputs agree with those of the trained model within 1e-5 of their size (tested).
    """
    import onnx

    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder) / "plain.onnx"
        _export(model, plain)
        graph = onnx.load(plain)
    onnx.helper.set_model_props(graph, _properties(model))
    onnx.checker.check_model(graph)
    with atomic_path(path) as temporary:
        onnx.save(graph, temporary)


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
        )


def _properties(model: FaceModel) -> dict[str, str]:
    described: dict[str, Any] = description(model) | {
        "channel_names": [channel_label(channel) for channel in model.channels],
        "input": "counts: change of each channel against rest, raw counts, in channel order; dF: "
        "the channel's change over history_frames frames",
        "units": UNITS,
        "axes": "the face's x, y and inward normal; heatmaps hold the normal alone or all three",
    }
    return {"instobj": json.dumps(described)}
