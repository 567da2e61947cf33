#!/usr/bin/env python3
"""Tests random scenes with extreme numbers: each render ends soon, with status 0, 1 or 2, and its picture is
finite.

    extremes_check.py RAYTRACER [--first 0] [--count 160] [--seed 1] [--keep FOLDER]

Two kinds of scenes take turns. In the first kind, some numbers of a scene become 0, -0, subnormal, or 1e+-100
to 1e+-308, and so may the options. The picture must be finite. In each precision it must be the same to the
bit with every instruction set, and without the tree. The pictures in double and in extended must be the same,
unless the program says of extended, too, that its picture may be wrong, or rounding decides what is seen.
In a pixel rounding does if a change of the scene's last bits makes of extended's colour that of double. (If
it makes any other colour, both may be wrong.) In the second kind, a scene is written in other units, by
powers of two that reach to the ends of double's range: of its meshes, its camera, its world, its planes and
axes. The picture must have the same bytes in each precision.
"""
import argparse
import array
import copy
import json
import math
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
from resource import RLIMIT_CPU, setrlimit

TOP = pathlib.Path(__file__).resolve().parent.parent.parent
SCENES = ["cone_cube", "spheres_cylinder", "refraction", "refraction_inside", "nested_glass",
          "orthographic_test1",
          "orthographic_test2", "camera_test1", "camera_test2", "extreme_scale", "texture", "mirror_corridor",
          "checker_horizon", "stress_test"]
OCTAHEDRON = ([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]],
              [[1, 3, 5], [3, 2, 5], [2, 4, 5], [4, 1, 5], [3, 1, 6], [2, 3, 6], [4, 2, 6], [1, 4, 6]])
EDGE, SECONDS = 12, 10
DIFFERENT = 8 / 255  # a channel of a pixel that is not the same
NUDGE = 1e-13  # of a number: some hundreds of units in its last place
NO_REFERENCE = "too far apart for any precision"  # what the program says
NUDGES = 16  # of a scene; one of them turns a direction to a certain side with a chance of a quarter


def numbers_of(node, path=()):
    """The places of the numbers, as paths. Not of those that must be 1 or 0: a matrix's last row, a point's
    fourth."""
    if isinstance(node, (dict, list)):
        for key, child in node.items() if isinstance(node, dict) else enumerate(node):
            if key != 3 or not isinstance(node, list) or path[-1] in ("shapes", "materials", "lights",
                                                                      "transforms"):
                yield from numbers_of(child, (*path, key))
    elif isinstance(node, (int, float)) and not isinstance(node, bool):
        yield path


def put(node, path, value):
    for key in path[:-1]:
        node = node[key]
    node[path[-1]] = value


def get(node, path):
    for key in path:
        node = node[key]
    return node


def extreme(dice):
    kind = dice.random()
    sign = dice.choice([1, -1])
    if kind < 0.1:
        return sign * 0.0
    if kind < 0.2:
        return sign * dice.choice([5e-324, dice.random() * 2e-308])
    if kind < 0.85:
        return sign * min((1 + 8 * dice.random()) * 10.0 ** (dice.choice([1, -1]) * dice.randint(100, 308)),
                          1.7e308)
    return sign * 10.0 ** dice.randint(-99, 99)


def write_obj(path, points, faces):
    lines = ["v %r %r %r" % tuple(map(float, point)) for point in points]
    path.write_text("\n".join(lines + ["f %d %d %d" % tuple(face) for face in faces]) + "\n")


def base_scene(dice):
    """A scene of the project, with a mesh of eight triangles beside it; where its numbers may be edited."""
    scene = json.loads((TOP / "scenes" / (dice.choice(SCENES) + ".json")).read_text())
    scene["textures"] = {name: str(TOP / "scenes" / path) for name, path in scene.get("textures", {}).items()}
    if dice.random() < 0.4:
        shape = dice.choice(scene["shapes"])
        shape["type"], shape["path"] = "mesh", "mesh.obj"
    for shape in scene["shapes"]:
        if shape["type"] == "mesh":
            shape["path"] = "mesh.obj"
    if len(scene["shapes"]) > 40:
        scene["shapes"] = dice.sample(scene["shapes"], 40)
    return scene


