"""The second board, on USB: hands on the lines of one object; copy it there as main.py."""

import time

import radio
import usb

GREETING_MS, SILENT_MS = 1000, 3000


def run():
    host, air = usb.Link(), radio.Link().radio
    followed, heard_ms, greeted_ms = None, time.ticks_ms(), time.ticks_ms()
    while True:
        mac, packet = air.recv(20)
        now = time.ticks_ms()
        if followed is not None and time.ticks_diff(now, heard_ms) > SILENT_MS:
            air.del_peer(followed)
            followed = None
        if mac is not None and followed is None:
            followed, greeted_ms = bytes(mac), time.ticks_add(now, -GREETING_MS)
            air.add_peer(followed)
        if mac is not None and followed == mac:
            heard_ms = now
            host.write(packet.decode())
        question = host.asked()
        if followed is not None and (question or time.ticks_diff(now, greeted_ms) >= GREETING_MS):
            greeted_ms = now
            air.send(followed, b"?" if question else b"!", False)


run()
