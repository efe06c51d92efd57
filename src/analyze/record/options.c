// Descriptors of the recording options, and values that follow from them.
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "member_table.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/dataset.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

#define WHOLE(name, field, part, key, fallback, low, high, refined, meaning)                                           \
    MEMBER(whirl_record_options, WHOLE, name, field, part, refined, key, "", "1", WHIRL_KEY_WHOLE, false, fallback,    \
           WHIRL_FROM_TO(low, high), NULL, meaning, "")
#define FLAG(field, part, fallback, meaning)                                                                           \
    MEMBER(whirl_record_options, FLAG, #field, field, part, false, #field, "", "", WHIRL_KEY_CHOICE, false, fallback,  \
           WHIRL_ANY, "yes|no|true|false", meaning, "")

#define RUNNING(field, key, meaning)                                                                                   \
    MEMBER(whirl_record_options, NUMBER, #field, field, "unbalance", false, key, "", "rad/s", WHIRL_KEY_NUMBER, false, \
           "0", WHIRL_NOT_NEGATIVE, NULL, meaning, "")

static const whirl_member members[] = {
    WHOLE("transient", transient, "integrate", "transient", "1100", 0, WHIRL_MAX_TRANSIENT, true,
          "revolutions before the record"),
    WHOLE("record", record, "integrate", "record", "100", 1, WHIRL_MAX_RECORD, false, "revolutions recorded"),
    WHOLE("watch", watch, "integrate", "watch", "0", 0, WHIRL_MAX_TRANSIENT + WHIRL_MAX_RECORD, true,
          "number of last revolutions that verdicts use, at least those recorded; 0: the record and half the "
          "transient, of that at most the larger of 1000 and record"),
    FLAG(settle, "integrate", "yes",
         "yes: the transient ends early where the motion has settled on a periodic orbit to 1e-11"),
    WHOLE("waveform_revolutions", waveform_revolutions, "keep", "waveform", "0", 0, WHIRL_MAX_RECORD, false,
          "number of last revolutions whose waveform is kept"),
    WHOLE("samples_per_revolution", samples_per_revolution, "keep", "samples", "64", 1, WHIRL_MAX_STEPS, false,
          "least number of samples of a waveform a revolution; at most steps_per_revolution"),
    MEMBER(whirl_record_options, NUMBER, "highest_order", highest_order, "keep", false, "highest_order", "", "1",
           WHIRL_KEY_NUMBER, false, "5", WHIRL_POSITIVE, NULL,
           "highest order of spectra; lines are reported up to the order that the motion reaches", ""),
    WHOLE("modes", modes, "modes", "count", "16", 1, 512, false, "number of modes, those of the lowest frequencies"),
    WHOLE("orders", orders, "modes", "orders", "2", 0, 64, false,
          "orders of the speed that excite torsional modes: from 1X to this one; 0: none"),
    MEMBER(whirl_record_options, NUMBER, "line_frequency", line_frequency, "modes", false, "line_frequency", "", "Hz",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
           "frequency of the electric line: it excites torsional modes, as does twice of it; 0: none", ""),
    WHOLE(NULL, modes, "critical_speeds", "count", "16", 1, 512, false, "number of critical speeds, the lowest"),
    FLAG(bearings, "critical_speeds", "no",
         "yes: the parameter is the stiffness of springs that replace all bearings; seals are left out"),
    WHOLE("antinodes_of", antinodes_of, "unbalance", "antinodes_of", "0", 0, 64, false,
          "n: unbalances of 2 x 6350 W/N g mm, in place of the machine's own, at the antinodes of the n-th forward "
          "critical speed; W: mass in kg that bearings carry there, N: running_to in rpm; 0: the machine's own"),
    MEMBER(whirl_record_options, WORD, "placed_at", placed_at, "unbalance", false, "at", "", "", WHIRL_KEY_CHOICE,
           false, "", WHIRL_ANY, "", "a station for one such unbalance, in place of antinodes", ""),
    MEMBER(whirl_record_options, WORD, "probes_at", probes_at, "unbalance", false, "probes_at", "", "",
           WHIRL_KEY_CHOICE, false, "", WHIRL_ANY, "",
           "a station or a list of stations with probes: peaks there need a margin, and the largest vibration there "
           "sets the scale; absent: all stations, and the scale by those with a clearance, if any",
           ""),
    MEMBER(whirl_record_options, NUMBER, "placed_weight", placed_weight, "unbalance", false, "weight", "W", "kg",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL, "mass W for `at`; 0: the overhanging mass there",
           ""),
    MEMBER(whirl_record_options, NUMBER, "placed_factor", placed_factor, "motions", false, "factor", "", "1",
           WHIRL_KEY_NUMBER, false, "1", WHIRL_POSITIVE, NULL, "factor of the unbalances of that study", ""),
    MEMBER(whirl_record_options, WORD, "coupling", coupling, "statics", false, "coupling", "", "", WHIRL_KEY_CHOICE,
           false, "", WHIRL_ANY, "",
           "a station or a list of stations: bearings are raised until shafts carry neither moment nor shear there",
           ""),
    MEMBER(whirl_record_options, NUMBER, "gas_density", gas_density, "stability", false, "density", "rho", "kg/m3",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
           "density of the gas, the average of inlet and outlet of the casing, for screening; 0: no screening", ""),
    MEMBER(
        whirl_record_options, NUMBER, "probe_angle", probe_angle, "unbalance", false, "probe", "", "rad",
        WHIRL_KEY_NUMBER, false, "0", WHIRL_ANY, NULL,
        "angle of the first probe of every station, from the x axis towards y; the second is a right angle further on",
        ""),
    RUNNING(running_low, "running_from", "lowest running speed, for margins; absent: running_to"),
    RUNNING(running_high, "running_to", "highest running speed; absent: running_from"),
    MEMBER(whirl_record_options, NUMBER, NULL, running_low, "modes", false, "running_from", "", "rad/s",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
           "lowest running speed, for separation of torsional modes; absent: running_to", ""),
    MEMBER(whirl_record_options, NUMBER, NULL, running_high, "modes", false, "running_to", "", "rad/s",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL, "highest running speed; absent: running_from", ""),
    WHOLE(NULL, modes, "torsion", "count", "16", 1, 512, false, "number of torsional modes, the lowest"),
    MEMBER(whirl_record_options, NUMBER, NULL, running_low, "torsion", false, "running_from", "", "rad/s",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL,
           "lowest running speed, for the largest torques there; absent: running_to", ""),
    MEMBER(whirl_record_options, NUMBER, NULL, running_high, "torsion", false, "running_to", "", "rad/s",
           WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE, NULL, "highest running speed; absent: running_from", ""),
    RUNNING(trip, "trip", "speed up to which clearances are checked; 0: all speeds of the study"),
    FLAG(spectra, "", "no", "whole spectra are kept"),
    FLAG(waveform, "", "yes", "waveforms are recorded"),
    FLAG(orbits, "", "no", "searches the periodic orbit of a settled motion"),
    WHOLE("growth", growth, "", "growth", "1", 0, WHIRL_GROWTH_ALL, false,
          "perturbations that are carried: 0 none, 1 one, 2 all"),
    // Overrides for the recording of details.
    WHOLE(NULL, transient, "detail", "transient", "", 0, WHIRL_MAX_TRANSIENT, false,
          "revolutions before the record; absent: as in integrate"),
    WHOLE(NULL, record, "detail", "record", "", 1, WHIRL_MAX_RECORD, false,
          "revolutions recorded; absent: as in integrate"),
    WHOLE(NULL, waveform_revolutions, "detail", "waveform", "20", 0, WHIRL_MAX_RECORD, false,
          "number of last revolutions whose waveform is kept; at most record"),
    {.part = NULL},
};

