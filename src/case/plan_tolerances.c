// Studies of tolerances: distributions of parameters, and the batches of samples.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "iso_286.h"
#include "plan_asked.h"
#include "plan_batches.h"
#include "plan_names.h"
#include "plan_parts.h"
#include "plan_tolerances.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"

// ---------------------------------------------------------------- distributions

/// Reads a difference such as "0.01 mm" or "5 degC": the zero of a temperature unit does not count.
static bool difference_read(const char *text, const char *unit, double *value, char why[WHY_SIZE]) {
    quantity read, zero = {.value = 0.0};
    const char *space = strchr(text, ' ');
    char nothing[WHY_SIZE];
    if (!quantity_read(text, unit, &read, why)) return false;
    snprintf(nothing, sizeof nothing, "0%s", space ? space : "");
    if (space && !quantity_read(nothing, unit, &zero, why)) return false;
    *value = read.value - zero.value;
    return true;
}

/// Reads "5 %" or "0.01 mm" as the distances of both bounds.
static bool read_distance(const char *text, const char *unit, bool plain_allowed, distribution_parts *own,
                          char why[WHY_SIZE]) {
    // Read a percentage, or a distance with a unit.
    const char *end;
    char shown[SHOWN_SIZE];
    double value;
    const bool number = quantity_number(text, &value, &end);
    const bool percent = number && strcmp(end + strspn(end, " "), "%") == 0;
    if (percent)
        value /= 100.0;
    else if (number && !*end && !plain_allowed) {
        snprintf(why, WHY_SIZE, "has the distance %s without a unit, expected one, or a part in %%",
                 text_shown(text, shown));
        return false;
    } else if (!difference_read(text, unit, &value, why)) {
        return false;
    }
    // Distances are the same on both sides.
    if (!(value > 0.0) || !isfinite(value)) {
        snprintf(why, WHY_SIZE, "has the distance %s, expected one above 0", text_shown(text, shown));
        return false;
    }
    own->relative = percent;
    own->below = own->above = value;
    return true;
}

/// Finds the beginning and end of "+-" in a text; NULL if it has none.
static const char *find_sign(const char *text, size_t *length) {
    static const char *const signs[] = {"+-", "+/-", "\u00b1"};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        const char *at = strstr(text, signs[i]);
        *length = strlen(signs[i]);
        if (at) return at;
    }
    return NULL;
}

