"""The IMU beside the sensors: acceleration (m/s²) and angular rate (rad/s); registers stand in plan.py."""

import struct

import plan

CELLS = 6


class Imu:
    """Set up where it answers; its cells are empty until then."""

    def __init__(self, bus):
        self.bus, self.buffer = bus, bytearray(2 * CELLS)
        self.alive = False
        self.watch()

    def watch(self):
        """Set it up where it does not answer; call once a second."""
        if plan.IMU is not None and not self.alive:
            self.alive = self.setup()

    def setup(self):
        who = bytearray(1)
        if not self.bus.transfer(plan.IMU, bytes((plan.IMU_WHO[0],)), who):
            return False
        return who[0] == plan.IMU_WHO[1] and all(
            self.bus.transfer(plan.IMU, bytes(setting)) for setting in plan.IMU_SETUP
        )

    def cells(self):
        """Texts of the last reading, acceleration first; empty where it is silent or lost its settings."""
        if plan.IMU is None:
            return []
        self.alive = self.alive and self.bus.transfer(
            plan.IMU, bytes((plan.IMU_DATA,)), self.buffer
        )
        counts = struct.unpack(plan.IMU_ORDER, self.buffer)
        # a part without its settings gives one number six times, gravity never does
        if not self.alive or min(counts) == max(counts):
            self.alive = False
            return [""] * CELLS
        rate, acceleration = counts[:3], counts[3:]
        if not plan.IMU_RATE_FIRST:
            rate, acceleration = acceleration, rate
        m_s2, rad_s = plan.IMU_STEPS
        return ["%.3f" % (m_s2 * c) for c in acceleration] + ["%.4f" % (rad_s * c) for c in rate]
