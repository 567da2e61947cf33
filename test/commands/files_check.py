"""Tests the files that the program writes: complete, at the right place, and nothing else; otherwise one line
and exit status 2.

Usage: files_check.py RAYTRACER [root], from the source folder. `root` runs the tests that need another user,
mounts or process numbers of their own; where these are not possible, the exit status is 77 (CTest: skipped).
"""
import os
import pathlib
import pty
import random
import shutil
import signal
import stat
import struct
import subprocess
import sys
import tempfile
import time

from checks import RAYTRACER, check, conclude

SCENE = str(pathlib.Path("test/good/least.json").resolve())
# They end a program, too.
RARE_SIGNALS = (signal.SIGPWR, signal.SIGVTALRM, signal.SIGPROF, signal.SIGIO, signal.SIGUSR1,
                signal.SIGRTMIN, signal.SIGRTMIN + 1, signal.SIGRTMAX, 16)  # 16: SIGSTKFLT
NOBODY = ["setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"]


def refused(what, line, done):
    check(what, (2, b"", line + "\n"), done)


def run(*arguments, before=(), **options):
    """(status, stdout, stderr) of the program; a run that does not end fails the test."""
    done = subprocess.run([*before, RAYTRACER, *map(str, arguments)], capture_output=True, timeout=100,
                          **options)
    return done.returncode, done.stdout, done.stderr.decode()


def render(out, size=10, *more, **options):
    return run(SCENE, out, size, "--quiet", *more, **options)


def width(path):
    data = pathlib.Path(path).read_bytes()
    return struct.unpack(">I", data[16:20])[0] if data[:4] == b"\x89PNG" else None


def names(folder):
    return sorted(entry.name for entry in folder.iterdir())


def check_links(folder):
    (folder / "sub").mkdir()
    (folder / "link.png").symlink_to("sub/next.png")
    (folder / "sub/next.png").symlink_to("x.png")
    for size in (10, 20):  # dangling, then not
        check(f"a chain of links, {size} px", (0, b"", ""), render(folder / "link.png", size))
        check("the links stay", [True, True],
              [(folder / link).is_symlink() for link in ("link.png", "sub/next.png")])
        check("the picture is behind them", size, width(folder / "sub/x.png"))
    (folder / "loop.png").symlink_to("loop.png")
    refused("a loop", f"{folder}/loop.png: cannot write: Too many levels of symbolic links",
            render(folder / "loop.png"))
    (folder / "lost.png").symlink_to("no/x.png")
    refused("into no folder",
            f'{folder}/lost.png: cannot write: No such file or directory; there is no folder "{folder}/no"',
            render(folder / "lost.png"))
    check("nothing else", ["link.png", "loop.png", "lost.png", "sub"], names(folder))
    check("nor behind the links", ["next.png", "x.png"], names(folder / "sub"))


def check_replaced(folder):
    out = folder / "m.png"
    for mode in (0o600, 0o640, 0o755):
        out.write_bytes(b"old")
        out.chmod(mode)
        check(f"over a file of mode {mode:o}", (0, b"", ""), render(out))
        check("keeps the mode", mode, stat.S_IMODE(out.stat().st_mode))
    os.link(out, folder / "hard.png")
    render(out, 20)
    check("a hard link is broken", (20, 10), (width(out), width(folder / "hard.png")))
    old = os.umask(0o077)
    render(folder / "new.png")
    os.umask(old)
    check("a new file has the mode that the umask leaves", 0o600,
          stat.S_IMODE((folder / "new.png").stat().st_mode))


def access_list(*entries):
    """(tag, permissions, user) of each entry, as Linux keeps them."""
    return struct.pack("<I", 2) + b"".join(struct.pack("<HHI", *entry) for entry in entries)


def permissions(file):
    return stat.S_IMODE(file.stat().st_mode), {name: os.getxattr(file, name) for name in os.listxattr(file)}


