// The block of a point: where its numbers lie, and how the analyses fill them.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "analysis.h"

static whirl_status check_needs(const char *name, const analysis_plan *plan, const whirl_record_options *options) {
    if (plan->needs_waveform && !options->waveform) {
        return whirl_fail(WHIRL_BAD_INPUT, "the analysis '%s' needs waveforms, but none are recorded", name);
    }
    if (plan->needs_growth > options->growth) {
        return whirl_fail(WHIRL_BAD_INPUT, "the analysis '%s' needs the growth of %s, but %s followed", name,
                          plan->needs_growth == WHIRL_GROWTH_ALL ? "all perturbations" : "a perturbation",
                          options->growth == WHIRL_GROWTH_NONE ? "none is" : "only one is");
    }
    return whirl_ok();
}

void whirl_analysis_needs(whirl_analysis_set set, whirl_record_options *options) {
    for (size_t a = 0; analysis_plans[a]; a++) {
        if (!(set >> a & 1u)) continue;
        const analysis_plan *plan = analysis_plans[a];
        options->waveform = options->waveform || plan->needs_waveform;
        if (plan->needs_growth > options->growth) options->growth = plan->needs_growth;
        if (plan->uses_growth > options->growth) options->growth = plan->uses_growth;
        options->orbits = options->orbits || plan->uses_orbits;
    }
}

static size_t layout_repetitions(whirl_extent extent, const block_shape *shape) {
    switch (extent) {
    case WHIRL_PER_STATION:
        return shape->station_count;
    case WHIRL_PER_CONTACT:
        return shape->contact_count;
    case WHIRL_PER_POINT:
        break;
    }
    return 1;
}

static whirl_status add_field(whirl_layout *layout, const field_plan *plan, const block_shape *shape) {
    const size_t rows = plan->rows ? plan->rows(shape) : 1;
    const size_t repeat = layout_repetitions(plan->extent, shape);
    if (rows == 0 || repeat == 0) return whirl_ok();
    if (layout->field_count == WHIRL_MAX_FIELDS) {
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields", WHIRL_MAX_FIELDS);
    }
    whirl_field *field = &layout->fields[layout->field_count++];
    *field = (whirl_field){.unit = plan->unit,
                           .meaning = plan->meaning,
                           .extent = plan->extent,
                           .rows = rows,
                           .columns = plan->columns,
                           .repeat = repeat,
                           .offset = layout->size};
    snprintf(field->name, sizeof field->name, "%s", plan->name);
    layout->size += rows * plan->columns * repeat;
    return whirl_ok();
}

static bool is_at_rest(whirl_analysis_set set) {
    for (size_t a = 0; analysis_plans[a]; a++)
        if ((set >> a & 1u) && analysis_plans[a]->compute_resting && !analysis_plans[a]->compute) return true;
    return false;
}

/// Returns the number of ranges of laws; 0 where springs replace the bearings, since results do not name the ranges of
/// such a machine.
static size_t range_count(const whirl_system *system, const whirl_record_options *options) {
    whirl_law_range range;
    size_t count = 0;
    while (!options->bearings && system->range && system->range(system->model, count, NULL, &range)) count++;
    return count;
}

whirl_status whirl_layout_new(const whirl_system *system, const whirl_integrate_options *integrate,
                              const whirl_record_options *options, whirl_analysis_set set, whirl_layout *layout) {
    // Check what all analyses need.
    *layout = (whirl_layout){0};
    whirl_status status = whirl_record_options_check(options);
    if (status.code == WHIRL_OK && integrate->steps_per_revolution < 1)
        status = whirl_fail(WHIRL_BAD_INPUT, "a revolution has %d steps, expected 1 or more",
                            integrate->steps_per_revolution);
    if (status.code != WHIRL_OK) return status;
    // Describe the machine: the sizes of fields depend on it.
    block_shape shape = {
        .dimension = system->dimension,
        .station_count = system->probe_count,
        .contact_count = system->contact_count,
        .touch_count = whirl_touch_count(system),
        .range_count = range_count(system, options),
        .samples_per_revolution = (size_t)whirl_record_samples(options, integrate->steps_per_revolution),
        .at_rest = is_at_rest(set),
        .twists = system->twist != NULL,
        .axial = system->axial != NULL,
        .also_twists = system->extra_count > 0 && system->extras[system->extra_count - 1].twists,
        .torque_count = system->torque_count,
        .run_shaft_count = system->shaft_count,
        .excitation_count = system->torsion ? system->torsion->excitation_count : 0,
        .path_count = system->torsion ? system->torsion->path_count : 0,
        .options = options,
    };
    for (size_t p = 0; p < system->probe_count; p++) shape.runout_count += system->probes[p].runout_count;
    // Add the fields of the chosen analyses, in the order of the registry.
    for (size_t a = 0; analysis_plans[a] && status.code == WHIRL_OK; a++) {
        if (!(set >> a & 1u)) continue;
        const char *name = whirl_analyses()[a].name;
        const analysis_plan *plan = analysis_plans[a];
        status = check_needs(name, plan, options);
        for (size_t f = 0; f < plan->field_count && status.code == WHIRL_OK; f++) {
            status = add_field(layout, &plan->fields[f], &shape);
        }
    }
    return status;
}

whirl_status whirl_analysis_check(const whirl_system *system, whirl_analysis_set set) {
    whirl_status status = whirl_ok();
    for (size_t a = 0; analysis_plans[a] && status.code == WHIRL_OK; a++)
        if ((set >> a & 1u) && analysis_plans[a]->check_system) status = analysis_plans[a]->check_system(system);
    return status;
}

