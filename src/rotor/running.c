// Machines whose speed changes: the numbers of a rotor as functions of its speed, and the equation of its shaft.
#include "whirl/engine/running.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "machine.h"

/// Powers of the speed that numbers are sums of, from -2 on.
enum { POWERS = 5, LOWEST_POWER = -2 };

/// Speeds at which machines are made: those that powers are found from, and at once checked at.
enum { POWER_SPEEDS = 11 };

/// Speeds of the nodes of splines, and of the checks between them.
enum { SPLINE_NODES = 33, SPLINE_SPEEDS = 2 * SPLINE_NODES - 1, SPLINE_NUMBERS = 2 * SPLINE_NODES };

/// Numbers count as a sum of powers where they are one to this share of their largest value.
static const double power_error = 2e-12;

/// The least speed, over the unit, that numbers are taken at: laws divide by the speed, and slower shafts stand.
static const double slowest = 1e-6;

/// A number that changes with the speed w: sum of power[k] w^(k - 2), or of splines of it times w^2.
typedef struct number_of_speed {
    size_t index;
    double power[POWERS];
    double *value, *curvature; ///< [SPLINE_NODES] of w^2 times the number, NULL: powers hold
} number_of_speed;

/// A running rotor.
typedef struct runner {
    whirl_running shown;   ///< first, so that it is this
    whirl_machine machine; ///< at the unit of speed, whose structure all have
    const whirl_rotor *rotor;
    double unit;
    whirl_turning how;
    double *numbers; ///< [number_count] at the speed *at, workspace
    double *at;
    size_t varying_count;
    number_of_speed *varying;
    double *splines; ///< all of them
    double lowest_node, node_distance;
    /// [degrees] of unbalances that turn: accelerations by C and S at a speed of 1 unit, and forces, kg or kg m2 of a
    /// unit of the coordinate; of those that are lost the same.
    double *own_cos, *own_sin, *force_cos, *force_sin;
    double *lost_cos, *lost_sin, *lost_force_cos, *lost_force_sin;
    double *block;         ///< these
    double *place, *slope; ///< [dimension] workspace
    double *friction;      ///< [contact_count][3] workspace
    whirl_system by_angle, by_time;
    double from; ///< where the part of a revolution begins
} runner;

// ---------------------------------------------------------------- numbers over the speed

/// Solves for the powers `of` [count] that give y [count] at w [count]; powers of one another are far enough apart.
static void fit_powers(size_t count, const int *of, const double *w, const double *y, double *out) {
    double a[POWERS][POWERS + 1];
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < count; j++) a[i][j] = pow(w[i], of[j]);
        a[i][count] = y[i];
    }
    for (size_t k = 0; k < count; k++) {
        size_t best = k;
        for (size_t i = k + 1; i < count; i++)
            if (fabs(a[i][k]) > fabs(a[best][k])) best = i;
        for (size_t j = 0; j <= count; j++) {
            const double swapped = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = swapped;
        }
        for (size_t i = k + 1; i < count; i++)
            for (size_t j = count + 1; j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    }
    for (size_t k = count; k-- > 0;) {
        out[k] = a[k][count];
        for (size_t j = k + 1; j < count; j++) out[k] -= a[k][j] * out[j];
        out[k] /= a[k][k];
    }
}

/// Finds the fewest powers whose sum the number is, at all of w [POWER_SPEEDS]. False where it is none.
static bool find_powers(const double *w, const double *y, double power[POWERS]) {
    double largest = 0.0;
    for (size_t i = 0; i < POWER_SPEEDS; i++) largest = fmax(largest, fabs(y[i]));
    for (size_t count = 1; count <= POWERS; count++)
        for (unsigned set = 1; set < 1u << POWERS; set++) {
            int of[POWERS];
            double found[POWERS], at[POWERS], value[POWERS];
            size_t size = 0;
            bool holds = true;
            for (int k = 0; k < POWERS; k++)
                if (set >> k & 1) of[size++] = k + LOWEST_POWER;
            if (size != count) continue;
            // Every second speed or so, over all of the range.
            for (size_t i = 0; i < count; i++) {
                const size_t pick = count == 1 ? 0 : i * (POWER_SPEEDS - 1) / (count - 1);
                at[i] = w[pick];
                value[i] = y[pick];
            }
            fit_powers(count, of, at, value, found);
            for (size_t i = 0; i < POWER_SPEEDS && holds; i++) {
                double sum = 0.0;
                for (size_t j = 0; j < count; j++) sum += found[j] * pow(w[i], of[j]);
                holds = fabs(sum - y[i]) <= power_error * largest;
            }
            if (!holds) continue;
            memset(power, 0, POWERS * sizeof *power);
            for (size_t j = 0; j < count; j++) power[of[j] - LOWEST_POWER] = found[j];
            return true;
        }
    return false;
}

