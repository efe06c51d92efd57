#include "files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "output.h"
#include "whirl/internal/arrays.h"
#include "whirl/internal/input.h"

enum { HEAD_SIZE = 4096 };

/// Returns true if a file begins like those that ROSS's Rotor.save writes, TOML or JSON.
static bool is_rotor_of_ross(const char *head) {
    return strstr(head, "ross_version") || strstr(head, "\"ShaftElement");
}

const char standard_input[] = "standard input";

bool is_standard_input(const char *path) {
    return strcmp(path, "-") == 0;
}

enum {
    LONGEST_CASE = (1 << 20) + 4
}; // one byte more than the largest case with a byte order mark, so that longer ones are refused

whirl_status read_case(const char *path, whirl_problems *problems, whirl_case **object) {
    if (!is_standard_input(path)) return whirl_case_load(path, problems, object);
    char *const text = malloc(LONGEST_CASE);
    if (!text) return whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    const size_t length = fread(text, 1, LONGEST_CASE, stdin);
    const whirl_status status = ferror(stdin) ? whirl_fail(WHIRL_BAD_INPUT, "%s cannot be read", standard_input)
                                              : whirl_case_parse(text, length, standard_input, problems, object);
    free(text);
    return status;
}

bool is_other_than_case(const char *path) {
    static const char signature[] = "\211HDF\r\n\032\n"; // HDF5 file format specification, III.A
    char head[HEAD_SIZE];
    if (is_standard_input(path)) return false;
    const size_t length = whirl_input_head(path, head, sizeof head);
    if (length >= sizeof signature - 1 && memcmp(head, signature, sizeof signature - 1) == 0)
        complain(
            "'%s' is a result, expected a case: 'whirl show %s' says what was found, 'whirl report %s -o DIR' draws it",
            path, path, path);
    else if (length > 0 && is_rotor_of_ross(head))
        complain("'%s' is a rotor of ROSS, expected a case: 'whirl import %s -o CASE.yaml' makes one", path, path);
    else
        return false;
    return true;
}

/// Returns true if a file has the key `whirl:`, with which every case begins, at the start of a line.
static bool is_case(const char *path) {
    char head[HEAD_SIZE];
    if (whirl_input_head(path, head, sizeof head) == 0) return false;
    return strncmp(head, "whirl:", 6) == 0 || strncmp(head, "\xEF\xBB\xBFwhirl:", 9) == 0 || strstr(head, "\nwhirl:");
}

static int load(const char *path, whirl_status (*read)(const char *, whirl_result **), whirl_result **result) {
    *result = NULL;
    if (is_case(path)) {
        complain("'%s' is a case, expected a result: 'whirl run %s' computes it", path, path);
        return EXIT_BAD_INPUT;
    }
    const whirl_status status = read(path, result);
    complain_of(&status);
    return status.code == WHIRL_OK ? EXIT_DONE : status.code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
}

/// Returns true for a table of numbers: its name ends with .csv, or it is an HDF5 file of another program.
static bool is_record(const char *path) {
    const size_t length = strlen(path);
    return (length > 4 && strcmp(path + length - 4, ".csv") == 0) || arrays_is_foreign(path);
}

int load_result(const char *path, whirl_result **result) {
    return load(path, is_record(path) ? whirl_result_read_record : whirl_result_read, result);
}

int load_result_columns(const char *path, const chosen_columns *columns, whirl_result **result, bool *chosen) {
    const bool text = !arrays_is_file(path) && !is_case(path);
    if (columns->count == 0 || !(is_record(path) || text)) return load_result(path, result);
    *chosen = true;
    const whirl_status status =
        whirl_result_read_record_columns(path, columns->headings, columns->names, columns->count, result);
    complain_of(&status);
    return status.code == WHIRL_OK ? EXIT_DONE : status.code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
}

int with_result(const char *path, result_action *act, const void *arguments) {
    whirl_result *result;
    keep_private(path);
    int outcome = load_result(path, &result);
    if (outcome != EXIT_DONE) return outcome;
    outcome = act(result, arguments);
    whirl_result_free(result);
    const int written = finish_output();
    return outcome == EXIT_DONE ? written : outcome;
}

int load_outline(const char *path, whirl_result **outline) {
    return load(path, whirl_result_read_outline, outline);
}

/// Writes a text to `temporary`, a file next to `path`. Returns 0 or an errno.
static int write_temporary(const char *path, const char *temporary, const char *text) {
    struct stat earlier;
    // The new file is not more public than the one that it replaces.
    const mode_t mode = stat(path, &earlier) == 0 ? earlier.st_mode & 0666 : 0666;
    unlink(temporary); // an earlier process with the same number may have left it
    const int descriptor = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode | 0600);
    FILE *const file = descriptor < 0 ? NULL : fdopen(descriptor, "w");
    if (!file) {
        const int reason = errno;
        if (descriptor >= 0) close(descriptor);
        return reason;
    }
    int reason = fputs(text, file) == EOF || fflush(file) != 0 || fsync(descriptor) != 0 ? errno : 0;
    if (fclose(file) != 0 && !reason) reason = errno;
    return reason;
}

/// Renames the temporary file to `path`, replacing an existing one with `force`. Returns 0 or an errno.
static int give_name(const char *temporary, const char *path, bool force) {
    if (force) return rename(temporary, path) == 0 ? 0 : errno;
    if (link(temporary, path) == 0) {
        unlink(temporary);
        return 0;
    }
    // Some file systems have no hard links.
    if (errno == EEXIST || access(path, F_OK) == 0) return EEXIST;
    return rename(temporary, path) == 0 ? 0 : errno;
}

bool may_write_file(const char *path, const char *input, const char *what, bool force) {
    struct stat there, source;
    if (stat(path, &there) != 0) return true;
    if (stat(input, &source) == 0 && there.st_dev == source.st_dev && there.st_ino == source.st_ino) {
        complain("'%s' is %s", path, what);
        return false;
    }
    if (!force) complain("'%s' is there already and is kept: add --force to replace it", path);
    return force;
}

int write_whole(const char *path, bool force, const char *text) {
    char temporary[4096];
    struct stat found;
    if (snprintf(temporary, sizeof temporary, "%s.tmp-%ld", path, (long)getpid()) >= (int)sizeof temporary) {
        complain("the name of the file has %zu bytes, expected a shorter one", strlen(path));
        return EXIT_FAILED;
    }
    // Refuse what must not be replaced.
    const bool there = stat(path, &found) == 0;
    int reason = there && !force ? EEXIST : there && S_ISDIR(found.st_mode) ? EISDIR : 0;
    if (there && !reason && !S_ISREG(found.st_mode)) {
        complain("'%s' is no ordinary file, expected the name of one", path);
        return EXIT_FAILED;
    }
    // Write a temporary file next to it, then rename that.
    if (!reason) {
        reason = write_temporary(path, temporary, text);
        if (!reason) reason = give_name(temporary, path, force);
        if (reason) unlink(temporary);
    }
    // Explain what went wrong.
    if (!reason) return EXIT_DONE;
    if (reason == EEXIST)
        complain("'%s' is there already and is kept: add --force to replace it", path);
    else
        complain("'%s' cannot be written: %s", path, strerror(reason));
    return EXIT_FAILED;
}
