"""Tensors and a JSON description in one safetensors file, sealed with a checksum."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from torch import Tensor

from design.errors import StoreError
from design.files import atomic_path
from design.seal import SEAL, seal_file, sealed_content


def save_tensors(tensors: Mapping[str, Tensor], described: Any, path: Path | str) -> None:
    """Write copies of the tensors and what describes them."""
    from safetensors.torch import save_file

    held = {name: value.detach().cpu().clone().contiguous() for name, value in tensors.items()}
    with atomic_path(path) as temporary:
        save_file(held, temporary, metadata={"instobj": json.dumps(described), "seal": SEAL})
        seal_file(temporary)


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
    except (SafetensorError, OSError) as error:
        raise StoreError(f"{path} is not a safetensors file ({error}). {advice}") from None
    sealed_content(path, advice)
    try:
        return json.loads(metadata["instobj"]), tensors
    except (KeyError, RecursionError, ValueError):
        raise StoreError(f"{path} was not written by instobj. {advice}") from None
