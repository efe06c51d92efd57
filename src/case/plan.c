// Making the batches of a study from its parts.
#include "plan.h"
#include "plan_batches.h"
#include "plan_parts.h"
#include "schema.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "problem.h"
#include "tree.h"
#include "whirl/engine/analyze.h"

static whirl_record_options record_options(valuation *v, const plan_parts *parts, int steps) {
    whirl_record_options options = whirl_record_default();
    settings_take(v, &parts->integrate, whirl_record_members(), &options);
    settings_take(v, &parts->keep, whirl_record_members(), &options);
    if (!settings_find(&parts->keep, "samples") && options.samples_per_revolution > steps)
        options.samples_per_revolution = steps;
    return options;
}

void plan_options(valuation *v, const plan_parts *parts, whirl_integrate_options *integrate,
                  whirl_record_options *record) {
    *integrate = whirl_integrate_default();
    settings_take(v, &parts->integrate, whirl_integrate_members(), integrate);
    *record = record_options(v, parts, integrate->steps_per_revolution);
}

/// Returns the highest order that a machine names, or that runout of the shaft's surface shows to probes; 0 if there is
/// none.
static double highest_order(const whirl_system *system) {
    double highest = 0.0;
    whirl_named_order named;
    for (size_t i = 0; system->named_order && system->named_order(system->model, i, &named); i++)
        highest = fmax(highest, named.order);
    for (size_t s = 0; s < system->probe_count; s++)
        for (size_t i = 0; i < system->probes[s].runout_count; i++)
            highest = fmax(highest, system->probes[s].runout[i].order);
    return highest;
}

void plan_raise_order(const plan_parts *parts, const whirl_system *system, whirl_batch *batch) {
    enum { SAMPLES = 4 }; // a turn of the highest order
    const double wanted = ceil(highest_order(system) * (1.0 - 1e-9)) + 1.0;
    const int steps = batch->integrate.steps_per_revolution;
    whirl_record_options *record = &batch->record;
    if (wanted <= record->highest_order || !plan_moves(batch) || !whirl_analysis_has(batch->analyses, "spectrum") ||
        settings_find(&parts->keep, "highest_order"))
        return;
    if (!settings_find(&parts->keep, "samples"))
        record->samples_per_revolution = (int)fmin(fmax(record->samples_per_revolution, SAMPLES * wanted), steps);
    const double most = 0.5 * whirl_record_samples(record, steps);
    record->highest_order = fmax(record->highest_order, fmin(wanted, most));
}

double plan_smallest_gap(const whirl_system *system) {
    double smallest = (double)INFINITY;
    for (size_t i = 0; i < system->probe_count; i++) {
        const double clearance = system->probes[i].clearance, gap = system->probes[i].gap;
        if (clearance > 0.0) smallest = fmin(smallest, clearance);
        if (gap > 0.0) smallest = fmin(smallest, gap);
    }
    return smallest;
}

void plan_lower_tolerance(const plan_parts *parts, const whirl_system *system, whirl_batch *batch) {
    const double of_gap = 1e-9;
    if (settings_find(&parts->integrate, "atol")) return;
    batch->integrate.atol = fmin(batch->integrate.atol, of_gap * plan_smallest_gap(system));
}

static whirl_record_options detail_options(valuation *v, const plan_parts *parts, const whirl_record_options *rest) {
    whirl_record_options options = *rest;
    settings_take(v, &parts->detail, whirl_record_members(), &options);
    if (options.transient != rest->transient || options.record != rest->record) options.watch = 0;
    if (!settings_find(&parts->detail, "waveform") && options.waveform_revolutions > options.record)
        options.waveform_revolutions = options.record;
    return options;
}

void plan_choose_analyses(whirl_batch *batch, whirl_analysis_set chosen, bool spectra) {
    whirl_record_options *record = &batch->record;
    const whirl_kind *kind = whirl_analysis_kind(chosen);
    batch->analyses = kind->moves ? whirl_analysis_fit(chosen, record) : chosen;
    if (kind->moves || kind->place) whirl_analysis_add(&batch->analyses, whirl_analysis_of_ranges());
    record->spectra = spectra && kind->moves;
    record->waveform = false;
    record->growth = WHIRL_GROWTH_NONE;
    record->orbits = false;
    if (kind->moves) whirl_analysis_needs(batch->analyses, record);
    if (!kind->moves) record->waveform_revolutions = record->watch = 0;
    if (!kind->settles) record->transient = 0;
    if (!kind->settles) record->record = 1;
}

