"""Contacts of an instrumented object: model:=contacts.nc port:=/dev/ttyACM0 [urdf:=object.urdf]."""

import re
from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import LifecycleNode, Node


def nodes(context):
    """Return the reader, and the object's frames where a URDF is given."""
    values = {
        name: LaunchConfiguration(name).perform(context) for name in ("model", "port", "urdf")
    }
    parameters = {name: values[name] for name in ("model", "port")}
    publishers = []
    if values["urdf"]:
        urdf = Path(values["urdf"]).resolve()
        text = urdf.read_text()
        # the description's frames hang on its first link, and so do contacts
        parameters["frame_id"] = re.search(r'<link\s[^>]*?name="([^"]+)"', text)[1]
        # RViz reads the description without its folder, so meshes get their whole path
        meshes = f'filename="{urdf.parent.as_uri()}/'
        description = {"robot_description": text.replace('filename="', meshes)}
        publishers.append(
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[description],
            )
        )
    reader = LifecycleNode(
        package="instobj_ros",
        executable="contacts",
        name="instobj",
        namespace="",
        parameters=[parameters],
        autostart=True,
    )
    return [reader, *publishers]


def generate_launch_description():
    """Return the launch description."""
    arguments = [
        DeclareLaunchArgument("model", default_value="contacts.nc"),
        DeclareLaunchArgument("port"),
        DeclareLaunchArgument("urdf", default_value=""),
    ]
    return LaunchDescription([*arguments, OpaqueFunction(function=nodes)])
