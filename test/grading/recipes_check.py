"""Tests the recipes as far as one machine can: Gradescope's script, the workflow's grading step, the class.

Usage: recipes_check.py RAYTRACER, from the source folder. Exit status 77 (CTest: skipped) without Pillow or
cmake.
"""
import csv
import getpass
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from grade_check import check, conclude, write_program

SCENES = ["spheres_cylinder", "cone_cube"]


def run(command, folder, **environment):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=120, cwd=folder,
                          env=os.environ | environment)


def make_exam(raytracer, folder):
    folder.mkdir()
    for name in SCENES:
        shutil.copy(f"scenes/{name}.json", folder)
        run([raytracer, folder / f"{name}.json", folder / f"{name}.png", 40, "--quiet"], folder)


def check_gradescope(raytracer, recipes, folder):
    submission = folder / "autograder/submission"
    submission.mkdir(parents=True)
    (folder / "autograder/results").mkdir()
    (folder / "autograder/source").mkdir()
    made = check_build(raytracer, (recipes / "gradescope/setup.sh").read_text("utf-8"), folder / "raytracer")
    check(not made or run([made / "raytracer", "--version"], folder).returncode == 0,
          "setup.sh makes a command of it")
    make_exam(raytracer, folder / "autograder/source/exam")
    student = "nobody" if os.geteuid() == 0 else ""
    (submission / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.20)\nproject(student NONE)\nexecute_process(COMMAND id -un "
        "OUTPUT_VARIABLE who)\n"
        f'if(NOT who STREQUAL "{student or getpass.getuser()}\\n")\n  message(FATAL_ERROR "made by '
        f'${{who}}")\nendif()\n'
        "file(COPY raytracing renderer DESTINATION ${CMAKE_BINARY_DIR})\n")
    shutil.copy(raytracer, submission / "renderer")  # which the student can read
    write_program(submission / "raytracing",
                  'exec "$(dirname "$0")/renderer" "$1" "$2" "$3" --quiet --only '
                  'diffuse,specular,shadows,reflections\n')
    done = run(["sh", recipes / "gradescope/run_autograder"], folder, AUTOGRADER=str(folder / "autograder"),
               STUDENT=student, PATH=f"{raytracer.parent}:{os.environ['PATH']}", POINTS="25", TMPDIR="")
    check((folder / "autograder").stat().st_mode & 0o777 == 0o700, "the references are closed to the student")
    check(done.returncode == 0, f"run_autograder: {done.returncode} {done.stdout} {done.stderr}")
    results = json.loads((folder / "autograder/results/results.json").read_text("utf-8"))
    tests = {test["name"]: test for test in results["tests"]}
    check(sorted(tests) == sorted(SCENES) and all(test["max_score"] == 25 for test in tests.values()),
          f"{results}")
    check(all("without ambient light" in test["output"] for test in tests.values()), f"{results}")


