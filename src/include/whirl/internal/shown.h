/// Shown units: the units in which figures, pages and files for people show the numbers of a result. They are those
/// asked for, else those of the case, else those of the result.
#ifndef WHIRL_SHOWN_H
#define WHIRL_SHOWN_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Quantities in documents, with their unit in SI; after the semicolon the unit shown by default.
typedef enum whirl_quantity {
    WHIRL_QUANTITY_NUMBER,      ///< without a unit
    WHIRL_QUANTITY_PERCENT,     ///< in %
    WHIRL_QUANTITY_DEGREES,     ///< angles, in degrees
    WHIRL_QUANTITY_SPEED,       ///< rad/s of a shaft; rpm
    WHIRL_QUANTITY_FREQUENCY,   ///< rad/s of a motion; Hz
    WHIRL_QUANTITY_ANGULAR,     ///< rad/s; rad/s
    WHIRL_QUANTITY_RATE,        ///< 1/s
    WHIRL_QUANTITY_TIME,        ///< s
    WHIRL_QUANTITY_LENGTH,      ///< m of displacements; unit of lengths in the case
    WHIRL_QUANTITY_SIZE,        ///< m of motions, zero to peak; unit as lengths, counted as chosen (0-p)
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
    WHIRL_QUANTITY_WEIGHT,      ///< kg of balancing weights; g
    WHIRL_QUANTITY_RESIDUAL,    ///< kg m of residual unbalance; g mm
    /// m/s2 of a station
    WHIRL_QUANTITY_ACCELERATION,
    WHIRL_QUANTITIES
} whirl_quantity;

/// Shown units with the factors of quantities; filled by whirl_result_shown_units.
typedef struct whirl_shown_units {
    const whirl_result *result; ///< result whose numbers are shown; borrowed
    whirl_unit speed;           ///< unit of parameters in rad/s; size 0: as in the case
    whirl_unit size;            ///< unit of parameters in m; likewise
    /// Displacements: factor for numbers in the result's own length scale; see whirl_shown_length.
    double length;
    char length_name[2 * WHIRL_NAME_SIZE]; ///< "um", or the symbol of the scale by which lengths are divided
    bool ratio;                            ///< lengths are divided by a scale: "x / c", not "x (mm)"
    double amplitude;                      ///< further factor of amplitudes, which results hold zero to peak
    const char *amplitude_name;            ///< name of the way of counting: "p-p"; "0-p" by default; static
    double frequency;                      ///< unit of frequencies in Hz; 0: orders of the running speed
    const char *frequency_name;            ///< unit of frequencies, or the name of orders; static
    whirl_unit of[WHIRL_QUANTITIES];       ///< unit in which documents show each quantity: number = SI value over its
                                           ///< size
    bool chosen[WHIRL_QUANTITIES];         ///< true if that unit was chosen
    double zero; ///< offset of temperatures in their unit: 273.15 for degC, 459.67 for degF, 0 for K
} whirl_shown_units;

/// Determines shown units from `asked` ("um, rpm, Hz, p-p", "US"; words as in a case's `units`, NULL or "" for none).
/// Choices that it leaves open come from the result's fact "units", unless `asked` names a system. The defaults are:
/// lengths over their scale if that is a named parameter, otherwise in m, mm or um; parameters as in the case; orders;
/// zero to peak. WHIRL_BAD_INPUT for words that are not units. `*units` borrows the result.
whirl_status whirl_result_shown_units(const whirl_result *result, const char *asked, whirl_shown_units *units);

/// Returns the factor from lengths of a point of the table to shown ones.
double whirl_shown_length(const whirl_shown_units *units, const whirl_table *table, size_t point);

/// Returns the name of a way of counting: "p-p", "0-p", "" for positions; static, or of the units.
const char *whirl_shown_counted(const whirl_shown_units *units, whirl_counting counting);

/// Returns true if one factor applies to all lengths of the table (NULL: of the case at its own parameters), with
/// clearances and gaps of stations.
bool whirl_shown_one_length(const whirl_shown_units *units, const whirl_table *table);

/// Determines the units of a document without a result, such as a bearing's: lengths in um by default. `*units` borrows
/// nothing. WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_shown_units_alone(const char *asked, whirl_shown_units *units);

/// Returns the unit of a parameter: shown number = value in SI over its size. A unit chosen for quantities of its SI
/// unit takes precedence over that of the case; temperatures are in K.
whirl_unit whirl_shown_parameter(const whirl_shown_units *units, const char *name);

/// Enumerates the SI units of parameters for which another unit can be chosen: returns number `index`, and fills in the
/// unit chosen for it (size 0: none). NULL past the last. Static text.
const char *whirl_shown_si(const whirl_shown_units *units, size_t index, whirl_unit *unit);

/// Returns the unit that is chosen for numbers in an SI unit of that list; of size 0 if none is.
whirl_unit whirl_shown_chosen(const whirl_shown_units *units, const char *si);

#ifdef __cplusplus
}
#endif

#endif
