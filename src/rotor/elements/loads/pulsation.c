// Torques that pulsate at orders of the speed or at fixed frequencies, and a steady one. They act in the study torsion.
#include "registry.h"
#include "two_pi.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "table.h"

enum { AT, ORDERS, FREQUENCIES, AMPLITUDES, SHARES, RATED, PHASES, STEADY, SPEEDS, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station on which they act; it twists"),
    [ORDERS] =
        CITED_NUMBERS_KEY("orders", "", "1", OPTIONAL, WHIRL_POSITIVE,
                          "frequencies divided by the speed of this station, which its gears determine", "API RP 684"),
    [FREQUENCIES] =
        CITED_NUMBERS_KEY("frequencies", "", "Hz", OPTIONAL, WHIRL_POSITIVE,
                          "fixed frequencies in place of orders, such as line frequency and twice that", ""),
    [AMPLITUDES] = CITED_NUMBERS_KEY("amplitudes", "", "N m", OPTIONAL, WHIRL_ANY,
                                     "torque amplitudes, zero to peak, one for each order or frequency, along the "
                                     "rotation of the station; with speeds a list over the speeds for each",
                                     ""),
    [SHARES] = CITED_NUMBERS_KEY("shares", "", "1", OPTIONAL, WHIRL_ANY,
                                 "in place of amplitudes: amplitudes divided by the rated torque", ""),
    [RATED] = NUMBER_KEY("rated", "T_0", "N m", OPTIONAL, WHIRL_POSITIVE, "rated torque, for shares"),
    [PHASES] = CITED_NUMBERS_KEY("phases", "", "rad", OPTIONAL, WHIRL_ANY,
                                 "phases at t = 0, one for each; at phase 0 the torque is largest; absent: 0", ""),
    [STEADY] = CITED_NUMBERS_KEY(
        "steady", "", "N m", OPTIONAL, WHIRL_ANY,
        "constant torque along the rotation of the station, below 0 for a load; with speeds a list over the speeds",
        ""),
    [SPEEDS] = CITED_NUMBERS_KEY("speeds", "", "rad/s", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                 "rising speeds of the station for torques that change with it; between them monotone "
                                 "cubics",
                                 "Fritsch, Butland 1984"),
};

/// Returns how many numbers a key has. A single number is not a list.
static size_t pulsation_count(const key_value *of) {
    return !of->given ? 0 : of->count > 0 ? of->count : 1;
}

static const double *pulsation_list(const key_value *of) {
    return of->count > 0 ? of->list : &of->number;
}

/// Checks for keys that contradict each other, and the lengths of lists.
static whirl_status pulsation_check(const key_value *values) {
    const key_value *speeds = &values[SPEEDS], *sizes = &values[values[SHARES].given ? SHARES : AMPLITUDES];
    const key_value *rates = &values[values[FREQUENCIES].given ? FREQUENCIES : ORDERS];
    const size_t count = pulsation_count(rates), rows = speeds->given ? pulsation_count(speeds) : 1;
    const char *name = values[SHARES].given ? "shares" : "amplitudes";
    // Amplitudes and rates must be given in one way each, and together.
    if (values[ORDERS].given && values[FREQUENCIES].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has orders and frequencies, expected one of them: a pulsation for each");
    if (values[AMPLITUDES].given && values[SHARES].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has amplitudes and shares, expected one of them");
    if (values[SHARES].given != values[RATED].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s alone, expected shares and the rated torque together",
                          values[RATED].given ? "rated" : "shares");
    if (!rates->given && !values[STEADY].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no torque, expected orders or frequencies with amplitudes or shares, "
                                           "or a steady torque");
    if (rates->given != sizes->given)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %s alone, expected orders or frequencies together with amplitudes or "
                          "shares",
                          rates->given ? values[ORDERS].given ? "orders" : "frequencies" : name);
    // Lists must have as many numbers as there are pulsations and speeds.
    if (speeds->given && (speeds->count < 2 || speeds->rows > 1 || !table_rises(speeds->count, speeds->list)))
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu speeds, expected a list of at least 2 that rise", speeds->count);
    if (sizes->given && pulsation_count(sizes) != count * rows)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu %s, expected %zu: one for each of %zu orders or frequencies%s",
                          pulsation_count(sizes), name, count * rows, count,
                          speeds->given ? " at each of the speeds" : "");
    if (sizes->given && speeds->given && sizes->rows != count)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %zu lists of %s, expected %zu: a list over the speeds for each order or "
                          "frequency",
                          sizes->rows, name, count);
    if (values[PHASES].given && pulsation_count(&values[PHASES]) != count)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu phases, expected %zu: one for each order or frequency",
                          pulsation_count(&values[PHASES]), count);
    if (values[STEADY].given && pulsation_count(&values[STEADY]) != rows)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu steady torques, expected %zu%s", pulsation_count(&values[STEADY]),
                          rows, speeds->given ? ": one for each of the speeds" : "");
    return whirl_ok();
}

/// Adds a torque of `factor` times its numbers, one for each speed.
static void pulsation_add(const key_value *values, assembly *to, harmonic_torque own, const double *sizes,
                          double factor) {
    own.station = values[AT].station[0];
    own.count = values[SPEEDS].given ? values[SPEEDS].count : 1;
    for (size_t i = 0; i < own.count; i++) {
        own.speeds[i] = values[SPEEDS].given ? values[SPEEDS].list[i] : 0.0;
        own.torques[i] = factor * sizes[i];
    }
    assembly_harmonic(to, &own);
}

static whirl_status pulsation_build(const key_value *values, assembly *to, element *out) {
    const key_value *rates = &values[values[FREQUENCIES].given ? FREQUENCIES : ORDERS];
    const key_value *sizes = &values[values[SHARES].given ? SHARES : AMPLITUDES];
    const size_t rows = values[SPEEDS].given ? values[SPEEDS].count : 1;
    size_t coordinate;
    whirl_status status = pulsation_check(values);
    if (status.code == WHIRL_OK) status = assembly_find(to, values[AT].station[0], AXIS_TWIST, &coordinate);
    if (status.code != WHIRL_OK) return status;
    out->lumped = true;
    for (size_t i = 0; rates->given && i < pulsation_count(rates); i++) {
        const bool fixed = values[FREQUENCIES].given;
        pulsation_add(values, to,
                      (harmonic_torque){.of = fixed ? HARMONIC_FIXED : HARMONIC_BY_STATION,
                                        .rate = (fixed ? two_pi : 1.0) * pulsation_list(rates)[i],
                                        .phase = values[PHASES].given ? pulsation_list(&values[PHASES])[i] : 0.0},
                      pulsation_list(sizes) + i * rows, values[SHARES].given ? values[RATED].number : 1.0);
    }
    if (values[STEADY].given)
        pulsation_add(values, to, (harmonic_torque){.of = HARMONIC_STEADY}, pulsation_list(&values[STEADY]), 1.0);
    return whirl_ok();
}

const element_type pulsation_element = {
    .group = {"pulsation",
              "torques at orders of the speed or fixed frequencies, and a steady one, in the study torsion",
              "API RP 684", keys, KEY_COUNT, NULL, NULL},
    .build = pulsation_build,
};
#endif
