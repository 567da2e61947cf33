#!/usr/bin/python3
"""Generates random scenes of every kind, to check a promise on scenes that nothing was tuned for.

    bench/random_scenes.py FOLDER --seed SEED [--count 8]

Writes the scenes 0, 1, ... as KIND_NUMBER.json into FOLDER. The kinds below take turns; each scene is
different. The same seed makes the same scenes.
"""
import argparse
import json
import math
import pathlib
import random

import numpy
import PIL.Image


class Maker:
    """One scene, put together."""

    def __init__(self, dice, folder, name):
        self.dice, self.folder, self.name = dice, folder, name
        self.textures, self.materials, self.transforms, self.shapes, self.lights = {}, [], [], [], []
        self.camera = {}

    def color(self, low=0.0, high=1.0):
        return [round(self.dice.uniform(low, high), 3) for _ in range(3)]

    def material(self, **others):
        diffuse = self.color(0.05, 0.95)
        ambient = self.dice.choice([0, 0.1, 0.3])
        specular = self.dice.choice([0, 0.3, 0.8])
        self.materials.append({"name": f"m{len(self.materials)}", "color_diffuse": diffuse,
                               "color_ambient": [round(ambient * channel, 3) for channel in diffuse],
                               "color_specular": [specular] * 3,
                               "shininess": self.dice.choice([5, 20, 100, 500]),
                               **others})
        return self.materials[-1]["name"]

    def mirror(self, low=0.2, high=0.95):
        return self.material(reflective=True, color_reflect=self.color(low, high))

    def glass(self):
        dark = self.dice.uniform(0, 0.2)
        return self.material(color_diffuse=[dark] * 3, reflective=self.dice.random() < 0.6,
                             color_reflect=self.color(0.05, 0.4),
                             refractive=True, color_refract=self.color(0.5, 0.98),
                             index_of_refraction=self.dice.uniform(1.05, 1.8))

    def texture(self):
        """Stripes, a checker, noise or dots, coarse or fine."""
        edge = self.dice.choice([16, 64, 256])
        y, x = numpy.mgrid[0:edge, 0:edge]
        period = self.dice.choice([2, 8, 16])
        a, b = (numpy.array(self.color()) * 255 for _ in range(2))
        noise = numpy.random.RandomState(self.dice.randrange(2**31)).uniform(size=(edge, edge))
        mask = self.dice.choice([x // period % 2, (x // period + y // period) % 2, noise,
                                 noise > 0.95])[..., None]
        name = f"t{len(self.textures)}"
        file = f"{self.name}_{name}.png"
        PIL.Image.fromarray((a * mask + b * (1 - mask)).astype(numpy.uint8)).save(self.folder / file)
        self.textures[name] = file
        return self.material(use_diffuse_texture=True, diffuse_texture=name)

    def add(self, kind, material, at=(0, 0, 0), scale=(1, 1, 1), turn=None, **others):
        transform = {"name": f"x{len(self.transforms)}", "translate": list(at), "scale": list(scale)}
        if turn is None:
            turn = (self.dice.uniform(0, 360), [self.dice.uniform(-1, 1) for _ in range(3)])
        transform["rotate"] = {"degrees": turn[0], "axis": list(turn[1])}
        self.transforms.append(transform)
        self.shapes.append({"type": kind, "transform": transform["name"], "material": material, **others})

    def solid(self):
        return self.dice.choice(["sphere", "cube", "cylinder", "cone"])

    def somewhere(self, size=2.0):
        return [self.dice.uniform(-size, size) for _ in range(3)]

    def floor(self, material=None):
        self.add("plane", material or self.material(), (0, -2, 0), turn=(-90, (1, 0, 0)),
                 scale=[self.dice.choice([0.5, 1, 3])] * 3)

    def light(self):
        """One to three lamps, near the eye or far above."""
        for _ in range(self.dice.choice([1, 1, 2, 3])):
            strength = self.dice.choice([0.5, 0.8, 1.2, 4])  # 4: much is brighter than white
            self.lights.append(
                {"position": [self.dice.uniform(-6, 6), self.dice.uniform(2, 9), self.dice.uniform(0, 9)],
                 "color": [round(strength * c, 3) for c in self.color(0.6, 1)],
                 "color_ambient": self.color(0.1, 0.6)})

    def look(self):
        """From some way off at the origin."""
        angle, height = self.dice.uniform(-0.8, 0.8), self.dice.uniform(-0.1, 0.5)
        far = self.dice.uniform(5, 8)
        eye = numpy.array([math.sin(angle) * math.cos(height), math.sin(height),
                           math.cos(angle) * math.cos(height)])
        right = numpy.cross([0, 1, 0], eye)
        right /= numpy.linalg.norm(right)
        short = self.dice.choice([1, 0.75, 0.6])
        half = self.dice.uniform(0.4, 0.6)
        self.camera = {"type": "perspective", "focal_length": 1, "eye": (far * eye).tolist(),
                       "look": (-eye).tolist(),
                       "up": numpy.cross(eye, right).tolist(), "film_left": -half, "film_right": half,
                       "film_bottom": -half * short, "film_top": half * short}
        if self.dice.random() < 0.2:
            self.camera |= {"type": "orthographic", "film_left": -3, "film_right": 3,
                            "film_bottom": -3 * short, "film_top": 3 * short}
            del self.camera["focal_length"]

    def write(self):
        self.light()
        self.look()
        scene = {"camera": self.camera, "materials": self.materials, "lights": self.lights,
                 "transforms": self.transforms, "shapes": self.shapes, "textures": self.textures}
        path = self.folder / f"{self.name}.json"
        path.write_text(json.dumps(scene))
        return path


