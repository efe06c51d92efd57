// What is found where a claim looks, in words and numbers.
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "claim_parts.h"
#include "quantities.h"

enum { MOST_LINES = 6 };

static void append(char *text, size_t size, const char *format, ...) {
    const size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

static bool speaks_of_spectrum(const whirl_claim *claim) {
    return claim->line_count > 0 || claim->has_band;
}

/// The largest lines, those that count in a comparison: at least a twentieth of the largest.
static void append_lines(const numbers *lines, char *text, size_t size) {
    double most = 0.0;
    int shown = 0;
    for (size_t i = 0; i < lines->rows; i++) most = fmax(most, fmax(lines->at[5 * i + 1], lines->at[5 * i + 2]));
    append(text, size, "; lines");
    for (size_t i = 0; i < lines->rows && shown < MOST_LINES; i++) {
        const double *line = &lines->at[5 * i];
        if (fmax(line[1], line[2]) < 0.05 * most) continue;
        append(text, size, "%s %.3g", shown ? "," : "", line[0]);
        shown++;
    }
    append(text, size, shown ? " X" : ": none");
}

void claim_point_text(const claim_view *view, size_t point, char *text, size_t size) {
    const whirl_verdict verdict = whirl_table_verdict(view->table, point);
    whirl_verdict_name(&verdict, text, size);
    const numbers lines = point_lines(view->table, point, view->station);
    if (lines.at && (speaks_of_spectrum(view->claim) || !view->claim->has_contact)) append_lines(&lines, text, size);
    if (view->claim->has_band && lines.at)
        append(text, size, " (%.0f %% of the power below 1 X in the band)", 100.0 * claim_band_share(view, point));
    const double share = rub_share(view->table, point, view->result->contact_count);
    if (share > 0.0)
        append(text, size, "; rub %.2g %% of the time", 100.0 * share);
    else if (share == 0.0)
        append(text, size, "; no rub");
    const double backward = backward_share(view->table, point, view->station);
    if (view->claim->has_whirl && !isnan(backward))
        append(text, size, "; whirl backward %.2g %% of the time", 100.0 * backward);
}

void claim_census_add(claim_census *census, const claim_view *view, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(view->table, point);
    const double value = view->table->values[point];
    census->points++;
    census->in_class[regime_class_of(&verdict)]++;
    const double share = rub_share(view->table, point, view->result->contact_count);
    census->rub_known += !isnan(share);
    if (share > 0.0) {
        census->rub_low = census->rubbing ? fmin(census->rub_low, value) : value;
        census->rub_high = census->rubbing ? fmax(census->rub_high, value) : value;
        census->rubbing++;
    }
    const double backward = backward_share(view->table, point, view->station);
    if (isnan(backward)) return;
    census->backward_low = census->backward_known ? fmin(census->backward_low, backward) : backward;
    census->backward_high = census->backward_known ? fmax(census->backward_high, backward) : backward;
    census->backward_known++;
}

static void append_regimes(const claim_census *census, char *text, size_t size) {
    bool first = true;
    for (int kind = 0; kind < CLASS_COUNT; kind++) {
        if (census->in_class[kind] == 0) continue;
        append(text, size, "%s%s %.3g %%", first ? "" : ", ", regime_class_name((regime_class)kind),
               100.0 * (double)census->in_class[kind] / (double)census->points);
        first = false;
    }
    append(text, size, " of %zu points", census->points);
}

void claim_census_text(const claim_census *census, const whirl_claim *claim, char *text, size_t size) {
    text[0] = '\0';
    if (claim->has_regime || (!claim->has_contact && !claim->has_whirl)) append_regimes(census, text, size);
    if (claim->has_contact || claim->has_whirl) {
        const char *comma = *text ? "; " : "";
        if (census->rub_known == 0)
            append(text, size, "%scontact not computed", comma);
        else if (census->rubbing == 0)
            append(text, size, "%sno rub", comma);
        else
            append(text, size, "%srub at %.3g %% of the points (between %.4g and %.4g)", comma,
                   100.0 * (double)census->rubbing / (double)census->points, census->rub_low, census->rub_high);
    }
    if (!claim->has_whirl) return;
    const size_t diverged = census->in_class[CLASS_DIVERGED];
    if (diverged == 0)
        append(text, size, "; bounded everywhere");
    else
        append(text, size, "; diverged at %zu of %zu points", diverged, census->points);
    if (census->backward_known > 0)
        append(text, size, "; whirl backward %.2g to %.2g %% of the time", 100.0 * census->backward_low,
               100.0 * census->backward_high);
}
