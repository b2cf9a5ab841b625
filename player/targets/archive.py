#!/usr/bin/env python3
"""Packs an exported game for upload: the same files give the same bytes, whenever, where and by whomever they are packed.

    archive.py linux|windows|web FOLDER NAME FILE...

Writes these files of the folder to NAME-linux.tar.xz, NAME-windows.zip or NAME-web.zip beside it and prints its path. All files have the time
SOURCE_DATE_EPOCH (s since 1970), by default 2000-01-01. They are in a folder NAME; those of a page are not, because hosts
of pages expect so.
"""
import lzma
import os
import stat
import sys
import tarfile
import time
import zipfile


def mode_of(path):
    return 0o755 if os.stat(path).st_mode & stat.S_IXUSR else 0o644


def write_tar(out, folder, files, start, moment):
    with lzma.open(out, "wb", preset=9) as packed, tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as archive:
        for path in files:
            file = os.path.join(folder, path)
            entry = tarfile.TarInfo(start + path)  # owner 0
            entry.size, entry.mtime, entry.mode = os.path.getsize(file), moment, mode_of(file)
            with open(file, "rb") as content:
                archive.addfile(entry, content)


def write_zip(out, folder, files, start, moment):
    with zipfile.ZipFile(out, "w") as archive:
        for path in files:
            file = os.path.join(folder, path)
            entry = zipfile.ZipInfo(start + path, time.gmtime(moment)[:6])
            entry.create_system = 3  # Unix: with the mode
            entry.external_attr = (stat.S_IFREG | mode_of(file)) << 16
            with open(file, "rb") as content:
                archive.writestr(entry, content.read(), zipfile.ZIP_DEFLATED, 9)


def main():
    target, folder, name = sys.argv[1], os.path.abspath(sys.argv[2]), sys.argv[3]
    files = sorted(sys.argv[4:], key=os.fsencode)
    first = 315532800  # 1980-01-01: a zip file has no earlier times
    moment = max(int(os.environ.get("SOURCE_DATE_EPOCH", "946684800")), first)
    write, ending = (write_tar, "tar.xz") if target == "linux" else (write_zip, "zip")
    archive = os.path.join(os.path.dirname(folder), f"{name}-{target}.{ending}")
    made = archive + ".part"
    try:
        write(made, folder, files, "" if target == "web" else name + "/", moment)
        os.replace(made, archive)
    except OSError as failed:
        if os.path.isfile(made):
            os.remove(made)
        sys.exit(f"plumb: the archive {archive} was not written: {failed}; check the free disk space and the write permission")
    print(archive)


main()