/// Describes two ranges, for a system that is made up to learn all fields. A field with a row for each range would
/// otherwise look like one with a single row.
static bool two_ranges(const void *model, size_t index, const whirl_extremes *seen, whirl_law_range *out) {
    (void)model, (void)seen, (void)out;
    return index < 2;
}

static double no_twist(const void *model, const double *v, double *shape) {
    (void)model, (void)v, (void)shape;
    return 0.0;
}

whirl_status whirl_layout_known(whirl_layout *layout) {
    const whirl_runout runout = {.order = 1};
    const whirl_probe probes[2] = {
        {.runout_count = 1, .runout = &runout}}; // two stations: a row for each must differ from a single row
    const whirl_extra twist = {.twists = true};
    const whirl_torsion torsion = {.excitation_count = 2, .path_count = 2};
    const whirl_system system = {.dimension = 2,
                                 .probe_count = 2,
                                 .contact_count = 1,
                                 .switch_count = 2,
                                 .probes = probes,
                                 .range = two_ranges,
                                 .twist = no_twist,
                                 .axial = no_twist,
                                 .extra_count = 1,
                                 .extras = &twist,
                                 .torque_count = 2,
                                 .shaft_count = 2,
                                 .torsion = &torsion};
    const whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    options.spectra = true;
    options.growth = WHIRL_GROWTH_ALL;
    options.waveform_revolutions = options.record;
    options.fit.unknowns = options.fit.motions = options.fit.numbers = 2;
    return whirl_layout_new(&system, &integrate, &options, ~0u, layout);
}

bool whirl_analysis_has_rows(const char *field) {
    for (size_t a = 0; analysis_plans[a]; a++)
        for (size_t f = 0; f < analysis_plans[a]->field_count; f++)
            if (strcmp(analysis_plans[a]->fields[f].name, field) == 0)
                return analysis_plans[a]->fields[f].rows && analysis_plans[a]->fields[f].rows != rows_of_axial &&
                       analysis_plans[a]->fields[f].rows != rows_of_twist;
    return false;
}

whirl_status whirl_analyze(const whirl_record *record, const whirl_record_options *options, whirl_analysis_set set,
                           const whirl_layout *layout, double *block) {
    for (size_t i = 0; i < layout->size; i++) block[i] = NAN;
    whirl_status status = whirl_ok();
    for (size_t a = 0; analysis_plans[a] && status.code == WHIRL_OK; a++) {
        if (!(set >> a & 1u)) continue;
        const analysis_plan *plan = analysis_plans[a];
        const block_view view = view_of(plan, layout, block);
        if (!plan->compute) continue;
        if (record->motion == WHIRL_BOUNDED) {
            status = plan->compute(record, options, &view);
        } else if (plan->compute_diverged) {
            plan->compute_diverged(record, &view);
        }
    }
    return status;
}

/// Computes an analysis of points that have no error yet, one after the other or, if it gains by that, together.
static void layout_analyze_points(const analysis_plan *plan, size_t count, const whirl_resting *points,
                                  const whirl_record_options *options, const block_view *views,
                                  whirl_status *statuses) {
    if (plan->compute_resting_together && count > 1) {
        plan->compute_resting_together(count, points, options, views, statuses);
        return;
    }
    for (size_t i = 0; i < count; i++)
        if (statuses[i].code == WHIRL_OK) statuses[i] = plan->compute_resting(&points[i], options, &views[i]);
}

whirl_status whirl_analyze_resting_together(size_t count, const whirl_resting *points,
                                            const whirl_record_options *options, whirl_analysis_set set,
                                            const whirl_layout *layout, double *const *blocks, whirl_status *statuses) {
    block_view *views = malloc((count + 1) * sizeof *views);
    if (!views) return whirl_fail(WHIRL_NO_MEMORY, "no memory for points at rest");
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < layout->size; k++) blocks[i][k] = NAN;
    for (size_t a = 0; analysis_plans[a]; a++) {
        if (!(set >> a & 1u) || !analysis_plans[a]->compute_resting) continue;
        for (size_t i = 0; i < count; i++) views[i] = view_of(analysis_plans[a], layout, blocks[i]);
        layout_analyze_points(analysis_plans[a], count, points, options, views, statuses);
    }
    free(views);
    return whirl_ok();
}

whirl_status whirl_analyze_resting(const whirl_resting *point, const whirl_record_options *options,
                                   whirl_analysis_set set, const whirl_layout *layout, double *block) {
    whirl_status own = whirl_ok();
    const whirl_status status = whirl_analyze_resting_together(1, point, options, set, layout, &block, &own);
    return status.code == WHIRL_OK ? own : status;
}

whirl_status whirl_analyze_trace(const whirl_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < layout->size; i++) block[i] = NAN;
    for (size_t a = 0; analysis_plans[a] && status.code == WHIRL_OK; a++) {
        const block_view view = view_of(analysis_plans[a], layout, block);
        if (view.fields[0] && analysis_plans[a]->compute_trace)
            status = analysis_plans[a]->compute_trace(trace, options, &view);
    }
    return status;
}

whirl_status whirl_analyze_torus(const whirl_torus_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < layout->size; i++) block[i] = NAN;
    for (size_t a = 0; analysis_plans[a] && status.code == WHIRL_OK; a++) {
        const block_view view = view_of(analysis_plans[a], layout, block);
        if (view.fields[0] && analysis_plans[a]->compute_torus)
            status = analysis_plans[a]->compute_torus(trace, options, &view);
    }
    return status;
}