def room(make):
    """As a course has them: a floor, perhaps walls, a few solids, one or two of them mirrors."""
    make.floor()
    if make.dice.random() < 0.5:
        make.add("plane", make.material(), (0, 0, -4), turn=(0, (1, 0, 0)))
    for _ in range(make.dice.randint(2, 6)):
        size = make.dice.uniform(0.3, 1)
        make.add(make.solid(), make.mirror() if make.dice.random() < 0.3 else make.material(),
                 make.somewhere(), [size] * 3)


def many(make):
    """Many small shapes."""
    if make.dice.random() < 0.5:
        make.floor()
    kinds = [make.material() for _ in range(5)] + [make.mirror()]
    count = int(10 ** make.dice.uniform(1.5, 3.3))
    for _ in range(count):
        size = 1.2 * count ** (-1 / 3) * make.dice.uniform(0.1, 1)
        make.add(make.solid(), make.dice.choice(kinds), make.somewhere(2.5), [size] * 3)


def textured(make):
    """Textures near and far."""
    make.floor(make.texture())
    for _ in range(make.dice.randint(1, 4)):
        make.add(make.solid(), make.texture(), make.somewhere(), [make.dice.uniform(0.4, 1.2)] * 3)


def glassy(make):
    """Glass in glass, before something to see."""
    make.floor(make.texture() if make.dice.random() < 0.5 else None)
    for _ in range(make.dice.randint(1, 3)):
        at, size = make.somewhere(1.2), make.dice.uniform(0.6, 1.3)
        for shell in range(make.dice.randint(1, 3)):
            make.add(make.solid() if shell == 0 else "sphere", make.glass(), at, [size * 0.6 ** shell] * 3)
        make.add("sphere", make.material(), at, [0.1] * 3)


def mirrors(make):
    """Mirrors that face each other, and solids between them."""
    for side in (-3, 3):
        make.add("plane", make.mirror(0.5, 0.95), (side, 0, 0), turn=(90, (0, 1, 0)))
    make.floor()
    for _ in range(make.dice.randint(1, 5)):
        make.add(make.solid(), make.mirror() if make.dice.random() < 0.5 else make.material(),
                 make.somewhere(1.5),
                 [make.dice.uniform(0.2, 0.8)] * 3)


def mesh(make):
    """A rough ball or a heap of triangles."""
    dice = numpy.random.RandomState(make.dice.randrange(2**31))
    file = f"{make.name}.obj"
    with open(make.folder / file, "w") as out:
        if make.dice.random() < 0.5:
            rows, columns = make.dice.randint(5, 40), make.dice.randint(6, 60)
            for i in range(rows + 1):
                for j in range(columns):
                    polar, around = math.pi * i / rows, 2 * math.pi * j / columns
                    r = 1.3 + 0.2 * dice.uniform(-1, 1)
                    out.write(f"v {r * math.sin(polar) * math.cos(around)} {r * math.cos(polar)} "
                              f"{r * math.sin(polar) * math.sin(around)}\n")
            for i in range(rows):
                for j in range(columns):
                    k = (j + 1) % columns
                    out.write("f %d %d %d\nf %d %d %d\n" % tuple(1 + n for n in (
                        i * columns + j, i * columns + k, (i + 1) * columns + k, i * columns + j,
                        (i + 1) * columns + k,
                        (i + 1) * columns + j)))
        else:
            for n in range(make.dice.randint(20, 1000)):
                corner = dice.uniform(-1.5, 1.5, 3)
                for _ in range(3):
                    out.write("v %g %g %g\n" % tuple(corner + dice.uniform(-0.3, 0.3, 3)))
                out.write("f -3 -2 -1\n")
    if make.dice.random() < 0.6:
        make.floor()
    make.add("mesh", make.mirror() if make.dice.random() < 0.2 else make.material(),
             scale=[make.dice.uniform(0.7, 1.3)] * 3, path=file)


def thin(make):
    """Wires, blades and plates thinner than a pixel."""
    if make.dice.random() < 0.7:
        make.floor()
    for _ in range(int(10 ** make.dice.uniform(0.5, 2.5))):
        width, length = 10 ** make.dice.uniform(-3, -1.5), make.dice.uniform(0.3, 2)
        if make.dice.random() < 0.7:
            make.add(make.dice.choice(["cylinder", "cone", "cube"]), make.material(), make.somewhere(),
                     (width, width, length))
        else:
            make.add("cube", make.material(), make.somewhere(), (length, length, width))


def empty(make):
    """A picture with next to nothing in it."""
    for _ in range(make.dice.choice([1, 1, 2, 10])):
        size = 10 ** make.dice.uniform(-2.3, -0.5)
        make.add(make.solid(), make.mirror() if make.dice.random() < 0.2 else make.material(),
                 make.somewhere(), [size] * 3)


KINDS = [room, many, textured, glassy, mirrors, mesh, thin, empty]


def generate(folder, seed, number):
    """The path of scene `number`."""
    kind = KINDS[number % len(KINDS)]
    make = Maker(random.Random(f"{seed} {number}"), pathlib.Path(folder), f"{kind.__name__}_{number}")
    kind(make)
    return make.write()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", required=True)
    parser.add_argument("--count", type=int, default=len(KINDS))
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for number in range(arguments.count):
        print(generate(arguments.folder, arguments.seed, number))


if __name__ == "__main__":
    main()
