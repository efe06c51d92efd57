// Reading a balancing job, with the same tree, tables and problems as cases.
#include "whirl/internal/balance.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"
#include "input.h"
#include "keys.h"
#include "problem.h"
#include "settings.h"
#include "table_file.h"
#include "tree.h"
#include "two_pi.h"

enum { VERSION = 1, MAX_ROWS = 10000 };

/// Keys of a vibration: amplitude and phase, or real and imaginary part.
#define VECTOR_KEYS(unit, size, angle)                                                                                 \
    NUMBER_KEY("amplitude", "", unit, OPTIONAL, WHIRL_NOT_NEGATIVE, size),                                             \
        NUMBER_KEY("phase", "", "rad", OPTIONAL, WHIRL_ANY, angle),                                                    \
        NUMBER_KEY("real", "", unit, OPTIONAL, WHIRL_ANY,                                                              \
                   "amplitude cos(phase), with imag, in place of amplitude and phase"),                                \
        NUMBER_KEY("imag", "", unit, OPTIONAL, WHIRL_ANY, "amplitude sin(phase)")

static const whirl_key file_keys[] = {
    WHOLE_KEY("balance", "", REQUIRED, WHIRL_ANY, "version of the format, 1"),
    CHOICE_KEY("title", OPTIONAL, "", "name of the rotor, in one line"),
    UNITS_KEY,
    CHOICE_KEY("angles", REQUIRED, "with|against",
               "direction in which angles on the rotor count from its mark: with the rotation or against it"),
    CHOICE_KEY("phases", REQUIRED, "lag|lead",
               "meaning of phases: lag: the peak comes after the mark passes the probe; lead: before"),
    CHOICE_KEY("amplitudes", OPTIONAL, "0-p|p-p|rms",
               "convention of all amplitudes of vibrations; absent: 0-p for the model"),
    CHOICE_KEY("planes", REQUIRED, "", "a list of planes in which weights are put"),
    CHOICE_KEY("trials", OPTIONAL, "",
               "a list of the weights of all runs; absent: none, and the model proposes some or balances by itself"),
    CHOICE_KEY("vibration", REQUIRED, "",
               "a list of readings, or the path of a table (CSV) of readings, from the folder of this file"),
    CHOICE_KEY("slow_roll", OPTIONAL, "",
               "a list of readings of the shaft surface at low speed, which are subtracted from all readings"),
    CHOICE_KEY("coefficients", OPTIONAL, "",
               "a list of known influence coefficients, one for every plane, probe and speed, in place of trials"),
    NUMBER_KEY("mass", "", "kg", OPTIONAL, WHIRL_POSITIVE, "mass of the rotor, for the limits of ISO 21940-11"),
    NUMBER_KEY("grade", "G", "mm/s", OPTIONAL, WHIRL_POSITIVE, "balance quality grade"),
    NUMBER_KEY("service_speed", "", "rad/s", OPTIONAL, WHIRL_POSITIVE, "largest speed in service"),
    CHOICE_KEY("modes", OPTIONAL, "", "a list of modes that are balanced one by one, by sets of weights"),
    CHOICE_KEY("keep_rigid", DEFAULT("no"), "yes|no",
               "yes: sets have no resultant and no couple; needs N + 2 planes for N modes, in place of N"),
    CHOICE_KEY("least", DEFAULT("squares"), "squares|max",
               "quantity that the weights minimize: the sum of the squares of the remaining vibrations, or the largest "
               "of these"),
    CHOICE_KEY("probes", OPTIONAL, "", "a list of properties of the probes"),
    CHOICE_KEY("model", OPTIONAL, "", "path of a case of the rotor, from the folder of this file"),
    CHOICE_KEY("influence", DEFAULT("runs"), "runs|model", "source of the influence coefficients"),
    NUMBER_KEY("model_error", "", "1", DEFAULT("0.03"), WHIRL_FROM_TO(0, 0.5),
               "assumed relative error of the model's critical speeds; the vibration that remains with it is reported"),
    NUMBER_KEY("keyphasor", "", "rad", DEFAULT("0"), WHIRL_ANY,
               "position of the mark's pickup, from the model's x axis towards y"),
};

