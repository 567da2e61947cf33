"""Tests the parts of a picture: assembled, they have the bytes of one run. A part that does not fit is named,
and no picture is written.

Usage: parts_check.py RAYTRACER knobs|faults|all, from the source folder. `knobs`: pictures with options in 2
parts, and one without options in 1, 2, 7, 16 and 64. `all`: each option in all these numbers of parts, which
takes a minute.
"""
import os
import pathlib
import re
import shutil
import sys
import tempfile
import zlib

from checks import RAYTRACER, check, conclude, run

SCENE = "scenes/refraction.json"
FIRST_MISSING = "part 1 of 3 is missing: render it with --part 1/3"


def render_parts(out, count, *arguments, scene=SCENE, size=97):
    for number in range(1, count + 1):
        check(f"part {number} of {count} {arguments}", (0, ""),
              run(scene, out, size, "--quiet", "--part", f"{number}/{count}", *arguments))
    return [f"{out}.part-{number}-of-{count}" for number in range(1, count + 1)]


def check_same(folder, ending, count, *arguments, scene=SCENE, size=97, status=0):
    whole, out = folder / f"whole{ending}", folder / f"out{ending}"
    check(f"one run {arguments}", status, run(scene, whole, size, "--quiet", *arguments)[0])
    parts = render_parts(out, count, *arguments, scene=scene, size=size)
    check(f"{count} parts {arguments}", (status, ""), run("assemble", *reversed(parts), out, "--quiet"))
    check(f"{count} parts {arguments}: the bytes", True,
          out.exists() and whole.read_bytes() == out.read_bytes())
    for path in (whole, out, *map(pathlib.Path, parts)):
        path.unlink(missing_ok=True)


KNOBS = (["--samples", 5], ["--adaptive", 0.05], ["--cutoff", 0.1], ["--precision", "float"],
         ["--precision", "extended"],
         ["--crop", "31,7,96,40"], ["--max-recursion", 6], ["--only", "ambient,diffuse"],
         ["--pass", "normals"],
         ["--texture-filter", "bilinear"], ["--opaque"], ["--target-error", 0.02], ["--threads", 3],
         ["--accelerator", "none"])


def check_knobs(folder):
    counts = (1, 2, 7, 16, 64)
    for count in counts:
        check_same(folder, ".png", count)
    for arguments in KNOBS:
        for count in counts if "all" in sys.argv else (2,):
            check_same(folder, ".png", count, *arguments)
    check_same(folder, ".pfm", 7, "--samples", 3)


def check_unreached(folder):
    """An error that no setting reaches: each part ends with 0, and the picture of them with 1."""
    check_same(folder, ".png", 2, "--target-error", 1e-7, size=2, status=1)
    parts = render_parts(folder / "out.png", 2, "--target-error", 1e-7, size=2)
    check("assemble", (1, f"{folder / 'out.png'}: --target-error is not reached\n"),
          run("assemble", *parts, folder / "out.png"))


def check_fault(folder, what, paths, *lines, out="out.png"):
    (folder / out).unlink(missing_ok=True)
    status, error = run("assemble", *paths, folder / out)
    check(what, (2, [line.replace("FOLDER", str(folder)) for line in lines]), (status, error.splitlines()))
    check(f"{what}: no picture", False, (folder / out).exists())


def changed(path, old, new, folder):
    """A part with other text in its head, and the checksum of that."""
    data = pathlib.Path(path).read_bytes()[:-8]
    size = int(data[17:25], 16)
    head = data[26:26 + size]
    assert old in head, (old, head)
    head = head.replace(old, new)
    data = data[:17] + b"%08x\n" % len(head) + head + data[26 + size:]
    other = folder / "changed.part"
    other.write_bytes(data + b"%08x" % zlib.crc32(data))
    return other


