// Stationary speeds of a drive: where its torque equals the torque that brakes the shaft; and the folds of that
// balance.
//
// A run may differ from the balance: a motor that could stay at a resonance for ever may pass it, since the motion
// needs time to build up.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "runup_parts.h"
#include "two_pi.h"
#include "whirl/engine/linear.h"

/// Instants of a turn over which torques are averaged.
enum { INSTANTS = 64 };

typedef struct balancing {
    const whirl_resting *point;
    whirl_running *running;
    size_t dimension; ///< dimension of the rotor's state
    double *rest;     ///< equilibrium [dimension], then the response [dimension][2]
    double *x;        ///< [dimension + 2] a state of the run with the angle as variable
} balancing;

/// Computes the motor's torque and the braking torque, a mean over a turn of small motions at a speed, rad/s. Both are
/// NaN where there is no small motion.
static void balance_at(const balancing *b, double speed, double *motor, double *brake) {
    whirl_machine machine;
    *motor = *brake = (double)NAN;
    if (b->point->at_speed(b->point->context, speed, WHIRL_AS_GIVEN, 0.0, &machine).code != WHIRL_OK) return;
    double *response = b->rest + b->dimension;
    const bool moves = machine.system->dimension == b->dimension &&
                       whirl_forced_response(machine.system, machine.start, b->rest, response).code == WHIRL_OK;
    if (machine.release) machine.release(machine.owner);
    if (!moves) return;
    double sum = 0.0;
    for (size_t k = 0; k < INSTANTS; k++) {
        const double angle = two_pi * (double)k / INSTANTS, c = cos(angle), s = sin(angle);
        whirl_torques torques;
        for (size_t i = 0; i < b->dimension; i++) b->x[i] = b->rest[i] + response[2 * i] * c - response[2 * i + 1] * s;
        b->x[b->dimension] = speed / b->running->unit;
        b->x[b->dimension + 1] = 0.0;
        b->running->torques(b->running, b->x, angle, &torques);
        *motor = torques.motor;
        sum += torques.load + torques.friction + torques.drag + torques.rotor;
    }
    *brake = -sum / INSTANTS;
}

static double balance_rest(const balancing *b, double speed) {
    double motor, brake;
    balance_at(b, speed, &motor, &brake);
    return motor - brake;
}

/// Returns the factor by which the motor's torque would have to be multiplied to hold a speed.
static double balance_factor(const balancing *b, double speed) {
    double motor, brake;
    balance_at(b, speed, &motor, &brake);
    return brake / motor;
}

/// Returns the slope over the speed of the factor that balance_factor computes, by a central difference of fourth
/// order.
static double balance_slope(const balancing *b, double speed) {
    const double h = 2e-5 * speed;
    return (8.0 * (balance_factor(b, speed + h) - balance_factor(b, speed - h)) -
            (balance_factor(b, speed + 2.0 * h) - balance_factor(b, speed - 2.0 * h))) /
           (12.0 * h);
}

typedef double balance_quantity(const balancing *b, double speed);

/// Finds where a quantity passes 0 between two speeds at which its values have different signs.
static double balance_root(const balancing *b, balance_quantity *of, const double speeds[2], const double values[2]) {
    bracket between = bracket_between(speeds[0], values[0], speeds[1], values[1]);
    double speed = speeds[1];
    for (int i = 0; i < 60 && bracket_width(&between) > 1e-13 * speeds[1]; i++) {
        speed = bracket_next(&between);
        const double value = of(b, speed);
        if (isnan(value) || value == 0.0) break;
        bracket_update(&between, speed, value);
    }
    return speed;
}

/// Rows of a field with three columns, as they fill.
typedef struct balance_rows {
    double *numbers;
    size_t count;
} balance_rows;

static void balance_add(balance_rows *to, double first, double second, double third) {
    if (to->count == RUNUP_STATIONARY) return;
    double *row = to->numbers + 3 * to->count++;
    row[0] = first, row[1] = second, row[2] = third;
}

