#!/usr/bin/env python3
"""Tests the commands that trade accuracy for speed, as a user calls them.

Usage: tradeoff_check.py RAYTRACER, from the source folder.
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

RAYTRACER = str(pathlib.Path(sys.argv[1]).resolve())
SCENES = sorted(p for p in pathlib.Path("scenes").glob("*.json") if p.name != "scene.schema.json")
DEFAULTS = "--samples 1 --adaptive 0 --max-recursion 3 --cutoff 0 --texture-filter nearest --precision double"


def run(*arguments):
    return subprocess.run([RAYTRACER, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def render(scene, out, size, options=""):
    """The picture's bytes, and how the program ended."""
    done = run(scene, out, size, *options.split())
    return out.read_bytes(), done


def check_defaults(folder):
    """Given as options, the defaults change no byte."""
    for scene in SCENES:
        plain, _ = render(scene, folder / "plain.png", 40)
        asked, _ = render(scene, folder / "asked.png", 40, DEFAULTS)
        assert plain == asked, scene


def check_target(folder, scene, size, target, others=""):
    """What --target-error says that it chooses is what it renders, also under --crop."""
    picture, done = render(scene, folder / "target.png", size, f"--target-error {target} {others}")
    assert done.returncode == 0, done
    setting = re.match(r"(--target-error \S+: )(--.*|the defaults)\n"
                       r"\1reached: estimated error (?:below )?(\S+)\n$", done.stderr)
    assert setting, done.stderr
    assert target / 11 < float(setting[3]) < 1.01 * target, done.stderr
    options = setting[2].replace("the defaults", "")
    same, done = render(scene, folder / "same.png", size, f"{options} {others}")
    assert done.returncode == 0 and picture == same, done
    _, done = render(scene, folder / "crop.png", size, f"--target-error {target} --crop 3,4,9,11 {others}")
    assert setting[0] == done.stderr, done.stderr


def check_doubt(folder):
    """No estimate far below the target is shown; what is not reached has a reason in the same line."""
    _, done = render("test/good/least.json", folder / "o.png", 8, "--target-error 0.02")
    assert "--target-error 0.02: reached: estimated error below 0.002\n" in done.stderr, done.stderr
    _, done = render("test/good/least.json", folder / "o.png", 8, "--target-time 0.05")
    assert done.stderr.startswith("--target-time: estimated error below 0.125, "), done.stderr  # 1 / 8
    _, done = render("scenes/checker_horizon.json", folder / "o.png", 2, "--target-error 1e-7")
    assert done.returncode == 1 and re.fullmatch(
        r"(--target-error 1e-07: )--samples (\d+) .*\n\1not reached: estimated error \S+ at --samples \2; "
        r"more is too slow\n", done.stderr), done.stderr


def check_one_sample(folder):
    """With so many lights the search ends at one sample: --adaptive would have no effect, and is not told."""
    scene = json.loads(pathlib.Path("test/good/least.json").read_text())
    scene |= {"lights": [{"position": [0, 0, 9], "color": [1e-4, 1e-4, 1e-4]}] * 4000,
              "materials": [{"name": "m", "color_diffuse": [1, 1, 1]}],
              "transforms": [{"name": "t", "scale": [3, 3, 3]}],
              "shapes": [{"type": "cube", "material": "m", "transform": "t"}]}
    (folder / "lights.json").write_text(json.dumps(scene))
    check_target(folder, folder / "lights.json", 16, 0.031)


def check_time(folder, scene, others=""):
    """--target-time tells the command that makes its picture again."""
    picture, done = render(scene, folder / "a time.png", 50, f"--target-time 0.1 {others}")
    again = re.search(r"^--target-time: the same picture again:\n(.*)$", done.stderr, re.M)
    assert done.returncode == 0 and again, done
    (folder / "a time.png").unlink()
    subprocess.run(again[1], shell=True, check=True, timeout=300)
    assert picture == (folder / "a time.png").read_bytes(), again[1]


def check_again(folder):
    """In that command a name that begins with a dash has a folder; what changes no picture is left out."""
    (folder / "-s.json").write_text(pathlib.Path("scenes/cone_cube.json").read_text())
    done = subprocess.run([RAYTRACER, "--target-time=0.1", "--skip-existing", "--", "-s.json", "-o.png",
                           "20"], cwd=folder,
                          capture_output=True, text=True)
    assert f"again:\n{RAYTRACER} ./-s.json ./-o.png 20 --" in done.stderr, done.stderr


def check_no_time(folder):
    """What is fastest is found where nothing is fast enough; the defaults need no option."""
    for words, options in [(["--pass", "normals"], ""), ([], " --max-recursion 0")]:
        done = run("scenes/texture.json", folder / "o.png", 40, "--target-time", 1e-9, *words)
        told = done.stderr.splitlines()
        assert told[0].endswith("; no setting takes less"), told
        assert told[-1].endswith(f"{folder / 'o.png'} 40{options}"), told


