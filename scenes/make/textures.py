#!/usr/bin/env python3
"""Draws every picture in ../textures. Needs numpy and Pillow; the same seeds give the same pictures.

    python3 scenes/make/textures.py            # all of them
    python3 scenes/make/textures.py globe sand # some
"""
import sys
from pathlib import Path

import numpy as np
from PIL import Image

OUT = Path(__file__).resolve().parent.parent / "textures"


# ---------------------------------------------------------------- tools

def colour(text):
    """'#rrggbb' as three floats in [0, 1]."""
    return np.array([int(text[i:i + 2], 16) / 255 for i in (1, 3, 5)])


def ramp(x, stops):
    """Piecewise linear colour ramp: stops are (position, '#rrggbb')."""
    at = [s[0] for s in stops]
    colours = np.array([colour(s[1]) for s in stops])
    return np.stack([np.interp(x, at, colours[:, c]) for c in range(3)], axis=-1)


def smooth(lo, hi, x):
    t = np.clip((x - lo) / (hi - lo), 0, 1)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    t = np.asarray(t)[..., None]
    return np.asarray(a) * (1 - t) + np.asarray(b) * t


def grid(width, height):
    """Texel centres: u to the right, v up, both in (0, 1)."""
    u, v = np.meshgrid((np.arange(width) + .5) / width, 1 - (np.arange(height) + .5) / height)
    return u, v


def noise(x, y, seed, period=None):
    """Value noise in [0, 1] on the unit lattice; with a period it tiles in x and y."""
    table = np.random.default_rng(seed).random((256, 256))
    xi, yi = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = smooth(0, 1, x - xi), smooth(0, 1, y - yi)
    px, py = period or (256, 256)

    def at(i, j):
        return table[(i % px) % 256, (j % py) % 256]

    low = at(xi, yi) * (1 - fx) + at(xi + 1, yi) * fx
    high = at(xi, yi + 1) * (1 - fx) + at(xi + 1, yi + 1) * fx
    return low * (1 - fy) + high * fy


def fractal(x, y, seed, octaves=4, period=None):
    total, weight, sum_ = 1., 1., 0.
    total = np.zeros(np.broadcast(x, y).shape)
    for k in range(octaves):
        p = None if period is None else (period[0] << k, period[1] << k)
        total += weight * noise(x * 2**k, y * 2**k, seed + k, p)
        sum_ += weight
        weight /= 2
    return total / sum_


def save(name, pixels, colours=None, dither=False):
    """As PNG; with a number of colours as a palette, which keeps noisy pictures small; dithered, gradients stay smooth."""
    image = Image.fromarray(np.rint(np.clip(pixels, 0, 1) * 255).astype(np.uint8), "RGB")
    if colours:
        palette = image.quantize(colours, method=Image.Quantize.MEDIANCUT)
        image = image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG if dither else Image.Dither.NONE)
    path = OUT / f"{name}.png"
    image.save(path, optimize=True)
    print(f"{path.name}: {image.width} x {image.height}, {path.stat().st_size / 1024:.0f} KiB")


# ---------------------------------------------------------------- the dusk of lantern_lake

SUN = np.array([-.30, .070, -1.])
SUN = SUN / np.linalg.norm(SUN)


