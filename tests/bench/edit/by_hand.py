#!/usr/bin/python3
"""How soon the editor answers a hand, by the clock: an X server, a pointer that XTest moves, and what the editor says of itself.

  tests/bench/edit/by_hand.py EDITOR SCENE click    30 clicks while a picture refines: from press to screen
  tests/bench/edit/by_hand.py EDITOR SCENE drag     a lamp in view, dragged for 9 s, a move every 0.1 s: from move to picture

EDITOR is build/release/tools/lanthorn/lanthorn. Needs Xvfb, libXtst (which xdotool brings) and two idle cores; the window has 960x540.
"""
import ctypes
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time

ACROSS, DOWN = 960, 540


class Hand:
    """The pointer of a display."""

    def __init__(self, display):
        self.x = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))

    def move(self, x, y):
        self.test.XTestFakeMotionEvent(self.display, -1, int(x), int(y), 0)
        self.x.XFlush(self.display)

    def button(self, down):
        self.test.XTestFakeButtonEvent(self.display, 1, int(down), 0)
        self.x.XFlush(self.display)


class Editor:
    """The program, and the lines of its --report."""

    def __init__(self, program, scene, display, folder):
        self.report = os.path.join(folder, "report")
        homes = {name: folder for name in ("XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME")}
        self.process = subprocess.Popen([program, "edit", scene, "--size", f"{ACROSS}x{DOWN}", "--report", self.report],
                                        env={**os.environ, **homes, "DISPLAY": display})

    def lines(self):
        if not os.path.exists(self.report):
            return []
        with open(self.report, encoding="utf-8") as report:
            return [json.loads(line) for line in report if line.endswith("}\n")]

    def state(self):
        return next((line for line in reversed(self.lines()) if "quality" in line), None)

    def wait(self, holds, seconds):
        latest = time.monotonic() + seconds
        while time.monotonic() < latest:
            state = self.state()
            if state and holds(state):
                return state
            time.sleep(0.2)
        sys.exit("by_hand.py: the editor did not come so far")


def say(name, values):
    values = sorted(values)
    print(f"{name}: {len(values)}, median {statistics.median(values):.0f} ms, 95th percentile {values[int(0.95 * len(values))]:.0f} ms")


def click(editor, hand):
    state = editor.wait(lambda s: s["refinement"].startswith("refining"), 60)
    known = len(editor.lines())
    chance = random.Random(1)
    left, top, width, height = state["box"][:4]
    pressed = []
    for _ in range(30):
        hand.move(left + width * chance.uniform(0.2, 0.8), top + height * chance.uniform(0.3, 0.8))
        time.sleep(0.15)
        pressed.append(time.monotonic())
        hand.button(True)
        hand.button(False)
        time.sleep(chance.uniform(0.6, 0.9))
    answers = [line["seconds"] for line in editor.lines()[known:] if "answer_ms" in line]
    waits = [next((1e3 * (a - press) for a in answers if a > press), None) for press in pressed]
    say("from press to screen", [wait for wait in waits if wait is not None])


def drag(editor, hand):
    state = editor.state()
    left, top, width, height = state["box"][:4]
    lamps = {name: at for name, at in state["lights"].items()
             if left < at[0] < left + width and top + 80 < at[1] < top + height and name != "moon"}
    if not lamps:
        sys.exit("by_hand.py: no lamp in view, expected one")
    name = "lantern-light" if "lantern-light" in lamps else next(iter(lamps))
    hand.move(*lamps[name])
    hand.button(True)
    hand.button(False)
    editor.wait(lambda s: s["chosen"], 20)
    time.sleep(2.5)  # the panels have come, and the picture rests
    x, y = editor.state()["lights"][name]
    x, y = x - 2, y - 55  # the arrow that points up
    hand.move(x, y)
    hand.button(True)
    known = 0
    for i in range(90):
        if i == 30:  # the size has been chosen
            known = len(editor.lines())
        hand.move(x, y - 6 - (30 - abs(30 - 2 * i % 60)))
        time.sleep(0.1)
    lines = editor.lines()[known:]
    hand.button(False)
    say(f"{name}, from move to picture", [line["follow_ms"] for line in lines if "follow_ms" in line])
    dragged = [line for line in lines if line.get("quality") == "drag"]
    print("pictures of", " and ".join(sorted({"x".join(map(str, line["picture"])) for line in dragged})))


def main():
    if len(sys.argv) != 4 or sys.argv[3] not in ("click", "drag"):
        sys.exit(__doc__)
    _, program, scene, what = sys.argv
    display = f":{random.randint(200, 900)}"
    server = subprocess.Popen(["Xvfb", display, "-screen", "0", "1280x1024x24", "-noreset"], stderr=subprocess.DEVNULL)
    time.sleep(1)
    with tempfile.TemporaryDirectory() as folder:
        editor = Editor(program, scene, display, folder)
        try:
            editor.wait(lambda s: s["quality"] == "still" and s["frames"] > 0, 240)
            {"click": click, "drag": drag}[what](editor, Hand(display))
        finally:
            editor.process.terminate()
            editor.process.wait(20)
            server.terminate()


main()
