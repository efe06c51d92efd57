// A synchronous motor that starts asynchronously. Its torque has a mean and a part that pulsates at twice the slip
// frequency. It acts in run-ups alone.
#include "registry.h"
#include "two_pi.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "table.h"

enum { AT, FREQUENCY, POLES, MEAN, PULSATING, SLIPS, PHASE, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", OPTIONAL,
                       "station of its rotor; required if stations twist; absent: it turns the shaft as a whole"),
    [FREQUENCY] = NUMBER_KEY("frequency", "f", "Hz", REQUIRED, WHIRL_POSITIVE, "line frequency"),
    [POLES] = WHOLE_KEY("poles", "P", REQUIRED, WHIRL_FROM_TO(2, 1000), "number of poles, even"),
    [MEAN] = CITED_NUMBERS_KEY("mean", "T_a", "N m", REQUIRED, WHIRL_ANY,
                               "mean torque, one number or one for each of `slips`", ""),
    [PULSATING] = CITED_NUMBERS_KEY("pulsating", "T_p", "N m", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                    "amplitude of the pulsating torque, one number or one for each of `slips`", ""),
    [SLIPS] =
        CITED_NUMBERS_KEY("slips", "s", "1", OPTIONAL, WHIRL_ANY,
                          "rising slips, 1 at standstill and 0 at synchronous speed; between them monotone cubics",
                          "Fritsch, Butland 1984"),
    [PHASE] = ANGLE_KEY("phase", "psi_0", NULL, "phase of the pulsation at t = 0, for a station at the angle 0"),
};

/// Numbers of the law, and the rows of its table.
enum { LINE, PAIRS, BEGIN };
enum { ROW_SLIP, ROW_MEAN, ROW_PULSATING };

static double synchronous_value(const shaft_torque *own, int row, double slip) {
    const double *slips = own->table[ROW_SLIP];
    if (own->count == 1) return own->table[row][0];
    return table_value(own->count, slips, own->table[row], fmin(fmax(slip, slips[0]), slips[own->count - 1]));
}

/// Returns T = T_a + T_p sin psi with psi' = 2 (2 pi f - p theta'). The frequency of the pulsation falls from twice the
/// line frequency to 0.
static double synchronous_torque(const shaft_torque *own, const torque_place *at, double *slopes) {
    const double *n = own->number, slip = 1.0 - n[PAIRS] * at->speed / n[LINE];
    const double psi = 2.0 * (n[LINE] * at->time - n[PAIRS] * at->angle) + n[BEGIN];
    (void)slopes;
    return synchronous_value(own, ROW_MEAN, slip) + synchronous_value(own, ROW_PULSATING, slip) * sin(psi);
}

static double synchronous_highest(const shaft_torque *own) {
    return own->number[LINE] / own->number[PAIRS];
}

static const torque_law synchronous_law = {
    .name = "synchronous_start", .motor = true, .torque = synchronous_torque, .highest = synchronous_highest};

/// Copies a list of `count` numbers, or a single number for all, to a row of the table.
static whirl_status synchronous_row(const key_value *value, const char *name, size_t count, double *row) {
    if (value->count > 1 && count == 1)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu %s and no slips, expected one number, or slips", value->count,
                          name);
    if (value->count > 1 && value->count != count)
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu %s and %zu slips, expected as many, or one number", value->count,
                          name, count);
    for (size_t i = 0; i < count; i++) row[i] = value->count > 1 ? value->list[i] : value->number;
    return whirl_ok();
}

static whirl_status synchronous_build(const key_value *values, assembly *to, element *out) {
    const key_value *slips = &values[SLIPS];
    shaft_torque own = {.law = &synchronous_law, .station = values[AT].given ? values[AT].station[0] : NO_STATION};
    out->lumped = true;
    own.count = slips->given ? slips->count : 1;
    if (fmod(values[POLES].number, 2.0) != 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "has %g poles, expected an even number", values[POLES].number);
    if (slips->given && (slips->count < 2 || slips->rows > 1 || !table_rises(slips->count, slips->list)))
        return whirl_fail(WHIRL_BAD_INPUT, "has %zu slips, expected at least 2, rising", slips->count);
    for (size_t i = 0; slips->given && i < slips->count; i++) own.table[ROW_SLIP][i] = slips->list[i];
    whirl_status status = synchronous_row(&values[MEAN], "mean torques", own.count, own.table[ROW_MEAN]);
    if (status.code == WHIRL_OK)
        status = synchronous_row(&values[PULSATING], "pulsating torques", own.count, own.table[ROW_PULSATING]);
    own.number[LINE] = two_pi * values[FREQUENCY].number;
    own.number[PAIRS] = 0.5 * values[POLES].number;
    own.number[BEGIN] = values[PHASE].number;
    return status.code == WHIRL_OK ? assembly_torque(to, &own) : status;
}

const element_type synchronous_start_element = {
    .group = {"synchronous_start", "a synchronous motor that starts asynchronously in a run-up: its torque pulsates",
              "API RP 684", keys, KEY_COUNT, NULL, NULL},
    .build = synchronous_build,
};
#endif
