"""Tests values that are set on the command line, animations, and pictures that exist already.

Usage: series_check.py RAYTRACER, from the source folder.
"""
import json
import os
import pathlib
import sys
import tempfile

from checks import RAYTRACER, check, conclude, run

SCENE = pathlib.Path("scenes/spheres_cylinder.json").resolve()


def with_value(scene, *place, value):
    scene = json.loads(scene.read_text())
    part = scene
    for step in place[:-1]:
        part = part[step]
    part[place[-1]] = value
    return json.dumps(scene)


def check_set(folder):
    edited = folder / "edited.json"
    edited.write_text(with_value(SCENE, "lights", 0, "position", value=[1, 5, 2.5]))
    check("an edited scene", (0, ""), run(edited, folder / "a.png", 40, "--quiet"))
    check("--set", (0, ""),
          run(SCENE, folder / "b.png", 40, "--quiet", "--set", "/lights/0/position=[1,5,2]", "--set",
              "/lights/0/position/2=2.5"))
    check("--set: the bytes", True, (folder / "a.png").read_bytes() == (folder / "b.png").read_bytes())
    scene = json.loads(SCENE.read_text())
    light = scene["lights"].pop()
    color = scene["materials"][0].pop("color_diffuse")
    edited.write_text(json.dumps(scene))
    check("--set of what is left out", (0, ""),
          run(edited, folder / "b.png", 40, "--quiet", "--set", f"/lights/-={json.dumps(light)}",
              "--set", f"/materials/0/color_diffuse={json.dumps(color)}"))
    check("the scene", (0, ""), run(SCENE, folder / "a.png", 40, "--quiet"))
    check("--set of what is left out: the bytes", True,
          (folder / "a.png").read_bytes() == (folder / "b.png").read_bytes())
    check("--set of what is not there",
          (2, f'{SCENE}: /camera, by --set: unknown key "eyes"; did you mean "eye"?\n'),
          run(SCENE, folder / "c.png", 40, "--set", "/camera/eyes=[1,2,3]"))
    check("--set to what does not fit",
          (2, f'{SCENE}: /camera/eye, by --set: expected 3 numbers, found "here"\n'),
          run(SCENE, folder / "c.png", 40, "--set", "/camera/eye=here"))
    for pointer, value, found in (("/camera/eye/0", "1e999", "1e999"),
                                  ("/camera/eye", "[-1e999, 0, 1]", "-1e999")):
        check(f"--set {pointer}={value}",
              (2, f"{SCENE}: /camera/eye/0, by --set: expected a finite number, found {found}\n"),
              run(SCENE, folder / "c.png", 40, "--set", f"{pointer}={value}"))
    check("--set without a value", (2, 'raytracer: --set: expected /pointer=value, found "/camera/eye"\n'),
          run(SCENE, folder / "c.png", 40, "--set", "/camera/eye"))
    check("a range without frames", (2, "raytracer: --set /camera/eye/0={0..1}: a range needs --frames\n"),
          run(SCENE, folder / "c.png", 40, "--set", "/camera/eye/0={0..1}"))
    check("a remark on what is set", (0, f"warning: {SCENE}: /lights/0/color, by --set: white is 1 1 1: "
                                         "if this is in bytes, divide it by 255\n"),
          run(SCENE, folder / "a.png", 8, "--set", "/lights/0/color=[255,0,0]"))
    check("three dots are none",
          (2, "raytracer: --set /camera/eye/0={0...3}: a range is {0..1}\n"),
          run(SCENE, folder / "c-%d.png", 8, "--frames", "1..2", "--set", "/camera/eye/0={0...3}"))
    for ends in ("1..1e999", "-1e308..1e308"):
        check(f"a range {ends}", (2, f"raytracer: --set /camera/focal_length={{{ends}}}: a range "
                                     "has finite ends and a finite length\n"),
              run(SCENE, folder / "c-%d.png", 8, "--frames", "1..2", "--set",
                  f"/camera/focal_length={{{ends}}}"))
    check("explain, too", 0, run("explain", SCENE, 5, 5, 40, "--set", "/lights/0/position=[1,5,2]")[0])
    check("nothing is left", ["a.png", "b.png", "edited.json"], sorted(os.listdir(folder)))


