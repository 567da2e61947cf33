#!/usr/bin/env python3
"""Writes every OBJ in ../meshes. Needs numpy; the same seeds give the same meshes.

    python3 scenes/make/meshes.py        # all of them
    python3 scenes/make/meshes.py shell  # some
"""
import sys
from pathlib import Path

import numpy as np

OUT = Path(__file__).resolve().parent.parent / "meshes"


def number(x, digits):
    text = f"{x:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-0") else text


def save(name, comment, positions, texcoords, faces, digits=4):
    """Faces: lists of (position, texcoord), from 0, counter-clockwise seen from outside."""
    lines = [f"# {comment}", "# made by scenes/make/meshes.py"]
    lines += ["v " + " ".join(number(c, digits) for c in p) for p in positions]
    lines += ["vt " + " ".join(number(c, 4) for c in t) for t in texcoords]
    lines += ["f " + " ".join(f"{p + 1}/{t + 1}" for p, t in face) for face in faces]
    path = OUT / f"{name}.obj"
    path.write_text("\n".join(lines) + "\n")
    triangles = sum(len(face) - 2 for face in faces)
    print(f"{path.name}: {triangles} triangles, {path.stat().st_size / 1024:.0f} KiB")


def quads(columns, rows):
    """Corners (i, j) of the quads of a grid, anticlockwise for i to the right and j up."""
    for i in range(columns):
        for j in range(rows):
            yield (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)


def mountains():
    """A low-poly range in x from -1 to 1, z from -.25 (far) to .25 (near), a saddle left of the middle;
    closed below."""
    random = np.random.default_rng(12)
    columns, rows = 64, 14
    x = np.linspace(-1, 1, columns + 1)
    z = np.linspace(-.25, .25, rows + 1)
    height = np.zeros((rows + 1, columns + 1))
    peaks = [(-.86, .0, .30, .17), (-.62, .03, .21, .13), (-.05, -.02, .20, .12), (.13, .02, .31, .13),
             (.33, -.04, .24, .12), (.52, .04, .34, .15), (.74, -.03, .25, .14), (.93, .02, .30, .13),
             (-.40, -.06, .09, .12)]
    for px, pz, tall, wide in peaks:
        d = np.hypot((x[None, :] - px) / wide, (z[:, None] - pz) / .17)
        height = np.maximum(height, tall * np.clip(1 - d, 0, None) ** 1.15)
    envelope = np.clip(1 - (np.abs(z) / .25) ** 3, 0, 1)[:, None]
    height = (height + .05 * random.random(height.shape) + .035 * np.sin(9 * x)[None, :] ** 2) * envelope
    xx = np.broadcast_to(x, height.shape) + (random.random(height.shape) - .5) * .018
    zz = np.broadcast_to(z[:, None], height.shape) + (random.random(height.shape) - .5) * .02
    positions = np.stack([xx, height - .01, zz], axis=-1).reshape(-1, 3)
    texcoords, faces = [], []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            corners = [a, a + columns + 1, a + columns + 2, a + 1]
            split = [(0, 1, 2), (0, 2, 3)] if (i + j) % 2 else [(0, 1, 3), (1, 2, 3)]
            for triangle in split:
                p = [corners[k] for k in triangle]
                # one colour to a facet: all its corners look up the same texel
                at = np.mean([positions[q][1] for q in p]) / .36
                texcoords.append((random.random(), min(.995, max(.005, at))))
                faces.append([(q, len(texcoords) - 1) for q in p])
    save("mountains", "a low-poly mountain range", positions, texcoords, faces)


def ridged(x, z, seed, octaves=5):
    """Noise with sharp crests, from 0 to 1: where waves of random directions cross their zero, a crest."""
    random = np.random.default_rng(seed)
    total, weight, frequency = 0., .5, 1.
    for _ in range(octaves):
        waves = 0.
        for _ in range(3):
            angle, phase = random.random(2) * 2 * np.pi
            waves = waves + np.sin(frequency * (x * np.cos(angle) + z * np.sin(angle)) * 7 + phase)
        total = total + weight * (1 - np.minimum(1, np.abs(waves) / 1.6))
        weight, frequency = weight * .48, frequency * 2.03
    return total