#define TRACE(TYPE, name, field, unit, kind, fallback, range, choices, meaning)                                        \
    MEMBER(whirl_trace_options, TYPE, name, field, "branch", false, #field, "", unit, kind, false, fallback, range,    \
           choices, meaning, "")
#define TRACE_WHOLE(name, field, fallback, low, high, meaning)                                                         \
    TRACE(WHOLE, name, field, "1", WHIRL_KEY_WHOLE, fallback, WHIRL_FROM_TO(low, high), NULL, meaning)

const whirl_member *whirl_trace_members(void) {
    static const whirl_member traced[] = {
        TRACE(FLAG, "trace_rest", rest, "", WHIRL_KEY_CHOICE, "no", WHIRL_ANY, "yes|no|true|false",
              "yes: branches of equilibria, and of the whirl that begins at them, of a machine that nothing drives"),
        TRACE(WORD, "trace_begin", begin, "", WHIRL_KEY_CHOICE, "settled", WHIRL_ANY, "settled|start|linear",
              "start of the search for the first orbit: a settled motion, or the initial state or the linear response, "
              "from which Newton's method finds unstable orbits, too"),
        TRACE_WHOLE("trace_revolutions", revolutions, "0", 0, WHIRL_MAX_ORBIT,
                    "revolutions of the first orbit of a branch; 0: the period of the settled motion"),
        TRACE_WHOLE("trace_longest", longest, "8", 1, WHIRL_MAX_ORBIT, "largest number of revolutions of an orbit"),
        TRACE_WHOLE("trace_switches", switches, "2", 0, 64,
                    "how many times in a row a new branch is followed from a doubling, crossing or Hopf point"),
        TRACE_WHOLE(
            "trace_segments", segments, "1", 1, 64,
            "segments of a revolution, each with its own unknowns (multiple shooting): more for very unstable orbits"),
        TRACE_WHOLE("trace_points", points, "4000", 2, 1000000, "largest number of points of all branches"),
        TRACE(NUMBER, "trace_step", step, "1", WHIRL_KEY_NUMBER, "0.05", WHIRL_ABOVE_TO(1e-6, 1.0), NULL,
              "longest step: 1 is the range of the parameter, or a change of the orbit by its own size"),
        TRACE(NUMBER, "trace_rtol", rtol, "1", WHIRL_KEY_NUMBER, "1e-13", WHIRL_ABOVE_TO(1e-14, 1e-3), NULL,
              "relative tolerance of the orbits' integration"),
        TRACE(FLAG, "trace_tori", tori, "", WHIRL_KEY_CHOICE, "no", WHIRL_ANY, "yes|no|true|false",
              "yes: the tori that begin at Neimark-Sacker points of orbits are followed, too, stable or not"),
        TRACE_WHOLE("trace_torus_nodes", torus_nodes, "63", WHIRL_MIN_TORUS_NODES, WHIRL_MAX_TORUS_NODES,
                    "largest number of nodes of the closed curve of a torus, beyond which it counts as rough; an even "
                    "number is raised by one"),
        TRACE_WHOLE("trace_torus_points", torus_points, "200", 1, 1000000,
                    "largest number of points of one branch of tori"),
        TRACE(
            NUMBER, "trace_torus_step", torus_step, "1", WHIRL_KEY_NUMBER, "0.025", WHIRL_ABOVE_TO(1e-4, 1.0), NULL,
            "longest step along a branch of tori: 1 is the range of the parameter, or a change of the closed curve by "
            "its own size"),
        TRACE(NUMBER, "trace_torus_accuracy", torus_accuracy, "1", WHIRL_KEY_NUMBER, "1e-5",
              WHIRL_ABOVE_TO(1e-10, 0.01), NULL,
              "accuracy of the closed curve of a torus between its nodes, relative to its radius"),
        {.part = NULL},
    };
    return traced;
}

