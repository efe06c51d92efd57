// Run-ups: motion, speed and torques of a machine while its speed changes, as rows at equal times.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "runup/run_motion.h"
#include "runup_parts.h"
#include "synchronous.h"
#include "whirl/engine/linear.h"

/// Columns of fields with two numbers at every order: of x and y, or of forward and backward motion.
enum { ORDER_COLUMNS = 2 * RUNUP_ORDERS };

static size_t runup_every_row(const block_shape *shape) {
    return (size_t)shape->options->runup.rows;
}

static size_t runup_every_row_of_axial(const block_shape *shape) {
    return rows_of_axial(shape) * runup_every_row(shape);
}

static size_t runup_every_row_of_twist(const block_shape *shape) {
    return rows_of_twist(shape) * runup_every_row(shape);
}

static size_t runup_every_torque(const block_shape *shape) {
    return whirl_runup_driven(&shape->options->runup) ? shape->torque_count : 0;
}
static size_t runup_every_torque_and_row(const block_shape *shape) {
    return runup_every_torque(shape) * runup_every_row(shape);
}
static size_t runup_every_torque_and_class(const block_shape *shape) {
    return runup_every_torque(shape) * RUNUP_CLASSES;
}
static size_t runup_every_row_with_torques(const block_shape *shape) {
    return runup_every_torque(shape) > 0 ? runup_every_row(shape) : 0;
}

static size_t runup_every_shaft(const block_shape *shape) {
    return (size_t)shape->options->runup.shaft_count;
}
static size_t runup_every_shaft_and_row(const block_shape *shape) {
    return runup_every_shaft(shape) * runup_every_row(shape);
}

/// Names of the elements with torques, by their number in the field of torques.
static const char *const torque_kinds[WHIRL_TORQUE_KINDS] = {[WHIRL_TORQUE_BETWEEN] = "twist",
                                                             [WHIRL_TORQUE_INDUCTION_MOTOR] = "induction_motor",
                                                             [WHIRL_TORQUE_SYNCHRONOUS_START] = "synchronous_start",
                                                             [WHIRL_TORQUE_SHORT_CIRCUIT] = "short_circuit",
                                                             [WHIRL_TORQUE_TIMED] = "timed_torque",
                                                             [WHIRL_TORQUE_MESH] = "gear",
                                                             [WHIRL_TORQUE_RIGID_GEAR] = "",
                                                             [WHIRL_TORQUE_WITH_PLAY] = "spring"};

static size_t runup_with_slow_roll(const block_shape *shape) {
    return shape->options->runup.slow_roll > 0.0 ? 1 : 0;
}

static size_t runup_every_row_with_slow_roll(const block_shape *shape) {
    return runup_with_slow_roll(shape) * runup_every_row(shape);
}

static size_t runup_every_orbit(const block_shape *shape) {
    return (size_t)shape->options->runup.orbits;
}

static size_t runup_every_instant_of_orbits(const block_shape *shape) {
    return runup_every_orbit(shape) * (size_t)shape->options->runup.samples;
}

static size_t runup_every_instant_of_orbits_with_drive(const block_shape *shape) {
    return whirl_runup_driven(&shape->options->runup) ? runup_every_instant_of_orbits(shape) : 0;
}

static size_t runup_every_torque_and_instant_of_orbits(const block_shape *shape) {
    return runup_every_torque(shape) * runup_every_instant_of_orbits(shape);
}

/// Returns the number of shafts whose torques are told apart within the turns of orbits.
static size_t runup_shafts_shown(const block_shape *shape) {
    const bool torques = whirl_runup_driven(&shape->options->runup) || shape->options->runup.shaft_count > 0;
    return torques && runup_every_orbit(shape) > 0 ? shape->run_shaft_count : 0;
}
static size_t runup_every_instant_of_shafts(const block_shape *shape) {
    return runup_shafts_shown(shape) * runup_every_instant_of_orbits(shape);
}
static size_t runup_with_shafts(const block_shape *shape) {
    return runup_shafts_shown(shape) > 0;
}

static size_t runup_every_instant_of_an_orbit(const block_shape *shape) {
    return runup_every_orbit(shape) > 0 ? (size_t)shape->options->runup.samples : 0;
}

static size_t runup_every_instant_of_waveforms(const block_shape *shape) {
    return WHIRL_RUNUP_WAVEFORMS * (size_t)shape->options->runup.waveform * (size_t)shape->options->runup.samples;
}

static size_t runup_every_spectrum(const block_shape *shape) {
    return (size_t)shape->options->runup.spectra;
}

static size_t runup_every_bin(const block_shape *shape) {
    return runup_bins(&shape->options->runup);
}

static size_t runup_every_bin_of_spectra(const block_shape *shape) {
    return runup_every_spectrum(shape) * runup_every_bin(shape);
}

static size_t runup_every_stationary(const block_shape *shape) {
    const whirl_runup_options *o = &shape->options->runup;
    const bool other = shape->torque_count > 0 || shape->twists || *o->torque_law || *o->load_law || o->shaft_count > 0;
    return !whirl_runup_driven(o) || o->stationary == 0 || other ? 0 : RUNUP_STATIONARY;
}

static size_t runup_every_bin_of_axial_spectra(const block_shape *shape) {
    return rows_of_axial(shape) * runup_every_bin_of_spectra(shape);
}
static size_t runup_every_instant_of_axial_orbits(const block_shape *shape) {
    return rows_of_axial(shape) * runup_every_instant_of_orbits(shape);
}
static size_t runup_every_instant_of_axial_waveforms(const block_shape *shape) {
    return rows_of_axial(shape) * runup_every_instant_of_waveforms(shape);
}

static size_t runup_every_bin_of_twist_spectra(const block_shape *shape) {
    return rows_of_twist(shape) * runup_every_bin_of_spectra(shape);
}
static size_t runup_every_instant_of_twist_orbits(const block_shape *shape) {
    return rows_of_twist(shape) * runup_every_instant_of_orbits(shape);
}
static size_t runup_every_instant_of_twist_waveforms(const block_shape *shape) {
    return rows_of_twist(shape) * runup_every_instant_of_waveforms(shape);
}

/// Columns of the field of events.
enum { EVENT_COLUMNS = 8 };

static size_t runup_every_event(const block_shape *shape) {
    const whirl_runup_options *o = &shape->options->runup;
    const whirl_system none = {.probe_count = 0};
    runup_happening own[RUNUP_EVENTS];
    return runup_events_of(o, &none, own) + (size_t)o->event_count;
}

static size_t runup_with_copy(const block_shape *shape) {
    return runup_wants_copy(&shape->options->runup, shape->contact_count) ? 1 : 0;
}

/// Names of the columns for four orders: of both axes, and of both circular parts.
#define OF_AXES "x1, y1, x2, y2, x3, y3, x4, y4"
#define OF_CIRCLES "forward1, backward1, forward2, backward2, forward3, backward3, forward4, backward4"

