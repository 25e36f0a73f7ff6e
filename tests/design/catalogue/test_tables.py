"""Catalogues are data: rows by name, and faults of a file are no silent defaults."""

from dataclasses import dataclass

import pytest
from pydantic import ValidationError

from design.catalogue.bus_parts import BOARDS
from design.catalogue.printers import PRINTERS, Printer
from design.catalogue.tables import read_table
from design.errors import InputError


@dataclass(frozen=True)
class Half:
    process: str
    bed_mm: tuple[float, float, float]


def test_rows_become_dataclasses_with_tuples():
    printer = read_table("printers", Printer)["resin"]
    assert printer.bed_mm == (140.0, 80.0, 160.0)
    assert printer.process == "resin"


def test_a_key_that_is_no_field_is_refused():
    with pytest.raises(ValidationError, match="wall_mm"):
        read_table("printers", Half)


def test_another_name_is_refused_with_all_names():
    with pytest.raises(InputError, match=r"printer.name = 'laser' .* fdm-0.4.*sls and give your"):
        PRINTERS.named("laser")


def test_a_row_like_another_has_its_values_and_its_own_name():
    usb, wireless = BOARDS["esp32s3"], BOARDS["esp32s3-espnow"]
    assert wireless.buses == usb.buses
    assert (usb.name, wireless.name) == ("esp32s3", "esp32s3-espnow")
    assert wireless.battery_pin not in (*wireless.outputs, *wireless.load_pins, usb.battery_pin)
    assert usb.logic_v == BOARDS["pico"].logic_v
