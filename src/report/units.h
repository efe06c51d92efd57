// How figures and pages call quantities, in the units in which they are shown.
#ifndef REPORT_UNITS_H
#define REPORT_UNITS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/shown.h"

enum { UNIT_LABEL_SIZE = 160 };

/// What an order of the running speed (rad/s) is in the unit of frequencies; NaN where they are shown as orders, or the
/// speed is not known.
double units_order(const whirl_shown_units *units, double speed);

/// The axis of orders of the running speed, or of the frequencies that they are; `full`: of backward whirl, too.
void units_order_label(const whirl_shown_units *units, bool orders, bool full, char *label, size_t size);

/// "p-p" of amplitudes, as they are shown; "0-p" of other distances; "" of places.
const char *units_counted(const whirl_shown_units *units, whirl_counting counting);

/// What a length of a point of the table is multiplied by to be shown.
double units_length(const whirl_shown_units *units, const whirl_table *table, size_t point, whirl_counting counting);

/// How an axis is called, for plain text: "x / c" or "x (um)"; "amplitude / c (0-p)" or "amplitude (um p-p)"; "omega
/// (rpm)".
void units_length_label(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *label,
                        size_t size);
void units_parameter_label(const whirl_shown_units *units, const char *name, char *label, size_t size);

/// "r_k = 0.46" or "omega = 6000 rpm"; for a table without a parameter its name.
void units_point_label(const whirl_shown_units *units, const whirl_table *table, size_t point, char *label,
                       size_t size);

#endif