static const field_plan fields[FIELD_COUNT] = {
    [END] =
        {WHIRL_FIELD_RUNUP_END, "1",
         "how the run ended: 0 as planned, 1 the shaft stood still, 2 the motion left all bounds, 3 the solver could "
         "not go on",
         WHIRL_PER_POINT, 1, NULL},
    [END_TIME] = {WHIRL_FIELD_RUNUP_END_TIME, "s", "time at the end of the run", WHIRL_PER_POINT, 1, NULL},
    [END_SPEED] = {WHIRL_FIELD_RUNUP_END_SPEED, "rad/s", "speed of the shaft at the end of the run", WHIRL_PER_POINT, 1,
                   NULL},
    [END_TURNS] = {WHIRL_FIELD_RUNUP_END_TURNS, "1", "turns of the shaft in the run", WHIRL_PER_POINT, 1, NULL},
    [EVENTS] = {WHIRL_FIELD_RUNUP_EVENTS, "s",
                "trip, loss, change (when the motor tripped, when a blade was lost, and when parameters changed; "
                "missing: never)",
                WHIRL_PER_POINT, 3, NULL},
    [HAPPENED] =
        {WHIRL_FIELD_RUNUP_HAPPENED, "1",
         "time, speed, trip, loss, moment, angle, changes, end (of each event: s and rad/s when it happened, missing: "
         "never; 1 if the motor trips, 1 + k if that of shaft k with a speed of its own does; index of the station "
         "where an unbalance appears, -1: none, kg m and rad; 1 if "
         "parameters change; 1 if the run ends)",
         WHIRL_PER_POINT, EVENT_COLUMNS, runup_every_event},
    [NUMBERS_ERROR] =
        {WHIRL_FIELD_RUNUP_ERROR, "1",
         "error of coefficients that are interpolated between speeds, over the largest coefficient; 0: exact",
         WHIRL_PER_POINT, 1, NULL},
    [SENSITIVITY] =
        {WHIRL_FIELD_RUNUP_SENSITIVITY, "1",
         "growth, from, to, at (natural logarithm of the largest growth of a small change of the motion, and s between "
         "which it grew; s from which on a change as small as rtol counts for 0.001 of the motion, missing: never)",
         WHIRL_PER_POINT, 4, runup_with_copy},
    [TIME] = {WHIRL_FIELD_RUNUP_TIME, "s", "time of the row: the middle of its turn (missing where no turn ended)",
              WHIRL_PER_POINT, 1, runup_every_row},
    [SPEED] = {WHIRL_FIELD_RUNUP_SPEED, "rad/s", "speed of the shaft over the turn of the row", WHIRL_PER_POINT, 1,
               runup_every_row},
    [TURNS] = {WHIRL_FIELD_RUNUP_TURNS, "1", "turns of the shaft since the beginning, at the end of the row's turn",
               WHIRL_PER_POINT, 1, runup_every_row},
    [TORQUE] = {WHIRL_FIELD_RUNUP_TORQUE, "N m",
                "motor, load, friction, rotor, drag (on the shaft at the end of the turn, in the sense of the "
                "rotation; rotor: by "
                "unbalances that the motion and the weight turn; drag: of films and seals)",
                WHIRL_PER_POINT, RUNUP_SHAFT_TORQUES, runup_every_row},
    [RADIUS] = {WHIRL_FIELD_RUNUP_RADIUS, "length", "largest distance from the centre since the row before",
                WHIRL_PER_STATION, 1, runup_every_row},
    [CENTRE] = {WHIRL_FIELD_RUNUP_CENTRE, "length", "x, y (mean over the turn, from the centre)", WHIRL_PER_STATION, 2,
                runup_every_row},
    [AMPLITUDE] = {WHIRL_FIELD_RUNUP_AMPLITUDE, "length",
                   OF_AXES " (0-p amplitudes of x and y at 1 to 4 times the speed, over the turn)", WHIRL_PER_STATION,
                   ORDER_COLUMNS, runup_every_row},
    [LAG] = {WHIRL_FIELD_RUNUP_LAG, "deg", OF_AXES " (angles by which these peaks come after the mark)",
             WHIRL_PER_STATION, ORDER_COLUMNS, runup_every_row},
    [WHIRL] = {WHIRL_FIELD_RUNUP_WHIRL_AMPLITUDE, "length",
               OF_CIRCLES " (0-p amplitudes of "
                          "the circular parts of these motions, with and against the rotation)",
               WHIRL_PER_STATION, ORDER_COLUMNS, runup_every_row},
    [PLACE] = {WHIRL_FIELD_RUNUP_PLACE, "length", "x, y (at the end of the run, from the centre)", WHIRL_PER_STATION, 2,
               NULL},
    [PEAK] = {WHIRL_FIELD_RUNUP_PEAK, "length", "largest distance from the centre in the run", WHIRL_PER_STATION, 1,
              NULL},
    [PEAK_TIME] = {WHIRL_FIELD_RUNUP_PEAK_TIME, "s", "time of the largest distance from the centre", WHIRL_PER_STATION,
                   1, NULL},
    [PEAK_SPEED] = {WHIRL_FIELD_RUNUP_PEAK_SPEED, "rad/s", "speed of the shaft at that time", WHIRL_PER_STATION, 1,
                    NULL},
    [FORCE] = {WHIRL_FIELD_RUNUP_FORCE, "force", "largest normal force at any instant since the row before",
               WHIRL_PER_CONTACT, 1, runup_every_row},
    [SHARE] = {WHIRL_FIELD_RUNUP_SHARE, "1", "share of the turn in contact", WHIRL_PER_CONTACT, 1, runup_every_row},
    [CONTACT] = {WHIRL_FIELD_RUNUP_CONTACT, "s", "first, last, time (closed first, opened last, closed in all)",
                 WHIRL_PER_CONTACT, 3, NULL},
    [CONTACT_NUMBER] = {WHIRL_FIELD_RUNUP_CONTACT_NUMBER, "1", "number of times that the contact closed",
                        WHIRL_PER_CONTACT, 1, NULL},
    [TORQUE_OF] = {WHIRL_FIELD_RUNUP_TORQUE_OF, "1",
                   "kind, first, second (0 between the twists of two stations, 1 of an induction motor, 2 of a "
                   "synchronous start, 3 of a short circuit, 4 over time, 5 of a mesh, 7 of a spring with play; "
                   "indices of stations from 0, -1: the shaft as "
                   "a whole, or between stations)",
                   WHIRL_PER_POINT, 3, runup_every_torque},
    [TORQUE_EXTREME] = {WHIRL_FIELD_RUNUP_TORQUE_EXTREME, "1",
                        "largest, at, least, at (N m and s, of each torque in the run; located)", WHIRL_PER_POINT, 4,
                        runup_every_torque},
    [TORQUE_COURSE] = {WHIRL_FIELD_RUNUP_TORQUE_COURSE, "N m",
                       "least, largest (since the row before: all rows of the first torque, then of the next)",
                       WHIRL_PER_POINT, 2, runup_every_torque_and_row},
    [CYCLES] = {WHIRL_FIELD_RUNUP_CYCLES, "1",
                "range, number (N m, the upper end of a class of ranges; cycles of the torque in it by rain flow, ASTM "
                "E1049: all classes of the first torque, then of the next)",
                WHIRL_PER_POINT, 2, runup_every_torque_and_class},
    [OPEN] = {WHIRL_FIELD_RUNUP_OPEN, "1",
              "share of the run in which nothing carries the torque: of meshes and springs with play, within it",
              WHIRL_PER_POINT, 1, runup_every_torque},
    [DAMAGE] = {WHIRL_FIELD_RUNUP_DAMAGE, "1",
                "sum, beyond (Miner's sum of these cycles over the torque's S-N curve; 1: some ranges are above it, of "
                "which it says nothing, and the sum is missing; missing without a curve)",
                WHIRL_PER_POINT, 2, runup_every_torque},
    [STATION_SPEED] = {WHIRL_FIELD_RUNUP_STATION_SPEED, "rad/s",
                       "speed of the station at the end of the row, in the sense of its rotation", WHIRL_PER_STATION, 1,
                       runup_every_row_with_torques},
    [SHAFT_END] =
        {WHIRL_FIELD_RUNUP_SHAFT_END, "1",
         "speed, turns (rad/s and turns of each shaft with a speed of its own at the end of the run, along its "
         "rotation)",
         WHIRL_PER_POINT, 2, runup_every_shaft},
    [SHAFT_TIME] =
        {WHIRL_FIELD_RUNUP_SHAFT_TIME, "s",
         "time of the row: the middle of the last turn of a shaft with a speed of its own in the row (missing where "
         "none ended; all rows of the first shaft, then of the next)",
         WHIRL_PER_POINT, 1, runup_every_shaft_and_row},
    [SHAFT_SPEED] = {WHIRL_FIELD_RUNUP_SHAFT_SPEED, "rad/s", "speed of that shaft over that turn", WHIRL_PER_POINT, 1,
                     runup_every_shaft_and_row},
    [SHAFT_TURNS] = {WHIRL_FIELD_RUNUP_SHAFT_TURNS, "1",
                     "turns of that shaft since the beginning, at the end of that turn", WHIRL_PER_POINT, 1,
                     runup_every_shaft_and_row},
    [SHAFT_TORQUE] =
        {WHIRL_FIELD_RUNUP_SHAFT_TORQUE, "N m",
         "motor, load, friction, rotor, drag (on that shaft at the end of that turn, along its rotation; missing where "
         "a law gives its speed)",
         WHIRL_PER_POINT, RUNUP_SHAFT_TORQUES, runup_every_shaft_and_row},
    [SHAFT_AMPLITUDE] = {WHIRL_FIELD_RUNUP_SHAFT_AMPLITUDE, "length",
                         OF_AXES " (0-p amplitudes of x and y at 1 to 4 times the speed of that "
                                 "shaft, over that turn)",
                         WHIRL_PER_STATION, ORDER_COLUMNS, runup_every_shaft_and_row},
    [SHAFT_LAG] = {WHIRL_FIELD_RUNUP_SHAFT_LAG, "deg",
                   OF_AXES " (angles by which these peaks come after that shaft's mark)", WHIRL_PER_STATION,
                   ORDER_COLUMNS, runup_every_shaft_and_row},
    [SHAFT_WHIRL] = {WHIRL_FIELD_RUNUP_SHAFT_WHIRL, "length",
                     OF_CIRCLES " (0-p amplitudes "
                                "of the circular parts of these motions, with and against the rotation of that shaft)",
                     WHIRL_PER_STATION, ORDER_COLUMNS, runup_every_shaft_and_row},
    [SPECTRUM_TIME] = {WHIRL_FIELD_RUNUP_SPECTRUM_TIME, "s",
                       "time of the spectrum: the middle of its turns (missing before that many turns)",
                       WHIRL_PER_POINT, 1, runup_every_spectrum},
    [SPECTRUM_SPEED] = {WHIRL_FIELD_RUNUP_SPECTRUM_SPEED, "rad/s", "speed of the shaft over these turns",
                        WHIRL_PER_POINT, 1, runup_every_spectrum},
    [SPECTRUM_ORDER] = {WHIRL_FIELD_RUNUP_SPECTRUM_ORDER, "order", "orders of the bins of every spectrum",
                        WHIRL_PER_POINT, 1, runup_every_bin},
    [SPECTRUM] = {WHIRL_FIELD_RUNUP_SPECTRUM, "length",
                  "forward, backward (0-p amplitudes of x + iy at the orders; a row a bin, one spectrum after another)",
                  WHIRL_PER_STATION, 2, runup_every_bin_of_spectra},
    [STATIONARY] = {WHIRL_FIELD_RUNUP_STATIONARY, "1",
                    "speed, torque, holds (rad/s, N m: where the motor's torque equals the braking torques in small "
                    "motions; 1: the shaft stays there, 0: it leaves)",
                    WHIRL_PER_POINT, 3, runup_every_stationary},
    [FOLD] = {WHIRL_FIELD_RUNUP_FOLD, "1",
              "speed, factor, release (rad/s; by which the motor's torque must be multiplied for two stationary speeds "
              "to meet there; 1: a rising torque leaves the speed upwards, 0: a falling one downwards)",
              WHIRL_PER_POINT, 3, runup_every_stationary},
    [SLOW_ROLL] =
        {WHIRL_FIELD_RUNUP_SLOW_ROLL, "length",
         "x_cos, x_sin, y_cos, y_sin (parts of x and y at the speed of the slow roll, by the angle of the shaft)",
         WHIRL_PER_STATION, 4, runup_with_slow_roll},
    [SLOW_ROLL_CHANGE] =
        {WHIRL_FIELD_RUNUP_SLOW_ROLL_CHANGE, "1",
         "change of these parts within 10 % of the speed, over the largest of the run; above 0.05 they "
         "are no slow roll",
         WHIRL_PER_STATION, 1, runup_with_slow_roll},
    [COMPENSATED] = {WHIRL_FIELD_RUNUP_COMPENSATED, "length",
                     "x1, y1 (0-p amplitudes at the speed of the shaft, less the slow roll)", WHIRL_PER_STATION, 2,
                     runup_every_row_with_slow_roll},
    [COMPENSATED_LAG] = {WHIRL_FIELD_RUNUP_COMPENSATED_LAG, "deg",
                         "x1, y1 (angles by which these peaks come after the mark)", WHIRL_PER_STATION, 2,
                         runup_every_row_with_slow_roll},
    [ORBIT_TIME] = {WHIRL_FIELD_RUNUP_ORBIT_TIME, "s", "time of the orbit: the middle of its turn", WHIRL_PER_POINT, 1,
                    runup_every_orbit},
    [ORBIT_SPEED] = {WHIRL_FIELD_RUNUP_ORBIT_SPEED, "rad/s", "speed of the shaft over that turn", WHIRL_PER_POINT, 1,
                     runup_every_orbit},
    [ORBIT] = {WHIRL_FIELD_RUNUP_ORBIT, "length",
               "x, y (from the centre, at equal angles of a turn from the mark on, one orbit after another)",
               WHIRL_PER_STATION, 2, runup_every_instant_of_orbits},
    [ORBIT_INSTANT] = {WHIRL_FIELD_RUNUP_ORBIT_INSTANT, "s",
                       "times of the instants of orbits since the beginning of their turns, which is pi over the speed "
                       "of the orbit before its time",
                       WHIRL_PER_POINT, 1, runup_every_instant_of_orbits},
    [ORBIT_FORCE] = {WHIRL_FIELD_RUNUP_ORBIT_FORCE, "force", "normal force at the instants of orbits",
                     WHIRL_PER_CONTACT, 1, runup_every_instant_of_orbits},
    [ORBIT_GAP] = {WHIRL_FIELD_RUNUP_ORBIT_GAP, "length", "gap at the instants of orbits; below 0: pressed in",
                   WHIRL_PER_CONTACT, 1, runup_every_instant_of_orbits},
    [ORBIT_TORQUE] = {WHIRL_FIELD_RUNUP_ORBIT_TORQUE, "N m",
                      "motor, load, friction, rotor, drag (on the shaft at the instants of orbits, in the sense of the "
                      "rotation, as in runup/torque)",
                      WHIRL_PER_POINT, RUNUP_SHAFT_TORQUES, runup_every_instant_of_orbits_with_drive},
    [ORBIT_TORQUE_COURSE] = {WHIRL_FIELD_RUNUP_ORBIT_TORQUE_COURSE, "N m",
                             "torques of motors and shafts at the instants of orbits (all instants of the first torque "
                             "of runup/torque_of, then of the next)",
                             WHIRL_PER_POINT, 1, runup_every_torque_and_instant_of_orbits},
    [ORBIT_SHAFT] =
        {WHIRL_FIELD_RUNUP_ORBIT_SHAFT, "1",
         "shaft of the station in runup/orbit_shaft_torque: 0 that of the motor, or the rotor's; then those "
         "with a speed of their own; then those that gears join",
         WHIRL_PER_STATION, 1, runup_with_shafts},
    [ORBIT_SHAFT_TORQUE] =
        {WHIRL_FIELD_RUNUP_ORBIT_SHAFT_TORQUE, "N m",
         "motor, load, friction, rotor, drag, gears, inertia (on each shaft of a machine with several at the instants "
         "of orbits, in the sense of its rotation: all instants of the first shaft, then of the next; gears: what the "
         "balance leaves for them; inertia: about axes through centres of mass, times the acceleration, which is the "
         "sum of the others; missing where a law gives the speed, and of gears where a polar inertia is not given)",
         WHIRL_PER_POINT, RUNUP_SHAFT_PARTS, runup_every_instant_of_shafts},
    [ORBIT_SHAFT_SPEED] = {WHIRL_FIELD_RUNUP_ORBIT_SHAFT_SPEED, "rad/s",
                           "speeds of these shafts at the instants of orbits, along their rotation; where stations "
                           "twist their mean, weighted by inertia",
                           WHIRL_PER_POINT, 1, runup_every_instant_of_shafts},
    [PEAK_ORBIT] = {WHIRL_FIELD_RUNUP_PEAK_ORBIT, "length",
                    "x, y (as in the orbits, in the turn with the largest motion)", WHIRL_PER_STATION, 2,
                    runup_every_instant_of_an_orbit},
    [WAVEFORM_TIME] =
        {WHIRL_FIELD_RUNUP_WAVEFORM_TIME, "s",
         "times of the instants of a waveform: around the largest motion of the station, then around events",
         WHIRL_PER_STATION, 1, runup_every_instant_of_waveforms},
    [WAVEFORM] = {WHIRL_FIELD_RUNUP_WAVEFORM, "length", "x, y (from the centre, at these instants)", WHIRL_PER_STATION,
                  2, runup_every_instant_of_waveforms},
    [CONTACT_TIME] =
        {WHIRL_FIELD_RUNUP_CONTACT_TIME, "s",
         "times of the instants of a waveform: around the largest force of the contact, then around events",
         WHIRL_PER_CONTACT, 1, runup_every_instant_of_waveforms},
    [CONTACT_FORCE] = {WHIRL_FIELD_RUNUP_CONTACT_FORCE, "force", "normal force at these instants", WHIRL_PER_CONTACT, 1,
                       runup_every_instant_of_waveforms},
    [CONTACT_GAP] = {WHIRL_FIELD_RUNUP_CONTACT_GAP, "length", "gap at these instants; below 0: pressed in",
                     WHIRL_PER_CONTACT, 1, runup_every_instant_of_waveforms},
    [AXIAL] = {WHIRL_FIELD_RUNUP_AXIAL, "length",
               "mean, least, largest (axial displacement, in the direction of growing positions: mean over the turn, "
               "extremes since the row before; missing where the station does not move along its shaft)",
               WHIRL_PER_STATION, 3, runup_every_row_of_axial},
    [AXIAL_AMPLITUDE] = {WHIRL_FIELD_RUNUP_AXIAL_AMPLITUDE, "length",
                         "axial1, axial2, axial3, axial4 (0-p amplitudes of the axial displacement at 1 to 4 times the "
                         "speed, over the turn)",
                         WHIRL_PER_STATION, RUNUP_ORDERS, runup_every_row_of_axial},
    [AXIAL_LAG] = {WHIRL_FIELD_RUNUP_AXIAL_LAG, "deg",
                   "axial1, axial2, axial3, axial4 (angles by which these peaks come after the mark)",
                   WHIRL_PER_STATION, RUNUP_ORDERS, runup_every_row_of_axial},
    [AXIAL_EXTREME] = {WHIRL_FIELD_RUNUP_AXIAL_EXTREME, "length",
                       "least, largest (axial displacement in the run; located)", WHIRL_PER_STATION, 2, rows_of_axial},
    [AXIAL_TIME] = {WHIRL_FIELD_RUNUP_AXIAL_TIME, "s", "least, largest (times of these displacements)",
                    WHIRL_PER_STATION, 2, rows_of_axial},
    [AXIAL_SPEED] = {WHIRL_FIELD_RUNUP_AXIAL_SPEED, "rad/s", "least, largest (speeds of the shaft at these times)",
                     WHIRL_PER_STATION, 2, rows_of_axial},
    [AXIAL_PLACE] = {WHIRL_FIELD_RUNUP_AXIAL_PLACE, "length", "axial displacement at the end of the run",
                     WHIRL_PER_STATION, 1, rows_of_axial},
    [AXIAL_SPECTRUM] =
        {WHIRL_FIELD_RUNUP_AXIAL_SPECTRUM, "length",
         "0-p amplitudes of the axial displacement at the orders; a row a bin, one spectrum after another",
         WHIRL_PER_STATION, 1, runup_every_bin_of_axial_spectra},
    [AXIAL_ORBIT] = {WHIRL_FIELD_RUNUP_AXIAL_ORBIT, "length", "axial displacement at the instants of the orbits",
                     WHIRL_PER_STATION, 1, runup_every_instant_of_axial_orbits},
    [AXIAL_WAVEFORM] = {WHIRL_FIELD_RUNUP_AXIAL_WAVEFORM, "length",
                        "axial displacement at the instants of the station's waveforms", WHIRL_PER_STATION, 1,
                        runup_every_instant_of_axial_waveforms},
    [TWIST] = {WHIRL_FIELD_RUNUP_TWIST, "rad",
               "mean, least, largest (twist about the axis, positive from x towards y, relative to the mean turn: mean "
               "over the turn, extremes since the row before; missing where the station does not twist, or moves no "
               "other way)",
               WHIRL_PER_STATION, 3, runup_every_row_of_twist},
    [TWIST_AMPLITUDE] = {WHIRL_FIELD_RUNUP_TWIST_AMPLITUDE, "rad",
                         "twist1, twist2, twist3, twist4 (amplitudes of the twist at 1 to 4 times the speed, over "
                         "the turn)",
                         WHIRL_PER_STATION, RUNUP_ORDERS, runup_every_row_of_twist},
    [TWIST_LAG] = {WHIRL_FIELD_RUNUP_TWIST_LAG, "deg",
                   "twist1, twist2, twist3, twist4 (angles by which these peaks come after the mark)",
                   WHIRL_PER_STATION, RUNUP_ORDERS, runup_every_row_of_twist},
    [TWIST_EXTREME] = {WHIRL_FIELD_RUNUP_TWIST_EXTREME, "rad", "least, largest (twist in the run; located)",
                       WHIRL_PER_STATION, 2, rows_of_twist},
    [TWIST_TIME] = {WHIRL_FIELD_RUNUP_TWIST_TIME, "s", "least, largest (times of these twists)", WHIRL_PER_STATION, 2,
                    rows_of_twist},
    [TWIST_SPEED] = {WHIRL_FIELD_RUNUP_TWIST_SPEED, "rad/s", "least, largest (speeds of the shaft at these times)",
                     WHIRL_PER_STATION, 2, rows_of_twist},
    [TWIST_PLACE] = {WHIRL_FIELD_RUNUP_TWIST_PLACE, "rad", "twist at the end of the run", WHIRL_PER_STATION, 1,
                     rows_of_twist},
    [TWIST_SPECTRUM] = {WHIRL_FIELD_RUNUP_TWIST_SPECTRUM, "rad",
                        "amplitudes of the twist at the orders; a row a bin, one spectrum after another",
                        WHIRL_PER_STATION, 1, runup_every_bin_of_twist_spectra},
    [TWIST_ORBIT] = {WHIRL_FIELD_RUNUP_TWIST_ORBIT, "rad", "twist at the instants of the orbits", WHIRL_PER_STATION, 1,
                     runup_every_instant_of_twist_orbits},
    [TWIST_WAVEFORM] = {WHIRL_FIELD_RUNUP_TWIST_WAVEFORM, "rad", "twist at the instants of the station's waveforms",
                        WHIRL_PER_STATION, 1, runup_every_instant_of_twist_waveforms},
};

