"""Where large batches are worked on."""

import pytest
import torch

from design.errors import InputError
from estimator.field import device
from estimator.field.device import SWITCH, card_tensor, compute_device


def test_the_processor_unless_a_card_is_named(monkeypatch):
    monkeypatch.delenv(SWITCH, raising=False)
    assert compute_device() == torch.device("cpu")
    monkeypatch.setenv(SWITCH, "")
    assert compute_device() == torch.device("cpu")
    monkeypatch.setattr(torch.cuda, "is_available", lambda: True)
    monkeypatch.setattr(torch.cuda, "device_count", lambda: 2)
    for name in ("cuda", "cuda:0", "cuda:1"):
        monkeypatch.setenv(SWITCH, name)
        assert compute_device() == torch.device(name)


def test_arrays_go_to_a_card_only_where_one_is_named(monkeypatch):
    for name in ("", "cpu"):
        monkeypatch.setenv(SWITCH, name)
        assert card_tensor() is None
    monkeypatch.setenv(SWITCH, "cuda:1")
    monkeypatch.setattr(torch.cuda, "is_available", lambda: False)
    with pytest.raises(InputError, match="sees no CUDA device here"):
        card_tensor()
    monkeypatch.setattr(device, "compute_device", lambda: torch.device("meta"))
    there = card_tensor()
    assert there.device == torch.device("meta")
    assert there.dtype == torch.float64


@pytest.mark.parametrize(
    ("asked", "cards", "told"),
    [
        ("cuda", 0, "sees no CUDA device here"),
        ("cuda:2", 2, "sees 2 CUDA devices here"),
        ("cuda:1", 1, "sees 1 CUDA device here"),
        ("gpu", 1, '"cpu", "cuda" or "cuda:1" and so on; got "gpu"'),
        ("cuda:x", 1, 'got "cuda:x"'),
        ("cpu:1", 1, 'got "cpu:1"'),
    ],
)
def test_a_card_that_is_not_there(asked, cards, told, monkeypatch):
    monkeypatch.setenv(SWITCH, asked)
    monkeypatch.setattr(torch.cuda, "is_available", lambda: cards > 0)
    monkeypatch.setattr(torch.cuda, "device_count", lambda: cards)
    with pytest.raises(InputError, match=told.replace("(", r"\(")):
        compute_device()
