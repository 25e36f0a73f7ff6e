"""Tensors and a JSON description in one safetensors file, sealed with a checksum.

The format: the length of a header in 8 bytes, the header as JSON (type, shape and place of each tensor,
and texts under `__metadata__`), the tensors' numbers one behind the other.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor

from design.errors import StoreError
from design.files import atomic_path
from design.seal import SEAL, sealed, sealed_content

_TYPES = {"F64": "<f8", "F32": "<f4", "I64": "<i8", "I32": "<i4", "U8": "|u1", "BOOL": "|b1"}
"""Types of numbers as the format and as NumPy calls them."""
_NAMES = {np.dtype(plain): name for name, plain in _TYPES.items()}
_LENGTH_BYTES = 8
"""Of the header's length; headers are filled up with spaces to a multiple of it."""


def save_tensors(tensors: Mapping[str, Tensor], described: Any, path: Path | str) -> None:
    """Write tensors and what describes them; the same give the same bytes."""
    metadata = {"instobj": json.dumps(described), "seal": SEAL}
    header: dict[str, Any] = {"__metadata__": metadata}
    content = b""
    for name, tensor in sorted(tensors.items()):
        values, start = tensor.detach().cpu().numpy(), len(content)
        content += values.tobytes()
        told = {"dtype": _NAMES[values.dtype], "shape": values.shape}
        header[name] = told | {"data_offsets": [start, len(content)]}
    text = json.dumps(header, sort_keys=True).encode()
    text += b" " * (-len(text) % _LENGTH_BYTES)
    with atomic_path(path) as temporary:
        temporary.write_bytes(sealed(len(text).to_bytes(_LENGTH_BYTES, "little") + text + content))


def load_tensors(path: Path, advice: str) -> tuple[Any, dict[str, Tensor]]:
    """Description and tensors; no code is run from the file.

    Raises
    ------
    StoreError
        Not such a file, or damaged; `advice` says how to get a sound one.
    """
    try:
        metadata, tensors = _parsed(path.read_bytes())
    except (AttributeError, KeyError, OSError, RecursionError, TypeError, ValueError) as error:
        reason = str(error) or type(error).__name__
        raise StoreError(f"{path} is not a safetensors file ({reason}). {advice}") from None
    sealed_content(path, advice)
    try:
        return json.loads(metadata["instobj"]), tensors
    except (KeyError, RecursionError, TypeError, ValueError):
        raise StoreError(f"{path} was not written by instobj. {advice}") from None


def _parsed(content: bytes) -> tuple[dict[str, str], dict[str, Tensor]]:
    """Return texts and tensors of a file's bytes."""
    start = _LENGTH_BYTES + int.from_bytes(content[:_LENGTH_BYTES], "little")
    header, numbers = json.loads(content[_LENGTH_BYTES:start]), content[start:]
    metadata, tensors = header.pop("__metadata__", {}), {}
    for name, told in header.items():
        first, end = told["data_offsets"]
        values = np.frombuffer(numbers[first:end], _TYPES[told["dtype"]]).reshape(told["shape"])
        tensors[name] = torch.from_numpy(values.copy())
    return metadata, tensors