def check_access_lists(folder):
    """One user more may read and write, and the group nothing, though the mode says 660."""
    file, attribute, none = folder / "listed.png", "system.posix_acl_access", 0xffffffff
    list_ = access_list((1, 6, none), (2, 6, 1234), (4, 0, none), (16, 6, none), (32, 0, none))
    file.write_bytes(b"old")
    try:
        os.setxattr(file, attribute, list_)
    except OSError:
        return  # the file system has no access lists
    check("over a file with an access list", (0, b"", ""), render(file))
    check("keeps the list", (0o660, {attribute: list_}), permissions(file))
    plain = folder / "plain.png"
    plain.write_bytes(b"old")
    plain.chmod(0o640)
    os.setxattr(folder, "system.posix_acl_default", list_)  # what new files get
    check("over a file without one", (0, b"", ""), render(plain))
    check("gets none", (0o640, {}), permissions(plain))
    render(folder / "new.png")
    check("a new file has the folder's list", [attribute], os.listxattr(folder / "new.png"))


def check_in_place(folder):
    with open(folder / "open", "w+b") as file:
        file.write(b"x" * 10000)
        file.flush()
        (folder / "fd.png").symlink_to(f"/proc/self/fd/{file.fileno()}")
        inode = os.fstat(file.fileno()).st_ino
        check("/proc/self/fd", (0, b"", ""), render(folder / "fd.png", pass_fds=[file.fileno()]))
        check("/proc/self/fd: the same file, cut", (inode, 10, True),
              ((folder / "open").stat().st_ino, width(folder / "open"),
               (folder / "open").stat().st_size < 1000))
    (folder / "full.png").symlink_to("/dev/full")
    refused("/dev/full", f"{folder}/full.png: cannot write: No space left on device",
            render(folder / "full.png"))
    check("/dev/full is there", True, stat.S_ISCHR(os.stat("/dev/full").st_mode))
    os.mkfifo(folder / "pipe.png")
    with subprocess.Popen(["cat", folder / "pipe.png"], stdout=subprocess.PIPE) as reader:
        check("a pipe", (0, b"", ""), render(folder / "pipe.png"))
        check("a pipe gets the picture", b"\x89PNG", reader.stdout.read()[:4])


def check_names(folder):
    for name, head in (("a.PNG", b"\x89PNG"), ("a.Pfm", b"PF\n10 10\n")):
        check(name, (0, b"", ""), render(folder / name))
        check(f"{name}: its format", True, (folder / name).read_bytes().startswith(head))
    (folder / "floats").write_bytes((folder / "a.Pfm").read_bytes())
    check("compare knows a PFM by its content", (0, ""),
          run("compare", folder / "a.Pfm", folder / "floats", "--quiet")[::2])
    for name in ("a.gif", "png", ""):
        refused(f"name {name!r}", f"{folder / name}: expected a name that ends in .png or .pfm",
                render(folder / name))
    long = folder / ("n" * 300 + ".png")
    refused("a long name", f"{long}: cannot write: File name too long", render(long))


def check_before_rendering(folder):
    """Each would take hours if the scene was rendered first."""
    hours = ("--samples", 256, "--max-recursion", 1000)
    (folder / "d.png").mkdir()
    refused("a folder", f"{folder}/d.png: cannot write: Is a directory",
            render(folder / "d.png", 65536, *hours))
    refused("no folder",
            f'{folder}/no/x.png: cannot write: No such file or directory; there is no folder "{folder}/no"',
            render(folder / "no/x.png", 65536, *hours))
    check("a file that is no folder", 0, render(folder / "x.png")[0])
    check("nothing else", ["d.png", "x.png"], names(folder))
    for command in (("grade", "test", "--csv"), ("compare", SCENE, SCENE, "--diff")):
        refused(command[0],
                f"{folder}/no/r.png: cannot write: No such file or directory; "
                f'there is no folder "{folder}/no"',
                run(*command, folder / "no/r.png"))
    refused("--diff -",
            'raytracer compare: --diff: expected a name, found "-": only a render writes to stdout',
            run("compare", SCENE, SCENE, "--diff", "-"))
    (folder / "out").mkdir()
    (folder / "out/tradeoff.svg").mkdir()
    check("tradeoff", (2, b"", f"{folder}/out/tradeoff.svg: cannot write: Is a directory\n"),
          run("tradeoff", SCENE, "--quiet", "--size", 4096, "--samples", 16, "--out", folder / "out"))
    check("tradeoff: nothing else", ["tradeoff.svg"], names(folder / "out"))
    check("tradeoff: no folder", (2, b"", f"{folder}/x.png/out: cannot make the folder: Not a directory\n"),
          run("tradeoff", SCENE, "--quiet", "--out", folder / "x.png/out"))


