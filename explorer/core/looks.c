// Previews: shorter and coarser motions that can be shown at once. Chaos in a short run may be a transient, so a
// preview has a verdict only if the case's length must give the same.
#include "looks.h"

#include <string.h>

static bool shorten(int *length, int most) {
    const bool shorter = most > 0 && most < *length;
    if (shorter) *length = most;
    return shorter;
}

EXPORTED void explorer_plan_look(plan *p, int transient, int record, int steps) {
    whirl_record_options *r = &p->batch.record;
    whirl_integrate_options *i = &p->batch.integrate;
    look *l = &p->look;
    *l = (look){.transient = r->transient, .record = r->record, .steps = i->steps_per_revolution};
    l->coarser = !whirl_method_is_adaptive(i->method) && shorten(&i->steps_per_revolution, steps);
    const bool sooner = shorten(&r->transient, transient), briefer = shorten(&r->record, record);
    l->shorter = sooner || briefer || l->coarser;
    if (!l->shorter) return;
    r->settle = true;
    r->watch = 0; // its value was for another length
}

static double number(const plan *p, const double *block, const char *name) {
    const whirl_field *field = whirl_layout_field(&p->layout, name);
    return field ? block[field->offset] : 0.0;
}

/// Returns true for a motion that settled to 1e-11 or diverged: a longer run with the same steps would end in the same
/// way.
static bool ended_by_itself(const plan *p, const double *block) {
    const whirl_record_options *r = &p->batch.record;
    return number(p, block, WHIRL_FIELD_REGIME_REVOLUTIONS) < (double)(r->transient + r->record);
}

bool look_is_provisional(const plan *p, const double *block) {
    return p->look.shorter && (p->look.coarser || !ended_by_itself(p, block));
}

void look_withhold(const plan *p, double *block) {
    static const char *const verdict[] = {WHIRL_FIELD_REGIME_CODE, WHIRL_FIELD_REGIME_PERIOD, WHIRL_FIELD_REGIME_CURVES,
                                          WHIRL_FIELD_REGIME_DIVERGED_AT, WHIRL_FIELD_REGIME_CONFIDENCE};
    if (!look_is_provisional(p, block)) return;
    for (size_t i = 0; i < sizeof verdict / sizeof *verdict; i++) {
        const whirl_field *field = whirl_layout_field(&p->layout, verdict[i]);
        if (field) block[field->offset] = 0.0;
    }
}

void look_reason(const plan *p, text *sentence) {
    const whirl_record_options *r = &p->batch.record;
    text_add(sentence, "a first look of %d + %d revolutions", r->transient, r->record);
    if (p->look.coarser) text_add(sentence, " of %d steps", p->batch.integrate.steps_per_revolution);
    text_add(sentence, "; a verdict takes the %d + %d", p->look.transient, p->look.record);
    if (p->look.coarser) text_add(sentence, " of %d steps", p->look.steps);
    text_add(sentence, " that were asked for");
}
