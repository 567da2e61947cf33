#!/usr/bin/python3
"""Measures how the cost grows with the spheres, the triangles, the size of the picture, and the threads.

    bench/scaling.py [--runs 3] [--parts spheres,mesh,picture,threads,ends] [--most 1000000]
        [--megapixels 64] [--size 1500] [--out bench/results]

--most limits the spheres and triangles; 10000000 adds the mesh of ten million, which takes several GB and
minutes. The cost of a ray is the CPU time of rendering (without loading, building and the PNG) over the
number of all rays cast.
"""
import argparse
import json
import os
import pathlib
import sys
import tempfile

import measure
import plot
import programs
from programs import say

SPHERES = [10 ** k for k in range(1, 7)]
TRIANGLES = [10 ** k for k in range(3, 8)]
EDGES = [316, 1000, 2000, 4000, 8000]  # squares of 0.1 to 64 megapixels


class Bench:
    def __init__(self, arguments, folder):
        self.arguments, self.folder = arguments, folder
        self.picture = folder / "out.png"

    def command(self, scene, size, threads):
        return [*programs.command("raytracer", scene, self.picture, (size, size), threads,
                                  self.arguments.raytracer), "--stats"]

    def alternated(self, commands):
        return measure.alternated(commands, self.arguments.runs)

    def generated(self, kind, count):
        out = self.folder / f"{kind}.json"
        measure.run([sys.executable, programs.HERE / "generate.py", kind, count, out])
        return out


def stats(usages):
    return json.loads(usages[-1].said[usages[-1].said.index("{"):])


def rays(usages):
    return sum(stats(usages)["rays"].values())


def seconds(usages, part, kind="seconds"):
    """The least over the runs of a phase's time: wall, or CPU where kind is cpu_seconds."""
    return min(json.loads(usage.said[usage.said.index("{"):])[kind][part] for usage in usages)


def by_count(bench, kind, counts):
    """The table's lines and [(count, ns a ray)] for scenes of growing numbers of shapes."""
    lines = [f"| {'spheres' if kind == 'spheres' else 'triangles'} | load, CPU s | build, CPU s | ns a ray | "
             f"to {plot.short(counts[0])} | peak MiB |",
             "|--:|--:|--:|--:|--:|--:|"]
    points = []
    for count in (count for count in counts if count <= bench.arguments.most):
        say(f"{kind}: {count}")
        scene = bench.generated(kind, count)
        usages = bench.alternated({"ours": bench.command(scene, bench.arguments.size, 1)})["ours"]
        if isinstance(usages, measure.Failed):
            lines.append(f"| {plot.short(count)} | {usages} | | | | |")
            break
        cost = 1e9 * seconds(usages, "render", "cpu_seconds") / rays(usages)
        points.append((count, cost))
        lines.append(f"| {plot.short(count)} | {seconds(usages, 'load', 'cpu_seconds'):.3f} | "
                     f"{seconds(usages, 'build', 'cpu_seconds'):.3f} | {cost:.0f} | "
                     f"{cost / points[0][1]:.2f} | "
                     f"{measure.median(usages, 'peak'):.0f} |")
    return lines, points


def by_picture(bench, scene):
    lines = ["| megapixels | user s | wall s | PNG written in s | user ns a pixel | peak MiB |",
             "|--:|--:|--:|--:|--:|--:|"]
    points = []
    for edge in (edge for edge in EDGES if edge * edge <= bench.arguments.megapixels * 1e6):
        say(f"picture: {edge} x {edge}")
        usages = bench.alternated({"ours": bench.command(scene, edge, 1)})["ours"]
        if isinstance(usages, measure.Failed):
            lines.append(f"| {edge * edge / 1e6:.1f} | {usages} | | | | |")
            break
        user = measure.median(usages, "user")
        points.append((edge * edge / 1e6, user))
        lines.append(f"| {edge * edge / 1e6:.1f} | {user:.3f} | {measure.median(usages, 'wall'):.3f} | "
                     f"{seconds(usages, 'write'):.3f} | {1e9 * user / edge ** 2:.0f} | "
                     f"{measure.median(usages, 'peak'):.0f} |")
    return lines, points