// ---------------------------------------------------------------- contradictions

/// Returns the place of a key in the file if it is given, else the place of its mapping.
static const file_node *plan_place(const setting_list *settings, const char *key) {
    const setting *given = settings_find(settings, key);
    return given ? given->place : settings->place;
}

static void check_record(case_reader *reader, const plan_parts *parts, const whirl_record_options *options, int steps) {
    if (options->samples_per_revolution > steps)
        problem_at(reader->problems, plan_place(&parts->keep, "samples"),
                   "is %d, expected at most steps_per_revolution (%d)", options->samples_per_revolution, steps);
    if (options->waveform_revolutions > options->record)
        problem_at(reader->problems, plan_place(&parts->keep, "waveform"),
                   "is %d, expected at most the revolutions of the record (%d)", options->waveform_revolutions,
                   options->record);
    if (options->watch != 0 &&
        (options->watch < options->record || options->watch > options->transient + options->record))
        problem_at(reader->problems, plan_place(&parts->integrate, "watch"),
                   "is %d, expected 0, or record (%d) to transient + record (%d)", options->watch, options->record,
                   options->transient + options->record);
    const double highest = whirl_record_samples(options, steps) / 2.0;
    if (settings_find(&parts->keep, "highest_order") && options->highest_order > highest)
        problem_at(reader->problems, plan_place(&parts->keep, "highest_order"),
                   "is %.10g, expected at most %.10g, half the samples per revolution (keep.samples)",
                   options->highest_order, highest);
}

static void check_analyses(case_reader *reader, const plan_parts *parts, const whirl_record_options *options) {
    const setting *chosen = settings_find(&parts->study, "analyze");
    const char *const needed = whirl_analysis_of_verdicts();
    whirl_analysis_set verdicts = 0;
    whirl_analysis_add(&verdicts, needed);
    if (settings_yes(&parts->study, "confirm") && !(parts->analyses & verdicts))
        problem_at(reader->problems, plan_place(&parts->study, "confirm"),
                   "is yes, but analyze lacks %s, whose verdicts would be confirmed", needed);
    if (!chosen || settings_find(&parts->study, "detail")) return;
    for (const file_node *item = chosen->place->first; item; item = item->next) {
        whirl_analysis_set one = 0;
        if (whirl_analysis_add(&one, item->text) && !(one & whirl_analysis_fit(one, options)))
            problem_at(reader->problems, item, "is %s, but no waveform is kept, expected keep: {waveform: ...}",
                       item->text);
    }
}

static void check_detail(case_reader *reader, const plan_parts *parts, const whirl_record_options *options) {
    if (options->waveform_revolutions > options->record)
        problem_at(reader->problems, plan_place(&parts->detail, "waveform"),
                   "is %d, expected at most the revolutions of the record (%d)", options->waveform_revolutions,
                   options->record);
}

// ---------------------------------------------------------------- batches

plan_origin *plan_next_origin(study_plan *result) {
    return &result->origins[result->batch_count];
}

whirl_batch *plan_add_batch(study_plan *result, whirl_role role, const char *name, const file_node *place) {
    whirl_batch *batch = &result->batches[result->batch_count];
    result->origins[result->batch_count++].place = place;
    *batch = (whirl_batch){.count = 1, .role = role};
    snprintf(batch->name, sizeof batch->name, "%s", name);
    return batch;
}

whirl_batch *plan_add_like(study_plan *result, size_t like, whirl_role role, const char *name, const file_node *place) {
    *plan_next_origin(result) = result->origins[like];
    whirl_batch *batch = plan_add_batch(result, role, name, place);
    *batch = result->batches[like];
    batch->role = role;
    snprintf(batch->name, sizeof batch->name, "%s", name);
    return batch;
}

/// Fills in values between two ends with equal differences; the last is exactly `to`, and no value between overflows.
static void space_values(double from, double to, size_t count, double *values) {
    for (size_t i = 0; i < count; i++) {
        const double share = count > 1 ? (double)i / (double)(count - 1) : 0.0;
        values[i] = (1.0 - share) * from + share * to;
    }
}

/// Fills in values between two ends with equal ratios.
static void scale_values(double from, double to, size_t count, double *values) {
    for (size_t i = 0; i < count; i++) values[i] = from * pow(to / from, (double)i / (double)(count - 1));
    values[count - 1] = count > 1 ? to : from;
}