/// State of filling the rows of a run.
typedef struct filling {
    const block_view *view;
    const whirl_resting *point;
    const whirl_system *system;
    size_t rows, contacts, torques;
    double duration, way;
    double *radius, *force; ///< [probes], [contacts] largest since the row before
    double *extra;          ///< [extra_count][2] least and largest axial displacement or twist since the row before
    size_t row;             ///< row of the last turn
    runup_views views;
    runup_history *histories; ///< [torques]
    whirl_status status;      ///< status of the views and histories
    bool stale;               ///< the saved state of the run does not fit
} filling;

static double *runup_at_row(const filling *f, size_t field, size_t which, size_t columns) {
    return view_numbers(f->view, field, which) + f->row * columns;
}

/// Fields of the amplitudes, lags and whirls of the orders of a shaft.
typedef enum order_field { ORDER_AMPLITUDE, ORDER_LAG, ORDER_WHIRL, ORDER_FIELDS } order_field;

/// Fills in the orders of a station over a turn, at a row of these fields. clockwise: forward whirl of the shaft goes
/// round from y to x.
static void runup_fill_orders(const filling *f, const runup_station *own, size_t probe, double radius, bool clockwise,
                              const size_t fields_of[ORDER_FIELDS], size_t row) {
    double *out[ORDER_FIELDS];
    for (size_t i = 0; i < ORDER_FIELDS; i++) out[i] = view_numbers(f->view, fields_of[i], probe) + row * ORDER_COLUMNS;
    for (size_t k = 0; k < RUNUP_ORDERS; k++) {
        const whirl_synchronous part = synchronous_of(own->x[k], own->y[k], radius);
        for (size_t i = 0; i < 2; i++) {
            out[ORDER_AMPLITUDE][2 * k + i] = part.amplitude[i];
            out[ORDER_LAG][2 * k + i] = part.lag[i];
            out[ORDER_WHIRL][2 * k + i] = part.amplitude[clockwise ? 3 - i : 2 + i];
        }
    }
}

