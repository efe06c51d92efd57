// Runout: apparent motion that probes see on a shaft that is not round, or not of uniform metal. It causes no force.
#include "registry.h"
#include "two_pi.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, SEEN_BY, ORDER, AMPLITUDE, ANGLE, PROFILE, KEY_COUNT };
enum { SEEN_BY_BOTH, SEEN_BY_FIRST };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station of the probes"),
    [SEEN_BY] = CHOICE_KEY("seen_by", DEFAULT("both"), "both|first|second",
                           "both: a surface that passes the probe along x and then the one along y; first, second: the "
                           "reading of one probe at slow roll"),
    [ORDER] = WHOLE_KEY("order", "n", DEFAULT("1"), WHIRL_FROM_TO(1, 64), "number of high places around the shaft"),
    [AMPLITUDE] = CITED_NUMBER_KEY("amplitude", "r", "m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                   "height of these places, zero to peak; this or profile", "API 670"),
    [ANGLE] = ANGLE_KEY("angle", "beta", NULL, "position of one of them at t = 0, from the x axis towards y"),
    [PROFILE] = CITED_NUMBERS_KEY("profile", "", "m", OPTIONAL, WHIRL_ANY,
                                  "heights at equal angles around the shaft, from the x axis at t = 0 towards y, in "
                                  "place of amplitude; interpolated by their harmonics, without their mean",
                                  ""),
};

/// Adds the surface a cos n psi + b sin n psi, psi = alpha - way tau, under a probe at alpha, as Re(v exp(i n tau)).
static void runout_add(const key_value *values, assembly *to, int order, double a, double b) {
    const double way = copysign(1.0, to->turn), quarter = -way * 0.25 * two_pi * (order % 4);
    const int by = values[SEEN_BY].choice;
    const double v[2] = {a, way * b}, c = cos(quarter), s = sin(quarter);
    whirl_runout seen = {.order = order};
    for (int part = 0; part < 2; part++) {
        if (by == SEEN_BY_BOTH || by == SEEN_BY_FIRST) seen.first[part] = v[part];
        if (by != SEEN_BY_FIRST) seen.second[part] = v[part] * c + (part == 0 ? -v[1] : v[0]) * s;
    }
    assembly_runout(to, values[AT].station[0], seen);
}

static void add_profile(const key_value *values, assembly *to) {
    const size_t count = values[PROFILE].count;
    for (size_t n = 1; 2 * n <= count; n++) {
        const double weight = (2 * n == count ? 1.0 : 2.0) / (double)count;
        double a = 0.0, b = 0.0;
        for (size_t j = 0; j < count; j++) {
            const double psi = two_pi * (double)(n * j % count) / (double)count;
            a += weight * values[PROFILE].list[j] * cos(psi);
            b += weight * values[PROFILE].list[j] * sin(psi);
        }
        runout_add(values, to, (int)n, a, b);
    }
}

static whirl_status runout_build(const key_value *values, assembly *to, element *out) {
    const double n = values[ORDER].number, r = values[AMPLITUDE].number, angle = values[ANGLE].number;
    const whirl_key *only = &keys[values[ORDER].given ? ORDER : ANGLE];
    out->station = values[AT].station[0];
    if (values[AMPLITUDE].given == values[PROFILE].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected one of them",
                          values[PROFILE].given ? "both amplitude and profile" : "neither amplitude nor profile");
    if (values[PROFILE].given && (values[ORDER].given || values[ANGLE].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s and a profile, which replaces it, expected one of them", only->name);
    if (values[PROFILE].given && (values[PROFILE].count < 3 || values[PROFILE].count > 128))
        return whirl_fail(WHIRL_BAD_INPUT, "has a profile of %zu heights, expected 3 to 128", values[PROFILE].count);
    if (to->phased)
        return whirl_fail(WHIRL_BAD_INPUT, "turns with the shaft, and sections are taken by another phase, expected a "
                                           "machine without a keyphasor of its own");
    if (values[PROFILE].given)
        add_profile(values, to);
    else
        runout_add(values, to, (int)n, r * cos(n * angle), r * sin(n * angle));
    return whirl_ok();
}

const element_type runout_element = {
    .group = {"runout", "runout of the shaft under probes: it changes their readings and exerts no force", "API 670",
              keys, KEY_COUNT, NULL, NULL},
    .spun = true,
    .build = runout_build,
};
#endif
