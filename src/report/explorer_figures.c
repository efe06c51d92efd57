#include "report_parts.h"

#include <stdlib.h>

#include "shown_kinds.h"
#include "whirl/engine/figure.h"

static bool has_no_view(const whirl_result *result) {
    const whirl_kind *kind = result->table_count > 0 ? whirl_analysis_kind(result->tables[0].analyses) : NULL;
    const shown_kind *shown = kind && !kind->moves && !kind->found ? shown_kind_of(&result->tables[0]) : NULL;
    return shown && shown != &shown_modes && shown != &shown_unbalance;
}

/// JSON within a script: nothing in it ends the script.
static void put_safely(FILE *stream, const char *json) {
    for (; *json; json++)
        if (*json == '<')
            fputs("\\u003c", stream);
        else if (*json != '\n')
            fputc(*json, stream);
}

static bool put_figure(FILE *stream, const whirl_result *result, const char *name, const char *units) {
    const whirl_figure_options options = {.units = units};
    whirl_figure *figure = NULL;
    char *json = NULL;
    size_t size;
    FILE *text = open_memstream(&json, &size);
    bool well = text && whirl_figure_new(result, name, &options, &figure).code == WHIRL_OK &&
                whirl_figure_write_json(figure, text).code == WHIRL_OK;
    if (text && fclose(text) != 0) well = false;
    if (well) put_safely(stream, json);
    whirl_figure_free(figure);
    free(json);
    return well;
}

bool explorer_write_figures(FILE *stream, const whirl_result *result, const char *units) {
    whirl_figure_name *names;
    size_t count;
    if (!has_no_view(result)) return true;
    bool well = whirl_figure_names(result, units, &names, &count).code == WHIRL_OK;
    fputs(",\"figures\":[", stream);
    for (size_t i = 0; i < count && well; i++) {
        if (i > 0) fputc(',', stream);
        well = put_figure(stream, result, names[i].name, units);
    }
    fputc(']', stream);
    free(names);
    return well;
}