static const whirl_key plane_keys[] = {
    CHOICE_KEY("name", REQUIRED, "", "name of the plane"),
    NUMBER_KEY("radius", "", "m", OPTIONAL, WHIRL_POSITIVE, "radius of the weights"),
    NUMBER_KEY("limit", "", "kg m", OPTIONAL, WHIRL_POSITIVE, "largest moment of its weight; absent: no limit"),
    WHOLE_KEY("holes", "", OPTIONAL, WHIRL_FROM_TO(3, 360),
              "number of evenly spaced holes for weights; absent: weights at any angle"),
    NUMBER_KEY("first_hole", "", "rad", DEFAULT("0"), WHIRL_ANY,
               "angle of hole 1; holes are numbered by rising angles"),
    CHOICE_KEY("station", OPTIONAL, "", "station of the model; absent: the one with the plane's name"),
    NUMBER_KEY("position", "", "m", OPTIONAL, WHIRL_ANY,
               "position along the rotor, for keep_rigid; absent: the model's"),
};

static const whirl_key mode_keys[] = {
    NUMBER_KEY("speed", "", "rad/s", REQUIRED, WHIRL_POSITIVE,
               "speed near the critical speed of the mode; a reading belongs to the mode of the nearest speed"),
    CHOICE_KEY("shape", OPTIONAL, "", "a list with one number for every plane; absent: the model's, at that speed"),
};

static const whirl_key probe_keys[] = {
    CHOICE_KEY("name", REQUIRED, "", "name of the probe in readings"),
    CHOICE_KEY("station", OPTIONAL, "", "station of the model; absent: the one with the probe's name"),
    NUMBER_KEY("angle", "", "rad", DEFAULT("0"), WHIRL_ANY, "angle of the probe, from the model's x axis towards y"),
    NUMBER_KEY("limit", "", "m", OPTIONAL, WHIRL_POSITIVE, "limit of the vibration with trial weights"),
    NUMBER_KEY("repeatability", "", "m", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "difference between readings of equal runs"),
};

static const whirl_key trial_keys[] = {
    WHOLE_KEY("run", "", REQUIRED, WHIRL_FROM_TO(0, 100000), "number of the run"),
    CHOICE_KEY("plane", OPTIONAL, "", "plane of the weight; this or set"),
    WHOLE_KEY("set", "", OPTIONAL, WHIRL_FROM_TO(1, WHIRL_MAX_PLANES),
              "number of the mode whose set of weights was used, multiplied by moment"),
    NUMBER_KEY("moment", "", "kg m", OPTIONAL, WHIRL_POSITIVE, "mass times radius; this or mass"),
    NUMBER_KEY("mass", "", "kg", OPTIONAL, WHIRL_POSITIVE, "mass at the radius of the plane"),
    NUMBER_KEY("angle", "", "rad", REQUIRED, WHIRL_ANY, "angle on the rotor"),
};

static const whirl_key vibration_keys[] = {
    WHOLE_KEY("run", "", REQUIRED, WHIRL_FROM_TO(0, 100000), "number of the run"),
    NUMBER_KEY("speed", "", "rad/s", REQUIRED, WHIRL_POSITIVE, "speed of the rotor"),
    CHOICE_KEY("probe", REQUIRED, "", "name of the probe"),
    VECTOR_KEYS("m", "amplitude of the 1X vibration, in the convention of `amplitudes`", "phase of the 1X vibration"),
    NUMBER_KEY("weight", "", "1", DEFAULT("1"), WHIRL_NOT_NEGATIVE,
               "weight of the square of this vibration in the sum"),
};

