#include "atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static whirl_status cannot_write(const char *path, const char *reason) {
    return whirl_fail(WHIRL_IO_ERROR, "cannot write %s: %s", path, reason);
}

/// Writes the folder of `path` to `folder`.
static void parent_of(const char *path, char *folder) {
    const char *slash = strrchr(path, '/');
    const size_t length = slash ? (size_t)(slash - path) : 0;
    if (!slash) {
        strcpy(folder, ".");
    } else if (length == 0) {
        strcpy(folder, "/");
    } else {
        memcpy(folder, path, length);
        folder[length] = '\0';
    }
}

/// Checks that a file can be written at `path`: it has a name and a folder, and no folder or device has this name.
static whirl_status check_place(const char *path) {
    struct stat found;
    char folder[ATOMIC_PATH_SIZE];
    if (path[0] == '\0') return whirl_fail(WHIRL_IO_ERROR, "cannot write a file without a name");
    if (stat(path, &found) == 0 && S_ISDIR(found.st_mode)) return cannot_write(path, "it is a folder");
    if (stat(path, &found) == 0 && !S_ISREG(found.st_mode)) return cannot_write(path, "it is no ordinary file");
    parent_of(path, folder);
    if (stat(folder, &found) != 0)
        return whirl_fail(WHIRL_IO_ERROR, "cannot write %s: folder %s: %s", path, folder, strerror(errno));
    if (!S_ISDIR(found.st_mode)) return whirl_fail(WHIRL_IO_ERROR, "cannot write %s: %s is no folder", path, folder);
    return whirl_ok();
}

whirl_status atomic_file_open(atomic_file *out, const char *path) {
    out->stream = NULL;
    // The temporary name has a suffix.
    if (strlen(path) + 32 > sizeof out->path) return whirl_fail(WHIRL_IO_ERROR, "cannot write: the path is too long");
    const whirl_status place = check_place(path);
    if (place.code != WHIRL_OK) return place;
    strcpy(out->path, path);
    snprintf(out->temporary, sizeof out->temporary, "%s.tmp-%ld", path, (long)getpid());
    // A leftover of an earlier process with this number is removed; O_EXCL keeps from writing through a link.
    unlink(out->temporary);
    // The new file is no more public than the one it replaces.
    struct stat earlier;
    const mode_t mode = stat(path, &earlier) == 0 ? earlier.st_mode & 0666 : 0666;
    const int file = open(out->temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode | 0600);
    if (file < 0) return cannot_write(path, strerror(errno));
    out->stream = fdopen(file, "w+b");
    // A later failure of a write sets errno, which atomic_file_commit reports.
    errno = out->stream ? 0 : errno;
    if (out->stream) return whirl_ok();
    const int reason = errno;
    close(file);
    unlink(out->temporary);
    return cannot_write(path, strerror(reason));
}

/// Makes the new name last through a power failure. Some file systems cannot sync a folder; the file is whole all the
/// same.
static void sync_folder(const char *path) {
    char folder[ATOMIC_PATH_SIZE];
    parent_of(path, folder);
    const int file = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    fsync(file);
    close(file);
}

whirl_status atomic_file_commit(atomic_file *out) {
    int reason = 0;
    if (fflush(out->stream) != 0 || ferror(out->stream) || fsync(fileno(out->stream)) != 0)
        reason = errno ? errno : EIO;
    if (fclose(out->stream) != 0 && !reason) reason = errno;
    out->stream = NULL;
    if (!reason && rename(out->temporary, out->path) != 0) reason = errno;
    if (reason) {
        unlink(out->temporary);
        return cannot_write(out->path, strerror(reason));
    }
    sync_folder(out->path);
    return whirl_ok();
}

void atomic_file_discard(atomic_file *out) {
    if (!out->stream) return;
    fclose(out->stream);
    out->stream = NULL;
    unlink(out->temporary);
}

bool atomic_file_there(const char *path) {
    struct stat there;
    return lstat(path, &there) == 0;
}

whirl_status atomic_folder(const char *path) {
    char folder[ATOMIC_PATH_SIZE];
    struct stat found;
    if (strlen(path) >= sizeof folder) return whirl_fail(WHIRL_IO_ERROR, "cannot make a folder: the path is too long");
    strcpy(folder, path);
    for (char *end = folder; *end; ++end) {
        const char here = end[1];
        if (here != '/' && here != '\0') continue;
        end[1] = '\0';
        if (mkdir(folder, 0777) != 0 && errno != EEXIST)
            return whirl_fail(WHIRL_IO_ERROR, "cannot make the folder %s: %s", folder, strerror(errno));
        end[1] = here;
    }
    if (stat(path, &found) != 0 || !S_ISDIR(found.st_mode))
        return whirl_fail(WHIRL_IO_ERROR, "cannot make the folder %s: there is a file of that name", path);
    return whirl_ok();
}
