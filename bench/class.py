"""Measures what it costs to grade a class of pictures, and to view its page.

The pictures are ours, without some terms of the light model: `--distinct` of them for each of ten scenes. A
third of the submissions has the right pictures. FOLDER is created. If Chromium is installed, the script also
measures how long the page takes.

Usage: class.py RAYTRACER FOLDER [--submissions N] [--distinct N] [--size N]
"""
import argparse
import itertools
import os
import random
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "test/grading"))
from report_check import Browser  # noqa: E402

SCENES = ["spheres_cylinder", "cone_cube", "refraction", "refraction_inside", "texture", "orthographic_test1",
          "orthographic_test2", "camera_test1", "camera_test2", "mirror_corridor"]
TERMS = ["ambient", "diffuse", "specular", "shadows", "reflections", "refraction", "textures"]

OPENED = """(async () => {
  const start = performance.now();
  overview.querySelector("tbody a").click();
  while (!overview.hidden) await new Promise(next => setTimeout(next));
  const images = [...main.querySelectorAll("img")];
  for (const image of images) { image.scrollIntoView(); await image.decode(); }
  return [images.length, performance.now() - start];
})()"""


def variants(count):
    """Options of a render, `count` of them; the first has all terms. Without one of three it is dark."""
    sizes = range(len(TERMS))
    sets = [set(TERMS) - set(out) for size in sizes for out in itertools.combinations(TERMS, size)]
    lit = [terms for terms in sets if terms & {"ambient", "diffuse", "specular"}]
    return [["--only", ",".join(sorted(terms))] for terms in lit[:count]]


def make_class(options, folder):
    for name in ("exam", "drawn", "class"):
        (folder / name).mkdir(parents=True)
    for name in ("textures", "meshes"):
        if (ROOT / "scenes" / name).exists():
            shutil.copytree(ROOT / "scenes" / name, folder / "exam" / name)
    for scene in SCENES:
        shutil.copy(ROOT / f"scenes/{scene}.json", folder / "exam")
        for i, variant in enumerate(variants(options.distinct)):
            names = [f"exam/{scene}.json", f"drawn/{scene}-{i}.png"]
            command = [options.raytracer, *names, str(options.size), "--quiet", *variant]
            subprocess.run(command, check=True, cwd=folder)
        shutil.copy(folder / f"drawn/{scene}-0.png", folder / f"exam/{scene}.png")
    bits = random.Random("class")
    for number in range(options.submissions):
        own = folder / f"class/student_{number:03d}"
        own.mkdir()
        for scene in SCENES:
            which = bits.randrange(options.distinct) if number % 3 else 0
            os.link(folder / f"drawn/{scene}-{which}.png", own / f"{scene}.png")


def look(folder):
    browser = Browser(folder / "profile")
    try:
        start = time.monotonic()
        browser.open(folder / "page.html")
        loaded = time.monotonic() - start
        images, opened = browser.evaluate(OPENED)
    finally:
        browser.close()
    print(f"Chromium: loaded in {loaded:.2f} s; {images} pictures of a submission in {opened / 1000:.2f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("raytracer", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--submissions", type=int, default=200)
    parser.add_argument("--distinct", type=int, default=6)
    parser.add_argument("--size", type=int, default=600)
    options = parser.parse_args()
    options.raytracer = options.raytracer.resolve()
    folder = options.folder.resolve()
    make_class(options, folder)
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run([options.raytracer, "grade", "exam", "--submissions", "class", "--report", "page.html"],
                   check=True, cwd=folder, stdout=subprocess.DEVNULL)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(f"{options.submissions} submissions, {options.distinct} pictures a scene: {cpu:.1f} s of CPU "
          f"({cpu / options.submissions:.2f} a submission), {wall:.1f} s")
    beside = [path.stat().st_size for path in (folder / "page_pictures").glob("*")]
    print(f"page {(folder / 'page.html').stat().st_size / 1e6:.1f} MB, beside it {len(beside)} pictures of "
          f"{sum(beside) / 1e6:.1f} MB")
    if shutil.which("chromium"):
        look(folder)


main()