static const whirl_key slow_roll_keys[] = {
    CHOICE_KEY("probe", REQUIRED, "", "name of the probe"),
    VECTOR_KEYS("m", "amplitude of the 1X vibration, in the convention of `amplitudes`", "phase of the 1X vibration"),
};

static const whirl_key coefficient_keys[] = {
    CHOICE_KEY("plane", REQUIRED, "", "plane of the weight"),
    NUMBER_KEY("speed", "", "rad/s", REQUIRED, WHIRL_POSITIVE, "speed of the rotor"),
    CHOICE_KEY("probe", REQUIRED, "", "name of the probe"),
    VECTOR_KEYS("m/(kg m)",
                "amplitude of the vibration by a weight, over its moment, in the convention of `amplitudes`",
                "phase of the vibration by a weight at angle 0"),
};

#define COUNT(keys) (sizeof(keys) / sizeof *(keys))
static const whirl_group file_group = {"balance", "a file for balancing a rotor", "", file_keys, COUNT(file_keys), NULL,
                                       NULL};
static const whirl_group plane_group = {
    "plane", "a plane in which weights are put", "", plane_keys, COUNT(plane_keys), NULL, NULL};
static const whirl_group trial_group = {"trial", "a weight of a run", "", trial_keys, COUNT(trial_keys), NULL, NULL};
static const whirl_group mode_group = {
    "mode", "a mode that is balanced separately", "", mode_keys, COUNT(mode_keys), NULL, NULL};
static const whirl_group probe_group = {"probe", "properties of a probe", "", probe_keys, COUNT(probe_keys), NULL,
                                        NULL};
static const whirl_group vibration_group = {
    "vibration", "a reading of a probe in a run", "", vibration_keys, COUNT(vibration_keys), NULL, NULL};

static const whirl_group slow_roll_group = {
    "slow_roll", "the reading of a probe of the shaft surface", "", slow_roll_keys, COUNT(slow_roll_keys), NULL, NULL};
static const whirl_group coefficient_group = {
    "coefficient", "an influence coefficient", "", coefficient_keys, COUNT(coefficient_keys), NULL, NULL};

const whirl_group *const *whirl_balance_groups(void) {
    static const whirl_group *const groups[] = {&file_group,      &plane_group,       &trial_group,
                                                &vibration_group, &mode_group,        &probe_group,
                                                &slow_roll_group, &coefficient_group, NULL};
    return groups;
}

/// Returns a number of an item without expressions; the default, or else 0, if it is absent.
static double number_of(case_reader *reader, const setting_list *item, const char *name) {
    const setting *given = settings_find(item, name);
    const whirl_key *key = whirl_group_key(item->group, name);
    if (!given) return *key->fallback ? strtod(key->fallback, NULL) : 0.0;
    if (given->value.expression) problem_at(reader->problems, given->place, "is an expression, expected a number");
    return given->good && !given->value.expression ? given->value.number : 0.0;
}

/// Returns the items of a list; NULL after a problem.
static const file_node *items_of(case_reader *reader, const setting_list *file, const char *name, size_t most) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(file, name);
    if (!given) return NULL;
    if (given->place->kind == NODE_LIST && given->place->count > 0 && given->place->count <= most)
        return given->place->first;
    problem_at(reader->problems, given->place, "is %s, expected a list of 1 to %zu",
               given->place->kind == NODE_LIST ? given->place->count ? "a longer list" : "an empty list"
                                               : node_shown(given->place, shown),
               most);
    return NULL;
}

static void *balance_array(case_reader *reader, const setting_list *file, const char *name, size_t size) {
    const setting *given = settings_find(file, name);
    void *array = calloc((given ? given->place->count : 0) + 1, size);
    reader->no_memory = reader->no_memory || !array;
    return array;
}

/// Returns the sense of angles on the rotor: 1, or -1 against the rotation.
static double way_of(const whirl_balance *of) {
    return of->against ? -1.0 : 1.0;
}

