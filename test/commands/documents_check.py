"""Tests the files that are installed with the program: the man page, three shells' completions and the
schema, each in the program that uses it.

Usage: documents_check.py RAYTRACER, from the source folder. A shell that is not installed is skipped.
"""
import fcntl
import os
import pathlib
import pty
import re
import select
import shutil
import struct
import subprocess
import sys
import tempfile
import termios
import time

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


class Zsh:
    """zsh on a terminal, with the completion of a folder. Ctrl+X shows the line that is being edited."""

    def __init__(self, folder):
        self.terminal, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 200, 0, 0))
        self.process = subprocess.Popen(["zsh", "-f", "-i"], stdin=slave, stdout=slave, stderr=slave,
                                        cwd=folder, start_new_session=True,
                                        env=os.environ | {"TERM": "dumb", "PS1": "", "LC_ALL": "C.UTF-8"})
        os.close(slave)
        self.answer(f"fpath=({folder} $fpath); autoload -U compinit; compinit -u -D; unsetopt beep; "
                    "show() { print -r -- \"<$BUFFER>\" }; zle -N show; bindkey ^X show; echo '<'set'>'\n",
                    "<set>")

    def answer(self, keys, end):
        """What is shown from now on until `end`, a regular expression; all of 20 seconds where it is not."""
        os.write(self.terminal, keys.encode())
        text, limit = "", time.monotonic() + 20
        while not re.search(end, text) and time.monotonic() < limit:
            if select.select([self.terminal], [], [], 0.1)[0]:
                text += os.read(self.terminal, 65536).decode(errors="replace")
        return text.replace("\r", "")

    def completed(self, line):
        """The line as it is after a tab, and what was listed."""
        text = self.answer(f"\x15{line}\t\x18", "<[^<>]*>")
        return (re.findall("<([^<>]*)>", text) or [""])[0].strip(), text

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.terminal)


def check_zsh(folder):
    script = pathlib.Path(folder, "_raytracer")
    script.write_text(output("--print-completion", "zsh"), encoding="utf-8")
    if not is_here("zsh"):
        return
    shown("zsh", "-n", str(script))
    zsh = Zsh(folder)
    for line, expected in (("--wat", "--watch"), ("a.json o.png 8 --pass no", "normals"), ("comp", "compare"),
                           ("compare --di", "--diff"), ("grade --refer", "--references"),
                           ("grade --stage diff", "diffuse"), ("explain --de", "--depth"),
                           ("tradeoff --rep", "--repeats"), ("assemble --qui", "--quiet")):
        found, _ = zsh.completed(f"raytracer {line}")
        check(f"zsh: {line}", f"raytracer {line.rpartition(' ')[0]} {expected}".replace("  ", " "), found)
    _, listed = zsh.completed("raytracer grade --p")
    check("zsh: what is listed", True, bool(re.search(
        r"--points +-- Gradescope's points for each picture \(above 0\) *\n"
        r"--program +-- Grade another program: runs PROGRAM scene\.json out\.png SIZE *\n", listed)))
    zsh.close()


def check_briefs():
    """What zsh and fish say of an option: its help, or the first phrase of that, which says something."""
    for shell, quoted in (("zsh", r"'(--[a-z-]+)\[(.*?)\](?::.*)?' \\"),
                          ("fish", r"-l ([a-z-]+) -d '((?:\\'|[^'])*)'")):
        script = output("--print-completion", shell)
        briefs = [(name, text.replace(r"'\''", "'").replace(r"\'", "'"))
                  for name, text in re.findall(quoted, script)]
        check(f"{shell}: options", True, len(briefs) > 50)
        check(f"{shell}: too long or too short", [],
              [brief for brief in briefs if not 10 <= len(brief[1]) < 80])
        for expected in ("Choose options for this error", "As root: run it as this user",
                         "Write Gradescope's results.json, of one submission", "Keep what is there",
                         "What a pixel shows: color (the light), raycast (color_diffuse) or normals"):
            check(f"{shell}: {expected}", True, expected in [text for _, text in briefs])


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
    check_briefs()
    with tempfile.TemporaryDirectory() as folder:
        for checked in (check_bash, check_zsh, check_fish, check_manual):
            checked(folder)
    return conclude("every document as it should be")


sys.exit(main())
