"""Pages of HTML as text; tags that are not closed are told."""

import re
from html.parser import HTMLParser

VOID = {"meta", "img", "link", "br", "input"}


class Balanced(HTMLParser):
    """Tags that are open, and text."""

    def __init__(self):
        super().__init__()
        self.open, self.words, self.unfolded = [], [], []

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1:] not in (["style"], ["script"]):
            self.words += data.split()
            folds = self.open.count("details") - ("summary" in self.open)
            self.unfolded += data.split() if folds <= 0 else []


def read(page):
    """The words of a page, whose tags are all closed."""
    parser = Balanced()
    parser.feed(page)
    assert parser.open == []
    return " ".join(parser.words)


def read_unfolded(page):
    """The words that a reader sees before opening anything: those outside closed folds, and their titles."""
    parser = Balanced()
    parser.feed(page)
    return " ".join(parser.unfolded)


def assert_short(page):
    """At most 1 200 words and 200 numbers before anything is unfolded."""
    told = read_unfolded(page)
    assert len(told.split()) <= 1200
    assert len(re.findall(r"\d+(?:[.,]\d+)*", told)) <= 200
