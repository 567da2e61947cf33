"""Every command's command line: its help fits a terminal, and what it refuses is said in one line.

Usage: command_line_check.py RAYTRACER, from the source folder.
"""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

RAYTRACER = str(pathlib.Path(sys.argv[1]).resolve())
SCENE = str(pathlib.Path("test/good/least.json").resolve())
COMMANDS = {"render": [], "compare": ["compare"], "grade": ["grade"], "explain": ["explain"], "tradeoff": ["tradeoff"]}
failures = []


def check(what, expected, found):
    if expected != found:
        failures.append(f"{what}: expected {expected!r}, found {found!r}")


def run(*arguments):
    words = [word if isinstance(word, bytes) else str(word) for word in arguments]
    return subprocess.run([RAYTRACER, *words], capture_output=True, text=True, timeout=60)


def check_help(command):
    done = run(*COMMANDS[command], "--help")
    check(f"{command} --help", (0, ""), (done.returncode, done.stderr))
    check(f"{command} --help ends with examples", True, "Examples:\n  raytracer " in done.stdout)
    for line in done.stdout.splitlines():
        if len(line) > 80:
            failures.append(f"{command} --help: a line of {len(line)} columns: {line}")
    return re.findall(r"^  (--[a-z-]+)", done.stdout, re.M)


def check_refused(arguments, text, command="raytracer"):
    done = run(*arguments)
    line = f"{command}: {text} ({command} --help tells more)\n"
    check(f"{arguments}", (2, "", line), (done.returncode, done.stdout, done.stderr))


# Option, what it expects, and numbers in its range.
NUMBERS = {
    "render": {
        "LONG_EDGE_PIXELS": ("a whole number from 1 to 65536", ["1", "65536"]),
        "--max-recursion": ("a whole number from 0 to 1000", ["0", "1000"]),
        "--samples": ("a whole number from 1 to 65536", ["1", "65536"]),
        "--adaptive": ("a number not below 0", ["0", "1e-400", "+.5"]),
        "--cutoff": ("a number not below 0", ["0", "1e300"]),
        "--threads": ("a whole number from 0 to 4096", ["0", "4096"]),
        "--target-error": ("a number above 0", ["1e-300"]),
        "--target-time": ("a number above 0", ["1e-300"]),
    },
    "compare": {
        "--max-pixels": ("a whole number not below 0", ["0", "18446744073709551615"]),
        "--tolerance": ("a whole number from 0 to 255", ["0", "255"]),
        "--min-score": ("a whole number from 0 to 100", ["0", "100"]),
    },
    "grade": {
        "--size": ("a whole number from 1 to 65536", ["1", "65536"]),
        "--timeout": ("a number above 0", ["1e-3", "1e300"]),
        "--max-pixels": ("a whole number not below 0", ["0"]),
        "--tolerance": ("a whole number from 0 to 255", ["0"]),
        "--min-score": ("a whole number from 0 to 100", ["0"]),
    },
    "explain": {
        "LONG_EDGE_PIXELS": ("a whole number from 1 to 65536", ["1", "65536"]),
        "X": ("a whole number", ["0"]),
        "Y": ("a whole number", ["0"]),
        "--max-recursion": ("a whole number from 0 to 1000", ["0"]),
        "--samples": ("a whole number from 1 to 65536", ["1"]),
        "--adaptive": ("a number not below 0", ["0"]),
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
    "compare": {"A": "/no.png", "B": "/no.png"},
    "grade": {"DIR": "/no"},
    "explain": {"SCENE": "/no.json", "X": "0", "Y": "0", "LONG_EDGE_PIXELS": "8"},
    "tradeoff": {"SCENE": "/no.json"},
}


def with_number(command, name, text):
    arguments = ARGUMENTS[command] | ({} if name.startswith("-") else {name: text})
    return [*COMMANDS[command], *arguments.values(), *([name, text] if name.startswith("-") else [])]


def just_outside(expected):
    """Numbers next to the range that the words name."""
    outside = {"a whole number": ["2147483648", "1.0"]}.get(expected, ["-1", "1e999"])
    if " from " in expected:
        least, most = re.findall(r"\d+", expected)
        outside = [str(int(least) - 1), str(int(most) + 1), "99999999999999999999", least + ".0"]
    return outside + (["0", "-0"] if " above " in expected else [])


def check_numbers(command, name, expected, good):
    full = " ".join(["raytracer", *COMMANDS[command]])
    for text in just_outside(expected) + ["nan", "inf", "-inf", "0x10", "1e", "", " 1", "1 ", "1,5", "++1", "ten"]:
        if text == "-inf" and not name.startswith("-"):
            continue  # looks like an option
        check_refused(with_number(command, name, text), f'{name}: expected {expected}, found "{text}"', full)
    for text in good:
        done = run(*with_number(command, name, text))
        if done.returncode != 2 or name in done.stderr or "--help" in done.stderr:
            failures.append(f"{command} {name} {text}: not taken: {done.stderr}")


def check_other_refusals():
    render = list(ARGUMENTS["render"].values())
    check_refused([*render, "--pass", "depth"], '--pass: expected color, raycast or normals, found "depth"')
    check_refused([*render, "--accelerator", "BVH"], '--accelerator: expected bvh or none, found "BVH"')
    check_refused([*render, "--colour"], "The following argument was not expected: --colour")
    check_refused([*render, "more"], "The following argument was not expected: more")
    check_refused(render[:2], "LONG_EDGE_PIXELS is required")
    check_refused([], "SCENE is required")
    check_refused([*render, "--samples", "1", "--samples", "2"], "--samples: At Most 1 required but received 2")
    check_refused(["compare", "a"], "B is required", "raytracer compare")
    for target in ("--target-error", "--target-time"):
        for other in ("--samples", "--adaptive", "--max-recursion", "--cutoff"):
            done = run(*render, target, "1", other, "1")
            check(f"{target} and {other}", 2, done.returncode)
            check(f"{target} and {other}", True, " excludes " in done.stderr and done.stderr.count("\n") == 1)


def check_shown():
    """What is found is shown shortened, and as text that does nothing to a terminal."""
    render = [*ARGUMENTS["render"].values(), "--texture-filter"]
    expected = "--texture-filter: expected nearest or bilinear, found"
    check_refused([*render, "9" * 400], f'{expected} "{"9" * 60}"...')
    check_refused([*render, "\x1b[31m\x9b\n\x7f"], f'{expected} "\\u001b[31m\\u009b\\n\\u007f"')
    check_refused([*render, "nearest", b"\x1b[2J\xff\xc2\x9b"], "The following argument was not expected: \\x1b[2J\\xff\\xc2\\x9b")
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
    done = run("tradeoff", SCENE, SCENE, "/no.json", "--quiet")
    check("a third scene that is not there", (2, "", True), (done.returncode, done.stdout, done.stderr.startswith("/no.json: ")))


def main():
    for command in COMMANDS:
        options = check_help(command)
        check(f"{command}: options with numbers that the help has", [],
              [name for name in NUMBERS[command] if name.startswith("--") and name not in options])
        for name, (expected, good) in NUMBERS[command].items():
            check_numbers(command, name, expected, good)
    check_other_refusals()
    check_crop()
    check_shown()
    check_decimal()
    check_many()
    print("\n".join(failures) if failures else "every command line as it should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
