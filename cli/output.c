#define _GNU_SOURCE // O_TMPFILE; NOLINT(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"

enum { PATH_SIZE = 4096 };

/// A file in `folder` that nobody sees and that is gone with its descriptor, where the system has such; else one by the
/// name that half results have, which a later run takes away.
static int trial_file(const char *folder, const char *path) {
#ifdef O_TMPFILE
    const int nameless = open(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (nameless >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return nameless;
#else
    (void)folder;
#endif
    char name[PATH_SIZE];
    if (snprintf(name, sizeof name, "%s.tmp-%ld", path, (long)getpid()) >= (int)sizeof name) {
        errno = ENAMETOOLONG;
        return -1;
    }
    const int file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file >= 0) unlink(name);
    return file;
}

/// Makes a file in the folder of `path`: permissions alone do not tell for root, full or read-only file systems.
static bool folder_takes_files(const char *path) {
    char folder[PATH_SIZE];
    const char *slash = strrchr(path, '/');
    const int length = slash ? (int)(slash - path) + 1 : 0;
    if (snprintf(folder, sizeof folder, "%.*s", length ? length : 1, length ? path : ".") >= (int)sizeof folder) {
        errno = ENAMETOOLONG;
        return false;
    }
    const int file = trial_file(folder, path);
    if (file >= 0) close(file);
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
