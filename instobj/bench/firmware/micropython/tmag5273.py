"""TMAG5273, Texas Instruments SLYS045: registers of section 6.6."""

import struct

import plan

RESULTS = 9  # bytes: temperature, X, Y, Z and CONV_STATUS
POWER_ON_RESET = 0x10
VCC_UV = 0x01


def move(bus, old, new):
    """Give the chip another address until its power is lost."""
    return bus.transfer(old, bytes((0x0C, new << 1 | 1)))


def setup(bus, address):
    """Range, averaging, temperature, and free running."""
    maker = bytearray(2)
    if not bus.transfer(address, b"\x0e", maker) or maker != b"IT":
        return False
    settings = (
        (0x00, plan.TMAG_AVERAGING << 2),
        (0x02, 0x70),  # X, Y, Z
        (0x03, 0x03 if plan.TMAG_WIDE else 0x00),
        (0x07, 0x01),  # temperature
        (0x18, POWER_ON_RESET),  # ones clear
        (0x1C, 0x0F),
        (0x01, 0x02),  # continuous
    )
    return all(bus.transfer(address, bytes(setting)) for setting in settings)


def read(bus, address, buffer):
    """Temperature, X, Y, Z in counts; None where the chip is silent or lost its settings."""
    if not bus.transfer(address, b"\x10", buffer) or buffer[8] & POWER_ON_RESET:
        return None
    return struct.unpack_from(">hhhh", buffer)


def undervoltage(bus, address):
    """Return whether the chip saw too low a supply since the last call."""
    status = bytearray(1)
    if not bus.transfer(address, b"\x1c", status) or not status[0] & VCC_UV:
        return False
    bus.transfer(address, bytes((0x1C, VCC_UV)))
    return True


def celsius(temperature):
    return 25 + (temperature - 17508) / 60.1
