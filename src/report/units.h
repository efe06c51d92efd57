/// Makes labels of quantities in figures and pages, in shown units.
#ifndef REPORT_UNITS_H
#define REPORT_UNITS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

enum { UNIT_LABEL_SIZE = 160 };

/// Returns an order of the running speed (rad/s) in the unit of frequencies; NaN if orders are shown, or the speed is
/// unknown.
double units_order(const whirl_shown_units *units, double speed);

/// Writes the label of an axis of orders of the running speed, or of frequencies; full: of a full spectrum, with
/// backward whirl.
void units_order_label(const whirl_shown_units *units, bool orders, bool full, char *label, size_t size);

/// Returns true if the parameter of a table is the speed of the shaft, by the field `speeds` at every point.
bool units_of_speed(const whirl_table *table, const char *speeds);

/// Returns the direction of whirl from a number between -1 and 1: 1 forward, -1 backward, 0 to and fro.
int units_way(double direction);

/// Returns the factor from a length at a point of the table to its shown value.
double units_length(const whirl_shown_units *units, const whirl_table *table, size_t point, whirl_counting counting);

/// Write an axis label in plain text: "x / c" or "x (um)"; "amplitude / c (0-p)" or "amplitude (um p-p)"; "omega
/// (rpm)".
void units_length_label(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *label,
                        size_t size);
void units_parameter_label(const whirl_shown_units *units, const char *name, char *label, size_t size);

/// Writes "r_k = 0.46", "omega = 6000 rpm, kappa = 10" or, for a motion on the way back, "omega = 6000 rpm from the
/// last value"; for a table without a parameter its name.
void units_point_label(const whirl_shown_units *units, const whirl_table *table, size_t point, char *label,
                       size_t size);

#endif
