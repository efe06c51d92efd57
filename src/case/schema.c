// The tables that a case file is checked against, and that `whirl describe` prints.
//
// A key of kind WHIRL_KEY_CHOICE with "" for its choices has a text, a name, or a part of the file with further keys as
// its value; its meaning says which. A key of kind WHIRL_KEY_NUMBER with "" for its unit has a value in the unit of the
// parameter that varies, or a list of numbers.
#include "schema.h"

#include <limits.h>

#include "keys.h"
#include "whirl/engine/case.h"
#include "whirl/engine/claims.h"
#include "whirl/engine/study.h"

#define COUNT(keys) (sizeof(keys) / sizeof *(keys))

static const whirl_key case_keys[] = {
    WHOLE_KEY("whirl", "", REQUIRED, WHIRL_ANY, "version of the format, 1"),
    CHOICE_KEY("title", OPTIONAL, "", "what the case is about, in one line"),
    CHOICE_KEY("document", OPTIONAL, "", "data for the head of reports: see document"),
    CHOICE_KEY("parameters", OPTIONAL, "",
               "names with values: a number, a number and a unit, or = and an expression over other parameters in SI"),
    CHOICE_KEY("rotor", REQUIRED, "", "the machine: see rotor"),
    CHOICE_KEY("study", REQUIRED, "", "the computations: see study"),
};

static const whirl_key document_keys[] = {
    CHOICE_KEY("tag", OPTIONAL, "", "the machine's tag or serial number"),
    CHOICE_KEY("customer", OPTIONAL, "", "owner of the machine"),
    CHOICE_KEY("project", OPTIONAL, "", "name of the project or order"),
    CHOICE_KEY("revision", OPTIONAL, "", "revision of the document"),
    CHOICE_KEY("author", OPTIONAL, "", "author of the document"),
    CHOICE_KEY("date", OPTIONAL, "", "date of the revision, as a text"),
};

// clang-format off
#define ROTOR_KEYS(speeds)                                                                                             \
    {"speed", "omega", "rad/s", WHIRL_KEY_NUMBER, true, "", speeds, NULL,                                              \
     "speed of rotation, above 0; for modes at least 0", "", NULL},                                                    \
    CHOICE_KEY("rotation", DEFAULT("counter-clockwise"), "counter-clockwise|clockwise",                                \
     "direction of rotation: from x to y, or from y to x; angles go from x towards y in both cases"),                  \
    NUMBER_KEY("length_scale", "", "m", REQUIRED, WHIRL_POSITIVE,                                                      \
     "length in which displacements are computed and reported, such as the clearance"),                                \
    CITED_CHOICE_KEY("materials", OPTIONAL, "", "names with the keys of a material of shafts",                         \
     ""),                                                                                                              \
    CHOICE_KEY("shafts", OPTIONAL, "",                                                                                 \
     "names with the keys of a shaft of finite elements, which segments make up"),                                     \
    CHOICE_KEY("stations", REQUIRED, "", "names with the keys of a station"),                                          \
    CITED_CHOICE_KEY("elements", OPTIONAL, "", "a list of elements, each a kind with its keys",                        \
     "")
// clang-format on

static const whirl_key rotor_keys[] = {ROTOR_KEYS(WHIRL_POSITIVE)};
static const whirl_key still_rotor_keys[] = {ROTOR_KEYS(WHIRL_NOT_NEGATIVE)};