/// Returns the tolerance class at the end of "40 mm H7"; NULL if there is none.
static const char *find_class(const char *text) {
    const char *last = strrchr(text, ' '), *c = last ? last + 1 : "";
    const size_t letters = strspn(c, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    const size_t digits = strspn(c + letters, "0123456789");
    const bool alike = letters >= 1 && letters <= 2 && digits >= 1 && digits <= 2 && !c[letters + digits];
    return alike && memchr(text, ' ', (size_t)(last - text)) ? c : NULL;
}

/// Reads bounds around a value: "0.2 mm +- 5 %", "+- 0.01 mm" or "40 mm H7".
static bool read_within(const file_node *where, const char *unit, distribution_parts *own, char why[WHY_SIZE]) {
    // Split the text at "+-" or before a tolerance class of ISO 286.
    char before[WHY_SIZE], shown[SHOWN_SIZE];
    const char *text = where->text;
    size_t length;
    const char *sign = find_sign(text, &length), *class = strcmp(unit, "m") == 0 ? find_class(text) : NULL;
    const char *end = sign ? sign : class ? class : text + strlen(text);
    snprintf(before, sizeof before, "%.*s", (int)(end - text), text);
    for (size_t used = strlen(before); used > 0 && before[used - 1] == ' ';) before[--used] = '\0';
    own->within = true;
    own->own = !*before;
    // Refuse texts with neither of them.
    if (!sign && !class) {
        snprintf(why, WHY_SIZE, "is %s, expected bounds such as 0.2 mm +- 5 %%, +- 0.01 mm%s", text_shown(text, shown),
                 strcmp(unit, "m") == 0 ? " or 40 mm H7" : "");
        return false;
    }
    // Read the value before it; without one it is the parameter's own.
    quantity read = {.unit = ""};
    if (*before && !quantity_read(before, unit, &read, why)) return false;
    own->value = read.value;
    // Read the distance, or look up the limits of the class.
    if (sign) {
        const char *distance = sign + length + strspn(sign + length, " ");
        const bool plain = !*unit || strcmp(unit, "1") == 0;
        return read_distance(distance, unit, plain, own, why);
    }
    double low, high;
    if (!iso_286_limits(class, read.value, &low, &high, why)) return false;
    own->below = read.value - low;
    own->above = high - read.value;
    return true;
}

/// Reads a number of a distribution with the unit of its parameter, if its key is given.
static void read_number(case_reader *reader, const distribution_parts *own, const char *name, number_formula *result) {
    const setting *given = settings_find(&own->keys, name);
    const whirl_key key = {.name = name, .unit = parameter_expected_unit(own->parameter), .range = WHIRL_ANY};
    if (given) formula_read(reader, given->place, &key, result);
}

static void tolerances_check_keys(case_reader *reader, const distribution_parts *own) {
    const setting *within = settings_find(&own->keys, "within"), *from = settings_find(&own->keys, "from");
    const setting *to = settings_find(&own->keys, "to"), *mean = settings_find(&own->keys, "mean");
    const setting *deviation = settings_find(&own->keys, "deviation");
    const bool normal = strcmp(settings_word(&own->keys, "distribution"), "normal") == 0;
    if (within && (from || to))
        problem_at_key(reader->problems, (from ? from : to)->place,
                       "is given together with within, expected one of the two");
    if (!normal && (mean || deviation))
        problem_at_key(reader->problems, (mean ? mean : deviation)->place,
                       "has a meaning only with distribution: normal");
    if (!normal && !within && (!from || !to))
        problem_missing(reader->problems, own->keys.place, from ? "to" : "from",
                        "is missing, expected two bounds, from and to, or within");
    if (normal && !deviation && !within && (!from || !to))
        problem_missing(reader->problems, own->keys.place, "deviation",
                        "is missing, expected the standard deviation, or two bounds");
}

bool distribution_read(case_reader *reader, const file_node *where, distribution_parts *own) {
    char why[WHY_SIZE], shown[SHOWN_SIZE];
    const parameter *found = plan_find_named(reader, where);
    if (!found) return false;
    // Read its distribution: bounds as a text, or the keys of one.
    *own = (distribution_parts){.parameter = found, .place = where};
    own->keys = (setting_list){.name = schema_distribution.name, .group = &schema_distribution, .place = where};
    const char *unit = parameter_expected_unit(found);
    if (!plan_check_free(reader, where, found)) return true;
    if (where->kind == NODE_TEXT) {
        if (!read_within(where, unit, own, why)) problem_at(reader->problems, where, "%s", why);
    } else if (where->kind == NODE_MAPPING) {
        settings_read(reader, where, &schema_distribution, &own->keys);
        tolerances_check_keys(reader, own);
        const setting *within = settings_find(&own->keys, "within");
        if (within && within->place->kind != NODE_TEXT)
            problem_at(reader->problems, within->place, "is %s, expected bounds such as 0.2 mm +- 5 %%",
                       node_shown(within->place, shown));
        else if (within && !read_within(within->place, unit, own, why))
            problem_at(reader->problems, within->place, "%s", why);
        read_number(reader, own, "from", &own->from);
        read_number(reader, own, "to", &own->to);
        read_number(reader, own, "mean", &own->mean);
        read_number(reader, own, "deviation", &own->deviation);
    } else {
        problem_at(reader->problems, where,
                   "is %s, expected bounds such as 0.2 mm +- 5 %%, or the keys of a distribution",
                   node_shown(where, shown));
    }
    return true;
}

// ---------------------------------------------------------------- reading the case

void tolerances_read(case_reader *reader, plan_parts *parts) {
    // Find the part; without it there are no tolerances.
    char shown[SHOWN_SIZE];
    tolerance_parts *own = &parts->tolerances;
    const setting *given = settings_find(&parts->study, "tolerances");
    plan_read_part(reader, &parts->study, "tolerances", &schema_tolerances, &own->keys);
    if (!given) {
        own->keys.place = NULL;
        return;
    }
    // Read the distributions of all parameters.
    const setting *all = settings_find(&own->keys, "parameters"), *of = settings_find(&own->keys, "of");
    if (all && (all->place->kind != NODE_MAPPING || all->place->count == 0))
        problem_at(reader->problems, all->place, "is %s, expected 1 to %d parameters with their tolerances",
                   all->place->kind == NODE_MAPPING ? "empty" : node_shown(all->place, shown), WHIRL_MAX_TOLERANCES);
    else if (all && all->place->count > WHIRL_MAX_TOLERANCES)
        problem_at(reader->problems, all->place, "has %zu parameters, expected 1 to %d with their tolerances",
                   all->place->count, WHIRL_MAX_TOLERANCES);
    else
        for (const file_node *one = all ? all->place->first : NULL; one; one = one->next)
            own->count += distribution_read(reader, one, &own->distributions[own->count]);
    // Read the numbers that are asked of all samples.
    asked_read(reader, of, &schema_limit, &own->asked);
}

// ---------------------------------------------------------------- batches

bool distribution_make(case_reader *reader, valuation *v, const distribution_parts *own, whirl_tolerance *to) {
    const double case_value = v->values[own->parameter - v->parameters->items];
    const bool normal = strcmp(settings_word(&own->keys, "distribution"), "normal") == 0;
    const setting *from = settings_find(&own->keys, "from"), *upto = settings_find(&own->keys, "to");
    const setting *mean = settings_find(&own->keys, "mean"), *deviation = settings_find(&own->keys, "deviation");
    bool good = true;
    *to = (whirl_tolerance){.name = own->parameter->name, .low = -INFINITY, .high = INFINITY};
    if (own->within) {
        const double value = own->own ? case_value : own->value, size = own->relative ? fabs(value) : 1.0;
        to->low = value - size * own->below;
        to->high = value + size * own->above;
    }
    if (from) good = plan_formula_value(reader, v, from->place, &own->from, &to->low) && good;
    if (upto) good = plan_formula_value(reader, v, upto->place, &own->to, &to->high) && good;
    if (good && !(to->low < to->high)) {
        problem_at(reader->problems, upto ? upto->place : own->place,
                   "gives bounds %.10g and %.10g (in SI), expected the lower one first", to->low, to->high);
        return false;
    }
    if (!normal || !good) return good;
    to->mean = isfinite(to->low) && isfinite(to->high) ? 0.5 * (to->low + to->high) : case_value;
    to->deviation = (to->high - to->low) / 6.0;
    if (mean) good = plan_formula_value(reader, v, mean->place, &own->mean, &to->mean) && good;
    if (deviation) good = plan_formula_value(reader, v, deviation->place, &own->deviation, &to->deviation) && good;
    if (good && !(to->deviation > 0.0 && isfinite(to->deviation))) {
        problem_at(reader->problems, deviation ? deviation->place : own->place,
                   "gives a standard deviation of %.10g, expected one above 0", to->deviation);
        return false;
    }
    const double far = 8.0; // standard deviations: beyond them lies 1e-15
    if (good && (to->low > to->mean + far * to->deviation || to->high < to->mean - far * to->deviation)) {
        problem_at(
            reader->problems, own->place,
            "has bounds more than %g standard deviations from the mean, expected some of the distribution between "
            "them",
            far);
        return false;
    }
    return good;
}

/// Returns true for a batch whose points tolerances sample.
static bool is_sampled(const whirl_batch *batch) {
    static const whirl_role roles[] = {WHIRL_ROLE_POINT, WHIRL_ROLE_SURVEY, WHIRL_ROLE_REST, WHIRL_ROLE_MOTIONS};
    for (size_t i = 0; i < sizeof roles / sizeof *roles; i++)
        if (batch->role == roles[i]) return !whirl_analysis_has(batch->analyses, "fit");
    return false;
}

/// Refuses parameters that a batch varies or sets itself.
static void check_parameters(case_reader *reader, const plan_parts *parts, const whirl_batch *batch) {
    for (size_t i = 0; i < parts->tolerances.count; i++) {
        const distribution_parts *own = &parts->tolerances.distributions[i];
        bool taken = strcmp(batch->parameter, own->parameter->name) == 0;
        for (size_t k = 0; k < batch->given_count; k++)
            taken = taken || strcmp(batch->given[k].name, own->parameter->name) == 0;
        if (taken && reader_reports(reader, "tolerance", own->parameter->name))
            problem_at_key(reader->problems, own->place,
                           "is a parameter that the study varies or sets itself, expected another one");
    }
}

/// Repeats the values of a batch for every machine of the samples; NULL after a problem, or if nothing varies.
static const double *repeat_values(case_reader *reader, const whirl_batch *batch, size_t machines) {
    if (!batch->values) return NULL;
    double *values = arena_take(reader->arena, machines * batch->count * sizeof *values);
    reader->no_memory = reader->no_memory || !values;
    for (size_t i = 0; values && i < machines; i++)
        memcpy(values + i * batch->count, batch->values, batch->count * sizeof *values);
    return values;
}

/// Adds a batch that computes the points of another batch for all sampled machines. It is called "tolerances", or
/// "tolerances_SWEEP" if several batches are sampled.
static void make_samples(case_reader *reader, const plan_parts *parts, const whirl_tolerance_options *options,
                         size_t index, bool several, study_plan *result) {
    const whirl_batch *of = &result->batches[index];
    const size_t machines = whirl_tolerance_machines(options);
    const setting_list *keys = &parts->tolerances.keys;
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, several ? "tolerances_%.52s" : "tolerances", of->name);
    if (result->batch_count == WHIRL_MAX_BATCHES) {
        problem_at_key(reader->problems, keys->place, "makes more than %d parts of a study", WHIRL_MAX_BATCHES);
        return;
    }
    if (of->carry != WHIRL_CARRY_NONE) {
        problem_at_key(reader->problems, keys->place,
                       "is given together with start: carry, expected one of the two: every sample starts anew");
        return;
    }
    if ((double)machines * (double)of->count > SCHEMA_MAX_POINTS) {
        problem_at_key(reader->problems, keys->place,
                       "makes %zu machines at %zu points each, expected at most %d points", machines, of->count,
                       SCHEMA_MAX_POINTS);
        return;
    }
    const double *values = repeat_values(reader, of, machines);
    if (of->values && !values) return;
    whirl_batch *batch = plan_add_like(result, index, WHIRL_ROLE_TOLERANCES, name, keys->place);
    batch->row = of->count;
    batch->count = machines * of->count;
    batch->values = values;
    batch->tolerances = *options;
    batch->tolerated = result->tolerated;
    batch->record.spectra = false;
    batch->record.waveform_revolutions = 0;
    if (whirl_analysis_kind(batch->analyses)->moves) {
        batch->analyses = whirl_analysis_fit(batch->analyses, &batch->record);
        plan_choose_analyses(batch, batch->analyses, false);
    }
    // A sample has no line in the case, so that its problems are reported at the key `tolerances`.
    plan_origin *origin = &result->origins[result->batch_count - 1];
    origin->each = NULL;
    origin->first = origin->last = origin->across = keys->place;
}

