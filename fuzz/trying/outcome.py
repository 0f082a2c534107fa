"""What a run of the program may end like, and what it must not."""
import math
import os
import re
import resource
import struct
import subprocess

PLACE = re.compile(r"^ajar: error: .+:\d+:\d+: ", re.M)
# Scenes that are refused as a whole have no place: what is too large is so in sum.
WHOLE = re.compile(r"memory|no such file|cannot (open|read)|is not a|is a folder")


def run(command, folder, seconds=60, gigabytes=6):
    """(exit code, stderr, seconds of the clock are up)"""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (gigabytes << 30, gigabytes << 30))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=seconds,
                              preexec_fn=limit)
    except subprocess.TimeoutExpired as late:
        return None, (late.stderr or b"").decode(errors="replace"), True
    return done.returncode, done.stderr.decode(errors="replace"), False


def pfm_complaint(path, scene, message):
    """Why a picture is none: missing, not finite without a word, negative though no filter is."""
    if not os.path.exists(path):
        return "no picture"
    with open(path, "rb") as file:
        data = file.read()
    _, size, _, rest = data.split(b"\n", 3)
    width, height = map(int, size.split())
    values = struct.unpack("<%df" % (3 * width * height), rest)
    if not all(math.isfinite(v) for v in values) and "values of the picture are infinite" not in message:
        return "values that are not finite"
    if min(values) < 0 and not re.search("mitchell|sinc", scene):
        return "negative values"
    return ""


def complaint(code, message, late):
    """Empty if the run ended as it may."""
    if late:
        return "hang"
    if code < 0:
        return "signal %d" % -code
    if code not in (0, 2, 3, 4):
        return "exit code %d" % code
    if "internal error" in message or "please report" in message:
        return "internal error"
    if re.search("[\x00-\x08\x0b-\x1f\x7f]", message):
        return "control characters"
    if code != 0 and "ajar: error: " not in message:
        return "no message"
    if code == 3 and not PLACE.search(message) and not WHOLE.search(message):
        return "no place"
    return ""
