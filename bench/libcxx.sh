#!/usr/bin/env bash
# Builds with clang and libc++, as on macOS, and runs the tests.
#
#     bench/libcxx.sh [VERSION]    with Debian's clang-VERSION; as root
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
version=${1:-16} build=$top/build/libcxx
if [ ! -e "/usr/lib/llvm-$version/include/c++/v1" ] || ! type "clang++-$version" >/dev/null 2>&1; then
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
        "clang-$version" "libc++-$version-dev" "libc++abi-$version-dev"
fi
cmake -S "$top" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER="clang++-$version" -DCMAKE_CXX_FLAGS=-stdlib=libc++ >/dev/null
ninja -C "$build" --quiet
# Tests that measure pictures, or how long the programs of a class take, run in GCC's release build only.
ctest --test-dir "$build" --output-on-failure -j "$(nproc)" -E \
    'target-error|error of a picture|error falls|counts are monotone|speed for accuracy|browser|schema'
