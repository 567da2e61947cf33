"""Tests the command line of every command: help fits a terminal, and an error is reported in one line.

Usage: command_line_check.py RAYTRACER, from the source folder.
"""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

from checks import RAYTRACER, check, check_width, conclude, failures

SCENE = str(pathlib.Path("test/good/least.json").resolve())
COMMANDS = {"render": [], "assemble": ["assemble"], "compare": ["compare"], "grade": ["grade"],
            "explain": ["explain"], "tradeoff": ["tradeoff"]}


def run(*arguments, **environment):
    words = [word if isinstance(word, bytes) else str(word) for word in arguments]
    return subprocess.run([RAYTRACER, *words], capture_output=True, text=True, timeout=60,
                          env={**os.environ, **environment})


def check_help(command):
    done = run(*COMMANDS[command], "--help")
    check(f"{command} --help", (0, ""), (done.returncode, done.stderr))
    check(f"{command} --help: exit status", True, "\nExit status: 0" in done.stdout)
    check(f"{command} --help ends with examples", True, "Examples:\n  raytracer " in done.stdout)
    for line in done.stdout.splitlines():
        if len(line) > 80:
            failures.append(f"{command} --help: a line of {len(line)} columns: {line}")
    return re.findall(r"^  (--[a-z-]+)", done.stdout, re.M)


def check_refused(arguments, text, command="raytracer"):
    done = run(*arguments)
    line = f"{command}: {text}\n"
    check(f"{arguments}", (2, "", line), (done.returncode, done.stdout, done.stderr))
    check_width(arguments, done.stderr.rstrip("\n"))


# Option, what it expects, and numbers in its range.
NUMBERS = {
    "render": {
        "LONG_EDGE_PIXELS": ("a whole number from 1 to 65536", ["1", "65536"]),
        "--max-recursion": ("a whole number from 0 to 1000", ["0", "1000"]),
        "--samples": ("a whole number from 1 to 65536", ["1", "65536"]),
        "--adaptive": ("a number from 0 to 1", ["0", "1", "1e-400", "+.5"]),
        "--cutoff": ("a number not below 0", ["0", "1e300"]),
        "--threads": ("a whole number from 0 to 4096", ["0", "4096"]),
        "--target-error": ("a number not below 1e-09", ["1e-9", "1"]),
        "--target-time": ("a number above 0", ["1e-300"]),
    },
    "assemble": {"--threads": ("a whole number from 0 to 4096", ["0", "4096"])},
    "compare": {
        "--max-pixels": ("a whole number not below 0", ["0", "18446744073709551615"]),
        "--tolerance": ("a whole number from 0 to 255", ["0", "255"]),
        "--min-score": ("a whole number from 0 to 100", ["0", "100"]),
    },
    "grade": {
        "--timeout": ("a number above 0", ["1e-3", "1e300"]),
        "--wall": ("a number above 0", ["1e-3", "1e300"]),
        "--memory": ("a whole number from 1 to 500000", ["1", "500000"]),
        "--jobs": ("a whole number from 1 to 1024", ["1", "1024"]),
        "--points": ("a number above 0", ["0.5"]),
        "--max-pixels": ("a whole number not below 0", ["0"]),
        "--tolerance": ("a whole number from 0 to 255", ["0"]),
        "--min-score": ("a whole number from 0 to 100", ["0"]),
    },
    "explain": {
        "LONG_EDGE_PIXELS": ("a whole number from 1 to 65536", ["1", "65536"]),
        "X": ("a whole number", ["0"]),
        "Y": ("a whole number", ["0"]),
        "--depth": ("a whole number from 0 to 1000", ["0"]),
        "--max-recursion": ("a whole number from 0 to 1000", ["0"]),
        "--cutoff": ("a number not below 0", ["0"]),
        "--threads": ("a whole number from 0 to 4096", ["0"]),
    },
    "tradeoff": {
        "--size": ("a whole number from 16 to 4096", ["16", "4096"]),
        "--samples": ("a whole number from 2 to 256", ["2", "256"]),
        "--repeats": ("a whole number from 1 to 1000", ["1", "1000"]),
        "--threads": ("a whole number from 0 to 4096", ["0"]),
    },
}
# The arguments of each command; none of them is there, so that a command line that is read ends all the same.
ARGUMENTS = {
    "render": {"SCENE": "/no.json", "IMAGE_OUT": "/no/no.png", "LONG_EDGE_PIXELS": "8"},
    "assemble": {"PART": "/no.part", "IMAGE_OUT": "/no/no.png"},
    "compare": {"A": "/no.png", "B": "/no.png"},
    "grade": {"DIR": "/no"},
    "explain": {"SCENE": "/no.json", "X": "0", "Y": "0", "LONG_EDGE_PIXELS": "8"},
    "tradeoff": {"SCENE": "/no.json"},
}