/// Fills in values `step` apart, from the first on; the last is `to` itself if it is reached.
static void step_values(double from, double to, double step, size_t count, double *values) {
    for (size_t i = 0; i < count; i++) {
        values[i] = from + (double)i * copysign(step, to - from);
        if (fabs(values[i] - to) < 1e-6 * step) values[i] = to;
    }
}

/// Returns the carry of a sweep. "Up" and "down" refer to the parameter, carries to the order of its values.
static whirl_carry carry_of(const setting_list *sweep, bool rising) {
    if (strcmp(settings_word(sweep, "start"), "carry") != 0) return WHIRL_CARRY_NONE;
    const char *direction = settings_word(sweep, "direction");
    if (strcmp(direction, "both") == 0) return WHIRL_CARRY_BOTH;
    return (strcmp(direction, "up") == 0) == rising ? WHIRL_CARRY_FORWARD : WHIRL_CARRY_REVERSE;
}

bool plan_formula_value(case_reader *reader, valuation *v, const file_node *where, const number_formula *formula,
                        double *value) {
    const whirl_status status = valuation_number(v, formula, value);
    if (status.code != WHIRL_OK) problem_at(reader->problems, where, "%s", status.message);
    return status.code == WHIRL_OK;
}

/// Counts the steps from one end to the other, with tolerance for rounding.
static bool count_steps(case_reader *reader, const setting *given, double from, double to, double step, size_t *count) {
    char shown[SHOWN_SIZE];
    const double steps = floor(fabs(to - from) / fabs(step) + 1e-6);
    if (!(step > 0.0) || !isfinite(step))
        problem_at(reader->problems, given->place, "is %s, expected a distance above 0",
                   node_shown(given->place, shown));
    else if (!(steps < SCHEMA_MAX_POINTS))
        problem_at(reader->problems, given->place, "gives %.10g values, expected at most %d", steps + 1.0,
                   SCHEMA_MAX_POINTS);
    else
        *count = (size_t)steps + 1;
    return *count > 0;
}

/// Returns the values of an axis with two ends; NULL after a problem.
static double *range_values(case_reader *reader, valuation *v, const axis_parts *axis, size_t *count) {
    char shown[SHOWN_SIZE], end[SHOWN_SIZE];
    double from, to, distance = 0.0;
    const setting_list *sweep = &axis->keys;
    const setting *step = settings_find(sweep, "step");
    const bool ratios = strcmp(settings_word(sweep, "scale"), "log") == 0;
    // Evaluate the ends and the step.
    bool good = plan_formula_value(reader, v, plan_place(sweep, "from"), &axis->from, &from);
    good = plan_formula_value(reader, v, plan_place(sweep, "to"), &axis->to, &to) && good;
    if (step) good = plan_formula_value(reader, v, step->place, &axis->step, &distance) && good;
    if (!good) return NULL;
    if (ratios && !(to / from > 0.0 && isfinite(to / from))) {
        problem_at(reader->problems, plan_place(sweep, "scale"),
                   "is log from %s to %s, expected two ends above 0 or two below",
                   node_shown(plan_place(sweep, "from"), shown), node_shown(plan_place(sweep, "to"), end));
        return NULL;
    }
    // Count the values, and compute them.
    *count = step ? 0 : (size_t)settings_number(v, sweep, "points");
    if (step && !count_steps(reader, step, from, to, distance, count)) return NULL;
    double *values = arena_take(reader->arena, *count * sizeof *values);
    reader->no_memory = reader->no_memory || !values;
    if (!values) return NULL;
    if (step)
        step_values(from, to, distance, *count, values);
    else if (ratios)
        scale_values(from, to, *count, values);
    else
        space_values(from, to, *count, values);
    return values;
}

/// Returns the values of a list; NULL after a problem.
static double *list_values(case_reader *reader, valuation *v, const formula_list *list) {
    double *values = arena_take(reader->arena, list->count * sizeof *values);
    bool good = values != NULL;
    reader->no_memory = reader->no_memory || !values;
    for (size_t i = 0; i < list->count && values; i++)
        good = plan_formula_value(reader, v, list->places[i], &list->items[i], &values[i]) && good;
    return good ? values : NULL;
}

