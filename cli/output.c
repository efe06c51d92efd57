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

/// Opens an anonymous file in `folder`. On systems without anonymous files it opens one with a temporary name of the
/// result, which a later run removes if it is left.
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

/// Writes the folder of `path`: the part up to the last '/', or ".". Returns false if it is too long.
static bool folder_of(const char *path, char folder[PATH_SIZE]) {
    const char *slash = strrchr(path, '/');
    const int length = slash ? (int)(slash - path) + 1 : 0;
    return snprintf(folder, PATH_SIZE, "%.*s", length ? length : 1, length ? path : ".") < PATH_SIZE;
}

/// Returns true if a file can be made in the folder. Permissions do not show this for root, and for full or read-only
/// file systems.
static bool folder_takes_files(const char *folder, const char *path) {
    const int file = trial_file(folder, path);
    if (file >= 0) close(file);
    return file >= 0;
}

/// Length of the longest suffix that is added to a result's name: RESULT.h5.journal-NUMBER.tmp-PROCESS.
enum { LONGEST_ENDING = 40 };

static bool name_is_short(const char *folder, const char *path) {
    const char *slash = strrchr(path, '/');
    const size_t length = strlen(slash ? slash + 1 : path);
    const long most = pathconf(folder, _PC_NAME_MAX);
    if (most < LONGEST_ENDING || length <= (size_t)most - LONGEST_ENDING) return true;
    complain("the name of the result has %zu bytes, expected at most %ld: the names of its journals are longer", length,
             most - LONGEST_ENDING);
    return false;
}

/// Returns true if nothing is at `path`, or a file that a result may replace; otherwise reports an error.
static bool is_no_other_thing(const char *path, const char *input) {
    struct stat there, source;
    if (stat(path, &there) != 0) return true;
    if (S_ISDIR(there.st_mode))
        complain("'%s' is a folder, expected the name of a result file", path);
    else if (!S_ISREG(there.st_mode))
        complain("'%s' is no ordinary file, expected the name of a result file", path);
    else if (stat(input, &source) == 0 && there.st_dev == source.st_dev && there.st_ino == source.st_ino)
        complain("the result would replace its own case '%s'; choose another name with -o", input);
    else
        return true;
    return false;
}

bool output_is_writable(const char *path, const char *input) {
    char folder[PATH_SIZE];
    struct stat found;
    // Check the name: not empty, not that of the case or of a folder, no ending of another kind of file.
    if (path[0] == '\0') {
        complain("the name of the result is empty");
        return false;
    }
    if (!is_no_other_thing(path, input)) return false;
    if (!whirl_result_name_fits(path)) {
        complain("'%s' has the ending of another kind of file, expected the name of a result, such as result.h5", path);
        return false;
    }
    // Check the folder: it exists, and files can be made in it.
    if (strlen(path) + LONGEST_ENDING > PATH_SIZE || !folder_of(path, folder)) {
        complain("the path of the result is too long");
        return false;
    }
    if (stat(folder, &found) != 0 && errno == ENOENT) {
        complain("'%s' cannot be written: there is no folder '%s'", path, folder);
        return false;
    }
    if (!name_is_short(folder, path)) return false;
    if (folder_takes_files(folder, path)) return true;
    complain("'%s' cannot be written: %s", path, strerror(errno));
    return false;
}

bool output_is_free(const char *path) {
    struct stat there;
    if (lstat(path, &there) != 0) return true;
    complain("'%s' is there already and is kept: add --force to replace it, or name another result with -o", path);
    return false;
}

void keep_private(const char *path) {
    struct stat found;
    if (stat(path, &found) != 0 || !S_ISREG(found.st_mode)) return;
    const mode_t group = found.st_mode & S_IRGRP ? 0 : S_IRWXG, others = found.st_mode & S_IROTH ? 0 : S_IRWXO;
    const mode_t mask = umask(S_IRWXG | S_IRWXO);
    umask(mask | group | others);
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
