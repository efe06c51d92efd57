// Checks of layouts that are read: tables of branches and tori have the shape that the program relies on.
#include <math.h>
#include <string.h>

#include "analysis.h"

/// Fields with one row for each coordinate of the state: they give its dimension.
static const char *const dimensions[] = {WHIRL_FIELD_TRACE_MULTIPLIERS, WHIRL_FIELD_TORUS_EXPONENTS};

/// Returns true if a layout has a field of an analysis.
static bool has_any(const whirl_layout *layout, const char *analysis) {
    const size_t length = strlen(analysis);
    for (size_t i = 0; i < layout->field_count; i++)
        if (strncmp(layout->fields[i].name, analysis, length) == 0 && layout->fields[i].name[length] == '/')
            return true;
    return false;
}

/// Recovers the shape that a layout was made for, as far as these analyses depend on it.
static block_shape shape_of(const whirl_layout *layout, const whirl_record_options *options) {
    block_shape shape = {.options = options};
    for (size_t i = 0; i < sizeof dimensions / sizeof *dimensions; i++) {
        const whirl_field *field = whirl_layout_field(layout, dimensions[i]);
        if (field) shape.dimension = field->rows;
    }
    const whirl_field *touches = whirl_layout_field(layout, WHIRL_FIELD_TRACE_TOUCHES);
    shape.touch_count = touches ? touches->rows : 0;
    shape.axial =
        whirl_layout_field(layout, WHIRL_FIELD_TRACE_AXIAL) || whirl_layout_field(layout, WHIRL_FIELD_TORUS_AXIAL);
    shape.also_twists =
        whirl_layout_field(layout, WHIRL_FIELD_TRACE_TWIST) || whirl_layout_field(layout, WHIRL_FIELD_TORUS_TWIST);
    return shape;
}

static whirl_status check_plan(const whirl_layout *layout, const analysis_plan *plan, const block_shape *shape) {
    for (size_t f = 0; f < plan->field_count; f++) {
        const field_plan *own = &plan->fields[f];
        const size_t rows = own->rows ? own->rows(shape) : 1;
        const whirl_field *field = whirl_layout_field(layout, own->name);
        const size_t found = field ? field->rows : 0;
        if (found != rows) return whirl_fail(WHIRL_BAD_INPUT, "%s has %zu rows, expected %zu", own->name, found, rows);
    }
    return whirl_ok();
}

whirl_status whirl_layout_check(const whirl_layout *layout, whirl_analysis_set set,
                                const whirl_record_options *options) {
    const block_shape shape = shape_of(layout, options);
    whirl_status status = whirl_ok();
    for (size_t a = 0; analysis_plans[a] && status.code == WHIRL_OK; a++) {
        const analysis_plan *plan = analysis_plans[a];
        const bool wanted = (set >> a & 1u) || has_any(layout, whirl_analyses()[a].name);
        if ((plan->compute_trace || plan->compute_torus) && wanted) status = check_plan(layout, plan, &shape);
    }
    return status;
}

whirl_status whirl_block_check(const whirl_layout *layout, const double *block, const whirl_record_options *options) {
    const double longest = (double)options->trace.longest;
    const struct {
        const char *field;
        double most;
    } counts[] = {{WHIRL_FIELD_TRACE_REVOLUTIONS, longest},
                  {WHIRL_FIELD_TORUS_REVOLUTIONS, longest},
                  {WHIRL_FIELD_TORUS_NODE_COUNT, (double)whirl_trace_torus_nodes(&options->trace)}};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        const whirl_field *field = whirl_layout_field(layout, counts[i].field);
        const double count = field ? block[field->offset] : (double)NAN;
        if (count < 0.0 || count > counts[i].most)
            return whirl_fail(WHIRL_BAD_INPUT, "%s is %g, expected 0 to %g", counts[i].field, count, counts[i].most);
    }
    return whirl_ok();
}
