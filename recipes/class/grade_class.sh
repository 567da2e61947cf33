#!/bin/sh
# Grades a class: grade_class.sh EXAM CLASS [PROGRAM]
# EXAM has the scenes and their reference pictures, CLASS a folder for each submission. With PROGRAM, say
# build/raytracing, each submission's own makes its pictures; without, the pictures lie in its folder.
set -eu
if [ $# -lt 2 ]; then sed -n '2,4s/^# \{0,1\}//p' "$0" >&2; exit 2; fi
exam=$1
class=$2
if [ $# -gt 2 ]; then set -- --program "{}/$3" --jobs "$(nproc)"; else set --; fi
raytracer grade "$exam" --submissions "$class" "$@" --report class.html --csv class.csv
