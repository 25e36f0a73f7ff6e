"""Lines of text over USB."""

import select
import sys


class Link:
    def __init__(self):
        self.poll = select.poll()
        self.poll.register(sys.stdin, select.POLLIN)

    def write(self, text):
        sys.stdout.write(text)

    def asked(self):
        """Return whether a ? came."""
        came = False
        while self.poll.poll(0):
            character = sys.stdin.read(1)
            if not character:  # nobody is there
                break
            came = character == "?" or came
        return came
