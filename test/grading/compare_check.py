"""Tests `raytracer compare` against an independent implementation in numpy, on generated pairs of pictures.

Usage: compare_check.py RAYTRACER. Exit status 77 (CTest: skipped) without numpy or Pillow.
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
    from PIL import Image, ImageFilter
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

RANDOM = np.random.default_rng(20240607)


def gradient(height, width):
    """A smooth picture with a disc in it: edges, flat parts and slopes."""
    y, x = np.mgrid[0:height, 0:width]
    picture = np.stack([255 * x / width, 255 * y / height, 128 + 0 * x], axis=2).astype(np.uint8)
    picture[(x - width / 2) ** 2 + (y - height / 2) ** 2 < (height / 4) ** 2] = (220, 40, 40)
    return picture


def noise(height, width, top=256):
    return RANDOM.integers(0, top, (height, width, 3), dtype=np.uint8)


def speckled(picture, count, value=(255, 255, 255)):
    result = picture.copy()
    places = RANDOM.choice(picture.shape[0] * picture.shape[1], count, replace=False)
    result.reshape(-1, 3)[places] = value
    return result


def one_channel_off_by_one(picture):
    result = picture.copy()
    result[..., 1] = np.where(result[..., 1] < 255, result[..., 1] + 1, 254)
    return result


def with_block(picture):
    result = picture.copy()
    result[10:30, 5:50] = (0, 255, 0)
    return result


def pairs():
    base = gradient(90, 120)
    blurred = np.asarray(Image.fromarray(base).filter(ImageFilter.GaussianBlur(1.5)))
    yield "equal", base, base
    yield "noise", noise(61, 83), noise(61, 83)
    yield "nearly black noise", noise(64, 64, 12), noise(64, 64, 12)
    yield "moved by one", base, np.roll(base, 1, axis=1)
    yield "speckled", speckled(base, 40), speckled(base, 25, (0, 0, 40))
    yield "inverted", base, 255 - base
    yield "one channel off by one", base, one_channel_off_by_one(base)
    yield "blurred", base, blurred
    yield "a wrong block", base, with_block(base)
    yield "one row", noise(1, 77), noise(1, 77)
    yield "one pixel", noise(1, 1), noise(1, 1)
    linear = (base / 255.0).astype(np.float32)
    yield "floats", linear, (linear * 1.02 + RANDOM.normal(0, 0.003, linear.shape)).astype(np.float32)
    yield "bright floats", 3 * linear - 1, 3 * np.roll(linear, 1, axis=0) - 1
    yield "floats and bytes", linear, blurred
    black, nan = np.zeros((20, 30, 3), np.float32), np.full((20, 30, 3), np.nan, np.float32)
    yield "black and NaN", black, nan
    yield "NaN in both", np.where(noise(20, 30) < 99, nan, black), np.where(noise(20, 30) < 99, nan, black)
    checkers = np.where(np.indices((20, 30)).sum(axis=0)[..., None] % 2 == 0, black, black + 1)
    yield "NaN among extremes", np.where(noise(20, 30) < 2, nan, checkers), checkers
    yield "NaN and bytes", np.where(noise(20, 30) < 99, nan, black), noise(20, 30)


def save(picture, stem):
    """Bytes as PNG, floats as little-endian PFM (rows from the bottom up)."""
    if picture.dtype == np.uint8:
        path = stem.with_suffix(".png")
        Image.fromarray(picture).save(path)
        return path
    path = stem.with_suffix(".pfm")
    header = f"PF\n{picture.shape[1]} {picture.shape[0]}\n-1.0\n".encode()
    path.write_bytes(header + picture[::-1].astype("<f4").tobytes())
    return path


def to_bytes(picture, other):
    """A NaN that meets a number gets the byte farthest from it."""
    if picture.dtype == np.uint8:
        return picture.astype(int)
    quantised = [np.floor(255 * np.clip(np.nan_to_num(one.astype(float)), 0, 1) + 0.5).astype(int)
                 if one.dtype != np.uint8 else one for one in (picture, other)]
    return np.where(np.isnan(picture) & ~np.isnan(other), np.where(quantised[1] < 128, 255, 0), quantised[0])


def windows(picture, outside):
    """Each pixel's 3 x 3 neighbourhood, as an array of 9 pictures, the centre being number 4."""
    padded = np.pad(picture, ((1, 1), (1, 1), (0, 0)), constant_values=outside)
    height, width, _ = picture.shape
    return np.stack([padded[dy:dy + height, dx:dx + width] for dy in range(3) for dx in range(3)])


def nearest(a, b, nan):
    """Per channel, the difference to the first of the nearest neighbours, the centre being looked at before
    the others."""
    order = [4, 0, 1, 2, 3, 5, 6, 7, 8]
    differences = np.abs(a[None] - windows(np.where(nan, 10000, b), 10000)[order])
    chosen = differences.sum(axis=3).argmin(axis=0)
    return np.where(nan, np.abs(a - b), np.take_along_axis(differences, chosen[None, ..., None], axis=0)[0])


def score(a, b, nan_a, nan_b):
    """A pixel with a NaN is nobody's neighbour, and as far as can be from a number."""
    nan, one_only = nan_a | nan_b, (nan_a != nan_b).any(axis=2, keepdims=True)
    there, back = [np.where(one_only, 255, nearest(*pair, nan.any(axis=2, keepdims=True)))
                   for pair in ((a, b), (b, a))]
    larger = np.where(back.sum(axis=2, keepdims=True) > there.sum(axis=2, keepdims=True), back, there)
    return int(round(max(0.0, 100 - np.average(larger) / 255 * 100 * 10)))


