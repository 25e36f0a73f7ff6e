"""Hall sensors on the simulated board's buses, as their data sheets describe them.

`scene.py` beside it says what there is: CHIPS (family, bus, factory address, multiplexer, channel,
supply pin, field in mT, °C), MULTIPLEXERS (bus, address), RESET, FAULTS (kind, chip, from, until in ms),
END_MS; LOAD_PINS, LOAD (ms, value) and SPS of a load cell. Kinds of faults as in tests/support/avr/rig.c.
"""

import scene
from hx711 import LoadCell

_clock = [0]


def now_us():
    return _clock[0]


def advance(us):
    _clock[0] += us
    if _clock[0] > 1000 * scene.END_MS:
        raise SystemExit


def saturated(counts):
    return max(-32768, min(32767, round(counts)))


def put(memory, at, value):
    memory[at], memory[at + 1] = value >> 8 & 0xFF, value & 0xFF


def faulty(kind, number):
    now = now_us() / 1000
    return any(k == kind and n == number and a <= now < b for k, n, a, b in scene.FAULTS)


_happened = set()


def happens(kind, number):
    """Whether a fault that happens once is due; not again afterwards."""
    if (kind, number) in _happened or not faulty(kind, number):
        return False
    _happened.add((kind, number))
    return True


class Tmag:
    start_us = 270

    def __init__(self, factory, field, celsius):
        self.factory, self.field, self.celsius = factory, field, celsius
        self.reset()

    def reset(self):
        self.address, self.pointer, self.ready_us = self.factory, 0, None
        self.memory = bytearray(32)
        self.memory[0x0E:0x10] = b"IT"
        self.memory[0x18] = 0x10

    def write(self, data):
        self.pointer = data[0]
        for offset, value in enumerate(data[1:]):
            self._set(data[0] + offset, value)

    def _set(self, register, value):
        if register == 0x0C:
            self.address = value >> 1 if value & 1 else self.address
        elif register in (0x18, 0x1C):
            self.memory[register] &= ~value & 0xFF
        elif register < 0x0C:
            self.memory[register] = value
            axes = sum(self.memory[2] >> k & 1 for k in (4, 5, 6)) + (self.memory[7] & 1)
            if register == 1 and value & 3 == 2:
                self.ready_us = now_us() + 25 + 25 * axes * (1 << (self.memory[0] >> 2 & 7))

    def read(self, count):
        memory = self.memory
        if self.ready_us is not None and now_us() >= self.ready_us:
            for k in range(3):
                range_mt = 80 if memory[3] & (1 if k == 2 else 2) else 40
                value = (
                    saturated(self.field[k] / range_mt * 32768) if memory[2] >> (4 + k) & 1 else 0
                )
                put(memory, 0x12 + 2 * k, value)
            put(memory, 0x10, saturated(17508 + 60.1 * (self.celsius - 25)) if memory[7] & 1 else 0)
            memory[0x18] |= 1
        return memory[self.pointer : self.pointer + count]


class Mlx:
    start_us = 1000

    def __init__(self, factory, field, celsius):
        self.factory, self.field, self.celsius = factory, field, celsius
        self.reset()

    def reset(self):
        self.address, self.ready_us = self.factory, None
        self.registers, self.code = [0] * 64, 0

    def write(self, data):
        self.code = data[0]
        if data[0] == 0xF0:
            self.ready_us = None
        elif data[0] & 0xF0 == 0x10:
            self.ready_us = now_us() + 14_800
        elif data[0] == 0x60:
            self.registers[data[3] >> 2] = data[1] << 8 | data[2]

    def read(self, count):
        answer = bytearray(9)
        if self.code & 0xF0 != 0x40:
            return answer[:count]
        if self.ready_us is None or now_us() < self.ready_us:
            answer[0] = 0x10
            return answer[:count]
        steps_ut = (0.751, 0.601, 0.451, 0.376, 0.300, 0.250, 0.200, 0.150)
        step = steps_ut[self.registers[0] >> 4 & 7] * (1 << (self.registers[2] >> 5 & 3)) / 1e3
        put(answer, 1, round(46244 + 45.2 * (self.celsius - 35)))
        for k in range(3):
            put(answer, 3 + 2 * k, saturated(self.field[k] / step / (1.613 if k == 2 else 1)))
        return answer[:count]


class Tle:
    """TLE493D-W2B6: 770 conversions a second of 0.35 ms, during which it holds the clock."""

    start_us = 200
    addresses = (0x35, 0x22, 0x78, 0x44)

    def __init__(self, factory, field, celsius):
        self.factory, self.field, self.celsius = factory, field, celsius
        self.reset()

    def reset(self):
        self.address, self.pointer, self.ready_us = self.factory, 0, None
        self.memory = bytearray(32)
        self.memory[6:17] = b"\x60\x80\x7f\x80\x7f\x80\x7f\x38\x38\x38\x01"
        kind = self.addresses.index(self.factory)
        self.memory[0x11] = kind << 5 | (0 if kind in (1, 2) else 0x80)
        self.memory[0x16] = 0xC9

    def write(self, data):
        self.pointer = data[0] & 0x1F
        for offset, value in enumerate(data[1:]):
            register = self.pointer + offset
            if 0x07 <= register <= 0x11 or register == 0x13:
                self.memory[register] = value
            if register == 0x11:
                self.address = self.addresses[value >> 5 & 3]
                self.ready_us = now_us() + 1300

    def read(self, count):
        memory, phase = self.memory, now_us() % 1300
        if phase < 350 and memory[0x11] & 0x0C == 0x04:
            advance(350 - phase)
        settings = bytearray(memory[7:17])
        settings[6], settings[7], settings[8] = (
            settings[6] & 127,
            settings[7] & 63,
            settings[8] & 63,
        )
        fuses = (memory[0x11], memory[0x13] & 0xE0)
        ready = self.ready_us is not None and now_us() >= self.ready_us
        memory[6] = ones(fuses) % 2 << 6 | ones(settings) % 2 << 5 | (0x0C if ready else 0)
        if ready:
            scale = 15.4 if memory[0x10] & 8 else 7.7
            x, y, z = (max(-2048, min(2047, round(b * scale))) & 0xFFF for b in self.field)
            t = 4 * round(295 + (self.celsius - 25) / 0.96) & 0xFFF
            memory[0], memory[1], memory[2], memory[3] = x >> 4, y >> 4, z >> 4, t >> 4
            memory[4] = (x & 15) << 4 | y & 15
            memory[5] = (t & 12) << 4 | (memory[0x11] >> 5 & 3) << 4 | z & 15
        return memory[self.pointer : self.pointer + count]


