// Energy of the run-ups of the gallery: what motors give, less what loads, dampers, films and friction take, is in the
// motion. Energies and powers are written out here from the numbers of the cases.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_runs.h"
#include "support_study.h"
#include "whirl/engine/case.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/result.h"
#include "whirl/engine/running.h"
#include "whirl/engine/study.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { MAX_STATE = 64, STATIONS = 4, TORQUES = 8 };

static const double pi = 3.14159265358979323846, gravity = 9.81;

/// A state in SI: displacements and velocities of stations; speed and angle of the shaft; torques that are watched, and
/// speeds of stations that twist.
typedef struct seen {
    double x[STATIONS], y[STATIONS], vx[STATIONS], vy[STATIONS];
    double speed, angle;
    double other_speed, other_angle; ///< of the first shaft with a speed of its own, about z
    double torque[TORQUES], turning[STATIONS];
    bool after; ///< the blade is lost and the motor has tripped
} seen;

/// Energy of a motion, J; power, W, that the motor gives and that all others take; and that of friction in contacts.
typedef struct account {
    double energy, given, taken, rubbing;
} account;

/// A machine with its account: the last two numbers of a state are the work that the motor gave, and that of all
/// others, in J.
typedef struct ledger {
    double length; ///< m, length scale of the case
    whirl_running *running;
    whirl_system system;
    bool after; ///< as in `seen`
    void (*find)(const seen *at, account *out);
} ledger;

// ---------------------------------------------------------------- work along with a motion

static account ledger_account(const ledger *own, const double *x) {
    // See the state in SI.
    const whirl_running *running = own->running;
    const whirl_system *inner = running->by_time;
    const size_t d = inner->dimension;
    double placed[MAX_STATE];
    account found;
    seen at = {.speed = x[d - 3] * running->unit, .angle = x[d - 1], .after = own->after};
    for (size_t p = 0; p < inner->probe_count; p++) {
        const whirl_probe *probe = &inner->probes[p];
        at.x[p] = own->length * whirl_probe_value(probe, x, 0);
        at.y[p] = own->length * whirl_probe_value(probe, x, 1);
        at.vx[p] = own->length * running->unit * whirl_probe_value(probe, x, 2);
        at.vy[p] = own->length * running->unit * whirl_probe_value(probe, x, 3);
    }
    memcpy(placed, x, d * sizeof *placed);
    if (running->spool_count > 0) {
        const double sense = inner->spools[0].sense;
        at.other_angle = sense * x[running->spool_state];
        at.other_speed = sense * x[running->spool_state + 1] * running->unit;
    }
    running->to_angle(running, placed);
    running->speeds(running, placed, at.turning);
    if (running->in_time) running->watch(running, placed, at.angle, at.torque);
    own->find(&at, &found);
    return found;
}

static void ledger_add(const ledger *own, const double *x, double *dxdt) {
    const size_t next = own->running->by_time->dimension;
    const account found = ledger_account(own, x);
    dxdt[next] = found.given / own->running->unit;
    dxdt[next + 1] = found.taken / own->running->unit;
}

static void ledger_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const ledger *own = model;
    const whirl_system *inner = own->running->by_time;
    inner->rhs(inner->model, t, forcing, x, dxdt);
    ledger_add(own, x, dxdt);
}

static void ledger_rhs_on_sides(const void *model, double t, const double *forcing, const double *x,
                                const double *sides, double *dxdt) {
    const ledger *own = model;
    const whirl_system *inner = own->running->by_time;
    inner->rhs_on_sides(inner->model, t, forcing, x, sides, dxdt);
    ledger_add(own, x, dxdt);
}

static void ledger_switches(const void *model, double t, const double *x, double *values) {
    const whirl_system *inner = ((const ledger *)model)->running->by_time;
    inner->switches(inner->model, t, x, values);
}

static void ledger_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                            double *by_time) {
    const whirl_system *inner = ((const ledger *)model)->running->by_time;
    inner->switch_gradient(inner->model, t, x, index, gradient, by_time);
    gradient[inner->dimension] = gradient[inner->dimension + 1] = 0.0;
}

static bool ledger_touches(const void *model, size_t index) {
    const whirl_system *inner = ((const ledger *)model)->running->by_time;
    return inner->switch_touches(inner->model, index);
}

