#!/usr/bin/python3
"""Runs the program in a memory control group (version 1) with limits below its peak: it must say so, and not
be killed. As root.

    bench/memory_group.py [--raytracer PROGRAM] [--step 1.5] -- ARGUMENTS

The limits go from 101 to 50 % of the peak.
"""
import argparse
import os
import pathlib
import subprocess

GROUP = pathlib.Path("/sys/fs/cgroup/memory/raytracer_bench")


def peak_of(command, limit):
    """Runs the command; returns its status, its last line, and the peak of the group, bytes."""
    for file, number in (("force_empty", 0), ("limit_in_bytes", limit), ("max_usage_in_bytes", 0)):
        (GROUP / f"memory.{file}").write_text(str(number))
    done = subprocess.run(["sh", "-c", f'echo $$ > {GROUP}/cgroup.procs; exec "$@"', "sh", *command],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    peak = int((GROUP / "memory.max_usage_in_bytes").read_text())
    return done.returncode, done.stderr.strip().split("\n")[-1], peak


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--raytracer", default="build/release/raytracer")
    parser.add_argument("--step", type=float, default=1.5, help="percent of the peak")
    parser.add_argument("arguments", nargs="+")
    options = parser.parse_args()
    command = [options.raytracer, *options.arguments]
    GROUP.mkdir(exist_ok=True)
    try:
        status, _, peak = peak_of(command, -1)
        print(f"without a limit: exit status {status}, peak {peak / 1e6:.1f} MB")
        outcomes = []
        for i in range(int(51 / options.step) + 1):
            share = 101 - i * options.step
            status, line, _ = peak_of(command, int(peak * share / 100))
            outcomes.append(status)
            print(f"{share:5.1f} %: {'killed' if status < 0 else status} {line[-100:]}")
        print(f"{sum(status < 0 for status in outcomes)} of {len(outcomes)} killed")
    finally:
        GROUP.rmdir()


if __name__ == "__main__":
    main()
