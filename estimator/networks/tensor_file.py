"""Tensors and a JSON description in one sealed safetensors file; tensors that torch recorded."""

from __future__ import annotations

import json
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.errors import RecordingError, StoreError
from design.files import atomic_path
from design.seal import SEAL, sealed, sealed_content


def save_tensors(tensors: Mapping[str, Tensor], described: Any, path: Path | str) -> None:
    """Write copies of the tensors and what describes them; the same give the same bytes."""
    from safetensors.torch import save

    held = {name: value.detach().cpu().clone().contiguous() for name, value in tensors.items()}
    content = save(held, {"instobj": json.dumps(described), "seal": SEAL})
    with atomic_path(path) as temporary:
        temporary.write_bytes(sealed(_sort_header(content)))


def _sort_header(content: bytes) -> bytes:
    """With the keys of the header sorted: the library writes the description's in any order.

    The header is JSON, its length before it in 8 bytes, filled up with spaces to a multiple of 8;
    places of tensors count from its end (format of safetensors).
    """
    start = 8 + int.from_bytes(content[:8], "little")
    header = json.dumps(json.loads(content[8:start]), sort_keys=True).encode()
    header += b" " * (-len(header) % 8)
    return len(header).to_bytes(8, "little") + header + content[start:]


def load_tensors(path: Path, advice: str) -> tuple[Any, dict[str, Tensor]]:
    """Description and tensors; no code is run from the file.

    Raises
    ------
    StoreError
        Not such a file, or damaged; `advice` says how to get a sound one.
    """
    from safetensors import SafetensorError, safe_open

    try:
        with safe_open(path, framework="pt") as file:
            metadata = file.metadata() or {}
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
    except (SafetensorError, OSError):
        raise StoreError(f"{path} is not a safetensors file, or is damaged. {advice}") from None
    sealed_content(path, advice)
    try:
        return json.loads(metadata["instobj"]), tensors
    except (KeyError, RecursionError, ValueError):
        raise StoreError(f"{path} was not written by instobj. {advice}") from None


def read_recorded_tensor(path: Path) -> Float[np.ndarray, "frame channel"]:
    """Return the numbers of a `.pt` file of one tensor, frames along its first axis.

    Only tensors are read (`weights_only`): a file that names any other object is refused, and no code of it
    runs.

    Raises
    ------
    RecordingError
        No such file, damaged, more than a tensor, or no frames of real numbers.
    """
    if not path.is_file():
        raise RecordingError(f"no recording at {path}. Give the path of a recording")
    try:
        with warnings.catch_warnings(action="ignore"):  # of pickles that are refused anyway
            content = torch.load(path, map_location="cpu", weights_only=True)
    except Exception:  # torch raises errors of many kinds for what is damaged or is no tensor
        raise RecordingError(
            f"{path} cannot be read as tensors alone: damaged, or it holds other objects, which are not "
            "loaded. Save one tensor (frame, channel) by torch.save"
        ) from None
    is_tensor = isinstance(content, Tensor) and not content.is_complex() and not content.is_sparse
    if not is_tensor or content.dim() < 2 or not content.numel():
        held = f"a tensor of shape {tuple(content.shape)}" if is_tensor else "something else"
        raise RecordingError(
            f"{path} must hold one tensor (frame, channel) of real numbers; got {held}. Save the readings so"
        )
    return content.detach().reshape(len(content), -1).to(torch.float64).numpy()
