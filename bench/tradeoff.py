#!/usr/bin/env python3
"""Runs `raytracer tradeoff` on six scenes with different bottlenecks, and makes the tables of bench/README.md
from it.

    bench/tradeoff.py [--raytracer PROGRAM] [--size 120] [--out bench/results] [--from tradeoff.csv]

Writes tradeoff.svg, tradeoff.html, tradeoff.csv and the tables, tradeoff.md, into --out. --from makes only
the tables, from an earlier CSV. The tables show rays of all kinds as multiples of the defaults', since other
load on the machine does not change them. Float and extended cast the same rays, so their table has processor
seconds.
"""
import argparse
import csv
import pathlib
import subprocess

TOP = pathlib.Path(__file__).resolve().parent.parent
SCENES = {"cone_cube": "edges", "checker_horizon": "textures", "refraction": "deep glass",
          "mirror_corridor": "facing mirrors", "mesh": "a mesh", "extreme_scale": "extreme scale"}


def read(path):
    """The trials of each scene: dictionaries with numbers where the table has some."""
    scenes = {name: [] for name in SCENES}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            for key, value in row.items():
                try:
                    row[key] = float(value)
                except ValueError:
                    pass
            scenes[row["scene"]].append(row)
    return scenes


def is_plain(trial, **knobs):
    usual = dict(samples=1, adaptive=0, max_recursion=3, cutoff=0, texture_filter="nearest",
                 precision="double")
    return all(trial[key] == value for key, value in (usual | knobs).items())


def find(trials, question="truncation", **knobs):
    return next((t for t in trials if t["question"] == question and is_plain(t, **knobs)), None)


def rays(trial):
    return sum(trial[f"{kind}_rays"] for kind in ("primary", "shadow", "reflection", "refraction"))


def number(value):
    return f"{value:.1e}".replace("e-0", "e-") if value else "0"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" + "|--:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def reaching(trials, error):
    """The cheapest setting that is no further off."""
    good = [t for t in trials if t["question"] == "truncation" and t["rmse"] <= error]
    return min(good, key=rays, default=None)


def options(trial):
    usual = dict(samples=1, adaptive=0, max_recursion=3, cutoff=0, texture_filter="nearest",
                 precision="double")
    shown = [(key.replace("_", "-"), trial[key]) for key in ("samples", "adaptive", "max_recursion", "cutoff")
             if not is_plain({**usual, key: trial[key]})]
    if trial["texture_filter"] == "bilinear":
        shown.append(("texture-filter", "bilinear"))
    return "`" + (" ".join(f"--{key} {value:g}" if isinstance(value, float) else f"--{key} {value}"
                           for key, value in shown)
                  or "the defaults") + "`"


def reach_table(scenes):
    """The setting with the fewest rays for an error, and what it takes."""
    rows = []
    for name, trials in scenes.items():
        plain = find(trials)
        row = [f"{name} ({SCENES[name]})", number(plain["rmse"])]
        for error in (0.03, 0.01, 0.003):
            best = reaching(trials, error)
            row.append(f"{rays(best) / rays(plain):.3g} × {options(best)}" if best else "–")
        rows.append(row)
    return table(["scene (bottleneck)", "RMSE of the defaults", "for 0.03", "for 0.01", "for 0.003"], rows)


def depth_table(scenes):
    """One sample a pixel, ever deeper, no cutoff."""
    rows = []
    for name, trials in scenes.items():
        base = find(trials)
        row = [name]
        for depth in (0, 1, 2, 3, 6):
            trial = find(trials, max_recursion=depth)
            row.append(f"{rays(trial) / rays(base):.2f} × {number(trial['rmse'])}" if trial and base else "–")
        rows.append(row)
    return table(["scene", *(f"depth {depth}" for depth in (0, 1, 2, 3, 6))], rows)


def sample_table(scenes):
    """More samples at the defaults' depth: as far as they are seen."""
    rows = []
    for name, trials in scenes.items():
        plain = find(trials)
        row = [name]
        for samples in (1, 4, 16, 64):
            trial = find(trials, samples=samples)
            row.append(f"{rays(trial) / rays(plain):.3g} × {number(trial['rmse'])}" if trial else "–")
        rows.append(row)
    return table(["scene", *(f"{n}" for n in (1, 4, 16, 64))], rows)


def precision_table(scenes):
    """The same 16 samples in another arithmetic."""
    rows = []
    for name, trials in scenes.items():
        exact = find(trials, "arithmetic", samples=16)
        row = [name]
        for precision in ("float", "double", "extended"):
            trial = find(trials, "arithmetic", samples=16, precision=precision)
            row.append(f"{trial['seconds'] / exact['seconds']:.2f} × {number(trial['rmse'])}")
        rows.append(row)
    return table(["scene", "float", "double", "extended"], rows)


def float_is_on_front(trials):
    """Whether nothing in double is both as fast and as accurate: its picture is off by what double's is, and
    by its own."""
    double, single = (find(trials, "arithmetic", samples=16, precision=p) for p in ("double", "float"))
    return single["seconds"] < double["seconds"]


def knob_table(scenes):
    """How many settings of each scene's front use a knob."""
    uses = {"--samples": lambda t: t["samples"] > 1, "--adaptive": lambda t: t["adaptive"] > 0,
            "--max-recursion": lambda t: t["max_recursion"] != 3, "--cutoff": lambda t: t["cutoff"] > 0,
            "--texture-filter bilinear": lambda t: t["texture_filter"] == "bilinear"}
    rows = []
    for name, trials in scenes.items():
        front = [t for t in trials if t["on_front"] == 1]
        rows.append([name, str(len(front)), *(str(sum(map(use, front))) for use in uses.values()),
                     "faster" if float_is_on_front(trials) else "slower"])
    return table(["scene", "on the front", *(f"`{knob}`" for knob in uses), "`--precision float`"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    parser.add_argument("--size", default="120")
    parser.add_argument("--out", default=TOP / "bench/results", type=pathlib.Path)
    parser.add_argument("--from", dest="csv", type=pathlib.Path)
    arguments = parser.parse_args()
    if not arguments.csv:
        files = [TOP / "scenes" / f"{name}.json" for name in SCENES]
        subprocess.run([arguments.raytracer, "tradeoff", *files, "--size", arguments.size, "--out",
                        arguments.out], check=True)
    scenes = read(arguments.csv or arguments.out / "tradeoff.csv")
    text = "\n".join(make.__doc__ + "\n\n" + make(scenes)
                     for make in (reach_table, depth_table, sample_table, precision_table, knob_table))
    (arguments.out / "tradeoff.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
