#!/usr/bin/env python3
"""Checks that a room includes only itself and rooms below it, and no private header of another room.

    layers_check.py ROOT

The order is the one of src/README.md. include/raytracer/ROOM/ is what a room offers; src/ROOM/ is private to
it and to its tests. A library that one room, or one file, wraps is included only there; only util may include
headers of the platform. Calls of the file system must take an error code, since the messages of the
exceptions that they throw are not for users.
"""
import pathlib
import re
import sys

# From the top floor down.
rooms = ["commands", "accuracy", "grading", "explain", "tracer", "geometry", "bvh", "numerics", "scene",
         "pictures", "json",
         "util"]
floor = {room: -place for place, room in enumerate(rooms)}

# What is included, by whom alone.
wrapped = {
    r"nlohmann/": {"json"},
    r"stb_image": {"pictures"},
    r"libdeflate": {"pictures"},
    r"(sys|linux)/|(unistd|fcntl|poll|dirent|pwd|grp|pthread|signal|malloc|io|windows|psapi)\.h$": {"util"},
}
platform = re.compile(r"\s*#\s*(el)?if.*(_WIN32|__MINGW32__|__linux__|__APPLE__|__unix__)")

# The plain tracer that the tests compare the tracer with shares no more with it than the description of a
# scene.
independent = {"test/tracer/plain_tracer.h": {"scene", "pictures"}}

# What asks the file system, or walks it.
asks = re.compile(r"\b(?:std::filesystem|fs|files)::(?!path\b|file_time_type\b)(\w+)(?: \w+)?(?=[({])|"
                  r"(?:\.|->)(is_(?!absolute|relative)\w+|file_size)(?=\(\))")


def room_of(path):
    parts = path.parts
    if parts[0] == "include":
        return parts[2]
    return "commands" if parts == ("src", "main.cpp") else parts[1]


def faults_of(root, path):
    relative = path.relative_to(root)
    room, is_test = room_of(relative), relative.parts[0] == "test"
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if platform.match(line) and room != "util":
            yield f"{relative}:{number}: {room} asks for the platform, which util alone knows"
        match = re.match(r'\s*#\s*include\s*(["<])([^">]+)', line)
        if not match:
            continue
        quote, name = match.groups()
        place = f"{relative}:{number}: {room} includes {name}"
        if not is_test and any(re.match(pattern, name) and not who & {room, str(relative)}
                               for pattern, who in wrapped.items()):
            yield f"{place}, which is wrapped elsewhere"
        if quote == "<":
            continue
        if name.startswith("raytracer/"):
            other = name.split("/")[1]
            if not (root / "include" / name).is_file():
                yield f"{place}, which is not there"
            elif other not in floor:
                yield f"{place}, of a room that is not known"
            elif room in floor and floor[other] > floor[room]:
                yield f"{place}, which is above it"
            elif other not in independent.get(str(relative), rooms):
                yield f"{place}, which it is to check"
        else:
            target = (path.parent / name).resolve()
            if not target.is_file():
                yield f"{place}, which is not there"
            elif target.relative_to(root).parts[0] == "src" and room_of(target.relative_to(root)) != room:
                yield f"{place}, a private header of another room"


def throwing_calls_of(root, path):
    """A range-based for's iterator throws, too. A status that somebody else asked for does not."""
    text = path.read_text()
    codes = re.findall(r"std::error_code&? (\w+)|file_status (\w+)|((?:symlink_)?status)\(", text)
    known = {name for names in codes for name in names} | {"error_code"}
    for call in asks.finditer(text):
        depth, end = 1, call.end() + 1
        while depth > 0:
            depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(text[end], 0)
            end += 1
        in_for = re.search(r"for \([^;()]* : $", text[:call.start()])
        if in_for or not known & set(re.findall(r"\w+", text[call.end():end])):
            line = text.count("\n", 0, call.start()) + 1
            yield f"{path.relative_to(root)}:{line}: {call[1] or call[2]} throws: give it an error code"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    files = [path for folder in ("include", "src", "test") for path in sorted((root / folder).rglob("*"))
             if path.suffix in (".h", ".cpp", ".inc")]
    faults = [fault for path in files for fault in faults_of(root, path)]
    faults += [fault for path in files if path.relative_to(root).parts[0] != "test"
               for fault in throwing_calls_of(root, path)]
    faults += [f"src/{path.name}: lies in no room" for path in (root / "src").iterdir()
               if path.is_file() and path.name not in ("main.cpp", "README.md")]
    for room in rooms:
        count = sum(path.is_file() for path in (root / "src" / room).glob("*"))
        if count > 25:
            faults.append(f"src/{room}: {count} files; a room has at most 25")
    print("\n".join(faults) if faults else f"{len(files)} files keep to their floors")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
