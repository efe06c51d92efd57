/// Axes of elements between two stations, as their key `along` selects them.
#ifndef ROTOR_ALONG_H
#define ROTOR_ALONG_H

#include "element.h"

enum { ALONG_XY, ALONG_X, ALONG_Y, ALONG_AXIAL, ALONG_TILTS, ALONG_TILT_X, ALONG_TILT_Y, ALONG_TWIST, ALONGS };

/// The axes [2] of each choice; AXES means none.
static const axis axes_along[ALONGS][2] = {[ALONG_XY] = {AXIS_X, AXIS_Y},
                                           [ALONG_X] = {AXIS_X, AXES},
                                           [ALONG_Y] = {AXES, AXIS_Y},
                                           [ALONG_AXIAL] = {AXIS_AXIAL, AXES},
                                           [ALONG_TILTS] = {AXIS_TILT_X, AXIS_TILT_Y},
                                           [ALONG_TILT_X] = {AXIS_TILT_X, AXES},
                                           [ALONG_TILT_Y] = {AXES, AXIS_TILT_Y},
                                           [ALONG_TWIST] = {AXIS_TWIST, AXES}};

#define ALONG_KEY                                                                                                      \
    CHOICE_KEY("along", DEFAULT("xy"), "xy|x|y|axial|tilts|tilt_x|tilt_y|twist",                                       \
               "the axes along which it acts; tilts: both slopes of the stations, dx/dz and dy/dz, or one of them; "   \
               "twist: about the shaft's axis; axial: along it")

static inline bool along_tilts(int choice) {
    return choice >= ALONG_TILTS;
}

/// Checks that a key fits the axes. WHIRL_BAD_INPUT for a key of angles along displacements, or the reverse.
static inline whirl_status check_along(const whirl_key *key, const key_value *value, bool for_tilts, int choice) {
    if (!value->given || for_tilts == along_tilts(choice)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "has %s, in %s, and acts along %s, expected along: %s", key->name, key->unit,
                      along_tilts(choice) ? "angles" : "displacements",
                      for_tilts ? "tilts, tilt_x, tilt_y or twist" : "xy, x, y or axial");
}

#endif