#define AND_NAME(name, ...) " " #name
#define KEY_AT_REST(name, meaning, ...)                                                                                \
    CHOICE_KEY(#name, OPTIONAL, "", meaning ", along one parameter or at one point, or a list of such: see " #name),

static const whirl_key study_keys[] = {
    CHOICE_KEY(
        "response", OPTIONAL, "",
        "one point; a study has one of response, sweep, map, basin, branch; alone or together with it studies of "
        "machines at rest:" WHIRL_STUDIES_AT_REST(AND_NAME)),
    CHOICE_KEY("sweep", OPTIONAL, "", "points along one parameter"),
    CHOICE_KEY("motions", OPTIONAL, "",
               "motions in time at each of the conditions, with the machine's own unbalances or those of a study, or a "
               "list of such: see motions"),
    CHOICE_KEY("map", OPTIONAL, "", "points of a plane of two parameters: see map"),
    CHOICE_KEY(
        "basin", OPTIONAL, "",
        "starts in a plane of two parameters of the initial state, and the motions that they settle on: see map"),
    CHOICE_KEY("branch", OPTIONAL, "",
               "orbits along one parameter, stable or not, and where and why they change; alone or together with a "
               "sweep: see branch"),
    CHOICE_KEY("curves", OPTIONAL, "",
               "curves over a second parameter, through the special points of the branches: see curves"),
    WHIRL_STUDIES_AT_REST(KEY_AT_REST)
        CHOICE_KEY("conditions", OPTIONAL, "",
                   "names, such as minimum and maximum, with values of parameters: every study of machines at rest, "
                   "and `motions`, runs at each of these, as NAME_CONDITION"),
    CHOICE_KEY("initial", OPTIONAL, "", "names of stations with their initial state; absent: zero"),
    CHOICE_KEY("starts", OPTIONAL, "",
               "several starts of every point of a response, sweep or map, to find coexisting motions: see starts"),
    CHOICE_KEY("tolerances", OPTIONAL, "",
               "parameters with distributions: every point of a response or sweep, of motions, and of studies of "
               "machines at rest is computed at many samples of them, too: see tolerances"),
    CHOICE_KEY(
        "sensitivity", OPTIONAL, "",
        "derivatives of the numbers of every point of a response, a sweep and studies of machines at rest, and of "
        "special points of a branch, by parameters: see sensitivity"),
    CHOICE_KEY("dataset", OPTIONAL, "", "labelled records of machines with faults, as sensors see them: see dataset"),
    CHOICE_KEY("integrate", OPTIONAL, "", "method and length of the integration: see integrate"),
    CHOICE_KEY("keep", OPTIONAL, "", "parts of waveforms and spectra that are kept: see keep"),
    CHOICE_KEY("analyze", OPTIONAL, "",
               "a list of analyses; absent: all except waveform, exponents, evidence and floquet"),
    CHOICE_KEY(
        "detail", OPTIONAL, "",
        "values of the swept parameter that are computed again, for longer and with whole waveforms and spectra"),
    CHOICE_KEY("units", OPTIONAL, "",
               "units of figures and pages, such as um, rpm, Hz, p-p: a length (scale, m, mm, um, in, mil), a speed "
               "(rad/s, rpm), a frequency (order, Hz, cpm), a way to count amplitudes (0-p, p-p, rms), a force, mass, "
               "stiffness, damping, moment, inertia, unbalance, density, pressure, viscosity and so on (lbf, lbm, "
               "lbf/in, psi, ...), or all of a system (US, SI); absent: as the case writes them"),
};

// Keys of points along a parameter.
// clang-format off
#define AXIS_KEYS(needed)                                                                                              \
    {"parameter", "", "", WHIRL_KEY_CHOICE, needed, "", WHIRL_ANY, "", "name of the parameter that varies", "", NULL}, \
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY, "first value of the parameter"),                                   \
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY, "last value of the parameter"),                                      \
    WHOLE_KEY("points", "", OPTIONAL, WHIRL_FROM_TO(1, SCHEMA_MAX_POINTS),                                             \
     "number of values, spaced by scale, both ends included; this or step"),                                           \
    NUMBER_KEY("step", "", "", OPTIONAL, WHIRL_ANY,                                                                    \
     "distance between the values, from the first to the last that is not beyond `to`; this or points"),               \
    CHOICE_KEY("scale", DEFAULT("linear"), "linear|log",                                                               \
     "spacing of points: linear: equal differences; log: equal ratios"),                                               \
    NUMBER_KEY("values", "", "", OPTIONAL, WHIRL_ANY,                                                                  \
     "a list of the values, rising or falling, in place of from, to, points and step")
// clang-format on

static const whirl_key sweep_keys[] = {
    AXIS_KEYS(true),
    CHOICE_KEY("start", DEFAULT("state"), "rest|state|carry",
               "rest: every point from zero; state: from the initial state; carry: from the end of the point before"),
    CHOICE_KEY("direction", DEFAULT("up"), "up|down|both",
               "with start: carry, along rising or falling values, or both, which shows hysteresis"),
};

// Others rely on the order of these keys: `parameter` is the first, `values` the last.
static const whirl_key axis_keys[] = {AXIS_KEYS(true)};

static const whirl_key map_keys[] = {
    CHOICE_KEY("x", REQUIRED, "", "the parameter along the rows of the map, and its values"),
    CHOICE_KEY("y", REQUIRED, "", "the parameter from row to row, and its values"),
    CHOICE_KEY("z", OPTIONAL, "", "the parameter from plane to plane, and its values; absent: one plane"),
    CHOICE_KEY("start", DEFAULT("state"), "rest|state", "rest: every point from zero; state: from the initial state"),
    WHOLE_KEY("refine", "", OPTIONAL, WHIRL_FROM_TO(2, WHIRL_MAX_SQUARE),
              "a power of two: every n-th point along both axes is computed first, then squares are halved where "
              "verdicts differ; absent: all points are computed"),
};

