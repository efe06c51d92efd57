// Fields with further evidence, beyond that of every verdict.
#include <math.h>

#include "analysis.h"
#include "correlation.h"
#include "evidence.h"
#include "multiplier.h"
#include "section.h"
#include "zero_one.h"

enum { CHAOS, CORRELATION, MEMORY, SETTLING, MULTIPLIER, MODULUS, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [CHAOS] = {WHIRL_FIELD_EVIDENCE_CHAOS, "1", "K of the 0-1 test, near 1 in chaos, near 0 for regular motion",
               WHIRL_PER_POINT, 1, NULL},
    [CORRELATION] = {WHIRL_FIELD_EVIDENCE_CORRELATION, "1",
                     "largest correlation of points that are 1/8 to 1/4 of the watched ones apart", WHIRL_PER_POINT, 1,
                     NULL},
    [MEMORY] = {WHIRL_FIELD_EVIDENCE_MEMORY, "revolution",
                "revolutions after which the correlation stays below 0.2 (missing: it does not)", WHIRL_PER_POINT, 1,
                NULL},
    [SETTLING] = {WHIRL_FIELD_EVIDENCE_SETTLING, "1/revolution",
                  "rate at which returns grow, below 0 while the motion settles", WHIRL_PER_POINT, 1, NULL},
    [MULTIPLIER] = {WHIRL_FIELD_EVIDENCE_MULTIPLIER, "1",
                    "real, imaginary (largest Floquet multiplier, where the way to rest shows it)", WHIRL_PER_POINT, 2,
                    NULL},
    [MODULUS] = {WHIRL_FIELD_EVIDENCE_MODULUS, "1", "modulus of the largest Floquet multiplier of P-k, by the exponent",
                 WHIRL_PER_POINT, 1, NULL},
};

static whirl_status evidence_fields_compute(const whirl_record *record, const whirl_record_options *options,
                                            const block_view *view) {
    const evidence e = evidence_gather(record);
    const correlation c = correlation_find(&e.points, e.rounding * e.size);
    const whirl_verdict verdict = whirl_judge(record);
    (void)options;
    *view_numbers(view, CHAOS, 0) = zero_one_test(&e.points, e.size);
    *view_numbers(view, CORRELATION, 0) = c.late;
    *view_numbers(view, MEMORY, 0) = c.time;
    *view_numbers(view, SETTLING, 0) = settling_rate(&e);
    if (verdict.regime == WHIRL_PERIODIC) {
        const multiplier m = multiplier_find(&e.points, verdict.period, e.size, e.rounding);
        view_numbers(view, MULTIPLIER, 0)[0] = m.real;
        view_numbers(view, MULTIPLIER, 0)[1] = m.imaginary;
        *view_numbers(view, MODULUS, 0) = exp(verdict.exponent.value * verdict.period);
    }
    return whirl_ok();
}

const analysis_plan evidence_analysis = {.fields = fields,
                                         .field_count = FIELD_COUNT,
                                         .uses_growth = WHIRL_GROWTH_LARGEST,
                                         .compute = evidence_fields_compute};
