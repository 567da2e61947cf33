#!/usr/bin/python3
"""Compares the error of N samples a pixel with that of a regular grid of N samples, on all scenes.

    bench/samples.py --old PROGRAM [--raytracer PROGRAM] [--size 96] [SCENE...]

--old is this project's program at commit bd55ad3, whose --samples N was a grid of N x N. Both programs use
the default depth.
"""
import argparse
import pathlib
import tempfile

import numpy

from target_error import Program, TOP, rmse

COUNTS = [4, 16, 64, 256]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    parser.add_argument("--old", required=True)
    parser.add_argument("--size", type=int, default=96)
    parser.add_argument("scenes", nargs="*",
                        default=sorted(str(path) for path in (TOP / "scenes").glob("*.json")
                                        if "schema" not in path.name))
    arguments = parser.parse_args()
    ratios = {count: [] for count in COUNTS}
    print("| scene | " + " | ".join(map(str, COUNTS)) + " |\n|---" + "|--:" * len(COUNTS) + "|")
    with tempfile.TemporaryDirectory() as name:
        new, old = (Program(path, pathlib.Path(name)) for path in (arguments.raytracer, arguments.old))
        for scene in arguments.scenes:
            truth = new.truth(scene, arguments.size, 0.0002, 3, depth=("--max-recursion", 3))
            row = []
            for count in COUNTS:
                errors = [rmse(program.render(scene, arguments.size, "--samples", samples)[0], truth)
                          for program, samples in ((new, count), (old, round(count ** 0.5)))]
                ratios[count].append(errors[0] / errors[1])
                row.append(f"{errors[0]:.1e}, {ratios[count][-1]:.2f}".replace("e-0", "e-"))
            print(f"| {pathlib.Path(scene).stem} | " + " | ".join(row) + " |", flush=True)
    print("| median | " + " | ".join(f"{numpy.median(ratios[count]):.2f}" for count in COUNTS) + " |")


if __name__ == "__main__":
    main()
