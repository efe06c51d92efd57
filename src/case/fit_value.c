#include "fit_value.h"

#include <math.h>
#include <string.h>

#include "fit_list.h"
#include "fit_speed.h"
#include "plan_batches.h"
#include "plan_names.h"
#include "problem.h"
#include "tree.h"
#include "two_pi.h"

/// Keys of single measured numbers, of which a set has one, and the unit of their noise. The noise of onsets and
/// critical speeds has the unit of the parameter that varies.
static const struct {
    const char *key, *unit;
    whirl_fit_quantity quantity;
} fit_kinds[] = {{"onset", "", WHIRL_FIT_ONSET},
                 {"critical", "", WHIRL_FIT_CRITICAL},
                 {"frequency", "Hz", WHIRL_FIT_FREQUENCY},
                 {"damping", "1", WHIRL_FIT_DAMPING}};

enum { FIT_KINDS = sizeof fit_kinds / sizeof *fit_kinds };

/// Returns the kind of a set; FIT_KINDS: a table.
static size_t fit_kind_of(const fit_set *set) {
    size_t kind = 0;
    while (kind < FIT_KINDS && !settings_find(&set->keys, fit_kinds[kind].key)) kind++;
    return kind;
}

static bool fit_is_threshold(size_t kind) {
    return kind < FIT_KINDS && !*fit_kinds[kind].unit;
}

bool fit_value_varies(const fit_set *set) {
    return fit_is_threshold(fit_kind_of(set));
}

/// Returns the key of a value along a threshold's parameter, or along the speed.
static whirl_key fit_along_key(const fit_set *set, const char *name) {
    if (set->along) return (whirl_key){.name = name, .unit = parameter_expected_unit(set->along), .range = WHIRL_ANY};
    return (whirl_key){.name = name, .unit = "rad/s", .range = WHIRL_POSITIVE};
}

static void fit_read_along(case_reader *reader, fit_set *out) {
    const setting *along = settings_find(&out->keys, "along");
    if (!along) return;
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    const parameter_table *all = reader->parameters;
    const char *name = along->place->kind == NODE_TEXT ? along->place->text : "";
    const size_t index = parameters_find(all, name);
    if (index == all->count) {
        describe_names(name, all->names, all->count, advice);
        problem_at(reader->problems, along->place, "is %s, which is no parameter, %s", node_shown(along->place, shown),
                   advice);
    } else if (plan_check_free(reader, along->place, &all->items[index])) {
        out->along = &all->items[index];
    }
}

bool fit_value_read(case_reader *reader, fit_set *out) {
    const size_t kind = fit_kind_of(out);
    if (kind == FIT_KINDS) return false;
    fit_read_along(reader, out);
    // Read the values along the parameter or the speed.
    const setting *from = settings_find(&out->keys, "from"), *to = settings_find(&out->keys, "to");
    const setting *given = settings_find(&out->keys, fit_kinds[kind].key);
    const whirl_key keys[] = {fit_along_key(out, fit_kinds[kind].key), fit_along_key(out, "from"),
                              fit_along_key(out, "to")};
    if (fit_is_threshold(kind)) formula_read(reader, given->place, &keys[0], &out->value);
    if (from) formula_read(reader, from->place, &keys[1], &out->from);
    if (to) formula_read(reader, to->place, &keys[2], &out->to);
    // The noise is in the unit of the number.
    out->noise_key = (whirl_key){
        .name = "noise", .unit = fit_is_threshold(kind) ? keys[0].unit : fit_kinds[kind].unit, .range = WHIRL_POSITIVE};
    return true;
}

/// Reports a key that is given and means nothing.
static void fit_refuse_key(case_reader *reader, const fit_set *set, const char *key, bool allowed, const char *with) {
    const setting *given = settings_find(&set->keys, key);
    if (given && !allowed) problem_at_key(reader->problems, given->place, "is given without %s", with);
}

