/// How tables are shown whose points are no motions: one file a kind in this folder, one line in the registry. Tables
/// of motions are what summary, figures and pages themselves are about.
#ifndef REPORT_SHOWN_KINDS_H
#define REPORT_SHOWN_KINDS_H

#include "page.h"

typedef struct shown_kind {
    const char *field;         ///< which its tables have, and no others
    const char *anchor, *name; ///< of its section, where it has one
    const char *about;         ///< what all of its sections share, told once; NULL: nothing
    bool single;               ///< its section is of one point, too
    bool explored;             ///< the explorer has a view of its own, else it shows the figures
    /// Whether sentences about all tables of the kind tell what was found in this one (pages/found.c); NULL: of none.
    bool (*found)(const whirl_table *table);
    /// Its lines of the summary, below the table's heading.
    void (*summarize)(FILE *out, const whirl_shown_units *units, const whirl_table *table);
    /// What stands in its section of the page of a result, below the heading; NULL where it has none. Of tables along
    /// one parameter.
    void (*section)(const page *to, size_t result, const whirl_table *table);
} shown_kind;

/// That of a table, NULL of motions.
const shown_kind *shown_kind_of(const whirl_table *table);

/// Of modes at a point: 1 where one grows, -1 where all die out, 0 where they do neither but for rounding.
int shown_modes_growing(const whirl_table *table, size_t point);

/// What is told once of sections of a kind.
void shown_kind_about(const page *to, const shown_kind *kind);

extern const shown_kind shown_branches, shown_tori, shown_modes, shown_unbalance, shown_critical_speeds,
    shown_stability, shown_statics;

#endif
