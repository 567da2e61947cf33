"""Tests `raytracer grade` on a generated class of forty: pictures with each kind of mistake, and programs
that fail in each way.

Usage: class_check.py RAYTRACER COMPILER [FLAG ...] LIBRARY ..., from the source folder. The compiler, its
flags and the libraries build the students' program (students.py). Exit status 77 (CTest: skipped) without
Pillow.
"""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

from grade_check import check, conclude, failures, write_program
from report_check import Browser
from students import KNOWN, build

SCENES = ["refraction", "spheres_cylinder"]
SIZE = 48
# What is wrong with whom, in part. The pictures are those of students.py.
PICTURES = {
    "right_1": [], "right_2": [],
    **{name: [name]
       for name in ("no_ambient", "no_diffuse", "no_specular", "no_shadows", "no_reflections", "order_srt",
                    "order_tsr", "radians", "rotate_back", "flip_up_down", "flip_left_right", "film_mirrored",
                    "clockwise", "top_left", "swapped", "gamma", "srgb", "cut", "no_first_light")},
    "pair_1": ["no_specular", "flip_up_down"], "pair_2": ["no_shadows", "gamma"],
    "pair_3": ["swapped", "no_ambient"],
}
# Of these the pictures are graded without a program, too.
PICTURES_ALONE = ["right_1", "no_specular", "swapped", "pair_1"]
# Programs, and the message of each. $1 is the scene, $2 the picture, {student} a right program.
PROGRAMS = {
    "good": ('{student} "$1" "$2" "$3"', ""),
    "status": ('{student} "$1" "$2" "$3"; exit 3', ""),
    "crash": ('{student} "$1" "$2" "$3"; kill -SEGV $$', "crashed: Segmentation fault"),
    "hang": ("sleep 60", "hung: stopped after 10 s"),
    "busy": ("while :; do :; done", "too slow: 0.5 s of processor time"),
    "flood": ("exec yes", "printed or wrote too much|too slow: 0.5 s of processor time"),
    "forks": ("for i in $(seq 300); do sleep 60 & done; wait",
              "started too many processes|too slow: 0.5 s of processor time"),
    "daemon": ('{student} "$1" "$2" "$3"; setsid sh -c \'echo $$ > {pid}; exec sleep 60\' & sleep 0.2', ""),
    "elsewhere": ('{student} "$1" ./elsewhere.png "$3"',
                  "wrote no picture, but elsewhere.png is there"),
    "copies": ('cp "$(dirname "$1")/$(basename "$1" .json).png" "$2" || cp references/*.png "$2"',
               "exit status 1, wrote no picture"),
    "fifo": ('mkfifo "$2"', "wrote no picture"),
    "link": ('ln -s {reference} "$2"', "out.png is a symbolic link, not a file"),
    "input": ('read line; {student} "$1" "$2" "$3"', ""),
    "nothing": ("true", "wrote no picture"),
    "size": ('{student} "$1" "$2" 20', "expected 48 x 48 pixels, as the reference has, found 20 x 20"),
    "none": ("", "could not be started, wrote no picture"),
}

