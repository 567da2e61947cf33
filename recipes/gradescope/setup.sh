#!/bin/sh
# Gradescope runs this once, as root, when the autograder is made: it builds raytracer.
set -eu
apt-get update
apt-get install -y git make
git clone --depth 1 "${RAYTRACER_SOURCE:?the address of the repository of raytracer}" /opt/raytracer
/opt/raytracer/run build
ln -sf /opt/raytracer/build/release/raytracer /usr/local/bin/raytracer
useradd --no-create-home student
