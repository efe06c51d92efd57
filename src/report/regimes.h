/// Divides regimes for figures and pages: classes with colours, and intervals along a sweep.
#ifndef REPORT_REGIMES_H
#define REPORT_REGIMES_H

#include <stddef.h>

#include "whirl/engine/result.h"

typedef enum regime_class {
    CLASS_P1 = 0,
    CLASS_P2,
    CLASS_P4,
    CLASS_OTHER_PERIOD,
    CLASS_QUASI_PERIODIC,
    CLASS_CHAOTIC,
    CLASS_UNDETERMINED,
    CLASS_DIVERGED,
    CLASS_NOT_JUDGED, ///< points of tables without verdicts; not in legends of verdicts
    CLASS_COUNT
} regime_class;

regime_class regime_class_of(const whirl_verdict *verdict);

/// Returns "P-1", "other P-k", "chaotic", ...; static text.
const char *regime_class_name(regime_class kind);

/// Returns the colour of a class, "#366EFB"; static text. Readers with any colour vision can distinguish the colours.
/// The explorer has the same (explorer/tests/colours.test.mjs).
const char *regime_class_colour(regime_class kind);

enum { ATTRACTOR_COLOURS = 8 };

/// Returns the colour of an attractor by number, from 1, repeating after ATTRACTOR_COLOURS. Static text.
const char *attractor_colour(size_t number);

/// Writes "rests", "P-1", "P-8", "quasi-periodic", "chaotic", ...: the part of a verdict that neighbouring points of an
/// interval share.
void regime_name(const whirl_verdict *verdict, char *text, size_t size);

/// Consecutive points of a sweep with the same regime.
typedef struct regime_interval {
    char name[64];
    regime_class kind;
    size_t first, last, count; ///< points of the table
    size_t rubbing;            ///< number of its points with contact
    int branch;
} regime_interval;

/// Merges consecutive computed points of one regime into intervals. Returns the number of intervals; at most `most` are
/// written.
size_t regime_intervals(const whirl_table *table, size_t contact_count, regime_interval *intervals, size_t most);

/// Returns the number of intervals at the beginning of a list that are shown as one: several short intervals in a row,
/// else 1.
size_t regime_group(const regime_interval *intervals, size_t count);

/// Writes the name of intervals that are shown as one: "P-1", or "changing: P-3, chaotic" of several.
void regime_group_name(const regime_interval *group, size_t count, char *text, size_t size);

#endif