/// Checks that values rise or fall throughout: diagrams, regimes and carried states follow their order.
static bool check_order(case_reader *reader, const formula_list *list, const double *values) {
    char shown[SHOWN_SIZE], before[SHOWN_SIZE];
    for (size_t i = 1; i < list->count; i++) {
        const bool rises = values[1] > values[0];
        if (rises ? values[i] > values[i - 1] : values[i] < values[i - 1]) continue;
        problem_at(reader->problems, list->places[i], "is %s after %s, expected values that rise or fall throughout",
                   node_shown(list->places[i], shown), node_shown(list->places[i - 1], before));
        return false;
    }
    return true;
}

/// Returns the values of an axis in the order of the file; NULL after a problem.
static double *axis_values(case_reader *reader, valuation *v, const axis_parts *axis, size_t *count) {
    *count = axis->values.count;
    if (*count == 0) return range_values(reader, v, axis, count);
    double *values = list_values(reader, v, &axis->values);
    return values && check_order(reader, &axis->values, values) ? values : NULL;
}

/// Returns the place in the file of the first or last value of an axis.
static const file_node *end_place(const axis_parts *axis, bool last) {
    if (axis->values.count == 0) return plan_place(&axis->keys, last ? "to" : "from");
    return axis->values.places[last ? axis->values.count - 1 : 0];
}

/// Returns the end of a sweep that its steps do not reach; NaN if they reach it.
static double missed_end(valuation *v, const axis_parts *axis, double last) {
    double to;
    if (!settings_find(&axis->keys, "step") || valuation_number(v, &axis->to, &to).code != WHIRL_OK || last == to)
        return NAN;
    return to;
}

/// Fills in the origin of the next batch, whose points are along an axis.
static void note_axis(valuation *v, const axis_parts *axis, double last, study_plan *result) {
    plan_origin *origin = plan_next_origin(result);
    origin->first = end_place(axis, false);
    origin->last = end_place(axis, true);
    origin->units[0] = axis->written;
    origin->end = missed_end(v, axis, last);
}

whirl_batch *plan_make_axis(case_reader *reader, valuation *v, const axis_parts *axis, whirl_role role,
                            study_plan *result) {
    size_t count;
    double *values = axis_values(reader, v, axis, &count);
    if (!values) return NULL;
    note_axis(v, axis, values[count - 1], result);
    whirl_batch *batch = plan_add_batch(result, role, axis->keys.group->name, axis->keys.place);
    snprintf(batch->parameter, sizeof batch->parameter, "%.63s", axis->parameter->name);
    batch->count = count;
    batch->values = values;
    return batch;
}

static void make_sweep(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const setting_list *sweep = &parts->sweep.keys;
    plan_next_origin(result)->rest = strcmp(settings_word(sweep, "start"), "rest") == 0;
    whirl_batch *batch = plan_make_axis(reader, v, &parts->sweep, WHIRL_ROLE_SURVEY, result);
    if (batch) batch->carry = carry_of(sweep, batch->values[0] <= batch->values[batch->count - 1]);
}

/// An axis of a map, with its values. An axis without a parameter has one value.
typedef struct map_side {
    const axis_parts *parts;
    const double *values;
    size_t count;
} map_side;

/// Evaluates all axes. Returns the number of points; 0 if a value or the number is wrong.
static size_t map_sides(case_reader *reader, valuation *v, const plan_parts *parts, map_side sides[3]) {
    const axis_parts *const axes[] = {&parts->sweep, &parts->across, &parts->planes};
    char text[80] = "";
    double points = 1.0;
    bool good = true;
    for (size_t i = 0; i < 3; i++) {
        sides[i] = (map_side){.parts = axes[i], .count = 1};
        if (!axes[i]->parameter) continue;
        sides[i].values = axis_values(reader, v, axes[i], &sides[i].count);
        good = good && sides[i].values;
        points *= (double)sides[i].count;
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%zu", i ? " x " : "", sides[i].count);
    }
    if (!good) return 0;
    if (points <= SCHEMA_MAX_POINTS) return (size_t)points;
    problem_at(reader->problems, parts->map.place, "has %s points, expected at most %d", text, SCHEMA_MAX_POINTS);
    return 0;
}

/// Returns the value of an axis at every point of a map; it changes every `step` points.
static void fill_side(const map_side *side, size_t step, double *values, size_t points) {
    for (size_t i = 0; i < points; i++) values[i] = side->values[i / step % side->count];
}

