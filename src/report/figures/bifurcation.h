/// What a bifurcation diagram of a station shows, and what its panels share.
#ifndef REPORT_BIFURCATION_H
#define REPORT_BIFURCATION_H

#include <stdbool.h>
#include <stddef.h>

#include "figure_kinds.h"
#include "regimes.h"

enum { MOST_KINDS = (int)CLASS_COUNT > (int)ATTRACTOR_COLOURS ? (int)CLASS_COUNT : (int)ATTRACTOR_COLOURS };

typedef struct bifurcation {
    const whirl_result *result;
    const whirl_table *table;
    const whirl_case *machine; ///< that they are of (machine_at.h), or NULL
    size_t station;
    span parameter, x, y, exponent, radius;
    bool rub, confidence, both;
    bool shaded;              ///< where the rotor rubs, which is seen where it does not everywhere
    bool present[MOST_KINDS]; ///< kinds of points
    size_t attractors; ///< that have a strip or a colour; 0 where every place has one start, and kinds are regimes
    const whirl_shown_units *units;
    double length, value; ///< what displacements and values of the parameter are multiplied by to be shown
    double share;         ///< largest share of the time in contact, with a margin
    double gap;           ///< radius at which the station touches a stator, 0 where none is near or it changes
    double clearance;     ///< of the bearing, 0 where there is none or it changes
    bool ratios;          ///< the points have equal ratios: the axis is logarithmic
} bifurcation;

/// Kinds of points: classes of regimes, or attractors where several starts lead to them.
size_t bifurcation_kinds(const bifurcation *of);
size_t bifurcation_kind(const bifurcation *of, size_t point);
const char *bifurcation_kind_colour(const bifurcation *of, size_t kind);
void bifurcation_kind_name(const bifurcation *of, size_t kind, char text[WHIRL_NAME_SIZE]);

/// Fills in ranges and flags from result, table, machine, station, units, length and value.
void bifurcation_survey(bifurcation *of);

/// What of the axis belongs to a point, in SI: up to half-way to its neighbours in its branch.
void bifurcation_edges(const bifurcation *of, size_t i, double *low, double *high);

#endif
