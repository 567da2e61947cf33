#!/usr/bin/env python3
"""check_schema.py RAYTRACER [N]: scenes/scene.schema.json and `raytracer --strict` give the same verdict.

Run it from the source folder. It tests all of scenes/, test/good/ and test/bad/, and a scene with all keys
that is damaged in every small way, or in every N-th. In test/bad/, both must reject schema/; only the loader
can reject semantic/ (names, files, inverses, duplicate keys); syntax/ is not JSON. Without Python's
jsonschema the exit status is 77 (CTest: skipped).
"""
import copy
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: Python has no jsonschema")
    sys.exit(77)

SCHEMA = json.loads(pathlib.Path("scenes/scene.schema.json").read_text(encoding="utf-8"))
jsonschema.Draft7Validator.check_schema(SCHEMA)
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)

# How the loader begins what a schema cannot know.
SEMANTIC = ("no material named", "no transform named", "no texture named", "is taken by",
            "expected a transform that has an inverse", "expected a number other than film_",
            "expected another direction than look's", "in \"", "no file ",
            "expected each key once", "expected a finite number")

# How advice on a scene begins that is in order otherwise, and none of the schema's business.
ADVICE = ("look and up distort", "so unseen but for its shadow: move it",
          "hidden inside of ",
          "all black: ", "the picture is mirrored", "the picture is upside down",
          "no diffuse_texture names it", "not shown without", "the mesh has no vt", "a negative color")

# The advice that is due to good scenes: what is said of them is meant, or is what they are for.
UNUSED = (":10:51: /textures/never used, so never decoded: no diffuse_texture names it: "
          "name it, or delete it\n")
DUE = {
    "camera_test2.json":
    ":4:15: /camera: look and up distort: lengths 1, 1.25 at 90°, not 1, 1 at 90°\n",
    "byte_order_mark.json": UNUSED,
    "defaults.json": UNUSED,
    "mirrored_film.json":
    ":4:22: /camera/film_left: the picture is mirrored: swap it with film_right\n",
    "least.json": ": all black: the scene has no shapes: add one to \"shapes\"\n",
    "rotated_unlike_scales.json":
    ": the scene's numbers lie too far apart for --precision double: computed in extended\n",
}

problems = []


def refuse_constant(name):
    raise ValueError(name + " is no JSON")


def parse(path):
    value = json.loads(path.read_text(encoding="utf-8-sig"), parse_constant=refuse_constant)
    json.dumps(value, ensure_ascii=False).encode()  # half a surrogate pair is a ValueError, but only here
    return value


def complaint(raytracer, scene, pixels=1):
    """What is said about the scene, or None if it is liked; no picture may come of one that is not."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "x.png")
        done = subprocess.run(
            [raytracer, "--strict", "--quiet", "--threads", "1", str(scene), str(out), str(pixels)],
            capture_output=True)
        error = done.stderr.decode()
        if done.returncode not in (0, 2) or (done.returncode == 0) != out.exists() or error.count("\n") > 25:
            problems.append(f"{scene}: exit status {done.returncode}, stderr: {error}")
        return error if done.returncode else None


def first_line(text):
    """--strict tells all faults, and a mistake of syntax shows its line."""
    return text and text.split("\n")[0] + "\n"


def expect(scene, what, expected, found):
    if expected != found:
        problems.append(f"{scene}: {what}: expected {expected!r}, found {found!r}")


def check_good(raytracer, scene):
    expect(scene, "the schema accepts", True, VALIDATOR.is_valid(parse(scene)))
    due = DUE.get(scene.name)
    enough = 16  # pixels: a single one of a good picture may well be black
    expect(scene, "advice", str(scene) + due if due else None,
           first_line(complaint(raytracer, scene, enough)))


def check_bad(raytracer, scene):
    expect(scene, "the loader", scene.with_suffix(".txt").read_text(encoding="utf-8"),
           first_line(complaint(raytracer, scene)))
    if scene.parent.name != "syntax":
        expect(scene, "the schema accepts", scene.parent.name == "semantic", VALIDATOR.is_valid(parse(scene)))
        return
    try:
        parse(scene)
        problems.append(f"{scene}: Python's parser likes it")
    except ValueError:
        pass


def places(value, path=()):
    """The paths of a JSON value and all in it."""
    yield path
    if isinstance(value, (dict, list)):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from places(value[key], path + (key,))


def damages(scene):
    """The scene with each value in turn left out, doubled, or replaced by one of another kind or at a
    limit."""
    for path in places(scene):
        for change in ("leave out", "double", None, True, False, 0, -1, 1, 0.5, "x", "", [], {}, [0, 0, 0],
                       [1, 1, 1]):
            damaged = copy.deepcopy(scene)
            if not path:
                yield change if not isinstance(change, str) else [change]
                continue
            parent = damaged
            for key in path[:-1]:
                parent = parent[key]
            if change == "leave out":
                del parent[path[-1]]
            elif change == "double" and isinstance(parent, list):
                parent.append(parent[path[-1]])
            elif change == "double":
                parent[path[-1] + "s"] = parent[path[-1]]
            else:
                parent[path[-1]] = change
            yield damaged


def check_damages(raytracer, scene, step):
    """Both verdicts on each of them; the loader's, if it is not about form, must come where the schema has
    none."""
    with tempfile.TemporaryDirectory(dir=scene.parent) as folder:
        path = pathlib.Path(folder, "damaged.json")
        for damaged in itertools.islice(damages(parse(scene)), 0, None, step):
            text = json.dumps(damaged).replace('"../', '"../../')  # it lies one folder deeper
            path.write_text(text, encoding="utf-8")
            error = complaint(raytracer, path)
            accepted = all(any(words in line for words in SEMANTIC + ADVICE)
                           for line in (error or "").splitlines())
            if accepted != VALIDATOR.is_valid(json.loads(text)):
                problems.append(f"the schema has another verdict than {error!r} on {text}")


def main():
    raytracer = sys.argv[1]
    scenes = sorted(path for path in pathlib.Path("scenes").glob("*.json")
                    if path.name != "scene.schema.json")
    for scene in scenes:
        expect(scene, "$schema", "scene.schema.json", parse(scene).get("$schema"))
    good = scenes + sorted(pathlib.Path("test/good").glob("*.json"))
    bad = sorted(pathlib.Path("test/bad").glob("*/*.json"))
    for scene in good:
        check_good(raytracer, scene)
    for scene in bad:
        check_bad(raytracer, scene)
    check_damages(raytracer, pathlib.Path("test/good/every_key.json"),
                  int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    print("\n".join(problems[:50]) or f"{len(good)} good and {len(bad)} bad scenes: the same verdict")
    return 1 if problems else 0


sys.exit(main())
