"""Drives a headless Chromium over its debugging pipe: no port, no package."""

import base64
import fcntl
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time

FLAGS = ["--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--hide-scrollbars",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--use-gl=angle",
         "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--remote-debugging-pipe",
         "--force-device-scale-factor=1", "--enable-precise-memory-info"]
PATIENCE = 240  # that the page is waited for [s]: guards against hangs alone, and decides nothing else


def chromium():
    """The browser's program, or None."""
    return os.environ.get("CHROMIUM") or shutil.which("chromium")


class PageError(Exception):
    """What the page answered instead of a value."""


class Browser:
    """One page of one browser; its console's errors are kept in `errors`, all that it was told in `messages`."""

    def __init__(self, width=1400, height=900):
        self.profile = tempfile.mkdtemp(prefix="thenar-live-")
        # Both browser ends must be numbered above 4, which the shell overwrites.
        (to_browser, write), (read, from_browser) = os.pipe(), os.pipe()
        low = (to_browser, from_browser)
        to_browser, from_browser = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in low]
        os.close(low[0]), os.close(low[1])

        # A shell lays the pipes where the browser wants them: commands on descriptor 3, answers on 4.
        line = f'exec "$@" 3<&{to_browser} 4>&{from_browser}'
        self.process = subprocess.Popen(
            ["/bin/bash", "-c", line, "bash", chromium(), *FLAGS, f"--user-data-dir={self.profile}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, pass_fds=(to_browser, from_browser))
        os.close(to_browser), os.close(from_browser)
        self.write, self.read = write, read
        self.rest, self.next, self.session = b"", 1, None
        self.errors, self.messages, self.requests = [], [], []
        targets = self.send("Target.getTargets")["targetInfos"]
        page = next(t for t in targets if t["type"] == "page")
        self.session = self.send("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.send(f"{domain}.enable")
        self.resize(width, height)

    # Protocol ------------------------------------------------------------------------------------

    def send(self, method, **params):
        number, self.next = self.next, self.next + 1
        message = {"id": number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.write, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + PATIENCE
        while True:
            answer = self._message(end)
            if answer.get("id") == number:
                if "error" in answer:
                    raise PageError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self._event(answer)

    def _message(self, end):
        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.read], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise PageError("the browser does not answer")
            part = os.read(self.read, 1 << 20)
            if not part:
                raise PageError("the browser has ended")
            self.rest += part
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def _event(self, message):
        method, params = message.get("method"), message.get("params", {})
        if method in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"):
            self.messages.append(json.dumps(params)[:400])
        if method == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description") or details["text"])
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "assert"):
            self.errors.append(" ".join(str(a.get("value", a.get("description"))) for a in params["args"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] == "error":
            self.errors.append(f"{params['entry']['text']} {params['entry'].get('url', '')}")
        elif method == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"])

    # The page ------------------------------------------------------------------------------------

    def open(self, address):
        self.send("Page.navigate", url=address)

    def value(self, expression):
        """The value of an expression of JavaScript; promises are waited for."""
        answer = self.send("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise PageError(f"{expression}: {details.get('exception', {}).get('description', details['text'])}")
        return answer["result"].get("value")

    def wait(self, expression, what=None, patience=PATIENCE):
        """Waits until an expression, or what it promises, is true."""
        end = time.monotonic() + patience
        while True:
            try:
                found = self.value(f"Promise.resolve({expression}).then(Boolean)")
                problem = ""
            except PageError as error:  # while the page loads there is nothing to ask
                found, problem = None, f" ({error})"
            if found:
                return found
            if time.monotonic() > end:
                raise PageError(f"waited in vain for {what or expression}{problem}; console: {self.errors}; notes: "
                                f"{self.value('[...document.querySelectorAll(`.note-box p`)].map(n => n.textContent)')}")
            time.sleep(0.05)

    def click(self, selector):
        self.value(f"(() => {{ const n = document.querySelector({json.dumps(selector)}); "
                   f"if (!n) throw new Error('no ' + {json.dumps(selector)}); n.click(); }})()")

    def press(self, key, modifiers=0):
        """A key as from the keyboard; modifiers: 1 Alt, 2 Ctrl, 4 Meta, 8 Shift."""
        codes = {"Tab": 9, "Enter": 13, "Escape": 27, "PageUp": 33, "PageDown": 34, "End": 35, "Home": 36,
                 "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, " ": 32}
        event = {"key": key, "modifiers": modifiers, "windowsVirtualKeyCode": codes.get(key, ord(key[0].upper()))}
        text = {"text": "\r" if key == "Enter" else key} if (len(key) == 1 or key == "Enter") and modifiers in (0, 8) else {}
        self.send("Input.dispatchKeyEvent", type="keyDown", **event, **text)
        self.send("Input.dispatchKeyEvent", type="keyUp", **event)

    def mouse(self, kind, x, y, buttons=0):
        self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, buttons=buttons, clickCount=1,
                  button="left" if buttons or kind == "mouseReleased" else "none")

    def resize(self, width, height, dark=False):
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.send("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def screenshot(self, file):
        data = base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"])
        pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
        pathlib.Path(file).write_bytes(data)
        return data

    def close(self):
        try:
            self.session = None
            self.send("Browser.close")
        except PageError:
            pass
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.write), os.close(self.read)
        shutil.rmtree(self.profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
