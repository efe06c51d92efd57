#include "output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"

/// Makes a file in the folder of `path` and takes it away again: permissions alone do not tell for root, full or
/// read-only file systems.
static bool folder_takes_files(const char *path) {
    static const char pattern[] = ".whirl-XXXXXX";
    const char *slash = strrchr(path, '/');
    const size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
    char *trial = malloc(folder + sizeof pattern);
    if (!trial) return false;
    memcpy(trial, path, folder);
    memcpy(trial + folder, pattern, sizeof pattern);
    const int file = mkstemp(trial);
    const int reason = errno;
    if (file >= 0) {
        close(file);
        unlink(trial);
    }
    free(trial);
    errno = reason;
    return file >= 0;
}

bool output_is_writable(const char *path, const char *input) {
    struct stat there, source;
    if (stat(path, &there) == 0) {
        if (S_ISDIR(there.st_mode)) {
            complain("'%s' is a folder, expected the name of a result file", path);
            return false;
        }
        if (stat(input, &source) == 0 && there.st_dev == source.st_dev && there.st_ino == source.st_ino) {
            complain("the result would replace its own case '%s'; choose another name with -o", input);
            return false;
        }
    }
    if (folder_takes_files(path)) return true;
    complain("'%s' cannot be written: %s", path, strerror(errno));
    return false;
}

bool output_may_be_folder(const char *path) {
    struct stat there;
    if (path[0] == '\0') {
        complain("the name of the folder for the output is empty");
        return false;
    }
    const bool found = stat(path, &there) == 0;
    if (found ? S_ISDIR(there.st_mode) : errno != ENOTDIR) return true;
    complain("'%s' %s, expected a folder", path, found ? "is a file" : "lies in a file");
    return false;
}