#define FIT(TYPE, field, key, unit, kind, fallback, range, choices, meaning)                                           \
    MEMBER(whirl_fit_options, TYPE, "fit_" #field, field, "fit", false, key, "", unit, kind, false, fallback, range,   \
           choices, meaning, "")
#define FIT_COUNT(field, most, meaning)                                                                                \
    MEMBER(whirl_fit_options, WHOLE, "fit_" #field, field, "", false, #field, "", "1", WHIRL_KEY_WHOLE, false, "0",    \
           WHIRL_FROM_TO(0, most), NULL, meaning, "")

const whirl_member *whirl_fit_members(void) {
    static const whirl_member fits[] = {
        FIT(WHOLE, revolutions, "revolutions", "1", WHIRL_KEY_WHOLE, "1", WHIRL_FROM_TO(1, WHIRL_MAX_ORBIT), NULL,
            "period of the motions in revolutions: 1 if synchronous, 2 after a doubling"),
        FIT(WHOLE, transient, "transient", "1", WHIRL_KEY_WHOLE, "200", WHIRL_FROM_TO(0, WHIRL_MAX_TRANSIENT), NULL,
            "maximum number of transient revolutions before the orbit is searched, at the first values"),
        FIT(WORD, loss, "loss", "", WHIRL_KEY_CHOICE, "squares", WHIRL_ANY, "squares|huber",
            "squares of residuals, or huber, against outliers: squares up to `huber` standard deviations, linear "
            "beyond; needs noise"),
        FIT(NUMBER, huber, "huber", "1", WHIRL_KEY_NUMBER, "2", WHIRL_POSITIVE, NULL,
            "for loss: huber, number of standard deviations beyond which the loss is linear"),
        FIT(WHOLE, most_steps, "steps", "1", WHIRL_KEY_WHOLE, "100", WHIRL_FROM_TO(1, 100000), NULL,
            "maximum number of evaluations of all motions"),
        FIT(NUMBER, tolerance, "tolerance", "1", WHIRL_KEY_NUMBER, "1e-8", WHIRL_ABOVE_TO(1e-13, 0.1), NULL,
            "relative change of the unknowns in a step below which the fit ends"),
        FIT(NUMBER, rtol, "rtol", "1", WHIRL_KEY_NUMBER, "1e-11", WHIRL_ABOVE_TO(1e-14, 1e-6), NULL,
            "relative tolerance of the orbits' integration"),
        FIT(WORD, method, "method", "", WHIRL_KEY_CHOICE, "dop853", WHIRL_ANY, "dop853|rodas5p",
            "method of integration; rodas5p for stiff machines"),
        FIT(WHOLE, record, "record", "1", WHIRL_KEY_WHOLE, "256", WHIRL_FROM_TO(32, 100000), NULL,
            "revolutions after the transient of which statistics are taken (compare: statistics)"),
        FIT(NUMBER, difference, "difference", "1", WHIRL_KEY_NUMBER, "0.01", WHIRL_ABOVE_TO(1e-6, 0.5), NULL,
            "part of the unknowns by which they are changed to derive statistics"),
        FIT(FLAG, profile, "profile", "", WHIRL_KEY_CHOICE, "no", WHIRL_ANY, "yes|no|true|false",
            "find profile intervals, too, for which all other unknowns are fitted again: for parameters on which "
            "motions depend nonlinearly"),
        FIT_COUNT(unknowns, WHIRL_MAX_UNKNOWNS, "number of unknown parameters"),
        FIT_COUNT(motions, WHIRL_MAX_FIT_MOTIONS, "number of motions"),
        FIT_COUNT(numbers, WHIRL_MAX_FIT_NUMBERS, "number of measured numbers"),
        MEMBER(whirl_fit_options, NUMBER, "fit_noise", noise, "", false, "given_noise", "", "1", WHIRL_KEY_NUMBER,
               false, "0", WHIRL_NOT_NEGATIVE, NULL, "1: the noise of the measured numbers is given", ""),
        MEMBER(whirl_fit_options, NUMBER, "fit_data", data, "", false, "checksum", "", "1", WHIRL_KEY_NUMBER, false,
               "0", WHIRL_ANY, NULL, "checksum of the measured numbers", ""),
        {.part = NULL},
    };
    return fits;
}