def sierra():
    """A range in x from -1 to 1, z from -.25 (far) to .25 (near), a saddle left of the middle; its feet lie
    below y = 0."""
    random = np.random.default_rng(12)
    columns, rows = 150, 20
    x = np.linspace(-1, 1, columns + 1)
    z = np.linspace(-.25, .25, rows + 1)
    xx = x[None, :] + (random.random((rows + 1, columns + 1)) - .5) * .008
    zz = z[:, None] + (random.random((rows + 1, columns + 1)) - .5) * .015
    peaks = [(-.86, .0, .27, .19), (-.62, .03, .19, .13), (-.05, -.02, .20, .13), (.13, .02, .27, .15),
             (.33, -.04, .20, .13), (.52, .04, .32, .17), (.74, -.03, .22, .15), (.93, .02, .28, .14),
             (-.40, -.06, .07, .12)]
    height = np.zeros_like(xx)
    for px, pz, tall, wide in peaks:
        d = np.hypot((xx - px) / wide, (zz - pz) / .21)
        height = np.maximum(height, tall * np.clip(1 - d, 0, None) ** 1.1)
    crests = ridged(xx, zz * 1.6, 3)
    height = height * (.62 + .55 * crests) + .055 * crests ** 2 + .01
    shore = .25 - .05 * ridged(xx * 1.3, xx * 0, 8, 3)  # how near the water's edge comes
    foot = np.clip((shore - np.abs(zz)) / .16, -1, 1)
    height = np.where(foot > 0, height * (1 - (1 - foot) ** 2), .3 * foot) - .004
    positions = np.stack([xx, height, zz], axis=-1).reshape(-1, 3)
    texcoords, faces = [], []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            corners = [a, a + columns + 1, a + columns + 2, a + 1]
            split = [(0, 1, 2), (0, 2, 3)] if (i + j) % 2 else [(0, 1, 3), (1, 2, 3)]
            for triangle in split:
                p = [corners[k] for k in triangle]
                if max(positions[q][1] for q in p) < -.01:
                    continue  # under water
                # one colour to a facet: all its corners look up the same texel
                at = np.mean([positions[q][1] for q in p]) / .36
                texcoords.append((random.random(), min(.995, max(.005, at))))
                faces.append([(q, len(texcoords) - 1) for q in p])
    used = sorted({q for face in faces for q, _ in face})
    index = {q: i for i, q in enumerate(used)}
    faces = [[(index[q], t) for q, t in face] for face in faces]
    save("sierra", "a mountain range above a lake", positions[used], texcoords, faces)


def sheet(at, columns, rows, positions, texcoords, faces, turned=False):
    """Adds the quads of a surface at(s, t), s and t from 0 to 1; a quad of no area becomes a triangle or
    nothing."""
    first, seen = len(texcoords), {}
    index = []
    for i in range(columns + 1):
        for j in range(rows + 1):
            p = tuple(np.round(at(i / columns, j / rows), 4))
            if p not in seen:
                seen[p] = len(positions)
                positions.append(p)
            index.append(seen[p])
            texcoords.append((i / columns, j / rows))
    for corners in quads(columns, rows):
        face = []
        for i, j in corners:
            k = i * (rows + 1) + j
            if index[k] not in [q for q, _ in face]:
                face.append((index[k], first + k))
        if len(face) > 2:
            faces.append(face[::-1] if turned else face)