static void runup_fill_station(const filling *f, const runup_turn *turn, size_t probe) {
    static const size_t orders[] = {AMPLITUDE, LAG, WHIRL};
    const runup_station *own = &turn->stations[probe];
    memcpy(runup_at_row(f, CENTRE, probe, 2), own->mean, sizeof own->mean);
    runup_fill_orders(f, own, probe, own->radius, f->way < 0.0, orders, f->row);
}

/// Fills in the axial displacement or twist of a station over a turn. `index`: of whirl_system.extras.
static void runup_fill_extra(const filling *f, const runup_turn *turn, size_t index) {
    const runup_station *own = &turn->stations[f->system->probe_count + index];
    const whirl_extra *extra = &f->system->extras[index];
    const size_t station = extra->station;
    double *extremes = f->extra + 2 * index, *row = runup_at_row(f, runup_extra_field(extra, AXIAL), station, 3);
    row[1] = extremes[0] = fmin(extremes[0], own->least);
    row[2] = extremes[1] = fmax(extremes[1], own->largest);
    if (!turn->whole) return;
    row[0] = own->mean[0];
    for (size_t k = 0; k < RUNUP_ORDERS; k++) {
        const double size = fmax(fabs(own->least), fabs(own->largest));
        const whirl_synchronous part = synchronous_of(own->x[k], own->y[k], size);
        runup_at_row(f, runup_extra_field(extra, AXIAL_AMPLITUDE), station, RUNUP_ORDERS)[k] = part.amplitude[0];
        runup_at_row(f, runup_extra_field(extra, AXIAL_LAG), station, RUNUP_ORDERS)[k] = part.lag[0];
    }
}

