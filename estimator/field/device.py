"""Device for tensors of large batches: the processor, or a graphics card."""

from __future__ import annotations

import os

import torch

from design.errors import InputError

SWITCH = "INSTOBJ_DEVICE"


def compute_device() -> torch.device:
    """The processor, or what `INSTOBJ_DEVICE` names: "cuda", or "cuda:1" for the second card.

    Layouts of a search and the training of networks are worked on there; batches of fields where
    their tensors are.

    Raises
    ------
    InputError
        No such device, or torch sees none here.
    """
    asked = os.environ.get(SWITCH) or "cpu"
    kind, _, number = asked.partition(":")
    if (
        kind not in ("cpu", "cuda")
        or (number and not number.isdecimal())
        or (kind == "cpu" and number)
    ):
        raise InputError(f'{SWITCH} must be "cpu", "cuda" or "cuda:1" and so on; got "{asked}"')
    if kind == "cuda":
        found = torch.cuda.device_count() if torch.cuda.is_available() else 0
        if int(number or 0) >= found:
            raise InputError(
                f"{SWITCH} = {asked}, but torch {torch.__version__} sees "
                f"{found or 'no'} CUDA device{'s' * (found > 1)} here. Leave it out, or install "
                "torch for CUDA (README.md)"
            )
    return torch.device(asked)
