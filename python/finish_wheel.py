"""Makes a wheel of this machine one for others: `finish_wheel.py WHEEL FOLDER`.

auditwheel takes in the libraries that it needs, under names of their own, so that others of the same names may live in one
process. Their licences go with them. Checks what comes of it: its size, and what it still needs of a machine."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

LARGEST = 60e6
# The C face, and the C++ one (cmake/library.map).
FACE = re.compile(r"ajar_|_Z(NK?|T.N)4ajar2v0")
# What manylinux lets a wheel ask of a machine: glibc, GCC's libraries and zlib.
SYSTEM = re.compile(r"(libc|libm|libdl|libpthread|librt|ld-linux-x86-64|libstdc\+\+|libgcc_s|libz)\.so\.")


def run(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


def is_elf(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def needed(path):
    return re.findall(r"\(NEEDED\).*\[(.+)\]", run("readelf", "-d", path))


def licence_of(library):
    """What Debian's package of a library says, by the name that it has there (without auditwheel's hash)."""
    name = re.sub(r"-[0-9a-f]{8}(?=[-.])", "", library.name)
    found = sorted(pathlib.Path("/usr/lib/x86_64-linux-gnu").glob(name.split(".so")[0] + ".so*"))
    for path in found:
        listed = subprocess.run(["dpkg", "-S", path.resolve()], capture_output=True, text=True, check=False).stdout
        if not listed:
            listed = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True, check=False).stdout
        for line in listed.splitlines():
            package = line.split(":")[0]
            copyright = pathlib.Path("/usr/share/doc") / package / "copyright"
            if copyright.exists():
                return package, copyright
    return None


def add_licences(folder):
    """Also of what is compiled in, headers alone."""
    target = next(folder.glob("*.dist-info")) / "licenses"
    target.mkdir(exist_ok=True)
    for library in (folder / "ajar_renderer.libs").iterdir():
        found = licence_of(library)
        if found is None:
            sys.exit(f"there is no licence of {library.name}")
        shutil.copy(found[1], target / f"{found[0]}.txt")
    for package in ("libboost1.74-dev", "nlohmann-json3-dev", "libcli11-dev", "libcereal-dev", "libstb-dev"):
        copyright = pathlib.Path("/usr/share/doc") / package / "copyright"
        if copyright.exists():
            shutil.copy(copyright, target / f"{package}.txt")


def check(folder):
    own = {path.name for path in folder.rglob("*") if path.is_file()}
    for path in folder.rglob("*"):
        if not path.is_file() or not is_elf(path):
            continue
        missing = [name for name in needed(path) if name not in own and not SYSTEM.match(name)]
        if missing:
            sys.exit(f"{path.name} needs what is not in the wheel: {', '.join(missing)}")
    library = folder / "ajar/lib/libajar.so"
    names = run("readelf", "--dyn-syms", "--wide", library)
    exported = {
        line.split()[7].split("@")[0]
        for line in names.splitlines()
        if len(line.split()) > 7 and line.split()[4] in ("GLOBAL", "WEAK", "UNIQUE") and line.split()[6] != "UND"
    }
    strangers = sorted(name for name in exported if not FACE.match(name))
    if strangers:
        sys.exit(f"{library.name} shows more than its faces: {', '.join(strangers[:10])}")


def main():
    wheel, target = map(pathlib.Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as text:
        work = pathlib.Path(text)
        run("auditwheel", "repair", wheel, "--wheel-dir", work / "repaired", "--strip")
        run(sys.executable, "-m", "wheel", "unpack", next((work / "repaired").glob("*.whl")), "--dest", work)
        folder = next(work.glob("ajar_renderer-*"))
        add_licences(folder)
        check(folder)
        run(sys.executable, "-m", "wheel", "pack", folder, "--dest-dir", work)
        finished = next(work.glob("*.whl"))
        size = finished.stat().st_size
        if size > LARGEST:
            sys.exit(f"{finished.name} has {size / 1e6:.1f} MB")
        target.mkdir(parents=True, exist_ok=True)
        shutil.copy(finished, target)
        print(f"{target / finished.name} ({size / 1e6:.1f} MB)")


if __name__ == "__main__":
    main()
