"""The measured programs: whether each is installed, and how it renders a scene of ours."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parent
NAMES = {"raytracer": "raytracer", "povray": "POV-Ray", "tachyon": "Tachyon"}


def say(*words):
    print(*words, file=sys.stderr, flush=True)


def default_binary():
    return TOP / "build" / "release" / "raytracer"


def installed(name, binary=None):
    """Whether there is such a program; says so where there is none."""
    there = pathlib.Path(binary or default_binary()).is_file() if name == "raytracer" else shutil.which(name)
    if not there:
        say(f"{NAMES[name]} is not installed: left out" if name != "raytracer"
            else "raytracer is not built: ./run test")
    return bool(there)


def version(name):
    """One line, for the table's foot."""
    if name == "povray":
        said = subprocess.run(["povray", "--version"], capture_output=True, text=True)
        found = re.search(r"POV-Ray (\d\S*)", said.stdout + said.stderr)
    else:
        # It introduces itself only when it is given a file, and then ends with an error as there is none.
        said = subprocess.run(["tachyon", "no-such-scene.dat"], capture_output=True, text=True)
        found = re.search(r"Version (\S+)", said.stdout + said.stderr)
    return f"{NAMES[name]} {found.group(1) if found else '(version unknown)'}"


def convert(scene, program, size, folder):
    """The scene in the program's own format (or "plain"), and what the conversion says it loses."""
    if program == "raytracer":
        return pathlib.Path(scene).resolve(), []
    suffix = {"povray": "pov", "tachyon": "dat", "plain": "json"}[program]
    out = pathlib.Path(folder) / f"{pathlib.Path(scene).stem}-{size}.{suffix}"
    said = subprocess.run([sys.executable, HERE / "convert.py", scene, "--to", program, "--size", str(size),
                           out],
                          capture_output=True, text=True)
    if said.returncode:
        raise RuntimeError(f"converting {scene}: {said.stderr}")
    return out, [line.split(f"{program}: ", 1)[1] for line in said.stderr.splitlines()]


def command(program, scene, picture, image_size, threads, binary=None):
    """A command line that renders a converted scene; pictures as PNG, one ray a pixel."""
    if program == "raytracer":
        return [binary or default_binary(), scene, picture, max(image_size), "--threads", threads, "--quiet"]
    if program == "povray":
        return ["povray", f"+I{scene}", f"+O{picture}", f"+W{image_size[0]}", f"+H{image_size[1]}", "-D",
                "-A", "+FN8",
                "File_Gamma=1.0", "-GA", f"+WT{threads}"]
    return ["tachyon", scene, "-shade_phong", "-numthreads", threads, "-format", "PNG", "-o", picture]


def image_size(scene, long_edge):
    """(width, height), asked of the converter's own reader in a process of its own: numpy stays out of this
    one."""
    said = subprocess.run([sys.executable, "-c", "import sys; from scene_file import read_scene; "
                           "print(*read_scene(sys.argv[1]).camera.image_size(int(sys.argv[2])))", scene,
                           str(long_edge)],
                          capture_output=True, text=True, cwd=HERE, check=True)
    return tuple(int(number) for number in said.stdout.split())


def differing_share(picture, other, by=8):
    """The share of pixels of which a channel differs by more than `by` of 255."""
    said = subprocess.run([sys.executable, HERE / "differ.py", picture, other, "--by", str(by)],
                          capture_output=True, text=True, check=True)
    return float(said.stdout)


def machine():
    """One line about where this ran: processor, how many of them, and the commit."""
    model = re.search(r"model name\s*:\s*(.+)", pathlib.Path("/proc/cpuinfo").read_text())
    count = len(os.sched_getaffinity(0))
    commit = "an unknown commit"
    if shutil.which("git"):
        said = subprocess.run(["git", "-C", TOP, "describe", "--always", "--dirty"], capture_output=True,
                              text=True)
        commit = said.stdout.strip() or commit
    return f"{model.group(1) if model else 'unknown processor'}, {count} processors; raytracer at {commit}"