static void set_vector(double size, double angle, double out[2]) {
    out[0] = size * cos(angle);
    out[1] = size * sin(angle);
}

static void read_planes(case_reader *reader, const setting_list *file, whirl_balance *out) {
    for (const file_node *at = items_of(reader, file, "planes", WHIRL_MAX_PLANES); at; at = at->next) {
        setting_list item;
        whirl_balance_plane *plane = &out->planes[out->plane_count++];
        settings_read(reader, at, &plane_group, &item);
        settings_text(reader, &item, "name", plane->name, sizeof plane->name);
        plane->radius = number_of(reader, &item, "radius");
        plane->limit = settings_find(&item, "limit") ? number_of(reader, &item, "limit") : (double)INFINITY;
        plane->holes = (int)number_of(reader, &item, "holes");
        plane->first_hole = way_of(out) * fmod(number_of(reader, &item, "first_hole"), two_pi);
        plane->position = settings_find(&item, "position") ? number_of(reader, &item, "position") : (double)NAN;
        settings_text(reader, &item, "station", plane->station, sizeof plane->station);
        for (const whirl_balance_plane *other = out->planes; other < plane; other++)
            if (strcmp(other->name, plane->name) == 0 && *plane->name)
                problem_at(reader->problems, at, "is a second plane '%s', expected names of their own", plane->name);
    }
}

static size_t find_plane(case_reader *reader, const setting_list *item, const whirl_balance *of) {
    const char *names[WHIRL_MAX_PLANES], *word = settings_find(item, "plane") ? settings_word(item, "plane") : "";
    char advice[WHY_SIZE];
    size_t plane = 0;
    while (plane < of->plane_count && strcmp(of->planes[plane].name, word) != 0) plane++;
    if (plane < of->plane_count || !*word) return plane < of->plane_count ? plane : 0;
    for (size_t i = 0; i < of->plane_count; i++) names[i] = of->planes[i].name;
    describe_names(word, names, of->plane_count, advice);
    problem_at(reader->problems, settings_find(item, "plane")->place, "is no plane, %s", advice);
    return 0;
}

/// Reads the shape of a mode, a number for every plane.
static void read_shape(case_reader *reader, const setting *given, size_t planes, whirl_balance_mode *out) {
    char shown[SHOWN_SIZE];
    if (given->place->kind != NODE_LIST || given->place->count != planes) {
        problem_at(reader->problems, given->place, "is %s, expected a list of %zu number%s, one for every plane",
                   node_shown(given->place, shown), planes, planes == 1 ? "" : "s");
        return;
    }
    size_t p = 0;
    for (const file_node *at = given->place->first; at; at = at->next) {
        char *end = NULL;
        const double number = at->kind == NODE_TEXT ? strtod(at->text, &end) : 0.0;
        if (!end || end == at->text || *end || !(fabs(number) <= 1e9)) {
            problem_at(reader->problems, at, "is %s, expected a plain number", node_shown(at, shown));
            return;
        }
        out->shape[p++] = number;
    }
    out->shaped = true;
}

static void read_modes(case_reader *reader, const setting_list *file, whirl_balance *out) {
    for (const file_node *at = items_of(reader, file, "modes", WHIRL_MAX_PLANES); at; at = at->next) {
        setting_list item;
        whirl_balance_mode *mode = &out->modes[out->mode_count++];
        settings_read(reader, at, &mode_group, &item);
        mode->speed = number_of(reader, &item, "speed");
        const setting *shape = settings_find(&item, "shape");
        if (shape) read_shape(reader, shape, out->plane_count, mode);
        if (!shape && !*out->model && at->kind == NODE_MAPPING)
            problem_missing(reader->problems, at, "shape", "is missing, and there is no model that would give it");
        for (const whirl_balance_mode *other = out->modes; other < mode; other++)
            if (other->speed == mode->speed && mode->speed > 0.0)
                problem_at(reader->problems, at, "is a second mode at that speed, expected speeds of their own");
    }
    out->keep_rigid = settings_yes(file, "keep_rigid");
    if (out->keep_rigid && !settings_find(file, "modes"))
        problem_at(reader->problems, settings_find(file, "keep_rigid")->place,
                   "applies only to weight sets: add modes");
}

