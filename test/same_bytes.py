#!/usr/bin/env python3
"""Checks that each way to run a program, and each way to build it, makes the same bytes of a picture.

    test/same_bytes.py PROGRAM    one program: each instruction set, glibc's FMA paths masked, 1 to 7 threads
    test/same_bytes.py --build    the matrix: g++ and clang++, -O0 and -O3, and arm64 under qemu-user, each
                                  built into
                                  build/matrix-NAME and run in each of these ways (some twenty minutes)

It compares the decoded pixels of the PNG and the samples of the PFM, of every scene in scenes/ (with PROGRAM:
of five), in float and in double. The matrix needs clang, and for arm64 g++-aarch64-linux-gnu, qemu-user and
libdeflate-dev:arm64; the script reports what is missing. The exit status is 1 if a picture differs.
"""
import concurrent.futures
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import PIL.Image
except ImportError:
    print("skipped: Python has no Pillow")
    sys.exit(77)

top = pathlib.Path(__file__).resolve().parent.parent
size = 48  # pixels on the long edge: -O0 takes a second a picture
# Every shape, material and texture.
short_scenes = ["texture", "mesh", "nested_glass", "stress_test", "lantern_lake"]
options = {"double": [], "float": ["--precision", "float"],
           "bilinear": ["--samples", "3", "--texture-filter", "bilinear", "--max-recursion", "5"]}
masked = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable"}
ways = {"scalar": ({"RAYTRACER_SIMD": "scalar"}, 2), "sse2": ({"RAYTRACER_SIMD": "sse2"}, 2),
        "avx2": ({"RAYTRACER_SIMD": "avx2"}, 2),
        "avx512": ({"RAYTRACER_SIMD": "avx512"}, 2),
        "no FMA in glibc": (masked, 2), **{f"{threads} threads": ({}, threads) for threads in range(1, 8)}}



def is_there(program, environment):
    """Whether the processor has the instruction set that the environment names."""
    names = subprocess.run([*program, "--version"], capture_output=True, text=True, check=True).stdout
    sets = re.search("instruction sets: (.*); used", names).group(1).split(", ")
    return environment.get("RAYTRACER_SIMD", sets[0]) in sets


few = {way: how for way, how in ways.items()
       if way not in ("2 threads", "4 threads", "5 threads", "6 threads")}

# Name: what is in front of the program, CMake's options, and the ways to run it. qemu-user 7.2 can hang where
# a program has two threads.
linux_arm64 = ["-DCMAKE_SYSTEM_NAME=Linux", "-DCMAKE_SYSTEM_PROCESSOR=aarch64",
               "-DCMAKE_LIBRARY_ARCHITECTURE=aarch64-linux-gnu",
               "-DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++", "-DCMAKE_BUILD_TYPE=Release",
               "-DCMAKE_FIND_ROOT_PATH=/usr"]
builds = {
    "g++ -O3": (ways, [], ["-DCMAKE_CXX_COMPILER=g++", "-DCMAKE_BUILD_TYPE=Release"]),
    "g++ -O0": (ways, [],
                ["-DCMAKE_CXX_COMPILER=g++", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0"]),
    "clang++ -O3": (ways, [], ["-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_BUILD_TYPE=Release"]),
    "clang++ -O0":
    (ways, [], ["-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0"]),
    "arm64": ({"1 threads": ({}, 1)}, ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"], linux_arm64),
}


def picture(program, scene, arguments, environment, threads):
    with tempfile.TemporaryDirectory() as folder:
        png, pfm = f"{folder}/o.png", f"{folder}/o.pfm"
        for path in (png, pfm):
            done = subprocess.run([*program, str(scene), path, str(size), "--quiet", "--threads",
                                   str(threads), *arguments],
                                  env={**os.environ, **environment}, cwd=top, capture_output=True, text=True)
            if done.returncode != 0:
                raise SystemExit(f"{' '.join(program)} {scene.name}: status {done.returncode}\n{done.stderr}")
        with PIL.Image.open(png) as image:
            pixels = image.tobytes()
        header = re.match(rb"PF\s+\d+\s+\d+\s+\S+\s", pathlib.Path(pfm).read_bytes())
        return hashlib.sha256(pixels + pathlib.Path(pfm).read_bytes()[header.end():]).hexdigest()


def pictures(program, scenes, ways=ways):
    missing = [way for way, (environment, _) in ways.items() if not is_there(program, environment)]
    if missing:
        print(f"left out, the processor lacks: {', '.join(missing)}")
    jobs = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for scene in scenes:
            for name, arguments in options.items():
                for way, (environment, threads) in ways.items():
                    if way in missing:
                        continue
                    jobs[scene.stem, name,
                         way] = pool.submit(picture, program, scene, arguments, environment, threads)
    return {key: job.result() for key, job in jobs.items()}


def differences(expected, label, made):
    """Prints the pictures that are not those that were made first; returns how many there are."""
    count = 0
    for (scene, name, way), digest in made.items():
        if expected.setdefault((scene, name), digest) != digest:
            print(f"{label}: {scene}, {name}, {way}: another picture")
            count += 1
    print(f"{label}: {len(made)} pictures, {count} differ")
    return count


def build(name, arguments):
    folder = top / "build" / ("matrix-" + re.sub(r"\W+", "-", name))
    quiet = {"check": True, "stdout": subprocess.DEVNULL}
    subprocess.run(["cmake", "-S", str(top), "-B", str(folder), "-G", "Ninja", "-DBUILD_TESTING=OFF",
                    *arguments], **quiet)
    subprocess.run(["ninja", "-C", str(folder), "raytracer"], **quiet)
    return str(folder / "raytracer")


def matrix(scenes):
    expected, count = {}, 0
    for name, (its_ways, prefix, arguments) in builds.items():
        compiler = next(a.split("=")[1] for a in arguments if a.startswith("-DCMAKE_CXX_COMPILER="))
        missing = [tool for tool in [compiler, *prefix[:1]] if not shutil.which(tool)]
        if missing:
            print(f"{name}: left out, {', '.join(missing)} is not installed")
            count += 1
            continue
        count += differences(expected, name, pictures([*prefix, build(name, arguments)], scenes, its_ways))
    return count


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    scenes = sorted(path for path in (top / "scenes").glob("*.json")
                    if not path.name.endswith(".schema.json"))
    if sys.argv[1] == "--build":
        return 1 if matrix(scenes) else 0
    short = [scene for scene in scenes if scene.stem in short_scenes]
    return 1 if differences({}, "pictures", pictures([sys.argv[1]], short, few)) else 0


if __name__ == "__main__":
    sys.exit(main())