/// Opens the machine of a case, driven by its torques from rest on, at its equilibrium: x, the state.
static void ledger_open(ledger *own, const run_point *at, double *x) {
    whirl_machine machine;
    require_ok(run_point_machine(at, 0.0, NULL, &machine));
    const double highest = machine.drive_speed;
    whirl_turning how = {.driven = true};
    whirl_spool_range spools[WHIRL_MAX_SPOOLS];
    double slow[WHIRL_MAX_SPOOLS] = {0.0};
    for (size_t k = 0; k < machine.system->spool_count; k++) {
        spools[k] = (whirl_spool_range){machine.system->spools[k].drive_speed, true};
        slow[k] = machine.system->spools[k].drive_speed / 256.0;
        how.spools[k].law = WHIRL_SPOOL_DRIVEN;
    }
    machine.release(machine.owner);
    require_ok(whirl_running_new(run_point_machine, at, 0.0, highest, true, spools, &own->running));
    require_ok(run_point_machine(at, highest / 256.0, slow, &machine));
    memcpy(x, machine.start, machine.system->dimension * sizeof *x);
    require_ok(whirl_equilibrium(machine.system, x));
    machine.release(machine.owner);
    own->running->turn(own->running, &how);
    // Add the account to the equations.
    const whirl_system *inner = own->running->by_time;
    own->system = *inner;
    own->system.dimension += 2;
    own->system.rhs = ledger_rhs;
    own->system.rhs_on_sides = ledger_rhs_on_sides;
    own->system.switches = ledger_switches;
    own->system.switch_gradient = ledger_gradient;
    if (inner->switch_touches) own->system.switch_touches = ledger_touches;
    own->system.model = own;
    assert_true(own->system.dimension <= MAX_STATE && inner->probe_count <= STATIONS);
    assert_true(own->running->watched_count <= TORQUES);
}

/// Sums over a run: the work of the motor, J, what is missing in the balance, J, and the largest power of friction, W.
typedef struct sums {
    double given, missing, rubbing;
} sums;

/// Carries a state over `seconds` in parts of at most a turn at the highest speed, and adds to the sums.
static void ledger_carry(ledger *own, double seconds, double rtol, double *x, sums *to) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    const size_t next = own->running->by_time->dimension;
    const size_t parts = (size_t)ceil(seconds * own->running->unit / (2.0 * pi));
    strcpy(options.method, "dop853");
    options.steps_per_revolution = 1;
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    options.limit = 1e300;
    x[next] = x[next + 1] = 0.0;
    const double before = ledger_account(own, x).energy;
    own->running->part(own->running, 0.0, seconds * own->running->unit / (double)parts);
    own->system.period = own->running->by_time->period;
    require_ok(whirl_integrator_new(&own->system, &options, &integrator));
    for (size_t part = 0; part < parts; part++) {
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
        to->rubbing = fmax(to->rubbing, ledger_account(own, x).rubbing);
    }
    whirl_integrator_free(integrator);
    to->given += x[next];
    to->missing += x[next] - x[next + 1] - (ledger_account(own, x).energy - before);
}

// ---------------------------------------------------------------- energies and powers of the cases

/// Returns energy of a disc with an unbalance U at angle 0 whose shaft has the inertia J about axes through centres of
/// mass: kinetic energy of both, and potential energy in the weight.
static double disc_energy(const seen *at, size_t p, double mass, double moment, double inertia, double weight) {
    const double c = cos(at->angle), s = sin(at->angle), w = at->speed;
    const double vx = at->vx[p] - moment / mass * w * s, vy = at->vy[p] + moment / mass * w * c;
    return 0.5 * mass * (vx * vx + vy * vy) + 0.5 * inertia * w * w + weight * (mass * at->y[p] + moment * s);
}

static double square(double x, double y) {
    return x * x + y * y;
}

/// Adds a rub of friction f and radius R: the energy of its spring, and the power of N that slides at w R + v_t.
static void add_rub(const seen *at, size_t p, double gap, double stiffness, double friction, double radius,
                    account *out) {
    const double r = hypot(at->x[p], at->y[p]), normal = stiffness * (r - gap);
    if (!(normal > 0.0)) return;
    const double slip = at->speed * radius + (at->x[p] * at->vy[p] - at->y[p] * at->vx[p]) / r;
    out->energy += 0.5 * normal * normal / stiffness;
    out->rubbing += friction * normal * slip;
    out->taken += friction * normal * slip;
}

