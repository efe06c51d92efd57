// Gives words and units to summaries.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "summary.h"
#include "whirl/engine/report.h"

const char *summary_plural(double count) {
    return count == 1 ? "" : "s";
}

void whirl_write_keyphasor(const char *keyphasor, double rate, FILE *out) {
    fprintf(out, "  sections: once a turn of the %s (%.6g Hz), which counts as a revolution here\n", keyphasor,
            rate / 6.283185307179586);
}

void whirl_result_write_end(const whirl_result *result, const char *table, const char *parameter, double first,
                            FILE *out) {
    char name[WHIRL_NAME_SIZE + 16];
    snprintf(name, sizeof name, "%.63s ends at", table);
    const char *const said = whirl_result_fact(result, name), *const missed = strstr(said, "short of ");
    if (!missed) return;
    const whirl_unit unit = whirl_result_unit(result, parameter);
    const char *const gap = *unit.name ? " " : "";
    const double last = strtod(said, NULL), end = strtod(missed + strlen("short of "), NULL);
    if (last == first)
        fprintf(out, "  the step is larger than the range: %.6g%s%s is the only value\n", last / unit.size, gap,
                unit.name);
    else
        fprintf(out, "  the steps end at %.6g%s%s, short of %.6g%s%s\n", last / unit.size, gap, unit.name,
                end / unit.size, gap, unit.name);
}
