#!/usr/bin/python3
"""Generates scenes for measurements: the same bytes on every machine and in every call.

    bench/generate.py spheres N OUT.json      N random spheres over a plane, two lights, a fifth of the
                                              spheres mirrors
    bench/generate.py mesh TRIANGLES OUT.json a displaced sphere of about as many triangles, with OUT.obj
                                              beside it
"""
import argparse
import json
import pathlib
import random

import numpy

SEED = 2024


def material(name, diffuse, **others):
    """Ambient of diffuse's hue and grey highlights: all that every one of the programs can say."""
    return {"name": name, "color_ambient": [round(0.1 * channel, 3) for channel in diffuse],
            "color_diffuse": diffuse, "color_specular": [0.3, 0.3, 0.3],
            "shininess": 20, "reflective": False, "refractive": False} | others


def scene(materials, transforms, shapes, focal_length):
    """A camera that looks down at a plane, and two lights above it."""
    tilt = 0.43
    return {
        "camera": {"type": "perspective", "focal_length": focal_length, "eye": [0, 4, 9],
                   "look": [0, -float(numpy.sin(tilt)), -float(numpy.cos(tilt))],
                   "up": [0, float(numpy.cos(tilt)), -float(numpy.sin(tilt))],
                   "film_left": -1, "film_right": 1, "film_bottom": -1, "film_top": 1},
        "lights": [{"position": [6, 12, 8, 1], "color": [0.7, 0.7, 0.7], "color_ambient": [1, 1, 1]},
                   {"position": [-9, 8, 3, 1], "color": [0.4, 0.4, 0.4], "color_ambient": [0, 0, 0]}],
        "materials": [material("ground", [0.5, 0.5, 0.45])] + materials,
        "transforms": [{"name": "ground", "translate": [0, -2, 0],
                        "rotate": {"degrees": -90, "axis": [1, 0, 0]}}] + transforms,
        "shapes": [{"type": "plane", "transform": "ground", "material": "ground"}] + shapes,
    }


def spheres(count):
    """Radii such that the spheres fill a constant share of the box: the picture stays as busy whatever their
    number."""
    dice = random.Random(SEED)
    colors = [[0.8, 0.2, 0.2], [0.2, 0.7, 0.3], [0.2, 0.3, 0.8], [0.8, 0.7, 0.2]]
    materials = [material(f"matt{i}", color) for i, color in enumerate(colors)]
    materials.append(material("mirror", [0.1, 0.1, 0.1], reflective=True, color_reflect=[0.8, 0.8, 0.8]))
    largest = 1.6 * count ** (-1 / 3)
    transforms, shapes = [], []
    for i in range(count):
        radius = round(largest * dice.uniform(0.3, 1), 7)
        place = [round(dice.uniform(*side), 6) for side in ((-4, 4), (-2, 2), (-5, 3))]
        transforms.append({"name": f"s{i}", "translate": place, "scale": [radius] * 3})
        shapes.append({"type": "sphere", "transform": f"s{i}",
                       "material": "mirror" if i % 5 == 4 else f"matt{i % 5}"})
    return scene(materials, transforms, shapes, 1.6)


def displaced_sphere(triangles):
    """(points, faces): rows x 2 rows quads split in two, closed, with waves and a little noise on the
    radius."""
    rows = max(3, round((triangles / 4) ** 0.5))
    columns = 2 * rows
    polar = numpy.linspace(0, numpy.pi, rows + 2)[1:-1, None]
    around = numpy.linspace(0, 2 * numpy.pi, columns, endpoint=False)[None, :]
    noise = numpy.random.RandomState(SEED).uniform(-1, 1, (rows, columns))
    radius = 1.6 + 0.15 * numpy.sin(5 * around) * numpy.sin(7 * polar) ** 2 + 0.3 / rows * noise
    points = numpy.stack([radius * numpy.sin(polar) * numpy.cos(around),
                          radius * numpy.cos(polar) + 0 * around,
                          radius * numpy.sin(polar) * numpy.sin(around)], axis=-1).reshape(-1, 3)
    i, j = (index.ravel() for index in numpy.mgrid[0:rows - 1, 0:columns])
    a, b = i * columns + j, i * columns + (j + 1) % columns
    quads = numpy.concatenate([numpy.stack([a, b, b + columns], 1),
                               numpy.stack([a, b + columns, a + columns], 1)], axis=1)
    north, south = rows * columns, rows * columns + 1
    edge = numpy.arange(columns)
    after = (edge + 1) % columns
    last = (rows - 1) * columns
    faces = numpy.concatenate([
        numpy.stack([after, edge, numpy.full(columns, north)], 1), quads.reshape(-1, 3),
        numpy.stack([last + edge, last + after, numpy.full(columns, south)], 1)])
    return numpy.concatenate([points, [[0, 1.6, 0], [0, -1.6, 0]]]), faces


def write_obj(path, points, faces):
    with open(path, "w") as out:
        out.writelines("v %.9g %.9g %.9g\n" % tuple(point) for point in points.tolist())
        out.writelines("f %d %d %d\n" % tuple(face) for face in (faces + 1).tolist())


def mesh(triangles, out_path):
    points, faces = displaced_sphere(triangles)
    write_obj(out_path.with_suffix(".obj"), points, faces)
    return scene([material("clay", [0.8, 0.5, 0.3])],
                 [{"name": "mesh", "rotate": {"degrees": 20, "axis": [1, 0, 0]}}],
                 [{"type": "mesh", "path": out_path.with_suffix(".obj").name, "transform": "mesh",
                   "material": "clay"}], 4)


def generate(kind, count, out_path):
    out_path = pathlib.Path(out_path)
    out_path.write_text(json.dumps(spheres(count) if kind == "spheres" else mesh(count, out_path),
                                   separators=(",", ":")))
    return out_path


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=["spheres", "mesh"])
    parser.add_argument("count", type=int)
    parser.add_argument("out")
    arguments = parser.parse_args()
    generate(arguments.kind, arguments.count, arguments.out)


if __name__ == "__main__":
    main()