/// Adds a motor with a line of torque over the speed, and the square of a load.
static void add_drive(const seen *at, double torque, double no_load, double quadratic, account *out) {
    const double w = at->speed;
    if (!at->after) out->given += torque * (1.0 - w / no_load) * w;
    out->taken += quadratic * w * fabs(w) * w;
}

/// A point of Gauss's quadrature over half a turn: cosine and sine of its angle, and its weight.
typedef struct half_turn {
    double cosine, sine, weight;
} half_turn;

enum { PIECES = 16, POINTS = 8, HALF_TURN = PIECES * POINTS };

static half_turn half[HALF_TURN];

static void fill_half_turn(void) {
    static const double place[] = {.1834346424956498, .5255324099163290, .7966664774136267, .9602898564975363};
    static const double weight[] = {.3626837833783620, .3137066458778873, .2223810344533745, .1012285362903763};
    for (size_t i = 0; i < HALF_TURN; i++) {
        const size_t k = i % POINTS / 2;
        const double angle = pi / PIECES * ((double)(i / POINTS) + 0.5 + (i % 2 ? 0.5 : -0.5) * place[k]);
        half[i] = (half_turn){cos(angle), sin(angle), 0.5 * pi / PIECES * weight[k]};
    }
}

/// Returns the power in a short film, W, of surfaces whose speeds have the sum at->speed and that difference: shear all
/// around, and flow where the pressure is above 0, which is half of the
/// circumference.
static double film_power_of(const seen *at, size_t p, double clearance, double radius, double length, double viscosity,
                            double difference) {
    // h = c - x cos - y sin of the angle; the wedge w h'/2 + dh/dt = a cos + b sin of it, and below 0 behind `first`.
    const double x = at->x[p], y = at->y[p], w = at->speed;
    const double a = -0.5 * w * y - at->vx[p], b = 0.5 * w * x - at->vy[p];
    const double first = atan2(b, a) + 0.5 * pi, cosine = cos(first), sine = sin(first), slide = difference * radius;
    double flow = 0.0;
    for (size_t i = 0; i < HALF_TURN; i++) {
        const double c = cosine * half[i].cosine - sine * half[i].sine;
        const double s = sine * half[i].cosine + cosine * half[i].sine;
        const double h = clearance - x * c - y * s, wedge = a * c + b * s;
        flow += half[i].weight * wedge * wedge / (h * h * h);
    }
    const double shear = 2.0 * pi * slide * slide / sqrt(clearance * clearance - x * x - y * y);
    return viscosity * radius * length * (length * length * flow + shear);
}

static double film_power(const seen *at, size_t p, double clearance, double radius, double length, double viscosity) {
    return film_power_of(at, p, clearance, radius, length, viscosity, at->speed);
}

static void rub_run_up(const seen *at, account *out) {
    *out = (account){.energy = disc_energy(at, 0, 2.0, 40e-6, 0.004, gravity) + 1e5 * square(at->x[0], at->y[0]),
                     .taken = 40.0 * square(at->vx[0], at->vy[0])};
    add_rub(at, 0, 0.2e-3, 1e6, 0.1, 0.04, out);
    add_drive(at, 0.8, 300.0 * pi, 1e-7, out);
}

static void sommerfeld(const seen *at, double torque, account *out) {
    *out = (account){.energy = disc_energy(at, 0, 10.0, 5e-3, 0.5, 0.0) + 5e4 * square(at->x[0], at->y[0]),
                     .taken = 40.0 * square(at->vx[0], at->vy[0])};
    add_drive(at, torque, 100.0 * pi, 0.0, out);
}
static void sommerfeld_weak(const seen *at, account *out) {
    sommerfeld(at, 0.7, out);
}
static void sommerfeld_strong(const seen *at, account *out) {
    sommerfeld(at, 1.2, out);
}