def check_standard_output(folder):
    picture = folder / "p.png"
    render(picture)
    status, out, error = render("-")
    check("- is a PNG on standard output", (0, picture.read_bytes(), ""), (status, out, error))
    refused("- and --stats", "raytracer: the picture - and --stats both go to standard output: "
            "name a file for the picture",
            render("-", 10, "--stats"))
    master, terminal = pty.openpty()
    done = subprocess.run([RAYTRACER, SCENE, "-", "10"], stdout=terminal, stderr=subprocess.PIPE, timeout=100)
    line = "the picture - is no text for a terminal: write - > out.png"
    check("- on a terminal", (2, f"raytracer: {line}\n"), (done.returncode, done.stderr.decode()))
    os.close(terminal)
    os.close(master)


def check_slow_reader(folder):
    """Standard output that does not wait, as some programs hand it on."""
    read, write = os.pipe()
    os.set_blocking(write, False)
    with subprocess.Popen([RAYTRACER, "scenes/texture.json", "-", "800", "--quiet"], stdout=write) as program:
        os.close(write)
        time.sleep(0.2)
        with open(read, "rb") as pipe:
            check("a slow reader", b"IEND\xaeB`\x82", pipe.read()[-8:])
    check("a slow reader: status", 0, program.returncode)


def check_write_errors(folder):
    (folder / "s.json").write_bytes(pathlib.Path(SCENE).read_bytes())
    picture = folder / "s.png"
    render(picture)
    commands = {
        "help": ["--help"], "compare": ["compare", picture, picture],
        "compare --json": ["compare", picture, picture, "--json"],
        "explain": ["explain", SCENE, 5, 5, 10], "grade": ["grade", folder],
        "stats": [SCENE, folder / "o.png", 10, "--quiet", "--stats"],
        "picture": [SCENE, "-", 10, "--quiet"],
        "tradeoff": ["tradeoff", SCENE, "--quiet", "--size", 16, "--samples", 2, "--repeats", 1, "--out",
                     folder / "t"],
    }
    for name, arguments in commands.items():
        for where, why in (("> /dev/full", "No space left on device"), (">&-", "Bad file descriptor"),
                           ("", "Broken pipe")):
            read, write = os.pipe()
            os.close(read)  # nobody reads: with "", a write fails
            done = subprocess.run(["sh", "-c", f'"$@" {where}', "sh", RAYTRACER, *map(str, arguments)],
                                  stdout=write, stderr=subprocess.PIPE, timeout=100)
            os.close(write)
            check(f"{name} {where}", (2, f"standard output: {why}\n"),
                  (done.returncode, done.stderr.decode()))
    status, _, error = run(*commands["tradeoff"], before=["sh", "-c", 'ulimit -f 20; "$@"', "sh"])
    check("tradeoff: a large file", (2, f"{folder}/t/tradeoff.html: cannot write: File too large\n"),
          (status, error))
    check("tradeoff leaves nothing", [], names(folder / "t"))
    for stream, where in (("/dev/stdout", ">&-"), ("/dev/stdin", "<&-"), ("/proc/self/fd/1", ">&-")):
        out = folder / "link.png"
        out.unlink(missing_ok=True)
        out.symlink_to(stream)
        done = subprocess.run(["sh", "-c", f'"$@" {where}', "sh", RAYTRACER, SCENE, out, "8", "--quiet"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100)
        check(f"{stream} {where}", (2, f"{out}: cannot write: Bad file descriptor\n"),
              (done.returncode, done.stderr))
    (folder / "fd").symlink_to("/dev/fd")
    for out in ("/proc/self/x.png", "/proc/self/fd/77.png", folder / "fd/77.png"):
        done = subprocess.run([RAYTRACER, SCENE, out, "10", "--stats"], capture_output=True, text=True,
                              timeout=100)
        check(f"{out}: told before the work", (2, "", f"{out}: cannot write: No such file or directory\n"),
              (done.returncode, done.stdout, done.stderr))
    (folder / "graded").mkdir()
    for name in ("s.json", "s.png"):
        (folder / "graded" / name).write_bytes((folder / name).read_bytes())
    done = subprocess.run([RAYTRACER, "grade", folder / "graded", "--json", "/dev/fd/77"],
                          capture_output=True, text=True, timeout=100)
    check("/dev/fd/77: told before the work",
          (2, "", "/dev/fd/77: cannot write: No such file or directory\n"),
          (done.returncode, done.stdout, done.stderr))
    closed = ["sh", "-c", '"$@" 2>&- <&- >&-', "sh", RAYTRACER, SCENE, folder / "closed.png", "10", "--stats"]
    check("no stream is open", (2, False),
          (subprocess.run(closed).returncode, (folder / "closed.png").exists()))
    check("no stream is open, none needed", (0, 10),
          (subprocess.run(closed[:-1]).returncode, width(folder / "closed.png")))


def check_signals(folder):
    """Where a signal ends the program at any moment, a file is as before or, if it came after the rename,
    whole."""
    subprocess.run([RAYTRACER, SCENE, folder / "old.pfm", "1200", "--quiet"], check=True)
    whole = (folder / "old.pfm").read_bytes()
    (folder / "old.pfm").write_bytes(before := b"old")
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT) * 4 + RARE_SIGNALS:
        for out in ("old.pfm", "new.pfm"):
            program = subprocess.Popen([RAYTRACER, SCENE, folder / out, "1200", "--quiet", "--threads", "8"])
            time.sleep(random.uniform(0.001, 0.12))
            program.send_signal(number)  # as `timeout` does: to the process, and to its group
            program.send_signal(number)
            status = program.wait(60)
            is_whole = (folder / out).exists() and (folder / out).read_bytes() == whole
            check(f"signal {number}", True, status == -number or status == 0 and is_whole)
            if is_whole:
                (folder / out).unlink()
                (folder / "old.pfm").write_bytes(before)
            check(f"after signal {number}", ["old.pfm"], names(folder))
            check(f"the old file after signal {number}", before, (folder / "old.pfm").read_bytes())
    done = subprocess.run(["sh", "-c", 'ulimit -f 0; "$@"', "sh", RAYTRACER, SCENE, folder / "new.png", "10",
                           "--quiet"],
                          capture_output=True)
    check("ulimit -f 0", (2, f"{folder}/new.png: cannot write: File too large\n".encode()),
          (done.returncode, done.stderr))
    program = subprocess.Popen(["nohup", RAYTRACER, SCENE, folder / "new.png", "600", "--quiet"],
                               stderr=subprocess.DEVNULL)
    program.send_signal(signal.SIGCONT)
    check("nohup", 0, program.wait(60))
    check("nothing else", ["new.png", "old.pfm"], names(folder))


