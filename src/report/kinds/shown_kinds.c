// Registry of the kinds of tables that have their own findings.
#include "shown_kinds.h"

#define KIND_AT(name) &shown_##name,
static const shown_kind *const kinds[] = {SHOWN_KINDS(KIND_AT)};

const shown_kind *shown_kind_of(const whirl_table *table) {
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (!kinds[i]->field || whirl_layout_field(&table->layout, kinds[i]->field)) return kinds[i];
    return &shown_motions;
}
