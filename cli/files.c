#include "files.h"

#include <stdio.h>
#include <string.h>

#include "command.h"

enum { HEAD_SIZE = 4096 };

/// The first bytes of a regular file or what else can be read twice; 0 of them where there is none.
static size_t read_head(const char *path, char head[HEAD_SIZE]) {
    FILE *const file = fopen(path, "rb");
    if (!file) return 0;
    // A pipe would lose what is read here.
    const size_t length = fseek(file, 0, SEEK_CUR) == 0 ? fread(head, 1, HEAD_SIZE - 1, file) : 0;
    fclose(file);
    head[length] = '\0';
    return length;
}

bool is_result_for_case(const char *path) {
    static const char signature[] = "\211HDF\r\n\032\n"; // HDF5 file format specification, III.A
    char head[HEAD_SIZE];
    if (read_head(path, head) < sizeof signature - 1 || memcmp(head, signature, sizeof signature - 1) != 0)
        return false;
    complain(
        "'%s' is a result, expected a case: 'whirl show %s' says what was found, 'whirl report %s -o DIR' draws it",
        path, path, path);
    return true;
}

/// The key that every case begins with, at the start of a line.
static bool is_case(const char *path) {
    char head[HEAD_SIZE];
    if (read_head(path, head) == 0) return false;
    return strncmp(head, "whirl:", 6) == 0 || strstr(head, "\nwhirl:");
}

int load_result(const char *path, whirl_result **result) {
    *result = NULL;
    if (is_case(path)) {
        complain("'%s' is a case, expected a result: 'whirl run %s' computes it", path, path);
        return EXIT_BAD_INPUT;
    }
    const whirl_status status = whirl_result_read(path, result);
    complain_of(&status);
    return status.code == WHIRL_OK ? EXIT_DONE : status.code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
}