def check_frames(folder):
    check("--frames", (0, ""),
          run(SCENE, folder / "f-%03d.png", 30, "--quiet", "--frames", "8..11", "--set",
              "/lights/0/position=[{-2..2},5,{1e0..1}]"))
    check("the frames", [f"f-{frame:03}.png" for frame in range(8, 12)], sorted(os.listdir(folder)))
    for frame, x in ((8, -2), (9, -1), (10, 0), (11, 1)):
        check(f"frame {frame} alone", (0, ""),
              run(SCENE, folder / "a.png", 30, "--quiet", "--set", f"/lights/0/position=[{x},5,1]"))
        check(f"frame {frame}: the bytes", True,
              (folder / "a.png").read_bytes() == (folder / f"f-{frame:03}.png").read_bytes())
    parts = [f"{folder}/f-9.pfm.part-{number}-of-2" for number in (1, 2)]
    for number in (1, 2):
        check("a part of a frame", (0, ""),
              run(SCENE, folder / "f-%d.pfm", 30, "--quiet", "--frames", "9..9", "--part", f"{number}/2"))
    check("parts of a frame", (0, ""), run("assemble", *parts, folder / "f-9.pfm", "--quiet"))
    expected = "raytracer: --frames: expected A..B, two whole numbers with 0 <= A <= B <= 999999, found "
    for text in ("1", "2..1", "-1..2", "a..b", "1..2..3", "1..1000000", "..2", "1.."):
        check(f"--frames {text}", (2, f'{expected}"{text}"\n'),
              run(SCENE, folder / "f-%d.png", 30, "--frames", text))
    for name in ("f.png", "f-%s.png", "f-%d-%d.png", "f-%4d.png", "f-%"):
        check(name, (2, f"{folder / name}: expected a name with one %04d, for the frame's number\n"),
              run(SCENE, folder / name, 30, "--frames", "1..2"))


def check_skipped(folder):
    """What is kept is not written again."""
    texture = folder / "texture.png"
    texture.write_bytes(pathlib.Path("test/expected/mesh.png").read_bytes())
    scene = folder / "scene.json"
    materials = [{"use_diffuse_texture": True, "diffuse_texture": "t"}]
    scene.write_text(json.dumps(json.loads(pathlib.Path("test/good/least.json").read_text()) |
                                {"materials": materials, "textures": {"t": "texture.png"}}))
    for path in (texture, scene):
        os.utime(path, ns=(0, 10**18))
    for name, more in (("a.png", []), ("a.pfm", []), ("a.png.part-2-of-3", ["--part", "2/3"])):
        check_kept(folder, scene, texture, folder / name,
                   [scene, folder / name.removesuffix(".part-2-of-3"), 20, "--skip-existing", *more])
    os.utime(texture, ns=(0, 10**18))
    check("skipped is said", (0, f"{folder}/a.pfm: skipped, it is there\n"),
          run(scene, folder / "a.pfm", 20, "--skip-existing"))
    check("--skip-existing and -", (2, "raytracer: --skip-existing has no effect with the picture -\n"),
          run(scene, "-", 20, "--skip-existing"))


def check_kept(folder, scene, texture, out, line):
    is_part = ".part" in out.name

    def written(what, is_written, *more):
        os.utime(out, ns=(0, 2 * 10**18))
        check(f"{out.name}, {what}", 0, run(*line, "--quiet", *more)[0])
        check(f"{out.name}, {what}: written", is_written, out.stat().st_mtime_ns != 2 * 10**18)

    check(out.name, 0, run(*line, "--quiet")[0])
    whole = out.read_bytes()
    written("whole", False)
    written("other options", is_part, "--samples", 2)
    out.write_bytes(whole)
    for what, data in (("cut", whole[:-1]), ("empty", b""), ("another size", None)):
        if data is None:
            run(*line[:2], 21, *line[4:])
        else:
            out.write_bytes(data)
        written(what, True)
        check(f"{out.name}, {what}: the bytes", True, out.read_bytes() == whole)
    if not out.name.endswith(".pfm"):
        out.write_bytes(whole[:-30] + bytes([whole[-30] ^ 1]) + whole[-29:])
        written("a bit is wrong", True)
    for path in (scene, texture):
        os.utime(path, ns=(0, 3 * 10**18))
        written(f"{path.name} is newer", not is_part)
        os.utime(path, ns=(0, 10**18))
    if is_part:
        before = texture.read_bytes()
        texture.write_bytes(pathlib.Path("test/expected/texture.png").read_bytes())
        written("the texture is another", True)
        texture.write_bytes(before)


def main():
    for test in (check_set, check_frames, check_skipped):
        with tempfile.TemporaryDirectory() as folder:
            test(pathlib.Path(folder))
    return conclude("values are set, frames rendered, and what is there is kept")


if __name__ == "__main__":
    sys.exit(main())