/// Returns the width of the first squares of a refined map; 0 for other maps.
static size_t map_refine(case_reader *reader, valuation *v, const plan_parts *parts) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(&parts->map, "refine");
    if (!given) return 0;
    const size_t width = (size_t)settings_number(v, &parts->map, "refine");
    if ((width & (width - 1)) != 0)
        problem_at(reader->problems, given->place, "is %s, expected a power of two: 2, 4, 8, 16, ...",
                   node_shown(given->place, shown));
    if (!whirl_analysis_has(parts->analyses, whirl_analysis_of_verdicts()))
        problem_at_key(reader->problems, given->place, "needs the analysis %s, whose verdicts it uses",
                       whirl_analysis_of_verdicts());
    if (settings_find(&parts->study, "starts"))
        problem_at_key(reader->problems, given->place, "is given together with starts, expected one of the two");
    if (parts->planes.parameter)
        problem_at_key(reader->problems, given->place, "is given together with z, expected one of the two");
    return width;
}

static void make_map(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    map_side sides[3];
    const size_t count = map_sides(reader, v, parts, sides), axes = parts->planes.parameter ? 3 : 2;
    // Fill in the values of all points along each axis.
    double *values = count > 0 ? arena_take(reader->arena, axes * count * sizeof *values) : NULL;
    reader->no_memory = reader->no_memory || (count > 0 && !values);
    if (!values) return;
    for (size_t i = 0, step = 1; i < axes; step *= sides[i++].count)
        fill_side(&sides[i], step, values + i * count, count);
    mapped_evict(reader->arena->mapped);
    note_axis(v, &parts->sweep, sides[0].values[sides[0].count - 1], result);
    // Note the places in the file, and the units.
    plan_origin *origin = plan_next_origin(result);
    origin->rest = strcmp(settings_word(&parts->map, "start"), "rest") == 0;
    origin->across = end_place(&parts->across, true);
    origin->units[1] = parts->across.written;
    origin->units[2] = parts->planes.written;
    // Add the batch.
    whirl_batch *batch = plan_add_batch(result, parts->map.group == &schema_basin ? WHIRL_ROLE_BASIN : WHIRL_ROLE_MAP,
                                        parts->map.group->name, parts->map.place);
    snprintf(batch->parameter, sizeof batch->parameter, "%.63s", parts->sweep.parameter->name);
    snprintf(batch->second, sizeof batch->second, "%.63s", parts->across.parameter->name);
    batch->count = count;
    batch->row = sides[0].count;
    batch->refine = map_refine(reader, v, parts);
    batch->values = values;
    batch->second_values = values + count;
    if (axes < 3) return;
    origin->planes = end_place(&parts->planes, true);
    snprintf(batch->third, sizeof batch->third, "%.63s", parts->planes.parameter->name);
    batch->plane = sides[0].count * sides[1].count;
    batch->third_values = values + 2 * count;
}

static void make_detail(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    double *values = list_values(reader, v, &parts->at);
    if (!values) return;
    plan_next_origin(result)->each = parts->at.places;
    whirl_batch *batch = plan_add_batch(result, WHIRL_ROLE_DETAIL, "detail", parts->detail.place);
    snprintf(batch->parameter, sizeof batch->parameter, "%.63s", parts->sweep.parameter->name);
    batch->count = parts->at.count;
    batch->values = values;
}

// ---------------------------------------------------------------- branches

/// Finds a bound of branches and its place in the file; the sweep's bound if the branch has none.
static bool branch_bound(case_reader *reader, valuation *v, const plan_parts *parts, const study_plan *result,
                         size_t which, double *value, const file_node **place) {
    const char *key = which == 0 ? "from" : "to";
    const setting *given = settings_find(&parts->branch, key);
    if (given) {
        *place = given->place;
        return plan_formula_value(reader, v, given->place, which == 0 ? &parts->low : &parts->high, value);
    }
    const whirl_batch *sweep = &result->batches[0];
    *place = which == 0 ? result->origins[0].first : result->origins[0].last;
    *value = sweep->values[which == 0 ? 0 : sweep->count - 1];
    return true;
}

