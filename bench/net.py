#!/usr/bin/env python3
"""Checks whether two builds make the same pictures, and with how many instructions.

    bench/net.py record NET.json [--raytracer PROGRAM] [--no-instructions]
    bench/net.py compare NET.json [--raytracer PROGRAM] [--no-instructions]

`record` renders every scene of scenes/ under each set of options below and stores the hashes of the PFM's
samples, of the PNG's decoded pixels, of the rays counted, and of `explain`'s answer for a few pixels.
`compare` does the same and prints each difference. Its exit status is 1 if a hash differs, or if an
instruction count (callgrind, one thread) differs by more than 2 %. To check a change that must not change
pictures, record before it and compare after it.
"""
import argparse
import concurrent.futures
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import PIL.Image

top = pathlib.Path(__file__).resolve().parent.parent
size = 96  # pixels on the long edge: every shape of every scene is seen, and all of this takes a few minutes
instruction_scenes = ["spheres_cylinder", "stress_test", "refraction", "mesh"]
instruction_size = 300
instruction_tolerance = 0.02

# Name: (options, RAYTRACER_SIMD or None).
sets = {
    "defaults": ([], None),
    "samples": (["--samples", "9"], None),
    "adaptive": (["--adaptive", "0.02"], None),
    "deep": (["--max-recursion", "10", "--cutoff", "0.02"], None),
    "float": (["--precision", "float"], None),
    "extended": (["--precision", "extended"], None),
    "list": (["--accelerator", "none"], None),
    "raycast": (["--pass", "raycast"], None),
    "normals": (["--pass", "normals"], None),
    "terms": (["--only", "ambient,diffuse,shadows,reflections"], None),
    "opaque": (["--opaque"], None),
    "bilinear": (["--texture-filter", "bilinear", "--samples", "4"], None),
    "1 thread": (["--threads", "1"], None),
    "3 threads": (["--threads", "3", "--samples", "4"], None),
    "crop": (["--crop", "31,7,79,30"], None),
    "scalar": ([], "scalar"),
    "sse2": ([], "sse2"),
    "float sse2": (["--precision", "float"], "sse2"),
    "avx2": ([], "avx2"),
    "avx512": ([], "avx512"),
}
explained_pixels = [(48, 40), (20, 24), (70, 30)]


def run(program, arguments, simd=None):
    environment = dict(os.environ)
    environment.pop("RAYTRACER_SIMD", None)
    if simd:
        environment["RAYTRACER_SIMD"] = simd
    done = subprocess.run([program, *arguments], env=environment, capture_output=True, text=True, cwd=top)
    if done.returncode != 0:
        raise SystemExit(f"{program} {' '.join(arguments)}: status {done.returncode}\n{done.stderr}")
    return done.stdout


def digest(data):
    return hashlib.sha256(data).hexdigest()[:16]


def pfm_samples(path):
    data = pathlib.Path(path).read_bytes()
    header = re.match(rb"PF\s+\d+\s+\d+\s+\S+\s", data)
    return data[header.end():]


def png_pixels(path):
    with PIL.Image.open(path) as image:
        return image.tobytes()


def ray_counts(stats):
    return json.dumps({key: value for key, value in json.loads(stats)["rays"].items() if key != "seconds"})


def hashes_of(program, scene, name):
    options, simd = sets[name]
    with tempfile.TemporaryDirectory() as folder:
        pfm, png = f"{folder}/o.pfm", f"{folder}/o.png"
        common = [str(size), "--quiet", *options]
        stats = run(program, [str(scene), pfm, *common, "--stats"], simd)
        run(program, [str(scene), png, *common], simd)
        return {"pfm": digest(pfm_samples(pfm)), "png": digest(png_pixels(png)),
                "rays": digest(ray_counts(stats).encode())}


def explanation_of(program, scene, pixel):
    return digest(run(program,
                      ["explain", str(scene), str(pixel[0]), str(pixel[1]), str(size), "--json"]).encode())


def instructions_of(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", program, str(scene),
                   f"{folder}/o.png", str(instruction_size), "--threads", "1", "--quiet"]
        done = subprocess.run(command, capture_output=True, text=True, cwd=top)
        return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def measure(program, with_instructions):
    scenes = sorted(path for path in (top / "scenes").glob("*.json")
                    if not path.name.endswith(".schema.json"))
    there = re.search("instruction sets: (.*); used", run(program, ["--version"])).group(1).split(", ")
    jobs = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for scene in scenes:
            for name in (name for name, (_, simd) in sets.items() if simd is None or simd in there):
                jobs[f"{scene.stem}, {name}"] = pool.submit(hashes_of, program, scene, name)
            for pixel in explained_pixels:
                jobs[f"{scene.stem}, explain {pixel}"] = pool.submit(explanation_of, program, scene, pixel)
        counts = {}
        if with_instructions:
            counts = {name: pool.submit(instructions_of, program, top / "scenes" / f"{name}.json")
                      for name in instruction_scenes}
        return {"hashes": {key: job.result() for key, job in jobs.items()},
                "instructions": {key: job.result() for key, job in counts.items()}}


def compare(before, now):
    differing = sorted(key for key in before["hashes"].keys() | now["hashes"].keys()
                       if before["hashes"].get(key) != now["hashes"].get(key))
    for key in differing:  # also those of an instruction set that only one of the processors has
        print(f"{key}: {before['hashes'].get(key)} before, {now['hashes'].get(key)} now")
    ok = not differing
    for name, count in now["instructions"].items():
        ratio = count / before["instructions"][name]
        print(f"{name}: {count / 1e6:.1f} million instructions, {ratio:.4f} of before")
        ok = ok and abs(ratio - 1) <= instruction_tolerance
    print(f"{len(before['hashes']) - len(differing)} of {len(before['hashes'])} hashes are equal")
    return ok


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["record", "compare"])
    parser.add_argument("net", type=pathlib.Path)
    parser.add_argument("--raytracer", default=str(top / "build/release/raytracer"))
    parser.add_argument("--no-instructions", action="store_true")
    arguments = parser.parse_args()
    with_instructions = not arguments.no_instructions
    if with_instructions and not shutil.which("valgrind"):
        raise SystemExit("bench/net.py: valgrind is not installed; --no-instructions leaves its counts out")
    now = measure(arguments.raytracer, with_instructions)
    if arguments.action == "record":
        arguments.net.write_text(json.dumps(now, indent=1) + "\n")
        return 0
    return 0 if compare(json.loads(arguments.net.read_text()), now) else 1


if __name__ == "__main__":
    sys.exit(main())
