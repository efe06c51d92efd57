// Weight on the machine of a result, from its fact "weight" (case/describe.c).
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report_parts.h"

void weight_text(const whirl_shown_units *units, char *text, size_t size) {
    static const char si[] = " m/s2";
    const whirl_unit *const unit = &units->of[WHIRL_QUANTITY_ACCELERATION];
    const char *fact = whirl_result_fact(units->result, "weight"), *end;
    size_t used = 0;
    *text = '\0';
    // Writes every "9.80665 m/s2" of the fact in the shown unit, and the words between as they are.
    for (; (end = strstr(fact, si)) != NULL; fact = end + sizeof si - 1) {
        const char *number = end;
        while (number > fact && number[-1] != ' ') number--;
        used += (size_t)snprintf(text + used, size - used, "%.*s%.6g %s", (int)(number - fact), fact,
                                 strtod(number, NULL) / unit->size, unit->name);
        if (used >= size) return;
    }
    snprintf(text + used, size - used, "%s", fact);
}

bool weight_stands(const whirl_result *result) {
    return strstr(whirl_result_fact(result, "weight"), " along ") != NULL;
}

bool weight_heads(const whirl_result *result) {
    bool journals = false;
    for (size_t t = 0; t < result->table_count; t++)
        if (whirl_layout_field(&result->tables[t].layout, WHIRL_FIELD_STATICS_LOAD)) return false;
    for (size_t s = 0; s < result->station_count; s++) journals = journals || result->stations[s].clearance > 0.0;
    return weight_stands(result) || (journals && strncmp(whirl_result_fact(result, "weight"), "none", 4) == 0);
}