// Without a parameter there is one point, the machine as given.
static const whirl_key resting_keys[] = {
    AXIS_KEYS(false),
    CHOICE_KEY("name", OPTIONAL, "", "name of this study among several of its kind; its table is KIND_NAME"),
};

static const whirl_key fit_keys[] = {
    CHOICE_KEY("name", OPTIONAL, "", "name of this fit among several; its table is fit_NAME"),
    CHOICE_KEY("unknown", REQUIRED, "", "names of the unknown parameters, each with start, from and to, or nothing"),
    CHOICE_KEY(
        "data", REQUIRED, "",
        "path of a table of measured numbers (CSV, HDF5, MAT or UFF) from the folder of the case, or a list of paths, "
        "of tables with further keys such as `at` and `noise`, and of numbers such as onset: see fit_data"),
    WHOLE_KEY("starts", "", DEFAULT("1"), WHIRL_FROM_TO(1, 10000),
              "number of starts: the first at the values of start, the others spread evenly between the bounds, by the "
              "sequence of Halton"),
};

static const whirl_key fit_unknown_keys[] = {
    NUMBER_KEY("start", "", "", OPTIONAL, WHIRL_ANY, "value at which the search begins; absent: that of the case"),
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY, "lowest value; absent: none"),
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY, "highest value; absent: none"),
};

static const whirl_key fit_data_keys[] = {
    CHOICE_KEY("file", OPTIONAL, "",
               "path of the table: displacements of probes over `angle`, `turns` or `time`, or amplitudes and lags of "
               "orders over `speed` or a parameter"),
    CHOICE_KEY("columns", OPTIONAL, "",
               "headings as in a table, each with its dataset, variable or record (run/x) of an HDF5, MAT or UFF file, "
               "a part of one with an index that runs (run/signals[:, 2]), or a heading of a CSV file (or column 3); "
               "absent: all vectors, under their own names"),
    WHOLE_KEY("record", "", OPTIONAL, WHIRL_FROM_TO(1, WHIRL_MAX_RECORDS),
              "file of study: dataset: number of the record, whose proximity probes are the table; parameters have its "
              "values, unless they are looked for or in `at`"),
    CHOICE_KEY("compare", DEFAULT("orbit"), "orbit|statistics|waveform",
               "file: orbit: its motions are periodic; statistics: they may be of any kind, and columns over `speed` "
               "or a parameter are largest and smallest displacements (disc x max, disc x min), lines (disc x 0.4X), "
               "and the share of the time in contact; waveform: displacements over `time` in a runup"),
    CHOICE_KEY("runup", OPTIONAL, "",
               "file: its orders over `speed` or `time`, or with compare: waveform its displacements over `time`, were "
               "measured while the speed changed: {speed_from: ..., speed_to: ..., rate: ...}, with further keys as in "
               "runup; the machine is run in the same way"),
    NUMBER_KEY("delay", "", "s", DEFAULT("0"), WHIRL_ANY,
               "runup: time of the table at which the run begins; it may depend on the unknowns"),
    NUMBER_KEY("onset", "", "", OPTIONAL, WHIRL_ANY,
               "in place of file: speed at which the machine loses stability, or value of the parameter `along`"),
    NUMBER_KEY("critical", "", "", OPTIONAL, WHIRL_ANY,
               "in place of file: critical speed, or value of the parameter `along` at which a mode whirls once a "
               "revolution; at the start of the fit the nearest one is taken"),
    NUMBER_KEY("frequency", "", "Hz", OPTIONAL, WHIRL_POSITIVE,
               "in place of file: damped frequency of a mode; at the start of the fit the mode `mode`, or the one with "
               "the nearest frequency, is taken"),
    NUMBER_KEY("damping", "", "1", OPTIONAL, WHIRL_FROM_TO(-1, 1),
               "in place of file: damping ratio of the mode `mode`"),
    CHOICE_KEY("of", DEFAULT("rest"), "rest|orbit",
               "onset: rest: the equilibrium becomes unstable; orbit: the periodic motion with the period "
               "`revolutions` becomes unstable or ends"),
    CHOICE_KEY("along", OPTIONAL, "", "onset and critical: parameter that varies; absent: the speed"),
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY,
               "onset and critical: value from which the search at the start of the fit goes to `to`, upwards, or for "
               "an onset of a motion also downwards; absent: half the measured number"),
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY,
               "onset and critical: value at which the search at the start of the fit ends; absent: twice the measured "
               "number"),
    WHOLE_KEY("mode", "", OPTIONAL, WHIRL_FROM_TO(1, 1000),
              "frequency and damping: number of the mode at the start, by rising frequency, of those that are not "
              "overdamped; absent: the nearest frequency"),
    CHOICE_KEY("whirl", OPTIONAL, "forward|backward",
               "critical, frequency and damping: direction of the mode; absent: any"),
    CHOICE_KEY("at", OPTIONAL, "", "parameters with the values that they had in this measurement"),
    CHOICE_KEY(
        "noise", OPTIONAL, "",
        "standard deviation of these numbers, by which they are weighed, in their unit, or {disc x: 2 um, disc y: 3 "
        "um}: one for each probe; absent, for tables only: all weigh the same"),
};