/// Second derivatives of the cubic spline through y at equal distances h, with parabolas at its ends.
static void bend(double h, const double *y, double *curvature) {
    double diagonal[SPLINE_NODES], right[SPLINE_NODES];
    const size_t last = SPLINE_NODES - 1;
    for (size_t i = 1; i < last; i++) {
        diagonal[i] = i == 1 || i + 1 == last ? 5.0 : 4.0;
        right[i] = 6.0 * (y[i - 1] - 2.0 * y[i] + y[i + 1]) / (h * h);
    }
    for (size_t i = 2; i < last; i++) {
        const double share = 1.0 / diagonal[i - 1];
        diagonal[i] -= share;
        right[i] -= share * right[i - 1];
    }
    curvature[last - 1] = right[last - 1] / diagonal[last - 1];
    for (size_t i = last - 1; i-- > 1;) curvature[i] = (right[i] - curvature[i + 1]) / diagonal[i];
    curvature[0] = curvature[1];
    curvature[last] = curvature[last - 1];
}

static double spline_at(const runner *r, const number_of_speed *of, double w) {
    const double place = (w - r->lowest_node) / r->node_distance;
    const double bounded = fmin(fmax(place, 0.0), SPLINE_NODES - 1.0);
    const size_t i = bounded >= SPLINE_NODES - 1 ? SPLINE_NODES - 2 : (size_t)bounded;
    const double b = bounded - (double)i, a = 1.0 - b, h = r->node_distance;
    return a * of->value[i] + b * of->value[i + 1] +
           ((a * a * a - a) * of->curvature[i] + (b * b * b - b) * of->curvature[i + 1]) * h * h / 6.0;
}

static double number_at(const runner *r, const number_of_speed *of, double w) {
    const double *c = of->power;
    if (of->value) return spline_at(r, of, w) / (w * w);
    return ((c[0] / w + c[1]) / w + c[2]) + w * (c[3] + w * c[4]);
}

/// Brings the numbers, which are workspace, to a speed.
static double *numbers_at(const runner *r, double w) {
    const double bounded = fmax(w, slowest);
    for (size_t i = 0; i < r->varying_count && bounded != *r->at; i++)
        r->numbers[r->varying[i].index] = number_at(r, &r->varying[i], bounded);
    *r->at = bounded;
    return r->numbers;
}

static whirl_status check_machine(const runner *r, const whirl_machine *machine) {
    const whirl_rotor *rotor = rotor_of_system(machine->system);
    if (!rotor)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine is no rotor, expected stations and elements, whose shaft turns");
    if (rotor->phase)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "sections of the machine are taken by the %s, expected those of its shaft (keyphasor: no)",
                          rotor->keyphasor);
    if (machine->system->frequency_count > 0)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "a bearing has coefficients over frequencies of whirl, expected a machine that moves in time");
    if (r->rotor && !r->rotor->lanes.alike(r->rotor, rotor))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the machine has other parts at %.6g rad/s than at %.6g rad/s, expected the same at all "
                          "speeds of its run",
                          rotor->speed, r->rotor->speed);
    return whirl_ok();
}