#define DATASET(TYPE, field, unit, kind, needed, fallback, range, meaning)                                             \
    MEMBER(whirl_dataset_options, TYPE, "dataset_" #field, field, "dataset", false, #field, "", unit, kind, needed,    \
           fallback, range, NULL, meaning, "")
#define DATASET_FOUND(TYPE, field, unit, kind, most, meaning)                                                          \
    MEMBER(whirl_dataset_options, TYPE, "dataset_" #field, field, "", false, #field, "", unit, kind, false, "0",       \
           WHIRL_FROM_TO(0, most), NULL, meaning, "")

const whirl_member *whirl_dataset_members(void) {
    static const whirl_member datasets[] = {
        DATASET(WHOLE, machines, "1", WHIRL_KEY_WHOLE, true, "", WHIRL_FROM_TO(1, WHIRL_MAX_RECORDS),
                "number of machines, which differ by their making (vary)"),
        DATASET(WHOLE, records, "1", WHIRL_KEY_WHOLE, false, "1", WHIRL_FROM_TO(1, WHIRL_MAX_RECORDS),
                "number of records of each machine with each label"),
        DATASET(WHOLE, seed, "1", WHIRL_KEY_WHOLE, false, "1", WHIRL_FROM_TO(0, INT_MAX),
                "seed of all random numbers: another one gives another data set, and the same one always the same"),
        DATASET(WHOLE, only, "1", WHIRL_KEY_WHOLE, false, "0", WHIRL_FROM_TO(0, WHIRL_MAX_RECORDS),
                "number of the only record that is made, from 1, as it is among the others; 0: all are made"),
        MEMBER(whirl_dataset_options, NUMBER, "dataset_turns", turns, "dataset", false, "revolutions", "", "1",
               WHIRL_KEY_NUMBER, false, "0", WHIRL_FROM_TO(0, 1e6), NULL,
               "length of a record in revolutions, with samples_per_revolution", ""),
        MEMBER(whirl_dataset_options, NUMBER, "dataset_per_revolution", per_revolution, "dataset", false,
               "samples_per_revolution", "", "1", WHIRL_KEY_NUMBER, false, "0", WHIRL_FROM_TO(0, 16384), NULL,
               "samples of a revolution, at equal angles; this and revolutions, or rate and samples", ""),
        DATASET(NUMBER, rate, "Hz", WHIRL_KEY_NUMBER, false, "0", WHIRL_NOT_NEGATIVE,
                "samples of a second, whatever the speed; this and samples, or samples_per_revolution and revolutions"),
        DATASET(WHOLE, samples, "1", WHIRL_KEY_WHOLE, false, "0", WHIRL_FROM_TO(0, WHIRL_MAX_RECORD_SAMPLES),
                "number of samples of a channel, an even number, with rate"),
        DATASET(NUMBER, train, "1", WHIRL_KEY_NUMBER, false, "0.7", WHIRL_FROM_TO(0, 1),
                "share of the machines whose records are for training"),
        DATASET(NUMBER, validation, "1", WHIRL_KEY_NUMBER, false, "0.15", WHIRL_FROM_TO(0, 1),
                "share of the machines whose records are for validation; the others are for testing"),
        DATASET_FOUND(NUMBER, lead, "1", WHIRL_KEY_NUMBER, 1e6,
                      "revolutions that are computed before and after the samples, for the filters"),
        DATASET_FOUND(WHOLE, labels, "1", WHIRL_KEY_WHOLE, WHIRL_MAX_LABELS, "number of labels"),
        DATASET_FOUND(WHOLE, channels, "1", WHIRL_KEY_WHOLE, WHIRL_MAX_CHANNELS, "number of channels"),
        DATASET_FOUND(WHOLE, parameters, "1", WHIRL_KEY_WHOLE, WHIRL_MAX_DRAWN,
                      "number of parameters that differ between records"),
        {.part = NULL},
    };
    return datasets;
}

