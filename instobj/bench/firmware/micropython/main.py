"""Frames of all sensors at a fixed rate, a status line a second, the channels on ? (see README.md)."""

import gc
import time

import machine
import micropython
import plan
from bus import Bus
from chip import celsius
from imu import Imu
from link import Link
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


def send(link, cells):
    body = ",".join(cells)
    data = body.encode()
    link.write(f"${body}*{crc16(data, len(data)):04X}\n")


def send_header(link):
    send(link, ("H", "1", plan.CHANNELS))


def send_loads(link, load):
    """Lines of all readings of the load cell since the last ones."""
    load.poll()
    for ms, value in load.take():
        send(link, ("L", str(ms), "1", newtons(value)))


def battery_mv():
    """Return the battery's voltage behind a divider of two equal resistors, empty where there is none."""
    if plan.BATTERY is None:
        return ""
    adc = machine.ADC(machine.Pin(plan.BATTERY), atten=machine.ADC.ATTN_11DB)
    return str(2 * adc.read_uv() // 1000)


def frame_cells(sensors, imu, load, sequence, values):
    """Cells of a frame; all sensors are read before, into `values`."""
    cells = ["F", str(sequence), str(time.ticks_ms())]
    for number in range(len(values)):
        values[number] = sensors.read(number)
        load.poll()
    motion = imu.cells()
    for value in values:
        for axis in plan.AXES:
            cells.append("" if value is None else str(value[axis]))
    return cells + motion


def status_cells(sensors, cause, values):
    cells = ["S", str(time.ticks_ms()), battery_mv()]
    for count in (sensors.supply_errors, Bus.errors, Bus.recoveries):
        cells.append(str(count))
    cells.append(cause)
    for value in values:
        cells.append("" if value is None else "%.1f" % celsius(value[0]))
    return cells


def wait_until(due_us, link, load):
    while time.ticks_diff(due_us, time.ticks_us()) > 0:
        if link.asked():
            send_header(link)
        send_loads(link, load)
        time.sleep_us(min(1000, max(0, time.ticks_diff(due_us, time.ticks_us()))))


def run():
    cause = "watchdog" if machine.reset_cause() == machine.WDT_RESET else "power"
    link = Link()
    watchdog = machine.WDT(timeout=WATCHDOG_MS)
    sensors, load = Sensors(), load_cell()
    imu = Imu(sensors.buses[0])
    values = [None] * len(plan.PLACES)
    send_header(link)
    due_us, status_ms, sequence, statuses = time.ticks_us(), time.ticks_ms(), 0, 0
    while True:
        watchdog.feed()
        wait_until(due_us, link, load)
        cells = frame_cells(sensors, imu, load, sequence, values)
        send_loads(link, load)
        send(link, cells)
        sequence = (sequence + 1) % 65536
        due_us = time.ticks_add(due_us, plan.FRAME_US)
        if time.ticks_diff(time.ticks_ms(), status_ms) >= STATUS_MS:
            status_ms = time.ticks_add(status_ms, STATUS_MS)
            send(link, status_cells(sensors, cause, values))
            sensors.watch()
            imu.watch()
            statuses += 1
            if statuses % STATUS_A_HEADER == 0:
                send_header(link)
        gc.collect()


run()
