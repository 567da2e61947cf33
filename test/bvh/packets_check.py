"""Tests that the object files for newer processors define no function that other files may define, too.

bvh_kernel.cpp and packet_tracer.cpp are compiled for newer processors, too. If they define a function that
other files also define (for example an inline one of the standard library), the linker may choose their
version for all files, and an older processor would run it.

    packets_check.py PROGRAM NM INSTRUCTION_SET OBJECT...
"""
import subprocess
import sys


def main():
    nm, instruction_set, objects = sys.argv[2], sys.argv[3], sys.argv[4:]
    namespace, shared = "lanes_" + instruction_set, []
    for path in objects:
        symbols = subprocess.run([nm, path], check=True, capture_output=True, text=True).stdout.splitlines()
        own = [line for line in symbols if namespace in line]
        if not own:
            sys.exit(f"{path}: nothing of namespace {namespace} in it")
        shared += [line for line in symbols if line not in own and line.split()[-2] in "WVu"]
    if shared:
        sys.exit(f"compiled for {instruction_set}, but not in namespace {namespace}:\n" + "\n".join(shared))


if __name__ == "__main__":
    main()
