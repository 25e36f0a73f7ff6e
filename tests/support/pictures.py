"""Small pictures for pages under test."""

from PIL import Image


def save_dot(path):
    """The smallest PNG."""
    Image.new("RGB", (1, 1)).save(path)
