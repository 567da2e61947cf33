#!/usr/bin/python3
"""Measures --adaptive E on all scenes: the picture's RMSE as a multiple of E, and the mean samples of a
pixel.

    bench/adaptive.py [--raytracer PROGRAM] [--size 96] [SCENE...]

The picture and the truth have the default depth; the truth has twice the size and a quarter of the least E. A
pixel needs the centres around it, so neighbouring tiles take the samples of the ring between them twice. The
samples include these; the last column shows them alone, from --adaptive 1, which needs no other extra
samples.
"""
import argparse
import json
import pathlib
import tempfile

import numpy

from target_error import Program, TOP, rmse

ERRORS = [0.1, 0.03, 0.01, 0.003]


def samples(done):
    stats = json.loads(done.stdout)
    return stats["rays"]["primary"] / (stats["width"] * stats["height"])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    parser.add_argument("--size", type=int, default=96)
    parser.add_argument("scenes", nargs="*",
                        default=sorted(str(path) for path in (TOP / "scenes").glob("*.json")
                                        if "schema" not in path.name))
    arguments = parser.parse_args()
    print("| scene | " + " | ".join(map(str, ERRORS)) + " | ring |\n|---" + "|--:" * (len(ERRORS) + 1) + "|")
    parts, taken = [], []
    with tempfile.TemporaryDirectory() as name:
        program = Program(arguments.raytracer, pathlib.Path(name))
        for scene in arguments.scenes:
            truth = program.truth(scene, arguments.size, min(ERRORS) / 4, 2, depth=("--max-recursion", 3))
            rows = []
            for error in ERRORS:
                picture, done = program.render(scene, arguments.size, "--adaptive", error, "--samples", 65536,
                                               "--stats")
                rows.append((rmse(picture, truth) / error, samples(done)))
            ring = samples(program.render(scene, arguments.size, "--adaptive", 1, "--stats")[1]) - 1
            parts.append([part for part, _ in rows])
            taken.append([count for _, count in rows])
            print(f"| {pathlib.Path(scene).stem} | " +
                  " | ".join(f"{part:.2f} E, {count:.3g}" for part, count in rows)
                  + f" | {ring:.3f} |", flush=True)
    columns = [f"{numpy.median(p):.2f} ({min(p):.2f} to {max(p):.2f}) E, {numpy.median(t):.3g}"
               for p, t in zip(zip(*parts), zip(*taken))]
    print("| median (least to most) | " + " | ".join(columns) + " | |")


if __name__ == "__main__":
    main()