def with_number(command, name, text):
    arguments = ARGUMENTS[command] | ({} if name.startswith("-") else {name: text})
    others = {"--timeout": ["--program", "no"], "--wall": ["--program", "no"],
              "--memory": ["--program", "no"], "--jobs":
              ["--program", "no", "--submissions", "no"],
              "--points": ["--gradescope", "/no/no"]}.get(name, [])
    return [*COMMANDS[command], *arguments.values(), *([name, text] if name.startswith("-") else []), *others]


def just_outside(expected):
    """Numbers next to the range that the words name."""
    outside = {"a whole number": ["2147483648", "1.0"]}.get(expected, ["-1", "1e999"])
    if " from " in expected:
        least, most = re.findall(r"\d+", expected)
        outside = [str(int(least) - 1), str(int(most) + 1), "99999999999999999999"]
        outside += [least + ".0"] if "whole" in expected else [most + ".01"]
    return outside + (["0", "-0"] if " above " in expected else [])


def check_numbers(command, name, expected, good):
    full = " ".join(["raytracer", *COMMANDS[command]])
    for text in just_outside(expected) + ["nan", "inf", "-inf", "0x10", "1e", "", " 1", "1 ", "1,5", "++1",
                                          "ten"]:
        is_endless = text in ("1e999", "nan", "inf", "-inf") and re.match("a number (not|above)", expected)
        wanted = expected.replace("a number", "a finite number") if is_endless else expected
        if (expected, text) == ("a whole number", "2147483648"):
            wanted = "at most 2147483647"
        remedy = "; write 1.5" if text == "1,5" and re.match("a number (not|above)", expected) else ""
        check_refused(with_number(command, name, text), f'{name}: expected {wanted}, found "{text}"{remedy}',
                      full)
    for text in good:
        done = run(*with_number(command, name, text))
        if done.returncode != 2 or name in done.stderr or "--help" in done.stderr:
            failures.append(f"{command} {name} {text}: not taken: {done.stderr}")


def check_other_refusals():
    render = list(ARGUMENTS["render"].values())
    check_refused([*render, "--pass", "depth"], '--pass: expected color, raycast or normals, found "depth"')
    check_refused([*render, "--accelerator", "BHV"],
                  '--accelerator: expected bvh or none, found "BHV"; did you mean "bvh"?')
    check_refused(["grade", "/no", "--stage", "difuse"],
                  '--stage: expected a name in --help, found "difuse"; did you mean "diffuse"?',
                  "raytracer grade")
    check_refused([*render, "--colour"], "unknown option --colour (see --help)")
    check_refused([*render, "--sample", 4], "unknown option --sample; did you mean --samples?")
    check_refused(["--recursion", 4], "unknown option --recursion; did you mean --max-recursion?")
    check_refused(["--quite", "/no.json"], "unknown option --quite; did you mean --quiet?")
    check_refused(["--depth=4"], "unknown option --depth; did you mean --max-recursion?")
    for option, meant in (("-help", "--help"), ("--halp", "--help"), ("-v", "--version"),
                          ("--print-shema", "--print-schema"), ("--sam", "--samples"),
                          ("--silence", "--quiet"), ("--recursion-depth", "--max-recursion"),
                          ("\u2013samples", "--samples"), ("\u2014watch", "--watch")):
        check_refused([*render, option], f"unknown option {option}; did you mean {meant}?")
    for option in ("--target", "-x"):
        check_refused([*render, option], f"unknown option {option} (see --help)")
    check_refused([*render, "--target-time", "0s"], '--target-time: expected a number above 0, found "0s"')
    check_refused(["--help=foo"], '--help: expected no value, found "foo"')
    check_refused([*render, "--print-schema"], "--print-schema stands alone")
    check_refused(["/no.json", "-o", "out.png", 600], "unknown option -o; the order is " + ORDER)
    check_refused([*render, "--samples"], "--samples: expected a whole number from 1 to 65536, found nothing")
    check_refused([*render, "--crop", "--stats"], "--crop: expected x0,y0,x1,y1, found nothing")
    check_refused([*render, "--quiet=yes"], '--quiet: expected no value, found "yes"')
    check_refused([*render, "--samples", "1", "--samples", "x"],
                  '--samples: expected a whole number from 1 to 65536, found "x"')
    for target in ("--target-error", "--target-time"):
        for other in ("--samples", "--adaptive", "--max-recursion", "--cutoff"):
            check_refused([*render, target, "1", other, "1"],
                          f"{target} and {other} exclude each other: give one of them")