def check_faults(folder):
    a, b, c = render_parts(folder / "a.png", 3)
    check_fault(folder, "one is missing", [a, c], "part 2 of 3 is missing: render it with --part 2/3")
    check_fault(folder, "twice", [a, b, c, b],
                "FOLDER/a.png.part-2-of-3: part 2 of 3 again, as FOLDER/a.png.part-2-of-3")
    many = render_parts(folder / "m.png", 9)
    check_fault(folder, "many are missing", [many[i] for i in (1, 5, 6)],
                "parts 1, 3 to 5 and 8 to 9 of 9 are missing: render each with --part K/9")
    whole = pathlib.Path(a).read_bytes()
    broken = folder / "broken.part"
    for what, data, line in (
            ("cut short", whole[:-1], "broken part of a picture: it is cut short"),
            ("cut to its head", whole[:300], "broken part of a picture: it is cut short"),
            ("cut in its head", whole[:40], "broken part of a picture: it is cut short"),
            ("cut to nothing", b"", 'not a part of a picture: it does not begin with "raytracer part 1"'),
            ("longer", whole + b"\0", "broken part of a picture: it goes on behind its end"),
            ("a bit of a pixel", whole[:-50] + bytes([whole[-50] ^ 1]) + whole[-49:],
             "broken part of a picture: its checksum is wrong"),
            ("a bit of its head", whole.replace(b"max-recursion 3", b"max-recursion 7"),
             "broken part of a picture: its checksum is wrong"),
            ("no JSON", whole.replace(b'"version"', b'"version '),
             "broken part of a picture: its head cannot be read"),
            ("a picture", pathlib.Path("test/expected/mesh.png").read_bytes(),
             'not a part of a picture: it does not begin with "raytracer part 1"')):
        broken.write_bytes(data)
        check_fault(folder, what, [broken, b, c], f"FOLDER/broken.part: {line}", FIRST_MISSING)
    check_fault(folder, "a head of other bytes that says the same",
                [changed(a, b'"part": [', b'"part":    [', folder), b, c],
                "FOLDER/changed.part: broken part of a picture: its head is not as raytracer writes it",
                FIRST_MISSING)
    check_fault(folder, "no file", ["/no/x.part", b, c], "/no/x.part: cannot read: No such file or directory",
                FIRST_MISSING)
    check_fault(folder, "a folder", [folder, b, c], "FOLDER: cannot read: it is no regular file",
                FIRST_MISSING)
    check_others(folder, a, b, c)


def check_others(folder, a, b, c):
    """Parts of something else."""
    does_not_fit = "does not fit FOLDER/a.png.part-2-of-3: it is"
    version = re.search(rb'"version": "([^"]*)"', pathlib.Path(a).read_bytes()).group(1)
    check_fault(folder, "another version", [changed(a, version, b"0.1", folder), b, c],
                f"FOLDER/changed.part: {does_not_fit} of version 0.1 of raytracer, not {version.decode()}",
                FIRST_MISSING)
    for what, line, options in (
            ("another size", "of a picture of 98 x 98 pixels, not 97 x 97", {"size": 98}),
            ("another crop", "of --crop 0,0,97,70, not 0,0,97,97", {"more": ("--crop", "0,0,97,70")}),
            ("another scene", "of another scene", {"scene": "scenes/spheres_cylinder.json"}),
            ("other options", "of a picture with --samples 2, not with --samples 1",
             {"more": ("--samples", 2)}),
            ("another value", "of a picture with --set /lights/0/position=[1,2,3]",
             {"more": ("--set", "/lights/0/position=[1,2,3]")})):
        other = render_parts(folder / "o.png", 3, *options.pop("more", ()), **options)
        check_fault(folder, what, [other[0], b, c], f"FOLDER/o.png.part-1-of-3: {does_not_fit} {line}",
                    FIRST_MISSING)
    other = render_parts(folder / "o.png", 4)
    check_fault(folder, "another count", [other[0], b, c],
                f"FOLDER/o.png.part-1-of-4: {does_not_fit} part 1 of 4, not of 3", FIRST_MISSING)
    other = render_parts(folder / "o.pfm", 3)
    check_fault(folder, "another format", [other[0], b, c],
                f"FOLDER/o.pfm.part-1-of-3: {does_not_fit} of a .pfm, not of a .png",
                FIRST_MISSING)
    check_fault(folder, "a wrong name", [a, b, c],
                "FOLDER/out.pfm: expected a name that ends in .png: the parts were rendered for that",
                out="out.pfm")
    check("no picture", (2, f"raytracer assemble: IMAGE_OUT is missing: {c} is the last part\n"),
          run("assemble", a, b, c))
    check_fault(folder, "no name of a picture", [a, b, c],
                "FOLDER/out.gif: expected a name that ends in .png or .pfm", out="out.gif")


