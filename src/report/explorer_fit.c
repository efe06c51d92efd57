#include "explorer_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/fit.h"
#include "whirl/engine/study.h"
#include "whirl/internal/fit_columns.h"

/// margin: margin of the live diagram on both sides of the measured speeds, as a share of their range. single_margin:
/// margin if only one speed was measured, as a share of that speed.
static const double margin = 0.04, single_margin = 0.4;

/// A fit in a result, at its best point.
typedef struct stored_fit {
    const whirl_result *result;
    const whirl_case *machine;
    const whirl_table *table;
    size_t unknowns, numbers, motions;
    const double *unknown, *number, *motion;
} stored_fit;

/// Loads the best point of a table. Returns false for tables that are no fits, and without such a point.
static bool fit_load(const whirl_result *result, const whirl_case *machine, const whirl_table *table, stored_fit *out) {
    const whirl_layout *layout = &table->layout;
    const whirl_field *unknown = whirl_layout_field(layout, WHIRL_FIELD_FIT_UNKNOWN);
    const whirl_field *number = whirl_layout_field(layout, WHIRL_FIELD_FIT_NUMBER);
    const whirl_field *motion = whirl_layout_field(layout, WHIRL_FIELD_FIT_MOTION);
    const size_t point = unknown && number && motion ? fit_best(table) : table->count;
    if (point == table->count) return false;
    *out = (stored_fit){.result = result,
                        .machine = machine,
                        .table = table,
                        .unknowns = unknown->rows,
                        .numbers = number->rows,
                        .motions = motion->rows,
                        .unknown = whirl_table_field(table, point, WHIRL_FIELD_FIT_UNKNOWN, 0),
                        .number = whirl_table_field(table, point, WHIRL_FIELD_FIT_NUMBER, 0),
                        .motion = whirl_table_field(table, point, WHIRL_FIELD_FIT_MOTION, 0)};
    return out->unknown && out->number && out->motion;
}

// ---------------------------------------------------------------- the live case

/// Receives uses of parameters, and keeps the one that is the speed of the rotor.
static void fit_see_use(void *context, const whirl_use *use) {
    const char **speed = context;
    if (use->alone && strcmp(use->path, "rotor.speed") == 0) *speed = use->parameter;
}

/// Sets a key of a case's text: frees the old text and puts the new one in its place. Returns false, with the text
/// unchanged, after a failure.
static bool fit_edit(char **text, const char *path, const char *value) {
    char *edited = NULL;
    if (whirl_case_edit(*text, strlen(*text), path, value, &edited).code != WHIRL_OK) return false;
    free(*text);
    *text = edited;
    return true;
}

/// Writes the fitted values into a text, each in the unit in which the case has the parameter.
static bool fit_set_values(const stored_fit *fit, char **text) {
    bool well = true;
    for (size_t u = 0; u < fit->unknowns && well; u++) {
        const double *row = fit->unknown + (size_t)FIT_UNKNOWN_COLUMNS * u;
        if (!(row[FIT_PARAMETER] >= 0.0 && row[FIT_PARAMETER] < (double)fit->result->parameter_count)) return false;
        const whirl_parameter *own = &fit->result->parameters[(size_t)row[FIT_PARAMETER]];
        char path[WHIRL_NAME_SIZE + 16], one[128], number[160], *end;
        double size = 1.0;
        // The unit follows the number; an expression has none, and its value is in SI.
        strtod(own->text, &end);
        const char *unit = own->text[0] == '=' ? "" : end + strspn(end, " ");
        snprintf(one, sizeof one, "1 %.100s", unit);
        if (!*unit || whirl_quantity_value(one, own->unit, &size).code != WHIRL_OK || !(size > 0.0)) {
            size = 1.0;
            unit = strcmp(own->unit, "1") == 0 ? "" : own->unit;
        }
        snprintf(path, sizeof path, "parameters.%s", own->name);
        snprintf(number, sizeof number, "%.10g%s%.100s", row[FIT_VALUE] / size, *unit ? " " : "", unit);
        well = fit_edit(text, path, number);
    }
    return well;
}

/// Returns true if a text is a case with motions over a parameter, or with one motion.
static bool fit_moves(const char *text) {
    whirl_case *object;
    whirl_study study;
    if (whirl_case_parse(text, strlen(text), "live.yaml", NULL, &object).code != WHIRL_OK) return false;
    whirl_case_study(object, &study);
    const bool moves = study.batch_count > 0 && whirl_analysis_kind(study.batches[0].analyses)->moves;
    whirl_case_free(object);
    return moves;
}

