/// Keys, numbers and doubts that bearings with fixed and with tilting pads share.
#ifndef ROTOR_PADS_BUILD_H
#define ROTOR_PADS_BUILD_H

#include "element.h"
#include "oil.h"
#include "whirl/internal/bearing.h"

/// Variant of tilting_pad with yielding pivots.
extern const element_type tilting_pad_yielding_type;

enum {
    PADS_AT,
    PADS_FROM,
    PADS_COUNT,
    PADS_SHAPE,
    PADS_PIVOTS,
    PADS_ARC,
    PADS_OFFSET,
    PADS_PRELOAD,
    PADS_TURNED,
    PADS_CAVITATION,
    PADS_CLEARANCE,
    PADS_OIL,
    PADS_TURBULENCE = PADS_OIL + OIL_KEYS,
    PADS_RADIUS,
    PADS_LENGTH,
    PADS_FIXED_KEYS,
    PADS_INERTIA = PADS_FIXED_KEYS,
    PADS_SPRING,
    PADS_DAMPER,
    PADS_PIVOT,
    PADS_PIVOT_DAMPER,
    PADS_MASS,
    PADS_TILTING_KEYS
};

/// Rows of both tables of keys; `shapes` are the usual bearings (whirl_pads_named).
// clang-format off
#define PADS_KEYS(shapes)                                                                                              \
    [PADS_AT] = STATION_KEY("at", REQUIRED, "station of the journal"),                                                 \
    [PADS_FROM] = STATION_KEY("from", OPTIONAL,                                                                        \
                              "station of the housing, which does not turn; absent: the ground"),                      \
    [PADS_COUNT] = WHOLE_KEY("count", "", DEFAULT("1"), WHIRL_FROM_TO(1, 1000),                                        \
                             "number of equal bearings at this station"),                                              \
    [PADS_SHAPE] = CHOICE_KEY("shape", OPTIONAL, shapes,                                                               \
                              "a standard bearing with its pads, for a load along -y; this, or pivots and arc"),       \
    [PADS_PIVOTS] =                                                                                                    \
        CITED_NUMBERS_KEY("pivots", "", "rad", OPTIONAL, WHIRL_ANY,                                                    \
                          "angles of the pads' pivots, or of their lines of preload, from x towards y", ""),           \
    [PADS_ARC] = NUMBER_KEY("arc", "", "rad", OPTIONAL, WHIRL_ABOVE_TO(0, 3.05), "length of every pad"),               \
    [PADS_OFFSET] = NUMBER_KEY("offset", "", "1", DEFAULT("0.5"), WHIRL_FROM_TO(0, 1),                                 \
                               "share of a pad before its pivot, in the direction of rotation"),                       \
    [PADS_PRELOAD] = NUMBER_KEY("preload", "m", "1", DEFAULT("0"), WHIRL_FROM_TO(0, 0.95),                             \
                                "distance of the pads' centres from the bearing's, as a share of the clearance"),      \
    [PADS_TURNED] = ANGLE_KEY("turned", "", NULL, "angle by which all pads are turned from x towards y"),              \
    [PADS_CAVITATION] = CITED_CHOICE_KEY("cavitation", DEFAULT("reynolds"), "reynolds|gumbel",                         \
                                         "reynolds: pressure and its gradient vanish where the film breaks; gumbel: "  \
                                         "the full film's pressures below 0 are left out",                             \
                                         "Swift 1932; Stieber 1933; Guembel 1914"),                                    \
    [PADS_CLEARANCE] = NUMBER_KEY("clearance", "c", "m", REQUIRED, WHIRL_POSITIVE,                                     \
                                  "radial clearance of the pads; that of the bearing is (1 - preload) times this"),    \
    OIL_ROWS(PADS_OIL, "dynamic viscosity of the oil; required without kinematic_viscosity"),                          \
    [PADS_TURBULENCE] = CITED_CHOICE_KEY("turbulence", DEFAULT("none"), "none|ng-pan|constantinescu",                  \
                                     "turbulence factors of the film, by the local Reynolds number; needs density",    \
                                         "Ng, Pan 1965; Constantinescu 1962"),                                         \
    [PADS_RADIUS] = NUMBER_KEY("radius", "R", "m", REQUIRED, WHIRL_POSITIVE, "radius of the journal"),                 \
    [PADS_LENGTH] = NUMBER_KEY("length", "L", "m", REQUIRED, WHIRL_POSITIVE, "length of the bearing along the shaft")
// clang-format on

/// Reads the pads of a bearing from its keys, with their angles in the machine. WHIRL_BAD_INPUT if keys contradict each
/// other.
whirl_status pads_of_keys(const key_value *values, bool tilting, bool clockwise, whirl_pads *out);

/// Sets the ports, the law (the number of pads) and the numbers. WHIRL_BAD_INPUT if keys contradict each other; errors
/// of tables.
whirl_status pads_build(const key_value *values, bool tilting, assembly *to, element *out);

/// Sets the states of tilting pads around a centred journal, where all pads have the same tilt.
void pads_begin(const element *own, double *states);

/// Provides the tables of the bearing's pads (pad_table_hold), all or none; and releases them.
whirl_status pads_hold(const element *own, const whirl_stop *stop);
void pads_release(const element *own);

/// Returns the radius of the circle in which the journal moves, in length scales; 0 if the housing moves.
double pads_clearance(const element *own);

/// Implements element_type.note: writes the errors of the film tables.
void pads_note(const element *own, double length, double clock, char *text, size_t size);

/// Implements element_type.doubt for bearings with pads.
void pads_doubt(const key_value *values, double speed, const doubt_teller *to);

#endif
