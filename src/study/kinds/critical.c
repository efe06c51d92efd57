// Critical speeds and stability thresholds between two points: follows modes from one machine to the next and closes in
// on sign changes.
#include "kinds.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"

/// A batch at a value of its parameter.
typedef struct place {
    const whirl_study *study;
    const whirl_batch *batch;
    double value;
} place;

static whirl_status at_frequency(const void *context, double frequency, whirl_machine *machine) {
    const place *at = context;
    whirl_batch batch = *at->batch;
    batch.asynchronous = true;
    batch.frequency = frequency;
    return at->study->machine(at->study->family, &batch, at->value, machine);
}

whirl_status resting_new(const whirl_study *study, const whirl_batch *batch, double value, resting_machine *out) {
    *out = (resting_machine){.value = value};
    whirl_status status = study->machine(study->family, batch, value, &out->machine);
    if (status.code != WHIRL_OK) return status;
    const place at = {study, batch, value};
    status = whirl_modes_of(&out->machine, &(whirl_whirling){at_frequency, &at}, &out->modes);
    if (status.code == WHIRL_BAD_INPUT && *batch->parameter)
        status = whirl_fail(status.code, "at %s = %.10g: %.300s", batch->parameter, value, status.message);
    if (status.code != WHIRL_OK) resting_free(out);
    return status;
}

void resting_free(resting_machine *r) {
    whirl_modes_free(r->modes);
    free(r->before);
    if (r->machine.release) r->machine.release(r->machine.owner);
    *r = (resting_machine){.modes = NULL};
}

/// Returns true if eigenvalues are equal: shapes of a multiple eigenvalue are arbitrary mixtures of each other.
static bool is_equal(const whirl_mode *a, const whirl_mode *b, double scale) {
    return hypot(scale * a->real - b->real, scale * a->imaginary - b->imaginary) <= 1e-6 * hypot(b->real, b->imaginary);
}

static whirl_status critical_no_memory(void) {
    return whirl_fail(WHIRL_NO_MEMORY, "no memory to follow modes");
}

/// Matches the modes of two machines (whirl_modes_match). *partner is to be freed, after a failure too.
static whirl_status critical_match(const resting_machine *from, const resting_machine *to, size_t **partner,
                                   double *unlike) {
    *partner = malloc((from->modes->count + 1) * sizeof **partner);
    if (!*partner) return critical_no_memory();
    return whirl_modes_match(from->modes, to->modes, from->machine.clock / to->machine.clock, *partner, unlike);
}

whirl_status resting_follow(const resting_machine *from, resting_machine *to) {
    const size_t count = from->modes->count;
    const double scale = from->machine.clock / to->machine.clock;
    if (from->modes->period > 0.0 || to->modes->period > 0.0)
        return whirl_ok(); // Floquet frequencies are known up to multiples of the speed
    size_t *partner = NULL;
    double *unlike = malloc((count + 1) * sizeof *unlike);
    to->before = calloc(to->modes->count + 1, sizeof *to->before);
    whirl_status status = unlike && to->before ? critical_match(from, to, &partner, unlike) : critical_no_memory();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++)
        if (unlike[i] < 1.0 ||
            (partner[i] < to->modes->count && is_equal(&from->modes->modes[i], &to->modes->modes[partner[i]], scale)))
            to->before[partner[i]] = i + 1;
    free(partner);
    free(unlike);
    return status;
}

/// A search between two values for a mode's critical speed or, without a mode, for the stability threshold.
typedef struct search {
    const whirl_study *study;
    const whirl_batch *batch;
    const resting_machine *from; ///< machine with the mode to follow
    size_t mode;                 ///< index of the mode; SIZE_MAX: the stability threshold
    whirl_critical at;           ///< result at the last value tried
} search;

/// Returns the growth rate of the machine's least stable mode, 1/s.
static double growth_of(const resting_machine *r) {
    return r->machine.clock * r->modes->growth;
}