/// Accounts for the torques of the motor and of both couplings; a coupling has k d + c d' of the twist d between its
/// ends.
static void motor_start(const seen *at, account *out) {
    static const double inertia[] = {0.089, 0.02, 0.002, 0.05};
    static const struct {
        size_t first, second;
        double stiffness, damping;
    } couplings[] = {{0, 1, 1500.0, 0.2}, {2, 3, 600.0, 0.05}};
    const double *w = at->turning, load = w[3];
    *out = (account){.given = at->torque[0] * w[0], .taken = 3.5e-5 * load * fabs(load) * load};
    for (size_t s = 0; s < COUNT_OF(inertia); s++) out->energy += 0.5 * inertia[s] * w[s] * w[s];
    for (size_t k = 0; k < COUNT_OF(couplings); k++) {
        const double rate = w[couplings[k].first] - w[couplings[k].second];
        const double spring = at->torque[1 + k] - couplings[k].damping * rate;
        out->energy += 0.5 * spring * spring / couplings[k].stiffness;
        out->taken += couplings[k].damping * rate * rate;
    }
}

static void fan(const seen *at, account *out) {
    enum { LEFT, FAN, RIGHT };
    static const size_t ends[] = {LEFT, RIGHT};
    *out = (account){.energy = disc_energy(at, FAN, 40.0, 120e-6 + (at->after ? 4e-3 : 0.0), 0.6, gravity)};
    for (size_t i = 0; i < COUNT_OF(ends); i++) {
        const size_t end = ends[i];
        out->energy += disc_energy(at, end, 4.0, 0.0, 0.0, gravity);
        out->energy += 4e6 * square(at->x[FAN] - at->x[end], at->y[FAN] - at->y[end]);
        out->taken += film_power(at, end, 0.1e-3, 0.03, 0.015, 0.02);
    }
    add_rub(at, FAN, 0.2e-3, 2e7, 0.1, 0.25, out);
    add_drive(at, 60.0, 300.0 * pi, 5e-5, out);
}

// ---------------------------------------------------------------- two shafts with speeds of their own

/// Adds a drive of the second shaft, whose torques are along its rotation, of that sense.
static void add_other_drive(const seen *at, double sense, double torque, double no_load, double quadratic,
                            account *out) {
    seen other = *at;
    other.speed = sense * at->other_speed;
    add_drive(&other, torque, no_load, quadratic, out);
}

/// Returns the energy of a disc on the second shaft, as disc_energy, with an unbalance at an angle.
static double other_energy(const seen *at, size_t p, double mass, double moment, double angle, double inertia) {
    seen other = *at;
    other.angle = at->other_angle + angle;
    other.speed = at->other_speed;
    return disc_energy(&other, p, mass, moment, inertia, gravity);
}

static void engine(const seen *at, account *out) {
    enum { FAN, CORE };
    const double x = at->x[FAN] - at->x[CORE], y = at->y[FAN] - at->y[CORE], r = hypot(x, y);
    const double vx = at->vx[FAN] - at->vx[CORE], vy = at->vy[FAN] - at->vy[CORE], normal = 2e7 * (r - 0.26e-3);
    *out = (account){.energy = disc_energy(at, FAN, 60.0, 480e-6, 3.0, gravity) +
                               other_energy(at, CORE, 45.0, 4e-4, 40.0 * pi / 180.0, 1.0) +
                               7e6 * square(at->x[FAN], at->y[FAN]) + 17e6 * square(at->x[CORE], at->y[CORE]) +
                               2e6 * square(x, y),
                     .taken = 900.0 * (square(at->vx[FAN], at->vy[FAN]) + square(at->vx[CORE], at->vy[CORE])) +
                              300.0 * square(vx, vy)};
    if (normal > 0.0) {
        const double slip = 0.08 * (at->speed - at->other_speed) + (x * vy - y * vx) / r;
        out->energy += 0.5 * normal * normal / 2e7;
        out->rubbing = 0.1 * normal * slip * slip / hypot(slip, 0.2);
        out->taken += out->rubbing;
    }
    add_drive(at, 400.0, 6500.0 * pi / 30.0, 2e-5, out);
    add_other_drive(at, -1.0, 300.0, 12000.0 * pi / 30.0, 4e-5, out);
}

