// Slots that are handled one by one: those that pass or come near a switch, and those that end.
//
// If a switching function clearly falls through zero, the step is tried again so that it ends there, together with the
// next steps of the other slots. The place of the zero is taken from the cubic through both ends, then from the
// function's own value and derivative. In doubtful cases (grazes, two switches at once) a stepper takes the step, with
// its full search for zeros. A stepper also takes all steps of a motion that slides along a switch.
#include <math.h>
#include <string.h>

#include "adaptive_lanes.h"
#include "stepper_parts.h"

enum { MAX_TRIES = 6 };

static double *at(const adaptive_lanes *lanes, double *rows, size_t row, size_t slot) {
    return &rows[row * lanes->slots + slot];
}

static void copy(const adaptive_lanes *lanes, double *to, const double *from, size_t rows, size_t slot) {
    for (size_t i = 0; i < rows; i++) to[i * lanes->slots + slot] = from[i * lanes->slots + slot];
}

static void special_end(const adaptive_lanes *lanes, size_t slot, whirl_motion motion) {
    lanes->ended[slot] = motion;
    lanes->running[slot] = 0.0;
}

// ---------------------------------------------------------------- by the stepper

/// Copies the state (set 0) or a perturbation of a slot to x [dimension].
static void give_set(const adaptive_lanes *lanes, size_t slot, size_t set, double *x) {
    const size_t n = lanes->degrees, rates = lanes->rates;
    for (size_t d = 0; d < n; d++) x[d] = *at(lanes, lanes->q, set * n + d, slot);
    for (size_t d = 0; d < rates; d++) x[n + d] = *at(lanes, lanes->v, set * rates + d, slot);
}

static void take_set(const adaptive_lanes *lanes, size_t slot, size_t set, const double *x) {
    const size_t n = lanes->degrees, rates = lanes->rates;
    for (size_t d = 0; d < n; d++) *at(lanes, lanes->q, set * n + d, slot) = x[d];
    for (size_t d = 0; d < rates; d++) *at(lanes, lanes->v, set * rates + d, slot) = x[n + d];
}

static void give_state(const adaptive_lanes *lanes, size_t slot) {
    stepper *c = lanes->stepper;
    whirl_perturbations *along = lanes->alongside;
    give_set(lanes, slot, 0, c->x);
    for (size_t k = 0; k < lanes->tangents; k++) give_set(lanes, slot, k + 1, along->vectors + k * lanes->dimension);
    if (lanes->tangents > 0) along->volume = lanes->volume[slot];
    c->variation.set = lanes->tangents > 0 ? along : NULL;
    stepper_place(c, lanes->machines[lanes->queue->slot_lane[slot]], lanes->t[slot]);
}

static void take_state(const adaptive_lanes *lanes, size_t slot) {
    const whirl_perturbations *along = lanes->alongside;
    take_set(lanes, slot, 0, lanes->stepper->x);
    for (size_t k = 0; k < lanes->tangents; k++) take_set(lanes, slot, k + 1, along->vectors + k * lanes->dimension);
    if (lanes->tangents > 0) lanes->volume[slot] = along->volume;
}

static void give_sides(const adaptive_lanes *lanes, size_t slot) {
    stepper *c = lanes->stepper;
    c->sliding_count = 0;
    for (size_t s = 0; s < lanes->switch_count; s++) {
        c->sides[s] = *at(lanes, lanes->sides, s, slot);
        c->held[s] = (int)*at(lanes, lanes->held, s, slot);
        c->sliding[s] = *at(lanes, lanes->sliding, s, slot) > 0.5;
        c->sliding_count += c->sliding[s];
    }
}

static void take_sides(const adaptive_lanes *lanes, size_t slot) {
    const stepper *c = lanes->stepper;
    for (size_t s = 0; s < lanes->switch_count; s++) {
        *at(lanes, lanes->sides, s, slot) = c->sides[s];
        *at(lanes, lanes->held, s, slot) = c->held[s];
        *at(lanes, lanes->sliding, s, slot) = c->sliding[s];
    }
    lanes->alone[slot] = c->sliding_count > 0;
}

void adaptive_find_sides(const adaptive_lanes *lanes, size_t slot) {
    give_state(lanes, slot);
    stepper_find_sides(lanes->stepper);
    stepper_vary_begin(lanes->stepper);
    take_state(lanes, slot); // exactly on the switches along which the motion slides
    take_sides(lanes, slot);
}

