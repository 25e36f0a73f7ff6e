"""Frames of all sensors at a fixed rate, a status line a second, the channels on ? (see README.md)."""

import gc
import select
import sys
import time

import machine
import micropython
import plan
from bus import Bus
from chip import celsius
from load_cell import load_cell, newtons
from sensors import Sensors

STATUS_MS = 1000
STATUS_A_HEADER = 8
WATCHDOG_MS = 2000


@micropython.viper
def crc16(data: ptr8, count: int) -> int:
    """CRC-16/CCITT-FALSE, a byte at a time without a table."""
    crc = 0xFFFF
    for k in range(count):
        x = (crc >> 8) ^ data[k]
        x ^= x >> 4
        crc = ((crc << 8) ^ (x << 12) ^ (x << 5) ^ x) & 0xFFFF
    return crc


def send(cells):
    body = ",".join(cells)
    data = body.encode()
    sys.stdout.write(f"${body}*{crc16(data, len(data)):04X}\n")


def send_header():
    send(("H", "1", plan.CHANNELS))


def send_loads(load):
    """Lines of all readings of the load cell since the last ones."""
    load.poll()
    for ms, value in load.take():
        send(("L", str(ms), "1", newtons(value)))


def frame_cells(sensors, load, sequence, values):
    """Cells of a frame; all sensors are read before, into `values`."""
    cells = ["F", str(sequence), str(time.ticks_ms())]
    for number in range(len(values)):
        values[number] = sensors.read(number)
        load.poll()
    for value in values:
        for axis in plan.AXES:
            cells.append("" if value is None else str(value[axis]))
    return cells


def status_cells(sensors, cause, values):
    cells = ["S", str(time.ticks_ms()), ""]
    for count in (sensors.supply_errors, Bus.errors, Bus.recoveries):
        cells.append(str(count))
    cells.append(cause)
    for value in values:
        cells.append("" if value is None else "%.1f" % celsius(value[0]))
    return cells


def asked(poll):
    """Return whether a ? came."""
    came = False
    while poll.poll(0):
        character = sys.stdin.read(1)
        if not character:  # nobody is there
            break
        came = character == "?" or came
    return came


def wait_until(due_us, poll, load):
    while time.ticks_diff(due_us, time.ticks_us()) > 0:
        if asked(poll):
            send_header()
        send_loads(load)
        time.sleep_us(min(1000, max(0, time.ticks_diff(due_us, time.ticks_us()))))


def run():
    cause = "watchdog" if machine.reset_cause() == machine.WDT_RESET else "power"
    poll = select.poll()
    poll.register(sys.stdin, select.POLLIN)
    watchdog = machine.WDT(timeout=WATCHDOG_MS)
    sensors, load = Sensors(), load_cell()
    values = [None] * len(plan.PLACES)
    send_header()
    due_us, status_ms, sequence, statuses = time.ticks_us(), time.ticks_ms(), 0, 0
    while True:
        watchdog.feed()
        wait_until(due_us, poll, load)
        cells = frame_cells(sensors, load, sequence, values)
        send_loads(load)
        send(cells)
        sequence = (sequence + 1) % 65536
        due_us = time.ticks_add(due_us, plan.FRAME_US)
        if time.ticks_diff(time.ticks_ms(), status_ms) >= STATUS_MS:
            status_ms = time.ticks_add(status_ms, STATUS_MS)
            send(status_cells(sensors, cause, values))
            sensors.watch()
            statuses += 1
            if statuses % STATUS_A_HEADER == 0:
                send_header()
        gc.collect()


run()