/// Fills in the torques on a shaft at a row of a field.
static void runup_fill_torque_row(const filling *f, size_t field, size_t row, const whirl_torques *of) {
    runup_list_torques(of, view_numbers(f->view, field, 0) + row * RUNUP_SHAFT_TORQUES);
}

static size_t runup_row_at(const filling *f, double time) {
    const double place = time / f->duration * (double)f->rows;
    return place >= (double)f->rows ? f->rows - 1 : place > 0.0 ? (size_t)place : 0;
}

static void runup_fill_torques(void *context, double time, const double *torque, const double *speed) {
    filling *f = context;
    const size_t row = runup_row_at(f, time);
    if (!runup_cycles_note(f->histories, f->torques, time, torque))
        f->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the torques of a run");
    for (size_t t = 0; t < f->torques; t++) {
        double *own = view_numbers(f->view, TORQUE_COURSE, 0) + 2 * (t * f->rows + row);
        own[0] = fmin(own[0], torque[t]); // fmin and fmax ignore a NaN
        own[1] = fmax(own[1], torque[t]);
    }
    for (size_t p = 0; p < f->system->probe_count; p++) view_numbers(f->view, STATION_SPEED, p)[row] = speed[p];
}

static void runup_fill_row(void *context, const runup_turn *turn) {
    // Extremes of a row are those since the row before; a new row begins at 0.
    filling *f = context;
    if (f->status.code == WHIRL_OK) f->status = runup_views_add(&f->views, turn);
    const size_t probes = f->system->probe_count;
    const size_t row = runup_row_at(f, turn->end);
    if (row != f->row || isnan(*runup_at_row(f, TIME, 0, 1))) {
        for (size_t p = 0; p < probes; p++) f->radius[p] = 0.0;
        for (size_t i = 0; i < f->system->extra_count; i++)
            f->extra[2 * i] = (double)INFINITY, f->extra[2 * i + 1] = -(double)INFINITY;
        for (size_t c = 0; c < f->contacts; c++) f->force[c] = 0.0;
    }
    f->row = row;
    // Fill in stations and contacts.
    for (size_t p = 0; p < probes; p++) {
        f->radius[p] = fmax(f->radius[p], turn->stations[p].radius);
        *runup_at_row(f, RADIUS, p, 1) = f->radius[p];
        if (turn->whole) runup_fill_station(f, turn, p);
    }
    for (size_t i = 0; i < f->system->extra_count; i++) runup_fill_extra(f, turn, i);
    for (size_t c = 0; c < f->contacts; c++) {
        f->force[c] = fmax(f->force[c], turn->force[c]);
        *runup_at_row(f, FORCE, c, 1) = f->force[c];
        *runup_at_row(f, SHARE, c, 1) = turn->share[c];
    }
    // Fill in place and torques at the end of the turn.
    *runup_at_row(f, TIME, 0, 1) = turn->time;
    *runup_at_row(f, SPEED, 0, 1) = turn->speed;
    *runup_at_row(f, TURNS, 0, 1) = turn->turns;
    runup_fill_torque_row(f, TORQUE, f->row, &turn->torques);
    if (f->point->passed) f->point->passed(f->point->watcher, turn->end, fmin(turn->end / f->duration, 1.0));
}

static void runup_fill_spool_row(void *context, const runup_spool_turn *turn) {
    static const size_t orders[] = {SHAFT_AMPLITUDE, SHAFT_LAG, SHAFT_WHIRL};
    const filling *f = context;
    const size_t at = turn->spool * f->rows + runup_row_at(f, turn->end);
    const bool clockwise = f->way * f->system->spools[turn->spool].sense < 0.0;
    if (!view_numbers(f->view, SHAFT_TIME, 0)) return;
    for (size_t p = 0; p < f->system->probe_count; p++)
        runup_fill_orders(f, &turn->stations[p], p, f->radius[p], clockwise, orders, at);
    view_numbers(f->view, SHAFT_TIME, 0)[at] = turn->time;
    view_numbers(f->view, SHAFT_SPEED, 0)[at] = turn->speed;
    view_numbers(f->view, SHAFT_TURNS, 0)[at] = turn->turns;
    runup_fill_torque_row(f, SHAFT_TORQUE, at, &turn->torques);
}

// ---------------------------------------------------------------- runs that are saved

/// Archives (saves or restores) everything that the rest of a run depends on: the numbers filled in, and the state of
/// the run.
static void runup_archive_filling(filling *f, runup_state *state, archive *a) {
    for (size_t k = 0; k < FIELD_COUNT; k++) {
        const whirl_field *field = f->view->fields[k];
        if (field)
            archive_part(a, view_numbers(f->view, k, 0),
                         field->repeat * field->rows * field->columns * sizeof *f->view->block);
    }
    archive_part(a, f->radius, f->system->probe_count * sizeof *f->radius);
    archive_part(a, f->force, f->contacts * sizeof *f->force);
    archive_part(a, f->extra, 2 * f->system->extra_count * sizeof *f->extra);
    archive_count(a, &f->row, f->rows);
    runup_views_archive(&f->views, a);
    if (f->point->motion) run_motion_archive(f->point->motion, a);
    runup_cycles_archive(f->histories, f->torques, a);
    runup_archive(state, a);
}

