"""The recipes, run as far as one machine can: Gradescope's script, the workflow's step that grades, the class.

Usage: recipes_check.py RAYTRACER, from the source folder. Exit status 77 (CTest: skipped) without Pillow or cmake.
"""
import csv
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
    check(run(["sh", "-n", recipes / "gradescope/setup.sh"], folder).returncode == 0, "setup.sh is a script")
    (folder / "autograder/results").mkdir()
    (folder / "autograder/source").mkdir()
    make_exam(raytracer, folder / "autograder/source/exam")
    (submission / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.20)\nproject(student NONE)\n"
                                               "file(COPY raytracing DESTINATION ${CMAKE_BINARY_DIR})\n")
    write_program(submission / "raytracing", f'exec {raytracer} "$1" "$2" "$3" --quiet --only diffuse,specular,shadows,reflections\n')
    done = run(["sh", recipes / "gradescope/run_autograder"], folder, AUTOGRADER=str(folder / "autograder"), AS_USER="",
               PATH=f"{raytracer.parent}:{os.environ['PATH']}", POINTS="25")
    check(done.returncode == 0, f"run_autograder: {done.returncode} {done.stdout} {done.stderr}")
    results = json.loads((folder / "autograder/results/results.json").read_text("utf-8"))
    tests = {test["name"]: test for test in results["tests"]}
    check(sorted(tests) == sorted(SCENES) and all(test["max_score"] == 25 for test in tests.values()), f"{results}")
    check(all("without ambient light" in test["output"] for test in tests.values()), f"{results}")


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
    make_exam(raytracer, folder / "exam")
    write_program(folder / "build/raytracing", f'exec {raytracer} "$1" "$2" "$3" --quiet --max-recursion 0\n')
    steps = steps_of(recipes / "github/grade.yml")
    check(list(steps) == ["build raytracer", "build the student's program", "grade", "summary"], f"steps: {list(steps)}")
    script = steps["grade"].replace("/opt/raytracer/build/release/raytracer", str(raytracer))
    done = run(["bash", "-eo", "pipefail", "-c", script], folder)
    check(done.returncode == 1 and "without any reflected or refracted ray" in done.stdout, f"{done.returncode} {done.stdout}")
    check((folder / "report.html").exists() and (folder / "junit.xml").read_text("utf-8").count("<failure") == 2, "the files")
    summary = folder / "summary.md"
    check(run(["bash", "-e", "-c", steps["summary"]], folder, GITHUB_STEP_SUMMARY=str(summary)).returncode == 0, "the summary")
    check(summary.read_text("utf-8").startswith("```\nscore"), f"the summary: {summary.read_text('utf-8')}")


def check_class(raytracer, recipes, folder):
    folder.mkdir()
    make_exam(raytracer, folder / "exam")
    for name, options in {"ada": "", "bob": "--only ambient,diffuse,shadows,reflections"}.items():
        (folder / "class" / name).mkdir(parents=True)
        write_program(folder / "class" / name / "raytracing", f'exec {raytracer} "$1" "$2" "$3" --quiet {options}\n')
        for scene in SCENES:
            run([raytracer, folder / "exam" / f"{scene}.json", folder / "class" / name / f"{scene}.png", 40, "--quiet",
                 *options.split()], folder)
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