/// Writes the numbers of the machine at speeds w [count], over the unit: out [count][number_count].
static whirl_status sample(const runner *r, whirl_machine_at *make, const void *context, size_t count, const double *w,
                           double *out) {
    const size_t numbers = r->rotor->lanes.number_count;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        whirl_machine machine = {.system = NULL};
        status = make(context, w[i] * r->unit, &machine);
        if (status.code != WHIRL_OK) return status;
        status = check_machine(r, &machine);
        if (status.code == WHIRL_OK)
            memcpy(out + i * numbers, rotor_of_system(machine.system)->numbers, numbers * sizeof *out);
        if (machine.release) machine.release(machine.owner);
    }
    return status;
}

/// Those that are no sums of powers, as splines: y [SPLINE_SPEEDS][number_count].
static void fit_splines(runner *r, const double *w, const double *y) {
    const size_t numbers = r->rotor->lanes.number_count;
    double *next = r->splines;
    for (size_t v = 0; v < r->varying_count; v++) {
        number_of_speed *own = &r->varying[v];
        double largest = 0.0;
        if (!own->value) continue;
        own->value = next;
        own->curvature = next + SPLINE_NODES;
        next += SPLINE_NUMBERS;
        for (size_t i = 0; i < SPLINE_NODES; i++) own->value[i] = w[2 * i] * w[2 * i] * y[2 * i * numbers + own->index];
        bend(r->node_distance, own->value, own->curvature);
        for (size_t i = 0; i < SPLINE_SPEEDS; i++)
            largest = fmax(largest, fabs(w[i] * w[i] * y[i * numbers + own->index]));
        for (size_t i = 1; i < SPLINE_SPEEDS; i += 2) {
            const double miss = spline_at(r, own, w[i]) - w[i] * w[i] * y[i * numbers + own->index];
            r->shown.error = fmax(r->shown.error, fabs(miss) / largest);
        }
    }
}

static whirl_status add_splines(runner *r, whirl_machine_at *make, const void *context, size_t count) {
    const size_t numbers = r->rotor->lanes.number_count;
    double w[SPLINE_SPEEDS], *y = malloc(SPLINE_SPEEDS * numbers * sizeof *y);
    r->splines = malloc(SPLINE_NUMBERS * count * sizeof *r->splines);
    r->node_distance = (1.0 - r->lowest_node) / (SPLINE_NODES - 1);
    for (size_t i = 0; i < SPLINE_SPEEDS; i++) w[i] = r->lowest_node + 0.5 * (double)i * r->node_distance;
    whirl_status status =
        y && r->splines ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speed");
    if (status.code == WHIRL_OK) status = sample(r, make, context, SPLINE_SPEEDS, w, y);
    if (status.code == WHIRL_OK) fit_splines(r, w, y);
    free(y);
    return status;
}

static whirl_status find_numbers(runner *r, whirl_machine_at *make, const void *context) {
    static const double share[POWER_SPEEDS] = {1.0, 0.91, 0.78, 0.65, 0.55, 0.42, 0.33, 0.24, 0.15, 0.08, 0.0};
    const double low = fmax(r->lowest_node, 0.17); // powers hold below it, too
    double w[POWER_SPEEDS];
    const size_t numbers = r->rotor->lanes.number_count;
    double *y = malloc((POWER_SPEEDS * numbers + 1) * sizeof *y);
    size_t splines = 0;
    for (size_t i = 0; i < POWER_SPEEDS; i++) w[i] = low + share[i] * (1.0 - low);
    r->numbers = calloc(numbers + 1, sizeof *r->numbers);
    r->at = r->numbers ? r->numbers + numbers : NULL;
    r->varying = calloc(numbers + 1, sizeof *r->varying);
    whirl_status status = y && r->numbers && r->varying
                              ? whirl_ok()
                              : whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speed");
    if (status.code == WHIRL_OK) status = sample(r, make, context, POWER_SPEEDS, w, y);
    if (status.code == WHIRL_OK) memcpy(r->numbers, r->rotor->numbers, numbers * sizeof *r->numbers);
    for (size_t n = 0; n < numbers && status.code == WHIRL_OK; n++) {
        number_of_speed own = {.index = n};
        double values[POWER_SPEEDS];
        bool varies = false;
        for (size_t i = 0; i < POWER_SPEEDS; i++) {
            values[i] = y[i * numbers + n];
            varies = varies || values[i] != values[0];
        }
        if (!varies) continue;
        if (!find_powers(w, values, own.power)) {
            own.value = r->numbers; // says that there is one, until it is made
            splines++;
        }
        r->varying[r->varying_count++] = own;
    }
    if (status.code == WHIRL_OK && splines > 0) status = add_splines(r, make, context, splines);
    free(y);
    return status;
}

