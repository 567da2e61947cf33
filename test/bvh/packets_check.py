"""bvh_kernel.cpp and packet_tracer.cpp are compiled for AVX2 too. A function there that other files may have as well (an inline
one of the standard library, say) could be linked for them and run on a processor without AVX2: there must be none.

    packets_check.py PROGRAM NM OBJECT...
"""
import subprocess
import sys


def main():
    nm, objects = sys.argv[2], sys.argv[3:]
    shared = []
    for path in objects:
        symbols = subprocess.run([nm, path], check=True, capture_output=True, text=True).stdout.splitlines()
        own = [line for line in symbols if "lanes_avx2" in line]
        if not own:
            sys.exit(f"{path}: nothing of namespace lanes_avx2 in it")
        shared += [line for line in symbols if line not in own and line.split()[-2] in "WVu"]
    if shared:
        sys.exit("compiled for AVX2, but not in namespace lanes_avx2:\n" + "\n".join(shared))


if __name__ == "__main__":
    main()