def check_limit(folder):
    """--adaptive alone has a limit, and says where it stopped many pixels."""
    alone, done = render("scenes/texture.json", folder / "alone.png", 40, "--adaptive 0.05")
    limited, _ = render("scenes/texture.json", folder / "limited.png", 40, "--adaptive 0.05 --samples 256")
    assert alone == limited and done.stderr == "", done
    done = run("scenes/texture.json", folder / "o.png", 40, "--adaptive", 0.01, "--samples", 8, "--stats")
    stats = json.loads(done.stdout)
    assert stats["setting"] == {"samples": 8, "adaptive": 0.01, "max_recursion": 3, "cutoff": 0,
                                "texture_filter": "nearest"}, stats
    stopped = stats["limited_pixels"]
    told = (f"{100 * stopped / 40 ** 2:.3g} % of the pixels would take more samples for --adaptive 0.01: "
            "--samples 8 is too few\n")
    assert stopped > 100 and done.stderr.endswith(told), done


def check_report(folder):
    """tradeoff writes a table, a chart and a page that tell of every setting."""
    done = run("tradeoff", "scenes/cone_cube.json", "--size", 16, "--samples", 4, "--repeats", 1, "--out",
               folder / "report",
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
    # the defaults have a class
    assert len([p for p in points if p.get("class") == "front"]) in (len(fronts), len(fronts) - 1)
    page = (folder / "report/tradeoff.html").read_text()
    assert page.count("<circle") == len(points) and "data:image/png" in page and "http" not in re.sub(
        r"http://www\.w3\.org/2000/svg", "", page), "not self-contained"


def check_names(folder):
    """Any name of a scene is one field of the table, text on a page, and does nothing to a terminal."""
    name = 'a,b"\n\x1b[31m<i>\'&\udcff'
    scene = folder / f"{name}.json"
    scene.write_bytes(pathlib.Path("test/good/least.json").read_bytes())
    done = subprocess.run([RAYTRACER, "tradeoff", scene, "--size", "16", "--samples", "2", "--repeats", "1",
                           "--out", folder / "names"],
                          capture_output=True, timeout=300)
    assert done.returncode == 0, done
    shown = 'a,b"\\x0a\\x1b[31m<i>\'&\\xff'
    assert done.stdout.decode().startswith(f"{shown}: 16 x 16 pixels."), done.stdout
    assert done.stderr.decode().startswith(f"{shown}: the reference ...\n"), done.stderr
    rows = list(csv.reader((folder / "names/tradeoff.csv").open(newline="")))
    assert {len(row) for row in rows} == {21}, rows
    assert {row[0] for row in rows[1:]} == {'a,b"\\x0a\\x1b[31m<i>\'&\\xff'}, rows[1]
    text = xml.etree.ElementTree.parse(folder /
                                       "names/tradeoff.svg").findall(".//{http://www.w3.org/2000/svg}text")
    assert 'a,b"\n\\x1b[31m<i>\'&\\xff' in [element.text
                                            for element in text], [element.text for element in text]
    page = (folder / "names/tradeoff.html").read_bytes().decode()
    assert "a,b&quot;\n\\x1b[31m&lt;i&gt;&#39;&amp;\\xff</h2>" in page and "\x1b" not in page, "the page"


def check_distinct(folder):
    """Scenes of one name are told apart by their paths; one that is given twice is refused."""
    (folder / "e1").mkdir()
    for name in ("s.json", "e1/s.json", "t.json"):
        (folder / name).write_bytes(pathlib.Path("test/good/least.json").read_bytes())

    def measured(*scenes):
        done = subprocess.run([RAYTRACER, "tradeoff", *scenes, "--size", "16", "--samples", "2", "--repeats",
                               "1", "--quiet"], cwd=folder, capture_output=True, text=True, timeout=300)
        return done.returncode, done.stderr

    def names():
        return {row["scene"] for row in csv.DictReader((folder / "tradeoff.csv").open(newline=""))}

    assert measured("s.json", "t.json") == (0, "") and names() == {"s", "t"}, names()
    assert measured("./s.json", "e1/s.json", folder / "s.json") == (0, "")
    assert names() == {"s.json", "e1/s.json", f"{folder.name}/s.json"}, names()
    said = 'raytracer tradeoff: expected each scene once, found "s.json" twice\n'
    assert measured("s.json", "e1/s.json", "./s.json") == (2, said), measured("s.json", "./s.json")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_defaults(folder)
        check_target(folder, "scenes/spheres_cylinder.json", 16, 0.1)
        check_target(folder, "scenes/cone_cube.json", 160, 0.02)
        check_target(folder, "scenes/texture.json", 60, 0.5)  # no recursion, so no cutoff
        check_target(folder, "scenes/cone_cube.json", 60, 0.05, "--pass normals")  # neither
        for only in ("diffuse", "ambient,shadows,textures"):  # neither
            check_target(folder, "scenes/spheres_cylinder.json", 60, 0.05, f"--only {only}")
            check_time(folder, "scenes/spheres_cylinder.json", f"--only {only}")
        check_doubt(folder)
        check_one_sample(folder)
        check_time(folder, "scenes/texture.json", "--texture-filter bilinear")
        check_again(folder)
        check_no_time(folder)
        check_limit(folder)
        check_report(folder)
        check_names(folder)
        check_distinct(folder)


if __name__ == "__main__":
    main()