def alone(picture):
    neighbours = np.delete(windows(picture, 10000), 4, axis=0)
    present = neighbours[..., 0] != 10000
    unlike = (np.abs(neighbours - picture[None]) > 8).any(axis=3)
    return (unlike | ~present).all(axis=0) & present.any(axis=0)


def finite(number):
    """As in JSON."""
    return float(number) if math.isfinite(number) else None


def expected(a, b):
    bytes_a, bytes_b = to_bytes(a, b), to_bytes(b, a)
    floats = a.dtype != np.uint8 and b.dtype != np.uint8
    peak = 1 if floats else 255
    samples = np.abs(a.astype(float) - b.astype(float)) if floats else np.abs(bytes_a - bytes_b).astype(float)
    samples[np.isnan(samples)] = np.where(np.isnan(a) == np.isnan(b), 0, np.inf)[np.isnan(samples)]
    by_pixel = np.abs(bytes_a - bytes_b).max(axis=2)
    rmse = math.sqrt(np.mean(samples ** 2))
    ranking = np.lexsort((np.arange(by_pixel.size), -samples.sum(axis=2).ravel(),
                          -samples.max(axis=2).ravel()))
    worst_y, worst_x = divmod(int(ranking[0]), a.shape[1])
    return {
        "width": a.shape[1],
        "height": a.shape[0],
        "differing": int((by_pixel > 0).sum()),
        "differing_by_more_than_1": int((by_pixel > 1).sum()),
        "differing_by_more_than_8": int((by_pixel > 8).sum()),
        "mean": finite(np.mean(samples)),
        "rmse": finite(rmse),
        "psnr": 10 * math.log10(peak ** 2 / rmse ** 2) if rmse and math.isfinite(rmse) else None,
        "maximum": finite(samples.max()),
        "worst": [worst_x, worst_y],
        "score": score(bytes_a, bytes_b, np.isnan(a), np.isnan(b)),
        "speckle": int((alone(bytes_a) != alone(bytes_b)).sum()),
        "within": bool((by_pixel == 0).all()),
    }


def same(found, wanted):
    if isinstance(wanted, float) and isinstance(found, (int, float)):
        return math.isclose(found, wanted, rel_tol=1e-12, abs_tol=1e-12)
    return found == wanted


def run(program, *arguments):
    return subprocess.run([program, "compare", *map(str, arguments)], capture_output=True, text=True,
                          timeout=60)


def check_pair(program, folder, name, a, b):
    path_a, path_b, path_diff = save(a, folder / "a"), save(b, folder / "b"), folder / "diff.png"
    result = run(program, path_a, path_b, "--json", "--diff", path_diff)
    wanted = expected(a, b)
    if result.returncode != (0 if wanted["within"] else 1):
        yield f"{name}: exit status {result.returncode}: {result.stderr}"
        return
    found = json.loads(result.stdout)
    if list(found) != list(wanted):
        yield f"{name}: keys {list(found)}"
    yield from (f"{name}: {key}: {found.get(key)}, here {wanted[key]}" for key in wanted
                if not same(found.get(key), wanted[key]))
    difference = np.abs(to_bytes(a, b) - to_bytes(b, a))
    amplified = np.where(difference > 0, np.minimum(255, 64 + 8 * difference), 0)
    if not np.array_equal(np.asarray(Image.open(path_diff)), amplified):
        yield f"{name}: the difference picture is another one"


def check_statuses(program, folder):
    """The exit status, and that what can't be compared gets one line on stderr."""
    a, b = gradient(20, 20), speckled(gradient(20, 20), 3)
    path_a, path_b = save(a, folder / "a"), save(b, folder / "b")
    small, broken = save(gradient(10, 20), folder / "small"), folder / "broken.png"
    broken.write_bytes(path_a.read_bytes()[:100])
    cases = [
        (0, path_a, path_a), (1, path_a, path_b), (0, path_a, path_b, "--max-pixels", 3),
        (1, path_a, path_b, "--max-pixels", 2), (0, path_a, path_b, "--min-score", 50),
        (1, path_a, path_b, "--min-score", 100), (0, path_a, path_b, "--tolerance", 255),
        (2, path_a, folder / "missing.png"), (2, broken, path_a), (2, path_a, small), (2, path_a, folder),
        (2, path_a, path_b, "--diff", folder / "no folder" / "diff.png"), (2, path_a),
        (2, path_a, path_b, "--minscore", 3),
    ]
    for status, *arguments in cases:
        result = run(program, *arguments)
        if result.returncode != status:
            yield f"{arguments}: exit status {result.returncode}, not {status}: {result.stderr}"
        if status == 2 and (result.stdout or result.stderr.count("\n") != 1):
            yield f"{arguments}: not one line on stderr: {result.stderr!r} {result.stdout!r}"
        if status != 2 and result.stderr:
            yield f"{arguments}: {result.stderr!r}"


def check_overwriting(program, folder):
    """A picture that is read is not overwritten, by whatever name."""
    path = save(gradient(20, 20), folder / "a")
    (folder / "link.png").symlink_to("a.png")
    for name in (path, folder / "link.png"):
        before = path.read_bytes()
        result = run(program, path, path, "--diff", name)
        said = f"{name} is read, too: give another name for what is written\n"
        if (result.returncode, result.stderr, path.read_bytes()) != (2, said, before):
            yield f"--diff over a picture: {result.returncode} {result.stderr!r}"


def main():
    failures, count = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for count, (title, a, b) in enumerate(pairs(), 1):
            failures += check_pair(sys.argv[1], folder, title, a, b)
        failures += check_statuses(sys.argv[1], folder)
        failures += check_overwriting(sys.argv[1], folder)
    print("\n".join(failures) or f"{count} pairs: every number is the same")
    return 1 if failures else 0


sys.exit(main())
