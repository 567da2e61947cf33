#!/usr/bin/env bash
# Builds the Debian package, checks it with lintian, and installs, uses and removes it in fresh roots of
# Debian 12 and 13.
#
#     bench/package.sh [SUITES]      as root, with lintian, debootstrap and a MIRROR of Debian
#
# The default of SUITES is "bookworm trixie".
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --build "$top/build/release" --target raytracer documents
(cd "$work" && cpack --config "$top/build/release/CPackConfig.cmake" >/dev/null)
deb=$(echo "$work"/*.deb)
dpkg-deb --info "$deb" | grep -E "Version|Depends|Installed-Size"
lintian --fail-on error,warning "$deb"
echo "lintian: nothing to say"
# Where this machine has its packages from.
sources=(apt-get indextargets --format '$(REPO_URI)' "Created-By: Packages" "Component: main")
mirror=${MIRROR:-$("${sources[@]}" | head -1)}
for suite in ${1:-bookworm trixie}; do
    root=$work/$suite
    debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$work/log" 2>&1 ||
        { tail -5 "$work/log"; exit 1; }
    cp "$deb" "$root/raytracer.deb"
    cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
    inside() { chroot "$root" "$@"; }
    inside sh -c "apt-get install -y -qq --no-install-recommends /raytracer.deb" >"$work/log" 2>&1 ||
        { tail -5 "$work/log"; exit 1; }
    inside raytracer --version
    inside raytracer /usr/share/doc/raytracer/examples/spheres_cylinder.json /out.png 300
    inside raytracer compare /out.png /out.png >/dev/null
    inside raytracer --print-schema | cmp - "$root/usr/share/raytracer/scene.schema.json"
    inside dpkg --remove raytracer >/dev/null
    left=$(find "$root/usr" -name '*raytracer*' -not -path '*/dpkg/*')
    [ -z "$left" ] || { echo "left: $left"; exit 1; }
    echo "$suite: installed, used, removed"
done
