"""TLE493D-W2B6, Infineon: registers of generation 2, two-byte protocol (register, then data)."""

import plan

RESULTS = 18  # bytes: Bx, By, Bz, temperature, low bits, diagnosis, settings up to MOD1
CONFIG, MOD1 = 0x10, 0x11
TYPES = (0x35, 0x22, 0x78, 0x44)
NO_INTERRUPT, SHORT_RANGE = 0x04, 0x08
FUSES_RIGHT, TEST_MODE, CONVERTED = 0x40, 0x10, 0x0C


def move(bus, old, new):
    return old == new


def _mod1(address):
    """Low-power mode, 770 conversions per second; no interrupts on the clock line, which stretches the
    clock while a conversion runs. The highest bit makes the number of ones odd, those of the update rate
    in MOD2 included, which are 0."""
    kind = TYPES.index(address)
    return kind << 5 | NO_INTERRUPT | (0 if kind in (0, 3) else 0x80)


def setup(bus, address):
    """Range, and free running."""
    # the lowest bit is the parity of registers 7 to 16; those before hold 33 ones after reset
    config = SHORT_RANGE | 1 if plan.TLE_SHORT else 0
    back = bytearray(2)
    return (
        bus.transfer(address, bytes((MOD1, _mod1(address))))
        and bus.transfer(address, bytes((CONFIG, config)))
        and bus.transfer(address, bytes((CONFIG,)), back)
        and back == bytes((config, _mod1(address)))
    )


def _twelve(high, low):
    value = high << 4 | low
    return value - 4096 if value > 2047 else value


def read(bus, address, buffer):
    """Temperature, X, Y, Z in counts; None where the chip is silent or lost its settings."""
    if not bus.transfer(address, b"\x00", buffer) or buffer[MOD1] != _mod1(address):
        return None
    if buffer[6] & (FUSES_RIGHT | TEST_MODE | CONVERTED) != FUSES_RIGHT | CONVERTED:
        return None
    return (
        _twelve(buffer[3], buffer[5] >> 6 << 2),
        _twelve(buffer[0], buffer[4] >> 4),
        _twelve(buffer[1], buffer[4] & 15),
        _twelve(buffer[2], buffer[5] & 15),
    )


def undervoltage(bus, address):
    return False  # the chip resets itself, which `read` sees


def celsius(temperature):
    return 25 + (temperature - 1180) * 0.24
