// A radial magnetic bearing with its control: its keys, and the numbers of its kernel.
#define KERNEL_FILE "elements/supports/magnetic_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 25
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS MAGNETIC_NUMBERS
#define KERNEL_SWITCHES 8
#define KERNEL_SWITCHES_BY_STATES
#define KERNEL_SWITCHES_OF(own) ((own)->law & MAGNETIC_LINEAR ? 0 : KERNEL_SWITCHES)

/// Switches of each coil: its current above 0, and its current below the largest; and the number of switches of each
/// axis.
enum { MAGNETIC_ABOVE, MAGNETIC_BELOW, MAGNETIC_LIMITS, MAGNETIC_AXIS_SWITCHES = 2 * MAGNETIC_LIMITS };

/// The transfer functions of the loop, of an order up to BLOCK_ORDER: the numbers b_0, b_1, ..., then a_0, a_1, ...
enum { SENSOR, PID, FILTER, AMPLIFIER, LOOP_BLOCKS };
enum { BLOCK_ORDER = 6, BLOCK_NUMBERS = 2 * BLOCK_ORDER + 1 };

/// Bits of the law: linear in current and displacement; fails. From bit MAGNETIC_ORDERS on: the orders of the transfer
/// functions.
enum { MAGNETIC_LINEAR = 1, MAGNETIC_FAILS = 2, MAGNETIC_ORDERS = 2, ORDER_BITS = 3 };

/// Numbers of the law. The unit of currents is the current that corresponds to a displacement of one length scale, so
/// that distances of states do not depend on the length scale. That current over displacement is i_0/s_0 for law
/// quadratic, and k_s/k_i for law linear. The clock x of bearings that fail is stored in the same unit, as x times 1 A.
///
/// The numbers are: k cos a divided by the square of the length scale; s_0 in length scales; i_0; i_max; k_i; k_s by
/// length scales; 1 A; cosine and sine of the first axis; lambda; the value of x when currents begin to fall, and 1
/// divided by the growth of x while they fall.
enum {
    MAGNETIC_FORCE,
    MAGNETIC_GAP,
    MAGNETIC_BIAS,
    MAGNETIC_MAX,
    MAGNETIC_BY_CURRENT,
    MAGNETIC_BY_PLACE,
    MAGNETIC_AMPERE,
    MAGNETIC_COS,
    MAGNETIC_SIN,
    MAGNETIC_CLOCK,
    MAGNETIC_FAILS_AT,
    MAGNETIC_FALLS,
    MAGNETIC_BLOCKS,
    MAGNETIC_NUMBERS = MAGNETIC_BLOCKS + LOOP_BLOCKS * BLOCK_NUMBERS
};

#include "element.h"

static inline int block_order(const element *own, int part) {
    return own->law >> (MAGNETIC_ORDERS + ORDER_BITS * part) & ((1 << ORDER_BITS) - 1);
}
static inline int loop_order(const element *own) {
    int order = 0;
    for (int part = 0; part < LOOP_BLOCKS; part++) order += block_order(own, part);
    return order;
}

#include "generic.h"
#include "registry.h"