ORDER = "SCENE IMAGE_OUT LONG_EDGE_PIXELS"


def check_order():
    render = list(ARGUMENTS["render"].values())
    check_refused([], f"SCENE is missing; the order is {ORDER} (see --help)")
    check_refused(["a.json", "600"], f"IMAGE_OUT is missing; the order is {ORDER} (see --help)")
    check_refused(render[:2], f"LONG_EDGE_PIXELS is missing; the order is {ORDER} (see --help)")
    check_refused(["compare", "a"], "B is missing; the order is A B (see --help)", "raytracer compare")
    check_refused(["tradeoff"], "SCENE is missing; the order is SCENE... (see --help)", "raytracer tradeoff")
    check_refused([*render, "more"], f'unexpected argument "more"; the order is {ORDER}')
    check_refused([*render, "400"], f'unexpected argument "400"; the order is {ORDER}')
    check_refused(["a.png", "a.json", "600"], f"is a.png the picture? The order is {ORDER}")
    check_refused(["600", "a.json", "a.png"], f"is a.json the scene? The order is {ORDER}")
    check_refused(["a.json", "600", "a.png"], f"is a.png the picture? The order is {ORDER}")
    check_refused(["a.png", "a.json"], f"is a.png the picture? The order is {ORDER}")
    check_refused(["explain", "1", "2", "a.json", "600"],
                  "is a.json the scene? The order is SCENE X Y LONG_EDGE_PIXELS",
                  "raytracer explain")
    check_refused(["explain", "a.json", "b.png", "600"],
                  "is b.png the picture? Give it with --picture; the order is SCENE X Y LONG_EDGE_PIXELS",
                  "raytracer explain")


def check_odd_names():
    """Names of files that look like something else."""
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder, "o.png")
        for name in ("8", "nan", "compare", "a=b", "-s", "--quiet"):
            pathlib.Path(folder, name).write_bytes(pathlib.Path(SCENE).read_bytes())
            for words in (["--quiet", "--", name, picture, "4"], ["explain", "--", name, "0", "0", "4"]):
                done = subprocess.run([RAYTRACER, *words], cwd=folder, capture_output=True, text=True)
                check(f"a scene named {name}: {words[0]}", (0, ""), (done.returncode, done.stderr))


def check_commands():
    check_refused(["comapre", "a.png", "b.png"], 'unknown command "comapre"; did you mean "compare"?')
    check_refused(["render", "a.json"], 'unknown command "render"; write raytracer ' + ORDER)
    check_refused(["help"], 'unknown command "help"; write raytracer --help')
    check_refused(["frobnicate"],
                  '"frobnicate" is no scene and no command (assemble, compare, explain, grade, tradeoff)')
    check_refused(["/frobnicate"], f"IMAGE_OUT is missing; the order is {ORDER} (see --help)")


def check_asked():
    """Help goes first, wherever it stands and whatever else is asked for; but not before what is unknown."""
    for words in (["--help", "--print-manual"], ["--print-schema", "-h"], ["--set", "-x", "--help"],
                  ["compare", "--help"], ["--samples", "-h"]):
        done = run(*words)
        check(f"{words}", (0, "", True), (done.returncode, done.stderr, "\nUsage: raytracer" in done.stdout))
    for words in (["--help", "compare"], ["-h", "compare"]):
        check(f"{words}", run("compare", "--help").stdout, run(*words).stdout)
    check_refused(["--no-such", "--help"], "unknown option --no-such (see --help)")
    check_refused(["--print-manual", "--", "--help"], "--print-manual stands alone")
    check_refused(["--", "--help"], f"IMAGE_OUT is missing; the order is {ORDER} (see --help)")


