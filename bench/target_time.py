#!/usr/bin/python3
"""Checks whether --target-time S takes S seconds: the whole process, on a quiet machine.

    bench/target_time.py [--seconds 2] [--size 2000] [--raytracer PROGRAM] [SCENE...]

Prints each scene's time over S, then how many are within 0.8 to 1.2. Without SCENE it runs all of scenes/.
"""
import argparse
import pathlib
import subprocess
import tempfile
import time

TOP = pathlib.Path(__file__).resolve().parent.parent


def seconds_of(command):
    start = time.monotonic()
    subprocess.run(command, check=True, capture_output=True)
    return time.monotonic() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=2)
    parser.add_argument("--size", type=int, default=2000)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, metavar="SCENE")
    arguments = parser.parse_args()
    scenes = arguments.scenes or sorted(s for s in (TOP / "scenes").glob("*.json") if "schema" not in s.name)
    near = 0
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            ratio = seconds_of([arguments.raytracer, scene, pathlib.Path(folder, "o.png"),
                                str(arguments.size), "--target-time",
                                str(arguments.seconds)]) / arguments.seconds
            near += 0.8 <= ratio <= 1.2
            print(f"{scene.stem} {ratio:.2f}", flush=True)
    print(f"{near} of {len(scenes)} within 0.8 to 1.2")


if __name__ == "__main__":
    main()
