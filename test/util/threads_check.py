#!/usr/bin/env python3
"""Tests deep recursion with any limit on the stack, and fewer threads than asked for.

Usage: threads_check.py RAYTRACER
"""
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

RAYTRACER = pathlib.Path(sys.argv[1]).resolve()
ALONE = 20000 + os.getpid() % 40000  # a user who has no other processes: they would count, too
MEBIBYTE = 1 << 20


def mirrors():
    """Two that face each other: a ray is reflected as often as it may."""
    plane = {"type": "plane", "material": "mirror"}
    return {
        "camera": {"type": "perspective", "focal_length": 1, "eye": [0, 0, 4], "look": [0, 0, -1],
                   "up": [0, 1, 0],
                   "film_left": -0.5, "film_right": 0.5, "film_bottom": -0.5, "film_top": 0.5},
        "materials":
        [{"name": "mirror", "color_ambient": [0.001] * 3, "color_diffuse": [0.1] * 3, "reflective": True,
          "color_reflect": [0.9999] * 3}],
        "lights": [{"position": [0, 0, 10], "color": [0, 0, 0], "color_ambient": [1, 1, 1]}],
        "transforms": [{"name": "a", "translate": [0, 0, -1]}, {"name": "b", "translate": [0, 0, 5]}],
        "shapes": [plane | {"transform": "a"}, plane | {"transform": "b"}]}


def run(folder, recursion, threads, stack, processes=None, command=("s.json", "o.pfm", "8")):
    """How the program ends with this limit on the main thread's stack and on processes (which root has
    not)."""
    def limit():
        resource.setrlimit(resource.RLIMIT_STACK, (stack, resource.getrlimit(resource.RLIMIT_STACK)[1]))
        if processes:
            resource.setrlimit(resource.RLIMIT_NPROC, (processes, processes))
            os.setgid(ALONE)
            os.setuid(ALONE)
    depth = ["--max-recursion", str(recursion)] if recursion is not None else []
    return subprocess.run([RAYTRACER, *command, "--quiet", *depth, "--threads", str(threads)],
                          cwd=folder, preexec_fn=limit, capture_output=True, text=True, timeout=60)


def picture(folder, *arguments):
    done = run(folder, *arguments)
    assert (done.returncode, done.stderr) == (0, ""), (arguments, done)
    return (folder / "o.pfm").read_bytes()


def check_stack(folder):
    plain = picture(folder, 1000, 1, resource.RLIM_INFINITY)
    for stack in (resource.RLIM_INFINITY, 8 * MEBIBYTE, 4 * MEBIBYTE, MEBIBYTE // 2):
        for threads in (1, 2):
            assert picture(folder, 1000, threads, stack) == plain, (stack, threads)
    for stack in (resource.RLIM_INFINITY, MEBIBYTE // 2):
        for form, word in ((["--json"], '"reflection"'), ([], "reflected ray")):
            done = run(folder, 1000, 2, stack, command=("explain", "s.json", "3", "4", "8", *form))
            assert done.returncode == 0 and done.stdout.count(word) > 900, (stack, form, done.returncode,
                                                                            done.stderr)


def check_search(folder):
    """--target-time renders tiles on several threads, as deep as it sees a difference."""
    for stack in (resource.RLIM_INFINITY, 4 * MEBIBYTE):
        done = run(folder, None, 2, stack, command=("s.json", "o.pfm", "60", "--target-time", "1"))
        assert (done.returncode, done.stderr) == (0, ""), (stack, done)


def check_threads(folder):
    if os.geteuid() != 0 or not all(parent.stat().st_mode & 1 for parent in RAYTRACER.parents):
        return print("limits on processes: skipped, root alone can become a user that has them, and who can "
                     "reach the program")
    plain = picture(folder, 3, 1, 8 * MEBIBYTE)
    assert picture(folder, 3, 4, 8 * MEBIBYTE, 1) == plain
    assert picture(folder, 1000, 4, resource.RLIM_INFINITY, 1) == picture(folder, 1000, 4, 8 * MEBIBYTE)
    done = run(folder, 1000, 4, 4 * MEBIBYTE, 1)
    assert (done.returncode, done.stderr) == (
        2, "--max-recursion 1000 needs a thread, and none can be made: lower it to 32, or set ulimit -s "
        "86699\n"), done
    assert picture(folder, 32, 4, 4 * MEBIBYTE, 1) == picture(folder, 32, 1, 8 * MEBIBYTE)
    for kibibytes in (256, 1365):
        done = run(folder, 0, 4, kibibytes << 10, 1)
        assert (done.returncode, done.stderr) == (
            2, "--max-recursion 0 needs a thread, and none can be made: set ulimit -s 1366\n"), done
    assert picture(folder, 0, 4, 1366 << 10, 1) == picture(folder, 0, 1, 8 * MEBIBYTE)
    assert picture(folder, 1000, 4, 86699 << 10, 1) == picture(folder, 1000, 1, 8 * MEBIBYTE)


with tempfile.TemporaryDirectory() as temporary:
    os.chmod(temporary, 0o777)
    here = pathlib.Path(temporary)
    (here / "s.json").write_text(json.dumps(mirrors()))
    (here / "o.pfm").touch()
    os.chmod(here / "o.pfm", 0o666)
    check_stack(here)
    check_search(here)
    check_threads(here)
