"""Tests the HTML report of `raytracer grade` in headless Chromium, as its readers use it, with 1 and with 80
scenes.

Usage: report_check.py RAYTRACER. Exit status 77 (CTest: skipped) without Pillow or Chromium.
"""
import fcntl
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from grade_check import LEAST, ImageDraw, check, conclude, draw_scene, failures, grade, write_program

# The page, exercised from inside: each line of the result is a check and whether it held.
PAGE_TEST = r"""
(async () => {
  const results = {}, errors = [];
  window.addEventListener("error", event => errors.push(event.message));
  window.addEventListener("unhandledrejection", event => errors.push(String(event.reason)));
  const wait = ms => new Promise(done => setTimeout(done, ms));
  const until = async condition => { for (let i = 0; i < 500 && !condition(); ++i) await wait(20); };
  const key = name => viewer.dispatchEvent(
      new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
  const press = (x, y, x2 = x, y2 = y) => {
    const at = (type, px, py) => stage.dispatchEvent(
        new PointerEvent(type, { clientX: px, clientY: py, bubbles: true }));
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

  // As if each first word were a scene of several stages.
  for (const card of cards) card.dataset.group = card.dataset.name.split("_")[0];
  arrange();
  const all = names().length;
  results.all = all === EXPECTED;
  results.groups = main.querySelectorAll("h2").length === GROUPS;
  results.worstFirstInEachGroup = [...main.children].every(part =>
    ascending([...part.querySelectorAll("article")].map(card => +card.dataset.score)));
  results.worstGroupFirst = ascending([...main.children].map(part =>
      +part.querySelector("article").dataset.score));
  set("grouped", false);
  results.ungrouped = main.querySelectorAll("h2").length === 0 && ascending(scores()) &&
      names().length === all;
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
  const centred = () => Math.abs(left + (wx + 0.5) * scale - middle[0]) < 2 &&
      Math.abs(top_ + (wy + 0.5) * scale - middle[1]) < 2;
  results.worstPixel = wx === 7 && wy === 9 && centred() && scale >= 8 && !mark.hidden;
  results.values = $("values").textContent.includes("(7, 9)") &&
      $("values").textContent.includes("reference 10 20 30")
    && $("values").textContent.includes("graded 255 255 255");
  const before = place();
  press(...middle);
  results.clickSwaps = shown() === "graded" && $("kind").textContent === "graded";
  results.inPlace = new Set(place()).size === 1 && place().join() === before.join();
  press(...middle);
  results.clickSwapsBack = shown() === "reference";
  key(" ");
  results.spaceSwaps = shown() === "graded";
  let changes = 0;
  new MutationObserver(() => ++changes).observe($("kind"), { childList: true });
  key("b"); await wait(1200); key("B");
  results.blinks = changes >= 2;
  const still = shown(); await wait(700);
  results.stopsBlinking = shown() === still;
  key("d"); results.difference = shown() === "difference";
  key("1"); results.one = shown() === "reference";
  key("2"); results.two = shown() === "graded";
  const close = scale;
  key("z");
  results.all_ = scale < close && left >= -1 && top_ >= -1 &&
      left + size()[0] * scale <= stage.clientWidth + 1;
  key("z"); results.worstAgain = scale === close && centred();
  key("+"); results.plus = scale === 2 * close && centred();
  key("-"); results.minus = scale === close && centred();
  stage.dispatchEvent(new WheelEvent("wheel", { deltaY: -1, clientX: 100, clientY: 100, cancelable: true }));
  results.wheel = scale > close;
  const from = [left, top_];
  press(300, 300, 350, 280);
  results.drag = left === from[0] + 50 && top_ === from[1] - 20 && shown() === "graded";
  const first = $("title").textContent;
  key("ArrowRight");
  if (EXPECTED > 1) await until(() => $("title").textContent !== first);
  results.next = EXPECTED === 1 ? $("title").textContent === first : $("title").textContent !== first;
  key("ArrowLeft");
  await until(() => $("title").textContent === first);
  results.previous = $("title").textContent === first;
  results["errors: " + errors.join("; ")] = errors.length === 0;
  return results;
})();
"""


class Browser:
    """Headless Chromium, spoken to over a pipe in its DevTools protocol: JSON messages that end with a zero
    byte."""

    def __init__(self, profile):
        command = [shutil.which("chromium"), "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
                   "--no-first-run",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   f"--user-data-dir={profile}", "--window-size=1200,900", "--remote-debugging-pipe",
                   "about:blank"]
        its_input, self.to_it = os.pipe()
        self.from_it, its_output = os.pipe()
        # clear of 3 and 4, where it looks
        high = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (its_input, its_output)]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        pass_fds=(3, 4),
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
        while self.evaluate("document.readyState + location.href") != "complete" + page.as_uri():
            time.sleep(0.05)

    def press_escape(self):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key="Escape", code="Escape",
                      windowsVirtualKeyCode=27)

    def close(self):
        self.process.kill()
        self.process.wait()


def make_gallery(folder, count):
    """`count` scenes in at most 8 groups, the k-th with more wrong pixels the larger k is; every fourth is
    right."""
    words = ["cone", "cube", "scene", "sphere", "plane", "mesh", "light", "glass"]
    for name in ("exam", "ours"):
        (folder / name).mkdir()
    for k in range(count):
        name = f"{words[(k + 2) % 8]}_scene{k}"
        (folder / "exam" / f"{name}.json").write_text(LEAST)
        draw_scene(10).save(folder / "exam" / f"{name}.png")
        picture = draw_scene(10)
        if k % 4 != 3:
            ImageDraw.Draw(picture).rectangle([7, 9, 7 + k // 8, 9], fill=(255, 255, 255))
        picture.save(folder / "ours" / f"{name}.png")
    # The program runs in a fresh folder.
    write_program(folder / "student", f'cp "{folder}/ours/$(basename "$1" .json).png" "$2"\n')


def check_page(browser, program, folder, count):
    folder.mkdir()
    make_gallery(folder, count)
    result = grade(program, folder, "exam", "--program", "./student", "--report", "report.html")
    if result.returncode != 1:
        failures.append(
            f"{count} scenes: exit status {result.returncode}: {result.stdout[-300:]}{result.stderr}")
        return
    browser.open(folder / "report.html")
    values = {"EXPECTED": count, "GROUPS": min(count, 8) if count > 1 else 0,
              "OFF": sum(k % 4 != 3 for k in range(count))}
    results = browser.evaluate(re.sub("|".join(values), lambda match: str(values[match[0]]), PAGE_TEST))
    browser.press_escape()
    results["Escape closes"] = browser.evaluate("!viewer.open")
    results["focus returns"] = browser.evaluate("document.activeElement.matches('button.picture')")
    for name, held in results.items():
        check(held, f"{count} scenes: {name}")


def main():
    if not shutil.which("chromium"):
        print("skipped: no chromium")
        return 77
    # the browser's children write on for a while
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        browser = Browser(Path(name) / "profile")
        try:
            for count in (1, 80):
                check_page(browser, str(Path(sys.argv[1]).resolve()), Path(name) / str(count), count)
        finally:
            browser.close()
    return conclude()


if __name__ == "__main__":
    sys.exit(main())
