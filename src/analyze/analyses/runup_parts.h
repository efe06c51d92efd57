/// Parts of the analysis of run-ups: its fields, and the results from the last turns of a run.
#ifndef ANALYZE_RUNUP_PARTS_H
#define ANALYZE_RUNUP_PARTS_H

#include "analysis.h"
#include "archive.h"
#include "runup/runup.h"

/// Fields of run-ups, in the order of the block.
enum {
    END,
    END_TIME,
    END_SPEED,
    END_TURNS,
    EVENTS,
    HAPPENED,
    NUMBERS_ERROR,
    SENSITIVITY,
    TIME,
    SPEED,
    TURNS,
    TORQUE,
    RADIUS,
    CENTRE,
    AMPLITUDE,
    LAG,
    WHIRL,
    PLACE,
    PEAK,
    PEAK_TIME,
    PEAK_SPEED,
    FORCE,
    SHARE,
    CONTACT,
    CONTACT_NUMBER,
    TORQUE_OF,
    TORQUE_EXTREME,
    TORQUE_COURSE,
    STATION_SPEED,
    SHAFT_END,
    SHAFT_TIME,
    SHAFT_SPEED,
    SHAFT_TURNS,
    SHAFT_TORQUE,
    SHAFT_AMPLITUDE,
    SHAFT_LAG,
    SHAFT_WHIRL,
    SPECTRUM_TIME,
    SPECTRUM_SPEED,
    SPECTRUM_ORDER,
    SPECTRUM,
    STATIONARY,
    FOLD,
    CYCLES,
    OPEN,
    DAMAGE,
    SLOW_ROLL,
    SLOW_ROLL_CHANGE,
    COMPENSATED,
    COMPENSATED_LAG,
    ORBIT_TIME,
    ORBIT_SPEED,
    ORBIT,
    ORBIT_INSTANT,
    ORBIT_FORCE,
    ORBIT_GAP,
    ORBIT_TORQUE,
    ORBIT_TORQUE_COURSE,
    ORBIT_SHAFT,
    ORBIT_SHAFT_TORQUE,
    ORBIT_SHAFT_SPEED,
    PEAK_ORBIT,
    WAVEFORM_TIME,
    WAVEFORM,
    CONTACT_TIME,
    CONTACT_FORCE,
    CONTACT_GAP,
    AXIAL,
    AXIAL_AMPLITUDE,
    AXIAL_LAG,
    AXIAL_EXTREME,
    AXIAL_TIME,
    AXIAL_SPEED,
    AXIAL_PLACE,
    AXIAL_SPECTRUM,
    AXIAL_ORBIT,
    AXIAL_WAVEFORM,
    TWIST,
    TWIST_AMPLITUDE,
    TWIST_LAG,
    TWIST_EXTREME,
    TWIST_TIME,
    TWIST_SPEED,
    TWIST_PLACE,
    TWIST_SPECTRUM,
    TWIST_ORBIT,
    TWIST_WAVEFORM,
    FIELD_COUNT
};

/// Returns the field of twists that corresponds to one of axial displacements for a motion of the latter kind, else
/// that of axial displacements.
static inline size_t runup_extra_field(const whirl_extra *extra, size_t axial) {
    return extra->twists ? axial + TWIST - AXIAL : axial;
}

/// Fills the fields of slow roll from rows that are complete. They stay missing if the run has no slow-roll speed; the
/// compensated fields also if the 1X changes too much.
void runup_fill_slow_roll(const block_view *view, const whirl_runup_options *options, size_t probes);

/// Spectra, orbits and waveforms of a run, from the samples of its last turns.
typedef struct runup_views {
    const block_view *view;
    const whirl_runup_options *options;
    const whirl_system *system;
    double duration;      ///< s, of the whole run
    bool clockwise;       ///< sense of rotation
    turn_samples samples; ///< of the present turn, axial displacements included; numbers are NULL if no view is wanted
    turn_history history;
    double *memory;         ///< x and y of a spectrum
    size_t spectra, orbits; ///< number of spectra and orbits that are filled, or whose time has passed
    size_t turns, events;   ///< complete turns, and turns with an event, so far
    double *largest;        ///< [probes + contacts] largest radius or force so far
    /// [WHIRL_RUNUP_WAVEFORMS][probes + contacts] turn whose end completes a waveform; 0: none.
    size_t *due;
} runup_views;

/// Maximum number of stationary speeds, and of folds.
enum { RUNUP_STATIONARY = 8 };

/// Finds the stationary speeds up to `highest`, rad/s, at which the drive's torque equals the torque that brakes the
/// shaft in small motions. They are searched between `count` speeds. Writes stationary [RUNUP_STATIONARY][3] as in the
/// field runup/stationary, and `folds` likewise. WHIRL_NO_MEMORY.
whirl_status runup_find_stationary(const whirl_resting *point, whirl_running *running, bool drag, size_t count,
                                   double highest, double *stationary, double *folds);

/// Classes of the ranges of torques.
enum { RUNUP_CLASSES = 32 };

/// Turning points of a torque over a run.
typedef struct runup_history {
    size_t count, capacity;
    double *values;
    bool full;                ///< there were more than can be kept
    bool idle;                ///< the torque was 0 at the last instant
    double began, time, open; ///< s: time of the first instant; time from there to the last instant; how much of this
                              ///< time was without torque
} runup_history;

/// Notes torques [torques] at a time, s, that follows the last one. Returns false without memory.
bool runup_cycles_note(runup_history *histories, size_t torques, double time, const double *torque);

/// Counts cycles by rain flow: out [torques][RUNUP_CLASSES][2] as in the field runup/cycles. Sums up the damage of
/// torques with an S-N curve: damage [torques][2] as in runup/damage. first: index of the first torque that is a path
/// of the system's torsion. WHIRL_NO_MEMORY.
whirl_status runup_cycles_count(const runup_history *histories, size_t torques, const whirl_system *system,
                                size_t first, double *out, double *damage);
/// Writes the turning points so far to an archive, or reads them from it.
void runup_cycles_archive(runup_history *histories, size_t torques, archive *a);

void runup_cycles_free(runup_history *histories, size_t torques);

/// Returns the number of bins of a spectrum of a run. Their orders are multiples of 1/spectrum_turns up to
/// highest_order.
size_t runup_bins(const whirl_runup_options *options);

/// Makes the views; nothing is kept if the options want none. watched: number of torques that are watched.
/// WHIRL_NO_MEMORY. Freed by runup_views_free.
whirl_status runup_views_new(const block_view *view, const whirl_runup_options *options, const whirl_system *system,
                             size_t contacts, size_t watched, double duration, runup_views *views);
void runup_views_free(runup_views *views);

/// Adds a turn. First fills the spectra and orbits whose time comes before its end. WHIRL_NO_MEMORY.
whirl_status runup_views_add(runup_views *views, const runup_turn *turn);

/// Writes the data on which views of later turns depend to an archive, or reads them from it.
void runup_views_archive(runup_views *views, archive *a);

/// Fills what is unfinished when the run ends at `time`. WHIRL_NO_MEMORY.
whirl_status runup_views_end(runup_views *views, double time);

#endif