// ---------------------------------------------------------------- what turns with the shaft

/// Accelerations of forces on coordinates, in place: where masses couple, by all of them.
static void accelerate(const whirl_rotor *rotor, const double *force, double *out) {
    const coupling *by = &rotor->coupled;
    const size_t degrees = rotor->lanes.degrees;
    for (size_t d = 0; d < degrees; d++) out[d] = force[d] / (rotor->inertia[d] * rotor->unit[d]);
    if (by->count == 0) return;
    for (size_t i = 0; i < degrees; i++) {
        double sum = 0.0;
        if (by->place[i] == NO_COORDINATE) continue;
        for (size_t j = 0; j < by->count; j++)
            sum += by->share[by->place[i] * by->count + j] * force[by->row[j]] /
                   (rotor->inertia[by->row[j]] * rotor->unit[by->row[j]]);
        out[i] = sum;
    }
}

static whirl_status add_turnings(runner *r) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees, d = rotor->system.dimension;
    r->block = calloc(8 * n + 2 * (d + 2) + 3 * rotor->contact_count + 1, sizeof *r->block);
    if (!r->block) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine whose speed changes");
    double **const parts[] = {&r->own_cos,  &r->own_sin,  &r->force_cos,      &r->force_sin,
                              &r->lost_cos, &r->lost_sin, &r->lost_force_cos, &r->lost_force_sin};
    for (size_t i = 0; i < 8; i++) *parts[i] = r->block + i * n;
    r->place = r->block + 8 * n;
    r->slope = r->place + d + 2;
    r->friction = r->slope + d + 2;
    for (size_t i = 0; i < rotor->turning_count; i++) {
        r->force_cos[rotor->turnings[i].row] += rotor->turnings[i].cos;
        r->force_sin[rotor->turnings[i].row] += rotor->turnings[i].sin;
    }
    accelerate(rotor, r->force_cos, r->own_cos);
    accelerate(rotor, r->force_sin, r->own_sin);
    return whirl_ok();
}

/// Returns true if a station moves along x (way: 0) or y (1).
static bool probe_moves(const whirl_probe *probe, size_t way) {
    return probe->x != probe->y || (way == 1) == probe->along_y;
}

static void running_lose(whirl_running *running, size_t count, const whirl_placed *placed) {
    runner *r = (runner *)running;
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    memset(r->lost_force_cos, 0, n * sizeof *r->lost_force_cos);
    memset(r->lost_force_sin, 0, n * sizeof *r->lost_force_sin);
    for (size_t i = 0; i < count; i++) {
        const whirl_probe *probe = &rotor->probes[placed[i].station];
        const double c = placed[i].moment * cos(placed[i].angle), s = placed[i].moment * sin(placed[i].angle);
        if (probe_moves(probe, 0)) {
            r->lost_force_cos[probe->x] += c;
            r->lost_force_sin[probe->x] -= s;
        }
        if (probe_moves(probe, 1)) {
            r->lost_force_cos[probe->y] += s;
            r->lost_force_sin[probe->y] += c;
        }
    }
    accelerate(rotor, r->lost_force_cos, r->lost_cos);
    accelerate(rotor, r->lost_force_sin, r->lost_sin);
}

// ---------------------------------------------------------------- the equation of the shaft

/// What turns the shaft: the motor and its load, without what the rotor does.
static void drive_at(const runner *r, double w, whirl_torques *out) {
    const shaft_drive *drive = &r->rotor->drive;
    const double speed = w * r->unit;
    out->motor = r->how.tripped ? 0.0 : drive_torque(drive, speed);
    out->load = -drive_load(drive, speed);
}

