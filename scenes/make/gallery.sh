#!/usr/bin/env bash
# Renders every picture in ../gallery: the README's large one and the small ones. Well sampled, unlike
# test/expected.
#
#     scenes/make/gallery.sh              # all of them, in about two minutes
#     scenes/make/gallery.sh nested_glass # some
#
# RAYTRACER names another program than build/release/raytracer.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
raytracer=${RAYTRACER:-build/release/raytracer}
wanted=("$@")
mkdir -p scenes/gallery

picture() {  # NAME PIXELS options...
    local name=$1 pixels=$2
    shift 2
    if [ ${#wanted[@]} -gt 0 ] && [[ " ${wanted[*]} " != *" $name "* ]]; then return; fi
    echo "$name"
    "$raytracer" "scenes/$name.json" "scenes/gallery/$name.png" "$pixels" \
        --quiet --strict --texture-filter bilinear "$@"
}

picture lantern_lake 1200 --samples 36 --max-recursion 8 --cutoff 0.002
picture nested_glass 400 --samples 16 --max-recursion 12 --cutoff 0.002
picture mesh 400 --samples 16
picture orthographic_test1 400 --samples 16 --max-recursion 6 --cutoff 0.002
picture orthographic_test2 400 --samples 16 --max-recursion 6 --cutoff 0.002
picture mirror_corridor 400 --samples 16 --max-recursion 24 --cutoff 0.002
picture refraction_inside 400 --samples 16 --max-recursion 8 --cutoff 0.002
picture extreme_scale 400 --samples 16 --max-recursion 8 --cutoff 0.002
picture stress_test 400 --samples 16 --max-recursion 8 --cutoff 0.002
picture texture 400 --samples 16 --max-recursion 8 --cutoff 0.002