def options_of(dice, scene):
    doubling = any(m.get("reflective") and m.get("refractive") for m in scene["materials"])
    options = ["--threads", str(dice.randint(1, 3))]
    if dice.random() < 0.6:
        options += ["--max-recursion", str(dice.randint(0, 6 if doubling else 60))]
    if dice.random() < 0.4:
        options += ["--precision", dice.choice(["float", "extended"])]
    if dice.random() < 0.3:
        options += ["--texture-filter", "bilinear"]
    if dice.random() < 0.2:
        options += ["--pass", dice.choice(["raycast", "normals"])]
    if dice.random() < 0.2:
        options += ["--only",
                    ",".join(dice.sample(["ambient", "diffuse", "specular", "shadows", "reflections",
                                          "refraction"], 3))]
    if dice.random() < 0.1:
        options += ["--opaque"]
    if dice.random() < 0.8:
        options += ["--quiet"]
    kind = dice.random()
    if kind < 0.2:
        options += ["--samples", str(dice.randint(2, 4)), "--adaptive",
                    repr(abs(extreme(dice)) if dice.random() < 0.5 else 0.1)]
    elif kind < 0.3:
        options += ["--cutoff", repr(abs(extreme(dice)) if dice.random() < 0.5 else 0.01)]
    elif kind < 0.35 and "--max-recursion" not in options:
        options += ["--target-error", repr(dice.choice([0.3, 0.05]))]
    return options


class Failure(Exception):
    pass


class Folder:
    def __init__(self, raytracer, path):
        self.raytracer, self.path, self.said = raytracer, path, ""

    def save(self, scene, points):
        (self.path / "scene.json").write_text(json.dumps(scene))
        write_obj(self.path / "mesh.obj", points, OCTAHEDRON[1])

    def run(self, arguments, simd=None, seconds=SECONDS):
        environment = {name: value for name, value in os.environ.items() if name != "RAYTRACER_SIMD"}
        if simd:
            environment["RAYTRACER_SIMD"] = simd
        try:  # of CPU: with other work beside it a render may take several times as long
            done = subprocess.run([self.raytracer, *arguments], cwd=self.path, env=environment,
                                  timeout=10 * seconds, capture_output=True, text=True,
                                  preexec_fn=lambda: setrlimit(RLIMIT_CPU, (seconds, seconds)))
        except subprocess.TimeoutExpired:
            raise Failure(f"still waits after {10 * seconds} s") from None
        if done.returncode in (-signal.SIGKILL, -signal.SIGXCPU):
            raise Failure(f"still runs after {seconds} s of CPU")
        if done.returncode not in (0, 1, 2):
            raise Failure(f"status {done.returncode}: {done.stderr[-300:]}")
        return done

    def read_picture(self):
        """The header of the PFM, and its numbers."""
        *head, numbers = (self.path / "o.pfm").read_bytes().split(b"\n", 3)
        return b"\n".join(head) + b"\n", array.array("f", numbers)

    def picture(self, options=(), simd=None):
        """The PFM's numbers, or None where the scene is refused."""
        out = self.path / "o.pfm"
        out.unlink(missing_ok=True)
        done = self.run(["scene.json", "o.pfm", str(EDGE), *options], simd)
        self.said = done.stderr
        if done.returncode == 2:
            if out.exists() or not done.stderr:
                raise Failure("refused without a word, or with a picture")
            # Of no file, no option, no instruction set: an exception that nobody expected.
            if re.search("^raytracer: (?!--|RAYTRACER_SIMD)", done.stderr, re.M):
                raise Failure(f"refused by chance: {done.stderr[-300:]}")
            return None
        _, numbers = self.read_picture()
        if not all(map(math.isfinite, numbers)):
            raise Failure(
                f"{sum(not math.isfinite(x) for x in numbers)} of {len(numbers)} numbers are not finite")
        return numbers


def differing(a, b):
    """The numbers of the pixels that differ, as a PNG shows them."""
    def clamped(x):
        return min(max(x, 0), 1)
    return {i // 3 for i in range(0, len(a), 3)
            if any(abs(clamped(a[i + c]) - clamped(b[i + c])) > DIFFERENT for c in range(3))}


