/// A bifurcation diagram of a station: its data, shared by its panels.
#ifndef REPORT_BIFURCATION_H
#define REPORT_BIFURCATION_H

#include "figure_build.h"
#include "regimes.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"
#include "whirl/job.h"

#include <stdbool.h>
#include <stddef.h>

enum { MAX_KINDS = (int)CLASS_COUNT > (int)ATTRACTOR_COLOURS ? (int)CLASS_COUNT : (int)ATTRACTOR_COLOURS };

typedef struct bifurcation {
    const whirl_result *result;
    const whirl_table *table;
    const whirl_case *machine; ///< case of the machine (machine_at.h), or NULL
    size_t station;
    span parameter, x, y, exponent, radius;
    bool rub, confidence, both; ///< the table has fields of contacts; of confidence; both directions of the sweep
    bool shaded;                ///< ranges with contact are shaded: some points have contact, but not all
    bool present[MAX_KINDS];    ///< true for kinds of points that occur
    size_t attractors; ///< number of attractors, each with a strip and a colour; 0: every parameter value has one
                       ///< start, and kinds are regimes
    const whirl_shown_units *units;
    double length, value; ///< factors from SI to displacements and parameter values as shown
    double share;         ///< largest share of the time in contact, with a margin
    double gap;           ///< gap to a stator; 0 if it is far away or differs between points
    double clearance;     ///< clearance of a bearing; 0 if there is none or it differs between points
    bool ratios;          ///< parameter values have equal ratios: the axis is logarithmic
} bifurcation;

/// Number of kinds of points, kind of a point, and colour and name of a kind. Kinds are classes of regimes, or
/// attractors if places have several starts.
size_t bifurcation_kinds(const bifurcation *of);
size_t bifurcation_kind(const bifurcation *of, size_t point);
const char *bifurcation_kind_colour(const bifurcation *of, size_t kind);
void bifurcation_kind_name(const bifurcation *of, size_t kind, char text[WHIRL_NAME_SIZE]);

/// Sets ranges and flags; result, table, machine, station, units, length and value must be set.
void bifurcation_survey(bifurcation *of);

/// Writes the part of the parameter's axis that belongs to a point, in SI: half-way to its neighbours in its branch.
void bifurcation_edges(const bifurcation *of, size_t i, double *low, double *high);

#endif