/// Returns the values at which branches begin, within the bounds; by default the first bound. NULL after a problem.
static double *begin_values(case_reader *reader, valuation *v, const plan_parts *parts, const double bounds[2],
                            size_t *count) {
    char shown[SHOWN_SIZE];
    const double low = fmin(bounds[0], bounds[1]), high = fmax(bounds[0], bounds[1]);
    double *values;
    *count = parts->begins.count > 0 ? parts->begins.count : 1;
    if (parts->begins.count == 0) {
        values = arena_take(reader->arena, sizeof *values);
        reader->no_memory = reader->no_memory || !values;
        if (values) values[0] = bounds[0];
        return values;
    }
    values = list_values(reader, v, &parts->begins);
    for (size_t i = 0; values && i < *count; i++) {
        if (values[i] >= low && values[i] <= high) continue;
        problem_at(reader->problems, parts->begins.places[i],
                   "is %s, expected a value between the bounds of the branch",
                   node_shown(parts->begins.places[i], shown));
        return NULL;
    }
    return values;
}

/// Returns the places in the file of the values at which branches begin.
static const file_node *const *begin_places(case_reader *reader, const plan_parts *parts, const file_node *first) {
    if (parts->begins.count > 0) return parts->begins.places;
    const file_node **place = arena_take(reader->arena, sizeof(const file_node *));
    reader->no_memory = reader->no_memory || !place;
    if (place) *place = first;
    return place;
}

/// Makes curves, which begin at the case's own value of the second parameter.
static void make_curves(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const setting_list *curves = &parts->curves;
    double low, high;
    bool good = plan_formula_value(reader, v, plan_place(curves, "from"), &parts->second_low, &low);
    good = plan_formula_value(reader, v, plan_place(curves, "to"), &parts->second_high, &high) && good;
    if (!good) return;
    const double own = v->values[parts->second - v->parameters->items];
    if (!(own >= fmin(low, high) && own <= fmax(low, high) && low != high)) {
        problem_at(reader->problems, plan_place(curves, "from"),
                   "gives bounds %.10g and %.10g, expected two around %.10g, the value of %s in the case", low, high,
                   own, parts->second->name);
        return;
    }
    whirl_batch *batch = plan_add_like(result, result->batch_count - 1, WHIRL_ROLE_CURVES, "curves", curves->place);
    snprintf(batch->second, sizeof batch->second, "%.63s", parts->second->name);
    batch->second_value = own;
    batch->second_bounds[0] = low;
    batch->second_bounds[1] = high;
}

/// Adds tori of the branches at index `branch`.
static void make_tori(const plan_parts *parts, size_t branch, study_plan *result) {
    whirl_batch *batch = plan_add_like(result, branch, WHIRL_ROLE_TORI, "tori", parts->branch.place);
    batch->analyses = 0;
    whirl_analysis_add(&batch->analyses, "torus");
}

static void make_branch(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const file_node *first, *last;
    double bounds[2];
    if (parts->swept_too && result->batch_count == 0) return; // has been reported
    if (!branch_bound(reader, v, parts, result, 0, &bounds[0], &first) ||
        !branch_bound(reader, v, parts, result, 1, &bounds[1], &last))
        return;
    if (bounds[0] == bounds[1]) {
        problem_at(reader->problems, last, "is where the branch begins, expected another value");
        return;
    }
    size_t count;
    const double *values = begin_values(reader, v, parts, bounds, &count);
    if (!values) return;
    *plan_next_origin(result) =
        (plan_origin){.each = begin_places(reader, parts, first), .units = {parts->sweep.written}, .end = NAN};
    whirl_batch *batch = plan_add_batch(result, WHIRL_ROLE_BRANCHES, "branch", parts->branch.place);
    snprintf(batch->parameter, sizeof batch->parameter, "%.63s", parts->sweep.parameter->name);
    batch->count = count;
    batch->values = values;
    memcpy(batch->bounds, bounds, sizeof bounds);
    whirl_analysis_add(&batch->analyses, "trace");
    const size_t own = result->batch_count - 1;
    if (parts->second) make_curves(reader, v, parts, result);
    if (settings_yes(&parts->branch, "tori")) make_tori(parts, own, result);
}

