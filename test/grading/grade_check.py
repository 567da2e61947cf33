"""Tests `raytracer grade` of other programs: good ones, and one for each way to fail.

Usage: grade_check.py RAYTRACER. Exit status 77 (CTest: skipped) without Pillow.
"""
import copy
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    from PIL import Image, ImageDraw
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

GOOD = Path(__file__).parent.parent / "good"
SCENE = json.loads((GOOD / "least.json").read_text())
SCENE["camera"] |= {"film_left": -1.5, "film_right": 1.5}  # as draw_scene's pictures
LEAST = json.dumps(SCENE)  # in one line
failures = []


def check(condition, what):
    if not condition:
        failures.append(what)


def conclude():
    print("\n".join(failures) or "as it should be")
    return 1 if failures else 0


def draw_scene(radius, dot=None, size=60):
    picture = Image.new("RGB", (size, size * 2 // 3), (10, 20, 30))
    ImageDraw.Draw(picture).ellipse([30 - radius, 20 - radius, 30 + radius, 20 + radius], fill=(200, 120, 40))
    if dot:
        ImageDraw.Draw(picture).rectangle([*dot, dot[0] + 1, dot[1] + 1], fill=(255, 255, 255))
    return picture


def write_program(path, body):
    path.write_text("#!/bin/sh\n" + body)
    path.chmod(0o755)
    return path


def grade(program, folder, *arguments):
    command = [program, "grade", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, cwd=folder)


# One scene for each way to end, which has 4 s for it, also on a loaded machine. The program copies what its
# author "rendered" to ours/.
ENDINGS = {
    "good_one": ("", "100", ""),
    "good_two": ("", "100", ""),
    "off": ("", "98", ""),
    "status": ("echo 'done, nearly' >&2; cp \"$ours\" \"$2\"; exit 3", "100", "exit status 3"),
    "crash": ("cp \"$ours\" \"$2\"; echo 'about to fall'; kill -SEGV $$", "0", "crashed: Segmentation fault"),
    "hang": ("echo 'thinking'; sleep 60", "0", "hung: stopped after 4 s"),
    "nothing": ("echo 'what scene?'", "0", "wrote no picture"),
    "broken": ("echo nonsense > \"$2\"", "0", "PNG"),
    "huge":
    ("printf '\\211PNG\\r\\n\\032\\n\\0\\0\\0\\rIHDR\\0\\0\\050\\0\\0\\0\\050\\0\\010\\2\\0\\0\\0' > \"$2\"",
     "0",
     "expected 60 x 40 pixels, as the reference has, found 10240 x 10240"),
    "pipe": ("mkfifo \"$2\"", "0", "wrote no picture"),
    "endless": ("ln -s /dev/zero \"$2\"", "0", "out.png is a symbolic link, not a file"),
    "folder": ("mkdir \"$2\"; printf '\\033[2J\\rred \\377\\302\\233'", "0", "wrote no picture"),
    "size": ("", "0", "expected 60 x 40 pixels, as the reference has, found 30 x 20"),
}


def make_class(folder):
    """exam/ with scenes and references, ours/ with what the program makes of them, and the program."""
    for name in ("exam", "ours"):
        (folder / name).mkdir()
    for name in ENDINGS:
        (folder / "exam" / f"{name}.json").write_text(LEAST)
        draw_scene(10).save(folder / "exam" / f"{name}.png")
        shown = draw_scene(10, (5, 5)) if name == "off" else draw_scene(10)
        (shown.resize((30, 20)) if name == "size" else shown).save(folder / "ours" / f"{name}.png")
    draw_scene(10).save(folder / "exam" / "off-normals.png")
    (folder / "exam" / "lonely.json").write_text(LEAST)
    (folder / "exam" / "scene.schema.json").write_text(LEAST)
    cases = "".join(f"{name}) {body or 'cp $ours $2'};;\n" for name, (body, _, _) in ENDINGS.items())
    return write_program(folder / "student", '[ "$3" = 60 ] || exit 9\nname=$(basename "$1" .json); '
                                             f'ours={folder}/ours/$name.png\n'
                                             f"case $name in\n{cases}esac\n")


def check_cli(program, folder):
    make_class(folder)
    start = time.monotonic()
    result = grade(program, folder, "exam", "--program", "./student", "--wall", 4, "--report", "report.html")
    check(time.monotonic() - start < 40, "a program that hangs is stopped")
    check(result.returncode == 1, f"exit status 1, not {result.returncode}: {result.stderr}")
    rows = {match[2]: match for match in re.finditer(r"^ *(\d+) .*  (\w+)(?:: (.*))?$", result.stdout, re.M)}
    check(sorted(rows) == sorted(ENDINGS), f"a row for each scene: {result.stdout}")
    for name, (_, score, message) in ENDINGS.items():
        check(rows[name][1] == score and message in (rows[name][3] or ""), f"{name}: {rows[name][0]!r}")
    for words in ("about to fall", "done, nearly", "thinking", "what scene?"):
        check(words in result.stdout, f"a program's last line is shown: {result.stdout}")
    check("3 of 13 pictures as the reference, mean score 30.6" in result.stdout,
          f"the summary: {result.stdout[-200:]}")
    check(result.stdout.endswith("no reference: lonely.json\n"),
          "scenes without reference are told, and no schema")
    check("schema" not in result.stdout, f"a schema is no scene: {result.stdout}")
    safe = "\x1b" not in result.stdout and "  red \\xff\\xc2\\x9b\n" in result.stdout
    check(safe, f"no command for a terminal: {result.stdout}")
    page = (folder / "report.html").read_text("utf-8")
    check("\x1b" not in page and "\\x1b[2J\\x0dred \\xff\\xc2\\x9b</pre>" in page, "nor in the report")
    check(page.count("<article") == 13 and "crashed: Segmentation fault" in page and "about to fall" in page,
          "the report")
    check_statuses(program, folder)
    check_interrupt(program, folder)
    check_own_failures(program, folder)
    check_lost_folder(program, folder)
    check_isolation(program, folder)
    check_found(program, folder)
    check_changed_inputs(program, folder)
    check_looping_link(program, folder)
    check_links(program, folder)
    check_elsewhere(program, folder)
    check_deep_folders(program, folder)


def check_interrupt(program, folder):
    """A signal that ends the grading ends the program that is being graded, too, and leaves no folder."""
    write_program(folder / "sleeper", "(while :; do :> \"$2.$$\"; done) & mkdir -p \"$2.d/e\"; echo $$ > "
                                      "\"$0.pid\"; exec sleep 60\n")
    pid, temporary = folder / "sleeper.pid", folder / "tmp"
    temporary.mkdir()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        pid.unlink(missing_ok=True)
        grader = subprocess.Popen([program, "grade", "exam", "--program", "./sleeper", "--report",
                                   "tmp/r.html"], cwd=folder,
                                  stdout=subprocess.DEVNULL, env=os.environ | {"TMPDIR": str(temporary)})
        while not (pid.exists() and pid.read_text().strip()):
            time.sleep(0.01)
        check(len(list(temporary.iterdir())) == 3,
              "folders for the grading and for the program, and a place for the report")
        grader.send_signal(number)
        check(grader.wait(10) == -number, f"signal {number} ends the grading")
        check(has_ended(pid.read_text().strip()), f"signal {number} ends the program")
        check(not list(temporary.iterdir()), f"signal {number} leaves {list(temporary.iterdir())}")
    temporary.rmdir()


def check_own_failures(program, folder):
    """What fails on the grader's side is no score."""
    def failing(what, line, *arguments, before=(), **environment):
        command = [*before, program, "grade", *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, cwd=folder,
                              env=os.environ | environment)
        check((done.returncode, re.fullmatch(line, done.stderr) is not None, "mean score" in done.stdout) ==
              (2, True, False),
              f"{what}: {done.returncode} {done.stderr!r} {done.stdout!r}")

    (folder / "one").mkdir()
    shutil.copy(folder / "exam/good_one.png", folder / "one/a.png")
    (folder / "one/a.json").write_text(LEAST)
    failing("no temporary folder", "/no: cannot make a temporary folder: No such file or directory\n", "one",
            TMPDIR="/no")
    failing("the same for a program", "/no: cannot make a temporary folder: No such file or directory\n",
            "one",
            "--program", "true", TMPDIR="/no")
    failing("the disk is full", "/tmp/raytracer-\\w+: no room for a picture: File too large\n", "one",
            "--program", "true", before=["sh", "-c", 'ulimit -f 100; exec "$@"', "sh"], TMPDIR="")
    for blank in ("", "  "):
        failing("no program", f'raytracer grade: --program: expected a command, found "{blank}"\n',
                "one", "--program", blank)
    for command in ('true "', "true )"):
        failing(f"the shell's syntax, {command}",
                "raytracer grade: --program: a shell cannot read it: sh: .*\n", "one", "--program", command)
    for command in ("~/no-such", "python3 ~/no-such.py"):
        file = f"{folder}/empty{command.split('~')[1]}"
        failing(f"no file, {command}", f"raytracer grade: --program: there is no file {file}\n", "one",
                "--program", command, HOME=f"{folder}/empty")
    for command, comment in (("#", "#"), ("true # of ada", "# of ada")):
        failing(f"a comment, {command}", "raytracer grade: --program: a comment hides the scene from it: "
                f'leave out "{comment}"\n', "one", "--program", command)
    check_files(program, folder, failing)
    (folder / "one/a.png").write_bytes((folder / "one/a.png").read_bytes()[:100])
    failing("a broken reference",
            "one/a.png: broken PNG picture: it is cut short, or a checksum in it is wrong\n", "one",
            "--program",
            "true")
    mount = ["unshare", "-m", "sh", "-c", 'mount -t tmpfs -o size=512k none one && shift && exec "$@"', "sh",
             ""]
    if subprocess.run([*mount, "true"], cwd=folder, capture_output=True).returncode:
        print("a small disk: skipped, it can't be mounted")
    else:
        failing("a small disk",
                f"{folder}/one/raytracer-\\w+: no room for a picture: No space left on device\n", "few",
                "--program", "true", before=mount, TMPDIR="one")
        check_filled_disk(program, folder, failing, [word.replace("512k", "4m") for word in mount])


def check_filled_disk(program, folder, failing, mount):
    """A program that fills the disk has the score 0; another that runs at the same time has its own. Where a
    neighbour has filled the disk, there is no score, even if the disk is empty again at the program's end."""
    fill, copy = "head -c 8000000 /dev/zero > ", f"cp {folder}/exam/good_one.png $2"
    (folder / "single").mkdir()
    for file in ("good_one.json", "good_one.png"):
        shutil.copy(folder / "exam" / file, folder / "single")
    other = f"{folder}/one/other"
    for name, body in {"neighbour": f"{fill} {other}; {copy}",
                       "guest": f"{fill} {other}; sleep 1; {copy}; rm {other}"}.items():
        write_program(folder / name, body)
        failing(f"a {name} on the disk", f"{folder}/one/raytracer-\\w+: no room for a picture: "
                f"the disk has been filled meanwhile, by others or by ./{name}\n",
                "single", "--program", f"./{name}",
                before=mount, TMPDIR="one")
    first = f"[ -e {folder}/guest_was_here ] || {{ : > {folder}/guest_was_here; {fill} {other}; sleep 1; }}"
    fillers = {"bytes": f"{fill} x; sleep 0.4",
               "files": f"{copy}; i=0; while : > $i; do i=$((i + 1)); done; sleep 0.4"}
    tidy, well = {"tidy": f"{fill} x; sleep 1; {copy}; rm x"}, {"well": f"sleep 0.2; {copy}"}
    check_submissions(program, folder, mount, fillers | tidy | well, 1)
    check_submissions(program, folder, mount, fillers | well, 3)
    check_submissions(program, folder, mount, {"beside guest": f"{first}; {copy}; rm -f {other}"}, 2)


def check_submissions(program, folder, mount, bodies, jobs):
    """Those that fill the disk are told; the others have the score 100."""
    shutil.rmtree(folder / "fillers", ignore_errors=True)
    for name, body in bodies.items():
        (folder / "fillers" / name).mkdir(parents=True)
        write_program(folder / "fillers" / name / "run", body)
    done = subprocess.run([word.replace("size=4m", "size=4m,nr_inodes=300") for word in mount] +
                          [program, "grade", "single", "--submissions", "fillers", "--program", "{}/run",
                           "--csv", "fill.csv", "--jobs", str(jobs)], cwd=folder, capture_output=True,
                          text=True, timeout=60, env=os.environ | {"TMPDIR": "one"})
    rows = [line.split(",") for line in (folder / "fill.csv").read_text().splitlines()[1:]]
    expected = [(name, "0", True) if name in ("bytes", "files", "tidy") else (name, "100", False)
                for name in sorted(bodies)]
    check([(row[0], row[1], "filled the disk" in row[-1]) for row in rows] == expected,
          f"programs that fill the disk, {jobs} at a time: {done.stderr} {rows}")


def check_files(raytracer, folder, failing):
    """What is named twice, or is not there, is told before anything is graded."""
    program = ("--program", "true")
    for output in ("--csv", "--json", "--junit", "--gradescope"):
        for read in ("one/a.json", "one/../one/a.png"):
            failing(f"{output} over {read}", f"{read} is read, too: give another name for what is written\n",
                    "one", *program, output, read)
    failing("two files of one name", "one/../x is written twice: give each file its own name\n", "one",
            *program,
            "--csv", "x", "--json", "one/../x")
    check(not (folder / "x").exists(), "no file where the line is wrong")
    (folder / "pipes").mkdir()
    os.mkfifo(folder / "pipes/a.json")
    shutil.copy(folder / "exam/good_one.png", folder / "pipes/a.png")
    failing("a pipe for a scene", "pipes/a.json: cannot read: it is no regular file\n", "pipes", *program)
    # With fewer the undefined-behaviour sanitizer takes every object for another one.
    failing("six open files", "(/\\S+: )?cannot start a process: Too many open files\n", "one", *program,
            before=["sh", "-c", 'ulimit -n 6; exec "$@"', "sh"])
    (folder / "links").mkdir()
    shutil.copy(folder / "one/a.json", folder / "links")
    shutil.copy(folder / "exam/good_one.png", folder / "links/b.png")
    (folder / "links/photo.png").symlink_to("nowhere")  # which no scene has
    for name, target, why in (("b.json", "nowhere", "No such file or directory.*"),
                              ("a.png", "a.png", "Too many levels of symbolic links")):
        link = folder / "links" / name
        link.symlink_to(target)
        failing(f"a link {name}", f"links/{name}: cannot read: {why}\n", "links", *program)
        link.unlink()
    failing("--size", "raytracer grade: there is no --size: a picture has its reference's size, which a "
                      "program is told\n",
            "one", *program, "--size", 20)
    scene = json.loads(LEAST) | {
        "textures": {"wood": "no.png"}, "transforms": [{"name": "t"}],
        "materials": [{"name": "m", "use_diffuse_texture": True, "diffuse_texture": "wood"}],
        "shapes": [{"type": "sphere", "transform": "t", "material": "m"}]}
    (folder / "one/a.json").write_text(json.dumps(scene))
    (folder / "pupils/ada").mkdir(parents=True)
    for arguments in (program, ["--submissions", "pupils"],
                      ["--submissions", "pupils", "--program", "{}/rt"]):
        failing("a texture that is not there",
                r'one/a.json:1:\d+: /textures/wood: no file "one/no.png" '
                 r'\(relative to the scene file\); .*\n',
                "one", *arguments)
    check_shapes(raytracer, folder, failing)
    check_strays(raytracer, folder, copy.deepcopy(scene))
    check_read(folder, failing, scene)
    check_unreadable(raytracer, folder, failing)
    check_broken_scenes(folder, failing)
    (folder / "one/a.json").write_text(LEAST)


def check_shapes(raytracer, folder, failing):
    """A reference that no picture of its scene can equal is the grader's fault. A rounding is none."""
    (folder / "shapes/class/ada").mkdir(parents=True)
    (folder / "shapes/a.json").write_text(LEAST)
    for width, height in ((40, 40), (40, 60), (60, 42), (60, 38)):
        Image.new("RGB", (width, height)).save(folder / "shapes/a.png")
        line = f"shapes/a.png: {width} x {height} pixels is not the shape of a.json's film \\(1.5 : 1\\)\n"
        for arguments in ([], ["--program", "true"], ["--submissions", "shapes/class"],
                          ["--submissions", "shapes/class", "--program", "cp {}"]):
            failing(f"a reference of {width} x {height}, {arguments}", line, "shapes", *arguments)
    narrow = json.loads(LEAST)
    narrow["camera"] |= {"film_left": -0.1, "film_right": 0.2}
    (folder / "shapes/a.json").write_text(json.dumps(narrow))
    failing("a film that is high", r"shapes/a.png: 60 x 38 .* film \(1 : 6.667\)\n", "shapes")
    (folder / "shapes/a.json").write_text(LEAST)
    for height in (39, 41):
        Image.new("RGB", (60, height)).save(folder / "shapes/a.png")
        done = grade(raytracer, folder, "shapes", "--submissions", "shapes/class")
        check((done.returncode, done.stderr) == (0, ""), f"a height of {height}: {done.stderr}")


def check_strays(raytracer, folder, textured):
    """Pictures that are named nearly as references are told; textures, and others, are not."""
    here = folder / "strays"
    here.mkdir()
    textured["textures"]["wood"] = "./a-wood.png"
    for name, scene in {"a": textured, "a-2": SCENE, "b": SCENE, "c": SCENE}.items():
        (here / f"{name}.json").write_text(json.dumps(scene))
    for name in ("a.png", "a-normal.png", "a-2-specula.png", "a-wood.png", "wood.png", "other.bmp", "c.png",
                 "c.jpg", "c-2.txt", "ab-normal.png", "a-2.jpg", "b.JPG", "b-normals.tif", "b-sketch.png"):
        shutil.copy(folder / "exam/good_one.png", here / name)
    told = {"a-2-specula.png": 'no stage "specula"; did you mean "a-2-specular.png"?',
            "a-2.jpg": "it is no reference: expected a-2.png",
            "a-normal.png": 'no stage "normal"; did you mean "a-normals.png"?',
            "b-normals.tif": "it is no reference: expected b-normals.png",
            "b-sketch.png": 'no stage "sketch"; --help lists them',
            "b.JPG": "it is no reference: expected b.png"}
    for quiet in ([], ["--quiet"]):
        done = grade(raytracer, folder, "strays", "--program", f"cp {here}/a.png \"$2\"; :", *quiet)
        said = "" if quiet else "".join(f"warning: strays/{name}: {why}\n" for name, why in told.items())
        check((done.returncode, done.stderr) == (0, said), f"strays: {done.returncode} {done.stderr}")


def check_read(folder, failing, textured):
    """What a scene names is not overwritten, nor what lies in a submission, nor by pictures beside a page."""
    for name in ("named", "named/r_pictures", "hand_ins/ada", "hand_ins/r_pictures"):
        (folder / name).mkdir(parents=True)
    (folder / "named/a.json").write_text(json.dumps(textured))
    for name in ("named/no.png", "named/a.png", "named/r_pictures/a.png", "hand_ins/ada/a.png"):
        shutil.copy(folder / "exam/good_one.png", folder / name)
    for output, name, read, *more in (
        ("--csv", "named/no.png", "named/no.png"), ("--json", "hand_ins/ada/a.png", "hand_ins/ada/a.png"),
        ("--report", "named/r.html", "named/r_pictures", "--references", "named/r_pictures"),
        ("--report", "hand_ins/r.html", "hand_ins/r_pictures")):
        failing(f"{output} over {read}", f"{read} is read, too: give another name for what is written\n",
                "named", "--submissions", "hand_ins", output, name, *more)


def check_unreadable(program, folder, failing):
    """What another user's mode bits hide from the grader is not taken for missing."""
    other = ["setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"] if os.geteuid() == 0 else []
    folder.chmod(0o755)
    if shutil.which("setpriv") is None or subprocess.run([*other, program, "--version"],
                                                         capture_output=True).returncode:
        return print("what cannot be read: skipped, there is no other user")
    ada = folder / "hidden/class/ada"
    (ada / "pictures").mkdir(parents=True)
    for path in (ada / "pictures/good_one.png", folder / "hidden/good_one.png"):
        shutil.copy(folder / "exam/good_one.png", path)
    write_program(ada / "rt", "")
    (folder / "hidden/good_one.json").write_text(LEAST)
    (folder / "hidden/class/bob").mkdir()
    (folder / "hidden/links").mkdir()
    (folder / "hidden/links/cyd").symlink_to(ada / "pictures")
    given, pictures = ["--submissions", "hidden/class"], "hidden/class/ada/pictures"
    for path, mode, named, *arguments in (
        (ada, 0, "hidden/class/ada", *given), (ada / "pictures", 0, pictures, *given),
        (ada / "pictures", 0o644, f"{pictures}/good_one.png", *given),
        (ada / "pictures/good_one.png", 0, f"{pictures}/good_one.png", *given),
        (ada, 0, "hidden/links/cyd", "--submissions", "hidden/links"),
        (folder / "hidden/class/bob", 0o644, "hidden/class/bob/rt", *given, "--program", "{}/rt"),
        (ada / "pictures", 0o644, r"hidden/class/ada/pictures/good_one.*\.png", "--references", pictures)):
        before = path.stat().st_mode
        path.chmod(mode)
        failing(f"{named}, mode {mode:o}", f"{named}: cannot read: Permission denied\n", "hidden", *arguments,
                before=other)
        path.chmod(before)


def check_broken_scenes(folder, failing):
    """A scene that cannot be read is the grader's fault, whoever makes the pictures."""
    slip = json.loads(LEAST) | {"materials": [{"name": "m"}], "transforms": [{"name": "t"}],
                                "shapes": [{"type": "cubee", "transform": "t", "material": "m"}]}
    shown = r"\n {4}[^\n]*\n *\^\n"
    shutil.copytree(folder / "few", folder / "broken")
    shutil.copy(folder / "exam/good_one.png", folder / "broken/b.png")
    for text, line in (
        ('{"camera": ', 'broken/b.json:1:12: "}" is missing at the end of the object' + shown),
        (json.dumps(slip), r'broken/b.json:1:\d+: /shapes/0/type: expected "cube", found "cubee"\n')):
        (folder / "broken/b.json").write_text(text)
        for arguments in ([], ["--program", "true"], ["--submissions", "pupils"],
                          ["--submissions", "pupils", "--program", "{}/rt"]):
            failing(f"a broken scene, {arguments}", line, "broken", *arguments)


def check_isolation(program, folder):
    """A program runs in a folder of its own, and is found from here; the children of all its threads
    count."""
    (folder / "alone").mkdir()
    (folder / "my programs").mkdir()
    (folder / "alone/fresh.json").write_text(LEAST)
    draw_scene(10).save(folder / "alone/fresh.png")
    write_program(folder / "my programs/lists", 'pwd | grep -q "^/.*/raytracer-[^/]*/[^/]*$" || exit 9\n'
                                                'ls -A | tr "\\n" " "; cat "$2" "$1"\n')
    (folder / "word").write_text(" and a word")
    done = grade(program, folder, "alone", "--program", "'my programs/lists' ./word")
    check("fresh: wrote no picture\n" in done.stdout and f" fresh.json {LEAST} and a word\n" in done.stdout,
          f"in a fresh folder: {done.stdout}")
    (folder / "threads.py").write_text(
        "import subprocess, threading, time\n"
        "def start():\n    for _ in range(150): subprocess.Popen(['sleep', '60'])\n    time.sleep(60)\n"
        "thread = threading.Thread(target=start)\nthread.start()\nthread.join()\n")
    done = grade(program, folder, "alone", "--program", f"{sys.executable} threads.py", "--wall", 20)
    check("fresh: started too many processes\n" in done.stdout, f"children of a second thread: {done.stdout}")


# Commands in "found", and what they print.
FOUND = {
    "ex/p.sh a": "p.sh a",
    "ex/my\\ p.sh a": "my p.sh a",
    "ex/p.sh a;true": "p.sh a",
    "ulimit -c 0; ./own.sh": "own.sh",
    "timeout 8 ex/p.sh 8": "p.sh 8",
    "timeout -s KILL 8 ./own.sh 8": "own.sh 8",
    "sh own.sh own.sh": "own.sh own.sh",
    "timeout 8 sh -e own.sh": "own.sh",
    "env A=1 nice -n 10 sh -u own.sh p.sh": "own.sh p.sh",
    "A=1 B= ./own.sh": "own.sh",
    "cp ./own.sh ex/own.sh; :": "cp: cannot stat './own.sh': No such file or directory",
    "2>/dev/null ex/p.sh": "p.sh",
    "f() { ex/p.sh \"$@\"; }; f": "p.sh",
    "f() { ./own.sh; }; f": "own.sh",
    "if test -e x; then :; else ./own.sh 1; fi; :": "own.sh 1",
    "for i in 1; do sh own.sh; done; :": "own.sh",
    "echo sh own.sh .": "sh own.sh .",
    "touch x.py; rm -f old.py; test -e x.sh || ex/p.sh": "p.sh",
    "echo 'echo made' > own.sh; sh own.sh": "made",
    "echo 'echo made' > own.sh && chmod +x own.sh && ./own.sh": "made",
    "cp ex/p.sh . && sh p.sh": "p.sh",
    "mkdir ex && cp '{}/ex/p.sh' ex/q.sh && cd ex && sh q.sh": "q.sh",
}


def check_changed_inputs(program, folder):
    """A program that changes what is graded with, or deletes it, ends the grading: no score is of that."""
    here = folder / "changed"
    textured = SCENE | {
        "textures": {"wood": "wood.png"}, "transforms": [{"name": "t"}],
        "materials": [{"name": "m", "use_diffuse_texture": True, "diffuse_texture": "wood"}],
        "shapes": [{"type": "sphere", "transform": "t", "material": "m"}]}
    for name in ("exam", "class/ada", "class/bob", "class/cyd"):
        (here / name).mkdir(parents=True)

    def check_change(body, changed, who, *arguments):
        for name in ("a", "b"):
            (here / f"exam/{name}.json").write_text(json.dumps(textured))
            draw_scene(10).save(here / f"exam/{name}.png")
        draw_scene(9).save(here / "exam/wood.png")
        copies = f'cp {folder}/exam/good_one.png "$2"; cd {here}/exam'
        write_program(here / "class/ada/rt", copies + "\n")
        write_program(here / "class/bob/rt", f"{copies}; {body}\n")
        write_program(here / "class/cyd/rt", f"{copies}; sleep 3\n")
        done = grade(program, here, "exam", *arguments)
        said = f"exam/{changed}: it has changed while {who} ran; as root, --user NAME prevents that\n"
        check((done.returncode, done.stderr) == (2, said), f"{body}: {done.returncode} {done.stderr!r}")
        check("mean" not in done.stdout, f"{body}: {done.stdout}")

    each = ("--submissions", "class", "--program", "{}/rt")
    for body, changed in {'cp "$2" a.png': "a.png", "echo >> b.png": "b.png", "rm b.json": "b.json",
                          "touch wood.png": "wood.png", "rm *": "a.json"}.items():
        check_change(body, changed, here / "class/bob/rt", *each)
    each = (*each, "--jobs", 3)
    check_change("sleep 1; touch b.json", "b.json", f"{here}/class/bob/rt, or one beside it,", *each)
    check_change("touch b.json", "b.json", "class/bob/rt", "--program", "class/bob/rt")


def check_links(program, folder):
    """A link to a picture, or a picture with one more ending, is no picture: and that is said."""
    here = folder / "linked"
    shutil.copytree(folder / "loop/one", here / "exam")
    for name, *parts in (("ada", "x"), ("bob", "b.png", "a.jpg"), ("cyd", "no"),
                         ("eve", "b.png", "deep/a.png"), ("fay", "a.png.zip")):
        (here / "class" / name / "deep").mkdir(parents=True)
        for part in parts:
            shutil.copy(here / "exam/a.png", here / "class" / name / part)
        if name not in ("cyd", "fay"):
            (here / "class" / name / "a.png").symlink_to(parts[0])
    (here / "class/cyd/b.png").symlink_to("no")
    write_program(here / "rt", f'cp {here}/exam/a.png real.png; ln -s real.png "$2"; exit $STATUS\n')

    done = grade(program, here, "exam", "--submissions", "class", "--csv", "c.csv")
    rows = [line.split(",", 3) for line in (here / "c.csv").read_text().splitlines()[1:]]
    linked = '"a is missing, but a.png is a symbolic link"'
    expected = [["ada", "0", "0.0", linked], ["bob", "0", "0.0", '"a is missing, but a.jpg is there"'],
                ["cyd", "0", "0.0", "a is missing"], ["eve", "100", "100.0", ""],
                ["fay", "0", "0.0", '"a is missing, but a.png.zip is there"']]
    check(rows == expected, f"{done.stderr}{rows}")
    for status, said in ((0, ""), (3, "exit status 3, ")):
        done = grade(program, here, "exam", "--program", f"STATUS={status} ./rt")
        check(f"a: {said}out.png is a symbolic link, not a file\n" in done.stdout, f"a link: {done.stdout}")


def check_elsewhere(program, folder):
    """A picture that a program writes under another name is named: of several the nearest to the top. What
    the scene names is there, too, and is the grader's."""
    here = folder / "elsewhere"
    shutil.copytree(folder / "loop/one", here / "exam")
    shutil.copy(here / "exam/a.png", here / "exam/texture.png")
    (here / "exam/a.json").write_text(json.dumps(json.loads(LEAST) | {"textures": {"x": "texture.png"}}))
    for body, there in (("", ""), ("ln -s texture.png b.png; mkdir c.png; touch log", ""),
                        ("mkdir a; touch a/a.png z.jpg y.PPM", "y.PPM"),
                        ("mkdir -p a/b; touch a/b/c.png b.png.txt", "a/b/c.png"),
                        ("touch \"$(printf '\\033[2J\\377\\n.png')\"", r"\x1b[2J\xff\x0a.png")):
        write_program(here / "rt", body + "\nexit 3\n")
        done = grade(program, here, "exam", "--program", "./rt")
        said = "exit status 3, wrote no picture" + (there and f", but {there} is there")
        check(f"  a: {said}\n" in done.stdout, f"{body}: {done.stdout}{done.stderr}")


def check_deep_folders(program, folder):
    """Folders beyond a path's longest, or more than can be open at once, cost no one else's marks."""
    here = folder / "deep"
    shutil.copytree(folder / "loop/one", here / "exam")
    for name in ("ada", "eve", "d" * 40):
        (here / "class" / name).mkdir(parents=True)
        shutil.copy(here / "exam/a.png", here / "class" / name)
    for name in ("e", "d" * 40):
        place = os.open(here / "class" / (name if len(name) > 1 else "eve"), os.O_RDONLY)
        for _ in range(200):
            os.mkdir(name, dir_fd=place)
            above, place = place, os.open(name, os.O_RDONLY, dir_fd=place)
            os.close(above)
        os.close(place)
    done = subprocess.run(["sh", "-c", 'ulimit -n 160; exec "$@"', "sh", program, "grade", "exam",
                           "--submissions", "class"], capture_output=True, text=True, timeout=120, cwd=here)
    rows = [line.split()[:2] for line in done.stdout.splitlines()[1:]]
    check((done.returncode, rows, done.stderr) == (0, 3 * [["100.0", "1/1"]], ""), f"{rows}{done.stderr}")


def check_looping_link(program, folder):
    """A student's link to itself costs that student's marks, and no one else's."""
    here = folder / "loop"
    (here / "one").mkdir(parents=True)
    (here / "one/a.json").write_text(LEAST)
    draw_scene(10).save(here / "one/a.png")
    for name in ("ada", "eve"):
        (here / "class" / name).mkdir(parents=True)
    write_program(here / "class/ada/rt", f'cp {here}/one/a.png "$2"\n')
    (here / "class/eve/rt").symlink_to("rt")
    done = grade(program, here, "one", "--submissions", "class", "--program", "{}/rt")
    rows = [line.split()[:3] for line in done.stdout.splitlines()]
    check(done.returncode == 0 and ["100.0", "1/1", "ada"] in rows and ["0.0", "0/1", "eve"] in rows,
          f"a looping link: {done.returncode} {done.stdout}{done.stderr}")


def check_found(program, folder):
    """A path of ours in a command is found, and what the command makes is not taken for one."""
    here = folder / "found"
    (here / "ex").mkdir(parents=True)
    (here / "8").write_text("")
    for name in ("own.sh", "p.sh", "ex/p.sh", "ex/my p.sh"):
        write_program(here / name, 'echo "${0##*/}" "$@"\n')
    (here / "p.sh").write_text("echo that of another\n")
    (here / "one").mkdir()
    (here / "one/a.json").write_text(LEAST)
    draw_scene(10).save(here / "one/a.png")
    before = {path: path.read_bytes() for path in here.rglob("*") if path.is_file()}
    for command, printed in FOUND.items():
        line = command.replace("{}", str(here))
        done = grade(program, here, "one", "--program", f"{line} #\n:")
        check(printed in map(str.strip, done.stdout.split("\n")), f"{line}: {done.stdout}{done.stderr}")
        after = {path: path.read_bytes() for path in here.rglob("*") if path.is_file()}
        check(before == after, f"{line}: our folder is as it was")


def check_lost_folder(program, folder):
    """In a folder that is gone, .. is still there, but nothing has a whole path."""
    for found, *arguments in (["../few/[^/]*.json", "--program", "true"], [r"../\w+", "--submissions", ".."]):
        (folder / "gone").mkdir()
        command = f'rmdir "$PWD" && exec "$0" grade ../few {" ".join(arguments)}'
        done = subprocess.run(["sh", "-c", command, program], capture_output=True, text=True,
                              cwd=folder / "gone")
        said = f"{found}: cannot find the current folder: No such file or directory\n"
        check(done.returncode == 2 and re.fullmatch(said, done.stderr), f"no current folder: {done.stderr!r}")


def has_ended(pid):
    """Within two seconds: gone, or dead and waiting for init to take note."""
    for _ in range(100):
        try:
            if Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z":
                return True
        except FileNotFoundError:
            return True
        time.sleep(0.02)
    return False


def check_statuses(program, folder):
    shutil.copytree(folder / "exam", folder / "few",
                    ignore=lambda _, names: [n for n in names if n[:3] not in ("goo", "off")])
    (folder / "empty").mkdir()
    student = ("--program", "./student")
    for status, *arguments in [
        (1, "few", *student), (0, "few", *student, "--max-pixels", 4),
        (0, "few", *student, "--min-score", 98),
        (1, "few", *student, "--min-score", 99), (2, "few", *student, "--size", 61),
        (0, "few", "--references", "ours",
        *student), (2, "empty", *student), (2, "nowhere", *student),
        (2, "few", *student, "--report", "nowhere/r.html"),
        (2, "few", *student, "--stage", "sketch"), (2, "few", *student, "--timeout", 0), (2,),
        (0, "few", "--stage", "normals", "--program", "cp exam/off-normals.png \"$2\" #\n:"),
    ]:
        result = grade(program, folder, *arguments)
        check(result.returncode == status,
              f"{arguments}: exit status {result.returncode}: {result.stderr}{result.stdout}")
        if status == 2:
            check(result.stderr.count("\n") == 1, f"{arguments}: {result.stderr!r}")


def main():
    with tempfile.TemporaryDirectory() as name:
        check_cli(str(Path(sys.argv[1]).resolve()), Path(name))
    return conclude()


if __name__ == "__main__":
    sys.exit(main())
