# SPDX-License-Identifier: MIT
"""Renders generated scenes, two at a time, and keeps those that lambert does not take well."""
import concurrent.futures
import os
import pathlib
import random
import subprocess
import sys

SECONDS = 20  # a scene of 64 pixels takes less
MEGABYTES = 2048
INCLUDES = "/usr/share/povray-3.7/include"
# What loops are given; a legitimate endless one must not count as a hang.
LOOP_TOKENS = "1000000"

ROOT = pathlib.Path(__file__).resolve().parents[2]


def environment():
    """The caller's, in which a sanitizer ends with a status of its own."""
    return dict(
        os.environ,
        ASAN_OPTIONS=f"exitcode=99:detect_leaks=1:hard_rss_limit_mb={MEGABYTES}:allocator_may_return_null=0",
        UBSAN_OPTIONS="print_stacktrace=1:exitcode=99")


def fault(lambert, path, folder):
    """What is wrong with how lambert takes the scene, or None."""
    command = [lambert, path, "--size", "8x8", "--threads", "1", "--loop-limit", LOOP_TOKENS, "-o",
               path.with_suffix(".png"), "+L" + INCLUDES, f"+L{folder}"]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              timeout=SECONDS, env=environment(), cwd=path.parent, check=False)
    except subprocess.TimeoutExpired:
        return f"not done in {SECONDS} s"
    words = done.stderr.decode("latin-1")
    for line in words.splitlines():
        if "runtime error:" in line or "ERROR: AddressSanitizer" in line or "ERROR: LeakSanitizer" in line \
                or "Assertion" in line or "hard rss limit" in line:
            return line
    if done.returncode not in (0, 1):
        return f"exit status {done.returncode}"
    if done.returncode == 1 and "error:" not in words:
        return "refused without a word"
    if done.returncode == 1 and "out of memory" in words:
        return "out of memory"
    return None


def run(name, make, count, seed, lambert):
    """Prints the faults and their number; True when there are none."""
    folder = ROOT / "build" / "tests" / "fuzz" / name
    folder.mkdir(parents=True, exist_ok=True)

    def one(index):
        path = folder / f"{name}-{seed}-{index}.pov"
        text, includes = make(random.Random(f"{name} {seed} {index}"))
        path.write_bytes(text)
        found = fault(lambert, path, includes)
        path.with_suffix(".png").unlink(missing_ok=True)
        if found is None:
            path.unlink()
        return path, found

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for path, found in pool.map(one, range(count)):
            if found:
                failed += 1
                print(f"FAIL {path.relative_to(ROOT)}: {found}", flush=True)
    print(f"{count - failed} passed, {failed} failed")
    return failed == 0


def main(name, make):
    """The command line of a generator; make(random) gives the bytes of a scene and a folder for its includes."""
    if len(sys.argv) not in (3, 4):
        sys.exit(f"usage: tests/fuzz/{name} COUNT SEED [LAMBERT]")
    lambert = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else ROOT / "build/asan/lambert").resolve()
    sys.exit(0 if run(name, make, int(sys.argv[1]), sys.argv[2], lambert) else 1)