static void take_polynomials(const adaptive_lanes *lanes, size_t slot) {
    const stepper *c = lanes->stepper;
    for (size_t i = 0; i < lanes->dimension; i++) {
        *at(lanes, lanes->dense[0], i, slot) = c->start[i];
        for (int p = 0; p < lanes->method->dense; p++) *at(lanes, lanes->dense[1 + p], i, slot) = c->dense[p][i];
    }
}

/// Takes the step of a slot with the stepper.
static void step_alone(const adaptive_lanes *lanes, size_t slot) {
    const bool observed = lanes->observing && lanes->watched[slot] > 0.5;
    stepper *c = lanes->stepper;
    // Pass the slot's state to the stepper.
    give_state(lanes, slot);
    give_sides(lanes, slot);
    *c->slot->h = lanes->length[slot];
    c->switchings = (int)lanes->switchings[slot];
    c->observed = c->eager = observed;
    // Step, and take the state back.
    const whirl_motion motion = stepper_step(c, lanes->until[slot]);
    take_state(lanes, slot);
    take_sides(lanes, slot);
    lanes->t[slot] = c->t;
    lanes->h[slot] = *c->slot->h;
    lanes->switchings[slot] = c->switchings;
    lanes->landing[slot] = 0.0;
    lanes->fresh[slot] = 1.0;
    // Observers need the polynomials of the step.
    if (observed) {
        lanes->begin[slot] = c->begin;
        lanes->taken[slot] = motion == WHIRL_BOUNDED ? c->length : 0.0;
        take_polynomials(lanes, slot);
    }
    if (motion != WHIRL_BOUNDED)
        special_end(lanes, slot, motion);
    else if (!(c->t < lanes->until[slot]))
        lanes->running[slot] = 0.0;
}

// ---------------------------------------------------------------- landing on a switch

/// Bernstein coefficients of the cubic through values and derivatives at both ends of a step. For a function that
/// begins at zero they are those of its quotient by theta.
typedef struct cubic {
    double b[4];
    int degree;
} cubic;

static cubic cubic_of(const adaptive_lanes *lanes, size_t s, size_t slot) {
    const double side = *at(lanes, lanes->sides, s, slot), third = side * lanes->length[slot] / 3.0;
    const double rise = third * *at(lanes, lanes->rate, s, slot), b0 = side * *at(lanes, lanes->value, s, slot);
    const double b3 = side * *at(lanes, lanes->end_value, s, slot);
    const double b2 = b3 - third * *at(lanes, lanes->end_rate, s, slot);
    if (*at(lanes, lanes->held, s, slot) > 0.5) return (cubic){{3.0 * rise, 1.5 * b2, b3}, 2};
    return (cubic){{b0, b0 + rise, b2, b3}, 3};
}

static bool is_clear(const cubic *c) {
    double least = c->b[0], margin = 0.0, jump = 0.0, before = 0.0;
    for (int i = 0; i <= c->degree; i++) least = fmin(least, c->b[i]);
    for (int i = 1; i < c->degree; i++) {
        const double bend = c->b[i - 1] - 2.0 * c->b[i] + c->b[i + 1];
        if (i > 1) jump = fabs(bend - before);
        margin = fmax(margin, fabs(bend));
        before = bend;
    }
    return least > (c->degree == 3 ? 0.5 * margin + jump : margin);
}

/// Returns true if the cubic falls monotonically from positive to negative.
static bool falls(const cubic *c) {
    for (int i = 0; i < c->degree; i++)
        if (!(c->b[i + 1] < c->b[i])) return false;
    return c->b[0] > 0.0 && c->b[c->degree] < 0.0;
}

static double zero_of(const cubic *c) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 20; i++) { // close enough for Newton's method afterwards
        const double theta = 0.5 * (low + high);
        double b[4];
        memcpy(b, c->b, sizeof b);
        for (int k = c->degree; k > 0; k--)
            for (int j = 0; j < k; j++) b[j] += theta * (b[j + 1] - b[j]);
        *(b[0] > 0.0 ? &low : &high) = theta;
    }
    return high;
}

/// Result of a step with respect to switches: no switch, the first switch that it passes, or doubtful.
typedef enum passage { PASSAGE_CLEAR, PASSAGE_FALLS, PASSAGE_DOUBTFUL } passage;

