/// Positions of the parts of a machine in its drawing.
#ifndef REPORT_MACHINE_LAYOUT_H
#define REPORT_MACHINE_LAYOUT_H

#include "figure_build.h"
#include "figure_kinds.h"
#include "whirl/engine/result.h"
#include "whirl/engine/system.h"
#include "whirl/internal/model.h"
#include "whirl/internal/shown.h"

#include <stdbool.h>
#include <stddef.h>

/// Layout of a machine's drawing. Lengths are in m; without shafts of finite elements they have no meaning.
typedef struct machine_layout {
    const whirl_result *result;
    whirl_model model;
    bool to_scale;                                           ///< the machine has shafts of finite elements
    double offset[WHIRL_MAX_SHAFTS], axis[WHIRL_MAX_SHAFTS]; ///< position of each shaft's start, and its height
    bool placed_shaft[WHIRL_MAX_SHAFTS];
    bool placed[WHIRL_MAX_PROBES];
    double x[WHIRL_MAX_PROBES], y[WHIRL_MAX_PROBES], radius[WHIRL_MAX_PROBES]; ///< positions and radii of all stations
    double symbol;                                                             ///< size of symbols
    double top, bottom;                                                        ///< range of the whole drawing
    span along;
} machine_layout;

/// layout_new: lays out the machine of a drawing; NULL without a machine or without memory. Free with layout_free.
machine_layout *layout_new(const drawing *of);
void layout_free(machine_layout *layout);

/// Returns the number of letters of the longest name of a station.
size_t layout_longest_name(const whirl_result *result);

/// Returns true for a station of the layout, false for the ground.
bool layout_has_station(const machine_layout *l, size_t station);

/// layout_largest_radius: returns the largest radius of a shaft and the parts on it, m. layout_rim_radius: returns the
/// radius of a station's disc, or of its shaft if that is larger, m.
double layout_largest_radius(const machine_layout *l, size_t shaft);
double layout_rim_radius(const machine_layout *l, size_t station);

/// Return the radius and the width in m of a steel disc with a station's mass and polar inertia; without inertia, those
/// of a cube.
double layout_disc_radius(const whirl_model_mass *of);
double layout_disc_width(const whirl_model_mass *of);

/// Returns the mass that determines a station's size: its own, or that of a steel disc with its polar inertia.
double layout_mass(const whirl_model_mass *of);

/// Drawn size of a station's disc or mass: half of its width, and its outer radius; both large enough to be visible. m.
typedef struct layout_disc {
    double half, radius;
} layout_disc;
layout_disc layout_disc_of(const machine_layout *l, size_t station);

/// Returns the positions of both ends of a shaft; an empty span without sections.
span layout_shaft_ends(const machine_layout *l, size_t shaft);

/// layout_unit: returns the unit of places along shafts in m; inches if lengths are in mils or inches, else mm.
/// layout_label: returns the label of their axis.
double layout_unit(const whirl_shown_units *units);
const char *layout_label(const whirl_shown_units *units);

#endif