class Imu:
    """LSM6DS3 or ICM-42688: acceleration in g, rates T, -T and 2 T degrees/s; one number while it is off."""

    start_us = 1000

    def __init__(self, factory, field, celsius):
        self.factory, self.field, self.celsius = factory, field, celsius
        self.reset()

    def reset(self):
        self.address, self.pointer, self.memory = self.factory, 0, bytearray(128)
        self.st = self.factory == 0x6A
        self.memory[0x0F if self.st else 0x75] = 0x69 if self.st else 0x47

    def write(self, data):
        self.pointer = data[0]
        for offset, value in enumerate(data[1:]):
            self.memory[data[0] + offset] = value

    def read(self, count):
        memory = self.memory
        if self.st:
            on = memory[0x10] >> 4 and memory[0x11] >> 4
            g, rate = (
                (2, 16, 4, 8)[memory[0x10] >> 2 & 3],
                (250, 500, 1000, 2000)[memory[0x11] >> 2 & 3],
            )
            per_g, per_rate = 1 / (0.000061 * g / 2), 1 / (0.00875 * rate / 250)
        else:
            on = memory[0x4E] & 15 == 15
            per_g, per_rate = 2048 << (memory[0x50] >> 5), 16.4 * (1 << (memory[0x4F] >> 5))
        values = [saturated(per_g * a) for a in self.field]
        values += [saturated(per_rate * self.celsius * k) for k in (1, -1, 2)]
        if not on:
            values = [0 if self.st else -32768] * 6
        for k, value in enumerate(values[3:] + values[:3] if self.st else values):
            if self.st:
                value = (value & 0xFF) << 8 | value >> 8 & 0xFF
            put(memory, (0x22 if self.st else 0x1F) + 2 * k, value)
        return memory[self.pointer : self.pointer + count]


def ones(values):
    return sum(value >> k & 1 for value in values for k in range(8))


class Placed:
    """A chip, where it is, and since when it has power."""

    def __init__(self, number, family, bus, factory, multiplexer, channel, supply, field, celsius):
        self.number, self.bus, self.supply = number, bus, supply
        self.multiplexer, self.channel = multiplexer, channel
        self.chip = {"T": Tmag, "M": Mlx, "E": Tle, "L": Imu, "I": Imu}[family](
            factory, field, celsius
        )
        self.powered_us = 0 if supply is None else None

    def power(self, on):
        if on and self.powered_us is None:
            self.chip.reset()
            self.powered_us = now_us()
        elif not on:
            self.powered_us = None
            if holder[0] is self:
                holder[0] = None

    def answers(self, bus, address):
        powered = self.powered_us is not None and now_us() >= self.powered_us + self.chip.start_us
        if not powered or self.bus != bus or faulty("dead", self.number):
            return False
        if happens("brownout", self.number):
            self.chip.reset()
        if happens("low", self.number):
            self.chip.memory[0x1C] |= 1
        open_now = self.multiplexer is None or channels[bus, self.multiplexer] >> self.channel & 1
        return bool(open_now) and self.chip.address == address


chips = [Placed(number, *what) for number, what in enumerate(scene.CHIPS)]
channels = dict.fromkeys(scene.MULTIPLEXERS, 0)


class Expander:
    """MCP23017: outputs power chips where their direction is out and their latch is set."""

    def __init__(self, bus, address):
        self.bus, self.address = bus, address
        self.reset()

    def reset(self):
        self.directions, self.latches = 0xFFFF, 0
        self.switch()

    def write(self, data):
        both = data[1] | data[2] << 8
        if data[0] == 0x14:
            self.latches = both
        elif data[0] == 0x00:
            self.directions = both
        self.switch()

    def switch(self):
        for placed in chips:
            if placed.bus == self.bus and isinstance(placed.supply, tuple):
                address, bit = placed.supply
                if address == self.address:
                    placed.power((self.latches & ~self.directions) >> bit & 1)


def present():
    """Places of expanders that answer."""
    return [place for place in expanders if not faulty("dead", -place[1])]


holder, clocks_left = [None], [0]
expanders = {place: Expander(*place) for place in scene.EXPANDERS}


def hold(placed, clocks):
    holder[0], clocks_left[0] = placed, clocks


def clocked(bus):
    if holder[0] is not None and holder[0].bus == bus:
        clocks_left[0] -= 1
        if clocks_left[0] == 0:
            holder[0] = None


def set_pin(pin, value):
    for placed in chips:
        if placed.supply == pin:
            placed.power(value)
    if pin == scene.RESET and not value:
        for place in channels:
            channels[place] = 0
        for expander in expanders.values():
            expander.reset()
        if holder[0] is not None and holder[0].multiplexer is not None:
            holder[0] = None


load = LoadCell(scene.LOAD_PINS, scene.LOAD, scene.SPS, lambda: now_us() / 1000, faulty)