def check_build(raytracer, script, folder):
    """The lines that build raytracer, from a repository with `run` whose build has a copy of ours to make."""
    if not shutil.which("git") or not shutil.which("ninja"):
        return print("the build of raytracer: skipped, no git or no ninja")
    source, bin_ = folder / "source", folder / "bin"
    (source / "build/release").mkdir(parents=True)
    bin_.mkdir()
    shutil.copy("run", source)
    (source / "build/release/build.ninja").write_text(
        f"rule copy\n  command = cp $in $out\nbuild raytracer: copy {raytracer}\n")
    for command in (["init", "-q"], ["add", "."],
                    ["-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "all"]):
        run(["git", *command], source)
    for name in ("apt-get", "sudo", "useradd"):
        write_program(bin_ / name, "true\n")
    for there, here in {"${{ vars.RAYTRACER_SOURCE }}": "$RAYTRACER_SOURCE", "/opt/": f"{folder}/opt/",
                        "/usr/local/bin": bin_}.items():
        script = script.replace(there, str(here))
    done = run(["sh", "-e", "-c", script], folder, PATH=f"{bin_}:{os.environ['PATH']}",
               RAYTRACER_SOURCE=f"file://{source}")
    made = folder / "opt/raytracer/build/release/raytracer"
    check(done.returncode == 0 and made.exists(), f"build: {done.returncode} {done.stdout} {done.stderr}")
    return made.exists() and bin_


def steps_of(workflow):
    """The scripts of the workflow, by name: of `run: |` or `run: COMMAND`."""
    steps, lines = {}, workflow.read_text("utf-8").split("\n")
    for i, line in enumerate(lines):
        found = re.fullmatch(r"( +)run: (.*)", line)
        if not found:
            continue
        name = next(re.search(r"name: (.*)", one)[1] for one in reversed(lines[:i]) if "- name:" in one)
        script = [found[2]] if found[2] != "|" else []
        for one in lines[i + 1:] if not script else []:
            if one.strip() and not one.startswith(found[1] + "  "):
                break
            script.append(one[len(found[1]) + 2:])
        steps[name] = "\n".join(script)
    return steps


def check_github(raytracer, recipes, folder):
    (folder / "build").mkdir(parents=True)
    check_build(raytracer, steps_of(recipes / "github/grade.yml")["build raytracer"], folder / "raytracer")
    make_exam(raytracer, folder / "exam")
    write_program(folder / "build/raytracing", f'exec {raytracer} "$1" "$2" "$3" --quiet --max-recursion 0\n')
    steps = steps_of(recipes / "github/grade.yml")
    check(list(steps) == ["build raytracer", "build the student's program", "grade", "summary"],
          f"steps: {list(steps)}")
    script = steps["grade"].replace("/opt/raytracer/build/release/raytracer", str(raytracer))
    done = run(["bash", "-eo", "pipefail", "-c", script], folder)
    check(done.returncode == 1 and "without any reflected or refracted ray" in done.stdout,
          f"{done.returncode} {done.stdout}")
    check((folder / "report.html").exists() and
          (folder / "junit.xml").read_text("utf-8").count("<failure") == 2, "the files")
    summary = folder / "summary.md"
    check(run(["bash", "-e", "-c", steps["summary"]], folder, GITHUB_STEP_SUMMARY=str(summary)).returncode ==
          0, "the summary")
    check(summary.read_text("utf-8").startswith("```\nscore"), f"the summary: {summary.read_text('utf-8')}")


def check_class(raytracer, recipes, folder):
    folder.mkdir()
    make_exam(raytracer, folder / "exam")
    for name, options in {"ada": "", "bob": "--only ambient,diffuse,shadows,reflections"}.items():
        (folder / "class" / name).mkdir(parents=True)
        write_program(folder / "class" / name / "raytracing",
                      f'exec {raytracer} "$1" "$2" "$3" --quiet {options}\n')
        for scene in SCENES:
            run([raytracer, folder / "exam" / f"{scene}.json", folder / "class" / name / f"{scene}.png", 40,
                 "--quiet", *options.split()], folder)
    for program in ([], ["raytracing"]):
        done = run(["sh", recipes / "class/grade_class.sh", "exam", "class", *program], folder,
                   PATH=f"{raytracer.parent}:{os.environ['PATH']}")
        check(done.returncode == 0, f"grade_class.sh: {done.returncode} {done.stderr}")
        with open(folder / "class.csv", newline="", encoding="utf-8") as file:
            mistakes = {row["submission"]: row["mistake"] for row in csv.DictReader(file)}
        check(mistakes == {"ada": "", "bob": "without specular light"}, f"{program}: {mistakes}")
        check((folder / "class.html").exists(), "the page")
        (folder / "class.html").unlink()


def main():
    if not shutil.which("cmake") or not shutil.which("bash"):
        print("skipped: no cmake or no bash")
        return 77
    raytracer, recipes = Path(sys.argv[1]).resolve(), Path("recipes").resolve()
    with tempfile.TemporaryDirectory() as name:
        check_gradescope(raytracer, recipes, Path(name) / "gradescope")
        check_github(raytracer, recipes, Path(name) / "github")
        check_class(raytracer, recipes, Path(name) / "class")
    return conclude()


sys.exit(main())