def check_quiet():
    """compare and grade print nothing, explain its answer alone."""
    with tempfile.TemporaryDirectory() as folder:
        picture, page = pathlib.Path(folder, "least.png"), pathlib.Path(folder, "page.html")
        pathlib.Path(folder, "least.json").write_bytes(pathlib.Path(SCENE).read_bytes())
        check("render --quiet", "", run(SCENE, picture, 4, "--quiet").stderr)
        for words in (["compare", picture, picture], ["grade", folder, "--report", page]):
            done = run(*words, "--quiet")
            check(f"{words[0]} --quiet", (0, "", ""), (done.returncode, done.stdout, done.stderr))
        check("grade --quiet: the page", True, page.stat().st_size > 0)
        check("compare --quiet: not the same", (1, "", ""),
              (lambda done: (done.returncode, done.stdout, done.stderr))(
                  run("compare", picture, "test/bad/files/check.png", "--quiet")))
    check_refused(["compare", "a.png", "b.png", "--json", "--quiet"],
                  "--json and --quiet exclude each other: give one of them", "raytracer compare")
    check("explain --quiet", True, "primary ray" in run("explain", SCENE, 0, 0, 8, "--quiet").stdout)


def check_without_effect():
    render = list(ARGUMENTS["render"].values())
    for value in ("raycast", "normals"):
        for option in ("--only", "--opaque", "--max-recursion", "--cutoff", "--texture-filter"):
            text = {"--only": ["diffuse"], "--texture-filter": ["bilinear"],
                    "--opaque": []}.get(option, ["1"])
            check_refused([*render, "--pass", value, option, *text],
                          f"{option} has no effect with --pass {value}")
    check_refused([*render, "--max-recursion", 0, "--cutoff", 1],
                  "--cutoff has no effect with --max-recursion 0")
    check_refused([*render, "--only", "ambient,textures", "--cutoff", 0.1],
                  "--cutoff has no effect with --only ambient,textures")
    check_refused([*render, "--only", "ambient,refraction", "--texture-filter", "bilinear"],
                  "--texture-filter has no effect with --only ambient,refraction")
    check_refused([*render, "--only", "ambient", "--opaque"], "--opaque has no effect with --only ambient")
    done = run(*render, "--only", "ambient,shadows", "--opaque")
    check("--opaque acts on shadows", False, "no effect" in done.stderr)
    done = run(*render, "--only", "ambient,reflections", "--max-recursion", 0)
    check("--max-recursion acts on reflections", False, "no effect" in done.stderr)
    check_refused([*render, "--samples", 1, "--adaptive", 0.1], "--adaptive has no effect with --samples 1")
    check_refused(["grade", "/no", "--program", "{}/x"],
                  "--program: {} is a submission's folder: it needs --submissions", "raytracer grade")
    for command, option in (("grade /no", "--json"), ("grade /no", "--csv"), ("grade /no", "--junit"),
                            ("grade /no", "--report"), ("grade /no", "--gradescope"),
                            ("compare a b", "--diff"), ("tradeoff a", "--out")):
        check_refused([*command.split(), option, "-"],
                      f'{option}: expected a name, found "-": only a render writes to stdout',
                      "raytracer " + command.split()[0])
    check_refused(["grade", "/no", "--timeout", 1], "--timeout has no effect without --program",
                  "raytracer grade")
    for option in ("--pass", "--samples", "--adaptive", "--crop"):
        check_refused(["explain", "/no.json", 0, 0, 8, option, 1],
                      f"there is no {option}: explain follows the one ray through the pixel's centre",
                      "raytracer explain")


def check_only():
    """Blanks around a term's name are taken; the last of a repeated option wins."""
    render = list(ARGUMENTS["render"].values())
    for first, second in (("--skip-existing", "--stats"), ("--frames=1..2", "--target-time=1"),
                          ("--watch", "--skip-existing")):
        names = " and ".join(word.split("=")[0] for word in (first, second))
        check_refused([*render, first, second], f"{names} exclude each other: give one of them")
    for terms in ("shadows", "reflections,textures"):
        check_refused([*render, "--only", terms],
                      f"--only {terms}: there is no light without ambient, diffuse or specular")
    check_refused([*render, "--only", ""], '--only: expected terms, as ambient,diffuse, found ""')
    check_refused([*render, "--only", "diffuse,"],
                  '--only: a comma too many in "diffuse,"')
    for terms in ("ambient+diffuse", "diffuse specular"):
        check_refused([*render, "--only", terms],
                      f'--only: expected commas between the terms, found "{terms}"')
    check_refused([*render, "--only", "ambient", "diffuse"],
                  "--only has commas, no blanks: write --only ambient,diffuse")
    check_refused([*render, "--only", "difuse, specular"],
                  '--only: no term "difuse"; did you mean "diffuse"?')
    with tempfile.TemporaryDirectory() as folder:
        pictures = []
        for terms in (["diffuse,specular"], [" diffuse , specular"],
                      ["ambient", "--only", "specular,diffuse"]):
            out = pathlib.Path(folder, "out.png")
            check(f"--only {terms}", 0, run(SCENE, out, 8, "--quiet", "--only", *terms).returncode)
            pictures.append(out.read_bytes())
        check("--only with blanks, and twice", pictures[:1] * 3, pictures)


