"""`raytracer grade` of other programs: good ones, and each way in which one can go wrong; then the page in a browser.

Usage: grade_check.py RAYTRACER cli|page. Exit status 77 (CTest: skipped) without Pillow or, for the page, Chromium.
"""
import fcntl
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    from PIL import Image, ImageDraw
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

failures = []


def check(condition, what):
    if not condition:
        failures.append(what)


def draw_scene(radius, dot=None, size=60):
    picture = Image.new("RGB", (size, size * 2 // 3), (10, 20, 30))
    ImageDraw.Draw(picture).ellipse([30 - radius, 20 - radius, 30 + radius, 20 + radius], fill=(200, 120, 40))
    if dot:
        ImageDraw.Draw(picture).rectangle([*dot, dot[0] + 1, dot[1] + 1], fill=(255, 255, 255))
    return picture


def write_program(path, body):
    path.write_text("#!/bin/sh\n" + body)
    path.chmod(0o755)
    return path


def grade(program, folder, *arguments):
    command = [program, "grade", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, cwd=folder)


# One scene for each way to end. The program copies what its author "rendered" to ours/.
ENDINGS = {
    "good_one": ("", "100", ""),
    "good_two": ("", "100", ""),
    "off": ("", "98", ""),
    "status": ("echo 'done, nearly' >&2; cp \"$ours\" \"$2\"; exit 3", "100", "exit status 3"),
    "crash": ("cp \"$ours\" \"$2\"; echo 'about to fall'; kill -SEGV $$", "0", "crashed: Segmentation fault"),
    "hang": ("echo 'thinking'; sleep 60", "0", "hung: stopped after 1 s"),
    "nothing": ("echo 'what scene?'", "0", "wrote no picture"),
    "broken": ("echo nonsense > \"$2\"", "0", "PNG"),
    "size": ("", "0", "the pictures' sizes differ: 30 x 20 and 60 x 40"),
}


def make_class(folder):
    """exam/ with scenes and references, ours/ with what the program makes of them, and the program."""
    for name in ("exam", "ours"):
        (folder / name).mkdir()
    for name in ENDINGS:
        (folder / "exam" / f"{name}.json").write_text("{}")
        draw_scene(10).save(folder / "exam" / f"{name}.png")
        shown = draw_scene(10, (5, 5)) if name == "off" else draw_scene(10)
        (shown.resize((30, 20)) if name == "size" else shown).save(folder / "ours" / f"{name}.png")
    draw_scene(10).save(folder / "exam" / "off-normals.png")
    (folder / "exam" / "lonely.json").write_text("{}")
    cases = "".join(f"{name}) {body or 'cp $ours $2'};;\n" for name, (body, _, _) in ENDINGS.items())
    return write_program(folder / "student", f'[ "$3" = 60 ] || exit 9\nname=$(basename "$1" .json); ours=ours/$name.png\n'
                                             f"case $name in\n{cases}esac\n")


def check_cli(program, folder):
    make_class(folder)
    start = time.monotonic()
    result = grade(program, folder, "exam", "--program", "./student", "--timeout", 1, "--report", "report.html")
    check(time.monotonic() - start < 10, "a program that hangs is stopped")
    check(result.returncode == 1, f"exit status 1, not {result.returncode}: {result.stderr}")
    rows = {match[2]: match for match in re.finditer(r"^ *(\d+) .*  (\w+)(?:: (.*))?$", result.stdout, re.M)}
    check(sorted(rows) == sorted(ENDINGS), f"a row for each scene: {result.stdout}")
    for name, (_, score, message) in ENDINGS.items():
        check(rows[name][1] == score and message in (rows[name][3] or ""), f"{name}: {rows[name][0]!r}")
    for words in ("about to fall", "done, nearly", "thinking", "what scene?"):
        check(words in result.stdout, f"a program's last line is shown: {result.stdout}")
    check("3 of 9 pictures as the reference, mean score 44.2" in result.stdout, f"the summary: {result.stdout[-200:]}")
    check("no reference: lonely.json" in result.stdout, "scenes without reference are told")
    page = (folder / "report.html").read_text()
    check(page.count("<article") == 9 and "crashed: Segmentation fault" in page and "about to fall" in page, "the report")
    check_statuses(program, folder)
    check_interrupt(program, folder)


def check_interrupt(program, folder):
    """Ctrl-C ends the program that is being graded, too."""
    write_program(folder / "sleeper", "echo $$ > pid; exec sleep 60\n")
    grader = subprocess.Popen([program, "grade", "exam", "--program", "./sleeper"], cwd=folder, stdout=subprocess.DEVNULL)
    pid = folder / "pid"
    while not (pid.exists() and pid.read_text().strip()):
        time.sleep(0.01)
    grader.send_signal(signal.SIGINT)
    check(grader.wait(10) == -signal.SIGINT, "an interrupt ends the grading")
    time.sleep(0.1)
    check(not Path(f"/proc/{pid.read_text().strip()}").exists(), "an interrupt ends the program")


def check_statuses(program, folder):
    shutil.copytree(folder / "exam", folder / "few", ignore=lambda _, names: [n for n in names if n[:3] not in ("goo", "off")])
    (folder / "empty").mkdir()
    student = ("--program", "./student")
    for status, *arguments in [
        (1, "few", *student), (0, "few", *student, "--max-pixels", 4), (0, "few", *student, "--min-score", 98),
        (1, "few", *student, "--min-score", 99), (1, "few", *student, "--size", 61), (0, "few", "--references", "ours",
        *student), (2, "empty", *student), (2, "nowhere", *student), (2, "few", *student, "--report", "nowhere/r.html"),
        (2, "few", *student, "--stage", "sketch"), (2, "few", *student, "--timeout", 0), (2,),
        (0, "few", "--stage", "normals", "--program", "cp exam/off-normals.png \"$2\" #\n:"),
    ]:
        result = grade(program, folder, *arguments)
        check(result.returncode == status, f"{arguments}: exit status {result.returncode}: {result.stderr}{result.stdout}")
        if status == 2:
            check(result.stderr.count("\n") == 1 + ("--help" in result.stderr), f"{arguments}: {result.stderr!r}")


# The page, exercised from inside: each line of the result is a check and whether it held.
PAGE_TEST = r"""
(async () => {
  const results = {}, errors = [];
  window.addEventListener("error", event => errors.push(event.message));
  window.addEventListener("unhandledrejection", event => errors.push(String(event.reason)));
  const wait = ms => new Promise(done => setTimeout(done, ms));
  const until = async condition => { for (let i = 0; i < 500 && !condition(); ++i) await wait(20); };
  const key = name => viewer.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
  const press = (x, y, x2 = x, y2 = y) => {
    const at = (type, px, py) => stage.dispatchEvent(new PointerEvent(type, { clientX: px, clientY: py, bubbles: true }));
    at("pointerdown", x, y); at("pointermove", x2, y2); at("pointerup", x2, y2);
  };
  const set = (id, value) => {
    if (typeof value === "boolean") $(id).checked = value; else $(id).value = value;
    $(id).dispatchEvent(new Event("input"));
  };
  const names = () => visible().map(card => card.dataset.name);
  const scores = () => visible().map(card => +card.dataset.score);
  const ascending = list => list.every((value, i) => i === 0 || list[i - 1] <= value);
  const shown = () => [...stage.querySelectorAll("img.shown")].map(image => image.alt).join();
  const place = () => [...stage.querySelectorAll("img")].map(image => image.style.transform);
  stage.setPointerCapture = () => {};  // a made-up pointer can't be captured

  const all = names().length;
  results.all = all === EXPECTED;
  results.groups = main.querySelectorAll("h2").length === GROUPS;
  results.worstFirstInEachGroup = [...main.children].every(part =>
    ascending([...part.querySelectorAll("article")].map(card => +card.dataset.score)));
  results.worstGroupFirst = ascending([...main.children].map(part => +part.querySelector("article").dataset.score));
  set("grouped", false);
  results.ungrouped = main.querySelectorAll("h2").length === 0 && ascending(scores()) && names().length === all;
  set("sort", "best");
  results.bestFirst = ascending(scores().reverse());
  set("sort", "name");
  results.byName = names().join() === [...names()].sort().join();
  set("filter", "SCENE");
  results.filter = names().length > 0 && names().every(name => name.includes("scene"));
  set("filter", "no such name");
  results.nothing = names().length === 0 && main.textContent.includes("Nothing to show");
  set("filter", "");
  set("offOnly", true);
  results.offOnly = names().length === OFF && visible().every(card => card.className !== "same");
  set("offOnly", false); set("sort", "worst");

  main.querySelector("button[data-kind=reference]").click();
  await until(() => viewer.open && stage.querySelector("img.shown"));
  results.opens = viewer.open && shown() === "reference" && $("kind").textContent === "reference";
  const [wx, wy] = worst(), middle = [stage.clientWidth / 2, stage.clientHeight / 2];
  const centred = () => Math.abs(left + (wx + 0.5) * scale - middle[0]) < 2 && Math.abs(top_ + (wy + 0.5) * scale - middle[1]) < 2;
  results.worstPixel = wx === 7 && wy === 9 && centred() && scale >= 8 && !mark.hidden;
  results.values = $("values").textContent.includes("(7, 9)") && $("values").textContent.includes("reference 10 20 30")
    && $("values").textContent.includes("ours 255 255 255");
  const before = place();
  press(...middle);
  results.clickSwaps = shown() === "ours" && $("kind").textContent === "ours";
  results.inPlace = new Set(place()).size === 1 && place().join() === before.join();
  press(...middle);
  results.clickSwapsBack = shown() === "reference";
  key(" ");
  results.spaceSwaps = shown() === "ours";
  let changes = 0;
  new MutationObserver(() => ++changes).observe($("kind"), { childList: true });
  key("b"); await wait(1200); key("B");
  results.blinks = changes >= 2;
  const still = shown(); await wait(700);
  results.stopsBlinking = shown() === still;
  key("d"); results.difference = shown() === "difference";
  key("1"); results.one = shown() === "reference";
  key("2"); results.two = shown() === "ours";
  const close = scale;
  key("z"); results.all_ = scale < close && left >= -1 && top_ >= -1 && left + size()[0] * scale <= stage.clientWidth + 1;
  key("z"); results.worstAgain = scale === close && centred();
  key("+"); results.plus = scale === 2 * close && centred();
  key("-"); results.minus = scale === close && centred();
  stage.dispatchEvent(new WheelEvent("wheel", { deltaY: -1, clientX: 100, clientY: 100, cancelable: true }));
  results.wheel = scale > close;
  const from = [left, top_];
  press(300, 300, 350, 280);
  results.drag = left === from[0] + 50 && top_ === from[1] - 20 && shown() === "ours";
  const first = $("title").textContent;
  key("ArrowRight");
  await until(() => EXPECTED > 1 && $("title").textContent !== first);
  results.next = EXPECTED === 1 ? $("title").textContent === first : $("title").textContent !== first;
  key("ArrowLeft");
  await until(() => $("title").textContent === first);
  results.previous = $("title").textContent === first;
  results["errors: " + errors.join("; ")] = errors.length === 0;
  return results;
})();
"""


class Browser:
    """Headless Chromium, spoken to over a pipe in its DevTools protocol: JSON messages that end with a zero byte."""

    def __init__(self, profile):
        command = [shutil.which("chromium"), "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   f"--user-data-dir={profile}", "--window-size=1200,900", "--remote-debugging-pipe", "about:blank"]
        its_input, self.to_it = os.pipe()
        self.from_it, its_output = os.pipe()
        high = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (its_input, its_output)]  # clear of 3 and 4, where it looks
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, pass_fds=(3, 4),
                                        preexec_fn=lambda: (os.dup2(high[0], 3), os.dup2(high[1], 4)))
        for fd in (its_input, its_output, *high):
            os.close(fd)
        self.buffer, self.number, self.session = b"", 0, None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

    def receive(self):
        while b"\0" not in self.buffer:
            block = os.read(self.from_it, 1 << 16)
            if not block:
                raise RuntimeError("the browser has ended")
            self.buffer += block
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_it, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                return answer["result"]

    def evaluate(self, script):
        answer = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"]["exception"].get("description", "exception"))
        return answer["result"].get("value")

    def open(self, page):
        self.call("Page.navigate", url=page.as_uri())
        while self.evaluate("document.readyState + location.protocol") != "completefile:":
            time.sleep(0.05)

    def press_escape(self):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key="Escape", code="Escape", windowsVirtualKeyCode=27)

    def close(self):
        self.process.kill()
        self.process.wait()


