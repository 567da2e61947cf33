#!/usr/bin/env python3
"""The commands that trade speed for accuracy, as a user meets them: tradeoff_check.py RAYTRACER, from the project's folder."""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

RAYTRACER = sys.argv[1]
SCENES = sorted(p for p in pathlib.Path("scenes").glob("*.json") if p.name != "scene.schema.json")
DEFAULTS = "--samples 1 --adaptive 0 --max-recursion 3 --cutoff 0 --texture-filter nearest --precision double"


def run(*arguments):
    return subprocess.run([RAYTRACER, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def render(scene, out, size, options=""):
    """The picture's bytes, and how the program ended."""
    done = run(scene, out, size, "--quiet", *options.split())
    return out.read_bytes(), done


def check_defaults(folder):
    """Given as options, the defaults change no byte."""
    for scene in SCENES:
        plain, _ = render(scene, folder / "plain.png", 40)
        asked, _ = render(scene, folder / "asked.png", 40, DEFAULTS)
        assert plain == asked, scene


def check_target(folder, scene, size, target, status, why, found=""):
    """What --target-error says that it picks is what it renders; its exit status says whether that is enough."""
    picture, done = render(scene, folder / "target.png", size, f"--target-error {target} --stats")
    assert done.returncode == status, done
    setting = re.search(r"^--target-error \S+: (the defaults|--[^,]*), (.*)$", done.stderr, re.M)
    assert setting and why in setting[2], done.stderr
    assert "rays a pixel, found with" in done.stderr and "the error is about" in done.stderr, done.stderr
    assert ("not reached" in done.stderr) == (status == 1), done.stderr
    options = "" if setting[1] == "the defaults" else setting[1]
    assert found in done.stderr, done.stderr
    same, plain = render(scene, folder / "same.png", size, options + " --stats")
    assert picture == same, setting[1]
    assert json.loads(done.stdout)["rays"] == json.loads(plain.stdout)["rays"], setting[1]


def check_report(folder):
    """tradeoff writes a table, a chart and a page that tell of every setting."""
    done = run("tradeoff", "scenes/cone_cube.json", "--size", 16, "--samples", 2, "--repeats", 1, "--out", folder / "report",
               "--quiet")
    assert done.returncode == 0, done
    rows = list(csv.DictReader((folder / "report/tradeoff.csv").open(newline="")))
    questions = [row["question"] for row in rows]
    assert questions.count("arithmetic") == 6 and questions.count("truncation") > 5, questions
    chart = xml.etree.ElementTree.parse(folder / "report/tradeoff.svg")
    points = chart.findall(".//{http://www.w3.org/2000/svg}circle")
    assert len(points) == questions.count("truncation"), len(points)
    assert all("RMSE" in point[0].text for point in points)  # the hover text
    fronts = [row for row in rows if row["on_front"] == "1"]
    assert len([p for p in points if p.get("class") == "front"]) in (len(fronts), len(fronts) - 1)  # the defaults have a class
    page = (folder / "report/tradeoff.html").read_text()
    assert page.count("<circle") == len(points) and "data:image/png" in page and "http" not in re.sub(
        r"http://www\.w3\.org/2000/svg", "", page), "not self-contained"


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_defaults(folder)
        check_target(folder, "scenes/spheres_cylinder.json", 16, 0.1, 0, "the cheapest of those that reach 0.1")
        check_target(folder, "scenes/spheres_cylinder.json", 16, 1e-9, 1, "nothing reaches 1e-09")
        check_target(folder, "scenes/cone_cube.json", 160, 0.02, 0, "the cheapest", "to find out, the picture was rendered")
        check_report(folder)


if __name__ == "__main__":
    main()
