#!/usr/bin/env python3
"""Checks that the papers name only files that exist, and that they are short.

    papers_check.py ROOT [--words]

Every relative link, and every path in backticks or in a code block, of README.md, src/README.md,
bench/README.md and Notes.txt exists. README.md has at most 1,500 words of prose (without code, tables,
pictures and addresses), Notes.txt at most 120 lines. A line that is not of a table ends by column 110, in
Notes.txt by column 100; so does a line of Python, CMake and shell (clang-format checks C++). Comments name no
file that is not there. --words prints the count.
"""
import pathlib
import re
import sys

MOST_WORDS, MOST_LINES = 1500, 120
MOST_COLUMNS = {".md": 110, ".txt": 100}
MOST_CODE_COLUMNS = 110
PAPERS = ["README.md", "src/README.md", "bench/README.md", "Notes.txt"]
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
IMAGE = re.compile(r"!\[[^]]*\]\([^)]*\)")
LINK = re.compile(r"\[([^]]*)\]\(([^)]*)\)")
SOURCE = re.compile(r"\.(h|cpp|py|cmake)$")


def words(text):
    text = IMAGE.sub("", FENCE.sub("", text))
    lines = [line for line in LINK.sub(r"\1", text).splitlines() if not line.startswith(("|", " " * 4))]
    return sum(bool(re.search(r"\w", word)) for word in " ".join(lines).split())


def code_of(text):
    """What stands in code blocks, between backticks and as the text of links."""
    rest = FENCE.sub("", text)
    links = [label for label, _ in LINK.findall(rest)]
    return " ".join(FENCE.findall(text) + re.findall(r"`([^`\n]+)`", rest) + links)


class Tree:
    """The files of the project, without what a build made."""

    def __init__(self, root):
        self.root = root
        made = ("build", ".git")
        self.tops = {path.name for path in root.iterdir() if path.is_dir() and path.name not in made}
        self.names = {path.name for top in self.tops for path in (root / top).rglob("*")}

    def has(self, path, folder):
        """Whether a path that a paper in `folder` names is there, if it is one of the project's own."""
        path = path.replace("ROOM", "*")
        if "/" not in path:
            return not SOURCE.search(path) or path in self.names
        if path.split("/")[0] in self.tops:
            bases = [self.root]
        elif SOURCE.search(path):
            bases = [folder, self.root / "include/raytracer", self.root / "src"]
        else:
            return True
        return any(next(base.glob(path.rstrip("/") + end), None) for base in bases for end in ("", ".cpp"))


def faults_of(tree, paper):
    text = (tree.root / paper).read_text()
    folder = (tree.root / paper).parent
    for _, target in LINK.findall(text):
        if not re.match(r"https?:|#", target) and not (folder / target.split("#")[0]).exists():
            yield f"{paper}: the link to {target}, which is not there"
    code = text if paper.endswith(".txt") else code_of(text)
    for path in re.findall(r"(?<![\w/.~$-])[\w.-][\w.*/-]*[\w*/]", code):
        if not tree.has(path, folder):
            yield f"{paper}: names {path}, which is not there"


def comment_faults(tree):
    """Comments that name a file which is not there."""
    tops = [tree.root / top for top in ("include", "src", "test", "bench")]
    for path in sorted(path for top in tops for path in top.rglob("*")):
        mark = {".h": "//", ".cpp": "//", ".py": "#", "CMakeLists.txt": "#"}.get(path.suffix or path.name)
        for number, line in enumerate(path.read_text().splitlines() if mark else [], 1):
            for name in re.findall(r"[\w./]+\.(?:h|cpp|py|md|js|css)\b", line.partition(mark)[2]):
                if name.split("/")[-1] not in tree.names or not tree.has(name, path.parent):
                    yield f"{path.relative_to(tree.root)}:{number}: names {name}, which is not there"


def length_faults(root):
    count = words((root / "README.md").read_text())
    if count > MOST_WORDS:
        yield f"README.md: {count} words of prose; at most {MOST_WORDS}"
    lines = (root / "Notes.txt").read_text().splitlines()
    if len(lines) > MOST_LINES:
        yield f"Notes.txt: {len(lines)} lines; at most {MOST_LINES}"


def width_faults(root, paper):
    most = MOST_COLUMNS[pathlib.Path(paper).suffix]
    for number, line in enumerate((root / paper).read_text().splitlines(), 1):
        if len(line) > most and not line.startswith("|"):
            yield f"{paper}:{number}: {len(line)} columns; at most {most}"


def is_script(path):
    if path.suffix:
        return path.suffix in (".py", ".sh", ".cmake") or path.name == "CMakeLists.txt"
    return path.is_file() and path.read_bytes()[:2] == b"#!"


def code_width_faults(tree):
    tops = [tree.root / top for top in sorted(tree.tops - {"third_party"})]
    files = [*tree.root.iterdir(), *(path for top in tops for path in top.rglob("*"))]
    for path in sorted(path for path in files if path.is_file() and is_script(path)):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if len(line) > MOST_CODE_COLUMNS:
                name = path.relative_to(tree.root)
                yield f"{name}:{number}: {len(line)} columns; at most {MOST_CODE_COLUMNS}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if "--words" in sys.argv:
        print(words((root / "README.md").read_text()), "words of prose in README.md")
    tree = Tree(root)
    faults = [fault for paper in PAPERS for fault in [*faults_of(tree, paper), *width_faults(root, paper)]]
    faults += [*length_faults(root), *comment_faults(tree), *code_width_faults(tree)]
    print("\n".join(faults) if faults else f"{len(PAPERS)} papers name what is there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