def dusk(direction, detail):
    """The evening sky in a direction (unit vectors, y up): low sun, bands of cloud, first stars."""
    x, y, z = direction[..., 0], direction[..., 1], direction[..., 2]
    up = np.degrees(np.arcsin(np.clip(y, -1, 1)))
    towards = np.degrees(np.arccos(np.clip(direction @ SUN, -1, 1)))
    sky = ramp(up, [(-5, "#f58a4a"), (0, "#fca45c"), (4, "#f9855a"), (9, "#d9606b"), (16, "#94487a"),
                    (26, "#4e3a78"), (40, "#26295c"), (90, "#0c1233")])
    away = ramp(up, [(-5, "#6a4a7a"), (0, "#7a5582"), (6, "#6b4a80"), (16, "#443a73"), (30, "#26295c"), (90, "#0c1233")])
    sky = mix(sky, away, smooth(15, 95, towards))
    sky = sky + (colour("#ffb060") * .55) * np.exp(-(towards / 7.5) ** 1.3)[..., None]
    if detail:
        azimuth = np.degrees(np.arctan2(x, -z))
        band = fractal(azimuth / 14 + .02 * up, up / 1.9 + .35 * np.sin(azimuth / 17), 71, 5)
        cloud = smooth(.52, .72, band) * smooth(1.5, 5, up) * (1 - smooth(17, 27, up))
        lit = ramp(towards, [(0, "#fff0c0"), (10, "#ffc486"), (22, "#f2837a"), (40, "#a35a8c"), (60, "#5e4a86")])
        sky = mix(sky, lit, .75 * cloud)
        sky = mix(sky, colour("#fff6d8") + 0 * sky, smooth(2.35, 2.05, towards))
    return np.clip(sky, 0, 1)


def sky_dusk():
    """On a slab 1 unit away: x from -1.2 to 1.2, y from -.05 to .75."""
    width, height = 960, 320
    u, v = grid(width, height)
    d = np.stack([-1.2 + 2.4 * u, -.05 + .8 * v, -np.ones_like(u)], axis=-1)
    pixels = dusk(d / np.linalg.norm(d, axis=-1, keepdims=True), True)
    random = np.random.default_rng(5)
    for _ in range(230):
        sx, sy = random.integers(width), int(random.random() ** 1.6 * height * .72)
        bright = (.25 + .75 * random.random() ** 3) * (1 - sy / (height * .75))
        pixels[sy, sx] = np.maximum(pixels[sy, sx], pixels[sy, sx] + bright * np.array([.9, .92, 1.]))
    save("sky_dusk", pixels)


def dome_dusk():
    """The same sky all around, for a sphere whose pole z points up and whose u = 0 points to +x."""
    u, v = grid(256, 256)
    polar = np.pi * (1 - v)
    around = 2 * np.pi * u
    d = np.stack([np.sin(polar) * np.cos(around), np.cos(polar), -np.sin(polar) * np.sin(around)], axis=-1)
    save("dome_dusk", dusk(d, False))


def ridge():
    """Colours of a mountain by height (v) and by patch (u)."""
    u, v = grid(64, 64)
    height = v + .10 * (noise(u * 16, v * 10, 3) - .5)
    pixels = ramp(height, [(0, "#141d32"), (.14, "#28304e"), (.36, "#5a4672"), (.56, "#9a6484"), (.68, "#d08c90"),
                           (.82, "#f2c2b0"), (1, "#ffe9dc")])
    save("ridge", pixels * (.85 + .15 * noise(u * 32, v * 32, 9))[..., None], 64)


# ---------------------------------------------------------------- materials

def planks():
    """Old boards, the grain along u; 4 boards to the tile."""
    u, v = grid(256, 256)
    board = np.floor(v * 4)
    shade = np.random.default_rng(17).random(4)[board.astype(int)]
    grain = fractal(u * 6 + board * 13, v * 64, 21, 3)
    knots = fractal(u * 5 + board * 7, v * 16, 33, 3)
    wood = ramp(.45 * grain + .3 * knots + .25 * shade,
                [(.2, "#4a3020"), (.45, "#80573a"), (.6, "#a37550"), (.85, "#c79b70")])
    seam = smooth(.0, .035, np.minimum(v * 4 % 1, 1 - v * 4 % 1))
    save("planks", wood * (.35 + .65 * seam)[..., None], 48)


MAKERS = [sky_dusk, dome_dusk, ridge, planks]

if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    wanted = sys.argv[1:]
    for maker in MAKERS:
        if not wanted or maker.__name__ in wanted:
            maker()
