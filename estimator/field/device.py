"""Device for tensors of large batches: the processor, on one of its threads, or a graphics card.

torch is imported only where it is asked for: a robot reads contacts without it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from design.errors import InputError
from design.processes import one_blas_thread

if TYPE_CHECKING:
    import torch

SWITCH = "INSTOBJ_DEVICE"


def compute_device() -> torch.device:
    """The processor, or what `INSTOBJ_DEVICE` names: "cuda", or "cuda:1" for the second card.

    Layouts of a search, the training of networks and contacts of many frames are worked on there.

    Raises
    ------
    InputError
        No such device, or torch sees none here.
    """
    import torch

    device_name = os.environ.get(SWITCH) or "cpu"
    kind, _, number = device_name.partition(":")
    if (
        kind not in ("cpu", "cuda")
        or (number and not number.isdecimal())
        or (kind == "cpu" and number)
    ):
        raise InputError(
            f'{SWITCH} must be "cpu", "cuda" or "cuda:1" and so on; got "{device_name}"'
        )
    if kind == "cuda":
        device_count = torch.cuda.device_count() if torch.cuda.is_available() else 0
        if int(number or 0) >= device_count:
            raise InputError(
                f"{SWITCH} = {device_name}, but torch {torch.__version__} sees "
                f"{device_count or 'no'} CUDA device{'s' * (device_count > 1)} here. "
                "Leave it out, or install "
                "torch for CUDA (README.md)"
            )
    return torch.device(device_name)


@contextmanager
def one_thread() -> Iterator[None]:
    """torch and linear algebra on one thread of the processor, whatever the environment says; then on as
    many as before.

    Tensors here are small: a second thread gains nothing, and waits at every sum where cores are shared (a
    walk took ten times as long on two of two busy cores).
    """
    import torch

    threads_before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        with one_blas_thread():
            yield
    finally:
        torch.set_num_threads(threads_before)


def card_tensor() -> torch.Tensor | None:
    """An empty tensor of doubles on the card that is asked for; None where it is the processor.

    Raises
    ------
    InputError
        As `compute_device`.
    """
    if (os.environ.get(SWITCH) or "cpu") == "cpu":
        return None
    import torch

    return torch.empty(0, dtype=torch.float64, device=compute_device())