def by_threads(bench, scene):
    count = len(os.sched_getaffinity(0))
    say(f"threads: 1 to {count}")
    usages = bench.alternated({threads: bench.command(scene, bench.arguments.size, threads)
                               for threads in range(1, count + 1)})
    lines = ["| threads | wall s | times one thread | render alone s | times one thread |",
             "|--:|--:|--:|--:|--:|"]
    points = []
    for threads, of_these in usages.items():
        gain = measure.ratio(usages[1], of_these, "wall")
        render = seconds(usages[1], "render") / seconds(of_these, "render")
        points.append((threads, render))
        lines.append(f"| {threads} | {measure.median(of_these, 'wall'):.3f} | {gain:.2f} | "
                     f"{seconds(of_these, 'render'):.3f} | {render:.2f} |")
    return lines, points


def by_scene(bench):
    """The ends of the pipeline: what a course scene at 600 pixels costs beside its tracing."""
    lines = ["| scene | tracing, CPU ms | load | build | PNG | start and end | all | to tracing |",
             "|---|--:|--:|--:|--:|--:|--:|--:|"]
    for name in ("stress_test", "spheres_cylinder", "refraction"):
        scene = programs.TOP / "scenes" / f"{name}.json"
        if not scene.is_file():
            say(f"{scene}: no such scene: left out")
            continue
        usages = bench.alternated({"ours": bench.command(scene, 600, 1)})["ours"]
        if isinstance(usages, measure.Failed):
            lines.append(f"| {name} | {usages} | | | | | | |")
            continue
        parts = {part: 1e3 * seconds(usages, part, "cpu_seconds")
                 for part in ("render", "load", "build", "write")}
        whole = 1e3 * min(usage.user + usage.system for usage in usages)
        cells = [*parts.values(), whole - sum(parts.values()), whole]
        lines.append(f"| {name} | " + " | ".join(f"{cell:.1f}" for cell in cells) +
                     f" | {whole / parts['render']:.2f} |")
    return lines, []


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--parts", default="spheres,mesh,picture,threads,ends")
    parser.add_argument("--most", type=int, default=1_000_000)
    parser.add_argument("--megapixels", type=float, default=64, help="the largest picture")
    parser.add_argument("--size", type=int, default=1500)
    parser.add_argument("--out", type=pathlib.Path, default=programs.HERE / "results")
    parser.add_argument("--raytracer", type=pathlib.Path, default=programs.default_binary())
    arguments = parser.parse_args()
    if not programs.installed("raytracer", arguments.raytracer):
        sys.exit(2)
    course = programs.TOP / "scenes" / "spheres_cylinder.json"
    with tempfile.TemporaryDirectory() as temporary:
        bench = Bench(arguments, pathlib.Path(temporary))
        parts = {
            "spheres": ("Random spheres", lambda: by_count(bench, "spheres", SPHERES)),
            "mesh": ("One mesh", lambda: by_count(bench, "mesh", TRIANGLES)),
            "picture": ("spheres_cylinder, one thread, whole process", lambda: by_picture(bench, course)),
            "threads": ("10,000 spheres",
                        lambda: by_threads(bench, bench.generated("spheres", min(10_000, arguments.most)))),
            "ends": ("600-pixel course scenes, one thread", lambda: by_scene(bench)),
        }
        results = {part: (parts[part][0], *parts[part][1]()) for part in arguments.parts.split(",")}
    write(arguments, results)


def write(arguments, results):
    arguments.out.mkdir(parents=True, exist_ok=True)
    text = "\n\n".join(f"### {title}\n\n" + "\n".join(lines) for title, lines, _ in results.values())
    (arguments.out / "scaling.md").write_text(
        f"{text}\n\nWhole processes' times and peaks are medians of {arguments.runs} runs, those of load, "
        f"build, render and PNG the least. {programs.machine()}.\n")
    points = {part: points for part, (_, _, points) in results.items()}
    ideal = [(threads, threads) for threads, _ in points.get("threads", [])]
    plot.write_svg(arguments.out / "scaling.svg", [
        plot.Panel("A ray's cost", "spheres or triangles", "ns",
                   {name: points[part] for part, name in (("spheres", "spheres"), ("mesh", "one mesh"))
                    if points.get(part)}),
        plot.Panel("A picture's cost", "megapixels", "user CPU s",
                   {"spheres_cylinder": points.get("picture", [])}),
        plot.Panel("Threads", "threads", "times one thread",
                   {"10,000 spheres": points.get("threads", []), "ideal": ideal},
                   log_x=False, log_y=False, dashed={"ideal"}),
    ])


if __name__ == "__main__":
    main()