static double friction_at(const runner *r, const double *x, const double *numbers) {
    const size_t contacts = r->rotor->contact_count;
    double torque = 0.0;
    if (contacts == 0) return torque;
    rotor_contacts_with(r->rotor, numbers, x, r->friction, r->friction + contacts);
    for (size_t c = 0; c < contacts; c++) {
        const double own = r->friction[contacts + 2 * c];
        if (isfinite(own)) torque -= own;
    }
    return torque;
}

/// Force and acceleration of coordinate i by a unit of theta'', with the values of time C and S.
typedef struct lever {
    double force, acceleration;
} lever;

static lever lever_of(const runner *r, size_t i, double way, const double *forcing) {
    const double c = forcing[COS_TAU], s = forcing[SIN_TAU];
    lever own = {way * (r->force_cos[i] * s - r->force_sin[i] * c), way * (r->own_cos[i] * s - r->own_sin[i] * c)};
    if (r->how.lost) {
        own.force += way * (r->lost_force_cos[i] * s - r->lost_force_sin[i] * c);
        own.acceleration += way * (r->lost_cos[i] * s - r->lost_sin[i] * c);
    }
    return own;
}

/// theta'' over the square of the unit of speed, at the speed `exact`, w where numbers are taken. a [degrees]:
/// accelerations by the angle without it.
static double turn(const runner *r, double exact, double w, const double *forcing, const double *numbers,
                   const double *x, const double *a, whirl_torques *torques) {
    const whirl_rotor *rotor = r->rotor;
    const double square = r->unit * r->unit;
    if (!r->how.driven) return r->how.rate / square;
    double reaction = 0.0, inertia = rotor->drive.inertia, own_mass = 0.0;
    for (size_t i = 0; i < rotor->lanes.degrees; i++) {
        const lever u = lever_of(r, i, rotor->way, forcing);
        if (u.force == 0.0) continue;
        reaction += u.force * rotor->unit[i] * w * w * a[i];
        inertia -= u.force * rotor->unit[i] * u.acceleration;
        own_mass += u.force * u.force / rotor->inertia[i];
    }
    inertia += own_mass;
    for (size_t p = 0; p < rotor->station_count; p++) {
        const whirl_probe *probe = &rotor->probes[p];
        if (probe_moves(probe, 0))
            reaction -= lever_of(r, probe->x, rotor->way, forcing).force * rotor->pull[0] / square;
        if (probe_moves(probe, 1))
            reaction -= lever_of(r, probe->y, rotor->way, forcing).force * rotor->pull[1] / square;
    }
    drive_at(r, exact, torques);
    torques->friction = friction_at(r, x, numbers);
    torques->rotor = reaction * square;
    return ((torques->motor + torques->load + torques->friction) / square + reaction) / inertia;
}

/// Slopes of the rotor by the angle at a speed that is held, x by the angle: dxdt [dimension of the rotor].
static const double *flow(const runner *r, double w, const double *forcing, const double *sides, const double *x,
                          double *dxdt) {
    const double *numbers = numbers_at(r, w);
    const size_t n = r->rotor->lanes.degrees;
    rotor_flow_with(r->rotor, numbers, forcing, sides, x, dxdt);
    for (size_t i = 0; i < n && r->how.lost; i++)
        dxdt[n + i] += r->lost_cos[i] * forcing[COS_TAU] + r->lost_sin[i] * forcing[SIN_TAU];
    return numbers;
}

static void rhs_by_angle(const void *model, double t, const double *given, const double *x, const double *sides,
                         double *dxdt) {
    const runner *r = model;
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees, d = rotor->system.dimension;
    const double w = x[d], angle = r->from + t;
    double forcing[FORCING_COUNT];
    whirl_torques torques;
    (void)given;
    rotor->system.forcing(rotor, angle, forcing);
    const double *numbers = flow(r, w, forcing, sides, x, dxdt);
    const double faster = turn(r, w, w, forcing, numbers, x, dxdt + n, &torques), share = faster / (w * w);
    for (size_t i = 0; i < n; i++) dxdt[n + i] += share * (lever_of(r, i, rotor->way, forcing).acceleration - x[n + i]);
    dxdt[d] = faster / w;
    dxdt[d + 1] = 1.0 / w;
}