# The page of the class, exercised from inside: each line of the result is a check and whether it held.
PAGE_TEST = r"""
(async () => {
  const results = {}, errors = [];
  window.addEventListener("error", event => errors.push(event.message));
  const wait = ms => new Promise(done => setTimeout(done, ms));
  const until = async condition => { for (let i = 0; i < 500 && !condition(); ++i) await wait(20); };
  const rows = [...overview.querySelectorAll("tbody tr")];
  const means = rows.map(row => +row.children[1].textContent);
  const find = text => { $("find").value = text; $("find").dispatchEvent(new Event("input")); };
  const rowOf = name => rows.find(row => row.dataset.name === name);
  results.rows = rows.length === 40 && !overview.hidden && main.children.length === 0;
  results.worstFirst = means.every((mean, i) => i === 0 || means[i - 1] <= mean);
  find("SPECULAR");
  const found = rows.filter(row => !row.hidden);
  results.find = found.length === 2 && found.every(row => row.textContent.includes("specular"));
  find("");
  results.findAll = rows.every(row => !row.hidden);
  const heads = [...overview.querySelectorAll("thead button")];
  const names = () => [...overview.querySelectorAll("tbody tr")].map(row => row.dataset.name);
  heads[0].click();
  results.byName = names().join() === [...names()].sort((a, b) => a.localeCompare(b)).join();
  heads[1].click(); heads[1].click();
  results.bestFirst = +overview.querySelector("tbody tr").children[1].textContent === Math.max(...means) &&
    heads[1].parentElement.ariaSort === "descending" && heads[0].parentElement.ariaSort === "none";
  rowOf("no_specular").querySelector("a").click();
  await until(() => overview.hidden);
  results.link = location.hash === "#no_specular";
  results.how = $("how").textContent === `mean ${rowOf("no_specular").cells[1].textContent}, 0 of 2 right`;
  results.opens = overview.hidden && !$("opened").hidden && visible().length === 2 &&
      $("who").textContent === "no_specular";
  results.named = visible().every(card =>
      card.querySelector(".mistake").textContent.includes("without specular light"));
  results.command = /^raytracer explain exam\/\w+\.json \d+ \d+ 48$/.test(
      main.querySelector("code").textContent);
  const images = [...main.querySelectorAll("img")];
  for (const image of images) image.scrollIntoView();
  await until(() => images.every(image => image.complete && image.naturalWidth));
  results.images = images.length === 6 && images.every(image => image.naturalWidth === 48);
  main.querySelector("button[data-kind=reference]").click();
  await until(() => viewer.open && stage.querySelector("img.shown"));
  results.viewer = viewer.open && $("kind").textContent === "reference";
  keys[" "]();
  draw();
  results.swaps = $("kind").textContent === "graded" && $("values").textContent.includes("graded");
  leave();
  $("back").click();
  await until(() => !overview.hidden);
  results.back = !overview.hidden && main.children.length === 0 &&
      document.activeElement === rowOf("no_specular").querySelector("a");
  history.back();
  await until(() => overview.hidden);
  results.browsersBack = overview.hidden && $("who").textContent === "no_specular";
  rowOf("crash").click();
  await until(() => $("who").textContent === "crash");
  results.crash = visible().length === 2 && main.textContent.includes("crashed: Segmentation fault") &&
    main.querySelectorAll("button[data-kind=graded]").length === 0;
  results["errors: " + errors.join("; ")] = errors.length === 0;
  return results;
})();
"""


def run(*arguments, **options):
    return subprocess.run(list(map(str, arguments)), capture_output=True, text=True, timeout=300, **options)


def make_scenes(raytracer, folder):
    """exam/ with the scenes and what they name, references/ with our pictures of them."""
    for name in ("exam", "references", "pictures", "class"):
        (folder / name).mkdir()
    shutil.copytree("scenes/textures", folder / "exam/textures")
    for name in SCENES:
        shutil.copy(f"scenes/{name}.json", folder / "exam")
        run(raytracer, f"scenes/{name}.json", folder / "references" / f"{name}.png", SIZE, "--quiet")


def make_pictures(student, folder):
    for name, mistakes in PICTURES.items():
        for i, scene in enumerate(SCENES):
            place = folder / "pictures" / name / ("." if i % 2 else "out/pictures")
            place.mkdir(parents=True, exist_ok=True)
            run(student, folder / "exam" / f"{scene}.json", place / f"{scene}.png", SIZE, *mistakes)
        shutil.copytree(folder / "pictures" / name, folder / "class" / name)
        if name not in PICTURES_ALONE:
            shutil.rmtree(folder / "pictures" / name)
        write_program(folder / "class" / name / "raytracer",
                      'cp "$(find "$(dirname "$0")" -name "$(basename "$1" .json).png")" "$2"\n')


def make_programs(student, folder):
    for name, (body, _) in PROGRAMS.items():
        (folder / "class" / name).mkdir()
        words = {"student": student, "pid": folder / "pid", "reference": folder / "references/refraction.png"}
        for word, value in words.items():
            body = body.replace("{" + word + "}", str(value))
        if name != "none":
            write_program(folder / "class" / name / "raytracer", body + "\n")


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return {row["submission"]: row for row in csv.DictReader(file)}


