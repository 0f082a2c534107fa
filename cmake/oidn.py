"""Unpacks Open Image Denoise, of which Debian 12 has no package: `oidn.py [--check]`.

A package of Python's registry brings the three files that are needed. They go to the cache folder, where
src/post/denoise/oidn_library.h looks for them at run time. `--check` only tells by its exit code whether there is
nothing to do."""
import glob
import hashlib
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

PACKAGE = "pyoidn==2.5.1.0 --hash=sha256:32ad13368f8de1ef63001942ad05b02a00cd732d1206d97f352d3a3f606d823e"
WANTED = re.compile(r".*/libOpenImageDenoise(\.so\.2|_core\.so\.2[0-9.]*|_device_cpu\.so\.2[0-9.]*)$")


def cache_folder():
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.environ.get("HOME") or "/nowhere", ".cache")
    return pathlib.Path(cache, "ajar", "oidn")


def has_oidn(folder):
    """True if a folder has the files that were unpacked there, to the byte. Files without sums are believed."""
    if not (folder / "libOpenImageDenoise.so.2").is_file():
        return False
    if not (folder / "SHA256SUMS").is_file():
        return True
    check = ["sha256sum", "--check", "--status", "SHA256SUMS"]
    return subprocess.run(check, cwd=folder, stderr=subprocess.DEVNULL, check=False).returncode == 0


def load(folder):
    """The package, as a file in `folder`."""
    requirements = pathlib.Path(folder, "requirements.txt")
    requirements.write_text(PACKAGE + "\n", encoding="utf-8")
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--timeout", "15",
               "--retries", "1", "--no-deps", "--only-binary", ":all:", "--dest", folder, "--requirement", requirements]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise RuntimeError((result.stdout + result.stderr).strip().rpartition("\n")[2])
    return glob.glob(folder + "/*.whl")[0]


def write(path, content):
    with open(path, "wb") as target:
        target.write(content)
        os.fsync(target.fileno())


def remove(path):
    if os.path.isdir(path) and not os.path.islink(path):
        shutil.rmtree(path)
    elif os.path.lexists(path):
        os.unlink(path)


def unpack(package, folder):
    """Complete and on the disk, or not there at all. A folder that is killed in between is none that is looked into."""
    parts = tempfile.mkdtemp(dir=folder)
    try:
        sums = ""
        with zipfile.ZipFile(package) as archive:
            names = sorted(filter(WANTED.match, archive.namelist()))
            if len(names) != 3:
                raise RuntimeError(f"the package has not the three files: {names}")
            for name in names:
                content = archive.read(name)
                sums += f"{hashlib.sha256(content).hexdigest()}  {os.path.basename(name)}\n"
                write(os.path.join(parts, os.path.basename(name)), content)
        write(os.path.join(parts, "SHA256SUMS"), sums.encode())
        os.chmod(parts, 0o755)
        place = os.path.join(folder, "lib")
        if os.path.lexists(place):
            os.rename(place, parts + ".before")
        os.rename(parts, place)
    finally:
        remove(parts)
        remove(parts + ".before")


def main():
    folder = cache_folder()
    if platform.machine() != "x86_64" or has_oidn(folder / "lib"):
        return 0
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return 0
    if "--check" in sys.argv[1:]:
        return 1
    print(f"dev: unpacking Open Image Denoise into {folder}, once (90 MB to load)", file=sys.stderr)
    try:
        with tempfile.TemporaryDirectory() as loaded:
            unpack(load(loaded), folder)
    except (RuntimeError, OSError, IndexError, zipfile.BadZipFile) as error:
        print(f"dev: Open Image Denoise could not be loaded, so pictures are filtered by Ajar's own filter: {error}",
              file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
