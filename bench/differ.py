#!/usr/bin/python3
"""Prints the share of pixels of two pictures in which a channel differs by more than --by of 255.

    bench/differ.py A.png B.png [--by 8]
"""
import argparse
import sys

import numpy
from PIL import Image


def read(path):
    return numpy.asarray(Image.open(path).convert("RGB")).astype(int)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("a")
    parser.add_argument("b")
    parser.add_argument("--by", type=float, default=8)
    arguments = parser.parse_args()
    a, b = read(arguments.a), read(arguments.b)
    if a.shape != b.shape:
        sys.exit(f"{arguments.a} is {a.shape[1]} x {a.shape[0]}, {arguments.b} {b.shape[1]} x {b.shape[0]}")
    print((abs(a - b).max(axis=2) > arguments.by).mean())


if __name__ == "__main__":
    main()