static void scale_to_angle(const runner *r, double *x) {
    const size_t n = r->rotor->lanes.degrees;
    const double w = fmax(x[r->rotor->system.dimension], slowest);
    for (size_t i = n; i < 2 * n; i++) x[i] /= w;
}

/// A state by time as one by the angle, in the workspace.
static const double *placed_by_angle(const runner *r, const double *x) {
    memcpy(r->place, x, (r->rotor->system.dimension + 2) * sizeof *r->place);
    scale_to_angle(r, r->place);
    return r->place;
}

static void rhs_by_time(const void *model, double t, const double *given, const double *x, const double *sides,
                        double *dxdt) {
    const runner *r = model;
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees, d = rotor->system.dimension;
    const double w = fmax(x[d], slowest);
    double forcing[FORCING_COUNT];
    whirl_torques torques;
    (void)given, (void)t;
    rotor->system.forcing(rotor, x[d + 1], forcing);
    const double *place = placed_by_angle(r, x);
    const double *numbers = flow(r, w, forcing, sides, place, dxdt);
    const double faster = turn(r, x[d], w, forcing, numbers, place, dxdt + n, &torques);
    for (size_t i = 0; i < n; i++) {
        dxdt[i] = x[n + i];
        dxdt[n + i] = w * w * dxdt[n + i] + faster * lever_of(r, i, rotor->way, forcing).acceleration;
    }
    for (size_t i = 2 * n; i < d; i++) dxdt[i] *= w;
    dxdt[d] = faster;
    dxdt[d + 1] = x[d];
}

static void free_by_angle(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    rhs_by_angle(model, t, forcing, x, NULL, dxdt);
}

static void free_by_time(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    rhs_by_time(model, t, forcing, x, NULL, dxdt);
}

// ---------------------------------------------------------------- switches

static void switches_by_angle(const void *model, double t, const double *x, double *values) {
    const runner *r = model;
    (void)t;
    rotor_switches_with(r->rotor, numbers_at(r, x[r->rotor->system.dimension]), x, values);
}

static void switches_by_time(const void *model, double t, const double *x, double *values) {
    const runner *r = model;
    switches_by_angle(r, t, placed_by_angle(r, x), values);
}

/// By the speed, too: a quotient of differences, since switches go with it by numbers.
static void gradient_at(const runner *r, const double *x, size_t index, double *gradient) {
    const size_t d = r->rotor->system.dimension;
    const double w = x[d], step = 1e-6 * fmax(w, slowest);
    double values[2][WHIRL_MAX_SWITCHES];
    rotor_gradient_with(r->rotor, numbers_at(r, w), x, index, gradient);
    rotor_switches_with(r->rotor, numbers_at(r, w + step), x, values[0]);
    rotor_switches_with(r->rotor, numbers_at(r, w - step), x, values[1]);
    gradient[d] = (values[0][index] - values[1][index]) / (2.0 * step);
    gradient[d + 1] = 0.0;
}

static void gradient_by_angle(const void *model, double t, const double *x, size_t index, double *gradient,
                              double *by_time) {
    (void)t;
    *by_time = 0.0;
    gradient_at(model, x, index, gradient);
}

static void gradient_by_time(const void *model, double t, const double *x, size_t index, double *gradient,
                             double *by_time) {
    const runner *r = model;
    const size_t n = r->rotor->lanes.degrees, d = r->rotor->system.dimension;
    const double w = fmax(x[d], slowest);
    (void)t;
    *by_time = 0.0;
    gradient_at(r, placed_by_angle(r, x), index, gradient);
    for (size_t i = n; i < 2 * n; i++) {
        gradient[d] -= gradient[i] * x[i] / (w * w);
        gradient[i] /= w;
    }
}

static bool touches(const void *model, size_t index) {
    const runner *r = model;
    return r->rotor->system.switch_touches(r->rotor, index);
}

// ---------------------------------------------------------------- the machine

