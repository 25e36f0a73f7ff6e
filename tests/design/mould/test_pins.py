"""Pins and bosses that form pockets, by the way in which the halves are pulled."""

from numpy.testing import assert_allclose

from design.layout.mould.pins import loose_pins
from design.mould.pins import fixed_bosses
from design.spec.object import ObjectSpec


def test_pockets_along_the_pull_are_fixed_bosses_but_where_a_locating_pin_forms_them():
    """Pulled along x: face 3's middle holds a locating pin, its second pocket and face 5's are fixed."""
    content = {
        "body": {"open_faces": []},
        "magnets": {"positions_mm": [[0.0, 0.0], [9.0, 0.0]]},
        "mould": {"parting_azimuth_deg": 0.0},
    }
    spec = ObjectSpec.model_validate({"name": "wide", **content})
    middles = [[boss.Center().toTuple() for boss in fixed_bosses(spec, side)] for side in (1, -1)]
    assert [[x > 0 for x, _, _ in some] for some in middles] == [[True], [False, False]]
    beside = [[yz for _, *yz in some] for some in middles]
    assert_allclose(beside[0], [[0.0, -9.0]], atol=1e-9)
    assert_allclose(beside[1], [[0.0, 0.0], [0.0, -9.0]], atol=1e-9)
    pins = loose_pins(spec)
    assert [pin.frame.number for pin in pins if pin.locator is not None] == [2, 3]
    assert [pin.frame.number for pin in pins if pin.locator is None] == [1, 1, 2, 4, 4, 6, 6]
