/// The axes of shafts as their finite elements bend: what drawings of modes, responses and sag are made of.
#ifndef WHIRL_LINE_H
#define WHIRL_LINE_H

#include <stddef.h>

#include "whirl/engine/rotor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Places along the shafts of a design, shaft by shaft and along them, several to an element, and how they move with
/// the coordinates of its rotor: by displacements and tilts of nodes, between which elements bend as they do without
/// mass (cubic without shear: Hermite's interpolation). Of a reduced shaft nodes follow its coordinates first. Of a
/// shaft with flats the line is that of its stiffer plane.
typedef struct whirl_shaft_line {
    size_t count, degrees; ///< of places; of coordinates, half of a state without those of elements
    size_t *shaft;         ///< [count] number of the shaft, from 1
    double *position;      ///< [count] along that shaft, m
    double *share; ///< [count][degrees] m along x by one unit of coordinates along x; those along y stand behind
    double *sag;   ///< [count] m upwards by the weight, as whirl_station_statics.deflection; NULL: not asked for
} whirl_shaft_line;

/// Makes it; with the sag where couplings are given as whirl_design_statics takes them (NULL: none asked for). Errors
/// as whirl_rotor_new and, with the sag, whirl_design_statics. Freed by whirl_shaft_line_free.
whirl_status whirl_design_line(const whirl_design *design, const char *couplings, whirl_shaft_line *out);

struct whirl_case;
struct whirl_batch;

/// Of the machine that a study of the case (whirl_case_study) has at a value of a batch's parameter, with the sag where
/// the batch's variant is WHIRL_WITH_STATICS. Not of machines with springs for their bearings.
whirl_status whirl_case_line(const struct whirl_case *object, const struct whirl_batch *batch, double value,
                             whirl_shaft_line *out);

/// Displacement of a place along x (across: 0) or y (1), m, by a state or a change of one; `stride`: 1, or 2 of complex
/// numbers, one part after the other.
double whirl_shaft_line_at(const whirl_shaft_line *line, size_t place, int across, const double *state, size_t stride);

/// Frees what it has, not the struct; {0} is none.
void whirl_shaft_line_free(whirl_shaft_line *line);

#ifdef __cplusplus
}
#endif
#endif
