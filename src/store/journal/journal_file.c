#define _GNU_SOURCE // fallocate; NOLINT(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
#include "journal_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bytes.h"

// ---------------------------------------------------------------- opening

whirl_status journal_file_failed(const journal_file *file, const char *what, int reason) {
    return whirl_fail(WHIRL_IO_ERROR, "cannot %s %.250s: %s", what, file->path, strerror(reason));
}

/// Returns true if the open file still has its name: another run may have finished and removed it before the lock was
/// free.
static bool has_its_name(const journal_file *file) {
    struct stat open_one, named;
    return fstat(file->descriptor, &open_one) == 0 && stat(file->path, &named) == 0 &&
           open_one.st_dev == named.st_dev && open_one.st_ino == named.st_ino;
}

static whirl_status lock(const journal_file *file) {
    int failed;
    do failed = flock(file->descriptor, LOCK_EX | LOCK_NB);
    while (failed && errno == EINTR);
    if (failed && errno == EWOULDBLOCK) return whirl_fail(WHIRL_BAD_INPUT, "another run is writing %.250s", file->path);
    // On a file system without locks, this run is assumed to be the only one.
    return has_its_name(file) ? whirl_ok()
                              : whirl_fail(WHIRL_BAD_INPUT, "another run has just finished with %.250s", file->path);
}

static whirl_status open_file(journal_file *file, const char *path, int flags, bool locked) {
    struct stat found;
    file->descriptor = -1;
    if (strlen(path) >= sizeof file->path)
        return whirl_fail(WHIRL_IO_ERROR, "cannot keep a journal: the path is too long");
    strcpy(file->path, path);
    // Opening a pipe must not wait.
    do file->descriptor = open(path, O_CLOEXEC | O_NONBLOCK | flags, 0666);
    while (file->descriptor < 0 && errno == EINTR);
    if (file->descriptor < 0 && errno == EEXIST) return whirl_fail(WHIRL_BAD_INPUT, "%.250s is there already", path);
    if (file->descriptor < 0 && errno == ENOENT && !(flags & O_CREAT))
        return whirl_fail(WHIRL_BAD_INPUT, "there is no journal %.250s", path);
    if (file->descriptor < 0) return journal_file_failed(file, "open", errno);
    whirl_status status = whirl_ok();
    if (fstat(file->descriptor, &found) != 0 || !S_ISREG(found.st_mode))
        status = whirl_fail(WHIRL_BAD_INPUT, "%.250s is no ordinary file", path);
    if (status.code == WHIRL_OK && locked) status = lock(file);
    if (status.code != WHIRL_OK) journal_file_close(file);
    return status;
}

whirl_status journal_file_create(journal_file *file, const char *path) {
    return open_file(file, path, O_RDWR | O_CREAT | O_EXCL, true);
}

whirl_status journal_file_open(journal_file *file, const char *path) {
    return open_file(file, path, O_RDWR, true);
}

whirl_status journal_file_peek(journal_file *file, const char *path) {
    return open_file(file, path, O_RDONLY, false);
}

bool journal_file_is_free(const journal_file *file) {
    if (flock(file->descriptor, LOCK_SH | LOCK_NB) != 0) return errno != EWOULDBLOCK;
    flock(file->descriptor, LOCK_UN);
    return true;
}

void journal_file_close(journal_file *file) {
    if (file->descriptor >= 0) close(file->descriptor);
    file->descriptor = -1;
}

// ---------------------------------------------------------------- bytes

int journal_file_size(const journal_file *file, uint64_t *size) {
    struct stat found;
    if (fstat(file->descriptor, &found) != 0) return errno;
    *size = (uint64_t)found.st_size;
    return 0;
}

int journal_file_read(const journal_file *file, uint64_t offset, void *to, size_t size) {
    return bytes_read_at(file->descriptor, offset, to, size);
}

int journal_file_write(const journal_file *file, uint64_t offset, const void *from, size_t size) {
    return bytes_write_at(file->descriptor, offset, from, size);
}

int journal_file_sync(const journal_file *file) {
    int failed;
    do failed = fdatasync(file->descriptor);
    while (failed && errno == EINTR);
    // Some file systems have nothing to sync.
    return !failed || errno == EINVAL || errno == EROFS || errno == ENOSYS ? 0 : errno;
}

int journal_file_cut(const journal_file *file, uint64_t size) {
    int failed;
    do failed = ftruncate(file->descriptor, (off_t)size);
    while (failed && errno == EINTR);
    return failed ? errno : 0;
}

int journal_file_reserve(const journal_file *file, uint64_t size) {
    int failed = 0;
#ifdef FALLOC_FL_KEEP_SIZE
    do failed = fallocate(file->descriptor, FALLOC_FL_KEEP_SIZE, 0, (off_t)size);
    while (failed && errno == EINTR);
#endif
    return failed && (errno == ENOSPC || errno == EDQUOT) ? errno : 0;
}

// ---------------------------------------------------------------- names

void journal_file_sync_name(const journal_file *file) {
    char folder[JOURNAL_PATH_SIZE];
    const char *slash = strrchr(file->path, '/');
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - file->path) + 1 : 1, slash ? file->path : ".");
    const int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

int journal_file_remove(const journal_file *file) {
    if (unlink(file->path) != 0 && errno != ENOENT) return errno;
    journal_file_sync_name(file);
    return 0;
}