static const whirl_key motions_keys[] = {
    AXIS_KEYS(false),
    CHOICE_KEY("name", OPTIONAL, "", "name of these motions among several; their table is motions_NAME"),
    CHOICE_KEY("unbalance", OPTIONAL, "",
               "name of a study unbalance, or `unbalance` for one without a name: its unbalances by antinodes_of or at "
               "replace the machine's own; absent: the machine's own unbalances"),
};

static const whirl_key branch_keys[] = {
    CHOICE_KEY("parameter", OPTIONAL, "", "name of the parameter that varies; absent: that of the sweep"),
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY, "first bound of the parameter; absent: that of the sweep"),
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY, "other bound of the parameter; absent: that of the sweep"),
    NUMBER_KEY("at", "", "", OPTIONAL, WHIRL_ANY,
               "a list of values at which a motion settles and a branch begins; absent: the first bound"),
};

static const whirl_key curves_keys[] = {
    CHOICE_KEY("parameter", REQUIRED, "", "name of the second parameter"),
    NUMBER_KEY("from", "", "", REQUIRED, WHIRL_ANY, "lower bound of the parameter"),
    NUMBER_KEY("to", "", "", REQUIRED, WHIRL_ANY, "upper bound of the parameter"),
};

static const whirl_key detail_keys[] = {
    NUMBER_KEY("at", "", "", REQUIRED, WHIRL_ANY, "a list of values of the swept parameter"),
};

static const whirl_key event_keys[] = {
    CHOICE_KEY("name", OPTIONAL, "", "a name for `after` of later events"),
    NUMBER_KEY("time", "", "s", OPTIONAL, WHIRL_NOT_NEGATIVE,
               "time of the event since the beginning of the run, or since the event that `after` names"),
    NUMBER_KEY("speed", "", "rad/s", OPTIONAL, WHIRL_POSITIVE, "the event happens when the speed passes this value"),
    CHOICE_KEY("shaft", OPTIONAL, "",
               "shaft with a speed of its own, whose speed and motor are meant; absent: the rotor's"),
    CHOICE_KEY("passing", DEFAULT("either"), "rising|falling|either", "sense in which the speed passes the value"),
    CHOICE_KEY(
        "when", OPTIONAL, "",
        "a formula or a comparison: the event happens once the formula is not below 0, or the comparison holds (time, "
        "speed, STATION_x, STATION_y, STATION_radius, STATION_vx, STATION_vy, STATION_speed and parameters, in SI)"),
    CHOICE_KEY("after", OPTIONAL, "", "name of the event that must have happened before"),
    CHOICE_KEY("trip", DEFAULT("no"), "yes|no|true|false", "yes: the motor trips; the load stays"),
    CHOICE_KEY("end", DEFAULT("no"), "yes|no|true|false", "yes: the run ends"),
    CHOICE_KEY("loss_at", OPTIONAL, "", "station where a blade is lost: an unbalance appears"),
    NUMBER_KEY("loss_moment", "", "kg m", OPTIONAL, WHIRL_NOT_NEGATIVE,
               "unbalance that the lost blade leaves; 0: no blade is lost"),
    ANGLE_KEY("loss_angle", "", "loss_at",
              "angle of the unbalance that the lost blade leaves, on the shaft from its mark, as for other unbalances"),
    CHOICE_KEY("change", OPTIONAL, "", "names of parameters with the values that they have from then on"),
};

static const whirl_key shaft_run_keys[] = {
    NUMBER_KEY("speed_from", "", "rad/s", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "speed at the beginning; 0: at rest"),
    NUMBER_KEY("speed_to", "", "rad/s", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
               "speed at which the rate ends and the speed stays; with speed_law as a formula, and with a drive, the "
               "highest speed"),
    NUMBER_KEY("rate", "", "rad/s2", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "constant rate of the speed, up or down"),
    CHOICE_KEY("speeds", OPTIONAL, "", "the speed over the time: a list of [time, speed], straight between, or a file"),
    CHOICE_KEY(
        "speed_law", OPTIONAL, "",
        "the speed by that of the rotor: a formula of time and speed (of the rotor) in SI, or a list of [speed of "
        "the rotor, speed] with monotone cubics between"),
    CHOICE_KEY("torque_law", OPTIONAL, "",
               "the torque of the motor of its drive, N m, as a formula of time and its own speed"),
    CHOICE_KEY("load_law", OPTIONAL, "", "the torque of the load of its drive, N m, as such a formula"),
};

