"""Lifecycle node: a board's readings in, contacts and the net wrench out."""

from __future__ import annotations

from collections.abc import Callable
from threading import Event, Thread
from typing import Any

import numpy as np
import rclpy
from geometry_msgs.msg import Point, Vector3, WrenchStamped
from instobj_msgs.msg import Contact, Contacts, Frame, Layout
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.qos import DurabilityPolicy, QoSProfile

from design.errors import InstobjError
from estimator.deploy.live_contacts import LiveContacts
from estimator.inversion.storage import load_inversion
from instobj.commands.contacts import contacts_of
from instobj.commands.readings import live_frames
from instobj.robot import contact_forces, contact_wrench

NS = 1_000_000_000
"""Nanoseconds of a second."""


class HeardContacts(LiveContacts):
    """Reader that hands on the raw counts of every frame, also of those that give the zero."""

    heard: Callable[[np.ndarray, float], None]

    def feed(self, raw_counts: np.ndarray, time_s: float, left_out: Any = None) -> Any:
        """Hand a frame on, and read it."""
        self.heard(raw_counts, time_s)
        return super().feed(raw_counts, time_s, left_out)


class ContactNode(LifecycleNode):
    """Reads `contacts.nc` on a serial port.

    Parameters of the node: `model` (path of contacts.nc), `port`, `baud`, `frame_id`. Topics:
    /instobj/layout (once, kept for late listeners), /instobj/frames, /instobj/contacts and
    /instobj/wrench (about the object's origin).
    """

    def __init__(self) -> None:
        super().__init__("instobj")
        defaults = {"model": "contacts.nc", "port": "", "baud": 115_200, "frame_id": "object"}
        for name, value in defaults.items():
            self.declare_parameter(name, value)
        self._stop, self._thread = Event(), None

    def on_configure(self, state: Any) -> TransitionCallbackReturn:
        """Load the model and open the topics."""
        try:
            self._inversion = load_inversion(self._value("model"))
        except InstobjError as error:  # not there, or damaged
            self.get_logger().error(str(error))
            return TransitionCallbackReturn.FAILURE
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._layout = self.create_lifecycle_publisher(Layout, "/instobj/layout", kept)
        self._frames = self.create_lifecycle_publisher(Frame, "/instobj/frames", 10)
        self._contacts = self.create_lifecycle_publisher(Contacts, "/instobj/contacts", 10)
        self._wrench = self.create_lifecycle_publisher(WrenchStamped, "/instobj/wrench", 10)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: Any) -> TransitionCallbackReturn:
        """Start to read; nothing may touch the object until the first contacts come."""
        super().on_activate(state)
        self._stop.clear()
        self._thread = Thread(target=self._read, daemon=True)
        self._thread.start()
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: Any) -> TransitionCallbackReturn:
        """Stop to read."""
        self._end()
        return super().on_deactivate(state)

    def on_cleanup(self, state: Any) -> TransitionCallbackReturn:
        """Close the topics, so that the node can be configured with another model."""
        for publisher in (self._layout, self._frames, self._contacts, self._wrench):
            self.destroy_lifecycle_publisher(publisher)
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: Any) -> TransitionCallbackReturn:
        """Stop to read."""
        self._end()
        return TransitionCallbackReturn.SUCCESS

    def _end(self) -> None:
        self._stop.set()
        if self._thread is not None:
            self._thread.join(timeout=5.0)

    def _value(self, name: str) -> Any:
        return self.get_parameter(name).value

    def _read(self) -> None:
        reader = HeardContacts(self._inversion)
        reader.warm_up()
        reader.heard = self._publish_frame
        port, baud = self._value("port"), self._value("baud")
        channels = [
            f"F{face}-{'XYZ'[axis]}{chip + 1}" for face, chip, axis in self._inversion.channels
        ]
        self._layout.publish(Layout(channels=channels, labels=[]))
        try:
            for frame in live_frames(reader, self._inversion.channels, port, baud):
                if self._stop.is_set():
                    return
                self._publish(frame)
        except InstobjError as error:  # unplugged, or another object
            self.get_logger().error(str(error))

    def _stamp(self, header: Any, time_s: float) -> None:
        header.frame_id = self._value("frame_id")
        header.stamp.sec, header.stamp.nanosec = divmod(round(time_s * NS), NS)

    def _publish_frame(self, raw_counts: np.ndarray, time_s: float) -> None:
        """Publish the readings; a recording of them begins with the rest that gives the zero."""
        readings = Frame(labels=[])
        self._stamp(readings.header, time_s)
        counts = [
            float(raw_counts[face - 1, chip, axis]) for face, chip, axis in self._inversion.channels
        ]
        readings.counts, readings.valid = counts, np.isfinite(counts).tolist()
        self._frames.publish(readings)

    def _publish(self, frame: Any) -> None:
        """Publish the contacts and their wrench with the frame's own stamp."""
        document = contacts_of(self._inversion, frame)
        spec = self._inversion.model.spec
        contacts = Contacts(contacts=[])
        self._stamp(contacts.header, frame.time_s)
        contacts.explained, contacts.p_value = document["explained"], document["p_value"]
        contacts.left_out = document["left_out"]
        for point_mm, push_n, contact in contact_forces(spec, document["contacts"]):
            contacts.contacts.append(
                Contact(
                    face=contact["face"],
                    position=Point(**_xyz(1e-3 * point_mm)),
                    force=Vector3(**_xyz(push_n)),
                    position_radius=1e-3 * contact["position_radius_mm"],
                    force_half_width=contact["force_halfwidth_n"],
                )
            )
        self._contacts.publish(contacts)
        force_n, torque_nm = contact_wrench(spec, document["contacts"])
        wrench = WrenchStamped(header=contacts.header)
        wrench.wrench.force, wrench.wrench.torque = (
            Vector3(**_xyz(force_n)),
            Vector3(**_xyz(torque_nm)),
        )
        self._wrench.publish(wrench)


def _xyz(values: np.ndarray) -> dict[str, float]:
    return dict(zip("xyz", values.tolist(), strict=True))


def main() -> None:
    """Run the node until it is stopped."""
    rclpy.init()
    rclpy.spin(ContactNode())
