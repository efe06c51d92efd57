"""Files that Python reads for the library."""

import errno
import os
import stat


def read_input(path: str | os.PathLike, most: int) -> bytes:
    """The first bytes of a plain file, at most ``most``. OSError for anything else: a folder, a pipe or a device, which
    would wait or never end."""
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0))
    try:
        kind = os.fstat(descriptor).st_mode
        if stat.S_ISDIR(kind):
            raise IsADirectoryError(errno.EISDIR, "it is a folder", str(path))
        if not stat.S_ISREG(kind):
            what = "pipe" if stat.S_ISFIFO(kind) else "device"
            raise OSError(errno.EINVAL, f"it is a {what}, expected an ordinary file", str(path))
        with open(descriptor, "rb", closefd=False) as file:
            return file.read(most)
    finally:
        os.close(descriptor)
