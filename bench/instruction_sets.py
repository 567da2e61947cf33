#!/usr/bin/env python3
"""Measures what an instruction set saves: the ratio of user times with it and with another, on one thread.

    bench/instruction_sets.py SCENE... [--sets BETTER OTHER] [--size N] [--runs N] [--options "..."]

The two run alternately. Prints the median, the smallest and the largest ratio. Needs build/release.
"""
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile

PROGRAM = pathlib.Path(__file__).resolve().parent.parent / "build/release/raytracer"


def user_seconds(scene, instruction_set, arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAM, scene, f"{folder}/o.png", str(arguments.size), "--threads", "1", "--quiet",
                        *arguments.options.split()],
                       env={**os.environ, "RAYTRACER_SIMD": instruction_set}, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--sets", nargs=2, default=["avx512", "avx2"])
    parser.add_argument("--size", type=int, default=1000)
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--options", default="")
    arguments = parser.parse_args()
    better, other = arguments.sets
    for scene in arguments.scenes:
        ratios = [user_seconds(scene, better, arguments) / user_seconds(scene, other, arguments)
                  for _ in range(arguments.runs)]
        print(f"{pathlib.Path(scene).stem:20} {better} / {other}: {statistics.median(ratios):.2f} "
              f"({min(ratios):.2f} to {max(ratios):.2f})", flush=True)


if __name__ == "__main__":
    main()