def share_differing(a, b):
    return len(differing(a, b)) / (len(a) // 3)


def explain(folder, dice):
    """explain's numbers are finite, too: as JSON others are null."""
    pixel = ["explain", "scene.json", str(dice.randrange(EDGE)), "0", str(EDGE), "--quiet"]
    for arguments in (pixel, [*pixel, "--json"]):
        if found := re.search(r"\b(nan|inf|null)\b", folder.run(arguments).stdout):
            raise Failure(f"{' '.join(arguments)} says {found[0]}")


def suspect(folder):
    """A wrong picture is told from the right one: the mistakes that explain tries make scenes that the loader
    would refuse."""
    head, numbers = folder.read_picture()
    wrong = array.array("f", (1 - min(max(x, 0), 1) for x in numbers))
    (folder.path / "wrong.pfm").write_bytes(head + wrong.tobytes())
    done = folder.run(["explain", "scene.json", "--picture", "wrong.pfm", "--quiet"], seconds=10 * SECONDS)
    if done.returncode != 1:
        raise Failure(f"explain --picture ends with status {done.returncode}: {done.stderr[-300:]}")


def nudged(dice, scene):
    """The scene, or points, with some last bits of their numbers changed."""
    other = copy.deepcopy(scene)
    for path in numbers_of(other):
        if dice.random() < 0.5 and path[-1] != "shininess":
            put(other, path, get(other, path) * (1 + dice.uniform(-NUDGE, NUDGE)))
    return other


def check_extreme(dice, folder):
    scene = base_scene(dice)
    points = [list(map(float, p)) for p in OCTAHEDRON[0]]
    places = list(numbers_of(scene))
    for path in dice.sample(places, min(len(places), dice.choice([1, 1, 2, 3, 5, 8, len(places) // 4]))):
        put(scene, path, extreme(dice))
    if dice.random() < 0.3:
        unit = abs(extreme(dice)) or 1
        points = [[max(min(x * unit, 1.7e308), -1.7e308) for x in p] for p in points]
    for _ in range(dice.choice([0, 0, 1, 3])):
        points[dice.randrange(6)][dice.randrange(3)] = extreme(dice)
    folder.save(scene, points)
    options = options_of(dice, scene)
    folder.settings = " ".join(options)
    picture = folder.picture(options, dice.choice([None, None, "scalar", "sse2", "avx2", "avx512"]))
    if picture is None:
        return "refused"
    if dice.random() < 0.2:
        explain(folder, dice)
        if len(scene["shapes"]) <= 8:  # the search takes long where the numbers need extended
            suspect(folder)
    way = dice.choice(["precision", "tree", "scalar", "sse2", "finite"])
    if "--target-error" in options or way == "finite":
        return "finite"
    if way != "precision":
        other = folder.picture([*options, "--accelerator", "none"] if way == "tree" else options,
                               None if way == "tree" else way)
        if other != picture:
            raise Failure(f"by {way} {share_differing(picture, other):.0%} of the pixels differ")
        return f"the same by {way}"
    return compare(dice, folder, scene, points,
                   [o for o in options if o not in ("float", "extended", "--precision")])


def compare(dice, folder, scene, points, options):
    in_extended = [*(o for o in options if o != "--quiet"), "--precision", "extended"]
    double, extended = folder.picture(options), folder.picture(in_extended)
    wrong = differing(double, extended)
    if not wrong:
        return "as extended has it"
    if NO_REFERENCE in folder.said:
        return "without a reference"
    count = len(wrong)
    for _ in range(NUDGES):  # what differs may be a matter of rounding
        folder.save(nudged(dice, scene), nudged(dice, {"transforms": points})["transforms"])
        nudge = folder.picture(in_extended)
        wrong = wrong & differing(nudge, double) if nudge else wrong
        if not wrong:
            return "a matter of rounding"
    folder.save(scene, points)
    raise Failure(f"{count} pixels differ from extended's, {len(wrong)} of them not by rounding")


def scale_all(node, keys, exponent):
    for key in keys:
        if key in node:
            node[key] = [math.ldexp(x, exponent)
                         for x in node[key]] if isinstance(node[key],
                                                           list) else math.ldexp(node[key], exponent)


def scale_shape(transform, exponent):
    scale = transform.get("scale", [1, 1, 1])
    transform["scale"] = [math.ldexp(x, exponent) for x in scale]


def own_transforms(scene):
    """Each shape gets a transform of its own, as its name is its index."""
    named = {transform["name"]: transform for transform in scene["transforms"]}
    scene["transforms"] = []
    for i, shape in enumerate(scene["shapes"]):
        scene["transforms"].append({**copy.deepcopy(named[shape["transform"]]), "name": str(i)})
        shape["transform"] = str(i)


def check_units(dice, folder):
    scene = base_scene(dice)
    own_transforms(scene)
    camera = scene["camera"]
    points = [list(map(float, p)) for p in OCTAHEDRON[0]]
    precision = ["--precision", dice.choice(["float", "double", "extended"])]
    folder.save(scene, points)
    folder.settings = " ".join(precision)
    plain = folder.picture([*precision, "--quiet"])

    def power(most=800):
        return dice.choice([0, dice.randint(-most, most)])
    mesh, film, frame, world = power(), power(400), power(400), power(500)
    points = [[math.ldexp(x, mesh) for x in p] for p in points]
    scale_all(camera, ["up"], film)
    scale_all(camera, ["film_left", "film_right", "film_bottom", "film_top"], -film)
    if camera["type"] == "perspective":
        scale_all(camera, ["film_left", "film_right", "film_bottom", "film_top", "focal_length"], frame)
    else:
        scale_all(camera, ["film_left", "film_right", "film_bottom", "film_top"], world)
    scale_all(camera, ["eye"], world)
    for light in scene["lights"]:
        light["position"] = [math.ldexp(x, world) for x in light["position"][:3]]
    for shape, transform in zip(scene["shapes"], scene["transforms"]):
        scale_all(transform, ["translate"], world)
        if "rotate" in transform:
            scale_all(transform["rotate"], ["axis"], power())
        inner = -mesh if shape["type"] == "mesh" else 0
        outer = min(max(power(400), inner - 900), inner + 900)  # of the scale, which a matrix takes back
        scale_shape(transform, world + outer)
        matrix = transform.get("matrix", [[float(i == j) for i in range(4)] for j in range(4)])
        transform["matrix"] = [[math.ldexp(x, inner - outer) for x in column[:3]] + [0]
                               for column in matrix[:3]] + [
            [math.ldexp(x, -outer) for x in matrix[3][:3]] + [1]]
    folder.save(scene, points)
    folder.settings += f"; mesh 2^{mesh}, film 2^{film}, frame 2^{frame}, world 2^{world}"
    other = folder.picture([*precision, "--quiet"])
    if plain != other:
        raise Failure("in other units: " + ("refused" if other is None else
                                            f"{share_differing(plain, other):.0%} of the pixels differ"))
    return "the same in other units"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("raytracer", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=0, help="the number of the first scene")
    parser.add_argument("--count", type=int, default=160)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the scenes that fail")
    arguments = parser.parse_args()
    tally, failures = {}, 0
    for number in range(arguments.first, arguments.first + arguments.count):
        dice = random.Random(f"{arguments.seed} {number}")
        with tempfile.TemporaryDirectory() as temporary:
            folder = Folder(arguments.raytracer.resolve(), pathlib.Path(temporary))
            try:
                outcome = check_units(dice, folder) if number % 4 == 3 else check_extreme(dice, folder)
                tally[outcome] = tally.get(outcome, 0) + 1
            except Failure as failure:
                failures += 1
                print(f"scene {number} of seed {arguments.seed}, {folder.settings}: {failure}", flush=True)
                if arguments.keep:
                    kept = arguments.keep / f"{arguments.seed}-{number}"
                    kept.mkdir(parents=True, exist_ok=True)
                    for file in folder.path.iterdir():
                        (kept / file.name).write_bytes(file.read_bytes())
    print(f"{failures} of {arguments.count} scenes failed; " +
          ", ".join(f"{n} {what}" for what, n in sorted(tally.items())))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