def expected_words(mistakes):
    return [KNOWN[mistake] for mistake in mistakes]


def check_pictures(raytracer, folder):
    done = run(raytracer, "grade", "exam", "--references", "references", "--submissions", "pictures",
               "--max-pixels", 20,
               "--report", "class.html", "--csv", "class.csv", "--json", "class.json", "--junit", "class.xml",
               cwd=folder)
    check((done.returncode, done.stderr) == (0, ""), f"pictures: {done.returncode} {done.stderr}")
    rows = rows_of(folder / "class.csv")
    check(sorted(rows) == sorted(PICTURES_ALONE), f"a row for each submission: {sorted(rows)}")
    check(list(rows["right_1"]) == ["submission", *sorted(SCENES), "mean", "mistake"],
          f"columns: {list(rows['right_1'])}")
    for name in PICTURES_ALONE:
        mistakes, said = PICTURES[name], rows[name]["mistake"]
        check(all(words in said for words in expected_words(mistakes)) and bool(said) == bool(mistakes),
              f"{name}: {said!r}")
        mean = sum(int(rows[name][scene]) for scene in SCENES) / len(SCENES)
        check(abs(mean - float(rows[name]["mean"])) < 0.06, f"{name}: mean {rows[name]['mean']}")
        check(re.search(rf"^ *{rows[name]['mean']} +\d+/2 +{name}\b", done.stdout, re.M),
              f"{name}: {done.stdout}")
    answer = json.loads((folder / "class.json").read_text("utf-8"))
    check({one["submission"]: one["mistake"] for one in answer["submissions"]} ==
          {name: row["mistake"] for name, row in rows.items()}, "JSON and CSV say the same")
    check_junit(folder / "class.xml", rows)
    check_odd(raytracer, folder)


def check_odd(raytracer, folder):
    """Nothing handed in, some missing, one that is there twice, names in capitals, pictures of another type,
    a name of more bytes than characters, an archive."""
    right = folder / "pictures/right_1"
    for name in ("capitals", "jpegs", "none", "some", "twice", "Zoé"):
        (folder / "odd" / name).mkdir(parents=True)
    for name in ("twice/a", "twice/b", "Zoé/a"):
        shutil.copytree(right, folder / "odd" / name)
    shutil.copy(next(right.rglob("refraction.png")), folder / "odd/some")
    for name in SCENES:
        shutil.copy(next(right.rglob(name + ".png")), folder / "odd/capitals" / (name.title() + ".PNG"))
        (folder / "odd/jpegs" / (name + ".jpg")).write_text("a picture")
    (folder / "odd/some/spheres_cylinder.png").write_text("no picture")
    (folder / "odd/none/refraction2.cpp").write_text("code")
    (folder / "odd/zip.zip").write_text("an archive")
    (folder / "odd/some.zip").write_text("an archive that is unpacked")
    grade = [raytracer, "grade", "exam", "--references", "references", "--submissions", "odd"]
    done = run(*grade, "--max-pixels", 20, "--csv", "odd.csv", "--json", "odd.json", "--report", "odd.html",
               cwd=folder)
    said = {name: row["mistake"] for name, row in rows_of(folder / "odd.csv").items()}
    twice = ("refraction.png is there twice: a/out/pictures/refraction.png counts, not "
             "b/out/pictures/refraction.png (so with 2 pictures)")
    four = said["none"], said["twice"], said["Zoé"], said["zip.zip"]
    missing = "refraction and spheres_cylinder are missing"
    check(four == (missing, twice, "", "an archive: unpack it into a folder"), f"odd ones: {said}")
    check(said["capitals"].startswith("Refraction.PNG counts as refraction.png"), said["capitals"])
    check(said["jpegs"].endswith(" are missing, but refraction.jpg is there"), said["jpegs"])
    answer = json.loads((folder / "odd.json").read_text("utf-8"))["submissions"]
    check({one["submission"]: one["mistake"] for one in answer} == said, "odd ones, as JSON")
    lines, absent = done.stdout.splitlines(), 4 * len(SCENES) - 2
    names = [line[15:27].rstrip() for line in lines[1:]]
    check(names == sorted(said) and twice in lines[6], f"the table: {lines}")
    check(lines[4][27:].startswith(missing), f"the table's columns: {lines}")
    check(all(line == line.rstrip() for line in lines), f"the table's ends: {lines}")
    page = (folder / "odd.html").read_text("utf-8")
    counts = page.count("not comparable"), page.count(">no picture<")
    check(counts == (1, absent), f"the page says what is not there: {counts}")
    check("<dt>time</dt>" not in page and ">ours<" not in page, "the page of pictures")
    refused = run(*grade, "--program", "{}/no/such --fast", cwd=folder)
    said = "raytracer grade: --program: no submission has a file {}/no/such\n"
    check((refused.returncode, refused.stderr) == (2, said), refused.stderr)


