// Waveforms: displacements that probes see, axial displacements and twists, over the last revolutions of the record.
#include <stdlib.h>

#include "analysis.h"

static size_t kept_samples(const block_shape *shape) {
    return (size_t)shape->options->waveform_revolutions * shape->samples_per_revolution;
}

static size_t kept_axial(const block_shape *shape) {
    return rows_of_axial(shape) * kept_samples(shape);
}

static size_t kept_twist(const block_shape *shape) {
    return rows_of_twist(shape) * kept_samples(shape);
}

enum { SAMPLES, AXIAL, TWIST, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [SAMPLES] = {WHIRL_FIELD_WAVEFORM_SAMPLES, "length",
                 "x, y (from the centre, at equal angles; with runout, where there is any)", WHIRL_PER_STATION, 2,
                 kept_samples},
    [AXIAL] = {WHIRL_FIELD_WAVEFORM_AXIAL, "length",
               "axial displacement at these angles (missing where the station does not move along its shaft)",
               WHIRL_PER_STATION, 1, kept_axial},
    [TWIST] = {WHIRL_FIELD_WAVEFORM_TWIST, "rad",
               "twist at these angles (missing where the station does not twist, or moves no other way)",
               WHIRL_PER_STATION, 1, kept_twist},
};

static whirl_status waveform_compute(const whirl_record *record, const whirl_record_options *options,
                                     const block_view *view) {
    const size_t kept = (size_t)options->waveform_revolutions * record->samples_per_revolution;
    if (kept > record->sample_count) {
        return whirl_fail(WHIRL_BAD_INPUT, "the record holds %zu samples of a waveform, expected %zu or more",
                          record->sample_count, kept);
    }
    double *x = malloc((2 * kept + 1) * sizeof *x);
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a waveform of %zu samples", kept);
    for (size_t s = 0; s < record->probe_count && kept > 0; s++) {
        double *out = view_numbers(view, SAMPLES, s);
        fill_seen(record, s, kept, x);
        for (size_t j = 0; j < kept; j++) {
            *out++ = x[j];
            *out++ = x[kept + j];
        }
    }
    for (size_t i = 0; i < record->extra_count && kept > 0; i++) {
        const whirl_extra *extra = &record->extras[i];
        fill_seen(record, record->probe_count + i, kept, x);
        memcpy(view_numbers(view, extra->twists ? TWIST : AXIAL, extra->station), x, kept * sizeof *x);
    }
    free(x);
    return whirl_ok();
}

const analysis_plan waveform_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_waveform = true, .compute = waveform_compute};
