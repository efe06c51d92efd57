// A massless elastic shaft with two unequal principal stiffnesses k1, k2 that turn with it.
//
// With kbar = (k1 + k2)/2, dk = (k1 - k2)/2 and the principal axis of k1 along x at tau = 0, the force on station a
// that is displaced by (dx, dy) from station b is
//
//     -[ kbar + dk cos 2tau     dk sin 2tau        ] (dx)
//      [ dk sin 2tau            kbar - dk cos 2tau ] (dy)
//
// (`signs: derived`, e.g. Friswell et al. 2010, section 7.3). The paper of 2015 prints + dk cos 2tau in both diagonal
// entries (`signs: paper`): no turning shaft does that, x + y and x - y become two Mathieu oscillators.
#include <math.h>

#include "element.h"

enum { BETWEEN, K1, K2, SIGNS, KEY_COUNT };
enum { SIGNS_DERIVED, SIGNS_PAPER };

static const whirl_key keys[KEY_COUNT] = {
    [BETWEEN] = {"between", "", "", WHIRL_KEY_STATIONS, true, "", WHIRL_ANY, NULL,
                 "the two stations that it joins; one may be ground", ""},
    [K1] = {"k1", "k1", "N/m", WHIRL_KEY_NUMBER, true, "", WHIRL_NOT_NEGATIVE, NULL,
            "stiffness along the first principal axis, which lies along x at t = 0", ""},
    [K2] = {"k2", "k2", "N/m", WHIRL_KEY_NUMBER, false, "", WHIRL_NOT_NEGATIVE, NULL,
            "stiffness along the second principal axis; k1 where absent", ""},
    [SIGNS] = {"signs", "", "", WHIRL_KEY_CHOICE, false, "derived", WHIRL_ANY, "derived|paper",
               "derived: a shaft that turns; paper: the equations of the 2015 paper as printed",
               "Friswell et al. 2010, sec. 7.3; rub-impact paper 2015, eq. (2)"},
};

typedef struct shaft {
    size_t a, b;           ///< stations; b may be GROUND
    double mean_a, half_a; ///< kbar/(m omega^2), dk/(m omega^2) at station a
    double mean_b, half_b; ///< at station b
    double half_sign;      ///< of dk cos 2tau in the y equation
} shaft;

static whirl_status build(const key_value *values, const scales *scale, void *coefficients) {
    size_t a = values[BETWEEN].station[0], b = values[BETWEEN].station[1];
    if (a == b) return whirl_fail(WHIRL_BAD_INPUT, "between names one station twice, expected two");
    if (a == GROUND) {
        a = b;
        b = GROUND;
    }
    const double k1 = values[K1].number;
    const double k2 = values[K2].given ? values[K2].number : k1;
    const double mean = 0.5 * (k1 + k2), half = 0.5 * (k1 - k2);
    const double scale_a = stiffness_scale(scale, a);
    shaft *s = coefficients;
    *s = (shaft){.a = a,
                 .b = b,
                 .mean_a = mean / scale_a,
                 .half_a = half / scale_a,
                 .half_sign = values[SIGNS].choice == SIGNS_PAPER ? 1.0 : -1.0};
    if (b != GROUND) {
        const double scale_b = stiffness_scale(scale, b);
        s->mean_b = mean / scale_b;
        s->half_b = half / scale_b;
    }
    return whirl_ok();
}

static void force(const void *coefficients, const double *forcing, const double *q, const double *v, double *a) {
    const shaft *s = coefficients;
    (void)v;
    double dx = q[2 * s->a], dy = q[2 * s->a + 1];
    if (s->b != GROUND) {
        dx -= q[2 * s->b];
        dy -= q[2 * s->b + 1];
    }
    // The force over its scale is mean (dx, dy) + half (turn_x, turn_y).
    const double turn_x = forcing[COS_2TAU] * dx + forcing[SIN_2TAU] * dy;
    const double turn_y = s->half_sign * forcing[COS_2TAU] * dy + forcing[SIN_2TAU] * dx;
    a[2 * s->a] -= s->mean_a * dx + s->half_a * turn_x;
    a[2 * s->a + 1] -= s->mean_a * dy + s->half_a * turn_y;
    if (s->b != GROUND) {
        a[2 * s->b] += s->mean_b * dx + s->half_b * turn_x;
        a[2 * s->b + 1] += s->mean_b * dy + s->half_b * turn_y;
    }
}

const element_type shaft_element = {
    .group = {"shaft", "a massless shaft of unequal stiffness between two stations, or from a station to ground",
              "Friswell et al. 2010, sec. 7.3", keys, KEY_COUNT, NULL},
    .size = sizeof(shaft),
    .build = build,
    .force = force,
};
