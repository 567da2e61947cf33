"""Shared by the tests of the commands: the program, the list of faults, and the end of a test."""
import pathlib
import re
import subprocess
import sys

RAYTRACER = str(pathlib.Path(sys.argv[1]).resolve())
failures = []


def check(what, expected, found):
    if expected != found:
        failures.append(f"{what}: expected {expected!r}, found {found!r}")


def check_width(what, line):
    """A message has at most 100 columns apart from names of files, with a place in them, and from what its
    reader typed beyond 12 letters."""
    named = re.sub(r"[\w./\\%-]*\.(json|png|pfm|jpg|obj|html|txt)\b(:\d+:\d+)?|looked in .*", "", line)
    columns = len(re.sub(r'(found "[^"]{12})[^"]+', r"\1", named))
    if columns > 100:
        failures.append(f"{what}: {columns} columns without names of files: {line}")


def run(*arguments, given=b""):
    """(status, stderr); what is given comes from a pipe."""
    done = subprocess.run([RAYTRACER, *map(str, arguments)], input=given, capture_output=True, timeout=100)
    return done.returncode, done.stderr.decode()


def conclude(good):
    """Prints the failures, or this; returns the exit status."""
    print("\n".join(failures) or good)
    return 1 if failures else 0