static const char between_text[] =
    "whirl: 1\nrotor:\n  speed: 300 rad/s\n  length_scale: 0.1 mm\n"
    "  shafts: {lp: {}, hp: {speed: 400 rad/s}}\n"
    "  stations:\n"
    "    a: {shaft: lp, mass: 10 kg, eccentricity: 50 um}\n"
    "    b: {shaft: hp, mass: 6 kg, moves: x}\n"
    "  elements:\n"
    "    - spring: {between: [a, ground], stiffness: 1e6 N/m}\n"
    "    - spring: {between: [b, ground], stiffness: 8e5 N/m, along: x}\n"
    "    - film: {at: a, from: b, clearance: 0.4 mm, viscosity: 50 mPa.s, radius: 30 mm, length: 15 mm}\n"
    "    - unbalance: {at: b, moment: 3e-4 kg.m, angle: 70 deg}\n"
    "    - gravity: 9.81 m/s2\n"
    "    - drive: {inertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s, load_quadratic: 1e-6 N.m.s2}\n"
    "    - drive: {shaft: hp, inertia: 0.03 kg.m2, torque: 5 N.m, no_load_speed: 400 rad/s, load_quadratic: 1e-6 "
    "N.m.s2}\n"
    "study: {runup: {duration: 1 s, rtol: 1e-12, shafts: {hp: {}}}}\n";

/// Accounts for a film between two shafts: the sum of their speeds is the wedge, their difference the shear. The second
/// station moves along x alone.
static void film_between(const seen *at, account *out) {
    enum { A, B };
    seen apart = *at;
    apart.x[A] -= at->x[B];
    apart.vx[A] -= at->vx[B];
    seen other = *at;
    other.y[B] = other.vy[B] = 0.0;
    *out = (account){.energy = disc_energy(at, A, 10.0, 5e-4, 0.05, gravity) +
                               other_energy(&other, B, 6.0, 3e-4, 70.0 * pi / 180.0, 0.03) +
                               5e5 * square(at->x[A], at->y[A]) + 4e5 * square(at->x[B], 0.0)};
    // A station that moves along one axis has the whole of its unbalance's rotary energy about its axis there.
    apart.speed = at->speed + at->other_speed;
    out->taken += film_power_of(&apart, A, 0.4e-3, 0.03, 0.015, 0.05, at->speed - at->other_speed);
    add_drive(at, 6.0, 300.0, 1e-6, out);
    add_other_drive(at, 1.0, 5.0, 400.0, 1e-6, out);
}

// ---------------------------------------------------------------- unbalances of other shafts

/// An unbalance: its moment, kg m, the ratio of its speed to the shaft's, and its angle at the beginning.
typedef struct unbalance {
    double moment, ratio, angle;
} unbalance;

/// Accounts for the energy of a station of 3 kg on springs of 1e5 N/m and dampers of 50 N s/m that moves along x, along
/// y, or both ways, with unbalances of its own shaft and of others, and a drive with the inertia 0.05 about axes
/// through centres of mass.
static void station_account(const seen *at, const unbalance *of, size_t count, bool along_x, bool along_y,
                            account *out) {
    const double mass = 3.0, w = at->speed;
    const double x = along_x ? at->x[0] : 0.0, y = along_y ? at->y[0] : 0.0;
    const double vx = along_x ? at->vx[0] : 0.0, vy = along_y ? at->vy[0] : 0.0;
    double inertia = 0.05, c = 0.0, s = 0.0;
    *out = (account){.energy = 0.5 * mass * square(vx, vy) + 5e4 * square(x, y) + mass * gravity * y,
                     .taken = 50.0 * square(vx, vy)};
    // Unbalances that turn with the shaft have a common centre of mass, others have their own.
    for (size_t i = 0; i < count; i++) {
        const double phase = of[i].ratio * at->angle + of[i].angle, turned = of[i].moment * of[i].ratio;
        out->energy += turned * w * (vy * cos(phase) - vx * sin(phase)) + of[i].moment * gravity * sin(phase);
        if (of[i].ratio == 1.0) {
            c += of[i].moment * cos(of[i].angle);
            s += of[i].moment * sin(of[i].angle);
        } else {
            inertia += turned * turned / mass;
        }
    }
    inertia += square(c, s) / mass;
    out->energy += 0.5 * inertia * w * w;
    add_drive(at, 6.0, 300.0, 1e-6, out);
}

#define STATION(moves, elements, more)                                                                                 \
    "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 1 mm\n" more                                                \
    "  stations: {disc: {mass: 3 kg, damping: 50 N.s/m, moves: " moves "}}\n  elements:\n" elements                    \
    "    - gravity: 9.81 m/s2\n"                                                                                       \
    "    - drive: {inertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s, load_quadratic: 1e-6 N.m.s2}\n"       \
    "study: {runup: {duration: 1 s, rtol: 1e-12}}\n"
