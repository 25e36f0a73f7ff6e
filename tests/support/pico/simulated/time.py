"""Time of the simulated board: it passes where the program waits, and in transfers on the bus."""

import world

_PERIOD = 1 << 30


def ticks_us():
    return world.now_us() % _PERIOD


def ticks_ms():
    return world.now_us() // 1000 % _PERIOD


def ticks_add(ticks, delta):
    return (ticks + delta) % _PERIOD


def ticks_diff(a, b):
    return (a - b + _PERIOD // 2) % _PERIOD - _PERIOD // 2


def sleep_us(us):
    world.advance(us)


def sleep_ms(ms):
    world.advance(1000 * ms)