void fit_value_check_keys(case_reader *reader, const fit_set *set) {
    const size_t kind = fit_kind_of(set);
    const char *first = NULL;
    if (set->place->kind != NODE_MAPPING) return; // the path of a table
    // Require exactly one of the kinds.
    for (size_t k = 0; k <= FIT_KINDS; k++) {
        const char *key = k < FIT_KINDS ? fit_kinds[k].key : "file";
        const setting *given = settings_find(&set->keys, key);
        if (given && first)
            problem_at_key(reader->problems, given->place, "is given together with %s, expected one of them", first);
        if (given && !first) first = key;
        if (settings_misspelt(&set->keys, key)) return;
    }
    if (!first)
        problem_at(reader->problems, set->place,
                   "has no file, onset, critical, frequency or damping, expected one of them");
    // Check the keys that only some kinds have.
    fit_refuse_key(reader, set, "compare", kind == FIT_KINDS, "file");
    fit_refuse_key(reader, set, "columns", kind == FIT_KINDS, "file");
    fit_refuse_key(reader, set, "record", kind == FIT_KINDS, "file");
    fit_refuse_key(reader, set, "runup", kind == FIT_KINDS, "file");
    fit_refuse_key(reader, set, "delay", settings_find(&set->keys, "runup") != NULL, "runup");
    const bool threshold = fit_is_threshold(kind), mode = kind < FIT_KINDS && !threshold;
    const bool onset = threshold && fit_kinds[kind].quantity == WHIRL_FIT_ONSET;
    fit_refuse_key(reader, set, "of", onset, "onset");
    fit_refuse_key(reader, set, "along", threshold, "onset or critical");
    fit_refuse_key(reader, set, "from", threshold, "onset or critical");
    fit_refuse_key(reader, set, "to", threshold, "onset or critical");
    fit_refuse_key(reader, set, "mode", mode, "frequency or damping");
    fit_refuse_key(reader, set, "whirl", mode || (threshold && !onset), "critical, frequency or damping");
    const setting *noise = settings_find(&set->keys, "noise");
    const setting *compare = settings_find(&set->keys, "compare");
    const bool statistics = strcmp(settings_word(&set->keys, "compare"), "statistics") == 0;
    if (compare && strcmp(settings_word(&set->keys, "compare"), "waveform") == 0 && !settings_find(&set->keys, "runup"))
        problem_at(reader->problems, compare->place,
                   "is waveform, which is of runs, expected runup; a table over the time of a motion at one speed "
                   "needs no compare");
    if (kind == FIT_KINDS && statistics && !noise)
        problem_at(reader->problems, set->place, "has no noise, expected the standard deviation of its statistics");
    if (kind == FIT_KINDS) return;
    if (!noise && !settings_misspelt(&set->keys, "noise"))
        problem_at(reader->problems, set->place, "has no noise, expected the standard deviation of %s", first);
    else if (noise && set->channel_count > 0)
        problem_at(reader->problems, noise->place, "is a list of probes, expected the standard deviation of %s", first);
    if (fit_kinds[kind].quantity == WHIRL_FIT_DAMPING && !settings_find(&set->keys, "mode"))
        problem_at(reader->problems, set->place, "has no mode, expected the number of the mode with this damping");
}

/// Adds the number and its motion. Returns false after a problem, or without memory.
static bool fit_value_add(fit_maker *m, const whirl_fit_motion *motion, const whirl_fit_number *number) {
    whirl_status status = fit_list_motion(m, motion);
    if (status.code == WHIRL_OK) status = fit_list_number(m, number);
    m->reader->no_memory = m->reader->no_memory || status.code == WHIRL_NO_MEMORY;
    if (status.code == WHIRL_BAD_INPUT)
        problem_at(m->reader->problems, m->parts->sets[number->set].place, "is one too many: %.100s", status.message);
    return status.code == WHIRL_OK;
}

/// Evaluates the ends of the search; by default from half the number to twice it. Returns false after a problem.
static bool fit_make_ends(fit_maker *m, const fit_set *set, double value, whirl_fit_motion *out) {
    const setting *from = settings_find(&set->keys, "from"), *to = settings_find(&set->keys, "to");
    out->from = value > 0.0 ? 0.5 * value : 2.0 * value;
    out->to = value > 0.0 ? 2.0 * value : 0.5 * value;
    if (from && !plan_formula_value(m->reader, m->v, from->place, &set->from, &out->from)) return false;
    if (to && !plan_formula_value(m->reader, m->v, to->place, &set->to, &out->to)) return false;
    // Motions are also followed downwards, as in a coast-down.
    const bool orbit = strcmp(settings_word(&set->keys, "of"), "orbit") == 0;
    const bool rising = out->from < value && value < out->to, falling = orbit && out->to < value && value < out->from;
    if ((rising || falling) && (set->along || fmin(out->from, out->to) > 0.0)) return true;
    problem_at(m->reader->problems, set->place, "is sought between %.10g and %.10g, expected values around it",
               out->from, out->to);
    return false;
}

bool fit_value_make(fit_maker *m, const fit_set *set) {
    const size_t kind = fit_kind_of(set);
    whirl_fit_motion motion = {.given_count = m->at_count, .given = m->at};
    whirl_fit_number number = {.set = m->set, .quantity = fit_kinds[kind].quantity, .at = -1.0, .noise = m->noise};
    const setting *given = settings_find(&set->keys, fit_kinds[kind].key);
    if (fit_is_threshold(kind)) {
        const whirl_key key = fit_along_key(set, fit_kinds[kind].key);
        if (!plan_formula_value(m->reader, m->v, given->place, &set->value, &number.value)) return false;
        const whirl_status status = formula_check(m->reader->parameters, &key, &set->value, number.value);
        if (status.code != WHIRL_OK) {
            problem_at(m->reader->problems, given->place, "%s", status.message);
            return false;
        }
        if (!fit_make_ends(m, set, number.value, &motion)) return false;
        const parameter *along = set->along ? set->along : fit_speed_parameter(m->reader, m->parts, set);
        motion.along = along ? along->name : NULL;
        if (set->along) number.at = (double)(set->along - m->reader->parameters->items);
        if (number.quantity == WHIRL_FIT_ONSET && strcmp(settings_word(&set->keys, "of"), "orbit") == 0)
            number.quantity = WHIRL_FIT_ORBIT_ONSET;
    } else {
        number.value = settings_number(m->v, &set->keys, fit_kinds[kind].key);
        if (settings_find(&set->keys, "mode")) motion.mode = (size_t)settings_number(m->v, &set->keys, "mode");
        number.at = (double)motion.mode;
    }
    if (number.quantity == WHIRL_FIT_FREQUENCY) {
        number.value *= two_pi;
        number.noise *= two_pi;
    }
    const setting *whirl = settings_find(&set->keys, "whirl");
    if (whirl) motion.whirl = strcmp(settings_word(&set->keys, "whirl"), "backward") == 0 ? -1 : 1;
    return fit_value_add(m, &motion, &number);
}