static void read_probes(case_reader *reader, const setting_list *file, whirl_balance *out) {
    for (const file_node *at = items_of(reader, file, "probes", WHIRL_MAX_BALANCE_PROBES); at; at = at->next) {
        setting_list item;
        whirl_balance_probe *probe = &out->probes[out->probe_count++];
        settings_read(reader, at, &probe_group, &item);
        settings_text(reader, &item, "name", probe->name, sizeof probe->name);
        settings_text(reader, &item, "station", probe->station, sizeof probe->station);
        if (!*probe->station) memcpy(probe->station, probe->name, sizeof probe->station);
        probe->angle = number_of(reader, &item, "angle");
        probe->limit = number_of(reader, &item, "limit");
        if (!(probe->limit > 0.0)) probe->limit = INFINITY;
        probe->repeatability = number_of(reader, &item, "repeatability");
        for (const whirl_balance_probe *other = out->probes; other < probe; other++)
            if (strcmp(other->name, probe->name) == 0 && *probe->name)
                problem_at(reader->problems, at, "is a second probe '%s', expected names of their own", probe->name);
    }
}

static void read_model(case_reader *reader, const setting_list *file, whirl_balance *out) {
    const char *kind = settings_word(file, "amplitudes");
    settings_text(reader, file, "model", out->model, sizeof out->model);
    out->by_model = strcmp(settings_word(file, "influence"), "model") == 0;
    out->model_error = number_of(reader, file, "model_error");
    out->kind = strcmp(kind, "p-p") == 0 ? 2.0 : strcmp(kind, "rms") == 0 ? sqrt(0.5) : 1.0;
    out->keyphasor = number_of(reader, file, "keyphasor");
    if (out->by_model && !settings_find(file, "model"))
        problem_at(reader->problems, settings_find(file, "influence")->place,
                   "is model, expected the key model as well");
}

/// Reads the plane or the set of a trial.
static void read_place(case_reader *reader, const file_node *at, const setting_list *item, const whirl_balance *of,
                       whirl_balance_trial *out) {
    const setting *set = settings_find(item, "set");
    const double number = number_of(reader, item, "set");
    if (at->kind == NODE_MAPPING && !set == !settings_find(item, "plane") && !settings_misspelt(item, "plane"))
        problem_at(reader->problems, at, "expected either plane or set");
    out->plane = set ? WHIRL_BALANCE_SET : find_plane(reader, item, of);
    out->mode = set && number >= 1.0 && number <= (double)of->mode_count ? (size_t)number - 1 : 0;
    if (set && number > (double)of->mode_count)
        problem_at(reader->problems, set->place, "is %g, and there %s %zu mode%s", number,
                   of->mode_count == 1 ? "is" : "are", of->mode_count, of->mode_count == 1 ? "" : "s");
    if (out != of->trials && (out->plane == WHIRL_BALANCE_SET) != (of->trials->plane == WHIRL_BALANCE_SET))
        problem_at(reader->problems, at, "has a %s, earlier trials have %ss, expected one kind", set ? "set" : "plane",
                   set ? "plane" : "set");
}

/// Returns the radius of a trial mass.
static double radius_of(case_reader *reader, const setting *mass, const whirl_balance *of,
                        const whirl_balance_trial *trial) {
    if (trial->plane == WHIRL_BALANCE_SET) {
        problem_at(reader->problems, mass->place, "is that of a set, expected moment in its place");
        return 0.0;
    }
    const whirl_balance_plane *plane = &of->planes[trial->plane];
    if (plane->radius == 0.0)
        problem_at(reader->problems, mass->place, "needs the radius of plane '%s', or moment in its place",
                   plane->name);
    return plane->radius;
}

