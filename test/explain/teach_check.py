"""Tests what the commands add to advice and explanations: with --strict the exit status and no picture; valid
JSON.

Usage: teach_check.py RAYTRACER, from the source folder.
"""
import array
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

RAYTRACER = str(pathlib.Path(sys.argv[1]).resolve())
SCENE = json.loads(pathlib.Path("test/good/least.json").read_text(encoding="utf-8"))
failures = []


def check(what, expected, found):
    if expected != found:
        failures.append(f"{what}: expected {expected!r}, found {found!r}")


def run(folder, *arguments):
    done = subprocess.run([RAYTRACER, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          cwd=folder)
    warnings = [line for line in done.stderr.replace("\r", "\n").split("\n") if "scene.json" in line]
    return done.returncode, warnings, done.stdout


def scene_with(folder, **parts):
    pathlib.Path(folder, "scene.json").write_text(json.dumps(SCENE | parts), encoding="utf-8")


def check_advice(folder, what, line):
    """Said in a render and in an explanation; not with --quiet; with --strict the one error, and no
    picture."""
    out = pathlib.Path(folder, "out.png")
    check(what + ": status", 0, run(folder, "scene.json", out, 8)[0])
    check(what + ": picture", True, out.exists())
    out.unlink()
    check(what + ": line", ["warning: scene.json" + line], run(folder, "scene.json", out, 8)[1])
    check(what + ": --quiet", (0, []), run(folder, "scene.json", out, 8, "--quiet")[:2])
    out.unlink()
    for arguments in (["--strict"], ["--strict", "--quiet"]):
        done = subprocess.run([RAYTRACER, *arguments, "scene.json", out, "8"], capture_output=True, text=True,
                              cwd=folder)
        check(what + ": strict status", 2, done.returncode)
        check(what + ": strict line", "scene.json" + line,
              done.stderr.replace("\r", "\n").strip().split("\n")[-1].strip())
        check(what + ": strict picture", False, out.exists())


def check_all_advice(folder):
    material, light, transform = {"color_ambient": [1, 1, 1]}, {"position": [0, 9, 9]}, {"name": "i"}
    sphere = {"type": "sphere", "transform": "i", "material": "default"}
    good = {"materials": [material], "lights": [light], "transforms": [transform], "shapes": [sphere]}
    scene_with(folder, **good)
    out = pathlib.Path(folder, "out.png")
    check("nothing to say", (0, []), run(folder, "scene.json", out, 8, "--strict")[:2])
    check("nothing to explain", (0, []), run(folder, "explain", "scene.json", 4, 4, 8, "--strict")[:2])
    out.unlink()

    dust = {"name": "dust", "translate": [0, 0, 5], "scale": [1e-310] * 3}
    scene_with(folder,
               **good | {"transforms": [transform, dust], "shapes": [sphere, sphere | {"transform": "dust"}]})
    check_advice(folder, "range",
                 ": the scene's numbers lie too far apart for --precision double: computed in extended")
    check("range: extended", (0, []),
          run(folder, "scene.json", out, 8, "--precision", "extended", "--strict")[:2])
    out.unlink()

    scene_with(folder, **good | {"camera": SCENE["camera"] | {"up": [0, 2, 0]}})
    line = ":1:12: /camera: look and up distort: lengths 1, 2 at 90°, not 1, 1 at 90°"
    check_advice(folder, "camera", line)
    check("explained", (0, ["warning: scene.json" + line]), run(folder, "explain", "scene.json", 4, 4, 8)[:2])
    check("explained strictly", (2, ["scene.json" + line]),
          run(folder, "explain", "scene.json", 4, 4, 8, "--strict")[:2])

    scene_with(folder, **good | {"materials": [{}]} | {"lights": [light | {"position": [0, 0, -9]}]})
    check_advice(folder, "black", ": all black: what is seen faces no light: move one, or set "
                                  "/materials/0/color_ambient")
    for partial in (["--only", "ambient"], ["--crop", "0,0,1,1"], ["--pass", "raycast"]):
        check(f"black with {partial}", (0, []), run(folder, "scene.json", out, 8, "--strict", *partial)[:2])
    out.unlink()
    check("black, as floats", 2, run(folder, "scene.json", "out.pfm", 8, "--strict")[0])
    check("black, as floats", False, pathlib.Path(folder, "out.pfm").exists())


def check_doubling(folder):
    """Among many panes of glass each ray is reflected and refracted at the next one."""
    glass = {"color_ambient": [1, 1, 1], "reflective": True, "refractive": True, "index_of_refraction": 1,
             "color_reflect": [0.3, 0.3, 0.3], "color_refract": [0.3, 0.3, 0.3]}
    places = range(-30, 30)
    scene_with(folder, materials=[glass], lights=[{"position": [0, 9, 9]}],
               transforms=[{"name": str(z), "translate": [0, 0, z + 0.5]} for z in places],
               shapes=[{"type": "plane", "transform": str(z), "material": "default"} for z in places])
    out = pathlib.Path(folder, "out.png")
    crop = ["--crop", "0,0,1,1"]
    status, warnings, _ = run(folder, "scene.json", out, 8, "--max-recursion", 13, *crop)
    found = re.fullmatch(r"warning: scene.json: --max-recursion 13 takes about (\S+) rays a sample; "
                         r"lower it, or add a --cutoff", "\n".join(warnings))
    rays = json.loads(run(folder, "scene.json", out, 8, "--max-recursion", 13, *crop, "--stats",
                          "--quiet")[2])["rays"]
    check("doubling: status", 0, status)
    check("doubling: the estimate", True,
          found and 0.5 < float(found[1]) / (rays["reflection"] + rays["refraction"]) < 2)
    check("doubling: few", (0, []), run(folder, "scene.json", out, 8, "--max-recursion", 9, *crop)[:2])
    check("doubling: --quiet", (0, []),
          run(folder, "scene.json", out, 8, "--max-recursion", 13, *crop, "--quiet")[:2])
    check("doubling: --cutoff", (0, []),
          run(folder, "scene.json", out, 8, "--max-recursion", 1000, *crop, "--cutoff", 0.2)[:2])


def check_pictures(folder):
    """A picture of the scene: its verdict, its worst pixel, and the exit status."""
    scene = pathlib.Path("scenes/spheres_cylinder.json").resolve()
    out = pathlib.Path(folder, "mine.png")
    run(folder, scene, out, 60, "--only", "ambient,diffuse,specular,reflections,refraction,textures",
        "--quiet")
    status, _, text = run(folder, "explain", scene, "--picture", "mine.png", "--depth", 0)
    lines = text.split("\n")
    check("no shadows: status", 1, status)
    check("no shadows: verdict",
          "mine.png equals the picture without shadows (0 of 3600 pixels differ; 558 differ from the right "
          "one)", lines[0])
    check("no shadows: hint", "  Is a ray cast from the surface to the light, and S_L 0 where it hits?",
          lines[1])
    found = re.fullmatch(r"pixel \((\d+), (\d+)\): \((.*)\) in mine.png, \((.*)\) is right", lines[2])
    check("no shadows: pixel", True, found is not None)
    check("no shadows: term", "without any shadow it would be as in mine.png", lines[3])
    check("no shadows: depth", 1, text.count(" ray, max_recursion"))
    answer = json.loads(run(folder, "explain", scene, "--picture", "mine.png", "--json")[2])
    check("as JSON", ["without shadows"], [mistake["what"] for mistake in answer["mistakes"]])
    check("as JSON: bytes", [found[3], found[4]],
          [", ".join(map(str, answer[key])) for key in ("theirs", "bytes")])
    run(folder, scene, out, 8, "--only", "ambient,diffuse,specular,reflections,refraction,textures",
        "--quiet")
    check("no shadows, small", "mine.png differs from the right picture in 8 of 64 pixels: too few wrong "
          "pixels to tell the mistake",
          run(folder, "explain", scene, "--picture", "mine.png")[2].split("\n")[0])
    run(folder, scene, out, 60, "--quiet")
    check("right", (0, "mine.png equals the right picture"), (lambda done: (done[0], done[2].split("\n")[0]))(
        run(folder, "explain", scene, "--picture", "mine.png", "--quiet")))
    equal = run(folder, "explain", scene, 25, 20, 60, "--picture", "mine.png")[2]
    # In float checker_horizon has other bytes than in double.
    checker = pathlib.Path("scenes/checker_horizon.json").resolve()
    run(folder, checker, out, 200, "--precision", "float", "--quiet")
    check("right, in float: status", [1, 0],
          [run(folder, "explain", checker, "--picture", "mine.png", "--quiet", "--precision", precision)[0]
           for precision in ("double", "float")])
    run(folder, scene, out, 60, "--quiet")
    check("a right pixel: no term", False, "it would be as in" in equal)
    check_roundings(folder)
    check_nan(folder)
    check_stages(folder)
    run(folder, scene, out, 60, "--crop", "0,0,60,50", "--quiet")
    wrong = subprocess.run([RAYTRACER, "explain", scene, "--picture", out], capture_output=True, text=True)
    check("size", (2, f"{out}: expected a picture of the scene, 60 x 60, found 60 x 50\n"),
          (wrong.returncode, wrong.stderr))


def check_nan(folder):
    """A NaN is not right, not even where black is."""
    scene, out = pathlib.Path("test/good/least.json").resolve(), pathlib.Path(folder, "mine.pfm")
    run(folder, scene, out, 8, "--quiet")
    numbers = array.array("f", out.read_bytes()[-8 * 8 * 12:])
    numbers[numbers.index(0)] = math.nan
    out.write_bytes(out.read_bytes()[:-8 * 8 * 12] + numbers.tobytes())
    status, _, text = run(folder, "explain", scene, "--picture", "mine.pfm")
    check("a NaN", (1, "mine.pfm differs from the right picture in 1 of 64 pixels: too few wrong pixels to "
                    "tell the mistake"), (status, text.split("\n")[0]))


def check_stages(folder):
    """A picture that two stages explain: each hint once, in lines of 100 columns."""
    good = {"lights": [{"position": [0, 9, 9]}], "transforms": [{"name": "i"}],
            "shapes": [{"type": "sphere", "transform": "i", "material": "default"}]}
    scene_with(folder, materials=[{"color_ambient": [0.2, 0.2, 0.2]}], **good)
    run(folder, "scene.json", "mine.png", 60, "--only", "diffuse")
    lines = run(folder, "explain", "scene.json", "--picture", "mine.png")[2].split("\n")
    check("two stages", [
        "mine.png equals the picture that shows diffuse light alone, as the stage -diffuse does, or that",
        "  shows the stage -diffuse_reflections_recursions_3 (0 of 3600 pixels differ; 2822 differ from the",
        "  right one)",
        "  Is it the picture of the stage that was asked for?"], lines[:4])
    check("two stages: the pixel", "pixel (", lines[4][:7])
    lights = [{"position": [3 * i - 8, 9, 9]} for i in range(8)]
    cover = {"type": "cube", "transform": "up", "material": "default"}
    transforms = [{"name": "i"}, {"name": "up", "translate": [0, 4, 0], "scale": [1, 0.1, 9]}]
    scene_with(folder, materials=[{"color_ambient": [0.2, 0.2, 0.2]}], lights=lights, transforms=transforms,
               shapes=[*good["shapes"], cover])
    for explained in ([30, 14, 60], ["--picture", "mine.png", 30, 14, 60]):
        sentence = run(folder, "explain", "scene.json", *explained)[2].partition("primary ray")[0]
        check(f"{explained}: long", True, len(sentence.split("\n")[-3]) > 60)
        check(f"{explained}: width", [], [line for line in sentence.split("\n") if len(line) > 100])


def check_roundings(folder):
    """Another rounding of few pixels is no mistake."""
    path = pathlib.Path("scenes/spheres_cylinder.json").resolve()
    out = pathlib.Path(folder, "rounded.pfm")
    run(folder, path, out, 60, "--quiet")
    data = bytearray(out.read_bytes())
    at = len(data) - 3 * 4 * 60 * 60
    for pixel in (0, 1500):  # up by 1 of 255
        for channel in range(3):
            place = at + 12 * pixel + 4 * channel
            struct.pack_into("<f", data, place, struct.unpack_from("<f", data, place)[0] + 1 / 255)
    out.write_bytes(data)
    status, _, text = run(folder, "explain", path, "--picture", "rounded.pfm", "--quiet")
    check("rounding", (0, "rounded.pfm equals the right picture but for rounding (2 of 3600 pixels by 1)"),
          (status, text.split("\n")[0]))


def check_explanations():
    """The JSON of some pixels of every scene: its bytes are the text's."""
    for scene in sorted(pathlib.Path("scenes").glob("*.json")):
        if scene.name == "scene.schema.json":
            continue
        for place in ((10, 12), (20, 16), (24, 17)):
            status, _, text = run(".", "explain", scene, *place, 40, "--quiet")
            explanation = json.loads(run(".", "explain", scene, *place, 40, "--quiet", "--json")[2])
            check(f"{scene} {place}", 0, status)
            check(f"{scene} {place}", text.rsplit("bytes ", 1)[1].strip(), str(tuple(explanation["bytes"])))
    for refused in (["--pass", "normals"], ["--samples", "2"]):
        check(f"explain {refused}", 2, run(".", "explain", "scenes/texture.json", 1, 1, 40, *refused)[0])
    for arguments in ([1, 1], ["--picture", "a.png", 1, 1]):
        done = subprocess.run([RAYTRACER, "explain", "scenes/texture.json", *map(str, arguments)],
                              capture_output=True, text=True)
        check(f"explain {arguments}",
              (2, "raytracer explain: LONG_EDGE_PIXELS is missing; the order is SCENE X Y "
               "LONG_EDGE_PIXELS (see --help)\n"), (done.returncode, done.stderr))
    check("explain outside", 2, run(".", "explain", "scenes/texture.json", 40, 1, 40)[0])


with tempfile.TemporaryDirectory() as temporary:
    check_all_advice(temporary)
    check_doubling(temporary)
    check_pictures(temporary)
check_explanations()
print("\n".join(failures) or "as it should be")
sys.exit(1 if failures else 0)