const element_kernels ISA(magnetic_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

enum {
    AT,
    FROM,
    ANGLE,
    LAW,
    GAP,
    BIAS,
    CONSTANT,
    TURNS,
    AREA,
    POLE_ANGLE,
    CURRENT_STIFFNESS,
    PLACE_STIFFNESS,
    MAX_CURRENT,
    PROPORTIONAL,
    INTEGRAL,
    DERIVATIVE,
    DERIVATIVE_FILTER,
    NUMERATOR,
    DENOMINATOR,
    SENSOR_BANDWIDTH,
    SENSOR_DAMPING,
    AMPLIFIER_BANDWIDTH,
    AMPLIFIER_DAMPING,
    FAILS_AFTER,
    FAILS_WITHIN,
    KEY_COUNT
};
enum { QUADRATIC, LINEAR };

#define BOOK "Schweitzer, Maslen 2009"

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", REQUIRED, "station that it carries"),
    [FROM] = STATION_KEY("from", OPTIONAL, "station of the housing; absent: the ground"),
    [ANGLE] = NUMBER_KEY("angle", "", "rad", DEFAULT("0.78539816339744831"), WHIRL_ANY,
                         "angle of its first axis, from the x axis towards y; absent: 45 degrees; the second axis is a "
                         "right angle further on"),
    [LAW] = CITED_CHOICE_KEY("law", DEFAULT("quadratic"), "quadratic|linear",
                             "quadratic: opposing magnets, whose currents are limited; linear: k_i i + k_s u", BOOK),
    [GAP] = NUMBER_KEY("gap", "s_0", "m", OPTIONAL, WHIRL_POSITIVE, "air gap in the middle; with law quadratic"),
    [BIAS] = NUMBER_KEY("bias", "i_0", "A", OPTIONAL, WHIRL_POSITIVE, "bias current of every coil; with law quadratic"),
    [CONSTANT] = CITED_NUMBER_KEY("constant", "k", "1", OPTIONAL, WHIRL_POSITIVE,
                                  "force of a magnet over the square of current by gap, in N m2/A2: mu_0 N^2 A/4; in "
                                  "place of turns and area",
                                  BOOK),
    [TURNS] = NUMBER_KEY("turns", "N", "1", OPTIONAL, WHIRL_POSITIVE, "turns of a magnet's coils, of both poles"),
    [AREA] = NUMBER_KEY("area", "A", "m2", OPTIONAL, WHIRL_POSITIVE, "area of one of a magnet's two poles"),
    [POLE_ANGLE] = NUMBER_KEY("pole_angle", "a", "rad", DEFAULT("0.39269908169872415"), WHIRL_FROM_TO(0, 1.5),
                              "angle between a pole and the axis; absent: 22.5 degrees, as with eight poles"),
    [CURRENT_STIFFNESS] =
        NUMBER_KEY("current_stiffness", "k_i", "N/A", OPTIONAL, WHIRL_POSITIVE, "force over current; with law linear"),
    [PLACE_STIFFNESS] = NUMBER_KEY("displacement_stiffness", "k_s", "N/m", OPTIONAL, WHIRL_NOT_NEGATIVE,
                                   "force over displacement, which pulls away from the middle; with law linear"),
    [MAX_CURRENT] = NUMBER_KEY("max_current", "i_max", "A", OPTIONAL, WHIRL_POSITIVE,
                               "largest current of a coil; with law quadratic; absent: no limit"),
    [PROPORTIONAL] = NUMBER_KEY("proportional", "K_p", "A/m", DEFAULT("0"), WHIRL_ANY,
                                "current divided by the displacement, which it opposes"),
    [INTEGRAL] =
        NUMBER_KEY("integral", "K_i", "A/(m s)", DEFAULT("0"), WHIRL_ANY,
                   "current divided by the integral of the displacement; it carries the weight without an offset"),
    [DERIVATIVE] = NUMBER_KEY("derivative", "K_d", "A s/m", DEFAULT("0"), WHIRL_ANY,
                              "current divided by the velocity, which it opposes"),
    [DERIVATIVE_FILTER] = NUMBER_KEY("derivative_filter", "T_f", "s", OPTIONAL, WHIRL_POSITIVE,
                                     "time constant of the derivative's filter, K_d s/(1 + s T_f)"),
    [NUMERATOR] = CITED_NUMBERS_KEY("numerator", "", "1", OPTIONAL, WHIRL_ANY,
                                    "numerator of a transfer function in s, SI, highest power first: a filter after "
                                    "the PID, or the whole controller, in A/m",
                                    BOOK),
    [DENOMINATOR] =
        CITED_NUMBERS_KEY("denominator", "", "1", OPTIONAL, WHIRL_ANY,
                          "denominator of that transfer function, highest power first, up to the sixth", BOOK),
    [SENSOR_BANDWIDTH] = NUMBER_KEY("sensor_bandwidth", "f_s", "Hz", OPTIONAL, WHIRL_POSITIVE,
                                    "corner frequency of the sensor; absent: no lag"),
    [SENSOR_DAMPING] = NUMBER_KEY("sensor_damping", "", "1", OPTIONAL, WHIRL_POSITIVE,
                                  "damping ratio of a sensor of second order; absent: first order"),
    [AMPLIFIER_BANDWIDTH] = NUMBER_KEY("amplifier_bandwidth", "f_a", "Hz", OPTIONAL, WHIRL_POSITIVE,
                                       "corner frequency of the amplifier; absent: no lag"),
    [AMPLIFIER_DAMPING] = NUMBER_KEY("amplifier_damping", "", "1", OPTIONAL, WHIRL_POSITIVE,
                                     "damping ratio of an amplifier of second order; absent: first order"),
    [FAILS_AFTER] = NUMBER_KEY("fails_after", "", "1", OPTIONAL, WHIRL_POSITIVE,
                               "revolutions after which the currents are switched off; absent: never"),
    [FAILS_WITHIN] = NUMBER_KEY("fails_within", "", "s", DEFAULT("0.001"), WHIRL_POSITIVE,
                                "time in which the currents then fall to zero"),
};

