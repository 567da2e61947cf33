#!/usr/bin/python3
"""Checks whether --target-error keeps its promise, on random scenes that nobody tuned it for.

    bench/target_error.py --seed SEED [--count 240] [--part 0/1] [--raytracer PROGRAM]
    bench/target_error.py --scenes scenes/*.json [--sizes 240]

The eight kinds of bench/random_scenes.py take turns. Each cycle of the eight is rendered at one size and one
E, such that 24 cycles have each pair of SIZES and ERRORS once; the seed decides which cycle has which pair.
The scenes of --scenes are rendered at each size and each E.

There are two truths: pictures of two and three times the size, with another depth; the means of 2 x 2 and
3 x 3 of their pixels. Their --adaptive is E / 3, or that which the program chose if it is less: so each takes
about four or nine times as many samples as the picture, or more. All three pictures have other sample points,
so their errors are independent, and the mean of (picture - truth) (picture - other truth) is the squared
error without the truths' own errors: in a noisy texture one truth alone would be off by up to E. The larger
truth's own error is measured in the same way. If a truth takes more than --seconds of CPU time, its case is
left out, and counted. (This happens with glass that is both reflective and refractive, where the rays double
with each bounce.) Prints each case that is above E, then the shares. --part 0/2 takes every second scene.
"""
import argparse
import collections
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile

import numpy

import random_scenes

TOP = pathlib.Path(__file__).resolve().parent.parent
SIZES, ERRORS = [80, 160, 320, 640], [0.05, 0.02, 0.01, 0.005, 0.002, 0.001]


def read_pfm(path):
    data = path.read_bytes()
    header = re.match(rb"PF\s+(\d+)\s+(\d+)\s+\S+\s", data)
    width, height = int(header[1]), int(header[2])
    return numpy.frombuffer(data[header.end():], "<f4").reshape(height, width, 3)[::-1].astype(float)


class TooSlow(Exception):
    pass


class Program:
    def __init__(self, path, folder, seconds=None):
        self.path, self.out, self.seconds = path, folder / "picture.pfm", seconds

    def limit(self):
        if self.seconds:
            resource.setrlimit(resource.RLIMIT_CPU, (self.seconds, self.seconds))

    def render(self, scene, size, *options):
        """The colours, and how the program ended."""
        done = subprocess.run([self.path, scene, self.out, str(size), *map(str, options)],
                              capture_output=True, text=True, preexec_fn=self.limit)
        if done.returncode in (-signal.SIGKILL, -signal.SIGXCPU):
            raise TooSlow()
        if done.returncode not in (0, 1) or not self.out.exists():
            raise SystemExit(f"{scene}: {done.stderr}")
        return read_pfm(self.out), done

    def truth(self, scene, size, error, times, depth=None):
        """Of a picture `size` large, from one `times` as large."""
        # With glass and mirrors in one material, 300 bounces would take for ever.
        bounces = 64 if "refractive" in pathlib.Path(scene).read_text() else 300
        large, _ = self.render(scene, times * size, "--adaptive", error, "--samples", 65536,
                               *(depth or ("--max-recursion", bounces, "--cutoff", error / 10)))
        if large.shape[0] % times:
            raise SystemExit(f"{scene}: {size} px: the height was rounded, so that the two pictures differ; "
                             "take a multiple of 48")
        means = large.reshape(large.shape[0] // times, times, size, times, 3).mean(axis=(1, 3))
        return means.clip(0, 1)


def rmse(picture, truth, other=None):
    """With another truth, whose errors are independent of the first one's: without the truths' errors."""
    a, b, c = (colors.clip(0, 1) for colors in (picture, truth, truth if other is None else other))
    return float(numpy.sqrt(max(0, ((a - b) * (a - c)).mean())))


def cases(arguments, folder):
    """Scene, size, E."""
    if arguments.scenes:
        return [(scene, size, error) for scene in arguments.scenes for size in arguments.sizes
                for error in ERRORS]
    pairs = [(size, error) for size in arguments.sizes for error in ERRORS]
    random.Random(arguments.seed).shuffle(pairs)
    part, parts = map(int, arguments.part.split("/"))
    return [(random_scenes.generate(folder, arguments.seed, i),
             *pairs[i // len(random_scenes.KINDS) % len(pairs)])
            for i in range(part, arguments.count, parts)]


class Results:
    def __init__(self):
        self.ratios, self.own, self.unreached, self.left_out = collections.defaultdict(list), [], 0, 0

    def leave_out(self, case):
        self.left_out += 1
        print(f"{pathlib.Path(case[0]).stem} {case[1]} px, E {case[2]}: too slow", flush=True)

    def add(self, case, ratio, done):
        scene, size, error = case
        text = f"{pathlib.Path(scene).stem} {size} px, E {error}: {ratio:.2f} E"
        if done.returncode == 1:
            self.unreached += 1
            print(f"{text}; not reached, says the program", flush=True)
            return
        for group in (error, f"{size} px", "all"):
            self.ratios[group].append(ratio)
        if ratio > 1:
            print(text, *re.findall(r"(--target-error .*)", done.stderr), sep="; ", flush=True)

    def print(self):
        for name, ratios in self.ratios.items():
            r = numpy.array(ratios)
            print(f"{name}: {len(r)} cases, {(r > 1).sum()} ({100 * (r > 1).mean():.1f} %) above E, "
                  f"{(r > 2).sum()} above 2 E, median {numpy.median(r):.2f}, most {r.max():.2f}")
        print(f"{self.unreached} not reached, says the program; {self.left_out} left out; the truths' own "
              f"errors: median {numpy.median(self.own):.2f}, most {max(self.own):.2f} E of {len(self.own)}",
              flush=True)


def measure(program, case, results):
    scene, size, error = case
    picture, done = program.render(scene, size, "--target-error", error)
    chosen = re.search(r"--adaptive (\S+)", done.stderr)
    adaptive = min([error / 3] + ([float(chosen[1])] if chosen else []))
    one, other = (program.truth(scene, size, adaptive, times) for times in (3, 2))
    results.own.append(rmse(one, picture, other) / error)
    results.add(case, rmse(picture, one, other) / error, done)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    parser.add_argument("--seed")
    parser.add_argument("--count", type=int, default=240)
    parser.add_argument("--part", default="0/1")
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--sizes", type=int, nargs="+", default=SIZES)
    parser.add_argument("--scenes", nargs="*")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program, results = Program(arguments.raytracer, folder, arguments.seconds), Results()
        for number, case in enumerate(cases(arguments, folder), 1):
            try:
                measure(program, case, results)
            except TooSlow:
                results.leave_out(case)
            if number % 24 == 0:
                print(f"after {number} cases:", flush=True)
                results.print()
        results.print()


if __name__ == "__main__":
    main()
