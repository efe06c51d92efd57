"""Opens files that Python reads for the library."""

import errno
import os
import stat


def open_input(path: str | os.PathLike) -> int:
    """Opens an ordinary file. Raises OSError for folders, pipes and devices, whose reading might not end."""
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0))
    kind = os.fstat(descriptor).st_mode
    if stat.S_ISREG(kind):
        return descriptor
    os.close(descriptor)
    if stat.S_ISDIR(kind):
        raise IsADirectoryError(errno.EISDIR, "it is a folder", str(path))
    what = "pipe" if stat.S_ISFIFO(kind) else "device"
    raise OSError(errno.EINVAL, f"it is a {what}, expected an ordinary file", str(path))


def read_input(path: str | os.PathLike, most: int) -> bytes:
    """Reads at most ``most`` bytes of an ordinary file. Raises OSError as open_input does."""
    with open(open_input(path), "rb") as file:
        return file.read(most)
