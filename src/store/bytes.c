#include "bytes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static whirl_status cannot_read(const char *path, const char *reason) {
    return whirl_fail(WHIRL_IO_ERROR, "cannot read %s: %s", path, reason);
}

// Reads until the size that the file had, or its end where it has become shorter.
static int fill(int file, unsigned char *bytes, size_t *size) {
    size_t done = 0;
    while (done < *size) {
        const ssize_t got = read(file, bytes + done, *size - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno;
        if (got == 0) break;
        done += (size_t)got;
    }
    *size = done;
    return 0;
}

static whirl_status read_open(int file, const char *path, unsigned char **bytes, size_t *size) {
    struct stat found;
    if (fstat(file, &found) != 0) return cannot_read(path, strerror(errno));
    if (S_ISDIR(found.st_mode)) return cannot_read(path, "it is a folder");
    if (!S_ISREG(found.st_mode)) return cannot_read(path, "it is no ordinary file");
    *size = (size_t)found.st_size;
    *bytes = malloc(*size ? *size : 1);
    if (!*bytes) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %s, %zu bytes", path, *size);
    const int reason = fill(file, *bytes, size);
    if (reason == 0) return whirl_ok();
    free(*bytes);
    *bytes = NULL;
    return cannot_read(path, strerror(reason));
}

whirl_status bytes_read(const char *path, unsigned char **bytes, size_t *size) {
    *bytes = NULL;
    // Opening a pipe without a writer must not wait.
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return cannot_read(path, strerror(errno));
    const whirl_status status = read_open(file, path, bytes, size);
    close(file);
    return status;
}
