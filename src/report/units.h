// In which units figures and pages show their numbers: as asked for, else as the case has them, else those of the
// result.
#ifndef REPORT_UNITS_H
#define REPORT_UNITS_H

#include <stdbool.h>
#include <stddef.h>

#include "unit_words.h"
#include "whirl/result.h"

enum { UNIT_LABEL_SIZE = 160 };

typedef struct shown_units {
    const whirl_result *result;
    const unit_word *speed; ///< of parameters in rad/s; NULL: as the case writes each
    const unit_word *size;  ///< of parameters in m; NULL likewise
    /// Displacements: `length` times what the result holds in the case's own length scale; see units_length.
    double length;
    char length_name[2 * WHIRL_NAME_SIZE]; ///< "um" shown, or the symbol of the scale that they are given over
    bool ratio;                            ///< they are given over a scale: "x / c", not "x (mm)"
    double amplitude;                      ///< times what the result holds, zero to peak; `length` not included
    const char *amplitude_name;            ///< "p-p"; "" where nobody asked and zero to peak is meant
    double frequency;                      ///< size of the unit of frequencies in Hz; 0: orders of the running speed
    const char *frequency_name;
} shown_units;

/// What `asked` says, where it says nothing what the result's fact "units" says, else: lengths over their scale where
/// that is a named parameter, in m, mm or um where it is not; parameters as the case writes them; orders; zero to peak.
shown_units units_shown(const whirl_result *result, const unit_choice *asked);

/// What lengths of a point of the table are multiplied by to be shown (NULL: those of the case as it stands).
double units_length(const shown_units *units, const whirl_table *table, size_t point);

/// Whether one factor shows all lengths of the table, the stations' clearances and gaps included.
bool units_one_length(const shown_units *units, const whirl_table *table);

/// The unit of a parameter: shown number = value in SI over its size.
whirl_unit units_parameter(const shown_units *units, const char *name);

/// What an order of the running speed (rad/s) is in the unit of frequencies; NaN where they are shown as orders, or the
/// speed is not known.
double units_order(const shown_units *units, double speed);

/// How an axis is called, for plain text: "x / c" or "x (um)"; "amplitude (um p-p)"; "omega (rpm)".
void units_length_label(const shown_units *units, const char *quantity, char *label, size_t size);
void units_amplitude_label(const shown_units *units, const char *quantity, char *label, size_t size);
void units_parameter_label(const shown_units *units, const char *name, char *label, size_t size);

/// "r_k = 0.46" or "omega = 6000 rpm"; for a table without a parameter its name.
void units_point_label(const shown_units *units, const whirl_table *table, size_t point, char *label, size_t size);

#endif