/// Fills in the parameter values as plan_given does, for one of the samples of a batch (whirl_batch.sampled).
static size_t given_of(const whirl_batch *batch, const double values[3], size_t sampled,
                       whirl_given given[PLAN_MAX_GIVEN]) {
    const whirl_given varied[] = {{batch->parameter, values[0]}, {batch->second, values[1]}, {batch->third, values[2]}};
    double drawn[WHIRL_MAX_DRAWN];
    size_t count = 0;
    for (size_t i = 0; i < 3 && *varied[i].name && !isnan(varied[i].value); i++) given[count++] = varied[i];
    for (size_t i = 0; i < batch->given_count; i++) given[count++] = batch->given[i];
    const size_t tolerated = sampled > 0 ? (size_t)batch->tolerances.parameters : 0;
    if (tolerated > 0) whirl_tolerance_values(&batch->tolerances, batch->tolerated, sampled - 1, drawn);
    for (size_t i = 0; i < tolerated; i++) given[count++] = (whirl_given){batch->tolerated[i].name, drawn[i]};
    const whirl_dataset *dataset = batch->dataset;
    if (!dataset || sampled == 0) return count;
    whirl_dataset_record(dataset, &batch->record.dataset, sampled - 1, drawn);
    for (size_t i = 0; i < dataset->parameter_count; i++)
        given[count++] = (whirl_given){dataset->parameters[i], drawn[i]};
    return count;
}

size_t plan_given(const whirl_batch *batch, double value, double second, double third,
                  whirl_given given[PLAN_MAX_GIVEN]) {
    return given_of(batch, (const double[]){value, second, third}, batch->sampled, given);
}

size_t plan_given_at(const whirl_batch *batch, size_t point, whirl_given given[PLAN_MAX_GIVEN]) {
    const double *const axes[] = {batch->values, batch->second_values, batch->third_values};
    double values[3];
    for (size_t i = 0; i < 3; i++) values[i] = axes[i] ? axes[i][point] : (double)NAN;
    const bool sampled = batch->tolerances.samples > 0;
    return given_of(batch, values, sampled ? 1 + point / batch->row : batch->dataset ? 1 + point : 0, given);
}

size_t plan_batch(const study_plan *plan, const char *name) {
    size_t i = 0;
    while (i < plan->batch_count && strcmp(plan->batches[i].name, name) != 0) i++;
    return i;
}

// ---------------------------------------------------------------- all batches

static bool check_all(case_reader *reader, valuation *v, const plan_parts *parts, const study_plan *result) {
    bool good = settings_check(reader, v, &parts->sweep.keys);
    good = settings_check(reader, v, &parts->across.keys) && good;
    good = settings_check(reader, v, &parts->planes.keys) && good;
    good = settings_check(reader, v, &parts->map) && good;
    good = settings_check(reader, v, &parts->integrate) && good;
    good = settings_check(reader, v, &parts->keep) && good;
    good = settings_check(reader, v, &parts->detail) && good;
    good = settings_check(reader, v, &parts->branch) && good;
    good = settings_check(reader, v, &parts->curves) && good;
    good = (!settings_find(&parts->study, "starts") || settings_check(reader, v, &parts->starts)) && good;
    for (size_t i = 0; i < result->start_count; i++) good = settings_check(reader, v, &result->starts[i].state) && good;
    for (size_t i = 0; i < result->range_count; i++)
        good = settings_check(reader, v, &result->ranges[i].low) &&
               settings_check(reader, v, &result->ranges[i].high) && good;
    return good;
}

static void finish_found(valuation *v, const plan_parts *parts, whirl_batch *batch) {
    settings_take(v, &parts->branch, whirl_trace_members(), &batch->record.trace);
    plan_choose_analyses(batch, batch->analyses, false);
}

/// Returns the number of starts: the initial state, and all combinations of a grid's values; more than WHIRL_MAX_STARTS
/// if there are too many.
static size_t count_grid(const study_plan *plan) {
    size_t count = 1;
    for (size_t i = 0; i < plan->range_count; i++)
        for (size_t k = 0; plan->ranges[i].points && k < plan->ranges[i].low.count; k++)
            if (count <= WHIRL_MAX_STARTS) count *= plan->ranges[i].points[k];
    return count + 1;
}

/// Refuses more starts than a point or a study may have, and neighbours of a single point.
static void check_starts(case_reader *reader, const plan_parts *parts, const file_node *place,
                         const whirl_batch *batch) {
    const bool neighbours = batch->neighbours > 0;
    const size_t all = batch->starts + (neighbours ? WHIRL_MAX_NEIGHBOUR_STARTS : 0);
    if (batch->starts > WHIRL_MAX_STARTS)
        problem_at(reader->problems, place, "has more than the %d starts that a point may have", WHIRL_MAX_STARTS);
    else if ((double)batch->count * (double)all > SCHEMA_MAX_POINTS)
        problem_at(reader->problems, place, "is %zu at %zu points%s, expected at most %d starts in all", batch->starts,
                   batch->count, neighbours ? " with up to 16 from neighbours at each" : "", SCHEMA_MAX_POINTS);
    if (neighbours && batch->count <= 1)
        problem_at(reader->problems, plan_place(&parts->starts, "neighbours"),
                   "has no meaning with one point, which has no neighbours");
}