void tolerances_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const tolerance_parts *own = &parts->tolerances;
    whirl_tolerance_options options = {0};
    if (!own->keys.place || !settings_check(reader, v, &own->keys)) return;
    // Read the options and the distributions.
    settings_take(v, &own->keys, whirl_tolerance_members(), &options);
    options.parameters = (int)own->count;
    const setting *samples = settings_find(&own->keys, "samples"), *starts = settings_find(&parts->study, "starts");
    if (options.samples & (options.samples - 1))
        problem_at(reader->problems, samples->place, "is %d, expected a power of two: 64, 128, 256, ...",
                   options.samples);
    if (starts)
        problem_at_key(reader->problems, starts->place, "is given together with tolerances, expected one of the two");
    result->tolerated = arena_take(reader->arena, (own->count + 1) * sizeof *result->tolerated);
    result->spreads = arena_take(reader->arena, (own->asked.count + 1) * sizeof *result->spreads);
    reader->no_memory = reader->no_memory || !result->tolerated || !result->spreads;
    if (reader->no_memory) return;
    for (size_t i = 0; i < own->count; i++)
        if (!distribution_make(reader, v, &own->distributions[i], &result->tolerated[i])) return;
    memcpy(result->spreads, own->asked.spreads, own->asked.count * sizeof *result->spreads);
    result->tolerated_count = own->count;
    result->spread_count = own->asked.count;
    // Add a batch of samples for each batch that can be sampled.
    size_t sampled = 0;
    const size_t count = result->batch_count;
    for (size_t i = 0; i < count; i++) sampled += is_sampled(&result->batches[i]);
    if (sampled == 0)
        problem_at_key(reader->problems, own->keys.place,
                       "needs a response, a sweep, motions or a study of machines at rest, whose points it computes");
    for (size_t i = 0; i < count; i++) {
        if (!is_sampled(&result->batches[i])) continue;
        check_parameters(reader, parts, &result->batches[i]);
        make_samples(reader, parts, &options, i, sampled > 1, result);
    }
}