#define RUNUP(TYPE, field, unit, kind, fallback, range, choices, meaning)                                              \
    MEMBER(whirl_runup_options, TYPE, "runup_" #field, field, "runup", false, #field, "", unit, kind, false, fallback, \
           range, choices, meaning, "")
#define RUNUP_NUMBER(field, key, unit, fallback, range, meaning)                                                       \
    MEMBER(whirl_runup_options, NUMBER, "runup_" #field, field, "runup", false, key, "", unit, WHIRL_KEY_NUMBER,       \
           false, fallback, range, NULL, meaning, "")

const whirl_member *whirl_runup_members(void) {
    static const whirl_member runs[] = {
        RUNUP_NUMBER(from, "speed_from", "rad/s", "0", WHIRL_NOT_NEGATIVE, "speed at the beginning; 0: at rest"),
        RUNUP_NUMBER(to, "speed_to", "rad/s", "0", WHIRL_NOT_NEGATIVE,
                     "speed at which the rate ends; the speed then stays until `duration`, or the run ends"),
        RUNUP_NUMBER(rate, "rate", "rad/s2", "0", WHIRL_NOT_NEGATIVE,
                     "rate at which the speed changes towards speed_to; 0: the drive of the machine turns the shaft"),
        RUNUP_NUMBER(duration, "duration", "s", "0", WHIRL_NOT_NEGATIVE,
                     "duration of the run; 0: until speed_to is reached"),
        RUNUP_NUMBER(angle, "angle", "rad", "0", WHIRL_ANY, "angle of the shaft at the beginning"),
        RUNUP(WORD, begin, "", WHIRL_KEY_CHOICE, "rest", WHIRL_ANY, "rest|centre|steady",
              "state at the beginning: the position of rest at the first speed, all stations in the centre, or the "
              "motion that has settled at that speed"),
        RUNUP_NUMBER(settle, "settle", "1", "500", WHIRL_FROM_TO(0, 1e7),
                     "for begin: steady, turns at the first speed before the run"),
        RUNUP_NUMBER(trip_time, "trip_time", "s", "0", WHIRL_NOT_NEGATIVE,
                     "time at which the motor trips; the load stays; 0: never"),
        RUNUP_NUMBER(trip_speed, "trip_speed", "rad/s", "0", WHIRL_NOT_NEGATIVE,
                     "speed at which the motor trips when it is first passed; the load stays; 0: never"),
        RUNUP(WORD, loss_at, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "station where a blade is lost: an unbalance appears"),
        RUNUP_NUMBER(loss_moment, "loss_moment", "kg m", "0", WHIRL_NOT_NEGATIVE,
                     "unbalance that the lost blade leaves"),
        RUNUP_NUMBER(
            loss_angle, "loss_angle", "rad", "0", WHIRL_ANY,
            "angle of the unbalance that the lost blade leaves, on the shaft from its mark, as for other unbalances"),
        RUNUP_NUMBER(loss_time, "loss_time", "s", "0", WHIRL_NOT_NEGATIVE,
                     "time at which the blade is lost; 0: at the beginning, or by loss_speed"),
        RUNUP_NUMBER(loss_speed, "loss_speed", "rad/s", "0", WHIRL_NOT_NEGATIVE,
                     "speed at which the blade is lost when it is first passed; 0: by loss_time"),
        RUNUP(WORD, change, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "names of parameters with the values that they have from an instant of the run on"),
        RUNUP_NUMBER(change_time, "change_time", "s", "0", WHIRL_NOT_NEGATIVE,
                     "time at which the parameters of `change` change; 0: by change_speed"),
        RUNUP_NUMBER(change_speed, "change_speed", "rad/s", "0", WHIRL_NOT_NEGATIVE,
                     "speed at which the parameters of `change` change when it is first passed; 0: by change_time"),
        RUNUP(WORD, events, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "a list of further events, each at a time, at a speed or when a formula is no longer below 0"),
        MEMBER(whirl_runup_options, WHOLE, "runup_event_count", event_count, "", false, "event_count", "", "1",
               WHIRL_KEY_WHOLE, false, "0", WHIRL_FROM_TO(0, WHIRL_MAX_EVENTS), NULL,
               "number of the events, and of a change of parameters", ""),
        RUNUP(
            WORD, shafts, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
            "laws of the shafts with a speed of their own (key `speed` of rotor.shafts), each under its name; a shaft "
            "without a law is turned by its drive, and one that is not listed keeps its speed"),
        MEMBER(whirl_runup_options, WHOLE, "runup_shaft_count", shaft_count, "", false, "shaft_count", "", "1",
               WHIRL_KEY_WHOLE, false, "0", WHIRL_FROM_TO(0, WHIRL_MAX_SPOOLS), NULL,
               "number of shafts with a speed of their own", ""),
        RUNUP(WORD, speeds, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "in place of a rate: the speed over the time as a list of [time, speed], linear between them, or a file "
              "of comma-separated values with the columns time and speed"),
        RUNUP(WORD, rate_law, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "in place of a rate: the rate, rad/s2, as a formula of time and speed, a list of [time, rate], or a file "
              "with these columns; speed_to is the highest speed"),
        RUNUP(
            WORD, torque_law, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
            "the torque of the drive's motor, N m, as a formula of time and speed, a list of [time, torque], or a file "
            "with these columns"),
        RUNUP(WORD, load_law, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "the torque of the drive's load, N m, as a formula of time and speed, a list of [time, load], or a file "
              "with these columns"),
        RUNUP(WORD, ground_x, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "the acceleration of the ground along x, m/s2, as a formula of time and speed, a list of [time, "
              "ground_x], or a file with these columns, linear between rows; 0 before and after a table"),
        RUNUP(WORD, ground_y, "", WHIRL_KEY_CHOICE, "", WHIRL_ANY, "",
              "the acceleration of the ground along y, m/s2, as that along x: a formula, a list of [time, ground_y], "
              "or a file"),
        RUNUP(
            WORD, sensitivity, "", WHIRL_KEY_CHOICE, "contacts", WHIRL_ANY, "contacts|yes|no",
            "a copy of the motion that begins nearby is followed, to see how fast small changes grow: in machines with "
            "contacts, in all, or in none"),
        RUNUP(FLAG, drag, "", WHIRL_KEY_CHOICE, "yes", WHIRL_ANY, "yes|no|true|false",
              "films and seals brake a shaft that its drive turns; no: the load has their drag"),
        RUNUP(WHOLE, stationary, "1", WHIRL_KEY_WHOLE, "120", WHIRL_FROM_TO(0, 100000), NULL,
              "number of speeds at which the torque of a drive is compared with the torques that brake the shaft, to "
              "find stationary speeds; 0: none"),
        RUNUP(WHOLE, rows, "1", WHIRL_KEY_WHOLE, "400", WHIRL_FROM_TO(2, 100000), NULL,
              "number of rows of the result, at equal times: each shows the last turn of the shaft before its time"),
        RUNUP(WHOLE, samples, "1", WHIRL_KEY_WHOLE, "128", WHIRL_FROM_TO(16, 65536), NULL,
              "number of instants of a turn at which the motion is observed"),
        RUNUP_NUMBER(rtol, "rtol", "1", "1e-8", WHIRL_ABOVE_TO(1e-14, 1e-2), "relative tolerance"),
        RUNUP_NUMBER(atol, "atol", "1", "0", WHIRL_FROM_TO(0, 1e-2),
                     "absolute tolerance, in length scales; 0: a thousandth of rtol"),
        RUNUP(WORD, method, "", WHIRL_KEY_CHOICE, "dop853", WHIRL_ANY, "dop853|rodas5p",
              "method of integration; rodas5p for machines whose fast modes are damped hard"),
        RUNUP(
            WHOLE, spectra, "1", WHIRL_KEY_WHOLE, "0", WHIRL_FROM_TO(0, 10000), NULL,
            "number of spectra of the result, at equal times: each has the last turns before its time; 0: no spectra"),
        RUNUP(WHOLE, spectrum_turns, "1", WHIRL_KEY_WHOLE, "16", WHIRL_FROM_TO(2, 1024), NULL,
              "turns of the shaft in a spectrum; its bins are multiples of 1/spectrum_turns of the speed"),
        RUNUP_NUMBER(highest_order, "highest_order", "1", "5", WHIRL_ABOVE_TO(0, 1000),
                     "multiple of the speed up to which spectra are kept"),
        RUNUP_NUMBER(slow_roll, "slow_roll", "rad/s", "0", WHIRL_NOT_NEGATIVE,
                     "speed of slow roll: its motion at 1X is subtracted from that at all speeds; 0: none"),
        RUNUP(WHOLE, orbits, "1", WHIRL_KEY_WHOLE, "0", WHIRL_FROM_TO(0, 1000), NULL,
              "number of turns whose orbits, contact forces, gaps and torques are kept, at equal times: each is the "
              "last turn before its time; one more orbit is that of the largest motion; 0: none"),
        RUNUP(WHOLE, waveform, "1", WHIRL_KEY_WHOLE, "0", WHIRL_FROM_TO(0, 1024), NULL,
              "turns of motions and contact forces that are kept around their largest, and around the first four "
              "events; 0: none"),
        {.part = NULL},
    };
    return runs;
}