/// Sets the starts of a batch. Points in detail have only the first start.
static void take_starts(case_reader *reader, valuation *v, const plan_parts *parts, const study_plan *plan,
                        whirl_batch *batch) {
    if (!settings_find(&parts->study, "starts") || batch->role == WHIRL_ROLE_DETAIL) return;
    const setting *grid = settings_find(&parts->starts, "grid");
    batch->starts = grid ? count_grid(plan) : (size_t)settings_number(v, &parts->starts, "count");
    batch->neighbours = (size_t)settings_number(v, &parts->starts, "neighbours");
    check_starts(reader, parts, grid ? grid->place : plan_place(&parts->starts, "count"), batch);
}

const setting_list *plan_keep_keys(case_reader *reader, const setting_list *keys) {
    setting_list *kept = keys ? arena_take(reader->arena, sizeof *kept) : NULL;
    reader->no_memory = reader->no_memory || (keys && !kept);
    if (kept) *kept = *keys;
    return kept;
}

void plan_keep_options(case_reader *reader, const plan_parts *parts, const whirl_batch *batch, plan_origin *origin) {
    const bool found = whirl_analysis_kind(batch->analyses)->found;
    origin->options[0] = plan_keep_keys(reader, &parts->integrate);
    origin->options[1] = plan_keep_keys(reader, &parts->keep);
    origin->options[2] = plan_keep_keys(reader, found                              ? &parts->branch
                                                : batch->role == WHIRL_ROLE_DETAIL ? &parts->detail
                                                                                   : NULL);
}

void plan_finish_points(case_reader *reader, valuation *v, const plan_parts *parts, const study_plan *plan,
                        whirl_batch *batch) {
    settings_take(v, &parts->study, whirl_batch_members(), batch);
    take_starts(reader, v, parts, plan, batch);
    if (batch->role == WHIRL_ROLE_DETAIL) {
        batch->record = detail_options(v, parts, &batch->record);
        check_detail(reader, parts, &batch->record);
    }
    plan_choose_analyses(batch, parts->analyses, !batch->values || batch->role == WHIRL_ROLE_DETAIL);
}

void plan_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    // Check what the batches need, and read the options that they share.
    if (!check_all(reader, v, parts, result)) return;
    for (size_t i = 0; i < WHIRL_MAX_BATCHES; i++) result->origins[i].end = NAN;
    whirl_integrate_options integrate;
    whirl_record_options record;
    plan_options(v, parts, &integrate, &record);
    check_record(reader, parts, &record, integrate.steps_per_revolution);
    check_analyses(reader, parts, &record);
    // Add the batch of the study itself: a map, a sweep or a point.
    if (parts->across.parameter)
        make_map(reader, v, parts, result);
    else if (parts->moves && parts->sweep.parameter)
        make_sweep(reader, v, parts, result);
    else if (parts->moves && !parts->dataset.keys.place)
        plan_add_batch(result, WHIRL_ROLE_POINT, schema_response.name, parts->study.place);
    // Add the batches of its points in detail and of its branches.
    if (parts->at.count > 0) make_detail(reader, v, parts, result);
    if (parts->branches && parts->sweep.parameter) make_branch(reader, v, parts, result);
    // Give options to all batches.
    for (size_t i = 0; i < result->batch_count; i++) {
        whirl_batch *batch = &result->batches[i];
        batch->integrate = integrate;
        batch->record = record;
        plan_keep_options(reader, parts, batch, &result->origins[i]);
        if (whirl_analysis_kind(batch->analyses)->found)
            finish_found(v, parts, batch);
        else
            plan_finish_points(reader, v, parts, result, batch);
    }
}

bool plan_moves(const whirl_batch *batch) {
    const whirl_kind *kind = whirl_analysis_kind(batch->analyses);
    return kind->moves || kind->found;
}

whirl_status plan_check_speed(const whirl_batch *batch, double speed) {
    if (speed > 0.0 || whirl_analysis_kind(batch->analyses)->still) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "speed is %g rad/s, expected a number above 0", speed);
}