static const whirl_key starts_keys[] = {
    WHOLE_KEY("count", "", OPTIONAL, WHIRL_FROM_TO(2, WHIRL_MAX_STARTS),
              "starts of every point; the first is the initial state itself, the others fill the ranges evenly, by the "
              "sequence of Halton: the same at every point"),
    CHOICE_KEY("grid", OPTIONAL, "",
               "in place of count: numbers of values of the coordinates of within, such as x: 5, from one end of the "
               "range to the other; every point also starts from the initial state"),
    CHOICE_KEY("within", REQUIRED, "",
               "names of stations with ranges of the coordinates of initial, such as x: [-1, 1]; other coordinates are "
               "as in initial"),
    WHOLE_KEY(
        "neighbours", "", DEFAULT("0"), WHIRL_FROM_TO(0, 100000),
        "largest number of rounds of starts from neighbours: points of a sweep or map start from the end of a "
        "neighbour's motion on an attractor that they lack; these starts do not count in the shares of attractors"),
};

static const whirl_key tolerances_keys[] = {
    CHOICE_KEY("parameters", REQUIRED, "",
               "names of parameters with their tolerances: 0.2 mm +- 5 %; +- 0.01 mm about the case's own value; "
               "40 mm H7 (ISO 286-1); or the keys of a distribution"),
    CHOICE_KEY("of", OPTIONAL, "",
               "a list of numbers of every point, with limits if they have some: see limit; absent: the usual numbers "
               "of each study"),
};

static const whirl_key distribution_keys[] = {
    CHOICE_KEY("distribution", DEFAULT("uniform"), "uniform|normal",
               "uniform between bounds, or normal, cut off at bounds if there are some"),
    CHOICE_KEY("within", OPTIONAL, "", "bounds as a text, such as 0.2 mm +- 5 % or 40 mm H7; this or from and to"),
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY, "lower bound"),
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY, "upper bound"),
    NUMBER_KEY(
        "mean", "", "", OPTIONAL, WHIRL_ANY,
        "mean of the normal distribution before bounds cut it off; absent: between the bounds, or the case's own "
        "value"),
    NUMBER_KEY("deviation", "", "", OPTIONAL, WHIRL_POSITIVE,
               "standard deviation of the normal distribution; absent: a sixth of the distance between the bounds"),
};

static const whirl_key dataset_keys[] = {
    CHOICE_KEY("vary", OPTIONAL, "", "parameters in which machines differ, with tolerances as in tolerances"),
    CHOICE_KEY("conditions", OPTIONAL, "",
               "parameters in which records differ, such as the speed, with tolerances as in tolerances"),
    CHOICE_KEY("runup", OPTIONAL, "",
               "records are of runs at changing speeds, in place of motions at a constant one: {speed_from: ..., "
               "speed_to: ..., rate: ...}, or {speeds: ...}, as in runup"),
    CHOICE_KEY("labels", REQUIRED, "", "names of labels, such as healthy or rub, each with its faults: see label"),
    CHOICE_KEY("channels", REQUIRED, "", "a list of sensors: see channel"),
};

static const whirl_key label_keys[] = {
    CHOICE_KEY(
        "grade", OPTIONAL, "",
        "parameters that the severity of the fault sets, from 0 (from) to 1 (to): {gap: {from: 90 um, to: 30 um}}"),
    CHOICE_KEY("vary", OPTIONAL, "", "further parameters in which records of the label differ, with tolerances"),
};

static const whirl_key grade_keys[] = {
    NUMBER_KEY("from", "", "", REQUIRED, WHIRL_ANY, "value where the severity is 0"),
    NUMBER_KEY("to", "", "", REQUIRED, WHIRL_ANY, "value where the severity is 1"),
};