def make_gallery(folder, count):
    """`count` scenes in at most 8 groups, the k-th with more wrong pixels the larger k is; every fourth is right."""
    words = ["cone", "cube", "scene", "sphere", "plane", "mesh", "light", "glass"]
    for name in ("exam", "ours"):
        (folder / name).mkdir()
    for k in range(count):
        name = f"{words[(k + 2) % 8]}_scene{k}"
        (folder / "exam" / f"{name}.json").write_text("{}")
        draw_scene(10).save(folder / "exam" / f"{name}.png")
        picture = draw_scene(10)
        if k % 4 != 3:
            ImageDraw.Draw(picture).rectangle([7, 9, 7 + k // 8, 9], fill=(255, 255, 255))
        picture.save(folder / "ours" / f"{name}.png")
    write_program(folder / "student", 'cp "ours/$(basename "$1" .json).png" "$2"\n')


def check_page(program, folder, count):
    folder.mkdir()
    make_gallery(folder, count)
    result = grade(program, folder, "exam", "--program", "./student", "--report", "report.html")
    if result.returncode != 1:
        failures.append(f"{count} scenes: exit status {result.returncode}: {result.stdout[-300:]}{result.stderr}")
        return
    browser = Browser(folder / "profile")
    try:
        browser.open(folder / "report.html")
        values = {"EXPECTED": count, "GROUPS": min(count, 8), "OFF": sum(k % 4 != 3 for k in range(count))}
        results = browser.evaluate(re.sub("|".join(values), lambda match: str(values[match[0]]), PAGE_TEST))
        browser.press_escape()
        results["Escape closes"] = browser.evaluate("!viewer.open")
        results["focus returns"] = browser.evaluate("document.activeElement.matches('button.picture')")
    finally:
        browser.close()
    for name, held in results.items():
        check(held, f"{count} scenes: {name}")


def main():
    program, part = str(Path(sys.argv[1]).resolve()), sys.argv[2]
    if part == "page" and not shutil.which("chromium"):
        print("skipped: no chromium")
        return 77
    with tempfile.TemporaryDirectory() as name:
        if part == "cli":
            check_cli(program, Path(name))
        else:
            for count in (1, 200):
                check_page(program, Path(name) / str(count), count)
    print("\n".join(failures) or "as it should be")
    return 1 if failures else 0


sys.exit(main())
