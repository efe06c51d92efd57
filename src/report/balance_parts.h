// Functions shared by the findings and the JSON of a balancing result.
#ifndef REPORT_BALANCE_PARTS_H
#define REPORT_BALANCE_PARTS_H

#include <stdbool.h>
#include <stddef.h>

#include "findings_render.h"
#include "whirl/internal/balance.h"

/// Returns the length of a vector.
double balance_size(const double vector[2]);

/// Returns the angle of a vector times `way` (1 or -1), in degrees from 0 to 360.
double balance_degrees(const double vector[2], double way);

/// Return the sense in which the file counts angles on the rotor, and phases: 1 (with the rotation; lead) or -1.
double balance_way_of_angles(const whirl_balance *of);
double balance_way_of_phases(const whirl_balance *of);

/// Computes the static part of a correction in two planes, and half of its couple (difference); 0 for rounding errors.
void balance_static(const whirl_correction *found, double sum[2], double half[2]);

/// Returns the sum of the weights in all planes, kg m.
double balance_sum(const whirl_balance *of, const whirl_correction *found);

/// Writes the name of plane or weight set n.
void balance_name(const whirl_balance *of, size_t n, char *text, size_t size);

/// Writes the reason for the size of trial weight n, and its expected effect. units: NULL for those of the file.
/// Returns false without memory.
bool balance_reason_text(const whirl_balance *of, const whirl_balance_model *model, const whirl_correction *found,
                         const char *units, size_t n, char text[STATEMENT_SIZE]);

/// Writes a warning by its index, "" past the last. units: NULL for those of the file. Returns false without memory.
bool balance_warning_text(const whirl_balance *of, const whirl_correction *found, const char *units, size_t index,
                          char text[STATEMENT_SIZE]);

#endif
