// Writes the corpus of fuzz_result anew, after a change of the format:  make_results FOLDER
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "synthetic.h"

static int write_one(const whirl_result *result, const char *folder, const char *name) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s.hdf5", folder, name);
    const whirl_status status = whirl_result_write(result, path);
    if (status.code != WHIRL_OK) fprintf(stderr, "%s\n", status.message);
    return status.code != WHIRL_OK;
}

/// Writes branches of orbits, or of tori, in place of both tables.
static int write_traced(const char *folder, const char *name, const char *analysis) {
    whirl_result *result = synthetic_result();
    whirl_table traced = {.count = 0};
    synthetic_traced(&traced, result, analysis);
    const whirl_table sweep = result->tables[0];
    result->tables[0] = traced;
    result->table_count = 1;
    const int failed = write_one(result, folder, name);
    result->table_count = 2;
    traced = result->tables[0];
    result->tables[0] = sweep;
    free(traced.values), free(traced.branch), free(traced.blocks);
    whirl_result_free(result);
    return failed;
}

int main(int count, char **arguments) {
    if (count != 2) {
        fputs("usage: make_results FOLDER\n", stderr);
        return 2;
    }
    char none[] = "";
    const whirl_result empty = {.case_text = none};
    whirl_result *result = synthetic_result();
    int failed = write_one(&empty, arguments[1], "empty") | write_one(result, arguments[1], "both-tables");
    // The table of invented fields alone, in the place of the first: shapes of every kind in a small file.
    const whirl_table first = result->tables[0];
    result->tables[0] = result->tables[1];
    result->table_count = 1;
    failed |= write_one(result, arguments[1], "one-table");
    result->tables[0] = first;
    result->table_count = 2;
    synthetic_map(&result->tables[0], 2, 2, 0);
    failed |= write_one(result, arguments[1], "map");
    failed |= write_traced(arguments[1], "branch", "trace") | write_traced(arguments[1], "tori", "torus");
    whirl_result_free(result);
    result = synthetic_result();
    synthetic_planes(&result->tables[0], 2, 2, 2, 0);
    failed |= write_one(result, arguments[1], "planes");
    whirl_result_free(result);
    return failed;
}
