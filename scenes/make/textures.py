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
    total, weight, sum_ = np.zeros(np.broadcast(x, y).shape), 1., 0.
    for k in range(octaves):
        p = None if period is None else (period[0] << k, period[1] << k)
        total += weight * noise(x * 2**k, y * 2**k, seed + k, p)
        sum_ += weight
        weight /= 2
    return total / sum_


def save(name, pixels, colours=None):
    """As PNG; with a number of colours as a palette, which keeps noisy pictures small."""
    image = Image.fromarray(np.rint(np.clip(pixels, 0, 1) * 255).astype(np.uint8), "RGB")
    if colours:
        image = image.quantize(colours, method=Image.Quantize.MEDIANCUT)
        assert max(image.getdata()) < len(image.getpalette()) // 3  # no texel beyond the palette
    path = OUT / f"{name}.png"
    image.save(path, optimize=True)
    print(f"{path.name}: {image.width} x {image.height}, {path.stat().st_size / 1024:.0f} KiB")


# ---------------------------------------------------------------- the dusk of lantern_lake

# As in lantern_lake.json: the lights that the sky is lit by, the sun's behind the ball that is seen, and the
# moon's. Their colours add up to 1, so that the sky is as drawn.
SUN_AT, SUN_COLOR = np.array([-95.1, 10.9, -305.4]), np.array([.92, .91, .87])
MOON_AT, MOON_COLOR = np.array([60., 130., 60.]), np.array([.08, .09, .13])
SKY_DIFFUSE = 1.6  # the slab's color_diffuse
DOME_AMBIENT = np.array([.045, .07, .195])  # what no shadow takes from the sky around
SUN = np.array([-.303, .029, -1.])  # where the ball of the sun is seen
SUN = SUN / np.linalg.norm(SUN)


def dusk(direction, detail):
    """The evening sky in a direction (unit vectors, y up): the glow around a low sun, bands of cloud."""
    x, y, z = direction[..., 0], direction[..., 1], direction[..., 2]
    up = np.degrees(np.arcsin(np.clip(y, -1, 1)))
    towards = np.degrees(np.arccos(np.clip(direction @ SUN, -1, 1)))
    sky = ramp(up, [(-5, "#f58a4a"), (0, "#fba257"), (3.5, "#f98a55"), (8, "#dc6468"), (14, "#9a4a7b"),
                    (22, "#5a3c7c"), (34, "#2b2a63"), (90, "#0c1233")])
    away = ramp(up,
                [(-5, "#6a4a7a"), (0, "#b8607f"), (6, "#8a4f86"), (14, "#54407c"), (28, "#26295c"),
                 (90, "#0c1233")])
    sky = mix(sky, away, smooth(12, 85, towards))
    sky = sky + (colour("#ff8a50") * .42) * np.exp(-(towards / 7.5) ** 1.3)[..., None]
    sky = sky + (colour("#ffa068") * .45) * np.exp(-(np.maximum(0, towards - 1.8) / 2.2))[..., None]
    if detail:
        azimuth = np.degrees(np.arctan2(x, -z))
        bent = up + .5 * np.sin(azimuth / 15) + .35 * np.sin(azimuth / 6.1 + 1)
        wide = fractal(azimuth / 15 + .12 * bent + 3, bent / 3.4, 71, 3)
        fine = fractal(azimuth / 3.2 + .3 * bent, bent / .62, 91, 4)
        band = .64 * wide + .36 * fine
        cloud = smooth(.48, .68, band) * smooth(2.2, 6,
                                                up) * (1 - smooth(16, 23,
                                                                  up)) * (1 - smooth(36, 41, np.abs(azimuth)))
        lit = ramp(towards,
                   [(0, "#ffe3b0"), (8, "#ffb886"), (18, "#ff9490"), (32, "#e2749f"), (50, "#9a62a8")])
        dark = ramp(towards, [(0, "#f08a58"), (12, "#c2586a"), (30, "#6d4079"), (50, "#40336c")])
        lower = fractal(azimuth / 15 + .12 * (bent - .45) + 3, (bent - .45) / 3.4, 71, 3) * .64 + .36 * fine
        face = smooth(-.025, .035, lower - wide * .64 - .36 * fine)  # bright below, where the sun shines from
        sky = mix(sky, dark + (lit - dark) * (1 - face)[..., None], .72 * cloud)
    return np.clip(sky, 0, 1.5)


