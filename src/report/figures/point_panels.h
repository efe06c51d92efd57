/// Panels of one point at a station.
#ifndef REPORT_POINT_PANELS_H
#define REPORT_POINT_PANELS_H

#include "figure_build.h"
#include "quantities.h"
#include "report_parts.h"

/// A point at a station with what there is of it.
typedef struct subject {
    const whirl_result *result;
    const whirl_case *machine; ///< that it came from; NULL: none
    const whirl_table *table;
    size_t point, station;
    numbers waveform, section, spectrum, lines;
    machine_walls walls; ///< around the station
    machine_wall wall;   ///< of its bearing
    size_t turn;         ///< samples of the waveform a revolution
    span x, y;           ///< of the orbit, or of the section where there is no waveform; as shown
    double size;         ///< of the motion: the larger side of its box; as shown
    const whirl_shown_units *units;
    /// What numbers of the result are multiplied by to be shown: displacements, amplitudes, orders (NaN: they stay
    /// orders).
    double length, amplitude, order;
} subject;

/// Where an orbit is once a revolution, the last instants of `samples` with `turn` a revolution (the keyphasor's dots:
/// the shaft's mark is at the x axis), and an arrow head half a revolution before the last of them, the way it goes;
/// `length`: of one unit of the samples as shown, `size` of the arrow, which is smaller on a small orbit.
void orbit_marks(whirl_figure *figure, whirl_panel *panel, const numbers *samples, size_t turn, double length,
                 double size, const char *colour, double dot);

/// Spectra of x and y over the orders, and of x + iy, whose backward lines stand on the left; the largest of these
/// lines alone, where no whole spectrum was kept.
void add_half_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of);
void add_full_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of);
void add_lines(whirl_figure *figure, whirl_panel *panel, const subject *of);

#endif
