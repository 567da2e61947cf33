#!/usr/bin/env bash
# Cross-compiles build/windows/raytracer.exe, one file that needs no other, with Debian's MinGW-w64, and tries
# it under Wine: pictures of all scenes with each instruction set, the commands, file names, mistakes.
#
#     bench/windows.sh [cmake -D options]    as root, with build/release/raytracer to compare with
set -euo pipefail
top=$(cd "$(dirname "$0")/.." && pwd)
build=$top/build/windows prefix=$top/build/windows/prefix triple=x86_64-w64-mingw32
if ! type $triple-g++-posix wine dpkg-source >/dev/null 2>&1; then
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
        g++-mingw-w64-x86-64-posix wine wine64 dpkg-dev
fi
mkdir -p "$prefix/include" "$prefix/lib" "$prefix/share/cmake"

# Debian has these libraries for MinGW in source only. Of the system's headers the compiler must not see
# others.
cp -r /usr/include/{glm,nlohmann,stb} "$prefix/include/"
cp -r /usr/share/cmake/{glm,nlohmann_json} "$prefix/share/cmake/"
if [ ! -e "$prefix/lib/libdeflate.a" ]; then
    rm -rf "$build/source" && mkdir -p "$build/source/lists/partial" && cd "$build/source"
    sources=(apt-get indextargets --format '$(REPO_URI)' "Created-By: Packages" "Component: main")
    suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
    echo "deb-src $("${sources[@]}" | head -1) $suite main" >list
    apt=(-qq -o "Dir::Etc::sourcelist=$PWD/list" -o Dir::Etc::sourceparts=/dev/null
        -o "Dir::State::Lists=$PWD/lists")
    apt-get "${apt[@]}" update && apt-get "${apt[@]}" source libdeflate >/dev/null
    cd libdeflate-*/
    for file in lib/*.c lib/x86/*.c; do $triple-gcc -O2 -I. -c "$file" -o "../${file//\//-}.o"; done
    $triple-ar rcs "$prefix/lib/libdeflate.a" ../*.o
    cp libdeflate.h "$prefix/include/"
fi
cmake -S "$top" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF \
    -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=x86_64 \
    -DCMAKE_CXX_COMPILER=$triple-g++-posix -DCMAKE_RC_COMPILER=$triple-windres \
    -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_FIND_ROOT_PATH_MODE_{LIBRARY,INCLUDE,PACKAGE}=ONLY \
    "$@" >"$build/log" ||
    { cat "$build/log"; exit 1; }
ninja -C "$build" raytracer

exe=$build/raytracer.exe native=$top/build/release/raytracer work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export WINEPREFIX=$build/wine WINEDEBUG=-all LC_ALL=C.UTF-8
run() { wine "$exe" "$@" </dev/null; }
tried() { echo "tried: $*"; }
fail() { echo "FAILED: $*"; exit 1; }
windowsName() { echo "Z:${1//\//\\}"; }
refused() {  # STATUS MESSAGE WORDS...
    local status=0
    run "${@:3}" >"$work/said" 2>&1 || status=$?
    [ $status = "$1" ] && grep -aqF "$2" "$work/said" || fail "${*:3}: status $status, $(cat "$work/said")"
}
cd "$top"
run --version
run --print-schema | cmp - scenes/scene.schema.json
for set in scalar sse2 avx2 avx512; do
    if ! RAYTRACER_SIMD=$set "$native" --version | grep -q "used: $set"; then continue; fi
    for scene in scenes/*.json; do
        if [ "$scene" = scenes/scene.schema.json ]; then continue; fi
        "$native" "$scene" "$work/linux.png" "${SIZE:-60}" --quiet
        RAYTRACER_SIMD=$set run "${scene//\//\\}" "$work/windows.png" "${SIZE:-60}" --quiet
        cmp "$work/linux.png" "$work/windows.png" || fail "$scene, $set"
    done
    tried "each scene with $set: the bytes of Linux"
done
for options in "--precision float" "--precision extended" "--samples 4 --adaptive 0.02" \
    "--max-recursion 1"; do
    for scene in scenes/{texture,mesh,refraction,cone_cube}.json; do
        "$native" "$scene" "$work/linux.png" 40 --quiet $options
        run "$scene" "$work/windows.png" 40 --quiet $options
        cmp "$work/linux.png" "$work/windows.png" || fail "$scene $options"
    done
    tried "four scenes, $options: the bytes of Linux"
done

mkdir "$work/Größe"
cp -r scenes/textures scenes/meshes "$work/Größe/"
mkdir "$work/folder.png"
cp scenes/texture.json "$work/Größe/Kugel ä €.json"
folder=$(windowsName "$work")\\Größe
run "$folder\\Kugel ä €.json" "$folder\\Bild ö 🎈.png" 60 --quiet
"$native" scenes/texture.json "$work/linux.png" 60 --quiet
cmp "$work/linux.png" "$work/Größe/Bild ö 🎈.png"
(cd "$work/Größe" && run 'Kugel ä €.json' "..\\neben.png" 60 --quiet)
cmp "$work/linux.png" "$work/neben.png"
refused 2 'cannot read: No such file or directory; there is' "$folder\\Kugel ä.json" x.png 60
tried "drives, backslashes, blanks, umlauts; a name that is nearly there"
refused 2 'cannot write: Is a directory' scenes/texture.json "$(windowsName "$work/folder.png")" 60
refused 2 'cannot write: No such file or directory' scenes/texture.json "$folder\\no\\x.png" 60
chmod a-w "$work/neben.png"
[ "$(id -u)" = 0 ] || refused 2 'cannot write: Permission denied' scenes/texture.json "$work/neben.png" 60
run scenes/texture.json - 60 --quiet | cmp - "$work/linux.png"
tried "folders that are not there or are in the way; standard output"

run compare "$work/linux.png" "$work/Größe/Bild ö 🎈.png"
refused 2 'found 40 x 40' compare "$work/linux.png" "$work/windows.png"
for command in "explain scenes/texture.json 10 50 60" "explain scenes/texture.json 10 50 60 --json"; do
    "$native" $command >"$work/linux.txt"
    run $command | tr -d '\r' | cmp - "$work/linux.txt"
done
run tradeoff scenes/cone_cube.json --out "$work/out" --size 16 --repeats 1 --samples 2 --quiet >/dev/null
[ -e "$work/out/tradeoff.html" ]
run grade scenes --references test/expected --report "$work/report.html" | tail -1
mkdir -p "$work/class/änne"
cp test/expected/*.png "$work/class/änne"
run grade scenes --references test/expected --submissions "$(windowsName "$work/class")" | tail -2
tried "compare, explain, tradeoff, grade of pictures"
refused 2 'programs are run on Linux only' grade scenes --references test/expected --program ./x