def sky_dusk():
    """On a slab 1 unit away: x from -.9 to .9, y from -.02 to .52; brighter where the lights meet it less
    squarely."""
    width, height = 1640, 492
    u, v = grid(width, height)
    d = np.stack([-.9 + 1.8 * u, -.02 + .54 * v, -np.ones_like(u)], axis=-1)
    pixels = dusk(d / np.linalg.norm(d, axis=-1, keepdims=True), True)
    random = np.random.default_rng(5)
    x, y = np.meshgrid(np.arange(-4, 5), np.arange(-4, 5))
    for _ in range(320):  # stars: round, most of them faint, more and brighter towards the top
        sx, sy = 5 + random.random() * (width - 10), 5 + random.random() ** 1.7 * height * .6
        bright, size = random.random() ** 3, .62 + .35 * random.random() ** 4
        i, j = round(sx), round(sy)
        spot = np.exp(-((x + i - sx) ** 2 + (y + j - sy) ** 2) / (2 * size ** 2))
        fade = (.16 + .84 * bright) * max(0, 1 - sy / (height * .62)) ** .8
        tint = colour("#dfe6ff") if random.random() < .75 else colour("#ffe6cc")
        pixels[j - 4:j + 5, i - 4:i + 5] += fade * spot[..., None] * tint
    lit = 0.
    for at, light in ((SUN_AT, SUN_COLOR), (MOON_AT, MOON_COLOR)):
        to = at - d * 19999
        lit = lit + (to[..., 2] / np.linalg.norm(to, axis=-1))[..., None] * light
    save("sky_dusk", pixels / lit / SKY_DIFFUSE)


def dome_dusk():
    """The same sky all around, for a sphere whose pole z points up and whose u = 0 points to +x."""
    u, v = grid(256, 256)
    polar = np.pi * (1 - v)
    around = 2 * np.pi * u
    d = np.stack([np.sin(polar) * np.cos(around), np.cos(polar), -np.sin(polar) * np.sin(around)], axis=-1)
    save("dome_dusk", dusk(d, False) - DOME_AMBIENT)


