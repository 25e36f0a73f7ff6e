"""MLX90393, Melexis 3901090393: commands and registers of chapters 13 to 15."""

import struct
import time

import plan

RESULTS = 9  # bytes: status, temperature, X, Y, Z
ERROR = 0x10
HALL_CONFIGURATION, FILTER, OVERSAMPLING = 0x0C, 4, 2


def move(bus, old, new):
    return old == new


def _command(bus, address, *code):
    status = bytearray(1)
    return bus.transfer(address, bytes(code), status) and not status[0] & ERROR


def _set(bus, address, register, value):
    return _command(bus, address, 0x60, value >> 8, value & 0xFF, register << 2)


def setup(bus, address):
    """Gain, resolution, filter, and burst mode of temperature, X, Y and Z."""
    status = bytearray(1)
    if not bus.transfer(address, b"\x80", status):  # exit
        return False
    time.sleep_ms(1)
    bus.transfer(address, b"\xf0", status)  # reset
    time.sleep_ms(2)
    resolution = plan.MLX_RESOLUTION << 9 | plan.MLX_RESOLUTION << 7 | plan.MLX_RESOLUTION << 5
    return (
        _set(bus, address, 0, plan.MLX_GAIN << 4 | HALL_CONFIGURATION)
        and _set(bus, address, 1, 0)
        and _set(bus, address, 2, resolution | FILTER << 2 | OVERSAMPLING)
        and _command(bus, address, 0x1F)
    )


def read(bus, address, buffer):
    """Temperature, X, Y, Z in counts; None where the chip is silent or has no new result."""
    if not bus.transfer(address, b"\x4f", buffer) or buffer[0] & ERROR:
        return None
    t, x, y, z = struct.unpack_from(">Hhhh", buffer, 1)
    wide = z * 413 // 256  # Z has steps 1.613 times as wide as X and Y
    return t, x, y, max(-32768, min(32767, wide))


def undervoltage(bus, address):
    return False  # the chip does not say


def celsius(temperature):
    return 35 + (temperature - 46244) / 45.2