#define SPRING(along) "    - spring: {between: [disc, ground], stiffness: 1e5 N/m, along: " along "}\n"

static const char geared_text[] =
    STATION("xy",
            SPRING("xy") "    - unbalance: {at: disc, moment: 3e-3 kg.m, angle: 30 deg}\n"
                         "    - unbalance: {at: disc, moment: 1e-2 kg.m, angle: 70 deg, ratio: 0.37}\n"
                         "    - unbalance: {at: disc, moment: 2e-3 kg.m, ratio: -2.5}\n",
            "");
static void geared(const seen *at, account *out) {
    static const unbalance of[] = {{3e-3, 1.0, 30.0}, {1e-2, 0.37, 70.0}, {2e-3, -2.5, 0.0}};
    unbalance turned[COUNT_OF(of)];
    for (size_t i = 0; i < COUNT_OF(of); i++) {
        turned[i] = of[i];
        turned[i].angle *= pi / 180.0;
    }
    station_account(at, turned, COUNT_OF(of), true, true, out);
}

static const char along_x_text[] =
    STATION("x",
            SPRING("x") "    - unbalance: {at: disc, moment: 1.2e-2 kg.m, angle: 30 deg}\n"
                        "    - unbalance: {at: disc, moment: 4e-3 kg.m, ratio: 2.5}\n",
            "");
static const char along_y_text[] =
    STATION("y",
            SPRING("y") "    - unbalance: {at: disc, moment: 1.2e-2 kg.m, angle: 30 deg}\n"
                        "    - unbalance: {at: disc, moment: 4e-3 kg.m, ratio: 2.5}\n",
            "");
static const unbalance of_one_way[] = {{1.2e-2, 1.0, 0.52359877559829887}, {4e-3, 2.5, 0.0}};
static void along_x(const seen *at, account *out) {
    station_account(at, of_one_way, COUNT_OF(of_one_way), true, false, out);
}
static void along_y(const seen *at, account *out) {
    station_account(at, of_one_way, COUNT_OF(of_one_way), false, true, out);
}

// ---------------------------------------------------------------- the gallery

/// A run of a case of the gallery.
typedef struct run_of {
    const char *what, *file;
    const char *text;    ///< the case itself, where it is not a file
    size_t point;        ///< of the case
    bool rubs;           ///< a contact closes
    double length, from; ///< m, length scale; rad/s, speed at the beginning
    double seconds;      ///< its length
    double after;        ///< s after which blade and motor are lost; 0: never
    void (*find)(const seen *at, account *out);
} run_of;

static const run_of runs[] = {
    {"run-up with a rub", "rub-run-up", NULL, 0, true, 1e-4, 0.0, 4.0, 0.0, rub_run_up},
    {"motor that sticks at the critical speed", "sommerfeld", NULL, 0, false, 1e-3, 0.0, 30.0, 0.0, sommerfeld_weak},
    {"motor that passes it", "sommerfeld", NULL, 1, false, 1e-3, 0.0, 60.0, 0.0, sommerfeld_strong},
    {"start of a geared compressor", "motor-start", NULL, 0, false, 1e-3, 0.0, 2.0, 0.0, motor_start},
    {"fan in films, from rest", "run-up", NULL, 0, false, 1e-4, 0.0, 1.0, 0.0, fan},
    {"fan in films, blade loss, trip and rub", "run-up", NULL, 0, true, 1e-4, 560.0, 0.1, 0.02, fan},
    {"engine with two shafts", "engine-run-up", NULL, 0, false, 1e-4, 0.0, 2.0, 0.0, engine},
    {"engine with two shafts that rub", "engine-run-up", NULL, 0, true, 1e-4, 530.0, 0.2, 0.0, engine},
    {"film between two shafts", "", between_text, 0, false, 1e-4, 0.0, 1.0, 0.0, film_between},
    {"unbalances of other shafts", "", geared_text, 0, false, 1e-3, 0.0, 1.0, 0.0, geared},
    {"unbalances on a station that moves along x", "", along_x_text, 0, false, 1e-3, 0.0, 1.0, 0.0, along_x},
    {"unbalances on a station that moves along y", "", along_y_text, 0, false, 1e-3, 0.0, 1.0, 0.0, along_y}};

