#!/usr/bin/python3
"""Checks whether --target-error keeps its promise, on random scenes that nobody tuned it for.

    bench/target_error.py --seed SEED [--count 240] [--part 0/1] [--raytracer PROGRAM]
    bench/target_error.py --scenes scenes/*.json [--sizes 240]

The eight kinds of bench/random_scenes.py take turns. Each cycle of the eight is rendered at one size and one
E, such that 24 cycles have each pair of SIZES and ERRORS once; the seed decides which cycle has which pair.
The scenes of --scenes are rendered at each size and each E.

The truth is a picture of three times the size, with another depth, whose pixels' own errors are estimated to
be at most E / 3; the mean of 3 x 3 of its pixels is the truth of one pixel. In every fourth case the truth's
error is measured, too: it is at most the difference from a second truth, of four times the size. If a truth
takes more than --seconds of CPU time, its case is left out, and counted. (This happens with glass that is
both reflective and refractive, where the rays double with each bounce.) Prints each case that is above E,
then the shares. --part 0/2 takes every second scene.
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
        done = subprocess.run([self.path, scene, self.out, str(size), "--quiet", *map(str, options)],
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


def rmse(a, b):
    return float(numpy.sqrt(((a.clip(0, 1) - b.clip(0, 1)) ** 2).mean()))


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
            print(f"{text}; {done.stderr.strip()}".replace("\n", "; "), flush=True)

    def print(self):
        for name, ratios in self.ratios.items():
            r = numpy.array(ratios)
            print(f"{name}: {len(r)} cases, {(r > 1).sum()} ({100 * (r > 1).mean():.1f} %) above E, "
                  f"{(r > 2).sum()} above 2 E, median {numpy.median(r):.2f}, most {r.max():.2f}")
        print(f"{self.unreached} not reached, says the program; {self.left_out} left out; the truths' own "
              f"errors: median {numpy.median(self.own):.2f}, most {max(self.own):.2f} E of {len(self.own)}",
              flush=True)


def measure(program, case, results, with_own_error):
    scene, size, error = case
    truth = program.truth(scene, size, error / 3, 3)
    picture, done = program.render(scene, size, "--target-error", error)
    if with_own_error:
        results.own.append(rmse(truth, program.truth(scene, size, error / 3, 4)) / error)
    results.add(case, rmse(picture, truth) / error, done)


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
                measure(program, case, results, number % 4 == 1)
            except TooSlow:
                results.leave_out(case)
            if number % 24 == 0:
                print(f"after {number} cases:", flush=True)
                results.print()
        results.print()


if __name__ == "__main__":
    main()
