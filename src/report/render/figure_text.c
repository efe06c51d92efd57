// Writes figures as texts in memory, for programs in other languages.
#include <stdlib.h>

#include "text_written.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/result.h"
#include "whirl/handles.h"
#include "whirl/status.h"

static whirl_status write_figure(const void *of, FILE *stream) {
    return whirl_figure_write_json(of, stream);
}

whirl_status whirl_result_figure(const whirl_result *result, const char *name, const char *units, const char *panels,
                                 const char *log, char **json) {
    return whirl_result_figure_with(result, NULL, name, units, panels, log, json);
}

whirl_status whirl_result_figure_with(const whirl_result *result, const whirl_result *with, const char *name,
                                      const char *units, const char *panels, const char *log, char **json) {
    const whirl_figure_options options = {.units = units, .panels = panels, .log = log, .with = with};
    whirl_figure *figure;
    *json = NULL;
    whirl_status status = whirl_figure_new(result, name, &options, &figure);
    if (status.code != WHIRL_OK) return status;
    status = text_written(write_figure, figure, "for a figure", json);
    whirl_figure_free(figure);
    return status;
}

whirl_status whirl_result_figures(const whirl_result *result, const char *units, char **lines) {
    whirl_figure_name *names;
    size_t count, size;
    *lines = NULL;
    whirl_status status = whirl_figure_names(result, units, &names, &count);
    if (status.code != WHIRL_OK) return status;
    FILE *stream = open_memstream(lines, &size);
    for (size_t i = 0; i < count && stream; i++) fprintf(stream, "%s\t%s\n", names[i].name, names[i].title);
    free(names);
    if (stream && fclose(stream) == 0) return status;
    free(*lines);
    *lines = NULL;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the names of figures");
}

void whirl_text_free(char *text) {
    free(text);
}