static void read_trials(case_reader *reader, const setting_list *file, whirl_balance *out) {
    bool tried[WHIRL_MAX_PLANES] = {false};
    out->trials = balance_array(reader, file, "trials", sizeof *out->trials);
    const file_node *first = out->trials ? items_of(reader, file, "trials", MAX_ROWS) : NULL;
    for (const file_node *at = first; at; at = at->next) {
        setting_list item;
        whirl_balance_trial *trial = &out->trials[out->trial_count++];
        settings_read(reader, at, &trial_group, &item);
        trial->run = (int)number_of(reader, &item, "run");
        read_place(reader, at, &item, out, trial);
        if (trial->plane != WHIRL_BALANCE_SET) tried[trial->plane] = true;
        const double mass = number_of(reader, &item, "mass"), moment = number_of(reader, &item, "moment");
        if (at->kind == NODE_MAPPING && (mass > 0.0) == (moment > 0.0))
            problem_at(reader->problems, at, "expected either moment or mass");
        const double radius = mass > 0.0 ? radius_of(reader, settings_find(&item, "mass"), out, trial) : 0.0;
        set_vector(mass > 0.0 ? mass * radius : moment, way_of(out) * number_of(reader, &item, "angle"), trial->moment);
    }
    for (size_t p = 0; p < out->plane_count && first; p++)
        if (!tried[p] && !out->by_model && out->coefficient_count == 0 && out->trials->plane != WHIRL_BALANCE_SET)
            problem_at(reader->problems, settings_find(file, "trials")->place, "has no weight in plane '%s'",
                       out->planes[p].name);
}

/// Reads an amplitude with its phase (lead or lag as in the file), or real and imaginary part, into x and y of a
/// vector.
static void read_phasor(case_reader *reader, const file_node *at, const setting_list *item, const whirl_balance *out,
                        double vector[2]) {
    const double way = out->leads ? 1.0 : -1.0;
    const bool amplitude = settings_find(item, "amplitude"), phase = settings_find(item, "phase"),
               real = settings_find(item, "real"), imaginary = settings_find(item, "imag");
    if (at->kind != NODE_MAPPING) return; // has been reported
    if (amplitude != phase || real != imaginary || amplitude == real) {
        const bool parts = real || imaginary;
        const char *missing = parts ? (real ? "imag" : "real") : amplitude ? "phase" : "amplitude";
        if ((amplitude || phase) && parts)
            problem_at(reader->problems, at, "has both, expected either amplitude and phase, or real and imag");
        else if (!settings_misspelt(item, missing))
            problem_missing(reader->problems, at, missing,
                            "is missing, expected amplitude and phase, or real and imag");
        return;
    }
    if (amplitude) {
        set_vector(number_of(reader, item, "amplitude"), way * number_of(reader, item, "phase"), vector);
    } else {
        vector[0] = number_of(reader, item, "real");
        vector[1] = way * number_of(reader, item, "imag");
    }
}

/// Reads one reading into `seen`, which follows the earlier readings in out->vibrations.
static void read_reading(case_reader *reader, const file_node *at, const whirl_balance *out,
                         whirl_balance_vibration *seen) {
    setting_list item;
    settings_read(reader, at, &vibration_group, &item);
    seen->run = (int)number_of(reader, &item, "run");
    seen->speed = number_of(reader, &item, "speed");
    settings_text(reader, &item, "probe", seen->probe, sizeof seen->probe);
    seen->weight = number_of(reader, &item, "weight");
    for (const whirl_balance_vibration *other = out->vibrations; other < seen; other++)
        if (other->speed == seen->speed && strcmp(other->probe, seen->probe) == 0 && other->weight != seen->weight) {
            problem_at(reader->problems, at,
                       "has the weight %g, and an earlier reading of '%s' at that speed %g, "
                       "expected one weight for a probe at a speed",
                       seen->weight, seen->probe, other->weight);
            break;
        }
    read_phasor(reader, at, &item, out, seen->vibration);
}