/// Writes the range of the measured speeds, rad/s, with a margin.
static void fit_range(const stored_fit *fit, double range[2]) {
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (size_t i = 0; i < fit->motions; i++) {
        range[0] = fmin(range[0], fit->motion[FIT_MOTION_COLUMNS * i + FIT_SPEED]);
        range[1] = fmax(range[1], fit->motion[FIT_MOTION_COLUMNS * i + FIT_SPEED]);
    }
    const double size = range[1] - range[0];
    const double more = size > 0.0 ? fmin(margin * size, 0.5 * range[0]) : single_margin * range[0];
    range[0] -= more;
    range[1] += more;
}

/// Removes a key of the study from a case's text: frees the old text and puts the new one in its place. Returns false,
/// with the text unchanged, if the key cannot be removed.
static bool fit_remove(char **text, const char *key) {
    char path[WHIRL_NAME_SIZE + 8], *edited = NULL;
    snprintf(path, sizeof path, "study.%s", key);
    if (whirl_case_remove(*text, strlen(*text), path, &edited).code != WHIRL_OK) return false;
    free(*text);
    *text = edited;
    return true;
}

/// Removes all keys of the study but its initial state and its units.
static bool fit_clear_study(char **text) {
    const whirl_group *const *groups = whirl_case_groups();
    while (*groups && strcmp((*groups)->name, "study") != 0) groups++;
    const whirl_key *key;
    for (size_t i = 0; *groups && (key = whirl_group_at(*groups, i)) != NULL; i++)
        if (strcmp(key->name, "initial") != 0 && strcmp(key->name, "units") != 0 && !fit_remove(text, key->name))
            return false;
    return *groups != NULL;
}

/// Sets a key of a case's text to a number with a unit; unit "": a plain number. Returns false after a failure.
static bool fit_set_number(char **text, const char *path, double number, const char *unit) {
    char value[2 * WHIRL_NAME_SIZE];
    snprintf(value, sizeof value, "%.8g%s%.60s", number, *unit ? " " : "", unit);
    return fit_edit(text, path, value);
}

/// Replaces the study of a text, whatever its YAML style, by motions of the fit: a sweep over the measured speeds
/// (`swept`), or one motion if no parameter is the speed. The motions have the transient, the method and the initial
/// state of the fit. Returns false after a failure.
static bool fit_make_study(const stored_fit *fit, bool swept, char **text) {
    const char *speed = NULL, *unit = "";
    const whirl_fit_options *options = &fit->table->record.fit;
    const bool contacts = fit->result->contact_count > 0;
    double range[2];
    if (swept) whirl_case_uses(fit->machine, fit_see_use, (void *)&speed);
    for (size_t i = 0; speed && i < fit->result->parameter_count; i++)
        if (strcmp(fit->result->parameters[i].name, speed) == 0) unit = fit->result->parameters[i].unit;
    if (strcmp(unit, "1") == 0) unit = "";
    fit_range(fit, range);
    // Keys are added in reverse order, since each new key is written before the existing keys of its mapping.
    bool well = fit_clear_study(text);
    well = well && fit_edit(text, "study.analyze",
                            contacts ? "[poincare, regime, lyapunov, spectrum, orbit, rub]"
                                     : "[poincare, regime, lyapunov, spectrum, orbit]");
    well = well && fit_edit(text, "study.integrate.record", "40");
    well = well && fit_set_number(text, "study.integrate.transient", options->transient, "");
    well = well && fit_edit(text, "study.integrate.method", options->method);
    if (!speed) return well && fit_edit(text, "study.response", "~");
    well = well && fit_edit(text, "study.sweep.start", "state");
    well = well && fit_edit(text, "study.sweep.points", "64");
    well = well && fit_set_number(text, "study.sweep.to", range[1], unit);
    well = well && fit_set_number(text, "study.sweep.from", range[0], unit);
    return well && fit_edit(text, "study.sweep.parameter", speed);
}

/// Returns the text of the case with the fitted values, and with motions over the measured speeds in place of its
/// study. NULL if there is no such case. The caller frees it.
static char *fit_live_text(const stored_fit *fit) {
    if (!fit->machine || !fit->result->case_text || !*fit->result->case_text) return NULL;
    // Try a sweep over the speeds first; if the machine cannot be made over their whole range, take one motion.
    for (int swept = 1; swept >= 0; swept--) {
        char *text = strdup(fit->result->case_text);
        if (text && fit_set_values(fit, &text) && fit_make_study(fit, swept != 0, &text) && fit_moves(text))
            return text;
        free(text);
    }
    return NULL;
}

bool explorer_fit_is_live(const whirl_result *result, const whirl_case *machine, const whirl_table *table) {
    stored_fit fit;
    char *text = fit_load(result, machine, table, &fit) ? fit_live_text(&fit) : NULL;
    free(text);
    return text != NULL;
}

