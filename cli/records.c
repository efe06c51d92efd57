#include "records.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "files.h"
#include "whirl/engine/dataset.h"
#include "whirl/engine/report.h"

/// Writes one of the two as text in memory, then as a file.
static int write_record_file(const whirl_result *result, const char *stem, bool sheet, bool force) {
    char path[4096], *text = NULL;
    size_t size = 0;
    snprintf(path, sizeof path, "%s%s", stem, sheet ? "-datasheet.md" : "-records.csv");
    const char *slash = strrchr(stem, '/');
    FILE *stream = open_memstream(&text, &size);
    whirl_status status = stream ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for %.200s", path);
    if (stream && sheet) status = whirl_dataset_write_sheet(result, slash ? slash + 1 : stem, stream);
    if (stream && !sheet) whirl_dataset_write_index(result, stream);
    if (stream && fclose(stream) != 0) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %.200s", path);
    const int written = status.code == WHIRL_OK ? write_whole(path, force, text) : complain_of(&status);
    free(text);
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
    const int written = write_record_file(result, stem, false, force);
    return written == EXIT_DONE ? write_record_file(result, stem, true, force) : written;
}
