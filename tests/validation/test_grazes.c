// No graze is missed: rotors that come near their stator, touch it lightly or hit it, against a reference that is this
// file's own.
//
// The reference takes classical RK4 steps in extended precision, so short that their error is below 1e-12, on one side
// of the contact at a time. It looks for the largest (in contact: the smallest) radius in every step in which the
// radial velocity turns, and for the beginning and the end of contact by bisection of the length of a step.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_rotor.h"
#include "whirl/engine/ensemble.h"

enum { ALL = 10000, FEW = 320, BLOCK = 160, STEPS = 16384, BISECTIONS = 50 };

/// Shallower than this a touch may count or not: the tolerance at which the library runs.
static const long double faint = 1e-10L;

// ---------------------------------------------------------------- the reference

/// x, y, x', y' with lengths in gaps, time in radians of rotation.
typedef struct state {
    long double x, y, vx, vy;
} state;

typedef struct reference {
    rub_case rub;
    state now;
    bool closed;
    int begun;           ///< times that contact began
    long double nearest; ///< least distance of an extreme radius from the gap
} reference;

static long double radius(const state *s) {
    return sqrtl(s->x * s->x + s->y * s->y);
}

static state slope(const reference *r, const state *s, long double t) {
    const rub_case *p = &r->rub;
    const long double square = (long double)p->speed * p->speed, damping = 2.0L * p->zeta / p->speed;
    const long double push = r->closed ? p->kappa * (1.0L - 1.0L / radius(s)) : 0.0L, f = p->friction;
    return (state){
        s->vx, s->vy, -damping * s->vx - (s->x + push * (s->x - f * s->y)) / square + p->eccentricity * cosl(t),
        -damping * s->vy - (s->y + push * (s->y + f * s->x) + p->weight) / square + p->eccentricity * sinl(t)};
}

static state moved(const state *s, const state *along, long double by) {
    return (state){s->x + by * along->x, s->y + by * along->y, s->vx + by * along->vx, s->vy + by * along->vy};
}

static state after(const reference *r, const state *s, long double t, long double h) {
    const state a = slope(r, s, t), at_b = moved(s, &a, h / 2), b = slope(r, &at_b, t + h / 2);
    const state at_c = moved(s, &b, h / 2), c = slope(r, &at_c, t + h / 2), at_d = moved(s, &c, h);
    const state d = slope(r, &at_d, t + h);
    state end = moved(s, &a, h / 6);
    end = moved(&end, &b, h / 3);
    end = moved(&end, &c, h / 3);
    return moved(&end, &d, h / 6);
}

/// Returns the distance from the stator, positive on the present side. `drift` is its derivative by time, times the
/// radius.
static long double room(const reference *r, const state *s) {
    return r->closed ? radius(s) - 1.0L : 1.0L - radius(s);
}
static long double drift(const reference *r, const state *s) {
    const long double outward = s->x * s->vx + s->y * s->vy;
    return r->closed ? outward : -outward;
}

/// Returns the length within h at which the distance to the stator, or with `turning` its derivative, changes its sign.
static long double bisect(const reference *r, long double t, long double h, bool turning) {
    long double low = 0.0L, high = h;
    for (int i = 0; i < BISECTIONS; i++) {
        const long double middle = (low + high) / 2;
        const state s = after(r, &r->now, t, middle);
        const bool before = turning ? drift(r, &s) < 0.0L : room(r, &s) > 0.0L;
        *(before ? &low : &high) = middle;
    }
    return high;
}

/// Makes one step of length h, in parts where contact begins or ends.
static void advance(reference *r, long double t, long double h) {
    const state end = after(r, &r->now, t, h);
    long double within = h;
    bool leaves = room(r, &end) <= 0.0L;
    if (!leaves && drift(r, &r->now) < 0.0L && drift(r, &end) > 0.0L) {
        within = bisect(r, t, h, true);
        const state least = after(r, &r->now, t, within);
        r->nearest = fminl(r->nearest, fabsl(room(r, &least)));
        leaves = room(r, &least) < 0.0L;
    }
    if (!leaves) {
        r->now = end;
        return;
    }
    const long double way = bisect(r, t, within, false);
    r->now = after(r, &r->now, t, way);
    r->closed = !r->closed;
    r->begun += r->closed;
    if (way < h) advance(r, t + way, h - way);
}

// ---------------------------------------------------------------- the motions

/// Returns a number from 0 to 1 (Marsaglia 2003).
static double random_number(uint64_t *seed) {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (double)(*seed >> 11) * 0x1p-53;
}
static double between(uint64_t *seed, double low, double high) {
    return low + (high - low) * random_number(seed);
}
static double scale_between(uint64_t *seed, double low, double high) {
    return low * pow(high / low, random_number(seed));
}