static void fill_systems(runner *r) {
    const whirl_system *own = &r->rotor->system;
    whirl_system both = {.dimension = own->dimension + 2,
                         .period = own->period,
                         .kinked = own->kinked,
                         .switch_count = own->switch_count,
                         .switch_touches = own->switch_count > 0 ? touches : NULL,
                         .probe_count = own->probe_count,
                         .probes = own->probes,
                         .model = r};
    r->by_angle = r->by_time = both;
    r->by_angle.rhs = free_by_angle;
    r->by_angle.rhs_on_sides = rhs_by_angle;
    r->by_angle.switches = switches_by_angle;
    r->by_angle.switch_gradient = gradient_by_angle;
    r->by_time.rhs = free_by_time;
    r->by_time.rhs_on_sides = rhs_by_time;
    r->by_time.switches = switches_by_time;
    r->by_time.switch_gradient = gradient_by_time;
}

static void running_turn(whirl_running *running, const whirl_turning *how) {
    ((runner *)running)->how = *how;
}

static void running_part(whirl_running *running, double from, double length) {
    runner *r = (runner *)running;
    r->from = from;
    r->by_angle.period = r->by_time.period = length;
}

static void running_to_angle(const whirl_running *running, double *x) {
    scale_to_angle((const runner *)running, x);
}

static void running_torques(const whirl_running *running, const double *x, double angle, whirl_torques *out) {
    const runner *r = (const runner *)running;
    const double w = x[r->rotor->system.dimension], bounded = fmax(w, slowest);
    double forcing[FORCING_COUNT];
    *out = (whirl_torques){.motor = 0.0};
    r->rotor->system.forcing(r->rotor, angle, forcing);
    const double *numbers = flow(r, bounded, forcing, NULL, x, r->slope);
    out->acceleration =
        r->unit * r->unit * turn(r, w, bounded, forcing, numbers, x, r->slope + r->rotor->lanes.degrees, out);
}

static size_t running_switch(const whirl_running *running, size_t contact) {
    const whirl_rotor *rotor = ((const runner *)running)->rotor;
    return rotor->elements[rotor->contacts[contact]].first_switch;
}

static void running_contacts(const whirl_running *running, const double *x, double *normal_force) {
    const runner *r = (const runner *)running;
    if (r->rotor->contact_count == 0) return;
    rotor_contacts_with(r->rotor, numbers_at(r, x[r->rotor->system.dimension]), x, normal_force, NULL);
}

static void running_release(whirl_running *running) {
    runner *r = (runner *)running;
    if (r->machine.release) r->machine.release(r->machine.owner);
    free(r->numbers);
    free(r->varying);
    free(r->splines);
    free(r->block);
    free(r);
}

whirl_status whirl_running_new(whirl_machine_at *make, const void *context, double lowest, double highest,
                               whirl_running **out) {
    runner *r = calloc(1, sizeof *r);
    *out = NULL;
    if (!r) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine whose speed changes");
    r->unit = highest;
    r->lowest_node = fmin(fmax(lowest / highest, 1.0 / 256.0), 0.999);
    whirl_status status = make(context, highest, &r->machine);
    if (status.code == WHIRL_OK) status = check_machine(r, &r->machine);
    if (status.code == WHIRL_OK) {
        r->rotor = rotor_of_system(r->machine.system);
        status = find_numbers(r, make, context);
    }
    if (status.code == WHIRL_OK) status = add_turnings(r);
    if (status.code != WHIRL_OK) {
        running_release(&r->shown);
        return status;
    }
    fill_systems(r);
    r->shown.by_angle = &r->by_angle;
    r->shown.by_time = &r->by_time;
    r->shown.unit = highest;
    r->shown.contact_count = r->rotor->contact_count;
    r->shown.turn = running_turn;
    r->shown.lose = running_lose;
    r->shown.part = running_part;
    r->shown.to_angle = running_to_angle;
    r->shown.torques = running_torques;
    r->shown.contacts = running_contacts;
    r->shown.contact_switch = running_switch;
    r->shown.release = running_release;
    *out = &r->shown;
    return whirl_ok();
}