def check_version():
    for words in (["--version"], ["-V"], ["compare", "--version"]):
        done = run(*words)
        check("--version", (0, ""), (done.returncode, done.stderr))
        check("--version", True, bool(re.fullmatch(
            r"raytracer \d+\.\d+ \((commit [0-9a-f]{10}|no commit known)\)\n"
            r"instruction sets: scalar[a-z0-9, ]*; used: \w+\nprecisions: float, double, extended\n",
            done.stdout)))


def check_instruction_set():
    """Of every command, before its work. The other sets are tested by test/same_bytes.py."""
    sets = re.search("instruction sets: (.*); used", run("--version").stdout).group(1).split(", ")
    has = sets[0] if len(sets) == 1 else ", ".join(sets[:-1]) + " or " + sets[-1]
    for arguments in (["--version"], [SCENE, "/tmp/no.png", "8"], ["compare", "/no.png", "/no.png"]):
        done = run(*arguments, RAYTRACER_SIMD="avx99")
        check(f"RAYTRACER_SIMD=avx99, {arguments}",
              (2, "",
               f'raytracer: RAYTRACER_SIMD: expected {has}, which this processor has, found "avx99"\n'),
              (done.returncode, done.stdout, done.stderr))
    for name in sets:
        check(f"RAYTRACER_SIMD={name}", True,
              f"; used: {name}\n" in run("--version", RAYTRACER_SIMD=name).stdout)


def check_shown():
    """What is found is shown shortened, and as text that does nothing to a terminal."""
    render = [*ARGUMENTS["render"].values(), "--texture-filter"]
    expected = "--texture-filter: expected nearest or bilinear, found"
    check_refused([*render, "9" * 400], f'{expected} "{"9" * 60}"...')
    check_refused([*render, "\x1b[31m\x9b\n\x7f"], f'{expected} "\\u001b[31m\\u009b\\n\\u007f"')
    check_refused([*render, "nearest", b"--\x1b[2J\xff\xc2\x9b"],
                  "unknown option --\\x1b[2J\\xff\\xc2\\x9b (see --help)")
    check("a file's name", (2, "/no\\x0a\\x1b.json: cannot read: No such file or directory\n"),
          (lambda done: (done.returncode, done.stderr))(run("explain", "/no\n\x1b.json", 0, 0, 8)))
    long = run(SCENE, "/tmp/no.png", 8, "--crop", "1," * 400).stderr
    check("a long --crop", True, long.endswith("...\n") and len(long) < 200)


def check_crop():
    expected = "raytracer: --crop: expected four whole numbers x0,y0,x1,y1, found "
    for crop in ("1,2,3", "1,2,3,4,", "1,2,3,4,5", "a,b,c,d", "0,0,1,nan", "0,0,,1", "0,0,1,1e0"):
        done = run(SCENE, "/tmp/no.png", 8, "--crop", crop)
        check(f"--crop {crop}", (2, f'{expected}"{crop}"\n'), (done.returncode, done.stderr))


def check_decimal():
    """A leading zero does not make a number octal."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "out.png")
        check("010 pixels", 0, run(SCENE, out, "010", "--quiet").returncode)
        check("010 pixels", 10, max(struct.unpack(">II", out.read_bytes()[16:24])))


def check_many():
    """tradeoff takes any number of scenes, and loads all before it measures one."""
    done = run("tradeoff", SCENE, "test/good/defaults.json", "/no.json", "--quiet")
    check("a third scene that is not there", (2, "", True),
          (done.returncode, done.stdout, done.stderr.startswith("/no.json: ")))


def main():
    for command in COMMANDS:
        options = check_help(command)
        check(f"{command}: options with numbers that the help has", [],
              [name for name in NUMBERS[command] if name.startswith("--") and name not in options])
        for name, (expected, good) in NUMBERS[command].items():
            check_numbers(command, name, expected, good)
    check_other_refusals()
    check_order()
    check_odd_names()
    check_commands()
    check_asked()
    check_quiet()
    check_without_effect()
    check_only()
    check_version()
    check_instruction_set()
    check_crop()
    check_shown()
    check_decimal()
    check_many()
    return conclude("every command line as it should be")


if __name__ == "__main__":
    sys.exit(main())