def check_scene_files(folder):
    """A scene is another one where a mesh of it is."""
    mesh = folder / "m.obj"
    mesh.write_text("v 0 0 -3\nv 1 0 -3\nv 0 1 -3\nf 1 2 3\n")
    scene = folder / "scene.json"
    scene.write_text(pathlib.Path("test/good/least.json").read_text().replace('"materials": []',
                                                                              '"materials": [{"name": "m"}]')
                     .replace('"transforms": []', '"transforms": [{"name": "t"}]')
                     .replace('"shapes": []', '"shapes": [{"type": "mesh", "path": "m.obj", "material": "m", '
                                              '"transform": "t"}]'))
    assert "m.obj" in scene.read_text()
    out = folder / "s.png"
    check("a part with the mesh", 0, run(scene, out, 40, "--part", "1/2")[0])
    mesh.write_text("v 0 0 -3\nv 1 0 -3\nv 0 2 -3\nf 1 2 3\n")
    check("a part with another mesh", 0, run(scene, out, 40, "--part", "2/2")[0])
    check_fault(folder, "another mesh", [f"{out}.part-1-of-2", f"{out}.part-2-of-2"],
                "FOLDER/s.png.part-2-of-2: does not fit FOLDER/s.png.part-1-of-2: it is of another scene",
                "part 2 of 2 is missing: render it with --part 2/2")


def check_outputs(folder):
    """No picture takes the place of what it is made of."""
    shutil.copytree("scenes/textures", folder / "textures")
    texture = folder / "textures/checker.png"
    scene = folder / "s.json"
    scene.write_text(pathlib.Path(SCENE).read_text())
    os.link(texture, folder / "link.png")
    for out in (texture, folder / "link.png", folder / "textures/../textures/checker.png"):
        check(f"a picture over its texture, {out}",
              (2, f"{out} is read, too: give another name for what is written\n"), run(scene, out, 8))
    check("the texture", pathlib.Path("scenes/textures/checker.png").read_bytes(), texture.read_bytes())
    (part,) = render_parts(folder / "p.png", 1, scene=scene, size=8)
    pathlib.Path(part).rename(folder / "part.png")
    check("a picture over its part",
          (2, f"{folder}/part.png is read, too: give another name for what is written\n"),
          run("assemble", folder / "part.png", folder / "part.png"))


def check_refusals(folder):
    expected = "raytracer: --part: expected K/N, two whole numbers with 1 <= K <= N <= 1048576, found "
    for text in ("0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/1048577"):
        check(f"--part {text}", (2, f'{expected}"{text}"\n'), run(SCENE, folder / "x.png", 8, "--part", text))
    check("--part and -", (2, "raytracer: the picture - goes to standard output, and --part to a file\n"),
          run(SCENE, "-", 8, "--part", "1/2"))
    check("--part and --target-time",
          (2, "raytracer: --part and --target-time exclude each other: give one of them\n"),
          run(SCENE, folder / "x.png", 8, "--part", "1/2", "--target-time", 1))
    # At once: the search for this error would take too long for the test.
    check("--part of a scene from a pipe", (2, "/dev/stdin: cannot read: it is no regular file\n"),
          run("/dev/stdin", folder / "x.png", 600, "--part", "1/2", "--target-error", 1e-9,
              given=pathlib.Path("scenes/cone_cube.json").read_bytes()))
    check("nothing is left", False, any(path.name.startswith("x.png") for path in folder.iterdir()))


def main():
    faults = (check_faults, check_scene_files, check_outputs, check_refusals)
    for test in faults if "faults" in sys.argv else (check_knobs, check_unreached):
        with tempfile.TemporaryDirectory() as folder:
            test(pathlib.Path(folder))
    return conclude("parts make the pictures of one run; what does not fit is named")


if __name__ == "__main__":
    sys.exit(main())
