#!/usr/bin/python3
"""Converts a scene JSON of ours for POV-Ray or Tachyon: the same picture, as far as their models allow.

    bench/convert.py SCENE.json --to povray|tachyon|plain [--size 600] OUT

plain is our own format without what one of the other programs cannot express, except glass.

The scene asks for one ray a pixel, no antialiasing, four levels of rays (the camera's and three bounces) and
linear bytes. What the other program cannot express is listed on stderr, one line for each kind.
"""
import argparse
import sys

import convert_povray
import convert_tachyon
from plain import write_plain
from scene_file import read_scene

WRITERS = {"povray": convert_povray, "tachyon": convert_tachyon}


def convert(scene_path, program, long_edge, out_path):
    """Writes out_path; returns what the picture loses, as sentences."""
    losses = {}  # a dict as an ordered set
    with open(out_path, "w") as out:
        if program == "plain":
            write_plain(scene_path, out, lambda loss: losses.setdefault(loss))
            return list(losses)
        scene = read_scene(scene_path)
        WRITERS[program].write(scene, scene.camera.image_size(long_edge), out,
                               lambda loss: losses.setdefault(loss))
    return list(losses)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("--to", choices=[*WRITERS, "plain"], required=True)
    parser.add_argument("--size", type=int, default=600, help="pixels on the long edge")
    parser.add_argument("out")
    arguments = parser.parse_args()
    for loss in convert(arguments.scene, arguments.to, arguments.size, arguments.out):
        print(f"{arguments.scene}: {arguments.to}: {loss}", file=sys.stderr)


if __name__ == "__main__":
    main()
