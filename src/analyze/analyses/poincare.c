// Poincare sections: the state of every station once per revolution, in step with the forcing.
#include "analysis.h"

static size_t recorded_revolutions(const block_shape *shape) {
    return (size_t)shape->options->record;
}

enum { SECTION };

static const field_plan fields[] = {
    [SECTION] = {WHIRL_FIELD_POINCARE_SECTION, "length",
                 "x, y, vx, vy (from the centre; velocities are lengths per unit of the system's time)",
                 WHIRL_PER_STATION, 4, recorded_revolutions},
};

static whirl_status poincare_compute(const whirl_record *record, const whirl_record_options *options,
                                     const block_view *view) {
    (void)options;
    const double *oldest = record->section + (record->section_count - record->record_count) * record->dimension;
    for (size_t s = 0; s < record->probe_count; s++) {
        const whirl_probe *probe = &record->probes[s];
        double *out = view_numbers(view, SECTION, s);
        for (size_t n = 0; n < record->record_count; n++) {
            const double *state = oldest + n * record->dimension;
            for (size_t c = 0; c < 4; c++) *out++ = whirl_probe_value(probe, state, c);
        }
    }
    return whirl_ok();
}

const analysis_plan poincare_analysis = {.fields = fields, .field_count = 1, .compute = poincare_compute};
