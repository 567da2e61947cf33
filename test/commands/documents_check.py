"""What is installed beside the program: the man page, three shells' completions and the schema, each tried in
its program.

Usage: documents_check.py RAYTRACER, from the source folder. What a shell that is not there would say is
skipped.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from checks import RAYTRACER, check, conclude


def output(*words):
    done = subprocess.run([RAYTRACER, *words], capture_output=True, text=True, check=False)
    check(f"{words}", (0, ""), (done.returncode, done.stderr))
    return done.stdout


def is_here(program):
    if not shutil.which(program):
        print(f"{program}: skipped, it is not installed")
    return shutil.which(program)


def shown(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    check(f"{command[:2]}", "", done.stderr)
    return done.stdout


def check_bash(folder):
    script = pathlib.Path(folder, "raytracer.bash")
    script.write_text(output("--print-completion", "bash"), encoding="utf-8")
    for words, expected in ((["--pa"], "--pass --part"),
                            (["a.json", "o.png", "8", "--pass", "no"], "normals"), (["com"], "compare"),
                            (["compare", "--di"], "--diff"), (["grade", "--stage", "amb"],
                            "ambient ambient_diffuse_specular ambient_diffuse_specular_shadows"),
                            (["--samples", "4"], "")):
        quoted = " ".join(f"'{word}'" for word in ["raytracer", *words])
        found = shown("bash", "-c", f"source {script}; COMP_WORDS=({quoted}); COMP_CWORD={len(words)}; "
                                    f"_raytracer; echo ${{COMPREPLY[*]}}")
        check(f"bash: {words}", expected, found.strip())


def check_zsh(folder):
    script = pathlib.Path(folder, "_raytracer")
    script.write_text(output("--print-completion", "zsh"), encoding="utf-8")
    if is_here("zsh"):
        shown("zsh", "-n", str(script))


def check_fish(folder):
    script = pathlib.Path(folder, "raytracer.fish")
    script.write_text(output("--print-completion", "fish"), encoding="utf-8")
    if not is_here("fish"):
        return
    for line, expected in (("raytracer a.json o.png 8 --pass no", "normals"),
                           ("raytracer compare --di", "--diff")):
        found = shown("fish", "--no-config", "-c", f"source {script}; complete -C '{line}'")
        check(f"fish: {line}", expected, found.split("\t")[0].strip())


def check_manual(folder):
    manual = output("--print-manual")
    check("man: all commands", True,
          all(f'.SH "raytracer {name}"' in manual for name in ("compare", "explain", "grade", "tradeoff")))
    options = set(re.findall(r"^  (--[a-z-]+)", output("--help"), re.M)) - {"--help", "--version"}
    check("man: options", [],
          [option for option in sorted(options) if "\\fB" + option.replace("-", "\\-") not in manual])
    if is_here("groff"):
        page = pathlib.Path(folder, "raytracer.1")
        page.write_text(manual, encoding="utf-8")
        page_shown = shown("groff", "-man", "-Tutf8", "-ww", "-Kutf8", "-rLL=80n", "-P-c", "-P-b", "-P-u",
                           str(page))
        check("man: lines over 80 columns", [], [line for line in page_shown.splitlines() if len(line) > 80])


def main():
    check("schema", pathlib.Path("scenes/scene.schema.json").read_text(encoding="utf-8"),
          output("--print-schema"))
    done = subprocess.run([RAYTRACER, "--print-completion", "tcsh"], capture_output=True, text=True,
                          check=False)
    check("tcsh", (2, 'raytracer: --print-completion: expected bash, zsh or fish, found "tcsh"\n'),
          (done.returncode, done.stderr))
    with tempfile.TemporaryDirectory() as folder:
        for checked in (check_bash, check_zsh, check_fish, check_manual):
            checked(folder)
    return conclude("every document as it should be")


sys.exit(main())