def hull():
    """A small sailing boat's hull with its deck, from stern (x = -1) to bow (x = 1), the water at y = 0."""
    def half(x):  # of the beam
        return .27 * np.clip(1 - ((x + .25) / (1.25 if x > -.25 else 1.5)) ** 2, 0, 1) ** .75

    def side(sign):
        def at(s, t):
            x = -1 + 2 * s
            gunwale = .17 + .15 * s ** 2.5 + .05 * (1 - s) ** 2
            y = -.12 + (gunwale + .12) * t
            return x + .22 * t * s ** 3 - .10 * t * (1 - s) ** 3, y, sign * half(x) * (.45 + .55 * t ** .6)
        return at

    def deck(s, t):
        port, starboard = np.array(side(-1)(s, .8)), np.array(side(1)(s, .8))
        return port + (starboard - port) * t

    def stern(s, t):
        port, starboard = np.array(side(-1)(0, t)), np.array(side(1)(0, t))
        return port + (starboard - port) * s

    positions, texcoords, faces = [], [], []
    sheet(side(1), 28, 7, positions, texcoords, faces)
    sheet(side(-1), 28, 7, positions, texcoords, faces, True)
    sheet(deck, 28, 2, positions, texcoords, faces, True)
    sheet(stern, 2, 7, positions, texcoords, faces, False)
    save("hull", "a sailing boat's hull", positions, texcoords, faces)


def sails():
    """Mainsail and jib for the hull, whose mast stands at x = .15; thin, filled by a wind from z < 0; v is
    the height."""
    def main(s, t):
        leech = .08 * np.sin(np.pi * t ** .8)
        return .13 - s * (.98 * (1 - t) +
                          leech), .42 + 1.75 * t + .03 * s, .20 * np.sin(np.pi * s ** .8) * (1 - t) ** .6

    def jib(s, t):
        luff = np.array((1.0 - .83 * t, .33 + 1.55 * t, 0))
        leech = np.array((.25 - .08 * t, .40 + 1.48 * t, .10 * (1 - t)))
        return luff + (leech - luff) * s + np.array((0, 0, .13 * np.sin(np.pi * s) * (1 - t) ** .6))

    positions, texcoords, faces = [], [], []
    sheet(main, 8, 14, positions, texcoords, faces, True)
    sheet(jib, 6, 12, positions, texcoords, faces, True)
    save("sails", "mainsail and jib", positions, texcoords, faces)


def shade():
    """A lamp's shade, a bell open below: its rim of radius 1 at z = 0, a knob on top at z = 1."""
    profile = [(1, 0), (.97, .07), (.86, .16), (.66, .29), (.44, .46), (.27, .64), (.16, .78), (.10, .86),
               (.13, .90), (.13, .95), (.08, .99), (0, 1)]
    steps = len(profile) - 1

    def at(s, t):
        r, z = profile[round(t * steps)]
        return r * np.cos(2 * np.pi * s), r * np.sin(2 * np.pi * s), z

    positions, texcoords, faces = [], [], []
    sheet(at, 48, steps, positions, texcoords, faces)
    save("shade", "a lamp shade", positions, texcoords, faces)


def torus():
    """Radii .7 and .3 around z; u along the ring, v around the tube."""
    ring, tube = 64, 24
    positions, texcoords, faces = [], [], []
    for i in range(ring):
        for j in range(tube):
            a, b = 2 * np.pi * i / ring, 2 * np.pi * j / tube
            r = .7 + .3 * np.cos(b)
            positions.append((r * np.cos(a), r * np.sin(a), .3 * np.sin(b)))
    for i in range(ring + 1):
        for j in range(tube + 1):
            texcoords.append((i / ring, j / tube))
    for corners in quads(ring, tube):
        faces.append([(i % ring * tube + j % tube, i * (tube + 1) + j) for i, j in corners])
    save("torus", "a torus", positions, texcoords, faces)