/// A speed, and the motor's torque less the braking torque at that speed.
typedef struct balance_rest_at {
    double speed, rest;
} balance_rest_at;

/// Adds the stationary speed between two speeds, if there is one.
static void balance_find_speed(const balancing *b, balance_rest_at low, balance_rest_at high,
                               balance_rows *stationary) {
    const double speeds[] = {low.speed, high.speed}, rests[] = {low.rest, high.rest};
    double motor, brake;
    if (!(rests[0] * rests[1] < 0.0)) return;
    const double speed = balance_root(b, balance_rest, speeds, rests);
    balance_at(b, speed, &motor, &brake);
    balance_add(stationary, speed, motor, rests[0] > 0.0 ? 1.0 : 0.0);
}

/// Adds the fold near the middle of three speeds, if the factor of the motor's torque has an extreme there. Returns its
/// speed, else the middle one.
static double balance_find_fold(const balancing *b, const double speeds[3], const double factors[3],
                                balance_rows *folds) {
    const double ends[] = {speeds[0], speeds[2]};
    if (!((factors[1] - factors[0]) * (factors[2] - factors[1]) < 0.0)) return speeds[1];
    const double slopes[] = {balance_slope(b, ends[0]), balance_slope(b, ends[1])};
    if (!(slopes[0] * slopes[1] < 0.0)) return speeds[1];
    const double speed = balance_root(b, balance_slope, ends, slopes), factor = balance_factor(b, speed);
    if (factor > 0.0) balance_add(folds, speed, factor, slopes[0] > 0.0 ? 1.0 : 0.0);
    return speed;
}

/// Goes through all speeds, from the lowest.
static void balance_go(const balancing *b, size_t count, double highest, balance_rows *stationary,
                       balance_rows *folds) {
    double speeds[3] = {0.0}, factors[3] = {0.0}, rests[3] = {0.0}, motor, brake;
    balance_rest_at last = {0.0, 0.0};
    for (size_t k = 1; k <= count && !whirl_stop_is_set(b->point->stop); k++) {
        // The motor has no torque at its last speed: stop just below it.
        const double speed = highest * ((double)k - (k == count ? 1e-6 : 0.0)) / (double)count;
        memmove(speeds, speeds + 1, 2 * sizeof *speeds);
        memmove(factors, factors + 1, 2 * sizeof *factors);
        memmove(rests, rests + 1, 2 * sizeof *rests);
        balance_at(b, speed, &motor, &brake);
        speeds[2] = speed;
        factors[2] = brake / motor;
        rests[2] = motor - brake;
        if (k == 1) last = (balance_rest_at){speed, rests[2]};
        if (k < 3) continue;
        // A fold between two speeds splits the interval between them into two.
        const double fold = balance_find_fold(b, speeds, factors, folds);
        const balance_rest_at middle = {fold, fold == speeds[1] ? rests[1] : balance_rest(b, fold)};
        balance_find_speed(b, last, middle, stationary);
        last = middle;
        if (k == count) balance_find_speed(b, last, (balance_rest_at){speed, rests[2]}, stationary);
    }
}

whirl_status runup_find_stationary(const whirl_resting *point, whirl_running *running, bool drag, size_t count,
                                   double highest, double *stationary, double *folds) {
    const size_t own = running->by_angle->dimension;
    balancing b = {.point = point, .running = running, .dimension = own - 2};
    balance_rows found[] = {{stationary, 0}, {folds, 0}};
    b.rest = calloc(3 * b.dimension + own, sizeof *b.rest);
    if (!b.rest) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the stationary speeds of a drive");
    b.x = b.rest + 3 * b.dimension;
    running->turn(running, &(whirl_turning){.driven = true, .dragless = !drag});
    balance_go(&b, count, highest, &found[0], &found[1]);
    free(b.rest);
    return whirl_ok();
}