def check_junit(path, rows):
    """The structure that CI systems read: https://github.com/testmoapp/junitxml."""
    root = xml.parse(path).getroot()
    check(root.tag == "testsuites" and [suite.get("name") for suite in root] == sorted(rows),
          "JUnit: a suite for each")
    for suite in (root, *root):
        cases = suite.findall(".//testcase")
        counts = {"tests": len(cases), "failures": len(suite.findall(".//failure")),
                  "errors": len(suite.findall(".//error"))}
        check({key: int(suite.get(key)) for key in counts} == counts and float(suite.get("time")) >= 0,
              f"JUnit: {suite.attrib}")
    for case in root.iter("testcase"):
        check(set(case.attrib) == {"classname", "name", "time"} and all(one.get("message") for one in case),
              f"JUnit: {case.attrib}")
    wrong = {case.get("classname") for case in root.iter("testcase") if len(case)}
    check(wrong == {name for name, row in rows.items() if row["mistake"]}, "JUnit: who fails")


def check_class(raytracer, folder):
    temporary = folder / "tmp"
    temporary.mkdir()
    done = run(raytracer, "grade", "exam", "--references", "references", "--submissions", "class",
               "--program",
               "{}/raytracer", "--jobs", 8, "--timeout", 0.5, "--wall", 10, "--max-pixels", 20, "--report",
               "forty.html", "--csv", "forty.csv", cwd=folder, env=os.environ | {"TMPDIR": str(temporary)})
    check((done.returncode, done.stderr) == (0, ""), f"programs: {done.returncode} {done.stderr}")
    rows = rows_of(folder / "forty.csv")
    check(sorted(rows) == sorted([*PROGRAMS, *PICTURES]) and len(rows) == 40,
          f"a row for each of forty: {sorted(rows)}")
    for name, mistakes in PICTURES.items():
        said = rows[name]["mistake"]
        check(all(words in said for words in expected_words(mistakes)) and bool(said) == bool(mistakes),
              f"{name}: {said!r}")
    for name, (_, message) in PROGRAMS.items():
        said = re.sub(r"\b\d+\.\d+ s of", "0.5 s of", rows[name]["mistake"])
        said = said.split(" (")[0] if "|" in message else said  # whichever limit is first
        check(said in message.split("|"), f"{name}: {said!r}, not {message!r}")
        check(float(rows[name]["mean"]) > 99 if not message else float(rows[name]["mean"]) == 0,
              f"{name}: {rows[name]['mean']}")
    daemon = Path(f"/proc/{(folder / 'pid').read_text().strip()}")
    check(not daemon.exists(), "nothing survives")
    check(not list(temporary.iterdir()), f"nothing is left: {list(temporary.iterdir())}")
    check(not list(folder.rglob("elsewhere.png")), "what is written elsewhere is gone")