static passage find_passage(const adaptive_lanes *lanes, size_t slot, size_t except, size_t *which, double *theta) {
    passage found = PASSAGE_CLEAR;
    *theta = 2.0;
    for (size_t s = 0; s < lanes->switch_count; s++) {
        const cubic c = cubic_of(lanes, s, slot);
        if (s == except || is_clear(&c)) continue;
        if (!falls(&c)) return PASSAGE_DOUBTFUL;
        const double zero = zero_of(&c);
        if (zero < *theta) {
            *theta = zero;
            *which = s;
        }
        found = PASSAGE_FALLS;
    }
    return found;
}

/// Chooses the side of switch `which`, on which the state lies, or begins to slide along the switch.
static void choose_side(const adaptive_lanes *lanes, size_t slot, size_t which) {
    give_state(lanes, slot);
    give_sides(lanes, slot);
    stepper_cross(lanes->stepper, which);
    take_state(lanes, slot);
    take_sides(lanes, slot);
}

/// Moves the slot to the end of the step tried, on the other side of switch `which`.
static void cross(const adaptive_lanes *lanes, size_t slot, size_t which) {
    copy(lanes, lanes->q, lanes->end_q, lanes->degrees, slot);
    copy(lanes, lanes->v, lanes->end_v, lanes->rates, slot);
    for (size_t s = 0; s < lanes->switch_count; s++) *at(lanes, lanes->held, s, slot) = s == which && !lanes->slides;
    lanes->taken[slot] = lanes->length[slot];
    lanes->t[slot] = fmin(lanes->t[slot] + lanes->length[slot], lanes->until[slot]);
    if (lanes->slides)
        choose_side(lanes, slot, which);
    else
        *at(lanes, lanes->sides, which, slot) *= -1.0;
    lanes->landing[slot] = 0.0;
    lanes->fresh[slot] = 1.0;
    if (++lanes->switchings[slot] > MAX_SWITCHINGS) special_end(lanes, slot, WHIRL_STUCK);
    if (!(lanes->t[slot] < lanes->until[slot])) lanes->running[slot] = 0.0;
}

/// Shortens the step so that it ends at a switch. With perturbations the stepper takes the step, and carries them
/// across the switch.
static void begin_landing(const adaptive_lanes *lanes, size_t slot) {
    size_t which = 0;
    double theta;
    if (lanes->tangents > 0 || find_passage(lanes, slot, lanes->switch_count, &which, &theta) != PASSAGE_FALLS) {
        step_alone(lanes, slot);
        return;
    }
    lanes->landing[slot] = 1.0 + (double)which;
    lanes->tries[slot] = 1.0;
    lanes->whole[slot] = lanes->length[slot];
    lanes->length[slot] *= theta;
}

/// Handles a step that was to end at a switch. Accepts it if it is near enough, otherwise moves nearer by Newton's
/// method.
static void go_on_landing(const adaptive_lanes *lanes, size_t slot) {
    const size_t which = (size_t)lanes->landing[slot] - 1;
    const double value = *at(lanes, lanes->end_value, which, slot), rate = *at(lanes, lanes->end_rate, which, slot);
    const double off = -value / rate, length = lanes->length[slot], reach = 1e-3 * lanes->rtol + 0x1p-50;
    size_t other = 0;
    double theta;
    const bool falling = *at(lanes, lanes->sides, which, slot) * rate < 0.0 && lanes->error[slot] < 1.0;
    const bool sure = falling && find_passage(lanes, slot, which, &other, &theta) == PASSAGE_CLEAR;
    if (sure && (fabs(off) <= reach || ++lanes->tries[slot] > MAX_TRIES)) {
        cross(lanes, slot, which);
    } else if (sure && length + off > 0.0 && length + off < lanes->whole[slot]) {
        lanes->length[slot] = length + off;
    } else {
        lanes->length[slot] = lanes->whole[slot];
        step_alone(lanes, slot);
    }
}

void adaptive_special(const adaptive_lanes *lanes, size_t slot) {
    const bool accepted = lanes->error[slot] < 1.0;
    const bool landing = lanes->landing[slot] > 0.5;
    if (lanes->alone[slot] > 0.5)
        step_alone(lanes, slot);
    else if (landing)
        go_on_landing(lanes, slot);
    else if (!accepted || lanes->attempts[slot] > MAX_ATTEMPTS)
        special_end(lanes, slot, accepted || isfinite(lanes->error[slot]) ? WHIRL_STUCK : WHIRL_DIVERGED);
    else if (!(lanes->size[slot] < lanes->limit))
        special_end(lanes, slot, WHIRL_DIVERGED);
    else
        begin_landing(lanes, slot);
}