// ---------------------------------------------------------------- the loop

/// A transfer function by ascending powers of s.
typedef struct transfer {
    int order;
    double b[BLOCK_ORDER + 1], a[BLOCK_ORDER + 1];
} transfer;

static transfer lag(const key_value *bandwidth, const key_value *damping) {
    const double corner = 6.283185307179586476925 * bandwidth->number, square = corner * corner;
    if (!bandwidth->given) return (transfer){0, {1.0}, {1.0}};
    if (!damping->given) return (transfer){1, {corner}, {corner, 1.0}};
    return (transfer){2, {square}, {square, 2.0 * damping->number * corner, 1.0}};
}

/// Returns the transfer function K_p + K_i/s + K_d s/(1 + s T_f), without poles for gains of zero.
static transfer pid(const key_value *values) {
    const double p = values[PROPORTIONAL].number, i = values[INTEGRAL].number, d = values[DERIVATIVE].number;
    const double rate = values[DERIVATIVE_FILTER].given ? 1.0 / values[DERIVATIVE_FILTER].number : 0.0;
    const bool any = values[PROPORTIONAL].given || values[INTEGRAL].given || values[DERIVATIVE].given;
    if (!any) return (transfer){0, {1.0}, {1.0}};
    if (i != 0.0 && d != 0.0) return (transfer){2, {i * rate, p * rate + i, p + d * rate}, {0.0, rate, 1.0}};
    if (i != 0.0) return (transfer){1, {i, p}, {0.0, 1.0}};
    if (d != 0.0) return (transfer){1, {p * rate, p + d * rate}, {rate, 1.0}};
    return (transfer){0, {p}, {1.0}};
}

/// Writes the numbers of a list, which has the highest power first, by ascending powers. Returns the order.
static int powers(const key_value *list, double *out) {
    const int count = list->count ? (int)list->count : 1;
    for (int k = 0; k < count && k <= BLOCK_ORDER; k++) out[k] = list->count ? list->list[count - 1 - k] : list->number;
    return count - 1;
}

static whirl_status filter(const key_value *values, transfer *out) {
    *out = (transfer){0, {1.0}, {1.0}};
    if (!values[NUMERATOR].given && !values[DENOMINATOR].given) return whirl_ok();
    if (!values[NUMERATOR].given || !values[DENOMINATOR].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has one of numerator and denominator, expected both");
    const int above = powers(&values[NUMERATOR], out->b), below = powers(&values[DENOMINATOR], out->a);
    if (below > BLOCK_ORDER)
        return whirl_fail(WHIRL_BAD_INPUT, "has a denominator of order %d, expected at most %d", below, BLOCK_ORDER);
    if (above > below)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a numerator of order %d over a denominator of order %d, expected none of a higher order",
                          above, below);
    if (out->a[below] == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "has a denominator that begins with 0, expected its highest power first");
    out->order = below;
    return whirl_ok();
}

/// Writes a transfer function with time in 1/clock and a_m = 1, and its output multiplied by `unit`.
static void magnetic_put(const transfer *from, double clock, double unit, int part, element *out) {
    const int m = from->order;
    double *b = out->number + MAGNETIC_BLOCKS + (size_t)part * BLOCK_NUMBERS, *a = b + BLOCK_ORDER + 1;
    for (int k = 0; k <= m; k++) {
        b[k] = unit * from->b[k] / from->a[m] * pow(clock, k - m);
        if (k < m) a[k] = from->a[k] / from->a[m] * pow(clock, k - m);
    }
    out->law |= m << (MAGNETIC_ORDERS + ORDER_BITS * part);
    out->states += 2 * (size_t)m;
}

