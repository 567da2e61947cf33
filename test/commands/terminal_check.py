"""Tests the output on a terminal: text wrapped to its width, one line on success, a progress bar that fits,
and nothing more with --quiet. A line break in a file's name makes no line of output.

Usage: terminal_check.py RAYTRACER, from the source folder.
"""
import fcntl
import json
import os
import pathlib
import pty
import re
import signal
import struct
import subprocess
import sys
import tempfile
import termios

from checks import RAYTRACER, check, conclude

LEAST = json.loads(pathlib.Path("test/good/least.json").read_text(encoding="utf-8"))


def on_terminal(columns, *words, until=None, **environment):
    """What stands on a terminal's stderr of so many columns; ends the program where that contains `until`."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([RAYTRACER, *map(str, words)], stderr=slave, stdout=subprocess.DEVNULL,
                               env=os.environ | {"TERM": "xterm"} | environment)
    os.close(slave)
    text = b""
    while True:
        try:
            block = os.read(master, 65536)
        except OSError:  # Linux says so where no process has the terminal open
            block = b""
        text += block
        if not block:
            break
        if until and re.search(until, text):
            process.send_signal(signal.SIGINT)
    os.close(master)
    process.wait(timeout=60)
    return text.decode().replace("\r\n", "\n")


def check_done(folder):
    out = pathlib.Path(folder, "out.png")
    done_line = re.escape(str(out)) + r": 8 × 8, (under )?0\.\d\d s\n"
    said = on_terminal(100, "test/good/least.json", out, 8, "--only", "ambient")
    check("success", True, bool(re.fullmatch(done_line, said)))
    check("success, quiet", "",
          on_terminal(100, "test/good/least.json", out, 8, "--only", "ambient", "--quiet"))
    for number in (1, 2):
        said = on_terminal(100, "test/good/least.json", out, 8, "--only", "ambient", "--part", f"{number}/2")
        check("a part", True, said.startswith(f"{out}.part-{number}-of-2: 8 × 8, "))
    said = on_terminal(100, "test/good/least.json", out, 8, "--only", "ambient", "--watch", until=rb"C ends")
    check("a watch that waits", True, said.endswith("s\nwaiting for a change; Ctrl+C ends\n"))
    parts = [f"{out}.part-{number}-of-2" for number in (1, 2)]
    said = on_terminal(100, "assemble", *parts, out)
    check("assembled", True, bool(re.fullmatch(done_line, said)))
    check("assembled, quiet", "", on_terminal(100, "assemble", *parts, out, "--quiet"))
    done = subprocess.run([RAYTRACER, "assemble", *parts, out], capture_output=True, check=False)
    check("assembled, no terminal", (0, b"", b""), (done.returncode, done.stdout, done.stderr))
    done = subprocess.run([RAYTRACER, "test/good/least.json", out, "8", "--only", "ambient"],
                          capture_output=True, check=False)
    check("success, no terminal", (0, b"", b""), (done.returncode, done.stdout, done.stderr))


def check_wrapped(folder):
    scene = pathlib.Path(folder, "scene.json")
    scene.write_text(json.dumps(LEAST | {"camera": LEAST["camera"] | {"up": [0, 2, 0]}}), encoding="utf-8")
    words = ("explain", scene, 4, 4, 8)
    expected = f"warning: {scene}:1:12: /camera: look and up distort: lengths 1, 2 at 90°, not 1, 1 at 90°"
    for columns in (40, 80, 100, 200):
        lines = on_terminal(columns, *words).splitlines()
        check(f"{columns} columns", expected, " ".join(line.strip() for line in lines))
        check(f"{columns} columns: width", [],
              [line for line in lines if len(line) > min(columns, 100) and str(scene) not in line])
        check(f"{columns} columns: continued", {"    "}, {line[:4] for line in lines[1:]})
    lines = subprocess.run([RAYTRACER, *map(str, words)], capture_output=True, text=True,
                           check=False).stderr.splitlines()
    check("no terminal", [expected], lines)


def check_bar(folder):
    words = ("scenes/refraction.json", pathlib.Path(folder, "out.png"), 2000, "--samples", 1000, "--threads",
             1)
    for columns, widths in ((40, "18,20"), (100, "40")):
        bars = re.findall(r"\r\033\[K([^\r\033]+)", on_terminal(columns, *words, until=rb"left"))
        wrong = [bar for bar in bars if len(bar) >= columns or not re.fullmatch(
            r"\[[# ]{%s}\] {2,3}\d{1,2} %%  \d+:\d\d left" % widths, bar)]
        check(f"bar in {columns} columns", (True, []), (bool(bars), wrong))


def check_search(folder):
    out = pathlib.Path(folder, "out.png")
    words = ("scenes/texture.json", out, 200, "--target-error", 1e-6, "--threads", 1)
    lines = re.findall(r"\r\033\[K([^\r\033]+)", on_terminal(100, *words, until=rb"so far"))
    expected = r"--target-error 1e-06: searching, \d{1,3}(,\d{3})* samples so far"
    wrong = [line for line in lines if not re.fullmatch(expected, line)]
    check("the search", (True, []), (bool(lines), wrong))


def check_dumb(folder):
    words = ("scenes/refraction.json", pathlib.Path(folder, "out.png"), 300, "--samples", 60, "--threads", 1)
    said = on_terminal(80, *words, TERM="dumb")
    check("a dumb terminal", True, bool(re.fullmatch(r"\S+: 300 × 300, [\d.]+ s\n", said)))


def check_forged(folder):
    """No name makes a line of its own: whatever is named has a newline in it."""
    forged = "\nforged\n"
    here = pathlib.Path(folder, forged)
    here.mkdir()
    scene, picture = here / f"{forged}.json", here / f"{forged}.png"
    sphere = {"type": "sphere", "transform": forged, "material": forged}
    scene.write_text(json.dumps(LEAST | {
        "lights": [{"position": [3, 5, 4], "color": [1, 1, 1]}, {"position": [0, 0, -9], "color": [1, 1, 1]}],
        "materials": [{"name": forged, "color_diffuse": [1, 1, 1], "reflective": True}],
        "transforms": [{"name": forged}, {"name": "t"}],
        "shapes": [sphere, sphere | {"transform": "t"}], forged: 0}))
    wrong = here / f"{forged}wrong.png"
    for words in ([scene, picture, 8, "--target-time", 0.01], [scene, wrong, 8, "--only", "diffuse"],
                  [scene, picture, 8, "--part", "1/1"], [scene, picture, 8, "--skip-existing"],
                  ["assemble", f"{picture}.part-1-of-1", here / f"{forged}.jpg"],
                  ["explain", scene, 4, 4, 8], ["explain", scene, "--picture", wrong],
                  ["compare", picture, wrong], ["compare", picture, scene], ["grade", here],
                  ["grade", here, "--program", f"echo '{forged}'"],
                  ["tradeoff", scene, "--size", 16, "--samples", 2, "--out", here / forged],
                  [here, picture, 8], [forged, picture, 8], [scene, picture, forged]):
        done = subprocess.run([RAYTRACER, *map(str, words)], capture_output=True, text=True, check=False)
        said = done.stdout + done.stderr
        check(f"{words}: is told", True, "forged" in said or words[-1] == "1/1")
        check(f"{words}: forged", [], [line for line in said.splitlines() if line.startswith("forged")])


with tempfile.TemporaryDirectory() as temporary:
    for checked in (check_done, check_wrapped, check_bar, check_search, check_dumb, check_forged):
        checked(temporary)
sys.exit(conclude("the terminal shows what it should"))