/// Returns the oscillating mode that decides stability, SIZE_MAX without one. A growth within rounding counts as 0.
static size_t critical_deciding(const whirl_modes *modes) {
    const double rounding = 1e-9;
    for (size_t i = 0; i < modes->count; i++) {
        const whirl_mode *own = &modes->modes[i];
        if (own->real == modes->growth) return i;
        if (modes->growth == 0.0 && fabs(own->real) <= rounding * fabs(own->imaginary)) return i;
    }
    return SIZE_MAX;
}

static double distance_of(const resting_machine *r, size_t mode) {
    return r->machine.clock * r->modes->modes[mode].imaginary - fabs(r->machine.speed);
}

static void critical_describe(search *s, const resting_machine *r, size_t mode) {
    s->at = (whirl_critical){.value = r->value, .speed = r->machine.speed};
    if (mode >= r->modes->count) return;
    const whirl_mode *own = &r->modes->modes[mode];
    s->at.frequency = r->machine.clock * own->imaginary;
    s->at.ratio = (0.0 - own->real) / hypot(own->real, own->imaginary);
    s->at.direction = own->direction;
}

/// Evaluates the function whose zero is searched; NaN if the mode is lost.
static whirl_status critical_measure(search *s, const resting_machine *r, double *result) {
    size_t mode = critical_deciding(r->modes);
    *result = growth_of(r);
    if (s->mode != SIZE_MAX) {
        size_t *partner;
        const whirl_status status = critical_match(s->from, r, &partner, NULL);
        if (status.code == WHIRL_OK) mode = partner[s->mode];
        free(partner);
        if (status.code != WHIRL_OK) return status;
        *result = mode < r->modes->count ? distance_of(r, mode) : (double)NAN;
    }
    critical_describe(s, r, mode);
    return whirl_ok();
}

static whirl_status measure_at(search *s, double value, double *result) {
    resting_machine r;
    whirl_status status = resting_new(s->study, s->batch, value, &r);
    if (status.code != WHIRL_OK) return status;
    status = critical_measure(s, &r, result);
    resting_free(&r);
    return status;
}

/// Closes in on the zero between a and b, where fa and fb have different signs. *found is false if the mode is lost on
/// the way, or jumps.
static whirl_status critical_close_in(search *s, double a, double fa, double b, double fb, bool *found) {
    enum { MAX_STEPS = 100 };
    const double jump = 1e-3 * fmax(fabs(fa), fabs(fb));
    bracket r = bracket_between(a, fa, b, fb);
    for (int k = 0; k < MAX_STEPS; k++) {
        const double width = bracket_width(&r), middle = 0.5 * (r.a + r.b), c = bracket_next(&r);
        double fc;
        const whirl_status status = measure_at(s, c, &fc);
        if (status.code != WHIRL_OK) return status;
        if (isnan(fc)) break;
        bracket_update(&r, c, fc);
        if (fc == 0.0 || bracket_width(&r) <= 1e-11 * fmax(fabs(r.a), fabs(r.b)) ||
            fabs(c - middle) + width <= 1e-300) {
            *found = fabs(fc) <= jump;
            return status;
        }
        // The value at c is so near zero that only rounding is left.
        if (fabs(fc) <= 1e-13 * (fabs(s->at.frequency) + fabs(s->at.speed)) && s->mode != SIZE_MAX) {
            *found = true;
            return status;
        }
    }
    *found = false;
    return whirl_ok();
}

static void critical_add(whirl_critical *found, size_t most, size_t *count, const whirl_critical *one) {
    if (*count < most) found[(*count)++] = *one;
}

static int by_value(const void *a, const void *b) {
    const whirl_critical *p = a, *q = b;
    if (p->value != q->value) return p->value < q->value ? -1 : 1;
    return p->direction < q->direction ? -1 : p->direction > q->direction;
}

static whirl_critical_kind critical_kind(const whirl_mode *mode) {
    static const whirl_critical_kind kinds[] = {[WHIRL_LATERAL_MODE] = WHIRL_CRITICAL_SPEED,
                                                [WHIRL_TORSIONAL_MODE] = WHIRL_TORSIONAL_SPEED,
                                                [WHIRL_AXIAL_MODE] = WHIRL_AXIAL_SPEED};
    return kinds[whirl_mode_kind_of(mode->torsion, mode->axial)];
}

