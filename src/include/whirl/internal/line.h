/// Axes of shafts as their finite elements bend, for drawings of modes, responses and sag.
#ifndef WHIRL_LINE_H
#define WHIRL_LINE_H

#include <stddef.h>

#include "whirl/engine/rotor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Positions along the shafts of a design, shaft by shaft and in order along each, several per element, and their
/// displacements by the coordinates of the rotor: displacements and tilts of nodes, between which elements bend as
/// without mass (cubic without shear: Hermite's interpolation). Nodes of a reduced shaft follow from its coordinates. A
/// shaft with flats bends as in its stiffer plane.
typedef struct whirl_shaft_line {
    size_t count, degrees; ///< number of positions; of coordinates, half of a state without those of elements
    size_t *shaft;         ///< [count] number of the shaft, from 1
    double *position;      ///< [count] along that shaft, m
    double *share;         ///< [count][degrees] m along x by one unit of coordinates along x; those along y follow
    double *sag;           ///< [count] m upwards by weight, as whirl_station_statics.deflection; NULL: not requested
} whirl_shaft_line;

/// Builds the line of a design; with the sag for `couplings` as in whirl_design_statics (NULL: no sag). Errors as
/// whirl_rotor_new and, with the sag, whirl_design_statics. Freed by whirl_shaft_line_free.
whirl_status whirl_design_line(const whirl_design *design, const char *couplings, whirl_shaft_line *out);

struct whirl_case;
struct whirl_batch;

/// Builds the line of the machine that a study of the case (whirl_case_study) has at a value of a batch's parameter,
/// with the sag if the batch's variant is WHIRL_WITH_STATICS. Not for machines with springs as bearings.
whirl_status whirl_case_line(const struct whirl_case *object, const struct whirl_batch *batch, double value,
                             whirl_shaft_line *out);

/// Returns the displacement of a position along x (across: 0) or y (1), m, for a state or a change of one; `stride`: 1,
/// or 2 for one part of interleaved complex numbers.
double whirl_shaft_line_at(const whirl_shaft_line *line, size_t place, int across, const double *state, size_t stride);

/// Frees the contents, not the struct; accepts {0}.
void whirl_shaft_line_free(whirl_shaft_line *line);

#ifdef __cplusplus
}
#endif
#endif
