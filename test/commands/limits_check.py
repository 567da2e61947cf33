"""Tests inputs that are too large, endless or no file: the program refuses each at once, with exit status 2
and one line that names the limit.

Usage: limits_check.py RAYTRACER [root], from the source folder. `root` runs the tests of limits that need the
right to mount files; without that right the exit status is 77 (CTest: skipped).
"""
import json
import os
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile
import zlib

RAYTRACER = str(pathlib.Path(sys.argv[1]).resolve())
LEAST = pathlib.Path("test/good/least.json").resolve()
failures = []


def check(what, line, *arguments, script='exec "$@"', status=2, prints=False):
    """The program ends with the status and a line that matches; `script` is the shell's, before."""
    command = ["sh", "-c", script, "sh", RAYTRACER, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=100)
    if done.returncode != status or not re.fullmatch(line, done.stderr) or bool(done.stdout) != prints:
        failures.append(f"{what}: {done.returncode}, {done.stdout[-200:]!r}, {done.stderr[-400:]!r}")


def addresses(kibibytes):
    return f'ulimit -v {kibibytes}; exec "$@"'


def data(kibibytes):
    return addresses(kibibytes).replace("-v", "-d")


def scene_of(folder, name, **parts):
    scene = json.loads(LEAST.read_text()) | {"materials": [{"name": "m"}],
                                             "transforms": [{"name": "t"}]} | parts
    (folder / name).write_text(json.dumps(scene))
    return folder / name


def with_texture(folder, path):
    material = {"name": "m", "use_diffuse_texture": True, "diffuse_texture": "x"}
    return scene_of(folder, "texture.json", textures={"x": path}, materials=[material],
                    shapes=[{"type": "sphere", "transform": "t", "material": "m"}])


def with_mesh(folder, path):
    return scene_of(folder, "mesh.json",
                    shapes=[{"type": "mesh", "path": path, "transform": "t", "material": "m"}])


