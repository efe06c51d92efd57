// Get numbers of a result for reports.
#ifndef REPORT_QUANTITIES_H
#define REPORT_QUANTITIES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"

enum { LABEL_SIZE = 128 };

/// An array of a table: numbers [rows][columns]; NULL with rows 0 if there is none.
typedef struct numbers {
    const double *at;
    size_t rows, columns;
} numbers;

/// Returns the array of a field for a point and a station or contact; at = NULL if the field is absent or its first
/// number is NaN.
numbers point_numbers(const whirl_table *table, size_t point, const char *field, size_t which);

/// Returns the first number of a field; NaN if it is absent.
double point_number(const whirl_table *table, size_t point, const char *field);

numbers point_section(const whirl_table *table, size_t point, size_t station);  ///< x, y, vx, vy once a revolution
numbers point_waveform(const whirl_table *table, size_t point, size_t station); ///< x, y
numbers point_spectrum(const whirl_table *table, size_t point, size_t station); ///< order, x, y, forward, backward
numbers point_lines(const whirl_table *table, size_t point,
                    size_t station); ///< peaks of the spectrum, in the same columns, largest first

/// Returns the share of a station's motion in its stored spectral lines (spectrum/share); NaN if unknown. Summary and
/// report show it below FEW_LINES.
double line_share(const whirl_table *table, size_t point, size_t station);
#define FEW_LINES 0.9

/// Returns the largest Lyapunov exponent per revolution: from the analysis "lyapunov", else from the verdict; NaN
/// without both.
whirl_estimate point_exponent(const whirl_table *table, size_t point);

double max_radius(const whirl_table *table, size_t point, size_t station);     ///< NaN if not computed
double backward_share(const whirl_table *table, size_t point, size_t station); ///< NaN if not computed

/// An estimate rounded for display: an error of at most two significant digits and at least 0.0001, a value with as
/// many decimals.
typedef struct shown_estimate {
    double value, error;
    int decimals;
} shown_estimate;
shown_estimate estimate_shown(whirl_estimate estimate);

/// Replaces "+-" in a sentence, which is for terminals (ASCII), by the sign for pages.
void plus_minus(char *text);

/// Writes the verdict's reason, with its exponent rounded for display.
void reason_text(const whirl_verdict *verdict, char *text, size_t size);

/// Returns the share of time in contact, the largest over all contacts; NaN if not computed or without contacts.
double rub_share(const whirl_table *table, size_t point, size_t contact_count);

/// Returns true if the table has fields of contacts.
bool has_rub(const whirl_table *table, size_t contact_count);

/// Returns true for a motion without any number: it left its bounds, or the solver could not go on. A motion with a
/// verdict has at least the numbers of the verdict.
bool motion_lost(const whirl_table *table, size_t point);

/// Returns the number of motions without any number in a table, and the first of them.
size_t motions_lost(const whirl_table *table, size_t *first);

/// Returns the table whose points are shown one by one: "detail", else "response"; NULL if there is neither.
const whirl_table *detail_table(const whirl_result *result);

#endif
