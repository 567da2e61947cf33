"""Tests --watch: the picture follows the scene and the files that it names. After an error the program waits
for the change that corrects it.

Usage: watch_check.py RAYTRACER, from the source folder.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

RAYTRACER = str(pathlib.Path(sys.argv[1]).resolve())
SCENE = json.loads(pathlib.Path("test/good/least.json").read_text(encoding="utf-8")) | {
    "textures": {"check": "check.png"}, "transforms": [{"name": "i"}], "lights": [{"position": [0, 0, 9]}],
    "materials": [{"use_diffuse_texture": True, "diffuse_texture": "check"}],
    "shapes": [{"type": "cube", "transform": "i", "material": "default"}]}
failures = []


def comes(condition):
    """Within ten seconds: this is no measurement, and the machine may be busy."""
    for _ in range(500):
        if condition():
            return True
        time.sleep(0.02)
    return False


def expect(what, condition):
    if not comes(condition):
        failures.append(what)


def save(path, text):
    """As an editor does: whole, in a new file."""
    beside = path.with_suffix(".new")
    beside.write_text(text, encoding="utf-8")
    beside.replace(path)


def watch(folder):
    scene, out, said = folder / "scene.json", folder / "out.png", folder / "said"
    shutil.copy("test/bad/files/check.png", folder / "check.png")
    save(scene, json.dumps(SCENE))
    with open(said, "w", encoding="utf-8") as errors:
        process = subprocess.Popen([RAYTRACER, scene, out, "8", "--watch"], stderr=errors)
    try:
        expect("a first picture", out.exists)
        first = out.read_bytes()
        save(scene, json.dumps(SCENE | {"lights": []}))
        expect("another light, another picture", lambda: out.read_bytes() != first)
        save(scene, json.dumps(SCENE)[:-1])
        expect("an error", lambda: "scene.json:1:" in said.read_text(encoding="utf-8"))
        save(scene, json.dumps(SCENE))
        expect("the first picture again", lambda: out.read_bytes() == first)
        (folder / "check.png").write_bytes(b"broken")
        expect("a broken texture",
               lambda: "/textures/check: in " in said.read_text(encoding="utf-8"))
        out.unlink()
        shutil.copy("test/bad/files/check.png", folder / "check.png")
        expect("a texture that is mended", lambda: out.exists() and out.read_bytes() == first)
        os.mkfifo(folder / "pipe")
        (folder / "pipe").replace(scene)
        expect("a pipe for a scene", lambda: said.read_text(encoding="utf-8").endswith(
            f"{scene}: cannot read: it is no regular file\n"))
        out.unlink()
        save(scene, json.dumps(SCENE))
        expect("a scene again", lambda: out.exists() and out.read_bytes() == first)
        if process.poll() is not None:
            failures.append("it has ended")
    finally:
        process.terminate()
        process.wait()
    refused = subprocess.run([RAYTRACER, scene, "-", "8", "--watch"], capture_output=True, text=True,
                             check=False)
    if (refused.returncode,
        refused.stderr) != (2, "raytracer: --watch has no effect with the picture -: write to a file\n"):
        failures.append(f"-: {refused.stderr}")


def watch_long(folder):
    """A picture that takes minutes is given up once its scene has changed."""
    scene, out = folder / "scene.json", folder / "out.png"
    shutil.copytree("scenes/textures", folder / "textures")
    shutil.copy("test/bad/files/check.png", folder / "check.png")
    save(scene, pathlib.Path("scenes/nested_glass.json").read_text(encoding="utf-8"))
    command = [RAYTRACER, scene, out, "2000", "--max-recursion", "16", "--threads", "1", "--quiet", "--watch"]
    process = subprocess.Popen(command)
    try:
        time.sleep(1)  # it has begun
        save(scene, json.dumps(SCENE | {"shapes": [], "materials": []}))
        expect("the picture of the changed scene", out.exists)
    finally:
        process.terminate()
        process.wait()


for watched in (watch, watch_long):
    with tempfile.TemporaryDirectory() as temporary:
        watched(pathlib.Path(temporary))
print("\n".join(f"expected {failure}" for failure in failures) if failures else "the picture follows")
sys.exit(1 if failures else 0)