def png_of_size(width, height, rows=None, depth=8, noise=0):
    """Black; small in the file, but for the last rows, of noise. It may have more rows than its header
    says."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    size, packer, generator = 3 * depth // 8 * width, zlib.compressobj(9), random.Random(1)
    lines = [bytes(size + 1)] * ((rows or height) - noise)
    lines += [b"\0" + generator.randbytes(size) for _ in range(noise)]
    data = b"".join(map(packer.compress, lines)) + packer.flush()
    header = struct.pack(">IIBBBBB", width, height, depth, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


LEFT = r"ulimit -v leaves [\d.]+ ([kMG]B|bytes)\n"
DATA_LEFT = LEFT.replace("-v", "-d")


def too_large(out):
    return re.escape(f"{out}: not enough memory for 5700 × 5700 pixels (292 MB): ")


def check_pictures(folder):
    out = folder / "out.png"
    check("a PNG", too_large(out) + LEFT, LEAST, out, 5700, "--quiet", script=addresses(200000))
    pfm = folder / "out.pfm"
    check("a PFM", re.escape(f"{pfm}: not enough memory for 65536 × 128 pixels (101 MB): ") + LEFT, LEAST,
          pfm, 65536,
          "--quiet", script=addresses(80000))
    check("a small PFM", re.escape(f"{pfm}: not enough memory for 1600 × 1600 pixels (30.7 MB): ") + LEFT,
          LEAST, pfm, 1600, "--target-error", 0.1, script=addresses(30000))
    check("a PNG, of data", too_large(out) + DATA_LEFT, LEAST, out, 5700, "--quiet", script=data(100000))
    check("a part of it", "", LEAST, out, 5700, "--quiet", "--crop", "0,0,9,9", script=addresses(200000),
          status=0)


def check_bands(folder):
    """A picture of over 2^25 pixels takes the memory of a band of it: with all pixels, it would be 300 MB."""
    wide = scene_of(folder, "wide.json",
                    camera=json.loads(LEAST.read_text())["camera"] | {"film_left": -127, "film_right": 127})
    out = folder / "wide.png"
    check("a picture in bands", "", wide, out, 65536, "--quiet", "--threads", 1, script=addresses(200000),
          status=0)


def check_files(folder):
    out = folder / "out.png"
    (folder / "large.png").write_bytes(png_of_size(6000, 6000))
    texture = with_texture(folder, "large.png")
    text = "not enough memory for 6000 × 6000 pixels (324 MB): "
    place = f'{texture}:1:374: /textures/x: in "{folder}/large.png": '
    check("a texture", re.escape(place + text) + LEFT, texture, out, 8, script=addresses(300000))
    check("a texture, of data", re.escape(place + text) + DATA_LEFT, texture, out, 8, script=data(60000))
    check("a texture that fits", "", texture, out, 8, "--quiet", "--threads", 1, script=data(420000),
          status=0)
    (folder / "bomb.png").write_bytes(png_of_size(1000, 10, 60000))
    check("a PNG that inflates to more",
          re.escape(f"{folder}/bomb.png: broken PNG picture: it has more data than pixels\n"),
          "compare", folder / "bomb.png", folder / "bomb.png", script=addresses(100000))
    (folder / "deep.png").write_bytes(png_of_size(3050, 3050, depth=16, noise=20))
    check("a PNG of 16 bits", re.escape(f"{folder}/deep.png: not enough memory for 3050 × 3050 pixels "
                                        "(167 MB): ") + LEFT,
          "compare", folder / "deep.png", folder / "deep.png", script=addresses(150000))
    # The 180 MB of data fit, but not into a buffer that is doubled for them, to 246 MB.
    check("what stb has no memory for",
          re.escape(f"{folder}/bomb.png: broken PNG picture: it has more data than pixels\n"),
          "compare", folder / "bomb.png", folder / "bomb.png", script=addresses(222000))
    (folder / "large.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 500000)
    mesh = with_mesh(folder, "large.obj")
    text = "not enough memory for 500000 triangles (40 MB): "
    place = f'{mesh}:1:272: /shapes/0/path: in "{folder}/large.obj": '
    check("a mesh", re.escape(place + text) + LEFT, mesh, out, 8, script=addresses(40000))
    check_irregular(folder)
    for command in ([], ["compare"]):
        check(f"{command} /dev/zero", "/dev/zero: cannot read: it is a device\n", *command, "/dev/zero", out,
              *([] if command else [8]))
        check(f"{command} an endless pipe",
              "/dev/stdin: cannot read: it has no size, as a pipe, and no end within 1 GiB: "
              "save it as a file\n",
              *command, "/dev/stdin", out, *([] if command else [8]), script='yes | "$@"')
        sparse = folder / "sparse.json"
        os.truncate(os.open(sparse, os.O_CREAT | os.O_WRONLY), 1 << 40)
        check(f"{command} a sparse file",
              re.escape(f"{sparse}: not enough memory for what is in it (1.1 TB): ") + LEFT,
              *command, sparse, out, *([] if command else [8]), script=addresses(300000))


def check_class(folder):
    """The grader's lack of memory is no score. A picture that is too large by its own fault is one: it does
    not end the grading of a class."""
    exam = folder / "exam"
    exam.mkdir()
    scene_of(exam, "a.json")
    (exam / "a.png").write_bytes(png_of_size(3000, 3000))

    def grade(what, line, pictures, limit, status):
        for student, picture in pictures.items():
            (folder / what / student).mkdir(parents=True)
            (folder / what / student / "a.png").write_bytes(picture)
            if not picture:
                os.truncate(folder / what / student / "a.png", 1 << 40)
        check(what, line, "grade", exam, "--submissions", folder / what, "--quiet", "--csv",
              folder / "scores.csv", script=addresses(limit), status=status)

    grade("deep", re.escape(f"{folder}/deep/ada/a.png: not enough memory for 3000 × 3000 pixels (162 MB): ") +
          LEFT, {"ada": png_of_size(3000, 3000, depth=16)}, 150000, 2)
    hostile = {"bomb": png_of_size(3000, 3000, 60000), "header": png_of_size(60000, 60000, 1), "sparse": b"",
               "well": png_of_size(3000, 3000)}
    grade("hostile", "", hostile, 800000, 0)
    scores = [line.split(",")[:2] for line in (folder / "scores.csv").read_text().splitlines()[1:]]
    if scores != [["bomb", "0"], ["header", "0"], ["sparse", "0"], ["well", "100"]]:
        failures.append(f"the scores of a class: {scores}")


def check_irregular(folder):
    """No texture or mesh can make the program wait or read without end."""
    os.mkfifo(folder / "pipe")
    for path in ("pipe", "/dev/zero", "/dev/full"):
        texture, mesh = with_texture(folder, path), with_mesh(folder, path)
        for place in (f"{texture}:1:374: /textures/x:",
                      f"{mesh}:1:272: /shapes/0/path:"):
            check(path, re.escape(f'{place} in "{folder / path}": cannot read: it is no regular file\n'),
                  place.split(":")[0], folder / "out.png", 8)
    endless = with_texture(folder, "/proc/self/pagemap")
    check("an endless file in /proc",
          re.escape(f'{endless}:1:374: /textures/x: in "/proc/self/pagemap": cannot read: it has no size, '
                    "as files in /proc, and may have no end\n"),
          endless, folder / "out.png", 8, script=addresses(300000))


def check_long_texts(folder):
    """A picture as text, where a path is expected, and a long key: the message is still a line."""
    data = "data:image/png;base64," + "A" * 100000
    texture, mesh = with_texture(folder, data), with_mesh(folder, data)
    for place in (f"{texture}:1:374: /textures/x:", f"{mesh}:1:272: /shapes/0/path:"):
        told = r' in "[^"]{400}"\.{3}: cannot read: File name too long\n'
        check("a picture as a path", re.escape(place) + told, place.split(":")[0], folder / "out.png", 8)
    key = scene_of(folder, "key.json", textures={"k" * 100000: 1})
    check("a long key", re.escape(f"{key}:1:") + r'\d+: /textures/"k{60}"\.{3}: expected [^\n]{1,60}\n', key,
          folder / "out.png", 8)


def check_json(folder):
    deep, rest = folder / "deep.json", LEAST.read_text().lstrip()[1:]
    deep.write_text('{"note":' + "[" * 255 + "]" * 255 + "," + rest)
    check("255 lists", "", deep, folder / "out.png", 8, "--quiet", status=0)
    deep.write_text('{"note":' + "[" * 256 + "]" * 256 + "," + rest)
    check("256 lists",
          re.escape(f"{deep}:1:264: expected at most 256 lists and objects inside of each other\n") +
          " {4}[^\n]*\n *\\^\n", deep, folder / "out.png", 8, "--quiet")
    (folder / "large.json").write_text('{"note": [' + "0," * 10000000 + "0]}")
    check("a large scene",
          re.escape(f"{folder}/large.json: not enough memory for 10000004 values and keys (160 MB): ") + LEFT,
          folder / "large.json", folder / "out.png", 8, script=addresses(120000))


def check_many(folder):
    """What a scene of many things takes, and what the pictures take that a command holds at once."""
    out = folder / "out.png"
    many = scene_of(folder, "many.json", transforms=[{"name": str(i)} for i in range(300000)])
    check("many transforms", re.escape(f"{many}: not enough memory for 300000 transforms (63.6 MB): ") + LEFT,
          many, out, 8, script=addresses(80000))
    long = scene_of(folder, "long.json", materials=[{"name": "m" * 20000000}])
    check("a long name", re.escape(f"{long}: not enough memory for this scene: ") + LEFT, long, out, 8,
          script=addresses(70000))
    names = scene_of(folder, "names.json", materials=[{"name": str(i) + "m" * 400} for i in range(30000)])
    check("long names", re.escape(f"{names}: not enough memory for the names of materials (22.6 MB): ") +
          DATA_LEFT, names, out, 8, script=data(40000))
    pfm, png = folder / "black.pfm", folder / "black.png"
    pfm.write_bytes(b"PF 2000 2000 -1\n" + bytes(48000000))
    png.write_bytes(png_of_size(3000, 3000))
    check("a PFM to read", re.escape(f"{pfm}: not enough memory for 2000 × 2000 pixels (48 MB): ") + LEFT,
          "compare", pfm, pfm, script=addresses(150000))
    check("a diagnosis",
          re.escape("not enough memory for the diagnosis of 3000 × 3000 pixels (153 MB): ") + LEFT, "explain",
          LEAST, "--picture", png, "--threads", 1, script=addresses(200000))
    text = "not enough memory for pictures of 4096 × 4096 pixels (1.85 GB): "
    check("a trade-off", re.escape(f"{LEAST}: {text}") + LEFT, "tradeoff", LEAST, "--size", 4096,
          script=addresses(400000))


def check_materials(folder):
    """What is built of the materials is counted, and taken once."""
    scene = scene_of(folder, "bare.json", materials=[{"name": str(i)} for i in range(100000)])
    render = (scene, folder / "out.png", 8, "--quiet", "--threads", 1)
    check("many materials that fit", "", *render, script=data(54000), status=0)
    check("many materials", re.escape("not enough memory for 100000 materials (32 MB): ") + DATA_LEFT,
          *render, "--precision", "extended", script=data(52000))


def check_diagnoses(folder):
    """A diagnosis takes no more than is counted. What each of many known mistakes takes adds up, even if each
    time it is too little to be worth a look at the limits."""
    noise, small = folder / "noise.png", folder / "small.png"
    noise.write_bytes(png_of_size(2000, 2000, noise=2000))
    check("a diagnosis that fits", "", "explain", LEAST, "--picture", noise, "--threads", 1,
          script=data(140000), status=1, prints=True)
    small.write_bytes(png_of_size(300, 300, noise=300))
    transforms = [{"name": str(i), "translate": [i // 60 - 30, i % 60 - 30, 0], "scale": [.4] * 3}
                  for i in range(3600)]
    spheres = scene_of(folder, "spheres.json", transforms=transforms, lights=[{"position": [0, 0, 9]}],
                       shapes=[{"type": "sphere", "transform": str(i), "material": "m"} for i in range(3600)])
    what = r"not enough memory for (a copy of the scene|3600 shapes|the tree of 3600 shapes) \(\d+ kB\): "
    check("known mistakes", what + DATA_LEFT, "explain", spheres, "--picture", small, "--threads", 1,
          "--quiet", script=data(100000))


def check_mounted(folder):
    """The same limits by files of ours, mounted over the system's."""
    out, meminfo, own = folder / "out.png", folder / "meminfo", folder / "own"
    meminfo.write_text("MemTotal: 1 kB\nMemAvailable:    200000 kB\n")

    def check_limit(what, words, setup):
        check(what, too_large(out) + words + "\n", LEAST, out, 5700, "--quiet",
              script=f"unshare -m sh -c 'set -e; {setup}; exec \"$@\"' sh \"$@\"")

    check_limit("available memory", "the machine has left 204 MB", f"mount --bind {meminfo} /proc/meminfo")
    groups = "mount -t tmpfs none /sys/fs/cgroup; cd /sys/fs/cgroup; mkdir -p a/b memory/a"
    for line, place in (("0::/a/b", "a/memory.max"), ("0::/", "memory.max"),
                        ("5:cpu,memory:/a", "memory/memory.limit_in_bytes")):
        own.write_text(line + "\n")
        check_limit(f"the control group {line}", r"the control group's limit leaves 19\d MB",
                    f"{groups}; echo 200000000 > {place}; mount --bind {own} /proc/$$/cgroup")


def main():
    checks = [check_pictures, check_bands, check_files, check_class, check_json, check_long_texts,
              check_many, check_materials, check_diagnoses]
    if sys.argv[2:] == ["root"]:
        if subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "none", "/mnt"],
                          capture_output=True).returncode:
            print("skipped: nothing can be mounted")
            return 77
        checks = [check_mounted]
    for one in checks:
        with tempfile.TemporaryDirectory() as name:
            one(pathlib.Path(name))
    print("\n".join(failures) if failures else "every limit as it should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
