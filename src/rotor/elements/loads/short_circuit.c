// The torque of a short circuit at the terminals of an electric machine. It acts in run-ups alone.
#include "registry.h"
#include "two_pi.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum { AT, TORQUE, FREQUENCY, FIRST, SECOND, DECAY, TIME, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", OPTIONAL,
                       "station of its rotor; required if stations twist; absent: it turns the shaft as a whole"),
    [TORQUE] = NUMBER_KEY("torque", "T_0", "N m", REQUIRED, WHIRL_POSITIVE,
                          "rated torque, of which the factors are multiples"),
    [FREQUENCY] = NUMBER_KEY("frequency", "f", "Hz", REQUIRED, WHIRL_POSITIVE, "line frequency"),
    [FIRST] = NUMBER_KEY("first", "a_1", "1", REQUIRED, WHIRL_ANY,
                         "factor of the part at line frequency, along the rotation; as stated by the maker"),
    [SECOND] = NUMBER_KEY("second", "a_2", "1", DEFAULT("0"), WHIRL_ANY,
                          "factor of the part at twice line frequency (a short circuit of two phases)"),
    [DECAY] = NUMBER_KEY("decay", "T_a", "s", REQUIRED, WHIRL_POSITIVE, "time in which both fall to 1/e"),
    [TIME] = NUMBER_KEY("time", "t_0", "s", DEFAULT("0"), WHIRL_NOT_NEGATIVE, "time of the short circuit"),
};

/// The keys of the law's numbers, in their order.
static const int of_law[] = {TORQUE, FREQUENCY, FIRST, SECOND, DECAY, TIME};
enum { T_0, LINE, A_1, A_2, T_A, AFTER };

/// Returns T_0 exp(-t/T_a) (a_1 sin w t + a_2 sin 2 w t), or 0 before the short circuit.
static double circuit_torque(const shaft_torque *own, const torque_place *at, double *slopes) {
    const double *n = own->number, t = at->time - n[AFTER], phase = two_pi * n[LINE] * t;
    (void)slopes;
    return t <= 0.0 ? 0.0 : n[T_0] * exp(-t / n[T_A]) * (n[A_1] * sin(phase) + n[A_2] * sin(2.0 * phase));
}

static double circuit_begins(const shaft_torque *own) {
    return own->number[AFTER];
}

static const torque_law circuit_law = {.name = "short_circuit", .torque = circuit_torque, .begins = circuit_begins};

static whirl_status circuit_build(const key_value *values, assembly *to, element *out) {
    shaft_torque own = {.law = &circuit_law, .station = values[AT].given ? values[AT].station[0] : NO_STATION};
    out->lumped = true;
    for (size_t i = 0; i < sizeof of_law / sizeof *of_law; i++) own.number[i] = values[of_law[i]].number;
    return assembly_torque(to, &own);
}

const element_type short_circuit_element = {
    .group = {"short_circuit", "the torque of a short circuit at the terminals of a machine, in a run-up", "API RP 684",
              keys, KEY_COUNT, NULL, NULL},
    .build = circuit_build,
};
#endif
