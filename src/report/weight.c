// Weight on the machine of a result, from its fact "weight" (case/describe.c).
#include <string.h>

#include "weight.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/findings.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

void weight_text(const whirl_shown_units *units, char *text, size_t size) {
    whirl_shown_sentence(units, whirl_result_fact(units->result, "weight"), text, size);
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