static const whirl_key channel_keys[] = {
    CHOICE_KEY("sensor", REQUIRED, "proximity|velocity|accelerometer|keyphasor",
               "proximity: gap, displacement and runout, m; velocity, m/s, and accelerometer, m/s2, of the station; "
               "keyphasor: pulses at angles of the shaft, 1 within a pulse and 0 outside"),
    CHOICE_KEY("at", OPTIONAL, "", "station of the sensor; not for a keyphasor"),
    CHOICE_KEY("name", OPTIONAL, "", "name of the channel; absent: made of sensor, station and number"),
    ANGLE_KEY("angle", "", "at", "direction of the sensor, from the x axis towards y"),
    NUMBER_KEY(
        "sensitivity", "", "", OPTIONAL, WHIRL_ANY,
        "volts per unit, such as 7.87 V/mm or 10.2 mV s2/m, for a keyphasor the volts of a pulse; absent: the signal "
        "is in the unit of the sensor, and so are noise and full_scale"),
    NUMBER_KEY("gap", "", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
               "proximity: distance from the shaft at the centre; absent: 0"),
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY,
               "lower end of the sensor's range, in its unit: the signal is clipped there"),
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY, "upper end of the sensor's range, where the signal is clipped, too"),
    NUMBER_KEY("resonance", "", "Hz", OPTIONAL, WHIRL_POSITIVE, "accelerometer: natural frequency of its mass"),
    NUMBER_KEY("damping", "", "1", DEFAULT("0.05"), WHIRL_FROM_TO(1e-6, 0.999),
               "accelerometer: damping ratio of its mass"),
    NUMBER_KEY("high_pass", "", "Hz", OPTIONAL, WHIRL_POSITIVE, "corner of a high pass of the first order"),
    NUMBER_KEY("noise", "", "", OPTIONAL, WHIRL_NOT_NEGATIVE, "standard deviation of white noise at the converter"),
    WHOLE_KEY("bits", "", OPTIONAL, WHIRL_FROM_TO(4, 32),
              "number of bits of the converter; absent: signals are not rounded"),
    NUMBER_KEY("full_scale", "", "", OPTIONAL, WHIRL_POSITIVE,
               "the converter's range is from minus this to this; with bits"),
    WHOLE_KEY("pulses", "", DEFAULT("1"), WHIRL_FROM_TO(1, 100000), "keyphasor, encoder: pulses of a turn"),
    NUMBER_KEY("width", "", "rad", DEFAULT("0.1"), WHIRL_POSITIVE, "width of the pulses, an angle of the shaft"),
    NUMBER_KEY("jitter", "", "rad", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "standard deviation of the angle of each pulse"),
};

// Keys that say which number of a point is meant.
#define NUMBER_KEYS                                                                                                    \
    CHOICE_KEY("field", REQUIRED, "", "a field of the results, such as unbalance/axes or orbit/max_radius"),           \
        CHOICE_KEY("column", OPTIONAL, "", "name of its column, such as major; absent: the first"),                    \
        WHOLE_KEY("row", "", DEFAULT("1"), WHIRL_FROM_TO(1, 100000), "its row, such as the number of a mode, from 1"), \
        CHOICE_KEY("at", OPTIONAL, "", "the station or contact of the number; needed where the field has several")

static const whirl_key sensitivity_keys[] = {
    CHOICE_KEY("parameters", REQUIRED, "",
               "a list of names of parameters, whose values in the case are numbers other than 0, and not expressions"),
    CHOICE_KEY("of", OPTIONAL, "",
               "a list of numbers of every point: see number; absent: the usual ones of each study"),
    NUMBER_KEY("difference", "", "1", OPTIONAL, WHIRL_FROM_TO(1e-4, 0.5),
               "largest change of each parameter, as a part of its value, for differences of records of motions that "
               "are not periodic; absent: such motions have no derivatives"),
};

static const whirl_key number_keys[] = {NUMBER_KEYS};

static const whirl_key limit_keys[] = {
    NUMBER_KEYS,
    NUMBER_KEY("below", "", "", OPTIONAL, WHIRL_ANY,
               "upper limit, in the unit of the field; plain numbers are in SI, lengths in m"),
    NUMBER_KEY("above", "", "", OPTIONAL, WHIRL_ANY, "lower limit"),
};

// Tables of structs whose members follow the keys of a group.
typedef const whirl_member *(*table)(void);
static const table of_batch[] = {whirl_batch_members, NULL};
static const table of_options[] = {whirl_integrate_members, whirl_record_members, whirl_trace_members,
                                   whirl_runup_members,     whirl_fit_members,    NULL};
static const table of_dataset[] = {whirl_dataset_members, NULL};
static const table of_tolerances[] = {whirl_tolerance_members, NULL};
static const table of_probe[] = {whirl_probe_members, NULL};

#define GROUP(name, meaning, keys, tables)                                                                             \
    { name, meaning, "", keys, COUNT(keys), NULL, tables }
#define PART(name, meaning, tables)                                                                                    \
    { name, meaning, "", NULL, 0, NULL, tables }

