"""Counts how often `raytracer` names the mistake in a picture: single ones, pairs, unknown ones, and none.

The pictures come from test/tracer/plain_tracer.h, changed by hand (test/grading/students.py). Right pictures
come from it unchanged, and from other precisions. STUDENT is the program that test/grading/class_check.py
builds.

Usage: mistakes.py RAYTRACER STUDENT SCENE.json ... [--size N] [--pairs N] [--seed N]
    [--only right,single,unknown,pairs] [--verbose]
"""
import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "test/grading"))
from students import KNOWN, MORE, UNKNOWN  # noqa: E402


def read(path):
    return numpy.asarray(Image.open(path).convert("RGB")).astype(int)


class Bench:
    def __init__(self, options, folder):
        self.options, self.folder, self.picture = options, folder, folder / "theirs.png"
        self.counts = {}

    def draw(self, scene, mistakes):
        subprocess.run([self.options.student, scene, self.picture, str(self.options.size), *mistakes],
                       check=True)
        return read(self.picture)

    def named(self, scene):
        command = [self.options.raytracer, "explain", scene, "--picture", self.picture, "--quiet", "--json"]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode < 2, (scene, done.stderr)
        answer = json.loads(done.stdout)
        return answer["verdict"] if answer["mistakes"] else ""

    def count(self, kind, scene, mistakes, good, said):
        found = self.counts.setdefault(kind, [0, 0, 0])
        found[0] += 1
        found[1] += good
        wrongly = not good and bool(said)
        found[2] += wrongly
        if self.options.verbose and not good:
            print(f"{kind}: {Path(scene).stem} {'+'.join(mistakes)}: {said or '-'}", flush=True)

    # Whether each mistake of several changes what the others leave by more than a few pixels.
    def shows(self, scene, mistakes):
        whole = self.draw(scene, mistakes)
        if (whole == whole[0, 0]).all():
            return False
        for left_out in mistakes:
            rest = self.draw(scene, [m for m in mistakes if m != left_out])
            off = abs(whole - rest).max(axis=2)
            threshold = 0 if "cut" in mistakes and left_out == "cut" else 1
            if (off > threshold).sum() < 40:
                return False
        self.draw(scene, mistakes)
        return True

    def single(self, scene):
        for mistake, words in {**KNOWN, **MORE}.items():
            if self.shows(scene, [mistake]):
                said = self.named(scene)
                self.count("single", scene, [mistake], words in said, said)

    def pairs(self, scene, bits):
        for mistakes in bits.sample([(a, b) for a in KNOWN for b in KNOWN
                                     if a < b and {a, b} != {"gamma", "srgb"}], self.options.pairs):
            if self.shows(scene, mistakes):
                said = self.named(scene)
                self.count("pair", scene, mistakes, all(KNOWN[m] in said for m in mistakes), said)

    def unknown(self, scene):
        for mistake, words in UNKNOWN.items():
            if self.shows(scene, [mistake]):
                said = self.named(scene)
                self.count("unknown", scene, [mistake], not said or bool(words and re.search(words, said)),
                           said)

    def right(self, scene):
        self.draw(scene, [])
        said = self.named(scene)
        self.count("right", scene, ["plain"], not said, said)
        for precision in ("float", "extended"):
            command = [self.options.raytracer, scene, self.picture, str(self.options.size), "--precision",
                       precision, "--quiet"]
            subprocess.run(command, check=True)
            said = self.named(scene)
            self.count("right", scene, [precision], not said, said)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("raytracer")
    parser.add_argument("student")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--size", type=int, default=200)
    parser.add_argument("--pairs", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="right,single,unknown,pairs")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    bits = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as name:
        bench = Bench(options, Path(name))
        for scene in options.scenes:
            for part in options.only.split(","):
                getattr(bench, part)(scene, *([bits] if part == "pairs" else []))
    for kind, (all_, good, wrongly) in bench.counts.items():
        print(f"{kind:8} {good:5} of {all_:5} ({100 * good / all_:5.1f} %), {wrongly} named wrongly")


main()
