/// In which units figures, pages and files for people show the numbers of a result: as asked for, else as the case has
/// them, else those of the result.
#ifndef WHIRL_SHOWN_H
#define WHIRL_SHOWN_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What a number of a document is; the unit it has in SI, and the one it is shown in where nobody chooses another.
typedef enum whirl_quantity {
    WHIRL_QUANTITY_NUMBER,      ///< without a unit
    WHIRL_QUANTITY_PERCENT,     ///< in %
    WHIRL_QUANTITY_DEGREES,     ///< angles, in degrees
    WHIRL_QUANTITY_SPEED,       ///< rad/s of a shaft; rpm
    WHIRL_QUANTITY_FREQUENCY,   ///< rad/s of a motion; Hz
    WHIRL_QUANTITY_ANGULAR,     ///< rad/s, shown so
    WHIRL_QUANTITY_RATE,        ///< 1/s
    WHIRL_QUANTITY_LENGTH,      ///< m of displacements; as the case writes lengths
    WHIRL_QUANTITY_SIZE,        ///< m, zero to peak, of motions; as lengths, and counted as is chosen (0-p)
    WHIRL_QUANTITY_SPAN,        ///< m, peak to peak; um
    WHIRL_QUANTITY_POSITION,    ///< m along a shaft
    WHIRL_QUANTITY_DIAMETER,    ///< m; mm
    WHIRL_QUANTITY_SLOPE,       ///< rad; mrad
    WHIRL_QUANTITY_FORCE,       ///< N
    WHIRL_QUANTITY_MOMENT,      ///< N m
    WHIRL_QUANTITY_MASS,        ///< kg
    WHIRL_QUANTITY_INERTIA,     ///< kg m2
    WHIRL_QUANTITY_UNBALANCE,   ///< kg m; kg mm
    WHIRL_QUANTITY_STIFFNESS,   ///< N/m of bearings; MN/m
    WHIRL_QUANTITY_CROSS,       ///< N/m of cross coupling
    WHIRL_QUANTITY_DAMPING,     ///< N s/m; kN s/m
    WHIRL_QUANTITY_DENSITY,     ///< kg/m3
    WHIRL_QUANTITY_PRESSURE,    ///< Pa; MPa
    WHIRL_QUANTITY_FLOW,        ///< m3/s; l/min
    WHIRL_QUANTITY_POWER,       ///< W; kW
    WHIRL_QUANTITY_TEMPERATURE, ///< K; degC
    WHIRL_QUANTITY_VISCOSITY,   ///< Pa s; mPa s
    WHIRL_QUANTITY_WEIGHT,      ///< kg of the weights that balance a rotor; g
    WHIRL_QUANTITY_RESIDUAL,    ///< kg m of these; g mm
    WHIRL_QUANTITIES
} whirl_quantity;

/// The units, and what quantities are multiplied by; made by whirl_result_shown_units.
typedef struct whirl_shown_units {
    const whirl_result *result; ///< whose numbers are shown; borrowed
    whirl_unit speed;           ///< of parameters in rad/s; of size 0: as the case writes each
    whirl_unit size;            ///< of parameters in m; likewise
    /// Displacements: `length` times what the result holds in the case's own length scale; see whirl_shown_length.
    double length;
    char length_name[2 * WHIRL_NAME_SIZE]; ///< "um" shown, or the symbol of the scale that they are given over
    bool ratio;                            ///< they are given over a scale: "x / c", not "x (mm)"
    double amplitude;                      ///< times what the result holds, zero to peak; `length` not included
    const char *amplitude_name;            ///< "p-p"; "0-p" where nobody asked; static
    double frequency;                      ///< size of the unit of frequencies in Hz; 0: orders of the running speed
    const char *frequency_name;            ///< static
    whirl_unit of[WHIRL_QUANTITIES];       ///< in which documents show each quantity: number = SI over its size
    bool chosen[WHIRL_QUANTITIES];         ///< somebody has chosen that unit
    double zero; ///< taken off temperatures in their unit: 273.15 of degC, 459.67 of degF, 0 of K
} whirl_shown_units;

/// What `asked` ("um, rpm, Hz, p-p", "US"; words as in a case's `units`, NULL or "" for none) says; where it says
/// nothing, and names no system, what the result's fact "units" says; else lengths over their scale where that is a
/// named parameter, in m, mm or um where it is not, parameters as the case writes them, orders, zero to peak.
/// WHIRL_BAD_INPUT for words that are no units. `*units` borrows the result.
whirl_status whirl_result_shown_units(const whirl_result *result, const char *asked, whirl_shown_units *units);

/// What lengths of a point of the table are multiplied by to be shown.
double whirl_shown_length(const whirl_shown_units *units, const whirl_table *table, size_t point);

/// How numbers that are counted so are called: "p-p", "0-p", "" of places; static, or of the units.
const char *whirl_shown_counted(const whirl_shown_units *units, whirl_counting counting);

/// Whether one factor shows all lengths of the table (NULL: those of the case as it stands), the stations' clearances
/// and gaps included.
bool whirl_shown_one_length(const whirl_shown_units *units, const whirl_table *table);

/// The units of a document that is of no result, such as a bearing's: lengths in um where nobody chooses. `*units`
/// borrows nothing. WHIRL_BAD_INPUT for words that are no units.
whirl_status whirl_shown_units_alone(const char *asked, whirl_shown_units *units);

/// The unit of a parameter: shown number = value in SI over its size. What is chosen for quantities of its SI unit goes
/// before how the case writes it; temperatures are in K.
whirl_unit whirl_shown_parameter(const whirl_shown_units *units, const char *name);

#ifdef __cplusplus
}
#endif

#endif