/// Saves a run after a turn if it is time to. A failure is not an error.
static void runup_save(void *context, runup_state *state) {
    filling *f = context;
    const whirl_saving *to = f->point->saving;
    if (!to || !to->due || f->status.code != WHIRL_OK || !to->due(to->context)) return;
    archive a = {.way = ARCHIVE_MEASURE, .sound = true};
    runup_archive_filling(f, state, &a);
    a = (archive){ARCHIVE_WRITE, malloc(a.at), a.at, 0, true};
    if (!a.bytes) return;
    runup_archive_filling(f, state, &a);
    if (a.sound) to->save(to->context, runup_turns_of(state), a.bytes, a.size);
    free(a.bytes);
}

/// Continues a run from its saved state. Returns false if the saved state does not fit the run.
static bool runup_restore(void *context, runup_state *state) {
    filling *f = context;
    const whirl_saving *from = f->point->saving;
    archive a = {ARCHIVE_READ, from->saved, from->saved_size, 0, true};
    runup_archive_filling(f, state, &a);
    f->stale = !a.sound || a.at != a.size;
    return !f->stale;
}

/// Empties all numbers of a run.
static void runup_empty(const block_view *view) {
    for (size_t k = 0; k < FIELD_COUNT; k++) {
        const whirl_field *field = view->fields[k];
        for (size_t i = 0; field && i < field->repeat * field->rows * field->columns; i++)
            view_numbers(view, k, 0)[i] = NAN;
    }
}

// ---------------------------------------------------------------- the run

/// Returns the highest speed that the run may reach, which determines how many numbers it has.
static double runup_highest_speed(const whirl_resting *point, const whirl_runup_options *o) {
    double highest = fmax(o->from, o->to);
    if (*o->speeds) {
        for (size_t i = 0; i < point->course->speed_count; i++) highest = fmax(highest, point->course->speeds[i]);
        return highest;
    }
    if (o->rate > 0.0 && o->to == 0.0) return o->from + o->rate * o->duration;
    return whirl_runup_driven(o) && !*o->torque_law ? fmax(highest, point->drive_speed) : highest;
}

/// Returns the lowest speed that the run may have: a drive may let it fall to standstill.
static double runup_lowest_speed(const whirl_resting *point, const whirl_runup_options *o) {
    double lowest = o->from;
    if (*o->rate_law) return 0.0;
    for (size_t i = 0; *o->speeds && i < point->course->speed_count; i++)
        lowest = fmin(lowest, point->course->speeds[i]);
    if (*o->speeds) return lowest;
    return o->rate > 0.0 && o->to == 0.0 ? o->from : fmin(o->from, o->to);
}

/// Returns the course of shaft k with a speed of its own. A shaft without a course keeps the speed that its key gives.
static whirl_spool_course runup_spool_course(const whirl_resting *point, size_t k) {
    const double speed = point->system->spools[k].speed;
    if (point->course && k < point->course->spool_count) return point->course->spools[k];
    return (whirl_spool_course){.law = WHIRL_SPOOL_RATE, .from = speed, .highest = speed};
}

