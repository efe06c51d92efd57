// Findings on tables of motions.
#include "found_motions.h"
#include "shown_kinds.h"

enum { MAX_LISTED = 12 };

/// Returns true for tables whose motions are looked at one by one: those of few points, and those of points in detail.
static bool motions_listed(const whirl_table *table) {
    return table->role == WHIRL_ROLE_DETAIL || table->role == WHIRL_ROLE_MOTIONS ||
           (table->row == 0 && whirl_table_planned(table) <= MAX_LISTED);
}

static void motions_find(const finder *of) {
    find_lost(of);
    find_together(of);
    find_regimes(of);
    find_attractors(of);
    find_lines(of);
    if (motions_listed(of->table)) find_points(of);
}

const shown_kind shown_motions = {.anchor = "regimes", .name = "Motions", .find = motions_find};