def check_other_users(folder):
    """Another user's files, as a user who is not root."""
    folder.chmod(0o777)
    files = (("mine.png", 0o644, 65534, 0), ("read_only.png", 0o444, 65534, 2), ("shared.png", 0o666, 0, 0))
    for name, mode, owner, status in files:
        out = folder / name
        out.write_bytes(b"precious")
        out.chmod(mode)
        os.chown(out, owner, owner)
        inode = out.stat().st_ino
        line = f"{out}: cannot write: Permission denied\n" if status else ""
        check(name, (status, b"", line), render(out, before=NOBODY))
        now = out.stat()
        check(f"{name}: owner, mode, content", (owner, mode, status == 0),
              (now.st_uid, stat.S_IMODE(now.st_mode), width(out) == 10))
        check(f"{name}: in place", name == "shared.png" or status == 2, now.st_ino == inode)
    for folder_mode in (0o755, 0o1777):  # not writable; sticky, as /tmp
        folder.chmod(folder_mode)
        check(f"in a folder of mode {folder_mode:o}", (0, b"", ""),
              render(folder / "shared.png", 20, before=NOBODY))
        check("as root, over another's", (0, b"", ""), render(folder / "mine.png"))
        check("whose it stays", 65534, (folder / "mine.png").stat().st_uid)
    folder.chmod(0o755)
    refused("a new file there", f"{folder}/x.png: cannot write: Permission denied",
            render(folder / "x.png", before=NOBODY))
    check("nothing else", ["mine.png", "read_only.png", "shared.png"], names(folder))


