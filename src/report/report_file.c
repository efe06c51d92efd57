#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "report_file.h"
#include "whirl/status.h"

whirl_status report_file_open(report_file *file, const char *folder, const char *name) {
    const int length = snprintf(file->path, sizeof file->path, "%s/%s", folder, name);
    if (length < 0 || (size_t)length >= sizeof file->path)
        return whirl_fail(WHIRL_IO_ERROR, "the path %.100s.../%.100s is too long", folder, name);
    snprintf(file->temporary, sizeof file->temporary, "%s.part", file->path);
    // Remove an existing file of this name, and follow no symbolic link: another user may have planted one here.
    unlink(file->temporary);
    const int made = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    file->stream = made >= 0 ? fdopen(made, "w") : NULL;
    if (file->stream) return whirl_ok();
    const int reason = errno;
    if (made >= 0) close(made);
    if (made >= 0) unlink(file->temporary);
    return whirl_fail(WHIRL_IO_ERROR, "%.300s cannot be written: %s", file->path, strerror(reason));
}

whirl_status report_file_close(report_file *file) {
    errno = 0;
    const int failed = ferror(file->stream);
    const int unclosed = fclose(file->stream);
    file->stream = NULL;
    if (!failed && !unclosed && rename(file->temporary, file->path) == 0) return whirl_ok();
    const int reason = errno;
    unlink(file->temporary);
    return whirl_fail(WHIRL_IO_ERROR, "%.300s cannot be written: %s", file->path,
                      reason ? strerror(reason) : "writing failed (is the disk full?)");
}

void report_file_drop(report_file *file) {
    fclose(file->stream);
    file->stream = NULL;
    unlink(file->temporary);
}

static whirl_status make_one(const char *path) {
    struct stat found;
    if (mkdir(path, 0777) == 0) return whirl_ok();
    const int reason = errno;
    if (stat(path, &found) == 0) {
        if (S_ISDIR(found.st_mode)) return whirl_ok();
        return whirl_fail(WHIRL_IO_ERROR, "%.300s is a file, expected a folder", path);
    }
    return whirl_fail(WHIRL_IO_ERROR, "the folder %.300s cannot be made: %s", path, strerror(reason));
}

whirl_status folder_make(const char *path) {
    char part[FILE_PATH_SIZE];
    const size_t length = strlen(path);
    if (length == 0 || length >= sizeof part)
        return whirl_fail(WHIRL_IO_ERROR, "the folder's path is %s", length ? "too long" : "empty");
    memcpy(part, path, length + 1);
    for (size_t i = 1; i < length; i++) {
        if (part[i] != '/') continue;
        part[i] = '\0';
        const whirl_status status = make_one(part);
        if (status.code != WHIRL_OK) return status;
        part[i] = '/';
    }
    return make_one(part);
}

bool report_file_there(const char *path) {
    struct stat there;
    return lstat(path, &there) == 0;
}

bool folder_holds_files(const char *path) {
    DIR *folder = opendir(path);
    bool holds = false;
    for (const struct dirent *one; folder && !holds && (one = readdir(folder));)
        holds = strcmp(one->d_name, ".") != 0 && strcmp(one->d_name, "..") != 0;
    if (folder) closedir(folder);
    return holds;
}

whirl_status folder_make_own(const char *path) {
    struct stat found;
    const whirl_status status = folder_make(path);
    if (status.code != WHIRL_OK) return status;
    if (lstat(path, &found) == 0 && S_ISDIR(found.st_mode)) return status;
    return whirl_fail(WHIRL_IO_ERROR, "%.300s is a link, expected a folder of the report's own", path);
}

whirl_status folder_make_temporary(const char *in, char *path) {
    snprintf(path, FILE_PATH_SIZE, "%.4000s/.whirl-figure-XXXXXX", in);
    if (mkdtemp(path)) return whirl_ok();
    return whirl_fail(WHIRL_IO_ERROR, "no folder can be made in %.200s: %.100s", in, strerror(errno));
}

void folder_remove(const char *path, const char *const *names) {
    char file[FILE_PATH_SIZE + 64];
    for (; *names; names++) {
        snprintf(file, sizeof file, "%.4000s/%.40s", path, *names);
        unlink(file);
    }
    rmdir(path);
}

void safe_name(const char *text, char *name, size_t size) {
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._+-";
    size_t length = 0;
    if (size == 0) return;
    for (; *text && length + 1 < size; text++) {
        const char letter = strchr(allowed, *text) ? *text : '-';
        const int begins_badly = length == 0 && (letter == '.' || letter == '-');
        if (!begins_badly) name[length++] = letter;
    }
    name[length] = '\0';
    if (length == 0) snprintf(name, size, "unnamed");
}
