#include "records.h"

#include <stdio.h>
#include <string.h>

#include "command.h"
#include "files.h"
#include "output.h"
#include "whirl/engine/report.h"
#include "whirl/handles.h"

static const struct {
    const char *what, *ending;
} record_files[] = {{"index", "-records.csv"}, {"datasheet", "-datasheet.md"}};

enum { RECORD_FILES = sizeof record_files / sizeof *record_files, ENDING_SIZE = 16 };

/// Writes the path of an output without ".h5". Returns false after reporting that it is too long.
static bool records_stem(const char *output, char *stem, size_t size) {
    if (snprintf(stem, size, "%s", output) >= (int)size) {
        complain("the name of the result has %zu bytes, expected a shorter one", strlen(output));
        return false;
    }
    char *ending = strrchr(stem, '.');
    if (ending && strcmp(ending, ".h5") == 0) *ending = '\0';
    return true;
}

bool record_files_are_free(const whirl_result *outline, const char *output) {
    char stem[4096 - ENDING_SIZE], path[4096];
    if (!whirl_result_records(outline)) return true;
    if (!records_stem(output, stem, sizeof stem)) return false;
    for (size_t i = 0; i < RECORD_FILES; i++) {
        snprintf(path, sizeof path, "%s%s", stem, record_files[i].ending);
        if (!output_is_free(path)) return false;
    }
    return true;
}

int write_record_files(const whirl_result *result, const char *output) {
    char stem[4096 - ENDING_SIZE], path[4096];
    if (!whirl_result_records(result)) return EXIT_DONE;
    if (!records_stem(output, stem, sizeof stem)) return EXIT_FAILED;
    const char *slash = strrchr(stem, '/');
    int written = EXIT_DONE;
    for (size_t i = 0; i < RECORD_FILES && written == EXIT_DONE; i++) {
        char *text = NULL;
        snprintf(path, sizeof path, "%s%s", stem, record_files[i].ending);
        const whirl_status status = whirl_result_dataset(result, record_files[i].what, slash ? slash + 1 : stem, &text);
        written = status.code == WHIRL_OK ? write_whole(path, true, text) : complain_of(&status);
        whirl_text_free(text);
    }
    return written;
}
