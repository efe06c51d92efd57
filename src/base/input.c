#include "input.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "whirl/internal/input.h"

/// Closes the file, notes the reason, and returns false.
static bool input_fail(input_file *in, int error, const char *reason) {
    if (in->descriptor >= 0) close(in->descriptor);
    in->descriptor = -1;
    in->no_memory = error == ENOMEM;
    if (reason)
        snprintf(in->reason, sizeof in->reason, "%s", reason);
    else if (strerror_r(error, in->reason, sizeof in->reason) != 0)
        snprintf(in->reason, sizeof in->reason, "error %d", error);
    return false;
}

bool input_open(const char *path, input_file *in) {
    struct stat found;
    *in = (input_file){.descriptor = -1};
    do in->descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    while (in->descriptor < 0 && errno == EINTR);
    if (in->descriptor < 0 || fstat(in->descriptor, &found) != 0) return input_fail(in, errno, NULL);
    if (S_ISDIR(found.st_mode)) return input_fail(in, 0, "it is a folder");
    if (S_ISFIFO(found.st_mode)) return input_fail(in, 0, "it is a pipe, expected an ordinary file");
    if (!S_ISREG(found.st_mode)) return input_fail(in, 0, "it is a device, expected an ordinary file");
    in->size = (uint64_t)found.st_size;
    return true;
}

/// Reads until the end of the file, at most `most` bytes; returns the number of bytes, -1 after a failure.
static ssize_t read_up_to(int descriptor, char *to, size_t most) {
    size_t length = 0;
    while (length < most) {
        const ssize_t got = read(descriptor, to + length, most - length);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return -1;
        if (got == 0) break;
        length += (size_t)got;
    }
    return (ssize_t)length;
}

bool input_read(const char *path, size_t most, input_file *in, char **text, size_t *length) {
    *text = NULL;
    *length = 0;
    if (!input_open(path, in)) return false;
    // A file may grow meanwhile, and those of /proc have no size.
    const size_t capacity = in->size > 0 && in->size < most ? (size_t)in->size + 1 : most;
    char *bytes = malloc(capacity + 1);
    const ssize_t got = bytes ? read_up_to(in->descriptor, bytes, capacity < most ? capacity : most) : 0;
    if (!bytes || got < 0) {
        const int error = bytes ? errno : ENOMEM;
        free(bytes);
        return input_fail(in, error, NULL);
    }
    close(in->descriptor);
    in->descriptor = -1;
    bytes[got] = '\0';
    *text = bytes;
    *length = (size_t)got;
    return true;
}

size_t whirl_input_head(const char *path, char *head, size_t size) {
    input_file in;
    head[0] = '\0';
    if (!input_open(path, &in)) return 0;
    const ssize_t got = read_up_to(in.descriptor, head, size - 1);
    close(in.descriptor);
    head[got > 0 ? got : 0] = '\0';
    return got > 0 ? (size_t)got : 0;
}

bool input_path_from(const char *file, const char *path, char *out, size_t size) {
    const char *slash = strrchr(file, '/');
    const int folder = *path == '/' || !slash ? 0 : (int)(slash + 1 - file);
    const int length = snprintf(out, size, "%.*s%s", folder, file, path);
    return length >= 0 && (size_t)length < size;
}