double whirl_runup_duration(const whirl_runup_options *options) {
    return options->duration > 0.0 ? options->duration : fabs(options->to - options->from) / options->rate;
}

/// Maximum number of values of a station in one window of a run, in all its spectra, or in its orbits and waveforms.
static const double MAX_RUNUP_NUMBERS = 4e6;

void whirl_runup_shaft_name(const whirl_runup_options *options, size_t index, char name[WHIRL_NAME_SIZE]) {
    const char *at = options->shafts;
    for (; index > 0 && *at; index--) at += strcspn(at, " ") + (at[strcspn(at, " ")] == ' ');
    snprintf(name, WHIRL_NAME_SIZE, "%.*s", (int)strcspn(at, " "), at);
}

bool whirl_runup_driven(const whirl_runup_options *o) {
    return o->rate == 0.0 && !*o->speeds && !*o->rate_law;
}

/// Checks what turns the shaft.
static whirl_status check_what_turns(const whirl_runup_options *o, bool has_drive, double no_load) {
    // One law gives the speed.
    const bool driven = whirl_runup_driven(o);
    if ((o->rate > 0.0) + (*o->speeds != '\0') + (*o->rate_law != '\0') > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has %s and %s, expected one of rate, rate_law and speeds",
                          o->rate > 0.0 ? "rate" : "speeds", *o->rate_law ? "rate_law" : "speeds");
    if (*o->speeds && (o->from > 0.0 || o->to > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "the run has speeds and %s, expected one of them",
                          o->from > 0.0 ? "speed_from" : "speed_to");
    if (*o->rate_law && o->from == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the run has rate_law and begins at standstill, expected speed_from above 0");
    if (*o->rate_law && (o->to == 0.0 || o->duration == 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "the run has rate_law and no %s, expected %s",
                          o->to == 0.0 ? "highest speed" : "end", o->to == 0.0 ? "speed_to" : "duration");
    // Torques need a drive, and a drive has no given speed.
    if (!driven && (*o->torque_law || *o->load_law))
        return whirl_fail(WHIRL_BAD_INPUT, "the run has %s and its speed is given, expected one of them",
                          *o->torque_law ? "torque_law" : "load_law");
    if (driven && !has_drive)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "nothing turns the shaft of the run, expected rate, speeds, or an element drive");
    if (driven && o->duration == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run by the machine's drive has no end, expected duration");
    if (driven && !(fmax(fmax(o->from, o->to), *o->torque_law ? 0.0 : no_load) > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "the highest speed of the run is not known, expected speed_to");
    if (!driven && (o->trip_time > 0.0 || o->trip_speed > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT, "the run has a rate and a trip of its drive, expected one of them");
    return whirl_ok();
}

whirl_status whirl_runup_check(const whirl_runup_options *o, bool driven, double no_load) {
    // Check what turns the shaft, and for how long.
    const whirl_status turned = check_what_turns(o, driven, no_load);
    if (turned.code != WHIRL_OK) return turned;
    if (o->rate > 0.0 && o->to == 0.0 && o->duration == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has a rate and no end, expected speed_to or duration");
    if (o->rate > 0.0 && o->to > 0.0 && o->to == o->from)
        return whirl_fail(WHIRL_BAD_INPUT, "the run begins and ends at %.10g rad/s, expected two speeds", o->to);
    if (strcmp(o->begin, "steady") == 0 && o->from == 0.0 && !*o->speeds)
        return whirl_fail(WHIRL_BAD_INPUT, "the run begins steady at standstill, expected speed_from above 0");
    // Check losses, trips and changes: each has one instant.
    if (*o->loss_at ? o->loss_moment == 0.0 : o->loss_moment != 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has %s, expected loss_at and loss_moment together",
                          *o->loss_at ? "loss_at alone" : "loss_moment alone");
    if (o->loss_time > 0.0 && o->loss_speed > 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has loss_time and loss_speed, expected one of them");
    if (o->trip_time > 0.0 && o->trip_speed > 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has trip_time and trip_speed, expected one of them");
    if (*o->change ? (o->change_time > 0.0) + (o->change_speed > 0.0) != 1
                   : o->change_time > 0.0 || o->change_speed > 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has %s, expected change and one of change_time and change_speed",
                          !*o->change             ? "an instant of a change alone"
                          : o->change_time == 0.0 ? "a change without its instant"
                                                  : "a change at two instants");
    // Check the results that are wanted, and their sizes.
    if (o->stationary == 1 || o->stationary == 2)
        return whirl_fail(WHIRL_BAD_INPUT, "the run has stationary: %d, expected 0 or at least 3", o->stationary);
    const double end = o->to > 0.0 ? o->to : o->from + o->rate * o->duration;
    if (o->slow_roll > 0.0 && o->rate > 0.0 && (o->slow_roll < fmin(o->from, end) || o->slow_roll > fmax(o->from, end)))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "slow_roll is at %.10g rad/s, expected a speed of the run, %.10g to %.10g rad/s",
                          o->slow_roll, fmin(o->from, end), fmax(o->from, end));
    const double kept = o->highest_order * o->spectrum_turns * o->spectra,
                 window = (double)o->spectrum_turns * o->samples;
    if (kept > MAX_RUNUP_NUMBERS)
        return whirl_fail(WHIRL_BAD_INPUT, "%d spectra of %.4g bins are wanted, expected at most %.0f bins in all",
                          o->spectra, o->highest_order * o->spectrum_turns, MAX_RUNUP_NUMBERS);
    if ((double)(o->orbits + WHIRL_RUNUP_WAVEFORMS * o->waveform) * o->samples > MAX_RUNUP_NUMBERS)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "%d orbits and waveforms of %d turns have %d samples a turn, expected at most "
                          "%.0f instants in all",
                          o->orbits, o->waveform, o->samples, MAX_RUNUP_NUMBERS);
    if (o->spectra > 0 && window > MAX_RUNUP_NUMBERS)
        return whirl_fail(WHIRL_BAD_INPUT, "a spectrum of %d turns has %.0f samples, expected at most %.0f",
                          o->spectrum_turns, window, MAX_RUNUP_NUMBERS);
    return whirl_ok();
}

const whirl_member *whirl_record_members(void) {
    return members;
}

whirl_record_options whirl_record_default(void) {
    whirl_record_options options = {.settle = false};
    whirl_members_default(members, &options);
    whirl_members_default(whirl_trace_members(), &options.trace);
    whirl_members_default(whirl_runup_members(), &options.runup);
    whirl_members_default(whirl_fit_members(), &options.fit);
    whirl_members_default(whirl_dataset_members(), &options.dataset);
    options.settle = false;
    return options;
}

int whirl_record_watch(const whirl_record_options *options) {
    enum { ENOUGH = 1000 }; // so that long transients cost no memory
    if (options->watch > 0) return options->watch;
    const int most = options->record > ENOUGH ? options->record : ENOUGH;
    const int before = options->transient / 2 < most ? options->transient / 2 : most;
    return options->record <= INT_MAX - before ? options->record + before : options->record;
}

int whirl_record_samples(const whirl_record_options *options, int steps_per_revolution) {
    const int steps = steps_per_revolution;
    const int least = options->samples_per_revolution < steps ? options->samples_per_revolution : steps;
    if (steps % least == 0) return least;
    // Divisors come in pairs.
    int found = steps;
    for (int small = 1; small <= steps / small; small++) {
        const int large = steps / small;
        if (steps % small != 0) continue;
        if (large >= least && large < found) found = large;
        if (small >= least && small < found) found = small;
    }
    return found;
}

whirl_status whirl_record_options_check(const whirl_record_options *options) {
    // The ranges of keys are not checked here: refinement may raise options beyond them (whirl_advice_apply).
    if (options->transient < 0 || options->record < 1 || options->transient > INT_MAX - options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "transient is %d and record %d revolutions, expected at least 0 and 1",
                          options->transient, options->record);
    const int watch = whirl_record_watch(options);
    if (watch < options->record || watch > options->transient + options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "watch is %d revolutions, expected record (%d) to transient + record (%d)",
                          watch, options->record, options->transient + options->record);
    if (options->waveform_revolutions < 0 || options->waveform_revolutions > options->record)
        return whirl_fail(WHIRL_BAD_INPUT, "waveform is %d revolutions, expected 0 to record (%d)",
                          options->waveform_revolutions, options->record);
    if (options->samples_per_revolution < 1)
        return whirl_fail(WHIRL_BAD_INPUT, "samples_per_revolution is %d, expected at least 1",
                          options->samples_per_revolution);
    const whirl_trace_options *trace = &options->trace;
    if (trace->longest < 1 || trace->longest > WHIRL_MAX_ORBIT || trace->segments < 1 || trace->segments > 64)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "orbits of %d revolutions in %d segments each are to be followed, expected 1 to %d and 1 to "
                          "64",
                          trace->longest, trace->segments, WHIRL_MAX_ORBIT);
    if (options->modes < 1 || !isfinite(options->probe_angle))
        return whirl_fail(WHIRL_BAD_INPUT, "modes is %d and probe is %g, expected at least 1 and a finite angle",
                          options->modes, options->probe_angle);
    if (!(options->highest_order > 0.0) || !isfinite(options->highest_order))
        return whirl_fail(WHIRL_BAD_INPUT, "the highest order of spectra is %g, expected a number above 0",
                          options->highest_order);
    return whirl_ok();
}

/// Checks that all perturbations can be followed, if requested.
static whirl_status check_growth(const whirl_system *system, const char *name, const whirl_record_options *options) {
    const whirl_method *method;
    if (options->growth != WHIRL_GROWTH_ALL) return whirl_ok();
    if (!system->tangent)
        return whirl_fail(WHIRL_BAD_INPUT, "the system gives no Jacobian, expected one to follow all perturbations");
    if (whirl_method_find(name, &method).code == WHIRL_OK && !method->follows)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "method %s takes no perturbations along, expected rk4, dop853 or rodas5p for all exponents",
                          name);
    return whirl_ok();
}

whirl_status whirl_record_check(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options) {
    const whirl_status status = whirl_record_options_check(options);
    return status.code == WHIRL_OK ? check_growth(system, integrate->method, options) : status;
}
