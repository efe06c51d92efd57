// Computes a bearing for programs in other languages: reads the text of its file, and returns the result as a text
// (JSON).
#include <stdlib.h>

#include "text_written.h"
#include "whirl/engine/case.h"
#include "whirl/engine/figure.h"
#include "whirl/handles.h"
#include "whirl/internal/bearing_table.h"
#include "whirl/status.h"

/// A table of bearing points, and the units in which it is shown.
typedef struct answer {
    const whirl_bearing_table *table;
    const char *units;
} answer;

/// Writes all figures of the table as a JSON list.
static whirl_status write_figures(const void *of, FILE *stream) {
    const answer *const own = of;
    static const char *const names[] = {"curves", "sommerfeld", "locus"};
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < sizeof names / sizeof *names && status.code == WHIRL_OK; i++) {
        whirl_figure *figure;
        status = whirl_bearing_figure(own->table, names[i], own->units, &figure);
        fputs(i ? "," : "[", stream);
        if (status.code == WHIRL_OK) status = whirl_figure_write_json(figure, stream);
        whirl_figure_free(figure);
    }
    fputs("]", stream);
    return status;
}

static whirl_status write_answer(const void *of, FILE *stream) {
    const answer *const own = of;
    return whirl_bearing_write_json(own->table, own->units, stream);
}

static whirl_status compute(const whirl_bearing *bearing, const char *units, int threads, char **json, char **figures) {
    const whirl_bearing_options options = {.threads = threads};
    whirl_bearing_table *table;
    whirl_status status = whirl_bearing_solve(bearing, &options, &table);
    if (status.code != WHIRL_OK) return status;
    const answer shown = {table, units};
    status = text_written(write_answer, &shown, "for a bearing", json);
    if (status.code == WHIRL_OK && figures) status = text_written(write_figures, &shown, "for a bearing", figures);
    whirl_bearing_table_free(table);
    if (status.code == WHIRL_OK) return status;
    free(*json);
    *json = NULL;
    return status;
}

whirl_status whirl_bearing_json(const char *text, size_t length, const char *name, const char *units, int threads,
                                char *problems, size_t size, char **json, char **figures) {
    whirl_problems found = {0};
    whirl_bearing *bearing;
    *json = NULL;
    if (figures) *figures = NULL;
    whirl_status status = whirl_bearing_parse(text, length, name, &found, &bearing);
    whirl_problems_text(&found, problems, size);
    whirl_problems_free(&found);
    if (status.code == WHIRL_OK) status = compute(bearing, units, threads, json, figures);
    whirl_bearing_free(bearing);
    return status;
}
