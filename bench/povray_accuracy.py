#!/usr/bin/python3
"""Measures the CPU time that raytracer and POV-Ray take to reach an RMSE, on scenes that both can draw.

    bench/povray_accuracy.py [--size 240] [--raytracer PROGRAM] [SCENE...]

plain.py removes from the scenes what POV-Ray cannot express. raytracer runs with --target-error E for the
errors below. POV-Ray runs without antialiasing, and with each of its two methods (+AM1, +AM2) at several
thresholds and depths. The truth of each program is its own: for raytracer a picture of three times the size
(target_error.py), for POV-Ray one of four times the size with 9 samples a pixel. CPU time is that of the
whole process, with one thread.
"""
import argparse
import itertools
import pathlib
import re
import tempfile

import numpy

import measure
import programs
from target_error import Program, rmse

COURSE = ["spheres_cylinder", "cone_cube", "camera_test1", "camera_test2", "mesh"]
ERRORS = [0.02, 0.01, 0.007, 0.005, 0.004, 0.003, 0.002, 0.001]
POVRAY = [["-A"]] + [[f"+AM{method}", f"+A{threshold}", f"+R{depth}"]
                     for method, threshold, depth in itertools.product(
    (1, 2), (0.3, 0.1, 0.03, 0.01, 0.003), (2, 3, 4, 6))]


def reduced(picture, times):
    height, width = picture.shape[0] // times, picture.shape[1] // times
    return picture[:height * times, :width * times].reshape(height, times, width, times, 3).mean(axis=(1, 3))


class PovRay:
    def __init__(self, scene, folder):
        self.scene, self.folder = scene, folder

    def render(self, size, *options):
        """The picture, and CPU seconds."""
        file, _ = programs.convert(self.scene, "povray", size, self.folder)
        text = file.read_text()
        file.write_text(re.sub(r"max_trace_level \d+", "max_trace_level 8", text))
        width, height = programs.image_size(self.scene, size)
        out = self.folder / "povray.ppm"
        command = ["povray", f"+I{file}", f"+O{out}", f"+W{width}", f"+H{height}", "-D", "+FP16",
                   "File_Gamma=1.0", "-GA", "+WT1",
                   "-J", *options]
        usage = measure.run(command)
        return read_ppm(out), usage.user + usage.system


def read_ppm(path):
    data = path.read_bytes()
    header = re.match(rb"P6\s+(?:#.*\n)*(\d+)\s+(\d+)\s+(\d+)\s", data)
    width, height, most = (int(header[i]) for i in (1, 2, 3))
    kind = ">u2" if most > 255 else "u1"
    return numpy.frombuffer(data[header.end():], kind).reshape(height, width, 3) / most


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", type=pathlib.Path, default=programs.default_binary())
    parser.add_argument("--size", type=int, default=240)
    parser.add_argument("scenes", nargs="*",
                        default=[str(programs.TOP / "scenes" / f"{name}.json") for name in COURSE])
    arguments = parser.parse_args()
    print("| scene | " + " | ".join(f"{error}" for error in ERRORS) + " |\n|---" + "|--:" * len(ERRORS) + "|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for given in arguments.scenes:
            scene, _ = programs.convert(given, "plain", 0, folder)
            program = Program(arguments.raytracer, folder)
            truth = program.truth(scene, arguments.size, min(ERRORS) / 3, 3)
            ours = []
            for error in [0.03, *ERRORS, 0.7 * min(ERRORS)]:
                picture, _ = program.render(scene, arguments.size, "--target-error", error, "--threads", 1)
                usage = measure.run([arguments.raytracer, scene, folder / "o.png", arguments.size, "--quiet",
                                     "--threads", 1,
                                     "--target-error", error])
                ours.append((rmse(picture, truth), usage.user + usage.system))
            povray = PovRay(scene, folder)
            converged = reduced(povray.render(4 * arguments.size, "+AM1", "+A0.0", "+R3")[0], 4)
            theirs = []
            for options in POVRAY:
                picture, seconds = povray.render(arguments.size, *options)
                theirs.append((rmse(picture, converged), seconds))
            row = []
            for error in ERRORS:
                a, b = (min((s for e, s in points if e <= error), default=None) for points in (ours, theirs))
                row.append(f"{a:.2f} s, {b:.2f} s: **{b / a:.0f}**" if a and b else f"{a:.2f} s, not reached"
                           if a else "–")
            print(f"| {pathlib.Path(given).stem} | " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