/// Reads the items of a list of readings.
static void read_readings(case_reader *reader, const file_node *list, whirl_balance *out) {
    out->vibrations = calloc(list->count + 1, sizeof *out->vibrations);
    reader->no_memory = reader->no_memory || !out->vibrations;
    for (const file_node *at = out->vibrations ? list->first : NULL; at; at = at->next)
        read_reading(reader, at, out, &out->vibrations[out->vibration_count++]);
}

/// Reads readings from a table file. Returns false unless all of them were read.
static bool read_table(case_reader *reader, const file_node *where, whirl_balance *out) {
    whirl_problems problems = {0};
    case_reader own = {.arena = reader->arena, .problems = &problems, .parameters = reader->parameters};
    char path[sizeof problems.file];
    if (!input_path_from(reader->problems->file, where->text, path, sizeof path)) {
        problem_at(reader->problems, where, "is too long for the path of a table");
        return false;
    }
    const file_node *list = table_read(&own, path, &vibration_group);
    if (list && list->count > MAX_ROWS)
        problem_at(reader->problems, where, "has %zu readings, expected 1 to %d", list->count, MAX_ROWS);
    else if (list)
        read_readings(&own, list, out);
    reader->no_memory = reader->no_memory || own.no_memory;
    table_take_problems(reader, where, &problems);
    const bool good = list && problems.count == 0;
    whirl_problems_free(&problems);
    return good;
}

/// Reads all readings. Returns false if those of a table could not be read: consequences are not reported then.
static bool read_vibration(case_reader *reader, const setting_list *file, whirl_balance *out) {
    const setting *given = settings_find(file, "vibration");
    if (given && given->place->kind == NODE_TEXT && !node_is_null(given->place))
        return read_table(reader, given->place, out);
    if (items_of(reader, file, "vibration", MAX_ROWS)) read_readings(reader, given->place, out);
    return true;
}

/// Subtracts slow roll from all readings.
static void read_slow_roll(case_reader *reader, const setting_list *file, whirl_balance *out) {
    out->slow_rolls = balance_array(reader, file, "slow_roll", sizeof *out->slow_rolls);
    const file_node *first = out->slow_rolls ? items_of(reader, file, "slow_roll", MAX_ROWS) : NULL;
    // Read the slow roll of each probe; a probe has one.
    for (const file_node *at = first; at; at = at->next) {
        setting_list item;
        whirl_balance_vibration *seen = &out->slow_rolls[out->slow_roll_count++];
        bool read = false;
        settings_read(reader, at, &slow_roll_group, &item);
        settings_text(reader, &item, "probe", seen->probe, sizeof seen->probe);
        read_phasor(reader, at, &item, out, seen->vibration);
        for (const whirl_balance_vibration *other = out->slow_rolls; other < seen; other++)
            if (strcmp(other->probe, seen->probe) == 0 && *seen->probe)
                problem_at(reader->problems, at, "is a second slow roll of '%s', expected one for a probe",
                           seen->probe);
        // Subtract the slow roll from the readings of its probe, which has to have one at least.
        for (size_t i = 0; i < out->vibration_count; i++) {
            if (strcmp(out->vibrations[i].probe, seen->probe) != 0) continue;
            read = true;
            for (int c = 0; c < 2; c++) out->vibrations[i].vibration[c] -= seen->vibration[c];
        }
        if (!read && *seen->probe)
            problem_at(reader->problems, at, "refers to probe '%s', which has no reading in vibration", seen->probe);
    }
}

