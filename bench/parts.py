#!/usr/bin/env python3
"""Measures what parts cost: CPU time of all N parts over that of one run, and the longest part over the mean.

    bench/parts.py SCENE LONG_EDGE_PIXELS [options of raytracer] [--raytracer PROGRAM] [--repeats 5]

For N = 1, 2, 4, 8, 16 it measures all parts and `assemble`: medians of the repeats, one thread.
"""
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

top = pathlib.Path(__file__).resolve().parent.parent

def cpu_seconds(command):
    def spent():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    before = spent()
    subprocess.run([str(word) for word in command], check=True)
    return spent() - before


def option(words, name, usual):
    """Takes the option and its value out of the words."""
    if name not in words:
        return usual
    at = words.index(name)
    value = words[at + 1]
    del words[at:at + 2]
    return value


def main():
    words = sys.argv[1:]
    if len(words) < 2 or "--help" in words:
        sys.exit(__doc__)
    program = pathlib.Path(option(words, "--raytracer", top / "build/release/raytracer")).resolve()
    repeats = int(option(words, "--repeats", 5))
    scene, size, *options = words
    with tempfile.TemporaryDirectory() as folder:
        out = f"{folder}/out.png"
        line = [program, scene, out, size, *options, "--quiet", "--threads", 1]
        counts = [1, 2, 4, 8, 16]
        one, parts, joins = [], {n: [] for n in counts}, {n: [] for n in counts}
        for _ in range(repeats):
            one.append(cpu_seconds(line))
            for n in counts:
                parts[n].append([cpu_seconds([*line, "--part", f"{k}/{n}"]) for k in range(1, n + 1)])
                names = [f"{out}.part-{k}-of-{n}" for k in range(1, n + 1)]
                joins[n].append(cpu_seconds([program, "assemble", *names, out, "--quiet", "--threads", 1]))
        whole = statistics.median(one)
        print(f"{pathlib.Path(scene).stem} {size} {' '.join(options)}: one run {1000 * whole:.0f} ms")
        print("| N | all parts, ms | over one run | longest to mean | assemble, ms |\n|--:|--:|--:|--:|--:|")
        for n in counts:
            means = [statistics.median(times) for times in zip(*parts[n])]  # of each part
            total = sum(means)
            print(f"| {n} | {1000 * total:.0f} | {total / whole:.2f} | {max(means) * n / total:.2f} | "
                  f"{1000 * statistics.median(joins[n]):.0f} |")


if __name__ == "__main__":
    main()
