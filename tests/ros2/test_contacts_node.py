"""The ROS 2 node with a stand-in for rclpy: what it publishes, as ROS messages that rosbags writes."""

import importlib.util
import sys
import time
from pathlib import Path
from types import MappingProxyType, ModuleType, SimpleNamespace
from xml.etree import ElementTree

import numpy as np
import pytest

from estimator.inversion.storage import save_inversion
from estimator.recordings.boards.lines import encode_frame
from tests.support.mechanics.inverted import expected_counts, inverted
from tests.support.recordings.dummy_board import dummy_board

typesys = pytest.importorskip("rosbags.typesys")
ROS2 = Path(__file__).parents[2] / "ros2"
CHANNELS = tuple(
    f"F{face}-{axis}{chip}" for face in range(1, 6) for chip in (1, 2, 3) for axis in "XYZ"
)


@pytest.fixture(scope="module")
def store():
    """All messages that ROS 2 has, and those of the package."""
    types = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    for path in sorted((ROS2 / "instobj_msgs" / "msg").glob("*.msg")):
        name = f"instobj_msgs/msg/{path.stem}"
        types.register(typesys.get_types_from_msg(path.read_text(), name))
    return types


def ros_message(store, name):
    """A message as rclpy makes it: with a default for every field that is not given."""
    kind = store.types[name]
    empty = {"string": "", "bool": False, "uint8": 0, "float64": 0.0, "int32": 0, "uint32": 0}

    def make(**given):
        values = {}
        for field, (node, detail) in store.fielddefs[name][1]:
            if field in given:
                values[field] = given[field]
            elif node.name == "BASE":
                values[field] = empty[detail[0]]
            else:
                values[field] = ros_message(store, detail)() if node.name == "NAME" else []
        return kind(**values)

    return make


class Publisher:
    def __init__(self):
        self.messages = []

    def publish(self, message):
        self.messages.append(message)


class Node:
    """As much of a lifecycle node as this one uses."""

    parameters = MappingProxyType({})

    def __init__(self, name):
        self.name, self.values, self.topics, self.errors = name, {}, {}, []

    def declare_parameter(self, name, value):
        self.values[name] = self.parameters.get(name, value)

    def get_parameter(self, name):
        return SimpleNamespace(value=self.values[name])

    def create_lifecycle_publisher(self, kind, topic, qos):
        self.topics[topic] = Publisher()
        return self.topics[topic]

    def destroy_lifecycle_publisher(self, publisher):
        self.topics = {name: kept for name, kept in self.topics.items() if kept is not publisher}

    def get_logger(self):
        return SimpleNamespace(error=self.errors.append)

    def on_activate(self, state):
        return "success"

    on_deactivate = on_activate


@pytest.fixture
def contacts_node(store, monkeypatch):
    """The node's module, with ROS in its stead."""
    kept = SimpleNamespace(TRANSIENT_LOCAL="kept")
    modules = {
        "rclpy": {},
        "rclpy.lifecycle": {
            "LifecycleNode": Node,
            "TransitionCallbackReturn": SimpleNamespace(SUCCESS="success", FAILURE="failure"),
        },
        "rclpy.qos": {"DurabilityPolicy": kept, "QoSProfile": lambda **given: given},
        "geometry_msgs.msg": {
            name: ros_message(store, f"geometry_msgs/msg/{name}")
            for name in ("Point", "Vector3", "WrenchStamped")
        },
        "instobj_msgs.msg": {
            name: ros_message(store, f"instobj_msgs/msg/{name}")
            for name in ("Contact", "Contacts", "Frame", "Layout")
        },
    }
    for name, content in modules.items():
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)
    path = ROS2 / "instobj_ros" / "instobj_ros" / "contacts.py"
    spec = importlib.util.spec_from_file_location("instobj_ros_contacts", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def board(counts):
    rng = np.random.default_rng(2)

    def lines(number):
        # rest for 3 s, which gives the zero, and a press of 2 s
        held = counts if number % 500 >= 300 else 0 * counts
        noisy = 300 + held + rng.normal(0, 5, 45)
        return encode_frame(number, 10 * number, [float(round(value)) for value in noisy])

    return lines


def test_a_press_is_published_with_its_place_and_its_force(
    contacts_node, store, monkeypatch, tmp_path
):
    save_inversion(inverted(), tmp_path / "contacts.nc")
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, 0], contact[0, 0] = 2, [3.0, -2.0, 7.0]
    # without noise of their own: held for seconds, it would be a signal that no contact gives
    counts = expected_counts(inverted().model, face, contact)[0]
    with dummy_board(board(counts), channels=CHANNELS) as port:
        given = {"model": str(tmp_path / "contacts.nc"), "port": port}
        monkeypatch.setattr(Node, "parameters", given)
        node = contacts_node.ContactNode()
        assert node.on_configure(None) == "success"
        node.on_activate(None)
        until = time.monotonic() + 30
        pressed = []
        while not pressed and time.monotonic() < until:
            time.sleep(0.2)
            pressed = [m for m in list(node.topics["/instobj/contacts"].messages) if m.contacts]
        node.on_deactivate(None)
    assert node.errors == []
    # a recording of the frames begins with the rest that gives the zero, before the first contacts
    first = node.topics["/instobj/frames"].messages[0].header.stamp
    read_first = node.topics["/instobj/contacts"].messages[0].header.stamp
    assert (first.sec, first.nanosec) < (read_first.sec, read_first.nanosec)
    (layout,) = node.topics["/instobj/layout"].messages
    assert layout.channels == list(CHANNELS)
    read = pressed[-1].contacts[0]
    half_mm = inverted().model.spec.body.size_mm[0] / 2
    place = np.array([read.position.x, read.position.y, read.position.z])
    push = np.array([read.force.x, read.force.y, read.force.z])
    assert read.face == 3
    assert np.abs(place).max() == pytest.approx(1e-3 * half_mm, rel=1e-6)
    assert np.linalg.norm(push) == pytest.approx(contact[0, 0, 2], rel=0.1)
    assert push @ place < 0  # inwards
    wrench = node.topics["/instobj/wrench"].messages[-1]
    readings = node.topics["/instobj/frames"].messages[-1]
    for name in ("counts", "valid", "labels"):  # rclpy takes lists, rosbags arrays
        setattr(
            readings, name, np.array(getattr(readings, name), bool if name == "valid" else float)
        )
    for message in (layout, pressed[-1], readings, wrench):
        name = message.__msgtype__
        again = store.deserialize_cdr(store.serialize_cdr(message, name), name)
        assert str(again.__msgtype__) == name


