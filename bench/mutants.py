#!/usr/bin/env python3
"""Mutation testing of the light model, the shapes and the sampling.

    bench/mutants.py [--count N] [--seed N] [--only PART]

A mutant is the core with one operator, constant or comparison changed. The script compiles each mutant (in
double: the core, and the packets for SSE2), links it with the rest of build/release, and runs the tests of
pictures, with packets and with single rays. If all of these pass, it runs the core's own tests, too. It
prints the fate of each mutant, and the survivors last. The exit status is 1 if a mutant survived. A survivor
should be killed by a new test, or explained in bench/README.md: some changes make no difference. Run `./run
test` first, which builds build/release.
"""
import argparse
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys

top = pathlib.Path(__file__).resolve().parent.parent
release, work = top / "build/release", top / "build/mutants"
tree = work / "tree"
mutated_files = ["src/tracer/ray_color.h", "include/raytracer/tracer/shading.h", "src/tracer/shading.cpp",
                 "src/tracer/camera.cpp", "src/tracer/tile.cpp", "include/raytracer/tracer/pixel_estimate.h",
                 "include/raytracer/geometry/*.h",
                 "src/geometry/transform.cpp",
                 "include/raytracer/tracer/sample_sequence.h"]
# Pattern, replacement. clang-format sets blanks around binary operators, so brackets of templates are no
# comparisons.
changes = [(r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "), (r" < ", " <= "),
           (r" < ", " > "), (r" <= ", " < "),
           (r" > ", " >= "), (r" > ", " < "), (r" >= ", " > "), (r" && ", " || "), (r" \|\| ", " && "),
           (r" & ", " | "), (r" == ", " != "),
           (r" != ", " == "), (r"\bmin\(", "max("), (r"\bmax\(", "min("), (r"\b0\b", "1"), (r"\b1\b", "2"),
           (r"\b2\b", "3"), (r"\b4\b", "5"),
           (r"\btrue\b", "false"), (r"\bfalse\b", "true"), (r" \+= ", " -= "), (r" \*= ", " /= "),
           (r"\(-", "("), (r"!\(", "(")]
no_code = re.compile(
    r"^\s*(//|#|\*|template|using|static_assert|namespace|inline constexpr std|case|default)")
# Compiled once: they see the core through interfaces that are the same in each mutant.
picture_tests = ["test/tracer/unit_plain_tracer.cpp", "test/tracer/unit_render.cpp",
                 "test/tracer/unit_samples.cpp", "test/tracer/unit_extremes.cpp",
                 "test/geometry/unit_coincidence.cpp", "test/geometry/unit_range.cpp",
                 "test/explain/unit_explain.cpp"]
late_tests = ["test/accuracy/unit_knobs.cpp"]  # of what passes those
core_tests = sorted(str(path.relative_to(top)) for path in top.glob("test/*/core_*.cpp"))
# These take a third of the time, to see what the powers of two see in less.
left_out = "~*extended precision*"
seconds_to_hang = 300


def candidates():
    """(file, line, start, end, replacement) of every possible change."""
    for pattern in mutated_files:
        for path in sorted(top.glob(pattern)):
            for number, line in enumerate(path.read_text().splitlines()):
                code = line.split("//")[0]
                if no_code.match(line) or '"' in code:
                    continue
                for before, after in changes:
                    for found in re.finditer(before, code):
                        yield path.relative_to(top), number, found.start(), found.end(), after


def compile_command(target):
    """Compiler and flags of this target of the build."""
    entries = json.loads((release / "compile_commands.json").read_text())
    entry = next(e for e in entries if target + ".dir" in e["command"])
    words = [w for w in shlex.split(entry["command"])
             if not w.startswith(("-O", "-Winvalid")) and "ccache" not in w]
    flags, skip = [], False
    for word in words[1:]:
        if skip or word in ("-o", "-c", "-include", "-MT", "-MF", "-MD"):
            skip = word in ("-o", "-c", "-include", "-MT", "-MF") and not skip
            continue
        flags.append(word.replace(str(top), str(tree)))
    return [words[0], *flags, "-O1", "-w"]


def core_sources():
    return re.search(r"set\(core_sources(.*?)\)", (top / "CMakeLists.txt").read_text(), re.S).group(1).split()


def compile_core():
    """Whether the core and its packets compile, as core.o and packets.o."""
    return (compile_to(compile_command("core_double"), core_sources(), "core") and
            compile_to(compile_command("packets_double_sse2"), ["src/tracer/packet_tracer.cpp"], "packets"))


def compile_to(command, sources, target):
    unit = work / (target + ".cpp")
    unit.write_text("".join(f'#include "{tree / source}"\n' for source in sources))
    done = subprocess.run([*command, "-c", str(unit), "-o", str(work / (target + ".o"))], capture_output=True,
                          text=True)
    return done.returncode == 0


def compile_each(command, sources):
    for source in sources:
        name = pathlib.Path(source).stem
        if not compile_to(command, [source], name):
            raise SystemExit(f"bench/mutants.py: {source} does not compile")
    return [pathlib.Path(source).stem for source in sources]


def passes(compiler, objects, name, instruction_sets):
    """Whether the tests in these objects pass with the mutant's core, with each of these sets."""
    libraries = [str(release / "libraytracer_core.a"), str(next(release.glob("third_party/libstb.a"))),
                 "-ldeflate", "-lpthread"]
    program = str(work / name)
    subprocess.run([compiler, "-o", program, *[str(work / (o + ".o")) for o in objects], *libraries],
                   check=True)
    try:
        # sse2: most rays in the mutant's packets, the others alone; scalar: all alone.
        return all(subprocess.run([program, "--abort", left_out], env={**os.environ, "RAYTRACER_SIMD": set_},
                                  cwd=top, capture_output=True, timeout=seconds_to_hang).returncode == 0
                   for set_ in instruction_sets)
    except subprocess.TimeoutExpired:
        return False


def fate(command, mutant, pictures, late):
    path, number, start, end, after = mutant
    text = (top / path).read_text()
    lines = text.split("\n")
    lines[number] = lines[number][:start] + after + lines[number][end:]
    (tree / path).write_text("\n".join(lines))
    try:
        if not compile_core():
            return "does not compile", lines[number]
        tests = ["core", "packets", "catch_main", *pictures]
        if not passes(command[0], tests, "pictures", ["sse2", "scalar"]):
            return "killed by a picture", lines[number]
        if not compile_to(command, core_tests, "core_tests"):
            raise SystemExit("bench/mutants.py: the core's tests do not compile")
        tests = ["core", "packets", "catch_main", "core_tests", *late]
        ok = passes(command[0], tests, "known", ["sse2"])
        return ("SURVIVED" if ok else "killed by a known answer"), lines[number]
    finally:
        (tree / path).write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=120, help="how many mutants that compile")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="mutate only files with this in their names")
    arguments = parser.parse_args()
    shutil.rmtree(tree, ignore_errors=True)
    for part in ("src", "include", "test"):
        shutil.copytree(top / part, tree / part)
    command = compile_command("core_double")
    seeing = [*command, '-DSOURCE_DIR="."']
    pictures, late = compile_each(seeing, picture_tests), compile_each(seeing, late_tests)
    compile_each(command, ["test/support/catch_main.cpp"])
    compile_core()
    tests = ["core", "packets", "catch_main", *pictures]
    if not passes(command[0], tests, "pictures", ["sse2", "scalar"]):
        raise SystemExit("bench/mutants.py: the tests fail without a mutant")
    order = [mutant for mutant in candidates() if arguments.only in str(mutant[0])]
    random.Random(arguments.seed).shuffle(order)
    fates = {}
    for mutant in order:
        became, line = fate(command, mutant, pictures, late)
        if became != "does not compile":
            fates.setdefault(became, []).append(f"{mutant[0]}:{mutant[1] + 1}: {line.strip()}")
            print(f"{became}: {fates[became][-1]}", flush=True)
        if sum(map(len, fates.values())) == arguments.count:
            break
    print("\n" + ", ".join(f"{len(lines)} {became}" for became, lines in sorted(fates.items())))
    print("\n".join(fates.get("SURVIVED", [])))
    return 1 if fates.get("SURVIVED") else 0


if __name__ == "__main__":
    sys.exit(main())
