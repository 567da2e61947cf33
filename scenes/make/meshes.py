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


def mountains():
    """A low-poly range in x from -1 to 1, z from -.25 (far) to .25 (near), a saddle left of the middle; closed below."""
    random = np.random.default_rng(12)
    columns, rows = 64, 14
    x = np.linspace(-1, 1, columns + 1)
    z = np.linspace(-.25, .25, rows + 1)
    height = np.zeros((rows + 1, columns + 1))
    peaks = [(-.86, .0, .30, .17), (-.62, .03, .21, .13), (-.05, -.02, .20, .12), (.13, .02, .31, .13),
             (.33, -.04, .24, .12), (.52, .04, .34, .15), (.74, -.03, .25, .14), (.93, .02, .30, .13), (-.40, -.06, .09, .12)]
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


def quads(columns, rows):
    """Corners (i, j) of the quads of a grid, anticlockwise for i to the right and j up."""
    for i in range(columns):
        for j in range(rows):
            yield (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)


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
    """A sea snail: a tube around a conical spiral, axis z up, about 1 unit tall; u along the spiral, v around the tube."""
    steps, tube, turns = 150, 22, 5.2
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
            pair = [(ring * tube + (j + 1) % tube, ring * (tube + 1) + j + 1), (ring * tube + j, ring * (tube + 1) + j)][::order]
            faces.append([(len(positions) - 1, len(texcoords) - 1)] + pair)
    save("shell", "a sea snail's shell", positions, texcoords, faces)


MAKERS = [mountains, torus, shell]

if __name__ == "__main__":
    OUT.mkdir(exist_ok=True)
    wanted = sys.argv[1:]
    for maker in MAKERS:
        if not wanted or maker.__name__ in wanted:
            maker()