def shell():
    """A sea snail: a tube around a conical spiral, axis z up, about 1 unit tall; u along the spiral, v around
    the tube."""
    steps, tube, turns = 220, 30, 5.2
    positions, texcoords, faces = [], [], []
    for i in range(steps + 1):
        t = i / steps
        angle = 2 * np.pi * turns * t
        grow = .055 ** t                       # each turn is a copy of the last, smaller
        for j in range(tube + 1):
            b = 2 * np.pi * j / tube
            flute = 1 + .05 * np.cos(22 * np.pi * turns * t) * (np.cos(b) > -.2)
            out = grow * (.30 + .30 * flute * np.cos(b))
            up = 1.02 - grow * (.84 - .36 * flute * np.sin(b) - .10 * np.cos(b))
            if j < tube:
                positions.append((out * np.cos(angle), out * np.sin(angle), up))
            texcoords.append((t, j / tube))
    for (i, j), (k, _), _, (_, m) in quads(steps, tube):
        loop = [(i, j), (k, j), (k, m), (i, m)]
        faces.append([(a * tube + b % tube, a * (tube + 1) + b) for a, b in loop])
    for ring, order in ((0, 1), (steps, -1)):  # lids at the mouth and at the tip
        positions.append(np.mean(positions[ring * tube:(ring + 1) * tube], axis=0))
        texcoords.append((ring / steps, .5))
        for j in range(tube):
            pair = [(ring * tube + (j + 1) % tube, ring * (tube + 1) + j + 1),
                    (ring * tube + j, ring * (tube + 1) + j)][::order]
            faces.append([(len(positions) - 1, len(texcoords) - 1)] + pair)
    save("shell", "a sea snail's shell", positions, texcoords, faces)


def starfish():
    """Five arms, lying on z = 0, an arm's tip 1 from the middle; u around, v from the middle to the edge."""
    def at(s, t):
        arm = (.5 + .5 * np.cos(5 * 2 * np.pi * s)) ** 1.5
        reach = .34 + .66 * arm
        curl = 2 * np.pi * s + .16 * t * t * arm * np.sin(2 * np.pi * s + 1)
        knobs = .016 * np.cos(22 * t) * arm ** 6 * (t > .12)
        height = (.17 - .06 * t *
                  arm) * (1 - t ** 2.5) ** .5 * (1 - .25 * (1 - arm) * min(1, 2 * t)) + knobs * (1 - t)
        return reach * t * np.cos(curl), reach * t * np.sin(curl), height

    positions, texcoords, faces = [], [], []
    sheet(at, 120, 12, positions, texcoords, faces, True)
    save("starfish", "a starfish", positions, texcoords, faces)


def scallop():
    """A fan of ribs in y > 0, hinged at the origin, bulging to z > 0; u across the ribs, v from the hinge to
    the rim."""
    def at(s, t):
        across = (s - .5) * np.radians(150)
        rib = np.cos(2 * np.pi * 13 * s)
        reach = t * (1 - .10 * np.sin(across) ** 2 + .012 * rib)
        bulge = .34 * np.sin(np.pi * np.clip(.06 + .94 * t, 0,
                                             1) ** .75) ** .8 * np.cos(across * .95) + .022 * rib * t
        return reach * np.sin(across), reach * np.cos(across), bulge

    def ears(s, t):
        return (s - .5) * .62, .20 * t - .03, .04 + .05 * t * (1 - abs(2 * s - 1))

    positions, texcoords, faces = [], [], []
    sheet(at, 104, 16, positions, texcoords, faces, True)
    texcoords_before = len(texcoords)
    sheet(ears, 8, 2, positions, texcoords, faces)
    texcoords[texcoords_before:] = [(u, .1) for u, _ in texcoords[texcoords_before:]]
    save("scallop", "a scallop's shell", positions, texcoords, faces)


MAKERS = [mountains, sierra, hull, sails, shade, torus, shell, starfish, scallop]

if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    wanted = sys.argv[1:]
    for maker in MAKERS:
        if not wanted or maker.__name__ in wanted:
            maker()