const whirl_group schema_case = GROUP("case", "a case file", case_keys, NULL);
const whirl_group schema_document = GROUP("document", "data for the head of reports", document_keys, NULL);
const whirl_group schema_rotor = GROUP("rotor", "the machine", rotor_keys, NULL);
const whirl_group schema_still_rotor = GROUP("rotor", "the machine", still_rotor_keys, NULL);
const whirl_group schema_study = GROUP("study", "the computations", study_keys, of_batch);
const whirl_group schema_response = PART("response", "one point: no keys", NULL);
const whirl_group schema_sweep = GROUP("sweep", "points along one parameter", sweep_keys, NULL);
const whirl_group schema_map = GROUP("map", "points of a plane of two parameters", map_keys, NULL);
const whirl_group schema_basin =
    GROUP("basin", "starts in a plane, and the motions that they settle on", map_keys, NULL);
const whirl_group schema_axis = GROUP("axis", "the values of a parameter, along x or y of a map", axis_keys, NULL);
// Keys of a study at rest, by the last word of its line in WHIRL_STUDIES_AT_REST.
#define STILL resting_keys
#define TURNING resting_keys
#define RUNNING resting_keys
#define FITTED fit_keys
#define GROUP_AT_REST(name, meaning, source, keys) GROUP(#name, meaning, keys, of_options),
#define ADDRESS_AT_REST(name, ...) &schema_at_rest[SCHEMA_AT_REST_##name],
const whirl_group schema_at_rest[] = {WHIRL_STUDIES_AT_REST(GROUP_AT_REST){.name = NULL}};
const whirl_group schema_motions =
    GROUP("motions", "motions in time of a case with studies of machines at rest", motions_keys, of_options);
const whirl_group schema_branch =
    GROUP("branch", "branches of periodic orbits and equilibria along one parameter", branch_keys, of_options);
const whirl_group schema_curves = GROUP("curves", "curves of special points over two parameters", curves_keys, NULL);
const whirl_group schema_initial = PART("initial", "the state that a station starts from", of_probe);
const whirl_group schema_event = GROUP("event", "an event of a run-up", event_keys, NULL);
const whirl_group schema_shaft_run =
    GROUP("shaft_run", "a shaft with a speed of its own in a run-up; speeds and torques are along its rotation",
          shaft_run_keys, NULL);
const whirl_group schema_fit_unknown =
    GROUP("fit_unknown", "the start and the bounds of an unknown parameter", fit_unknown_keys, NULL);
const whirl_group schema_fit_data = GROUP("fit_data", "a table of measured numbers, or a number", fit_data_keys, NULL);
const whirl_group schema_starts = GROUP("starts", "several starts of every point", starts_keys, NULL);
const whirl_group schema_tolerances =
    GROUP("tolerances", "parameters with distributions, and what is asked of them", tolerances_keys, of_tolerances);
const whirl_group schema_distribution =
    GROUP("distribution", "the distribution of a parameter with a tolerance", distribution_keys, NULL);
const whirl_group schema_limit =
    GROUP("limit", "a number of every point of a study of tolerances, and its limits", limit_keys, NULL);
const whirl_group schema_sensitivity =
    GROUP("sensitivity", "derivatives of the numbers of every point by parameters", sensitivity_keys, NULL);
const whirl_group schema_number = GROUP("number", "a number of every point that is differentiated", number_keys, NULL);
const whirl_group schema_dataset =
    GROUP("dataset", "labelled records of machines with faults, as sensors see them", dataset_keys, of_dataset);
const whirl_group schema_label =
    GROUP("label", "a label of a data set, and the faults that it means", label_keys, NULL);
const whirl_group schema_grade = GROUP("grade", "a parameter that the severity of a fault sets", grade_keys, NULL);
const whirl_group schema_channel = GROUP("channel", "a sensor with its electronics and converter", channel_keys, NULL);
const whirl_group schema_integrate = PART("integrate", "method and length of the integration", of_options);
const whirl_group schema_keep = PART("keep", "parts of waveforms and spectra that are kept", of_options);
const whirl_group schema_detail =
    GROUP("detail", "values that are computed again, for longer", detail_keys, of_options);

const char *schema_scaled_unit(const whirl_key *key) {
    for (const whirl_member *member = whirl_probe_members(); member->part; member++)
        if (key == &member->key) return key->name[0] == 'v' ? "m/s" : "m";
    return "";
}