// ---------------------------------------------------------------- writing

static void fit_write_unknowns(FILE *stream, const stored_fit *fit) {
    script_key(stream, ',', "unknowns");
    fputc('[', stream);
    for (size_t u = 0; u < fit->unknowns; u++) {
        const double *row = fit->unknown + (size_t)FIT_UNKNOWN_COLUMNS * u;
        const bool named = row[FIT_PARAMETER] >= 0.0 && row[FIT_PARAMETER] < (double)fit->result->parameter_count;
        if (u > 0) fputc(',', stream);
        script_text_member(stream, '{', "name", named ? fit->result->parameters[(size_t)row[FIT_PARAMETER]].name : "");
        script_number_member(stream, ',', "value", row[FIT_VALUE]);
        script_number_member(stream, ',', "error", row[FIT_ERROR]);
        script_number_member(stream, ',', "half", row[FIT_HALF]);
        script_text_member(stream, ',', "determined", fit_determined(row));
        fputc('}', stream);
    }
    fputc(']', stream);
}

/// Writes the numbers of a file [count] in the form of MeasuredTable of the page (protocol.ts).
static void fit_write_file(FILE *stream, const stored_fit *fit, const double *numbers, size_t count) {
    const size_t first = (size_t)numbers[FIT_MOTION];
    const size_t last = (size_t)numbers[FIT_NUMBER_COLUMNS * (count - 1) + FIT_MOTION];
    char name[32];
    snprintf(name, sizeof name, "file %.0f", numbers[FIT_SET] + 1.0);
    script_text_member(stream, '{', "name", name);
    script_key(stream, ',', "table");
    script_text_member(stream, '{', "title", "");
    script_text_member(stream, ',', "parameter", "");
    script_key(stream, ',', "motions");
    for (size_t i = first; i <= last; i++) {
        fputc(i > first ? ',' : '[', stream);
        script_number(stream, fit->motion[FIT_MOTION_COLUMNS * i + FIT_SPEED]);
    }
    fputc(']', stream);
    script_key(stream, ',', "numbers");
    for (size_t i = 0; i < count; i++) {
        const double *row = numbers + (size_t)FIT_NUMBER_COLUMNS * i;
        fprintf(stream, "%s[%.0f,%.0f,", i > 0 ? "," : "[", row[FIT_MOTION] - (double)first, row[FIT_STATION]);
        script_number(stream, row[FIT_ANGLE]);
        fprintf(stream, ",%.0f,", row[FIT_QUANTITY]);
        script_number(stream, row[FIT_AT]);
        fputc(',', stream);
        script_number(stream, row[FIT_MEASURED]);
        fputc(']', stream);
    }
    fputs("]}}", stream);
}

/// Writes the files whose numbers lie over a motion at one speed: no statistics, no run-ups, and no onsets, critical
/// speeds and modes.
static void fit_write_files(FILE *stream, const stored_fit *fit) {
    bool first = true;
    script_key(stream, ',', "measured");
    fputc('[', stream);
    for (size_t i = 0, count; i < fit->numbers; i += count) {
        const double *numbers = fit->number + (size_t)FIT_NUMBER_COLUMNS * i;
        const whirl_fit_quantity what = (whirl_fit_quantity)numbers[FIT_QUANTITY];
        for (count = 1; i + count < fit->numbers && numbers[FIT_NUMBER_COLUMNS * count + FIT_SET] == numbers[FIT_SET];)
            count++;
        const double *motion = fit->motion + FIT_MOTION_COLUMNS * (size_t)numbers[FIT_MOTION];
        if (whirl_fit_is_statistic(what) || !whirl_fit_is_motion(what) || isfinite(motion[FIT_TIME])) continue;
        if (!first) fputc(',', stream);
        first = false;
        fit_write_file(stream, fit, numbers, count);
    }
    fputc(']', stream);
}

void explorer_write_fits(FILE *stream, const whirl_result *result, const whirl_case *machine) {
    bool first = true;
    script_key(stream, ',', "fits");
    fputc('[', stream);
    for (const whirl_table *table = result->tables; table < result->tables + result->table_count; table++) {
        stored_fit fit;
        char *text = fit_load(result, machine, table, &fit) ? fit_live_text(&fit) : NULL;
        if (!text) continue;
        if (!first) fputc(',', stream);
        first = false;
        script_text_member(stream, '{', "table", table->name);
        script_text_member(stream, ',', "case_text", text);
        fit_write_unknowns(stream, &fit);
        fit_write_files(stream, &fit);
        fputc('}', stream);
        free(text);
    }
    fputc(']', stream);
}
