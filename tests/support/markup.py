"""Pages of HTML as text; tags that are not closed are told."""

from html.parser import HTMLParser

VOID = {"meta", "img", "link", "br", "input"}


class Balanced(HTMLParser):
    """Tags that are open, and text."""

    def __init__(self):
        super().__init__()
        self.open, self.words = [], []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1:] not in (["style"], ["script"]):
            self.words += data.split()


def read(page):
    """The words of a page, whose tags are all closed."""
    parser = Balanced()
    parser.feed(page)
    assert parser.open == []
    return " ".join(parser.words)