/// Checks that the study, which follows a run by the angle of the shaft, ends in the same state.
static void check_study(const run_of *run, const ledger *own, const double *x) {
    const whirl_system *inner = own->running->by_time;
    whirl_result *result = result_of_text(run->text);
    check_within("Run energy", words("%s, by the angle: speed", run->what),
                 x[inner->dimension - 3] * own->running->unit, first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 1e-6);
    for (size_t axis = 0; axis < 2; axis++)
        check_within("Run energy", words("%s, by the angle: place %zu, in length scales", run->what, axis),
                     whirl_probe_value(&inner->probes[0], x, axis),
                     first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, axis), 1e-6);
    whirl_result_free(result);
}

/// Checks the balance of a run, of which a share of the work and of the energy at its beginning may be missing.
static void check_balance(const run_of *run, double rtol) {
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_study study;
    double x[MAX_STATE] = {0.0};
    sums found = {.given = 0.0};
    // Open the machine at the speed of its beginning.
    if (run->text)
        object = case_of_text(run->text);
    else
        require_ok(whirl_case_load(words("%s/%s.yaml", WHIRL_CASES, run->file), &problems, &object));
    require_ok(whirl_case_study(object, &study));
    const whirl_batch *batch = &study.batches[0];
    const run_point at = {.study = &study, .value = batch->values ? batch->values[run->point] : NAN};
    ledger own = {.length = run->length, .find = run->find};
    ledger_open(&own, &at, x);
    x[own.running->by_time->dimension - 3] = run->from / own.running->unit;
    if (own.running->spool_count > 0) x[own.running->spool_state + 1] = 1.75 * run->from / own.running->unit;
    const double stored = fmax(ledger_account(&own, x).energy, 0.0);
    // Carry it, up to the loss of its blade and beyond.
    ledger_carry(&own, run->after > 0.0 ? run->after : run->seconds, rtol, x, &found);
    if (run->after > 0.0) {
        const whirl_placed lost = {1, 4e-3, 0.0};
        own.after = true;
        own.running->lose(own.running, 1, &lost);
        own.running->turn(own.running, &(whirl_turning){.driven = true, .tripped = true, .lost = true});
        ledger_carry(&own, run->seconds - run->after, rtol, x, &found);
    }
    check_within("Run energy", words("%s, rtol %g: share missing", run->what, rtol), 0.0,
                 found.missing / (found.given + stored), 1e-2 * rtol + 1e-12);
    if (run->text) check_study(run, &own, x);
    if (run->rubs) check_holds("Run energy", words("%s: friction takes power", run->what), found.rubbing > 1.0);
    own.running->release(own.running);
    whirl_case_free(object);
    whirl_problems_free(&problems);
}

/// Returns true if the study of a case runs up.
static bool runs_up(const char *file) {
    char line[256];
    bool found = false;
    FILE *from = fopen(words("%s/%s", WHIRL_CASES, file), "r");
    assert_non_null(from);
    while (!found && fgets(line, sizeof line, from)) found = strncmp(line, "  runup:", 8) == 0;
    fclose(from);
    return found;
}

/// Every case of the gallery that runs up is in the list.
static void whole_gallery(void **state) {
    size_t count = 0;
    DIR *folder = opendir(WHIRL_CASES);
    (void)state;
    assert_non_null(folder);
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        const char *end = strstr(entry->d_name, ".yaml");
        size_t i = 0;
        if (!end || !runs_up(entry->d_name)) continue;
        const size_t length = (size_t)(end - entry->d_name);
        while (i < COUNT_OF(runs) && strncmp(runs[i].file, entry->d_name, length) != 0) i++;
        check_holds("Run energy", words("%s has a balance", entry->d_name), i < COUNT_OF(runs));
        count++;
    }
    check_holds("Run energy", "the gallery has four cases at least", count >= 4);
    closedir(folder);
}

static void balance_of_energy(void **state) {
    (void)state;
    fill_half_turn();
    for (size_t i = 0; i < COUNT_OF(runs); i++) {
        check_balance(&runs[i], 1e-7);
        check_balance(&runs[i], 1e-10);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole_gallery), cmocka_unit_test(balance_of_energy)};
    return cmocka_run_group_tests_name("energy of runs", tests, NULL, NULL);
}
