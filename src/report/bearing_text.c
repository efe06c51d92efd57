// A bearing as a text, for programs in other languages.
#include <stdlib.h>

#include "whirl/bearing_table.h"
#include "whirl/case.h"
#include "whirl/figure.h"
#include "whirl/handles.h"

/// Writes the table, or a figure of it where `figure` is its name.
static whirl_status write_all(const whirl_bearing_table *table, const char *figure, FILE *stream) {
    whirl_figure *made;
    if (!figure) return whirl_bearing_write_json(table, stream);
    whirl_status status = whirl_bearing_figure(table, figure, &made);
    if (status.code == WHIRL_OK) status = whirl_figure_write_json(made, stream);
    whirl_figure_free(made);
    return status;
}

static whirl_status compute(const whirl_bearing *bearing, const char *figure, int threads, char **json) {
    const whirl_bearing_options options = {.threads = threads};
    whirl_bearing_table *table;
    size_t size;
    whirl_status status = whirl_bearing_solve(bearing, &options, &table);
    if (status.code != WHIRL_OK) return status;
    FILE *stream = open_memstream(json, &size);
    status = stream ? write_all(table, figure, stream) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a bearing");
    if (stream && fclose(stream) != 0 && status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a bearing");
    whirl_bearing_table_free(table);
    if (status.code == WHIRL_OK) return status;
    free(*json);
    *json = NULL;
    return status;
}

whirl_status whirl_bearing_json(const char *text, size_t length, const char *name, const char *figure, int threads,
                                char *problems, size_t size, char **json) {
    whirl_problems found = {0};
    whirl_bearing *bearing;
    *json = NULL;
    whirl_status status = whirl_bearing_parse(text, length, name, &found, &bearing);
    whirl_problems_text(&found, problems, size);
    whirl_problems_free(&found);
    if (status.code == WHIRL_OK) status = compute(bearing, figure, threads, json);
    whirl_bearing_free(bearing);
    return status;
}