def test_a_node_that_is_cleaned_up_is_configured_again(contacts_node, monkeypatch, tmp_path):
    save_inversion(inverted(), tmp_path / "contacts.nc")
    monkeypatch.setattr(Node, "parameters", {"model": str(tmp_path / "contacts.nc")})
    node = contacts_node.ContactNode()
    assert node.on_configure(None) == "success"
    first = dict(node.topics)
    assert node.on_cleanup(None) == "success"
    assert node.topics == {}
    assert node.on_configure(None) == "success"
    assert set(node.topics) == set(first)


def test_the_launch_file_starts_the_reader_and_shows_a_urdf(monkeypatch, tmp_path):
    """With stand-ins of launch that keep what they are given."""
    kept = {name: lambda *given, **named: SimpleNamespace(given=given, **named) for name in (
        "LaunchDescription", "DeclareLaunchArgument", "OpaqueFunction", "LifecycleNode", "Node"
    )}  # fmt: skip
    values = {"model": "contacts.nc", "port": "/dev/ttyACM0", "urdf": ""}
    stands = {
        "launch": kept,
        "launch.actions": kept,
        "launch_ros.actions": kept,
        "launch.substitutions": {
            "LaunchConfiguration": lambda name: SimpleNamespace(perform=lambda _: values[name])
        },
    }
    for name, content in stands.items():
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)
    path = ROS2 / "instobj_ros" / "launch" / "contacts.launch.py"
    launch = importlib.util.module_from_spec(
        spec := importlib.util.spec_from_file_location("contacts_launch", path)
    )
    spec.loader.exec_module(launch)
    (*arguments, _) = launch.generate_launch_description().given[0]
    assert {argument.given[0] for argument in arguments} == set(values)
    (reader,) = launch.nodes(None)
    assert reader.parameters == [{"model": "contacts.nc", "port": "/dev/ttyACM0"}]
    assert (reader.package, reader.autostart) == ("instobj_ros", True)
    values["urdf"] = str(tmp_path / "object.urdf")
    # RViz finds meshes of a description by their whole path alone
    mesh = '<mesh filename="meshes/core.stl"/>'
    links = f'<link name="my_cube">{mesh}</link><link name="sensor_1"/>'
    (tmp_path / "object.urdf").write_text(f'<robot name="robot">{links}</robot>')
    reader, publisher = launch.nodes(None)
    described = ElementTree.fromstring(publisher.parameters[0]["robot_description"])
    assert (
        described.find("link/mesh").get("filename") == (tmp_path / "meshes" / "core.stl").as_uri()
    )
    # contacts are in the frame of the body that the description shows
    (given,) = reader.parameters
    assert given == {"model": "contacts.nc", "port": "/dev/ttyACM0", "frame_id": "my_cube"}


def test_the_packages_name_what_they_use():
    texts = {path.stem: path.read_text() for path in (ROS2 / "instobj_msgs" / "msg").glob("*.msg")}
    cmake = (ROS2 / "instobj_msgs" / "CMakeLists.txt").read_text()
    for name, text in texts.items():
        assert f"msg/{name}.msg" in cmake
        for package in ("geometry_msgs", "std_msgs"):
            if f"{package}/" in text:
                assert f"find_package({package} REQUIRED)" in cmake
    depended = (ROS2 / "instobj_ros" / "package.xml").read_text()
    for package in ("rclpy", "instobj_msgs", "geometry_msgs"):
        assert f"depend>{package}</" in depended


@pytest.mark.parametrize("content", [None, b"", b"no model"])
def test_a_model_that_is_none_keeps_the_node_unconfigured(
    contacts_node, monkeypatch, tmp_path, content
):
    if content is not None:
        (tmp_path / "a.nc").write_bytes(content)
    monkeypatch.setattr(Node, "parameters", {"model": str(tmp_path / "a.nc")})
    node = contacts_node.ContactNode()
    assert node.on_configure(None) == "failure"
    assert "a.nc" in node.errors[0]
