// Weight on the machine of a result, from its fact "weight" (case/describe.c).
#include <string.h>

#include "report_parts.h"

const char *weight_told(const whirl_result *result) {
    return whirl_result_fact(result, "weight");
}

bool weight_stands(const whirl_result *result) {
    return strstr(weight_told(result), " along ") != NULL;
}

bool weight_heads(const whirl_result *result) {
    bool journals = false;
    for (size_t t = 0; t < result->table_count; t++)
        if (whirl_layout_field(&result->tables[t].layout, WHIRL_FIELD_STATICS_LOAD)) return false;
    for (size_t s = 0; s < result->station_count; s++) journals = journals || result->stations[s].clearance > 0.0;
    return weight_stands(result) || (journals && strncmp(weight_told(result), "none", 4) == 0);
}
