"""Whole chains show that every stage works; what statistics are worth is tested beside them."""

from tests.support import smaller_statistics

smaller_statistics.install()