/// Finds the state at which the run begins: start [*count], displacements, and velocities divided by `unit`, the unit
/// of speed in rad/s.
static whirl_status runup_find_start(const whirl_resting *point, const whirl_runup_options *o, double unit,
                                     double *start, size_t *count) {
    whirl_machine machine;
    const double from = o->from > 0.0 ? o->from : unit / 256.0;
    double spools[WHIRL_MAX_SPOOLS] = {0.0};
    for (size_t k = 0; k < point->system->spool_count; k++) {
        const whirl_spool_course own = runup_spool_course(point, k);
        spools[k] = own.from > 0.0 ? own.from : own.highest / 256.0;
    }
    whirl_status status = point->system->spool_count > 0
                              ? point->at_speeds(point->context, from, spools, &machine)
                              : point->at_speed(point->context, from, WHIRL_AS_GIVEN, 0.0, &machine);
    if (status.code != WHIRL_OK) return status;
    const size_t d = *count = machine.system->dimension;
    if (strcmp(o->begin, "centre") != 0) {
        memcpy(start, machine.start, d * sizeof *start);
        status = whirl_equilibrium(machine.system, start);
    }
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// Returns the index of the first watched torque that is a path of the machine's torsion; torques on stations come
/// before.
static size_t runup_first_path(const whirl_running *running, const whirl_system *system) {
    size_t paths = 0;
    for (size_t k = 0; system->torsion && k < system->torsion->path_count; k++) {
        whirl_torque_path path;
        system->torsion->path(system->model, k, &path);
        paths += path.kind != WHIRL_TORQUE_RIGID_GEAR;
    }
    return running->watched_count - paths;
}

static void runup_fill_extremes(const filling *f, const whirl_running *running, const runup_run *run) {
    for (size_t t = 0; t < f->torques; t++) {
        const char *name;
        size_t station[2];
        double *of = view_numbers(f->view, TORQUE_OF, 0) + 3 * t;
        double *extreme = view_numbers(f->view, TORQUE_EXTREME, 0) + 4 * t;
        running->watched(running, t, station, &name);
        for (size_t k = 0; k < WHIRL_TORQUE_KINDS; k++)
            if (strcmp(name, torque_kinds[k]) == 0) of[0] = (double)k;
        for (size_t end = 0; end < 2; end++)
            of[1 + end] = station[end] < f->system->probe_count ? (double)station[end] : -1.0;
        if (!isfinite(run->torques[t].largest.value)) continue;
        if (of[0] >= WHIRL_TORQUE_MESH && f->histories[t].time > 0.0)
            view_numbers(f->view, OPEN, 0)[t] = f->histories[t].open / f->histories[t].time;
        extreme[0] = run->torques[t].largest.value, extreme[1] = run->torques[t].largest.time;
        extreme[2] = run->torques[t].least.value, extreme[3] = run->torques[t].least.time;
    }
}

/// Fills in when each event happened, and when the first trip, loss and change of parameters did.
static void runup_fill_events(const block_view *view, const runup_run *run) {
    double *first = view_numbers(view, EVENTS, 0);
    for (size_t k = 0; k < run->event_count; k++) {
        const runup_happening *own = &run->events[k];
        const bool lost = own->is.lost.moment > 0.0, is[] = {own->is.trip, lost, own->is.changes};
        const double row[EVENT_COLUMNS] = {own->time,
                                           own->at,
                                           own->is.trip ? 1.0 + (double)own->is.spool : 0.0,
                                           lost ? (double)own->is.lost.station : -1.0,
                                           lost ? own->is.lost.moment : (double)NAN,
                                           lost ? own->is.lost.angle : (double)NAN,
                                           own->is.changes,
                                           own->is.end};
        memcpy(view_numbers(view, HAPPENED, 0) + k * EVENT_COLUMNS, row, sizeof row);
        for (size_t i = 0; i < 3; i++)
            if (is[i] && !(first[i] <= own->time)) first[i] = own->time;
    }
}

static void runup_fill_end(const filling *f, const runup_run *run) {
    // Fill in where and why the run ended.
    const block_view *view = f->view;
    *view_numbers(view, END, 0) = (double)run->end;
    *view_numbers(view, END_TIME, 0) = run->time;
    *view_numbers(view, END_SPEED, 0) = run->speed;
    *view_numbers(view, END_TURNS, 0) = run->turns;
    *view_numbers(view, NUMBERS_ERROR, 0) = run->error;
    for (size_t k = 0; k < f->system->spool_count && view_numbers(view, SHAFT_END, 0); k++) {
        view_numbers(view, SHAFT_END, 0)[2 * k] = run->spool_speed[k];
        view_numbers(view, SHAFT_END, 0)[2 * k + 1] = run->spool_turns[k];
    }
    double *sensitivity = view_numbers(view, SENSITIVITY, 0);
    if (sensitivity) memcpy(sensitivity, run->sensitivity, sizeof run->sensitivity);
    runup_fill_events(view, run);
    // Fill in the last position and the peak of each station, and the numbers of each contact.
    for (size_t p = 0; p < f->system->probe_count; p++) {
        for (size_t axis = 0; axis < 2; axis++)
            view_numbers(view, PLACE, p)[axis] = whirl_probe_value(&f->system->probes[p], run->last, axis);
        *view_numbers(view, PEAK, p) = run->peaks[p].radius;
        *view_numbers(view, PEAK_TIME, p) = run->peaks[p].time;
        *view_numbers(view, PEAK_SPEED, p) = run->peaks[p].speed;
    }
    const runup_peak *peak = run->peaks + f->system->probe_count;
    for (size_t i = 0; i < f->system->extra_count; i++) {
        const whirl_extra *extra = &f->system->extras[i];
        const size_t station = extra->station;
        const whirl_probe *probe = &f->system->probes[f->system->probe_count + i];
        *view_numbers(view, runup_extra_field(extra, AXIAL_PLACE), station) = whirl_probe_value(probe, run->last, 0);
        for (size_t side = 0; side < 2; side++, peak++) {
            if (!isfinite(peak->radius)) continue;
            view_numbers(view, runup_extra_field(extra, AXIAL_EXTREME), station)[side] =
                side == 0 ? -peak->radius : peak->radius;
            view_numbers(view, runup_extra_field(extra, AXIAL_TIME), station)[side] = peak->time;
            view_numbers(view, runup_extra_field(extra, AXIAL_SPEED), station)[side] = peak->speed;
        }
    }
    for (size_t c = 0; c < f->contacts; c++) {
        double *contact = view_numbers(view, CONTACT, c);
        const runup_contact *own = &run->contacts[c];
        contact[0] = own->first, contact[1] = own->last, contact[2] = own->time;
        *view_numbers(view, CONTACT_NUMBER, c) = own->count;
    }
}

/// Input for making the machine after events.
typedef struct changing {
    const whirl_resting *point;
    double lowest, highest;
    bool driven;
    whirl_spool_range spools[WHIRL_MAX_SPOOLS];
} changing;

static whirl_status runup_make_machine(const void *context, size_t count, const unsigned char *happened,
                                       whirl_running **running) {
    const changing *c = context;
    return c->point->running(c->point->context, c->lowest, c->highest, c->driven, c->spools, count, happened, running);
}

/// Returns the options of a run, with the first and last speed of its table of speeds if it has one.
static whirl_runup_options runup_with_table(const whirl_resting *point, const whirl_runup_options *options) {
    whirl_runup_options o = *options;
    const whirl_run_course *course = point->course;
    if (!course || course->speed_count == 0) return o;
    o.from = course->speeds[0];
    if (o.duration == 0.0) o.duration = course->speed_times[course->speed_count - 1];
    return o;
}

/// The run of a point, and all that it needs.
typedef struct runup_job {
    changing make;
    whirl_runup_options options;
    const block_view *view;
    whirl_running *running;
    double *numbers; ///< memory of run.last, plan.start, f.radius, f.force and f.extra
    runup_run run;
    runup_happening events[RUNUP_EVENTS];
    filling f;
    runup_plan plan;
    whirl_status status;
} runup_job;

/// Makes the machine of a point.
static void runup_job_open(runup_job *job, const whirl_resting *point, const whirl_runup_options *options,
                           const block_view *view) {
    job->options = runup_with_table(point, options);
    const whirl_runup_options *o = &job->options;
    job->make = (changing){.point = point,
                           .lowest = runup_lowest_speed(point, o),
                           .highest = runup_highest_speed(point, o),
                           .driven = whirl_runup_driven(o)};
    for (size_t k = 0; k < point->system->spool_count; k++) {
        const whirl_spool_course own = runup_spool_course(point, k);
        job->make.spools[k] = (whirl_spool_range){own.highest, own.law == WHIRL_SPOOL_DRIVEN};
    }
    job->view = view;
    job->status = runup_make_machine(&job->make, 0, NULL, &job->running);
}

static void runup_job_close(runup_job *job) {
    if (job->running) job->running->release(job->running);
}

/// Prepares the run of a machine, from the saved state of the point if `resume`.
static void runup_job_begin(runup_job *job, bool resume) {
    const whirl_runup_options *o = &job->options;
    const whirl_resting *point = job->make.point;
    const whirl_running *running = job->running;
    const whirl_system *system = running->by_angle;
    const size_t d = system->dimension, probes = system->probe_count, contacts = running->contact_count;
    const size_t torques = running->in_time ? running->watched_count : 0;
    job->numbers = calloc(2 * d + probes + contacts + 2 * system->extra_count + 1, sizeof *job->numbers);
    job->run = (runup_run){.peaks = calloc(probes + 2 * system->extra_count + 1, sizeof(runup_peak)),
                           .contacts = calloc(contacts + 1, sizeof(runup_contact)),
                           .torques = calloc(torques + 1, sizeof(runup_torque)),
                           .events = job->events,
                           .last = job->numbers};
    job->f = (filling){.view = job->view,
                       .point = point,
                       .system = system,
                       .rows = (size_t)o->rows,
                       .contacts = contacts,
                       .torques = torques,
                       .way = 1.0,
                       .histories = calloc(torques + 1, sizeof(runup_history)),
                       .status = whirl_ok()};
    job->plan = (runup_plan){.options = o,
                             .course = point->course,
                             .change = runup_make_machine,
                             .change_context = &job->make,
                             .integrate = whirl_integrate_default(),
                             .angle = o->angle,
                             .see = runup_fill_row,
                             .see_spool = runup_fill_spool_row,
                             .watch = runup_fill_torques,
                             .context = &job->f,
                             .turned = runup_save,
                             .resume = resume ? runup_restore : NULL};
    filling *f = &job->f;
    runup_plan *plan = &job->plan;
    if (!job->numbers || !job->run.peaks || !job->run.contacts || !job->run.torques || !f->histories) {
        job->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a run");
        return;
    }
    f->radius = job->numbers + 2 * d;
    f->force = f->radius + probes;
    f->extra = f->force + contacts;
    f->duration = whirl_runup_duration(o);
    if (probes > 0) f->way = whirl_probe_way(&system->probes[0]);
    plan->start = job->numbers + d;
    plan->integrate.rtol = o->rtol;
    plan->integrate.atol = o->atol > 0.0 ? o->atol : 1e-3 * o->rtol;
    plan->integrate.limit = 1e300; // time grows without bounds; a motion diverges when it is no longer finite
    memcpy(plan->integrate.method, o->method, sizeof plan->integrate.method);
    job->status = runup_find_start(point, o, job->make.highest, job->numbers + d, &plan->start_count);
    if (job->status.code == WHIRL_OK)
        job->status = runup_views_new(job->view, o, system, contacts, torques, f->duration, &f->views);
    if (f->views.samples.numbers) plan->samples = &f->views.samples;
    plan->motion = point->motion;
}

/// Fills in the results of a run that is over, and frees what runup_job_begin allocated.
static void runup_job_end(runup_job *job) {
    filling *f = &job->f;
    runup_run *run = &job->run;
    const whirl_system *system = job->make.point->system;
    whirl_status status = job->status;
    if (status.code == WHIRL_OK && run->end == RUNUP_STOPPED) status = whirl_fail(WHIRL_STOPPED, "stopped");
    if (status.code == WHIRL_OK) status = f->status;
    if (status.code == WHIRL_OK) status = runup_views_end(&f->views, run->time);
    if (status.code == WHIRL_OK) runup_fill_end(f, run);
    if (status.code == WHIRL_OK) runup_fill_slow_roll(job->view, &job->options, f->system->probe_count);
    if (status.code == WHIRL_OK) runup_fill_extremes(f, job->running, run);
    for (size_t s = 0; s < f->system->probe_count && f->views.samples.shafts > 0; s++)
        *view_numbers(f->view, ORBIT_SHAFT, s) = (double)job->running->shaft_of[s];
    if (status.code == WHIRL_OK && f->torques > 0)
        status = runup_cycles_count(f->histories, f->torques, system, runup_first_path(job->running, system),
                                    view_numbers(job->view, CYCLES, 0), view_numbers(job->view, DAMAGE, 0));
    job->status = status;
    runup_cycles_free(f->histories, f->torques);
    runup_views_free(&f->views);
    free(job->numbers);
    free(run->peaks);
    free(run->contacts);
    free(run->torques);
}

/// Runs the machines of jobs that are begun.
static void runup_jobs_run(runup_job *jobs, size_t count) {
    runup_task *tasks = calloc(count + 1, sizeof *tasks);
    size_t begun = 0;
    for (size_t i = 0; i < count && tasks; i++)
        if (jobs[i].status.code == WHIRL_OK)
            tasks[begun++] = (runup_task){jobs[i].running, &jobs[i].plan, &jobs[i].run, whirl_ok()};
    if (tasks) runup_carry_together(begun, tasks);
    for (size_t i = 0, task = 0; i < count; i++)
        if (jobs[i].status.code == WHIRL_OK)
            jobs[i].status = tasks ? tasks[task++].status : whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
    free(tasks);
}

// ---------------------------------------------------------------- measured runs

/// Returns the speed of a measured turn, rad/s.
static double runup_measured_speed(const whirl_measured *m, size_t n) {
    return 2.0 * acos(-1.0) / (m->end[n] - m->time[n * m->samples]);
}

/// Evaluates a measured turn: means, orders and largest radii of all stations, the largest radii of the run so far, and
/// samples for spectra and orbits.
static void runup_read_turn(const filling *f, const whirl_measured *m, size_t n, runup_station *stations) {
    const size_t probes = f->system->probe_count;
    for (size_t p = 0; p < probes; p++) {
        const double *x = m->x + (p * m->turns + n) * m->samples, *y = m->y + (p * m->turns + n) * m->samples;
        stations[p] = (runup_station){.radius = 0.0};
        for (size_t k = 0; k < m->samples; k++) {
            const double share = 1.0 / (double)m->samples, angle = 2.0 * acos(-1.0) * (double)k * share;
            const double radius = hypot(x[k], y[k]);
            double *peak = view_numbers(f->view, PEAK, p); // missing before the first sample
            if (!(radius <= *peak)) {
                *peak = radius;
                *view_numbers(f->view, PEAK_TIME, p) = m->time[n * m->samples + k];
                *view_numbers(f->view, PEAK_SPEED, p) = runup_measured_speed(m, n);
            }
            stations[p].radius = fmax(stations[p].radius, radius);
            stations[p].mean[0] += share * x[k];
            stations[p].mean[1] += share * y[k];
            for (size_t order = 1; order <= RUNUP_ORDERS; order++) {
                const double complex turned = 2.0 * share * cexp(-I * (double)order * angle);
                stations[p].x[order - 1] += turned * x[k];
                stations[p].y[order - 1] += turned * y[k];
            }
            if (f->views.samples.numbers) {
                double *row = f->views.samples.numbers + k * f->views.samples.width;
                row[0] = m->time[n * m->samples + k];
                row[1 + 2 * p] = x[k];
                row[2 + 2 * p] = y[k];
            }
        }
    }
}

/// Fills the rows of a run from a measured record instead of a computed motion.
static whirl_status runup_fill_measured(const whirl_resting *point, const whirl_runup_options *o,
                                        const block_view *view) {
    // Make memory for turns.
    const whirl_measured *m = point->measured;
    const size_t probes = point->system->probe_count;
    double *radius = calloc(probes + 1, sizeof *radius);
    runup_station *stations = calloc(probes + 1, sizeof *stations);
    filling f = {.view = view,
                 .point = point,
                 .system = point->system,
                 .rows = (size_t)o->rows,
                 .duration = o->duration,
                 .way = 1.0,
                 .radius = radius,
                 .status = whirl_ok()};
    whirl_status status =
        radius && stations ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the turns of a record");
    if (status.code == WHIRL_OK) status = runup_views_new(view, o, point->system, 0, 0, f.duration, &f.views);
    // Treat each turn of the record like a turn of a computed run; a record has no torques.
    for (size_t n = 0; n < m->turns && status.code == WHIRL_OK; n++) {
        const double begin = m->time[n * m->samples], end = m->end[n];
        runup_read_turn(&f, m, n, stations);
        const runup_turn turn = {.time = 0.5 * (begin + end),
                                 .speed = runup_measured_speed(m, n),
                                 .end = end,
                                 .turns = (double)(n + 1),
                                 .whole = true,
                                 .torques = {NAN, NAN, NAN, NAN, NAN, NAN},
                                 .stations = stations,
                                 .samples = f.views.samples.numbers};
        runup_fill_row(&f, &turn);
        status = f.status;
    }
    // Fill in the end of the record.
    if (status.code == WHIRL_OK) status = runup_views_end(&f.views, o->duration);
    if (status.code == WHIRL_OK) {
        *view_numbers(view, END, 0) = RUNUP_DONE;
        *view_numbers(view, END_TIME, 0) = m->end[m->turns - 1];
        *view_numbers(view, END_SPEED, 0) = runup_measured_speed(m, m->turns - 1);
        *view_numbers(view, END_TURNS, 0) = (double)m->turns;
        runup_fill_slow_roll(view, o, probes);
    }
    runup_views_free(&f.views);
    free(radius);
    free(stations);
    return status;
}

static void runup_compute_together(size_t count, const whirl_resting *points, const whirl_record_options *options,
                                   const block_view *views, whirl_status *statuses) {
    runup_job *jobs = calloc(count + 1, sizeof *jobs);
    for (size_t i = 0; i < count && !jobs; i++) statuses[i] = whirl_fail(WHIRL_NO_MEMORY, "no memory for runs");
    if (!jobs) return;
    // Make all machines, and carry out their runs together.
    for (size_t i = 0; i < count; i++) {
        jobs[i].status = statuses[i];
        if (jobs[i].status.code == WHIRL_OK)
            runup_job_open(&jobs[i], &points[i], points[i].run ? points[i].run : &options->runup, &views[i]);
        if (jobs[i].status.code == WHIRL_OK) runup_job_begin(&jobs[i], points[i].saving && points[i].saving->saved);
    }
    runup_jobs_run(jobs, count);
    for (size_t i = 0; i < count; i++) {
        runup_job *job = &jobs[i];
        statuses[i] = job->status;
        if (!job->running) continue;
        runup_job_end(job);
        // A saved state that does not fit is discarded, and the run begins anew.
        if (job->f.stale) {
            runup_empty(job->view);
            if (points[i].motion) points[i].motion->filled = 0;
            job->status = whirl_ok();
            runup_job_begin(job, false);
            runup_jobs_run(job, 1);
            runup_job_end(job);
        }
        // Find stationary speeds, except of geared machines: the balance of torques uses the response at one speed
        // only.
        double *stationary = view_numbers(job->view, STATIONARY, 0);
        if (job->status.code == WHIRL_OK && stationary && !job->running->geared)
            job->status =
                runup_find_stationary(&points[i], job->running, job->options.drag, (size_t)job->options.stationary,
                                      job->make.highest, stationary, view_numbers(job->view, FOLD, 0));
        statuses[i] = job->status;
        runup_job_close(job);
    }
    free(jobs);
}

static whirl_status runup_compute(const whirl_resting *point, const whirl_record_options *options,
                                  const block_view *view) {
    whirl_status status = whirl_ok();
    if (point->measured) return runup_fill_measured(point, &options->runup, view);
    runup_compute_together(1, point, options, view, &status);
    return status;
}

const analysis_plan runup_analysis = {.fields = fields,
                                      .field_count = FIELD_COUNT,
                                      .compute_resting = runup_compute,
                                      .compute_resting_together = runup_compute_together};