static whirl_status put_loop(const key_value *values, const assembly *to, double ampere, element *out) {
    const transfer sensor = lag(&values[SENSOR_BANDWIDTH], &values[SENSOR_DAMPING]), law = pid(values);
    const transfer amplifier = lag(&values[AMPLIFIER_BANDWIDTH], &values[AMPLIFIER_DAMPING]);
    transfer behind;
    const whirl_status status = filter(values, &behind);
    if (status.code != WHIRL_OK) return status;
    magnetic_put(&sensor, to->clock, 1.0, SENSOR, out);
    magnetic_put(&law, to->clock, to->length * ampere, PID, out); // currents from here on
    magnetic_put(&behind, to->clock, 1.0, FILTER, out);
    magnetic_put(&amplifier, to->clock, 1.0, AMPLIFIER, out);
    return whirl_ok();
}

// ---------------------------------------------------------------- the rest

static whirl_status magnetic_check_keys(const key_value *values) {
    const bool linear = values[LAW].choice == LINEAR, given = values[CONSTANT].given;
    // Both laws need some keys, and do not use others.
    static const struct {
        int key;
        bool linear, required;
    } rules[] = {{GAP, false, true},
                 {BIAS, false, true},
                 {CONSTANT, false, false},
                 {TURNS, false, false},
                 {AREA, false, false},
                 {CURRENT_STIFFNESS, true, true},
                 {PLACE_STIFFNESS, true, true},
                 {MAX_CURRENT, false, false}};
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        const bool has = values[rules[i].key].given;
        const char *name = keys[rules[i].key].name;
        if (rules[i].required && rules[i].linear == linear && !has)
            return whirl_fail(WHIRL_BAD_INPUT, "has no %s, expected one: its law needs it", name);
        if (rules[i].linear != linear && has)
            return whirl_fail(WHIRL_BAD_INPUT, "has a %s, which its law has no use for, expected none", name);
    }
    // The strength of magnets must be given in one way.
    if (!linear && given == (values[TURNS].given && values[AREA].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has %s, expected constant, or turns and area",
                          given ? "both constant and turns with area" : "no strength of its magnets");
    if (given && (values[TURNS].given || values[AREA].given))
        return whirl_fail(WHIRL_BAD_INPUT, "has both constant and turns or area, expected one way");
    if (values[MAX_CURRENT].given && !(values[MAX_CURRENT].number > values[BIAS].number))
        return whirl_fail(WHIRL_BAD_INPUT, "has a max_current of %g A, expected one above the bias of %g A",
                          values[MAX_CURRENT].number, values[BIAS].number);
    // The controller must have a gain or a transfer function, and keys that belong together must be given together.
    if (values[DERIVATIVE].number != 0.0 && !values[DERIVATIVE_FILTER].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has no derivative_filter, expected one: a derivative needs it");
    if (!values[PROPORTIONAL].given && !values[INTEGRAL].given && !values[DERIVATIVE].given && !values[NUMERATOR].given)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "has no controller, expected proportional, integral, derivative, or numerator and denominator");
    if (values[SENSOR_DAMPING].given && !values[SENSOR_BANDWIDTH].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has a sensor_damping without sensor_bandwidth, expected both");
    if (values[AMPLIFIER_DAMPING].given && !values[AMPLIFIER_BANDWIDTH].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has an amplifier_damping without amplifier_bandwidth, expected both");
    return whirl_ok();
}

/// Limit of coils without limit: a current that no coil reaches.
static const double NO_LIMIT = 0x1p300;

/// mu_0 in N/A2: 4 pi 1e-7 to nine digits.
static const double permeability = 1.2566370614359173e-6;

/// Returns the constant k of a magnet, N m2/A2.
static double strength(const key_value *values) {
    const double turns = values[TURNS].number;
    return values[CONSTANT].given ? values[CONSTANT].number : 0.25 * permeability * turns * turns * values[AREA].number;
}

/// Returns 1 A in the unit of currents. A linear bearing without k_s has no natural unit.
static double ampere_of(const key_value *values, double length) {
    const double usual = 1e4; // A/m
    double by_place = values[BIAS].number / values[GAP].number;
    if (values[LAW].choice == LINEAR) by_place = values[PLACE_STIFFNESS].number / values[CURRENT_STIFFNESS].number;
    return 1.0 / ((by_place > 0.0 ? by_place : usual) * length);
}

static void put_failure(const key_value *values, const assembly *to, element *out) {
    if (!values[FAILS_AFTER].given) return;
    const double after = 6.283185307179586476925 * values[FAILS_AFTER].number, lambda = 1.0 / after;
    const double within = values[FAILS_WITHIN].number * to->clock;
    out->law |= MAGNETIC_FAILS;
    out->states++;
    out->number[MAGNETIC_CLOCK] = lambda;
    out->number[MAGNETIC_FAILS_AT] = out->number[MAGNETIC_AMPERE] * (0.0 - expm1(-1.0));
    out->number[MAGNETIC_FALLS] = 1.0 / (out->number[MAGNETIC_AMPERE] * exp(-1.0) * (0.0 - expm1(-lambda * within)));
}

static whirl_status magnetic_build(const key_value *values, assembly *to, element *out) {
    const double length = to->length;
    // Add the states of the controller, which come first.
    whirl_status status = magnetic_check_keys(values);
    if (status.code == WHIRL_OK) status = element_in_housing(&values[AT], &values[FROM], to, out);
    out->law = values[LAW].choice == LINEAR ? MAGNETIC_LINEAR : 0;
    out->states = 0;
    if (status.code != WHIRL_OK) return status;
    const double ampere = ampere_of(values, length), of_force = length * ampere;
    status = put_loop(values, to, ampere, out);
    if (status.code != WHIRL_OK) return status;
    // Compute the numbers of the law, in a unit of current for which forces and displacements are in the rotor's units.
    out->number[MAGNETIC_AMPERE] = ampere;
    out->number[MAGNETIC_FORCE] = strength(values) * cos(values[POLE_ANGLE].number) / (of_force * of_force);
    out->number[MAGNETIC_GAP] = values[GAP].number / length;
    out->number[MAGNETIC_BIAS] = values[BIAS].number * ampere;
    out->number[MAGNETIC_MAX] = values[MAX_CURRENT].given ? values[MAX_CURRENT].number * ampere : NO_LIMIT;
    out->number[MAGNETIC_BY_CURRENT] = values[CURRENT_STIFFNESS].number / ampere;
    out->number[MAGNETIC_BY_PLACE] = values[PLACE_STIFFNESS].number * length;
    out->number[MAGNETIC_COS] = cos(values[ANGLE].number);
    out->number[MAGNETIC_SIN] = sin(values[ANGLE].number);
    put_failure(values, to, out);
    generic_scale(out, to, 1.0);
    return whirl_ok();
}

static void magnetic_loop(const element *own, const double *q, const double *states, size_t index, double *acceleration,
                          double *slope, double *sensed) {
    const kernel_view view = {.stride = 1, .number = own->number};
    const double c = own->number[MAGNETIC_COS], sine = own->number[MAGNETIC_SIN];
    const double along[2] = {index == 0 ? c : 0.0 - sine, index == 0 ? sine : c};
    const double u = along[0] * (q[0] - q[2]) + along[1] * (q[1] - q[3]);
    const size_t order = (size_t)loop_order(own), first = index * order;
    dual s[KERNEL_STATES], rates[KERNEL_STATES];
    for (size_t i = 0; i < order; i++) s[i] = dual_of(states[first + i]);
    dual current = dual_input(u, 0);
    currents_dual(own, &view, 1, &current, s, rates);
    const double pull = pull_dual(own, &view, dual_of(u), current, NULL).by[0];
    for (size_t i = 0; i < order; i++) slope[first + i] = rates[i].by[0];
    for (size_t p = 0; p < KERNEL_PORTS; p++) {
        const double way = p < KERNEL_AXES ? 1.0 : -1.0;
        acceleration[p] = way * own->number[KERNEL_NUMBERS + p] * pull * along[p % KERNEL_AXES];
        sensed[p] = way * along[p % KERNEL_AXES];
    }
}

/// Returns the ratio of the current to a state, for a loop whose last part lags, so that the current is a state; 0 for
/// other loops. *before becomes the number of the loop's states before it.
static double current_by_state(const element *own, size_t *before) {
    double factor = -1.0;
    *before = (size_t)loop_order(own);
    for (int part = AMPLIFIER; part >= SENSOR; part--) {
        const int order = block_order(own, part);
        const double last = own->number[MAGNETIC_BLOCKS + part * BLOCK_NUMBERS + order];
        *before -= (size_t)order;
        if (order > 0) return last == 0.0 ? factor : 0.0;
        factor *= last;
    }
    return 0.0;
}

/// Returns false: at these switches coils reach their limits, and no contact begins.
static bool magnetic_touches(const element *own, size_t index) {
    (void)own, (void)index;
    return false;
}

/// Returns false: at these switches only the slope of the force changes.
static bool magnetic_jumps(const element *own) {
    (void)own;
    return false;
}

/// Describes the ranges: coil currents, and the gap between magnets.
static bool magnetic_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    const double *number = own->number, bias = number[MAGNETIC_BIAS], ampere = number[MAGNETIC_AMPERE];
    size_t before;
    const double factor = current_by_state(own, &before);
    if (own->law & MAGNETIC_LINEAR) return false;
    if (index == 0) {
        *out = (element_range){"distance over air gap", "1", "at which the rotor touches a magnet", 1.0, NAN};
        out->reached = seen->radius / number[MAGNETIC_GAP];
        return true;
    }
    *out = (element_range){"control current", "A", "at which a coil is at its limit", NAN, 0.0};
    out->most = fmin(bias, number[MAGNETIC_MAX] - bias) / ampere;
    for (size_t at = before; at < 2 * (size_t)loop_order(own) && factor != 0.0; at += (size_t)loop_order(own))
        out->reached =
            fmax(out->reached, fabs(factor) / ampere * fmax(seen->state_high[at], 0.0 - seen->state_low[at]));
    return index == 1 && factor != 0.0;
}

/// Raises a doubt about currents with which iron saturates. The field is B = mu_0 N i/(2 s_0) for a magnet whose N
/// turns are on both poles.
static void magnetic_doubt(const key_value *values, double speed, const doubt_teller *to) {
    const double most = 1.6;
    const double current = values[MAX_CURRENT].given ? values[MAX_CURRENT].number : values[BIAS].number;
    const double field = permeability * values[TURNS].number * current / (2.0 * values[GAP].number);
    (void)speed;
    if (values[TURNS].given && field > most)
        doubt_value(to, keys[values[MAX_CURRENT].given ? MAX_CURRENT : BIAS].name,
                    "is so large that the field in the gap would be %.3g T, and iron saturates at about %g T", field,
                    most);
}

/// Implements element_type.paced: state j of a transfer function is a derivative of order j.
static void magnetic_paced(const element *own, const double *states, double *out) {
    size_t next = 0;
    for (size_t i = 0; i < own->states; i++) out[i] = 0.0;
    for (int line = 0; line < 2; line++)
        for (int part = 0; part < LOOP_BLOCKS; part++)
            for (int j = 0; j < block_order(own, part); j++, next++) out[next] = j * states[next];
}

/// Returns the index of the state that counts the time until the bearing fails, the last one; the number of states if
/// it does not fail.
static size_t magnetic_clock(const element *own) {
    return own->law & MAGNETIC_FAILS ? own->states - 1 : own->states;
}

KERNELS_OF_EVERY_ISA(magnetic_kernels);

const element_type magnetic_element = {
    .group = {"magnetic", "a radial magnetic bearing with sensor, controller and amplifier", BOOK, keys, KEY_COUNT,
              NULL, NULL},
    .number_count = KERNEL_NUMBERS + KERNEL_PORTS,
    .state_count = KERNEL_STATES,
    .kernels = kernels,
    .build = magnetic_build,
    .clock = magnetic_clock,
    .paced = magnetic_paced,
    GENERIC_SWITCHES,
    .touches = magnetic_touches,
    .jumps = magnetic_jumps,
    .loops = KERNEL_AXES,
    .loop = magnetic_loop,
    .carries = true,
    .range = magnetic_range,
    .doubt = magnetic_doubt,
};
#endif
