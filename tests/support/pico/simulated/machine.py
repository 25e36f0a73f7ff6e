"""The parts of MicroPython's `machine` that the firmware uses, on the simulated world."""

import world

WDT_RESET, PWRON_RESET = 3, 1
_EIO, _ETIMEDOUT = 5, 110
_lines = {}


def reset_cause():
    return PWRON_RESET


class WDT:
    """Ends the program where it is not fed in time."""

    def __init__(self, timeout):
        self.timeout_us, self.fed_us = 1000 * timeout, world.now_us()

    def feed(self):
        if world.now_us() - self.fed_us > self.timeout_us:
            raise SystemExit(3)
        self.fed_us = world.now_us()


class Pin:
    OUT, IN, OPEN_DRAIN, PULL_UP = 1, 0, 2, 1

    def __init__(self, number, mode=None, pull=None, value=None):
        self.number, self.mode = number, mode
        if value is not None:
            self.value(value)

    def value(self, new=None):
        if new is None and world.load.pins[:1] == (self.number,):
            return world.load.level()
        if new is None:
            held = self.number in _lines and _lines[self.number][1] == "sda" and world.holder[0]
            return int(not (held and held.bus == _lines[self.number][0]))
        if world.load.pins[1:] == (self.number,):
            world.load.clock(new)
        elif self.mode == Pin.OUT:
            world.set_pin(self.number, new)
        elif new and _lines[self.number][1] == "scl":
            world.clocked(_lines[self.number][0])


class ADC:
    """Twelve bits, shown as sixteen; a battery of 3.8 V behind a divider of two equal resistors."""

    ATTN_11DB = 3

    def __init__(self, pin, atten=None):
        self.battery = pin.number == world.scene.BATTERY
        assert (self.battery and atten == ADC.ATTN_11DB) or world.load.pins == (pin.number,)

    def read_uv(self):
        return 1_900_000

    def read_u16(self):
        steps = max(0, min(4095, int(world.load.at(world.now_us() / 1000) / 3300 * 4096)))
        return steps << 4 | steps >> 8


def disable_irq():
    return 0


def enable_irq(state):
    pass


class I2C:
    def __init__(self, number, sda, scl, freq, timeout):
        self.number, self.bit_us, self.timeout_us = number, 1e6 / freq, timeout
        _lines[sda.number], _lines[scl.number] = (number, "sda"), (number, "scl")

    def _begin(self, address, count):
        if world.holder[0] is not None and world.holder[0].bus == self.number:
            world.advance(self.timeout_us)
            raise OSError(_ETIMEDOUT)
        world.advance(int(9 * (1 + count) * self.bit_us) + 1)
        found = [placed for placed in world.chips if placed.answers(self.number, address)]
        parts = list(world.channels) + world.present()
        if not found and (self.number, address) not in parts:
            raise OSError(_EIO)
        return found

    def writeto(self, address, data, stop=True):
        found = self._begin(address, len(data))
        for placed in found:
            placed.chip.write(data)
        if (self.number, address) in world.channels:
            world.channels[self.number, address] = data[0]
        if (self.number, address) in world.expanders:
            world.expanders[self.number, address].write(data)

    def readfrom_into(self, address, buffer):
        found = self._begin(address, len(buffer))
        for k in range(len(buffer)):
            buffer[k] = 0xFF
        for placed in found:
            for k, value in enumerate(placed.chip.read(len(buffer))):
                buffer[k] &= value
            long = len(buffer) > 4
            if long and (
                world.faulty("stuck", placed.number) or world.happens("hang", placed.number)
            ):
                world.hold(placed, -1 if world.faulty("stuck", placed.number) else 5)
                world.advance(self.timeout_us)
                raise OSError(_ETIMEDOUT)
