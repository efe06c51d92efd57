#include "records.h"

#include <stdio.h>
#include <string.h>

#include "command.h"
#include "files.h"
#include "whirl/engine/report.h"
#include "whirl/handles.h"

/// Writes one file, STEM with `ending`. Returns the exit status.
static int write_record_file(const whirl_result *result, const char *stem, const char *what, const char *ending,
                             bool force) {
    char path[4096], *text = NULL;
    snprintf(path, sizeof path, "%s%s", stem, ending);
    const char *slash = strrchr(stem, '/');
    const whirl_status status = whirl_result_dataset(result, what, slash ? slash + 1 : stem, &text);
    const int written = status.code == WHIRL_OK ? write_whole(path, force, text) : complain_of(&status);
    whirl_text_free(text);
    return written;
}

int write_record_files(const whirl_result *result, const char *output, bool force) {
    char stem[4096 - 16];
    if (!whirl_result_records(result)) return EXIT_DONE;
    if (snprintf(stem, sizeof stem, "%s", output) >= (int)sizeof stem) {
        complain("the name of the result has %zu bytes, expected a shorter one", strlen(output));
        return EXIT_FAILED;
    }
    char *ending = strrchr(stem, '.');
    if (ending && strcmp(ending, ".h5") == 0) *ending = '\0';
    const int written = write_record_file(result, stem, "index", "-records.csv", force);
    return written == EXIT_DONE ? write_record_file(result, stem, "datasheet", "-datasheet.md", force) : written;
}
