// An induction motor by its equations. The flux linkages of stator and rotor are states, so that the pulsation at line
// frequency after switching on is a result. It acts in run-ups alone.
#include "registry.h"
#include "two_pi.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum {
    AT,
    VOLTAGE,
    FREQUENCY,
    POLES,
    STATOR_RESISTANCE,
    STATOR_REACTANCE,
    MAGNETIZING_REACTANCE,
    ROTOR_REACTANCE,
    ROTOR_RESISTANCE,
    PHASE,
    KEY_COUNT
};

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", OPTIONAL,
                       "station of its rotor; required if stations twist; absent: it turns the shaft as a whole"),
    [VOLTAGE] = NUMBER_KEY("voltage", "V", "V", REQUIRED, WHIRL_POSITIVE, "line voltage, rms between two phases"),
    [FREQUENCY] =
        NUMBER_KEY("frequency", "f", "Hz", REQUIRED, WHIRL_POSITIVE, "line frequency, at which the reactances hold"),
    [POLES] = WHOLE_KEY("poles", "P", REQUIRED, WHIRL_FROM_TO(2, 1000), "number of poles, even"),
    [STATOR_RESISTANCE] = NUMBER_KEY("stator_resistance", "r_s", "ohm", REQUIRED, WHIRL_NOT_NEGATIVE,
                                     "resistance of a phase of the stator"),
    [STATOR_REACTANCE] =
        NUMBER_KEY("stator_reactance", "X_ls", "ohm", REQUIRED, WHIRL_POSITIVE, "leakage reactance of the stator"),
    [MAGNETIZING_REACTANCE] =
        NUMBER_KEY("magnetizing_reactance", "X_m", "ohm", REQUIRED, WHIRL_POSITIVE, "reactance of the air gap"),
    [ROTOR_REACTANCE] = NUMBER_KEY("rotor_reactance", "X_lr", "ohm", REQUIRED, WHIRL_POSITIVE,
                                   "leakage reactance of the rotor, referred to the stator"),
    [ROTOR_RESISTANCE] = NUMBER_KEY("rotor_resistance", "r_r", "ohm", REQUIRED, WHIRL_POSITIVE,
                                    "resistance of the rotor, referred to the stator"),
    [PHASE] = ANGLE_KEY("phase", "phi_0", NULL, "phase of the voltage at t = 0, when it is switched on"),
};

/// Numbers of the law: amplitude of a phase's voltage, frequency of the line in rad/s, pairs of poles, then the motor's
/// impedances.
enum { AMPLITUDE, LINE, PAIRS, R_S, X_LS, X_M, X_LR, R_R };
enum { PHASE_AT = 0 }; ///< column of the table

/// Returns the torque, and writes the slopes of the states: flux linkages per second, V, of the stator q, d, then of
/// the rotor q, d, in the stationary frame. After Krause, Wasynczuk, Sudhoff, "Analysis of Electric Machinery" (2002),
/// ch. 4.
static double induction_torque(const shaft_torque *own, const torque_place *at, double *slopes) {
    const double *n = own->number, *psi = at->state, line = n[LINE], angle = line * at->time + own->table[0][PHASE_AT];
    const double mutual = 1.0 / (1.0 / n[X_M] + 1.0 / n[X_LS] + 1.0 / n[X_LR]), turning = n[PAIRS] * at->speed;
    const double gap_q = mutual * (psi[0] / n[X_LS] + psi[2] / n[X_LR]);
    const double gap_d = mutual * (psi[1] / n[X_LS] + psi[3] / n[X_LR]);
    const double current_q = (psi[0] - gap_q) / n[X_LS], current_d = (psi[1] - gap_d) / n[X_LS];
    if (slopes) {
        slopes[0] = line * (n[AMPLITUDE] * cos(angle) + n[R_S] / n[X_LS] * (gap_q - psi[0]));
        slopes[1] = line * (-n[AMPLITUDE] * sin(angle) + n[R_S] / n[X_LS] * (gap_d - psi[1]));
        slopes[2] = turning * psi[3] + line * n[R_R] / n[X_LR] * (gap_q - psi[2]);
        slopes[3] = -turning * psi[2] + line * n[R_R] / n[X_LR] * (gap_d - psi[3]);
    }
    return 1.5 * n[PAIRS] / line * (psi[1] * current_q - psi[0] * current_d);
}

static double induction_highest(const shaft_torque *own) {
    return own->number[LINE] / own->number[PAIRS];
}

static const torque_law induction_law = {
    .name = "induction_motor", .states = 4, .motor = true, .torque = induction_torque, .highest = induction_highest};

static whirl_status induction_build(const key_value *values, assembly *to, element *out) {
    const double poles = values[POLES].number;
    shaft_torque own = {.law = &induction_law, .station = values[AT].given ? values[AT].station[0] : NO_STATION};
    out->lumped = true;
    if (fmod(poles, 2.0) != 0.0) return whirl_fail(WHIRL_BAD_INPUT, "has %g poles, expected an even number", poles);
    own.number[AMPLITUDE] = sqrt(2.0 / 3.0) * values[VOLTAGE].number;
    own.number[LINE] = two_pi * values[FREQUENCY].number;
    own.number[PAIRS] = 0.5 * poles;
    own.number[R_S] = values[STATOR_RESISTANCE].number;
    own.number[X_LS] = values[STATOR_REACTANCE].number;
    own.number[X_M] = values[MAGNETIZING_REACTANCE].number;
    own.number[X_LR] = values[ROTOR_REACTANCE].number;
    own.number[R_R] = values[ROTOR_RESISTANCE].number;
    own.table[0][PHASE_AT] = values[PHASE].number;
    return assembly_torque(to, &own);
}

const element_type induction_motor_element = {
    .group = {"induction_motor", "an induction motor that turns the shaft in a run-up, by its equations",
              "Krause, Wasynczuk, Sudhoff 2002, ch. 4", keys, KEY_COUNT, NULL, NULL},
    .build = induction_build,
};
#endif
