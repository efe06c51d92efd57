/// Panels over the places along a machine, with the machine in grey behind.
#ifndef REPORT_MACHINE_ALONG_H
#define REPORT_MACHINE_ALONG_H

#include "figure_build.h"
#include "figure_kinds.h"
#include "machine_layout.h"
#include "whirl/engine/system.h"

#include <stdbool.h>
#include <stddef.h>

/// Positions of stations and shafts along a panel. Stations on shafts of finite elements are at their places. Shafts on
/// different axes follow one another, then stations on no shaft. Without such shafts stations are spaced evenly.
typedef struct machine_along {
    machine_layout *layout;                               ///< layout of the machine, to scale; NULL: none
    bool shafts;                                          ///< the machine has shafts of finite elements
    size_t aside;                                         ///< number of stations on no shaft, if there are shafts
    double unit;                                          ///< m of one unit
    span range;                                           ///< range of the axis, in units, or in numbers of stations
    double step, end;                                     ///< spacing of stations on no shaft, which begin at `end`
    double at[WHIRL_MAX_PROBES], start[WHIRL_MAX_SHAFTS]; ///< positions of stations, and of the beginnings of shafts
} machine_along;

/// Finds the positions along a panel; the caller frees `layout` by layout_free.
void along_place(const drawing *of, machine_along *out);

/// Sets up the horizontal axis of a panel: places along shafts, or names of stations without shafts.
void along_axis(whirl_figure *figure, whirl_panel *panel, const drawing *of, const machine_along *along);

/// Returns the caption of the grey machine; "" if it is not drawn.
const char *along_caption(const machine_along *along);

/// Draws the machine in grey behind a panel whose vertical axis goes from -high to high: to scale along the axis, and
/// across as large as fits.
void along_machine(whirl_figure *figure, whirl_panel *panel, const machine_along *along, double high);

#endif
