#!/usr/bin/python3
"""Compares raytracer, POV-Ray and Tachyon on the same scenes: whole processes, from the scene to the PNG, the
same picture size, one ray a pixel.

    bench/side_by_side.py [--runs 5] [--threads 1,2] [--only NAME,...] [--size 2000] [--scenes scenes]
        [--out bench/results]

First, plain.py removes from the scenes what one of the programs cannot express; glass stays. Each round runs
every program once. A printed ratio is the median of the rounds' ratios.
"""
import argparse
import pathlib
import sys
import tempfile

import measure
import programs
from programs import NAMES, say

COURSE = ["stress_test", "spheres_cylinder", "refraction"]
GENERATED = {"spheres_10k": ("spheres", 10_000), "spheres_100k": ("spheres", 100_000),
             "mesh_5k": ("mesh", 5_000),
             "mesh_1.3M": ("mesh", 1_300_000)}


def find_scene(name, scenes, folder):
    """(scene file that all can say, what it lost for that), made now if it is a generated one; None where
    there is none."""
    if name in GENERATED:
        kind, count = GENERATED[name]
        out = folder / f"{name}.json"
        measure.run([sys.executable, programs.HERE / "generate.py", kind, count, out])
        return out, []
    path = scenes / f"{name}.json"
    if not path.is_file():
        say(f"{path}: no such scene: left out")
        return None
    return programs.convert(path, "plain", 0, folder)


def compare_one(scene, size, threads, who, runs, folder, binary):
    """Rows of the table for one scene and number of threads: [program, usages or Failed, share, losses]."""
    image_size = programs.image_size(scene, size)
    converted = {program: programs.convert(scene, program, size, folder) for program in who}
    pictures = {program: folder / f"{program}.png" for program in who}
    usages = measure.alternated(
        {program: programs.command(program, converted[program][0], pictures[program], image_size,
                                   threads, binary) for program in who}, runs)
    rows = []
    for program in who:
        failed = isinstance(usages[program], measure.Failed)
        share = None if failed or isinstance(usages["raytracer"], measure.Failed) else \
            programs.differing_share(pictures["raytracer"], pictures[program])
        rows.append([program, usages[program], share, converted[program][1]])
    return rows


def table_lines(name, size, threads, rows):
    ours = rows[0][1]
    for program, usages, share, _ in rows:
        start = f"| {name} | {size} | {threads} | {NAMES[program]} |"
        if isinstance(usages, measure.Failed):
            yield f"{start} {usages} | | | | | |"
            continue
        costs = [measure.median(usages, field) for field in ("user", "system", "wall", "peak")]
        ratios = ["", ""] if isinstance(ours, measure.Failed) else \
            [f"**{measure.ratio(usages, ours, field):.2f}**" if usages is not ours else "1"
             for field in ("user", "wall")]
        yield (f"{start} {costs[0]:.3f} | {costs[1]:.3f} | {costs[2]:.3f} | {ratios[0]} | {ratios[1]} | "
               f"{costs[3]:.0f} | "
               f"{'' if usages is ours or share is None else f'{100 * share:.2f} %'} |")


HEAD = ("| scene | pixels | threads | program | user s | system s | wall s | user, to ours | wall, to ours | "
        "peak MiB | pixels that differ |\n|---|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--only", default=",".join([*COURSE, *GENERATED]))
    parser.add_argument("--size", type=int, default=2000)
    parser.add_argument("--scenes", type=pathlib.Path, default=programs.TOP / "scenes",
                        help="folder of the course scenes")
    parser.add_argument("--out", type=pathlib.Path, default=programs.HERE / "results")
    parser.add_argument("--raytracer", type=pathlib.Path, default=programs.default_binary())
    arguments = parser.parse_args()
    who = [name for name in NAMES if programs.installed(name, arguments.raytracer)]
    if "raytracer" not in who:
        sys.exit(2)
    lines, losses = [HEAD], {}
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name in arguments.only.split(","):
            if not (found := find_scene(name, arguments.scenes, folder)):
                continue
            scene, lost = found
            losses |= {(name, "all"): lost} if lost else {}
            for threads in arguments.threads.split(","):
                say(f"{name}, {threads} threads")
                rows = compare_one(scene, arguments.size, threads, who, arguments.runs, folder,
                                   arguments.raytracer)
                lines += table_lines(name, arguments.size, threads, rows)
                say("\n".join(lines[-len(who):]))
                losses |= {(name, NAMES[program]): said for program, _, _, said in rows if said}
    write(arguments, who, lines, losses)


def write(arguments, who, lines, losses):
    arguments.out.mkdir(parents=True, exist_ok=True)
    notes = [f"Medians of {arguments.runs} alternated runs of the whole process; a ratio is the median of "
             "the rounds' own ratios (above 1: raytracer is faster). A pixel differs where a channel is off "
             "by more than 8 of 255. Peaks "
             f"up to {measure.memory_floor():.0f} MiB can't be told apart.",
             ", ".join([programs.machine(),
                        *(programs.version(name) for name in who if name != "raytracer")]) + "."]
    notes += [f"{NAMES[name]} is not installed here." for name in NAMES if name not in who]
    notes += [f"- {scene}, {program}: " + "; ".join(said) + "." for (scene, program), said in losses.items()]
    (arguments.out / "side_by_side.md").write_text("\n".join(lines) + "\n\n" + "\n".join(notes) + "\n")


if __name__ == "__main__":
    main()
