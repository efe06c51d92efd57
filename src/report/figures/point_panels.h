/// Panels that show one point at a station.
#ifndef REPORT_POINT_PANELS_H
#define REPORT_POINT_PANELS_H

#include "figure_build.h"
#include "machine_at.h"
#include "quantities.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

/// A point at a station, and its available data.
typedef struct subject {
    const whirl_result *result;
    const whirl_case *machine; ///< case of the result; NULL: none
    const whirl_table *table;
    size_t point, station;
    numbers waveform, section, spectrum, lines;
    /// Of the axial displacement: samples [rows][1]; bins and lines [rows][2], order and amplitude; without any if the
    /// station does not move along its shaft.
    numbers axial, axial_spectrum, axial_lines;
    numbers twist, twist_spectrum, twist_lines; ///< likewise of the twist of a station that also moves otherwise, rad
    machine_walls walls;                        ///< around the station
    machine_wall wall;                          ///< wall of its bearing
    size_t turn;                                ///< samples of the waveform in a revolution
    span x, y;   ///< range of the orbit (of the section without a waveform), in shown units
    double size; ///< larger of the ranges x and y, in shown units
    const whirl_shown_units *units;
    /// Factors from numbers of the result to displacements, amplitudes and frequencies as shown; order NaN: frequencies
    /// are shown as orders.
    double length, amplitude, order;
} subject;

/// Marks an orbit once a revolution with a keyphasor dot, where the shaft's mark is at the x axis: at the last instants
/// of `samples`, with `turn` instants a revolution. Adds an arrow head half a revolution before the last dot, in the
/// direction of motion. `length`: factor from samples to shown lengths; `size`: largest size of the arrow, which is
/// smaller on a small orbit.
void orbit_marks(whirl_figure *figure, whirl_panel *panel, const numbers *samples, size_t turn, double length,
                 double size, const char *colour, double dot);

/// Draws the wall of a bearing or seal, with its radii times `scale`, and returns the largest radius drawn.
double wall_line(whirl_figure *figure, whirl_panel *panel, const machine_wall *wall, double scale);

/// Draws the circle of a stator that may be touched, dashed; nothing for a radius of 0.
void stator_line(whirl_figure *figure, whirl_panel *panel, double radius);

/// add_half_spectrum: spectra of x and y over the order. add_full_spectrum: spectrum of x + iy, backward lines on the
/// left. add_lines: only the largest lines, if the whole spectrum was not stored.
void add_half_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of);
void add_full_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of);
void add_lines(whirl_figure *figure, whirl_panel *panel, const subject *of);

/// Draws the spectrum of the axial displacement, or its lines if the whole spectrum was not stored.
void add_axial_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of);

/// Draws that of the twist, likewise.
void add_twist_spectrum(whirl_figure *figure, whirl_panel *panel, const subject *of);

#endif
