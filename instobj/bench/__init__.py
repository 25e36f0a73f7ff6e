"""Boards, machines and built objects: what serves them, behind the extra `instobj[bench]`."""
