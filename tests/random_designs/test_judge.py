"""The judge of random designs: sound parts pass, and each planted fault is told."""

import json
from types import SimpleNamespace

import pytest

from design.build.parts import parts_of
from design.solids.booleans import convert_to_triangles
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from tests.random_designs import judge
from tests.random_designs.__main__ import read_rows
from tests.random_designs.draw import EDITS, KINDS, drawn, kind_of
from tests.random_designs.judge import violations
from tests.random_designs.summary import summary
from tests.support.pages import ROOT

PAD = {
    "name": "pad",
    "body": {"kind": "pad", "size_mm": [40.0, 30.0, 12.0]},
    "shell": {"thickness_mm": 7.0},
    "magnets": {"positions_mm": [[-8.0, 0.0], [8.0, 0.0]]},
    "sensors": {"positions_mm": [[0.0, 9.0]]},
}


@pytest.fixture(scope="module")
def pad():
    spec = ObjectSpec.model_validate(PAD)
    made = {part.name: part for part in parts_of(spec) if part.name in ("core", "shell")}
    return spec, {name: convert_to_triangles(part.make()) for name, part in made.items()}


def test_a_sound_pad_is_sound(pad):
    assert violations(*pad) == []


@pytest.mark.parametrize(
    ("table", "fault", "told"),
    [
        ("magnets", {"positions_mm": [[-8.0, 0.0], [9.0, 0.0]]}, "magnet 2 and shell share"),
        (
            "magnets",
            {"positions_mm": [[-8.0, 0.0], [8.0, 14.5]]},
            "magnet 2 stands out of the body",
        ),
        (
            "sensors",
            {"positions_mm": [[0.0, -9.0]]},
            "the board of sensor 1 of face 1 and core share",
        ),
        ("shell", {"thickness_mm": 6.0}, "the board of sensor 1 of face 1 and shell share"),
    ],
)
def test_parts_of_another_specification_are_told(pad, table, fault, told):
    """The parts of one pad are judged by the numbers of another."""
    spec = ObjectSpec.model_validate(PAD | {table: PAD[table] | fault})
    assert any(text.startswith(told) for text in violations(spec, pad[1]))


def test_a_block_that_fills_its_pocket_touches_the_shell_and_shares_nothing():
    """Of seed 2014: the magnet cut with the shell gave 1.2 mm³, the shell cut with the magnet none."""
    spec = ObjectSpec.model_validate(
        {
            "name": "dome",
            "body": {"kind": "dome", "size_mm": [49.0, 49.0, 30.6]},
            "magnets": {"shape": "block", "positions_mm": [[-11.46, -11.46]]},
        }
    )
    shell = next(part for part in parts_of(spec) if part.name == "shell")
    assert violations(spec, {"shell": convert_to_triangles(shell.make())}) == []


def test_shells_that_meet_the_core_and_open_parts_are_told(pad):
    spec, parts = pad
    sunk = parts["shell"].copy().apply_translation([0.0, 0.0, -0.5])
    assert any("core and shell share" in text for text in violations(spec, parts | {"shell": sunk}))
    torn = parts["core"].copy()
    torn.update_faces([False, *[True] * (len(torn.faces) - 1)])
    assert "core is open or in pieces" in violations(spec, parts | {"core": torn})


def test_a_seed_is_one_specification_and_kinds_have_their_edits(tmp_path):
    assert drawn(0, tmp_path) == drawn(0, tmp_path)
    assert all(sum(kind in kinds for _, kinds in EDITS) >= 15 for kind in KINDS)


def test_a_summary_counts_by_kind_and_its_shares_have_intervals(tmp_path):
    rows = [
        {"seed": seed, "kind": kind_of(seed), "outcome": outcome, "seconds": seconds, "why": ""}
        for seed, (outcome, seconds) in enumerate(
            [("sound", 12.0), ("violates", 70.0), ("refused by check", 0.0), ("crash", None)] * 4
        )
    ]
    text = summary(rows)
    assert "| box | 2 |" in text
    assert "| capsule | 2 | " in text
    assert "| cylinder | 2 | 0 | 0 | 2 | 0 | 0 |" in text
    assert "| all | 16 |" in text
    assert "violations that nothing told: 4 of 12 (13.8% to 60.9%)" in text
    told = summary([rows[0] | {"outcome": one} for one in ("told by fabrication", "told by check")])
    assert "violations that check did not tell: 1 of 2" in told
    assert "violations, told or not: 2 of 2" in told
    assert "over 60 s: 8 of 12" in text
    table = tmp_path / "rows.jsonl"
    table.write_text("".join(json.dumps(row) + "\n" for row in [*rows, rows[0] | {"why": "again"}]))
    assert read_rows(table)[0]["why"] == "again"
    assert len(read_rows(table)) == 16


@pytest.mark.parametrize(
    ("wrong", "warned", "status", "outcome"),
    [
        ([], ["the seam"], "fail", "sound"),
        (["shared"], ["the seam"], "pass", "told by check"),
        (["shared"], [], "fail", "told by fabrication"),
        (["shared"], [], "pass", "violates"),
    ],
)
def test_what_is_wrong_is_told_by_a_check_or_by_nothing(
    monkeypatch, wrong, warned, status, outcome
):
    body, finding = SimpleNamespace(kind="box", size_mm=(1, 1, 1)), {"check": "c", "part": "p"}
    patched = {
        "parse_spec": SimpleNamespace(body=body),
        "parts_of": [],
        "violations": wrong,
        "seam_in_words": warned,
        "check_fabrication": SimpleNamespace(findings=[SimpleNamespace(status=status, **finding)]),
    }
    for name, answer in patched.items():
        monkeypatch.setattr(judge, name, lambda *given, answer=answer: answer)
    assert judge.outcome_of({"name": "one"})[0] == outcome


@pytest.mark.slow
def test_the_egg_without_a_bore_is_built_and_sound():
    """`check` passed it and `build` refused: its pouring hole leaves through the seam's corner."""
    spec = load_spec(ROOT / "examples" / "egg.toml", ["body.open_faces=[]"])
    assert violations(spec, {p.name: convert_to_triangles(p.make()) for p in parts_of(spec)}) == []
