"""Headless Chromium over its pipe: pages are opened, clicked and pictured, without a library.

Chromium speaks the DevTools protocol on file descriptors 3 and 4 (`--remote-debugging-pipe`), one
JSON message after the other with a zero byte between. Without graphics hardware, as on the machines that
run the tests: pages are put together by the processor, and WebGL is drawn by SwiftShader.
"""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import time

FLAGS = (
    *("--headless=new", "--no-sandbox", "--hide-scrollbars", "--mute-audio", "--no-first-run"),
    *("--disable-gpu", "--enable-unsafe-swiftshader"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    *("--disable-extensions", "--disable-default-apps", "--disable-dev-shm-usage"),
    "--remote-debugging-pipe",
)
_LIMIT_S = 300.0
"""Time after which a page is taken to hang. Commands that a page begins are nice to other programs: beside
three busy ones on two cores, five seconds of work took more than two minutes."""
_DRAWN_IN_SOFTWARE = "GPU stall due to ReadPixels"
"""What Chromium tells of itself where it puts pages together without graphics hardware."""
_KEYS = {
    name: {"windowsVirtualKeyCode": code}
    for name, code in {"Tab": 9, "End": 35, "Home": 36, "ArrowLeft": 37, "ArrowRight": 39}.items()
}


def chromium():
    """Path of the system's browser, or None."""
    return next(
        filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
    )


class Browser:
    """One page of a browser; `events` holds what it reported."""

    def __init__(self, width=1100, height=900, more=()):
        self.profile = tempfile.mkdtemp(prefix="instobj_browser_")
        to_read, self._write = os.pipe()
        self._read, to_write = os.pipe()
        size = f"--window-size={width},{height}"

        def pipes():
            a, b = os.dup(to_read), os.dup(to_write)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [chromium(), *FLAGS, *more, size, f"--user-data-dir={self.profile}", "about:blank"],
            preexec_fn=pipes,
            close_fds=False,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(to_read)
        os.close(to_write)
        self._buffer, self._number, self.events, self._session = b"", 0, [], None
        targets = self.send("Target.getTargets")["targetInfos"]
        page = next(one["targetId"] for one in targets if one["type"] == "page")
        attached = self.send("Target.attachToTarget", targetId=page, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.send(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.process.kill()
        self.process.wait()
        os.close(self._read)
        os.close(self._write)
        shutil.rmtree(self.profile, ignore_errors=True)

    def send(self, method, **params):
        """The answer to a command; events on the way are kept."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": params}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == self._number:
                assert "error" not in answer, answer
                return answer["result"]
            self.events.append(answer)

    def open(self, path, ready):
        """Load a file and wait until an expression is true."""
        self.send("Page.navigate", url=path.as_uri())
        self.wait(ready)

    def wait(self, expression):
        end = time.monotonic() + _LIMIT_S
        while not self.ask(expression):
            assert time.monotonic() < end, f"never true: {expression}\n{self.problems()}"
            time.sleep(0.05)

    def ask(self, expression):
        """The value of an expression in the page."""
        answer = self.send(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def press(self, key):
        """A key in the element that has the focus."""
        for kind in ("keyDown", "keyUp"):
            self.send("Input.dispatchKeyEvent", type=kind, key=key, code=key, **_KEYS[key])

    def picture(self):
        """PNG of what the window shows."""
        return base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"])

    def problems(self):
        """What the page complained about: exceptions, errors and warnings of the console and the log."""
        kinds = ("Runtime.exceptionThrown", "Log.entryAdded", "Runtime.consoleAPICalled")
        found = [one["params"] for one in self.events if one.get("method") in kinds]
        return [one for one in found if _DRAWN_IN_SOFTWARE not in str(one)]

    def requests(self):
        """Addresses that the page asked for, but data within it."""
        sent = [e["params"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]
        return [
            one["request"]["url"] for one in sent if not one["request"]["url"].startswith("data:")
        ]

    def _next(self):
        while b"\0" not in self._buffer:
            data = os.read(self._read, 1 << 20)
            assert data, "the browser ended"
            self._buffer += data
        message, _, self._buffer = self._buffer.partition(b"\0")
        return json.loads(message)
