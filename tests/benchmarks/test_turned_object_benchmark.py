"""The benchmark of a turned object runs, and its figures hang together."""

import pytest


@pytest.mark.slow
def test_quick_run_reads_every_number_of_contacts_in_both_states(quick_run):
    result, printed = quick_run("turned_object", 1, ["turned_object.json"])
    rows = {(row["contacts"], row["state"], row["reader"]): row for row in result["rows"]}
    assert len(rows) == 28
    assert all(0 <= row["number_right"] <= 1 for row in rows.values())
    assert rows[0, "turned", "grasp"]["contacts_read"] == 0
    for reader in ("design", "twin 1", "exact 1"):
        assert rows[0, "turned", reader]["contacts_read"] <= 0.1
    assert rows[0, "turned", "grasp"]["number_right"] > rows[0, "turned", "bench"]["number_right"]
    assert printed.startswith("small_cube, still, bench: number right 100 /")
