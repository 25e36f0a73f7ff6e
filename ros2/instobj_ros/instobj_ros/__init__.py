"""Contacts of an instrumented object for ROS 2."""
