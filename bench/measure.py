"""Runs a command once and returns its cost. Imports little, so that the process it forks from stays small."""
import os
import statistics
import threading
import time
from dataclasses import dataclass

TIME_LIMIT = 900  # seconds of wall time, after which a run is ended and counts as failed


@dataclass
class Usage:
    user: float  # seconds of CPU in the program
    system: float  # seconds of CPU in the kernel
    wall: float
    peak: float  # MiB resident; not less than what this Python itself holds (memory_floor)
    said: str  # the end of what it wrote


class Failed(Exception):
    """The command ended with another status than 0; its text is the last thing that it said."""


def run(command, cwd=None):
    """One run of a command, its output kept only for the case that it fails."""
    null = os.open(os.devnull, os.O_RDWR)
    read_end, write_end = os.pipe()
    said = bytearray()

    def listen():
        while part := os.read(read_end, 65536):
            said.extend(part)
            del said[:-4000]

    listener = threading.Thread(target=listen)
    listener.start()
    start = time.perf_counter()
    here = os.getcwd()
    try:
        if cwd:
            os.chdir(cwd)
        pid = os.posix_spawnp(command[0], [str(word) for word in command], os.environ,
                              file_actions=[(os.POSIX_SPAWN_DUP2, null, 0),
                                            (os.POSIX_SPAWN_DUP2, write_end, 1),
                                            (os.POSIX_SPAWN_DUP2, write_end, 2)])
    finally:
        os.chdir(here)
        os.close(write_end)
        os.close(null)
    limit = threading.Timer(TIME_LIMIT, os.kill, (pid, 9))
    limit.start()
    _, status, used = os.wait4(pid, 0)
    wall = time.perf_counter() - start
    limit.cancel()
    listener.join()
    os.close(read_end)
    text = said.decode(errors="replace")
    if status != 0:
        code = os.waitstatus_to_exitcode(status)
        words = text.strip().splitlines()
        raise Failed(
            f"{os.path.basename(str(command[0]))} ended with {code}: {words[-1] if words else 'no message'}")
    return Usage(used.ru_utime, used.ru_stime, wall, used.ru_maxrss / 1024, text)


def memory_floor():
    """MiB below which a peak can't be told: a child counts the process that it was forked from."""
    return run(["true"]).peak


def alternated(commands, runs):
    """{name: [Usage]} of runs rounds; each round runs every command once, so that all meet the same weather.

    A command that fails is left out of the rest; its value is then the Failed."""
    usages = {name: [] for name in commands}
    for _ in range(runs):
        for name, command in commands.items():
            if isinstance(usages[name], Failed):
                continue
            try:
                usages[name].append(run(command))
            except Failed as failure:
                usages[name] = failure
    return usages


def median(usages, field):
    return statistics.median(getattr(usage, field) for usage in usages)


def ratio(usages, to, field):
    """The median over the rounds of a round's own ratio."""
    return statistics.median(getattr(a, field) / max(getattr(b, field), 1e-9) for a, b in zip(usages, to))
