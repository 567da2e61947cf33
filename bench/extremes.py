#!/usr/bin/python3
"""Counts the pixels that go wrong if the unit of length or the origin changes: raytracer, POV-Ray, Tachyon.

    bench/extremes.py [--scenes spheres_cylinder,cone_cube] [--size 200] [--by 8] [--out bench/results]

A picture should depend on neither. A pixel is wrong if a channel differs by more than --by of 255 from the
same program's picture of the original scene. For raytracer a second count has the pixels that differ by more
than 1 of 255 from --precision extended on the same numbers. First, plain.py removes from the scenes what one
of the programs cannot express.
"""
import argparse
import pathlib
import sys
import tempfile

import measure
import programs
from programs import NAMES, say

measure.TIME_LIMIT = 120
SCALES = list(range(-12, 13))  # powers of ten
TRANSLATIONS = list(range(0, 9))
OURS = {"float": "raytracer, float", "double": "raytracer, double", "extended": "raytracer, long double"}


class Extremes:
    def __init__(self, arguments, folder):
        self.arguments, self.folder = arguments, folder
        self.columns = [name for name in [*OURS, "povray", "tachyon"]
                        if programs.installed("raytracer" if name in OURS else name, arguments.raytracer)]

    def title(self, column):
        return OURS.get(column) or NAMES[column]

    def render(self, column, scene, tag):
        """The picture's path, or None where the program drew none."""
        program = "raytracer" if column in OURS else column
        out = self.folder / f"{scene.stem}-{tag}-{column}.png"
        size = programs.image_size(scene, self.arguments.size)
        converted, _ = programs.convert(scene, program, self.arguments.size, self.folder)
        command = programs.command(program, converted, out, size, 1, self.arguments.raytracer)
        try:
            measure.run(command + (["--precision", column] if column in OURS else []))
        except measure.Failed as failure:
            say(f"{tag}: {failure}")
        return out if out.exists() else None

    def transformed(self, scene, tag, options):
        out = self.folder / f"{scene.stem}-{tag}.json"
        measure.run([sys.executable, programs.HERE / "transform_scene.py", scene, *options, out])
        return out

    def wrong(self, scene, tag, options, baseline):
        """{column: wrong pixels, None for no picture} and {precision: wrong pixels against extended}."""
        moved = self.transformed(scene, tag, options)
        pictures = {column: self.render(column, moved, tag) for column in self.columns}
        pixels = self.pixels(scene)
        own = {column: pictures[column] and
               round(pixels * programs.differing_share(baseline[column], pictures[column], self.arguments.by))
               for column in self.columns}
        reference = {column: pictures[column] and pictures["extended"] and
                 round(pixels * programs.differing_share(pictures["extended"], pictures[column], 1))
                 for column in ("float", "double")}
        return own, reference

    def pixels(self, scene):
        width, height = programs.image_size(scene, self.arguments.size)
        return width * height

    def rows(self, scenes, kind, powers):
        """Lines of the table; the counts of all scenes are added."""
        for power in powers:
            tag = f"{kind}{power}"
            options = ["--scale", f"1e{power}"] if kind == "scale" else ["--translate-sizes", f"1e{power}"]
            say(tag)
            counts = [self.wrong(scene, tag, options, baseline) for scene, baseline in scenes.items()]
            cells = [total(own[column] for own, _ in counts) for column in self.columns]
            references = [total(reference[column] for _, reference in counts)
                          for column in ("float", "double")]
            what = f"scaled by 10^{power}" if kind == "scale" else f"moved by 10^{power} sizes"
            yield f"| {what} | " + " | ".join(cells + references) + " |"


def total(counts):
    counts = list(counts)
    return "no picture" if any(count is None for count in counts) else f"{sum(counts):,}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default="spheres_cylinder,cone_cube")
    parser.add_argument("--size", type=int, default=200)
    parser.add_argument("--by", type=float, default=8)
    parser.add_argument("--step", type=int, default=1, help="every how many powers of ten of the scale")
    parser.add_argument("--out", type=pathlib.Path, default=programs.HERE / "results")
    parser.add_argument("--raytracer", type=pathlib.Path, default=programs.default_binary())
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        extremes = Extremes(arguments, pathlib.Path(temporary))
        if "double" not in extremes.columns:
            sys.exit(2)
        scenes = {}
        for name in arguments.scenes.split(","):
            is_path = name.endswith(".json")
            path = pathlib.Path(name) if is_path else programs.TOP / "scenes" / f"{name}.json"
            plain, _ = programs.convert(path, "plain", 0, extremes.folder)
            scenes[plain] = {column: extremes.render(column, plain, "start") for column in extremes.columns}
        titles = [extremes.title(column) for column in extremes.columns]
        titles += ["float to long double", "double to long double"]
        pixels = sum(extremes.pixels(scene) for scene in scenes)
        lines = ["| wrong pixels | " + " | ".join(titles) + " |", "|---|" + "--:|" * len(titles)]
        lines += extremes.rows(scenes, "scale", SCALES[::arguments.step])
        lines += extremes.rows(scenes, "move", TRANSLATIONS)
    arguments.out.mkdir(parents=True, exist_ok=True)
    note = "Tachyon's reader stores every number as a float. " if "tachyon" in extremes.columns else ""
    missing = [f"{NAMES[name]} is not installed here. " for name in NAMES
               if name != "raytracer" and name not in extremes.columns]
    (arguments.out / "extremes.md").write_text("\n".join(lines) + (
        f"\n\nOf {pixels:,} pixels ({arguments.scenes}, {arguments.size} px). Wrong: a channel differs by "
        "more than "
        f"{arguments.by:g} of 255 from the same program's picture of the scene as it was; in the last two "
        "columns, by more than 1 of "
        "255 from the picture in long double of the same numbers. "
        f"{note}{''.join(missing)}{programs.machine()}.\n"))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