/// Makes a rotor inside its stator whose radius would peak about `depth` beyond the gap, or short of it.
static reference near_graze(uint64_t *seed) {
    for (;;) {
        reference r = {.nearest = 1.0L};
        r.rub = (rub_case){.speed = between(seed, 0.6, 3.0),
                           .zeta = between(seed, 0.02, 0.2),
                           .kappa = scale_between(seed, 3.0, 30.0),
                           .friction = between(seed, 0.0, 0.2),
                           .eccentricity = between(seed, 0.0, 0.5),
                           .weight = between(seed, 0.0, 0.3)};
        const double short_of = scale_between(seed, 1e-4, 1e-2), angle = between(seed, -3.14, 3.14);
        const double depth = (random_number(seed) < 0.5 ? -0.5 : 1.0) * scale_between(seed, 1e-6, short_of);
        const long double c = cosl(angle), s = sinl(angle), along = between(seed, -0.8, 0.8);
        r.now = (state){(1.0L - short_of) * c, (1.0L - short_of) * s, -along * s, along * c};
        const state a = slope(&r, &r.now, 0.0L);
        const long double bend = (a.vx * c + a.vy * s) + along * along / (1.0L - short_of);
        if (bend > -0.05L) continue;
        const long double outward = sqrtl(-2.0L * bend * (short_of + depth));
        r.now.vx += outward * c;
        r.now.vy += outward * s;
        // The library sees doubles; so must the reference.
        r.now = (state){(double)r.now.x, (double)r.now.y, (double)r.now.vx, (double)r.now.vy};
        return r;
    }
}

/// Counts over one block of motions.
typedef struct tally {
    int motions, touched, faint, miscounted;
    double apart; ///< largest difference of an end state
} tally;

/// Compares one revolution of `count` motions in lanes with the reference.
static void compare(uint64_t *seed, int count, tally *sum) {
    reference motions[BLOCK];
    whirl_rotor *rotors[BLOCK] = {NULL};
    whirl_ensemble *lanes;
    whirl_integrate_options options = whirl_integrate_default();
    snprintf(options.method, sizeof options.method, "dop853");
    options.rtol = 1e-11;
    options.atol = 1e-13;
    for (int i = 0; i < count; i++) {
        motions[i] = near_graze(seed);
        rotors[i] = make_rub_rotor(&motions[i].rub);
    }
    require_ok(whirl_ensemble_new(whirl_rotor_system(rotors[0]), &options, (size_t)count, &lanes));
    for (int i = 0; i < count; i++) {
        const state *s = &motions[i].now;
        const double x[4] = {(double)s->x, (double)s->y, (double)s->vx, (double)s->vy};
        require_ok(whirl_ensemble_load(lanes, (size_t)i, whirl_rotor_system(rotors[i]), x));
    }
    whirl_ensemble_revolve(lanes, (size_t)count, &(whirl_ensemble_observe){.extremes = true});
    for (int i = 0; i < count; i++) {
        reference *r = &motions[i];
        const long double h = 8.0L * atanl(1.0L) / STEPS;
        double x[4], begun;
        const whirl_ensemble_seen seen = {.contact_number = &begun};
        for (int n = 0; n < STEPS; n++) advance(r, n * h, h);
        assert_int_equal(whirl_ensemble_motion(lanes, (size_t)i), WHIRL_BOUNDED);
        whirl_ensemble_state(lanes, (size_t)i, x);
        whirl_ensemble_read(lanes, (size_t)i, &seen);
        const double end[4] = {(double)r->now.x, (double)r->now.y, (double)r->now.vx, (double)r->now.vy};
        for (int d = 0; d < 4; d++) sum->apart = fmax(sum->apart, fabs(x[d] - end[d]));
        sum->motions++;
        sum->touched += r->begun > 0;
        sum->faint += r->nearest < faint;
        sum->miscounted += r->nearest >= faint && r->begun != (int)begun;
    }
    whirl_ensemble_free(lanes); // before its rotors, which it looks at
    for (int i = 0; i < count; i++) whirl_rotor_free(rotors[i]);
}

static void no_graze_is_missed(void **unused) {
    (void)unused;
    const int all = getenv("WHIRL_SOAK") ? ALL : FEW;
    uint64_t seed = 88172645463325252u;
    tally sum = {0};
    for (int done = 0; done < all; done += BLOCK) compare(&seed, all - done < BLOCK ? all - done : BLOCK, &sum);
    check_within("grazes", words("of %d motions, %d with contact: contacts miscounted", sum.motions, sum.touched), 0.0,
                 sum.miscounted, 0.0);
    check_within("grazes", "largest difference of an end state after a revolution", 0.0, sum.apart, 1e-9);
    // Both kinds must be there, and hardly any too faint to tell.
    check_holds("grazes", "motions that touch and motions that do not, each clear",
                sum.touched > all / 4 && sum.touched < all * 9 / 10 && sum.faint <= all / 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_graze_is_missed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
