#!/usr/bin/python3
"""Compares the cost of --target-error, in rays and CPU time, with that of the best setting of the regular
grid that reaches the same error.

    bench/target_cost.py --old PROGRAM [--raytracer PROGRAM] [--size 240] [--errors 0.02 0.01 0.005 0.002]
        scenes/*.json

--old is this project's program at commit bd55ad3: --samples N was a grid of N x N, and --adaptive T took all
of them where the four corners differ by more than T. Its best setting is found by prediction. Measured are
the sampling error and the cost of each grid at one depth, and the truncation error and the cost of each depth
at one sample. To predict a setting, the squared errors are added, and the rays multiplied. The cheapest
setting that is predicted to reach the error is rendered, and the next one if that fails. Rays are those of
--stats: all rays cast, including those of the pilot samples.
"""
import argparse
import json
import pathlib
import statistics
import sys
import tempfile

import numpy

from target_error import Program, rmse

DEPTHS = ([(r, c) for r in (0, 1, 2, 3, 4, 6, 8, 12, 16) for c in (0.01, 0.03, 0.1, 0.3, 1)] +
          [(r, 0) for r in (1, 2, 3)])
DEEP = (16, 0.01)
GRIDS = [(n, t) for n in (1, 2, 3, 4, 6, 8, 12, 16) for t in ((0,) if n < 3 else (0.3, 0.1, 0.03, 0.01, 0))]


class Old:
    """Every render of the old program is done once."""

    def __init__(self, program, scene, size, truth):
        self.program, self.scene, self.size, self.truth, self.done = program, scene, size, truth, {}

    def render(self, grid, depth):
        if (grid, depth) not in self.done:
            picture, done = self.program.render(self.scene, self.size, "--stats", "--samples", grid[0],
                                                "--adaptive", grid[1],
                                                "--max-recursion", depth[0], "--cutoff", depth[1])
            self.done[grid, depth] = picture, *cost_of(done)
        return self.done[grid, depth]

    def best(self, error):
        """(rays, CPU seconds) of the cheapest that reaches it, or None."""
        deep, deep_rays, _ = self.render((1, 0), DEEP)
        depths = {d: (rmse(self.render((1, 0), d)[0], deep), self.render((1, 0), d)[1] / deep_rays)
                  for d in DEPTHS}
        guesses = []
        for grid in GRIDS:
            picture, rays, _ = self.render(grid, DEEP)
            sampling = rmse(picture, self.truth)
            guesses += [(rays * share, grid, d) for d, (left_out, share) in depths.items()
                        if sampling ** 2 + left_out ** 2 <= (1.02 * error) ** 2]
            if grid[1] == 0 and sampling < 0.9 * error:
                break  # more samples cost more
        for _, grid, depth in sorted(guesses)[:12]:
            picture, rays, seconds = self.render(grid, depth)
            if rmse(picture, self.truth) <= error:
                return rays, seconds, grid, depth
        return None


def cost_of(done):
    stats = json.loads(done.stdout)
    return sum(stats["rays"].values()), stats["cpu_seconds"]["choose"] + stats["cpu_seconds"]["render"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raytracer",
                        default=pathlib.Path(__file__).resolve().parent.parent / "build/release/raytracer")
    parser.add_argument("--old", required=True)
    parser.add_argument("--size", type=int, default=240)
    parser.add_argument("--errors", type=float, nargs="+", default=[0.02, 0.01, 0.005, 0.002])
    parser.add_argument("scenes", nargs="+")
    arguments = parser.parse_args()
    rays, seconds = [], []
    with tempfile.TemporaryDirectory() as name:
        new = Program(arguments.raytracer, pathlib.Path(name))
        old_program = Program(arguments.old, pathlib.Path(name))
        for scene in arguments.scenes:
            truth = new.truth(scene, arguments.size, min(arguments.errors), 2)
            old = Old(old_program, scene, arguments.size, truth)
            for error in arguments.errors:
                picture, done = new.render(scene, arguments.size, "--target-error", error, "--stats")
                ours, best = cost_of(done), old.best(error)
                reached = rmse(picture, truth) / error
                line = (f"{pathlib.Path(scene).stem} E {error}: {reached:.2f} E, "
                        f"{ours[0] / 1e6:.3g} million rays")
                if best is None:
                    print(f"{line}; the grid does not reach it")
                    continue
                rays.append(ours[0] / best[0])
                seconds.append(ours[1] / best[1])
                print(f"{line}; {rays[-1]:.2f} of the rays and {seconds[-1]:.2f} of the time of {best[2]} at "
                      f"depth {best[3]}", flush=True)
    for kind, ratios in (("rays", rays), ("CPU time", seconds)):
        print(
            f"{kind}: median {statistics.median(ratios):.2f}, most {max(ratios):.2f} of {len(ratios)} cases; "
              f"{sum(r > 1.2 for r in ratios)} above 1.2")


if __name__ == "__main__":
    main()
