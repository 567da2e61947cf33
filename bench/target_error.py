#!/usr/bin/python3
"""Whether --target-error keeps its promise, on random scenes that nobody tuned it for.

    bench/target_error.py --seed SEED [--count 200] [--raytracer PROGRAM] [--sizes 80 160 320 640]
    bench/target_error.py --scenes scenes/*.json [--sizes 240]

Scene i of bench/random_scenes.py is rendered at one of the sizes in turn (those of --scenes at each), for each error E
of ERRORS that this size has. Its true error is measured against a picture of twice the size whose pixels' own errors
are estimated to be at most the least E; the mean of its 2 x 2 pixels is off by a part of E that is printed: half of the
difference from a third picture, of three times the size. Prints each case that is above E, then the shares.
"""
import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

import random_scenes

TOP = pathlib.Path(__file__).resolve().parent.parent
# A small E takes most of the time, in the truth too, so that only small pictures have it.
ERRORS = {80: [0.05, 0.02, 0.01, 0.005, 0.002, 0.001], 160: [0.05, 0.02, 0.01, 0.005, 0.002], 320: [0.05, 0.02, 0.01, 0.005]}


def errors_of(size):
    return ERRORS.get(size, [0.05, 0.02, 0.01])


def read_pfm(path):
    data = path.read_bytes()
    header = re.match(rb"PF\s+(\d+)\s+(\d+)\s+\S+\s", data)
    width, height = int(header[1]), int(header[2])
    return numpy.frombuffer(data[header.end():], "<f4").reshape(height, width, 3)[::-1].astype(float)


class Program:
    def __init__(self, path, folder):
        self.path, self.out = path, folder / "picture.pfm"

    def render(self, scene, size, *options):
        """The colours, and how the program ended."""
        done = subprocess.run([self.path, scene, self.out, str(size), "--quiet", *map(str, options)], capture_output=True, text=True)
        if done.returncode not in (0, 1) or not self.out.exists():
            raise SystemExit(f"{scene}: {done.stderr}")
        return read_pfm(self.out), done

    def truth(self, scene, size, least, times, depth=None):
        """Of a picture `size` large, from one `times` as large."""
        large, _ = self.render(scene, times * size, "--adaptive", least, "--samples", 65536,
                               *(depth or ("--max-recursion", 32, "--cutoff", least / 10)))
        height, width = large.shape[0] // times, large.shape[1] // times
        means = large[:height * times, :width * times].reshape(height, times, width, times, 3).mean(axis=(1, 3))
        return means.clip(0, 1)


def rmse(a, b):
    return float(numpy.sqrt(((a.clip(0, 1) - b.clip(0, 1)) ** 2).mean()))


def cases(arguments, folder):
    if arguments.scenes:
        return [(scene, size) for scene in arguments.scenes for size in arguments.sizes]
    numbers = range(arguments.first, arguments.first + arguments.count)
    # Neither the kinds nor the sizes are a multiple of the other.
    return [(random_scenes.generate(folder, arguments.seed, i), arguments.sizes[i // len(random_scenes.KINDS) % len(arguments.sizes)])
            for i in numbers]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    parser.add_argument("--seed")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--sizes", type=int, nargs="+", default=[80, 160, 320, 640])
    parser.add_argument("--scenes", nargs="*")
    parser.add_argument("--own-error", action="store_true", help="measure the truth's own error too")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = Program(arguments.raytracer, folder)
        ratios, unreached, own = collections.defaultdict(list), 0, []
        for scene, size in cases(arguments, folder):
            least = min(errors_of(size))
            truth = program.truth(scene, size, least, 2)
            if arguments.own_error:
                own.append(rmse(truth, program.truth(scene, size, least, 3)) / least)
            for error in errors_of(size):
                picture, done = program.render(scene, size, "--target-error", error)
                ratio = rmse(picture[:truth.shape[0], :truth.shape[1]], truth) / error
                if done.returncode == 1:
                    unreached += 1
                    print(f"{pathlib.Path(scene).stem} {size} px, E {error}: not reached, says the program; {ratio:.2f} E")
                    continue
                ratios[error].append(ratio)
                if ratio > 1:
                    print(f"{pathlib.Path(scene).stem} {size} px, E {error}: {ratio:.2f} E; {done.stderr.strip()}".replace("\n", "; "))
                sys.stdout.flush()
        for error in sorted(ratios, reverse=True):
            r = numpy.array(ratios[error])
            print(f"E {error}: {len(r)} cases, {100 * (r > 1).mean():.1f} % above E, {(r > 2).sum()} above 2 E, "
                  f"median {numpy.median(r):.2f}, most {r.max():.2f}")
        r = numpy.concatenate(list(ratios.values()))
        print(f"all: {len(r)} cases, {100 * (r > 1).mean():.1f} % above E, {(r > 2).sum()} above 2 E; {unreached} not reached")
        if own:
            print(f"the truths of 2 x 2 and 3 x 3 differ by {numpy.median(own):.2f} (median), {max(own):.2f} (most) of the least E")


if __name__ == "__main__":
    main()