def check_user(raytracer, folder):
    """As root, a program has another user's rights, and its folder is that user's with all that is in it."""
    if os.geteuid() != 0:
        refused = run(raytracer, "grade", "exam", "--references", "references", "--program", "true", "--user",
                      "nobody", cwd=folder)
        check((refused.returncode, refused.stderr) == (2, "only root may run programs as another user\n"),
              refused.stderr)
        return
    program = ("sh -c 'id -un; find . -type f -exec cat {} + > /dev/null && find . -type d -exec touch "
               "{}/own \\; &&"
               " find . -type f | wc -l' -")
    shutil.copy("scenes/checker_horizon.json", folder / "exam")
    run(raytracer, "scenes/checker_horizon.json", folder / "references/checker_horizon.png", SIZE, "--quiet")
    for path in (folder / "exam").rglob("*"):
        path.chmod(0o700 if path.is_dir() else 0o600)
    done = run(raytracer, "grade", "exam", "--references", "references", "--program", program, "--user",
               "nobody",
               "--junit", "user.xml", cwd=folder)
    printed = {case.get("name"): case.find("error").text
               for case in xml.parse(folder / "user.xml").getroot().iter("testcase")}
    expected = {"checker_horizon": "nobody\n5\n", "refraction": "nobody\n5\n",
                "spheres_cylinder": "nobody\n2\n"}
    check(done.returncode == 1 and printed == expected, f"--user: {printed} {done.stderr}")
    refused = run(raytracer, "grade", "exam", "--program", "true", "--user", "no such", cwd=folder)
    said = "raytracer grade: --user: there is no user no such\n"
    check((refused.returncode, refused.stderr) == (2, said), refused.stderr)


def check_hostile(raytracer, folder):
    """What a program does to the folders of the grading is never the score of another one."""
    place = folder / "hostile"
    place.mkdir()
    folder.chmod(0o755)
    (place / "tmp").mkdir()
    (place / "exam").mkdir()
    shutil.copy("test/good/least.json", place / "exam/a.json")
    shutil.copy(folder / "references/refraction.png", place / "exam/a.png")
    hand_in = f'cp {place}/exam/a.png "$2"\n'

    def graded(programs, *options, before=()):
        shutil.rmtree(place / "class", ignore_errors=True)
        for name, body in programs.items():
            (place / "class" / name).mkdir(parents=True)
            write_program(place / "class" / name / "rt", body + "\n")
        done = run(*before, raytracer, "grade", "exam", "--submissions", "class", "--program", "{}/rt",
                   "--csv", "c.csv", *options, cwd=place, env=os.environ | {"TMPDIR": str(place / "tmp")})
        rows = rows_of(place / "c.csv") if (place / "c.csv").exists() else {}
        (place / "c.csv").unlink(missing_ok=True)
        left = [shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()
                for path in (place / "tmp").glob("*")]
        return (done.returncode, done.stderr, len(left),
                {name: (row["a"], row["mistake"]) for name, row in rows.items()})

    none = "its folder was deleted, wrote no picture"
    for what, body in {".. is emptied": "rm -rf ../*",
                       "a link instead of the folder": f'rm -rf "$PWD"; ln -s {place}/exam "$PWD"'}.items():
        found = graded({"ada": body, "bob": hand_in})
        said = "wrote no picture" if "ln" in body else none
        check(found == (0, "", 0, {"ada": ("0", said), "bob": ("100", "")}), f"{what}: {found}")
    found = graded({"bob": hand_in, "zoe": "rm -rf ../../raytracer-* ../raytracer-*"})
    line = (rf"{place}/tmp/raytracer-\w+: a program has changed what is kept there: "
            rf"{place}/class/zoe/rt, or one beside it; as root, --user NAME prevents that\n")
    check(found[0] == 2 and re.fullmatch(line, found[1]) and found[2:] == (0, {}), f"what is kept: {found}")
    if os.geteuid() != 0:
        return
    empties = "sleep 0.2; for d in ../raytracer-* ../../raytracer-*; do rm -rf $d/*; done; true"
    found = graded({"ada": empties, "bob": hand_in + "sleep 0.4"}, "--user", "nobody", "--jobs", 2)
    check(found == (0, "", 0, {"ada": ("0", "wrote no picture"), "bob": ("100", "")}),
          f"the folder of another run: {found}")
    alone = ["unshare", "-m"]
    if run(*alone, "true").returncode:
        return print("what is mounted: skipped, it can't be mounted")
    (place / "dear").mkdir()
    (place / "dear/file").write_text("dear")
    mounts = f"for m in m ../m; do mkdir $m; mount --bind {place}/dear $m; done\n"
    found = graded({"ada": mounts + hand_in}, before=alone)
    line = (rf"{place}/tmp/raytracer-\w+: cannot be deleted: something in it is mounted or immutable; "
            r"delete it by hand\n")
    check(found[0] == 0 and re.fullmatch(line, found[1]) and found[2:] == (1, {"ada": ("100", "")}),
          f"what is mounted: {found}")
    check((place / "dear/file").exists(), "what is mounted stays")


