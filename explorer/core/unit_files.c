// The database of UDUNITS, which lies in the core: what its reader opens, reads and closes.
#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <sys/types.h>

typedef struct unit_file {
    const char *name;
    size_t size;
    const unsigned char *bytes;
} unit_file;

static const unit_file files[] = {
#include "unit_files.inc"
};

enum { FILE_COUNT = sizeof files / sizeof *files, FIRST_DESCRIPTOR = 100 };

/// How far every file has been read. One reader at a time.
static size_t places[FILE_COUNT];

int unit_file_open(const char *path, int flags, ...);
ssize_t unit_file_read(int descriptor, void *to, size_t size);
int unit_file_close(int descriptor);

/// As open: the file of that name in any folder.
int unit_file_open(const char *path, int flags, ...) {
    (void)flags;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    for (int i = 0; i < FILE_COUNT; i++) {
        if (strcmp(files[i].name, name) != 0) continue;
        places[i] = 0;
        return FIRST_DESCRIPTOR + i;
    }
    errno = ENOENT;
    return -1;
}

/// As read.
ssize_t unit_file_read(int descriptor, void *to, size_t size) {
    const int i = descriptor - FIRST_DESCRIPTOR;
    if (i < 0 || i >= FILE_COUNT) {
        errno = EBADF;
        return -1;
    }
    const size_t left = files[i].size - places[i], count = size < left ? size : left;
    memcpy(to, files[i].bytes + places[i], count);
    places[i] += count;
    return (ssize_t)count;
}

/// As close.
int unit_file_close(int descriptor) {
    (void)descriptor;
    return 0;
}
