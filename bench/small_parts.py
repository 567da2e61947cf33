#!/usr/bin/python3
"""Measures --target-error and --adaptive on scenes whose small parts lie between the centres of the pixels.

    bench/small_parts.py [--raytracer PROGRAM]

Prints the RMSE of 120 px pictures as a multiple of E. The truths are two pictures of three and four times the
size, with 400 samples a pixel; their own errors drop out (target_error.py). "Dots" lie at corners of pixels,
"stars" anywhere; "30" are 30 times as bright as white. The bars of "comb" are a tenth of their distance wide;
"rails" run past the eye.
"""
import argparse
import json
import pathlib
import random
import tempfile

from target_error import Program, TOP, rmse

SIZE, TIMES, SAMPLES = 120, (3, 4), 400


def scene(shapes, shine=1, perspective=False):
    """Shapes: type, translate, scale; all of one colour that shines by itself."""
    edge = 0.5 if perspective else 3
    return {"camera": {"type": "perspective" if perspective else "orthographic", "focal_length": 1,
                       "eye": [0, 0, 0 if perspective else 6], "look": [0, 0, -1], "up": [0, 1, 0],
                       "film_left": -edge, "film_right": edge, "film_bottom": -edge, "film_top": edge},
            "lights": [{"position": [0, 0, 9], "color": [0, 0, 0], "color_ambient": [1, 1, 1]}],
            "materials": [{"name": "m", "color_ambient": [shine] * 3, "color_diffuse": [0] * 3,
                           "color_specular": [0] * 3}],
            "transforms": [{"name": f"x{i}", "translate": place, "scale": scale}
                           for i, (_, place, scale) in enumerate(shapes)],
            "shapes": [{"type": kind, "transform": f"x{i}", "material": "m"}
                       for i, (kind, _, _) in enumerate(shapes)]}


def scenes():
    dice = random.Random("small parts")
    pixel = 6 / SIZE
    corners = [[(dice.randrange(SIZE) - SIZE // 2) * pixel for _ in "xy"] + [0] for _ in range(80)]
    anywhere = [[dice.uniform(-3, 3), dice.uniform(-3, 3), 0] for _ in range(1500)]
    stars = [("sphere", place, [0.012] * 3) for place in anywhere]
    rails = [("cube", [dice.uniform(-1, 1), dice.uniform(-1, 1), 0], [0.0004, 0.0004, 100])
             for _ in range(20)]
    return {"80 dots": scene([("sphere", place, [0.3 * pixel] * 3) for place in corners]),
            "1500 stars": scene(stars), "1500 stars, 30": scene(stars, 30),
            "comb of 400 bars": scene([("cube", [0.015 * i - 2.9925, 0, 0], [0.00075, 2.5, 0.05])
                                       for i in range(400)]),
            "20 rails": scene(rails, perspective=True)}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer", default=TOP / "build/release/raytracer")
    print("| scene | `--target-error` 0.01 | 0.002 | `--adaptive` 0.05 | 0.02 | 0.01 |")
    print("|---|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = Program(parser.parse_args().raytracer, folder)
        for title, description in scenes().items():
            path = folder / "scene.json"
            path.write_text(json.dumps(description))
            truths = []
            for times in TIMES:
                large, _ = program.render(path, times * SIZE, "--samples", SAMPLES)
                truths.append(large.reshape(SIZE, times, SIZE, times, 3).mean(axis=(1, 3)))
            cells = []
            for option, errors in ("--target-error", (0.01, 0.002)), ("--adaptive", (0.05, 0.02, 0.01)):
                for error in errors:
                    more = ["--samples", 4096] if option == "--adaptive" else []
                    picture, _ = program.render(path, SIZE, option, error, *more)
                    cells.append(f"{rmse(picture, *truths) / error:.2f}")
            print(f"| {title} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
