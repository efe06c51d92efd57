// Figures as texts, for programs in other languages.
#include <stdlib.h>

#include "whirl/figure.h"
#include "whirl/handles.h"

whirl_status whirl_result_figure(const whirl_result *result, const char *name, const char *units, const char *panels,
                                 const char *log, char **json) {
    const whirl_figure_options options = {.units = units, .panels = panels, .log = log};
    whirl_figure *figure;
    size_t size;
    *json = NULL;
    whirl_status status = whirl_figure_new(result, name, &options, &figure);
    if (status.code != WHIRL_OK) return status;
    FILE *stream = open_memstream(json, &size);
    status = stream ? whirl_figure_write_json(figure, stream) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a figure");
    if (stream && fclose(stream) != 0 && status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a figure");
    whirl_figure_free(figure);
    if (status.code == WHIRL_OK) return status;
    free(*json);
    *json = NULL;
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