def ridge():
    """Colours of a mountain by height (v) and by patch (u)."""
    u, v = grid(64, 64)
    height = v + .10 * (noise(u * 16, v * 10, 3) - .5)
    pixels = ramp(height,
                  [(0, "#141d32"), (.14, "#28304e"), (.36, "#5a4672"), (.56, "#9a6484"), (.68, "#d08c90"),
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


def checker():
    """Two by two texels: the cheapest checkerboard."""
    light, dark = colour("#f4efe6"), colour("#5f6f86")
    save("checker", np.array([[light, dark], [dark, light]]))


def stripes():
    """Upright stripes of a curtain, soft folds in them."""
    u, v = grid(64, 2)
    folds = .86 + .14 * np.cos(2 * np.pi * 4 * u)
    bands = np.where((u * 2 % 1)[..., None] < .5, colour("#f1e3cb"), colour("#c65f4b"))
    save("stripes", bands * folds[..., None])


def sand():
    """Ripples and grains; tiles both ways."""
    u, v = grid(320, 320)
    ripple = .5 + .5 * np.sin(2 * np.pi * (6 * v + 1.1 * fractal(u * 4, v * 4, 41, 2, (4, 4))))
    grain = np.random.default_rng(43).random(u.shape)
    save("sand", ramp(.62 * ripple + .38 * grain, [(0, "#b99b6b"), (.5, "#dcc294"), (1, "#f7e7c4")]), 24)


def globe():
    """A planet to wrap a sphere: seas, coasts, deserts, poles and a grid every 30 degrees."""
    u, v = grid(512, 256)
    longitude, latitude = 2 * np.pi * u, np.pi * (v - .5)
    x, y, z = np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)
    land = (fractal(x * 1.7 + 7, y * 1.7 + 3 + z, 101, 5) +
            fractal(z * 1.7 + 9 + x, x * 1.7 + 5 - y, 131, 5)) / 2
    land = land + .03 * np.sin(3 * longitude)
    sea = ramp(land, [(.3, "#123a66"), (.46, "#1f6a96"), (.5, "#4fb0bd")])
    dry = np.abs(latitude) / (np.pi / 2) + .5 * (fractal(x * 5, y * 5 + z * 3, 151, 3) - .5)
    soil = ramp(dry, [(0, "#3d8b46"), (.25, "#d9b565"), (.45, "#6fa04b"), (.7, "#7d8f63"), (.85, "#e8eef0")])
    pixels = np.where((land > .505)[..., None], soil, sea)
    pixels = mix(pixels, colour("#f5fafc") + 0 * pixels,
                 smooth(.80, .84, np.abs(latitude) / (np.pi / 2) + .1 * (land - .5)))
    lines = np.minimum(np.abs((u * 12 + .5) % 1 - .5) / 12 * 512,
                       np.abs((v * 6 + .5) % 1 - .5) / 6 * 256) < .55
    save("globe", mix(pixels, colour("#fff3d0") + 0 * pixels, .45 * lines), 64)


def crate():
    """A wooden box: boards in a frame with a brace across."""
    u, v = grid(192, 192)
    edge = np.minimum(np.minimum(u, 1 - u), np.minimum(v, 1 - v))
    frame = edge < .13
    brace = ~frame & (np.abs(u - v) < .09)
    along = np.where(frame & (np.minimum(u, 1 - u) < np.minimum(v, 1 - v)), v, u)
    across = np.where(frame & (np.minimum(u, 1 - u) < np.minimum(v, 1 - v)), u, v)
    along, across = np.where(brace, u + v, along), np.where(brace, u - v, across)
    grain = fractal(along * 5 + 3 * brace, across * 40, 201, 3)
    wood = ramp(grain, [(.2, "#7a4d28"), (.5, "#b07a42"), (.8, "#d6a566")])
    wood = wood * np.where(frame | brace, 1.1, .82)[..., None]
    gap = np.where(~frame & ~brace & ((v * 5.4 + .1) % 1 < .05), .4, 1)
    rim = np.where((np.abs(edge - .13) < .008) | (~frame & (np.abs(np.abs(u - v) - .09) < .008)) |
                   (edge < .012), .45, 1)
    nail = np.min([np.hypot(u - a, v - b) for a in (.065, .935) for b in (.065, .5, .935)], axis=0) < .014
    save("crate", np.where(nail[..., None], colour("#3a3a40"), wood * (gap * rim)[..., None]), 48)


def label():
    """The paper around a tin: bands above and below, a sun with rays in the middle, twice around."""
    u, v = grid(384, 128)
    a, b = (u * 2 % 1 - .5) * 3.2, v - .5
    r, angle = np.hypot(a, b), np.arctan2(b, a)
    pixels = mix(colour("#f6ead2"), colour("#efe0bf"), (u * 96 % 1 < .5) * .6)
    rays = (np.sin(angle * 12) > 0) & (r < .36)
    pixels = np.where(rays[..., None], colour("#e9a23b"), pixels)
    pixels = np.where((r < .22)[..., None], colour("#d9492f"), pixels)
    pixels = np.where((r < .17)[..., None], colour("#f2b63c"), pixels)
    for low, high, c in ((0, .09, "#2b6e6b"), (.09, .115, "#e9a23b"), (.885, .91, "#e9a23b"),
                         (.91, 1, "#2b6e6b")):
        pixels = np.where(((v >= low) & (v < high))[..., None], colour(c), pixels)
    save("label", pixels, 32)


def spiral():
    """Helical stripes for a cone or a cylinder, stars between them."""
    u, v = grid(256, 128)
    turn = (u * 3 + v * 2) % 1
    pixels = np.where((turn < .5)[..., None], colour("#7a2f8c"), colour("#f3c64a"))
    pixels = np.where(((turn > .46) & (turn < .54) | (turn < .04) | (turn > .96))[..., None],
                      colour("#fbf3e0"), pixels)
    save("spiral", pixels)


def mosaic():
    """Floor tiles, 4 x 4 to the picture: stone in two tones, a small square at the corners."""
    u, v = grid(256, 256)
    i, j = np.floor(u * 4), np.floor(v * 4)
    a, b = u * 4 % 1, v * 4 % 1
    tone = (i + j) % 2
    shade = .92 + .08 * fractal(u * 16, v * 16, 301, 3, (16, 16))
    base = np.where(tone[..., None] > 0, colour("#cdbfa6"), colour("#8fa3a0")) * shade[..., None]
    corner = np.minimum(a, 1 - a) + np.minimum(b, 1 - b) < .22
    pixels = np.where(corner[..., None], colour("#a4553f") * shade[..., None], base)
    grout = (np.minimum(np.minimum(a, 1 - a), np.minimum(b, 1 - b)) < .018)
    save("mosaic", np.where(grout[..., None], colour("#5c5a55"), pixels), 48)


def rosette():
    """A round floor of glazed tiles, for the cap of a cylinder: rings of stars, petals and diamonds around a
    sun."""
    u, v = grid(768, 768)
    x, y = u * 2 - 1, v * 2 - 1
    r, turn = np.hypot(x, y), np.arctan2(y, x) / (2 * np.pi)
    ink, cream, teal, blue = colour("#18284a"), colour("#f3e6c8"), colour("#1f8a8c"), colour("#2a57a5")
    amber, brick, rose = colour("#eda63a"), colour("#b9472f"), colour("#d98a80")
    pixels = np.broadcast_to(cream, u.shape + (3,)).copy()

    def paint(where, c):
        pixels[where] = c

    def ring(low, high, count, half=0):
        """Along a ring of tiles: where it is, across and along in its tile from -1 to 1, and the tile's
        number."""
        t = turn * count + half
        return (r >= low) & (r < high), (t % 1 - .5) * 2, (r -
                                                           low) / (high - low) * 2 - 1, np.floor(t) % count

    def band(low, high, c):
        paint((r >= low) & (r < high), c)

    inside, a, b, k = ring(0, .13, 16)
    paint(inside, brick)
    paint(inside & (r < .05 + .07 * (1 - np.abs(a))), amber)
    inside, a, b, k = ring(.14, .27, 16)
    paint(inside, blue)
    paint(inside & (np.abs(a) + np.abs(b) < .95), cream)
    paint(inside & (np.abs(a) + np.abs(b) < .5), amber)
    band(.27, .29, ink)
    inside, a, b, k = ring(.30, .46, 16, .5)
    paint(inside, teal)
    paint(inside & (a ** 2 + ((b + 1) / 2) ** 2 * 1.0 < .8), cream)           # petals
    paint(inside & (a ** 2 + ((b + 1) / 2) ** 2 * 1.3 < .5), rose)
    paint(inside & (a ** 2 + ((b + 1) / 2) ** 2 * 1.6 < .22), brick)
    band(.46, .48, ink)
    inside, a, b, k = ring(.49, .64, 32)
    paint(inside, np.array(cream))
    paint(inside & (k % 2 == 0), blue)
    star = np.maximum(np.abs(a), np.abs(b)) < .62
    star |= np.abs(a) + np.abs(b) < .88
    paint(inside & star & (k % 2 == 0), cream)
    paint(inside & star & (k % 2 == 1), brick)
    paint(inside & (np.hypot(a, b) < .32), amber)
    band(.64, .66, ink)
    inside, a, b, k = ring(.67, .80, 48)
    paint(inside, teal)
    paint(inside & (np.abs(a) < (1 - b) / 2), cream)
    paint(inside & (np.abs(a) < (1 - b) / 2 - .35), amber)
    inside, a, b, k = ring(.81, .94, 48)
    paint(inside, brick)
    paint(inside & (np.abs(a) + np.abs(b) < .9), rose)
    paint(inside & (np.abs(a) + np.abs(b) < .45), ink)
    band(.95, 1.5, ink)
    save("rosette", pixels, 16)


def sky_studio():
    """A backdrop by height, for the inside of a sphere whose pole z points up: a glow low down, night
    above."""
    u, v = grid(2, 1024)
    save("sky_studio",
         ramp((v - .5) * 180,
              [(-90, "#4a2a55"), (-50, "#b5607a"), (-30, "#f2a981"), (-22, "#ee9478"), (-12, "#b8658a"),
               (-2, "#6b4a96"), (8, "#3b3f8a"), (25, "#3a64b0"), (50, "#5f9fd6"), (90, "#2a4f9a")]))


def glaze():
    """Around a torus: tiles of blue glaze with a flower in each; repeats 12 by 4."""
    u, v = grid(384, 128)
    a, b = (u * 12 % 1 - .5) * 2, (v * 4 % 1 - .5) * 2
    r, angle = np.hypot(a, b), np.arctan2(b, a)
    pixels = np.ones(u.shape + (3,)) * colour("#f2f5f2")
    pixels = np.where((r < .55 + .3 * np.cos(4 * angle))[..., None], colour("#2b62b5"), pixels)
    pixels = np.where((r < .24)[..., None], colour("#f0b13a"), pixels)
    edge = np.maximum(np.abs(a), np.abs(b)) > .93
    save("glaze", np.where(edge[..., None], colour("#173b78"), pixels), 16)


def shell():
    """Along a shell (u: mouth to tip, v: around it): growth lines and tiger bands."""
    u, v = grid(512, 128)
    wave = .012 * np.sin(2 * np.pi * v * 2) + .02 * fractal(u * 30, v * 4, 401, 3, (30, 4))
    bands = smooth(.45, .6,
                   fractal((u + wave) * 34, v * 6, 411, 3, (34, 6))) * smooth(.02, .10, v) * smooth(1, .8, v)
    base = ramp(fractal(u * 8, v * 3, 421, 2, (8, 3)), [(.2, "#f6e3c8"), (.8, "#fff7ea")])
    pixels = mix(base, ramp(u, [(0, "#b3552f"), (.6, "#96402c"), (1, "#5d2a2c")]), .92 * bands)
    lines = .93 + .07 * np.sin(2 * np.pi * 150 * (u + .3 * wave))
    pixels = pixels * lines[..., None]
    pixels[:, 0] = colour("#f0b7a0")  # the lid of the mouth looks up u = 0
    save("shell", pixels, 48)


def sky_day():
    """Only a gradient by height, for the inside of a sphere whose pole z points up."""
    u, v = grid(2, 1024)
    save("sky_day",
         ramp((v - .5) * 180,
              [(-90, "#cfe3ea"), (0, "#dceef2"), (6, "#bfe2f0"), (20, "#86c3e6"), (45, "#4a93d2"),
               (90, "#2a62ab")]))


def clouds():
    """A fair day's sky above the sea, heaps of cloud along the horizon, for an upright slab 2.8 times as wide
    as high."""
    u, v = grid(810, 288)
    x, y = u * 4.5, v * 1.6
    sky = ramp(y, [(0, "#e9f1ee"), (.12, "#cfe6ef"), (.45, "#8cc4ea"), (1, "#4f95d6"), (1.6, "#2f6fb8")])
    base = .15 + .10 * noise(x * .9 + 5, 0 * x, 501)

    def density(x, y):
        heap = fractal(x * 1.15 + 3.3, 0 * y, 521, 2)  # where the clouds stand
        above = y - base
        puff = fractal(x * 2.6 + 2, y * 3.4, 511, 5)
        return puff + 1.25 * (heap - .50) - 1.15 * np.maximum(0,
                                                              above - .04) ** .8 - .10 - 5 * np.maximum(
                                                                  0, .02 - above)

    cover = density(x, y)
    thick = smooth(.20, .34, cover)
    lit = density(x - .04, y + .05)  # less cloud towards the sun: brighter
    body = ramp(smooth(-.14, .16, cover - lit) * .75 + .25 * smooth(0, .25, y - base),
                [(0, "#b4c2d3"), (.35, "#dfe3e8"), (.7, "#fdf6ea"), (1, "#fffdf6")])
    veil = smooth(.5, .8, fractal(x * 1.3 + .8 * y, y * 7, 531, 5)) * smooth(.45, .8, y)
    sky = mix(sky, colour("#f2f6fa") + 0 * sky, .45 * veil)
    save("clouds", mix(sky, body, .95 * thick), 128)


def skin():
    """Of a starfish (u around, five arms; v from the middle to the edge): pale knobs in rows."""
    u, v = grid(320, 64)
    arm = (u * 5 + .5) % 1 - .5
    base = ramp(v + .25 * (fractal(u * 40, v * 8, 541, 3) - .5),
                [(0, "#c4452a"), (.5, "#e06a34"), (1, "#f2a35e")])
    dots = np.zeros(u.shape, bool)
    for row, gap in ((0, .09), (.10, .11), (-.10, .11), (.21, .13), (-.21, .13)):
        along = (v / gap + abs(row) * 5) % 1 - .5
        dots |= np.hypot((arm - row) / (.032 + .02 * v), along * gap / .035) < 1
    save("skin", np.where((dots & (v > .04))[..., None], colour("#ffe9c4"), base), 32)


def fan():
    """Of a scallop (u across its 13 ribs, v from the hinge to the rim): bands of growth, a paler groove
    between the ribs."""
    u, v = grid(416, 128)
    rib = .5 + .5 * np.cos(2 * np.pi * 13 * u)
    wave = v + .03 * (fractal(u * 26, v * 3, 551, 3) - .5) + .012 * rib
    pixels = ramp(wave,
                  [(0, "#fff0dc"), (.25, "#f7c9a4"), (.40, "#e98b6c"), (.47, "#f6c3a2"), (.60, "#d9655a"),
                   (.68, "#f3b39c"),
                   (.80, "#b9415a"), (.87, "#eaa09a"), (.96, "#8f2f52"), (1, "#f6dcd0")])
    save("fan", mix(pixels, colour("#fff3e4") + 0 * pixels, .5 * (1 - rib) ** 2), 48)


def dots():
    """Rows of dots on yellow, small at the poles and large at the waist, for a sphere."""
    u, v = grid(512, 256)
    dark = np.zeros(u.shape, bool)
    for rib in range(12):
        for k in range(11):
            at = (k + .5 + .5 * (rib % 2)) / 11
            radius = (.030 if rib % 2 else .044) * np.sin(np.pi * min(at, 1)) ** .8
            across = ((u - (rib + .5) / 12 + .5) % 1 - .5) * 2 * np.sin(np.pi * v)
            dark |= np.hypot(across, v - at) < radius
    ribs = .80 + .20 * np.abs(np.sin(np.pi * 12 * u)) ** .5
    pixels = np.where(dark[..., None], colour("#17130f"), colour("#f7c51d") * ribs[..., None])
    save("dots", pixels, 64)


MAKERS = [sky_dusk, dome_dusk, ridge, planks, checker, stripes, sand, globe, crate, label, spiral, mosaic,
          rosette, glaze, shell, sky_day, sky_studio, clouds, skin, fan, dots]

if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    wanted = sys.argv[1:]
    for maker in MAKERS:
        if not wanted or maker.__name__ in wanted:
            maker()
