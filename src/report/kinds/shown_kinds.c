// Registry of kinds of tables with views of their own.
#include "shown_kinds.h"

static const shown_kind *const kinds[] = {&shown_tolerances, &shown_branches,        &shown_tori,      &shown_modes,
                                          &shown_unbalance,  &shown_critical_speeds, &shown_stability, &shown_statics,
                                          &shown_runup,      &shown_twists,          &shown_fit,       &shown_records};

const shown_kind *shown_kind_of(const whirl_table *table) {
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (whirl_layout_field(&table->layout, kinds[i]->field)) return kinds[i];
    return NULL;
}