const whirl_group *const *whirl_case_groups(void) {
    static const whirl_group *const groups[] = {
        &schema_case,
        &schema_document,
        &schema_rotor,
        &schema_study,
        &schema_response,
        &schema_sweep,
        &schema_map,
        &schema_basin,
        &schema_axis,
        WHIRL_STUDIES_AT_REST(ADDRESS_AT_REST) & schema_motions,
        &schema_branch,
        &schema_curves,
        &schema_initial,
        &schema_starts,
        &schema_tolerances,
        &schema_distribution,
        &schema_limit,
        &schema_sensitivity,
        &schema_number,
        &schema_dataset,
        &schema_label,
        &schema_grade,
        &schema_channel,
        &schema_integrate,
        &schema_keep,
        &schema_detail,
        &schema_event,
        &schema_shaft_run,
        &schema_fit_unknown,
        &schema_fit_data,
        NULL,
    };
    return groups;
}

// ---------------------------------------------------------------- claims

static const whirl_key claims_keys[] = {
    WHOLE_KEY("claims", "", REQUIRED, WHIRL_ANY, "version of the format, 1"),
    CHOICE_KEY("source", OPTIONAL, "", "source of the claims"),
    CHOICE_KEY("parameter", REQUIRED, "", "name of the parameter of the claims"),
    CHOICE_KEY("station", REQUIRED, "", "name of the station whose spectrum is meant"),
    CHOICE_KEY("items", REQUIRED, "", "a list of claims"),
};

static const whirl_key claim_keys[] = {
    CHOICE_KEY("where", REQUIRED, "", "figure or section"),
    NUMBER_KEY("from", "", "", OPTIONAL, WHIRL_ANY, "first value of the parameter"),
    NUMBER_KEY("to", "", "", OPTIONAL, WHIRL_ANY, "last value of the parameter"),
    NUMBER_KEY("at", "", "", OPTIONAL, WHIRL_ANY, "value of the parameter, in place of from and to"),
    CHOICE_KEY("says", REQUIRED, "", "the claim in words"),
    CHOICE_KEY("regime", OPTIONAL, "", "P-1 to P-128, periodic, quasi-periodic, chaotic or diverged"),
    WHOLE_KEY("curves", "", OPTIONAL, WHIRL_FROM_TO(1, 64), "closed curves of a quasi-periodic section"),
    CHOICE_KEY("rub", OPTIONAL, "true|false|yes|no|always|at_times",
               "true or false: contact or none; always, at_times: how long"),
    CHOICE_KEY("dry_whip", OPTIONAL, "true|false|yes|no",
               "true: friction drives the rotor backward round its stator, in lasting contact"),
    NUMBER_KEY("lines", "", "", OPTIONAL, WHIRL_POSITIVE, "a list of orders that the spectrum shows"),
    CHOICE_KEY("only_lines", OPTIONAL, "true|false|yes|no", "true: the spectrum shows no other lines"),
    NUMBER_KEY("band", "", "", OPTIONAL, WHIRL_NOT_NEGATIVE,
               "two orders between which the large lines below the running speed lie"),
    NUMBER_KEY("largest", "", "", OPTIONAL, WHIRL_NOT_NEGATIVE, "two orders between which the largest line lies"),
    CHOICE_KEY("whirl", OPTIONAL, "forward|backward|diverging-backward", "direction of the whirl"),
    CHOICE_KEY(
        "changes", OPTIONAL, "",
        "a list of changes that branches have in the range: fold, crossing, doubling, neimark-sacker, hopf, grazing"),
    CHOICE_KEY("unchanged", OPTIONAL, "", "a list of changes that branches do not have in the range"),
    CHOICE_KEY("sense", OPTIONAL, "supercritical|subcritical",
               "supercritical or subcritical: sense of the first of the changes"),
    NUMBER_KEY("orders", "", "", OPTIONAL, WHIRL_POSITIVE,
               "a list of orders; the whirl that begins at the first Hopf point of the range has one of them"),
    WHOLE_KEY("regions", "", OPTIONAL, WHIRL_FROM_TO(1, 99),
              "number of parts of the curve of Hopf points, alternately supercritical and subcritical"),
    CHOICE_KEY("given", OPTIONAL, "",
               "name of another parameter of the case, if the claim holds only for some of its values"),
    NUMBER_KEY("given_from", "", "", OPTIONAL, WHIRL_ANY, "first value of that parameter"),
    NUMBER_KEY("given_to", "", "", OPTIONAL, WHIRL_ANY, "last value of that parameter"),
};

const whirl_group schema_claims =
    GROUP("claims", "a claims file: statements of a paper or a measurement about a rotor", claims_keys, NULL);
const whirl_group schema_claim = GROUP("claim", "one claim of the list `items` of a claims file", claim_keys, NULL);

const whirl_group *const *whirl_claims_groups(void) {
    static const whirl_group *const groups[] = {&schema_claims, &schema_claim, NULL};
    return groups;
}