def check_page(folder):
    if not shutil.which("chromium"):
        return print("the page in a browser: skipped, no chromium")
    browser = Browser(folder / "profile")
    try:
        browser.open(folder / "forty.html")
        for name, held in browser.evaluate(PAGE_TEST).items():
            check(held, f"the page: {name}")
    finally:
        browser.close()


def check_one(raytracer, folder):
    """--gradescope: https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format."""
    (folder / "one").mkdir()
    shutil.copytree(folder / "pictures/no_specular", folder / "one/ada")
    (folder / "one/ada/spheres_cylinder.png").unlink()
    grade = [raytracer, "grade", "exam", "--references", "references", "--gradescope", "results.json",
             "--points", 20]
    done = run(*grade, "--submissions", "one", "--min-score", 50, cwd=folder)
    check(done.returncode == 1, f"below --min-score: {done.returncode} {done.stderr}")
    results = json.loads((folder / "results.json").read_text("utf-8"))
    top = {"score": float, "execution_time": (int, float), "output": str, "output_format": str,
           "visibility": str, "tests": list}
    check(set(results) == set(top) and all(isinstance(results[key], kind) for key, kind in top.items()),
          f"Gradescope: {results}")
    check(abs(results["score"] - sum(test["score"] for test in results["tests"])) < 1e-9,
          "Gradescope: the sum")
    for test in results["tests"]:
        check(0 <= test["score"] <= test["max_score"] == 20 and test["status"] in ("passed", "failed"),
              f"Gradescope: {test}")
        check(set(test) == {"name", "score", "max_score", "status", "output", "output_format", "extra_data"},
              f"Gradescope: {test}")
    outputs = {test["name"]: test["output"] for test in results["tests"]}
    check(outputs["spheres_cylinder"] == "no picture spheres_cylinder.png" and
          "without specular light" in outputs["refraction"], f"{outputs}")
    refused = run(*grade, "--submissions", "pictures", cwd=folder)
    check((refused.returncode, refused.stderr) ==
          (2, f"raytracer grade: --gradescope: expected one submission, found {len(PICTURES_ALONE)}\n"),
          f"{refused.stderr}")
    refused = run(*grade[:-4], "--submissions", "pictures", "--program", "true", cwd=folder)
    check((refused.returncode, refused.stderr) ==
          (2, 'raytracer grade: --program: expected {} for the submission\'s folder, found "true"\n'),
          f"{refused.stderr}")
    refused = run(*grade[:-4], "--submissions", "one/ada/none", cwd=folder)
    check((refused.returncode, refused.stderr) ==
          (2, "one/ada/none: cannot read the folder: No such file or directory\n"),
          f"{refused.stderr}")


def main():
    raytracer, compiler, *libraries = sys.argv[1:]
    raytracer = str(Path(raytracer).resolve())
    student = Path(raytracer).with_name("student")
    build(compiler, Path.cwd(), libraries, student)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        folder = Path(name)
        make_scenes(raytracer, folder)
        make_pictures(student, folder)
        make_programs(student, folder)
        check_pictures(raytracer, folder)
        check_class(raytracer, folder)
        check_page(folder)
        check_one(raytracer, folder)
        check_user(raytracer, folder)
        check_hostile(raytracer, folder)
    return conclude()


if __name__ == "__main__":
    sys.exit(main())