/// Locates critical speeds; overdamped modes have none. *lost: a mode that crosses the speed could not be followed to
/// the crossing.
static whirl_status locate_speeds(search *s, const resting_machine *to, const size_t *partner, whirl_critical *found,
                                  size_t most, size_t *count, bool *lost) {
    const resting_machine *from = s->from;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < from->modes->count && status.code == WHIRL_OK; i++) {
        if (partner[i] >= to->modes->count) continue;
        const double fa = distance_of(from, i), fb = distance_of(to, partner[i]);
        bool good = true;
        if ((fa < 0.0) == (fb < 0.0) || fa == 0.0) continue;
        s->mode = i;
        if (fb == 0.0)
            critical_describe(s, to, partner[i]);
        else
            status = critical_close_in(s, from->value, fa, to->value, fb, &good);
        s->at.kind = critical_kind(&from->modes->modes[i]);
        *lost = *lost || !good;
        if (good && status.code == WHIRL_OK && s->at.ratio <= WHIRL_OVERDAMPED_RATIO)
            critical_add(found, most, count, &s->at);
    }
    return status;
}

static whirl_status locate_threshold(search *s, const resting_machine *to, whirl_critical *found, size_t most,
                                     size_t *count, bool *lost) {
    const double fa = growth_of(s->from), fb = growth_of(to);
    if ((fa > 0.0) == (fb > 0.0)) return whirl_ok();
    s->mode = SIZE_MAX;
    // A point may lie on the threshold.
    const resting_machine *on = fa == 0.0 ? s->from : fb == 0.0 ? to : NULL;
    whirl_status status = whirl_ok();
    bool good = on != NULL;
    if (on)
        critical_describe(s, on, critical_deciding(on->modes));
    else
        status = critical_close_in(s, s->from->value, fa, to->value, fb, &good);
    s->at.kind = (fb > 0.0) == (to->value > s->from->value) ? WHIRL_ONSET : WHIRL_RECOVERY;
    *lost = *lost || !good;
    if (good && status.code == WHIRL_OK) critical_add(found, most, count, &s->at);
    return status;
}

static whirl_status critical_locate_pieces(search *s, const resting_machine *to, whirl_critical *found, size_t most,
                                           size_t *count, bool *lost) {
    const whirl_modes *from = s->from->modes;
    whirl_status status = whirl_ok();
    // Floquet frequencies are known up to multiples of the speed: each mode would cross it.
    if (from->period == 0.0 && to->modes->period == 0.0) {
        size_t *partner;
        status = critical_match(s->from, to, &partner, NULL);
        if (status.code == WHIRL_OK) status = locate_speeds(s, to, partner, found, most, count, lost);
        free(partner);
    }
    return status.code == WHIRL_OK ? locate_threshold(s, to, found, most, count, lost) : status;
}

/// Locates in halves if modes change too much to be matched in one piece.
static whirl_status locate_in_halves(search *s, const resting_machine *to, int depth, whirl_critical *found,
                                     size_t most, size_t *count) {
    const size_t before = *count;
    resting_machine middle;
    bool lost = false;
    whirl_status status = critical_locate_pieces(s, to, found, most, count, &lost);
    if (status.code != WHIRL_OK || !lost || depth == 0) return status;
    status = resting_new(s->study, s->batch, 0.5 * (s->from->value + to->value), &middle);
    if (status.code != WHIRL_OK) return status;
    *count = before;
    search second = *s;
    second.from = &middle;
    status = locate_in_halves(s, &middle, depth - 1, found, most, count);
    if (status.code == WHIRL_OK) status = locate_in_halves(&second, to, depth - 1, found, most, count);
    resting_free(&middle);
    return status;
}

whirl_status critical_locate(const whirl_study *study, const whirl_batch *batch, const resting_machine *from,
                             const resting_machine *to, whirl_critical *found, size_t most, size_t *count) {
    enum { DEEPEST = 12 };
    search s = {.study = study, .batch = batch, .from = from};
    *count = 0;
    const whirl_status status = locate_in_halves(&s, to, DEEPEST, found, most, count);
    qsort(found, *count, sizeof *found, by_value);
    return status;
}