static void read_coefficients(case_reader *reader, const setting_list *file, whirl_balance *out) {
    out->coefficients = balance_array(reader, file, "coefficients", sizeof *out->coefficients);
    const file_node *first = out->coefficients ? items_of(reader, file, "coefficients", MAX_ROWS) : NULL;
    for (const file_node *at = first; at; at = at->next) {
        setting_list item;
        whirl_balance_coefficient *own = &out->coefficients[out->coefficient_count++];
        settings_read(reader, at, &coefficient_group, &item);
        own->plane = find_plane(reader, &item, out);
        own->speed = number_of(reader, &item, "speed");
        settings_text(reader, &item, "probe", own->probe, sizeof own->probe);
        read_phasor(reader, at, &item, out, own->influence);
        for (const whirl_balance_coefficient *other = out->coefficients; other < own; other++)
            if (other->plane == own->plane && other->speed == own->speed && strcmp(other->probe, own->probe) == 0)
                problem_at(reader->problems, at, "is a second coefficient of that plane, probe and speed");
    }
    if (first && (out->by_model || out->mode_count > 0))
        problem_at(reader->problems, settings_find(file, "coefficients")->place,
                   "is given together with %s, expected one of them", out->by_model ? "influence: model" : "modes");
}

/// Reports weights of runs without readings.
static void check_runs(case_reader *reader, const setting_list *file, const whirl_balance *of) {
    const setting *trials = settings_find(file, "trials");
    const file_node *at = trials && trials->place->kind == NODE_LIST ? trials->place->first : NULL;
    for (size_t t = 0; t < of->trial_count && at; t++, at = at->next) {
        size_t i = 0;
        while (i < of->vibration_count && of->vibrations[i].run != of->trials[t].run) i++;
        if (i == of->vibration_count && of->vibration_count > 0)
            problem_at(reader->problems, at, "refers to run %d, which has no readings", of->trials[t].run);
    }
}

static void balance_fill(case_reader *reader, const setting_list *file, void *into) {
    whirl_balance *out = into;
    settings_text(reader, file, "title", out->title, sizeof out->title);
    settings_units(reader, file, out->units, sizeof out->units);
    out->against = strcmp(settings_word(file, "angles"), "against") == 0;
    out->leads = strcmp(settings_word(file, "phases"), "lead") == 0;
    snprintf(out->counted, sizeof out->counted, "%s", settings_word(file, "amplitudes"));
    out->least_max = strcmp(settings_word(file, "least"), "max") == 0;
    out->mass = number_of(reader, file, "mass");
    out->grade = number_of(reader, file, "grade");
    out->service_speed = number_of(reader, file, "service_speed");
    read_planes(reader, file, out);
    if (out->plane_count == 0) return; // has been reported
    read_model(reader, file, out);
    read_modes(reader, file, out);
    read_probes(reader, file, out);
    if (!settings_find(file, "trials") && !settings_find(file, "modes") && !settings_find(file, "model") &&
        !settings_find(file, "coefficients") && !settings_misspelt(file, "trials"))
        problem_missing(reader->problems, file->place, "trials",
                        "is missing, and there is no model, mode or coefficient");
    read_coefficients(reader, file, out);
    read_trials(reader, file, out);
    const bool all_read = read_vibration(reader, file, out);
    read_slow_roll(reader, file, out);
    if (all_read) check_runs(reader, file, out);
}

static void balance_release(void *made) {
    whirl_balance_free(made);
}

static const file_kind kind = {&file_group, VERSION, sizeof(whirl_balance), balance_fill, balance_release};

whirl_status whirl_balance_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                                 whirl_balance **out) {
    void *made;
    const whirl_status status = file_parse(&kind, text, length, name, problems, &made);
    *out = made;
    return status;
}

whirl_status whirl_balance_load(const char *path, whirl_problems *problems, whirl_balance **balance) {
    void *made;
    const whirl_status status = file_load(&kind, path, problems, &made);
    *balance = made;
    return status;
}

void whirl_balance_free(whirl_balance *balance) {
    if (!balance) return;
    free(balance->trials);
    free(balance->vibrations);
    free(balance->slow_rolls);
    free(balance->coefficients);
    free(balance);
}