def check_locked_folder(folder):
    """A graded program may lock the grader's folder; the grader gets rid of it all the same."""
    for name in ("exam", "tmp"):
        (folder / name).mkdir()
        (folder / name).chmod(0o777)
    shutil.copy(SCENE, folder / "exam/a.json")
    render(folder / "exam/a.png")
    lock = 'd=$(dirname "$2"); mkdir -p "$d/e/f"; chmod 500 "$d/e/f"; chmod 0 "$d/e"; chmod 0 "$d"'
    (folder / "locker").write_text(f"#!/bin/sh\n{lock}\n")
    (folder / "locker").chmod(0o755)
    status, out, error = run("grade", folder / "exam", "--program", folder / "locker", before=NOBODY,
                             env=os.environ | {"TMPDIR": str(folder / "tmp")})
    check("a program that locks its folder", (1, True, ""),
          (status, b"  a: wrote no picture\n" in out, error))
    check("its folder", [], names(folder / "tmp"))


def check_mounts(folder):
    for name in ("mounted.png", "source.png"):
        (folder / name).write_bytes(b"")
    script = 'mount --bind "$1" "$2" && shift 2 && exec "$@"'
    bind = ["unshare", "-m", "sh", "-c", script, "sh", folder / "source.png", folder / "mounted.png"]
    check("a file that is mounted", (0, b"", ""), render(folder / "mounted.png", before=bind))
    check("is written", (10, None), (width(folder / "source.png"), width(folder / "mounted.png")))
    (folder / "small").mkdir()
    script = ('f=$1; shift; mount -t tmpfs -o size=64k none $f; echo old > $f/x.pfm; "$@"; '
              'echo $? $(ls -A $f) $(cat $f/x.pfm)')
    small = ["unshare", "-m", "sh", "-c", script, "sh", folder / "small"]
    status, out, error = render(folder / "small/x.pfm", 200, before=small)
    check("a full disk", (b"2 x.pfm old\n", f"{folder}/small/x.pfm: cannot write: No space left on device\n"),
          (out, error))


def check_first_process(folder):
    """A container's first process outlives a signal's default action."""
    command = ["unshare", "--pid", "--fork", RAYTRACER, SCENE, folder / "x.pfm", "8000", "--samples", "64",
               "--quiet"]
    outer = subprocess.Popen(command)
    children = pathlib.Path(f"/proc/{outer.pid}/task/{outer.pid}/children")
    while not names(folder):
        time.sleep(0.01)
    os.kill(int(children.read_text()), signal.SIGTERM)
    check("a container's first process ends", 128 + signal.SIGTERM, outer.wait(60))
    check("nothing is left", [], names(folder))


def check_same_numbers(folder):
    """Two processes with the same number write to one folder, as two containers do."""
    for _ in range(3):
        apart = ["unshare", "--pid", "--fork", RAYTRACER, SCENE, "--quiet"]
        writers = [subprocess.Popen([*apart, folder / f"{size}.pfm", str(size)]) for size in (700, 701)]
        check("both end well", [0, 0], [writer.wait(60) for writer in writers])
        for size in (700, 701):
            check("each has its own picture", b"PF\n%d %d\n" % (size, size),
                  (folder / f"{size}.pfm").read_bytes()[:11])
    check("nothing else", ["700.pfm", "701.pfm"], names(folder))


def main():
    checks = [check_links, check_replaced, check_access_lists, check_in_place, check_names,
              check_before_rendering, check_standard_output, check_slow_reader, check_write_errors,
              check_signals]
    if sys.argv[2:] == ["root"]:
        able = ["unshare", "-m", "--pid", "--fork", *NOBODY, RAYTRACER, "--help"]
        others_reach = all(parent.stat().st_mode & 1 for parent in pathlib.Path(RAYTRACER).parents)
        if os.geteuid() != 0 or not others_reach or subprocess.run(able, capture_output=True).returncode:
            print("skipped: not root, without unshare or setpriv, or nobody may not run the program")
            return 77
        checks = [check_other_users, check_locked_folder, check_mounts, check_first_process,
                  check_same_numbers]
    for one in checks:
        with tempfile.TemporaryDirectory() as name:
            os.chmod(name, 0o755)
            one(pathlib.Path(name))
    return conclude("every file as it should be")


if __name__ == "__main__":
    sys.exit(main())
