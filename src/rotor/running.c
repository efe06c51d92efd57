// Machines whose speed changes: the numbers of a rotor as functions of the speed, and the equation of its shaft.
#include "whirl/engine/running.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "running_rotor.h"
#include "table.h"

/// Speed, divided by the unit, below which the dry friction of a load falls to 0 in proportion to the speed, for
/// machines that may stand while torques pulsate.
static const double slipping = 1e-4;

// ---------------------------------------------------------------- numbers over the speed

/// Evaluates the numbers at a speed, in workspace. x: a state with the speeds of shafts that have their own, or NULL
/// for the highest ones.
static double *running_numbers_at(const running_rotor *r, double w, const double *x) {
    const double bounded = fmax(w, slowest);
    double spools[WHIRL_MAX_SPOOLS];
    bool moved = bounded != *r->at;
    for (size_t i = 0; i < r->varying_count && bounded != *r->at; i++)
        r->numbers[r->varying[i].index] = running_number_at(&r->varying[i], r->lowest_node, r->node_distance, bounded);
    *r->at = bounded;
    for (size_t k = 0; k < r->spool_count; k++) {
        spools[k] = fmax(x ? x[r->at_spool + 2 * k + 1] : r->spools[k].highest, slowest);
        moved = moved || spools[k] != r->spool_at[k];
    }
    if (r->spool_count > 0 && moved) running_put_spooled(r, bounded, spools);
    return r->numbers;
}

/// Fits splines to the numbers that are not sums of powers, from y [SPLINE_SPEEDS][number_count]. Notes the largest
/// error half way between nodes.
static void running_fit_splines(running_rotor *r, const double *w, const double *y) {
    double *next = r->splines;
    for (size_t v = 0; v < r->varying_count; v++)
        if (r->varying[v].value) {
            const double error = running_fit_spline(&r->varying[v], r->lowest_node, r->node_distance, w, y,
                                                    r->rotor->lanes.number_count, 1.0, &next);
            r->shown.error = fmax(r->shown.error, error);
        }
}

static whirl_status running_add_splines(running_rotor *r, whirl_machine_at *make, const void *context, size_t count) {
    const size_t numbers = r->rotor->lanes.number_count;
    double w[SPLINE_SPEEDS], *y = malloc(SPLINE_SPEEDS * numbers * sizeof *y);
    r->splines = malloc(SPLINE_NUMBERS * count * sizeof *r->splines);
    r->node_distance = (1.0 - r->lowest_node) / (SPLINE_NODES - 1);
    for (size_t i = 0; i < SPLINE_SPEEDS; i++) w[i] = r->lowest_node + 0.5 * (double)i * r->node_distance;
    whirl_status status =
        y && r->splines ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speed");
    if (status.code == WHIRL_OK) status = running_sample(r, make, context, SPLINE_SPEEDS, w, NULL, y);
    if (status.code == WHIRL_OK) running_fit_splines(r, w, y);
    free(y);
    return status;
}

static whirl_status running_find_numbers(running_rotor *r, whirl_machine_at *make, const void *context) {
    double w[POWER_SPEEDS];
    const size_t numbers = r->rotor->lanes.number_count;
    double *y = malloc((POWER_SPEEDS * numbers + 1) * sizeof *y);
    size_t splines = 0;
    // Compute the numbers of the machine at a few speeds.
    running_sample_speeds(r->lowest_node, 1.0, w);
    r->numbers = calloc(numbers + 1, sizeof *r->numbers);
    r->at = r->numbers ? r->numbers + numbers : NULL;
    r->varying = calloc(numbers + 1, sizeof *r->varying);
    whirl_status status = y && r->numbers && r->varying
                              ? whirl_ok()
                              : whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speed");
    if (status.code == WHIRL_OK) { // the first speed is that of the existing machine
        memcpy(r->numbers, r->rotor->numbers, numbers * sizeof *r->numbers);
        memcpy(y, r->rotor->numbers, numbers * sizeof *y);
        status = running_sample(r, make, context, POWER_SPEEDS - 1, w + 1, NULL, y + numbers);
    }
    // Represent each number that varies by a sum of powers, or else by a spline.
    for (size_t n = 0; n < numbers && status.code == WHIRL_OK; n++) {
        number_of_speed own = {.index = n};
        double values[POWER_SPEEDS];
        bool varies = false;
        for (size_t i = 0; i < POWER_SPEEDS; i++) {
            values[i] = y[i * numbers + n];
            varies = varies || values[i] != values[0];
        }
        if (!varies) continue;
        if (!running_find_powers(POWER_SPEEDS, w, values, own.power)) {
            own.value = r->numbers; // not NULL: running_fit_splines replaces it
            splines++;
        }
        r->varying[r->varying_count++] = own;
    }
    // Numbers that other shafts give need no representation over the rotor's speed alone.
    if (status.code == WHIRL_OK && r->spool_count > 0) status = running_find_spooled(r, make, context, w, y, &splines);
    if (status.code == WHIRL_OK && splines > 0) status = running_add_splines(r, make, context, splines);
    free(y);
    return status;
}

// ---------------------------------------------------------------- what turns with the shaft

/// Counts the unbalances that turn at fixed ratios of the speed, and sums their effect on the inertia of the shaft: m
/// (U/m)^2 for an unbalance U at a station of mass m, times the square of the ratio.
static void running_count_geared(running_rotor *r) {
    const whirl_rotor *rotor = r->rotor;
    running_numbers_at(r, 1.0, NULL);
    for (size_t i = 0; i < rotor->element_count; i++) {
        const double start[MAX_ELEMENT_STATES] = {0.0};
        const size_t *port = rotor->elements[i].port;
        double lever[2];
        const double moment = running_geared_lever(r, i, 1.0, start, lever);
        if (moment == 0.0) continue;
        const size_t at = port[0] != NO_COORDINATE ? port[0] : port[1];
        if (at == NO_COORDINATE) continue;
        r->geared_count++;
        r->geared_inertia += moment * moment / rotor->inertia[at];
    }
}

/// Returns the part of the inertia about the shaft's axis that is due to unbalances, those of `lose` included, kg m2:
/// the sum over the stations of the square of the unbalance divided by the mass.
static double running_unbalance_inertia(const running_rotor *r) {
    double sum = 0.0;
    for (size_t i = 0; i < r->rotor->lanes.degrees; i++) {
        const double c = r->force_cos[i] + r->lost_force_cos[i], s = r->force_sin[i] + r->lost_force_sin[i];
        sum += r->alone[i] * (c * c + s * s) / r->rotor->inertia[i];
    }
    return sum;
}

static void running_lose(whirl_running *running, size_t count, const whirl_placed *placed);

/// Adds the forces of unbalances that have appeared on shafts with a speed of their own in a state x by the angle to
/// the accelerations a [degrees] at the speed w, and their levers.
static void running_add_lost_spools(const running_rotor *r, double w, const double *x, double *a) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    for (size_t i = 0; i < r->lost_spool_count; i++) {
        const whirl_placed *placed = &r->lost_spools[i];
        const whirl_probe *probe = &rotor->probes[placed->station];
        const size_t k = rotor->spool_of[placed->station] - 1;
        running_spool *own = &r->spools[k];
        const double sense = rotor->way * own->sense, angle = placed->angle + sense * x[r->at_spool + 2 * k];
        const double share = x[r->at_spool + 2 * k + 1] / w, c = cos(angle), s = sin(angle);
        const double force[2] = {placed->moment * c, placed->moment * s};
        const double lever[2] = {sense * placed->moment * s, -sense * placed->moment * c};
        memset(r->geared_force, 0, n * sizeof *r->geared_force);
        for (size_t way = 0; way < 2; way++) {
            if (!running_probe_moves(probe, way)) {
                own->guided_lever[way] += lever[way];
                continue;
            }
            const size_t row = way == 0 ? probe->x : probe->y;
            r->geared_force[row] = share * share * force[way];
            own->lever_force[row] += lever[way];
        }
        rotor_accelerate(rotor, r->geared_force, r->geared_acceleration);
        for (size_t d = 0; d < n; d++) a[d] += r->geared_acceleration[d];
        rotor_accelerate(rotor, own->lever_force, own->lever_acceleration);
    }
}

static whirl_status running_add_turnings(running_rotor *r) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    r->block = calloc(17 * n + 3 * (r->at_speed + 2) + 3 * rotor->contact_count + 4, sizeof *r->block);
    r->along = malloc(n + 1);
    if (!r->block || !r->along) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine whose speed changes");
    // Cut the block into arrays.
    double **const parts[] = {&r->own_cos,
                              &r->own_sin,
                              &r->force_cos,
                              &r->force_sin,
                              &r->lost_cos,
                              &r->lost_sin,
                              &r->lost_force_cos,
                              &r->lost_force_sin,
                              &r->lever_force,
                              &r->lever_acceleration,
                              &r->geared_force,
                              &r->geared_acceleration,
                              &r->alone,
                              &r->torque,
                              &r->torque_acceleration};
    enum { PARTS = sizeof parts / sizeof *parts };
    for (size_t i = 0; i < PARTS; i++) *parts[i] = r->block + i * n;
    r->place = r->block + PARTS * n;
    r->slope = r->place + r->at_speed + 2;
    r->spool_place = r->slope + r->at_speed + 2;
    r->friction = r->spool_place + r->at_speed + 2;
    r->shake = r->friction + 3 * rotor->contact_count;
    r->guided_lever = r->shake + 2;
    r->shaken = r->guided_lever + 2;
    // Compute the accelerations by the ground, by unbalances and by turning loads.
    for (size_t way = 0; way < 2; way++) rotor_accelerate(rotor, rotor->weight + way * n, r->shaken + way * n);
    for (size_t i = 0; i < rotor->turning_count; i++) {
        r->force_cos[rotor->turnings[i].row] += rotor->turnings[i].cos;
        r->force_sin[rotor->turnings[i].row] += rotor->turnings[i].sin;
    }
    // Find the direction of each displacement: 0 along x, 1 along y, 2 neither.
    memset(r->along, 2, n);
    for (size_t i = 0; i < n; i++) r->alone[i] = 0.5;
    for (size_t p = 0; p < rotor->station_count; p++)
        for (unsigned char way = 0; way < 2; way++) {
            const whirl_probe *probe = &rotor->probes[p];
            const size_t row = way == 0 ? probe->x : probe->y;
            if (!running_probe_moves(probe, way)) continue;
            r->along[row] = way;
            if (!running_probe_moves(probe, 1 - way)) r->alone[row] = 1.0;
        }
    rotor_accelerate(rotor, r->force_cos, r->own_cos);
    rotor_accelerate(rotor, r->force_sin, r->own_sin);
    r->own_inertia = running_unbalance_inertia(r);
    running_count_geared(r);
    running_lose(&r->shown, 0, NULL);
    return whirl_ok();
}

static void running_lose(whirl_running *running, size_t count, const whirl_placed *placed) {
    running_rotor *r = (running_rotor *)running;
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    memset(r->lost_force_cos, 0, n * sizeof *r->lost_force_cos);
    memset(r->lost_force_sin, 0, n * sizeof *r->lost_force_sin);
    memcpy(r->lost_guided, rotor->guided, sizeof r->lost_guided);
    r->lost_spool_count = 0;
    for (size_t i = 0; i < count; i++) {
        if (rotor->spool_of[placed[i].station] > 0) {
            r->lost_spools[r->lost_spool_count++] = placed[i];
            continue;
        }
        const whirl_probe *probe = &rotor->probes[placed[i].station];
        const double c = placed[i].moment * cos(placed[i].angle), s = placed[i].moment * sin(placed[i].angle);
        if (running_probe_moves(probe, 0)) {
            r->lost_force_cos[probe->x] += c;
            r->lost_force_sin[probe->x] -= s;
        } else {
            r->lost_guided[0].cos += c;
            r->lost_guided[0].sin -= s;
        }
        if (running_probe_moves(probe, 1)) {
            r->lost_force_cos[probe->y] += s;
            r->lost_force_sin[probe->y] += c;
        } else {
            r->lost_guided[1].cos += s;
            r->lost_guided[1].sin += c;
        }
    }
    rotor_accelerate(rotor, r->lost_force_cos, r->lost_cos);
    rotor_accelerate(rotor, r->lost_force_sin, r->lost_sin);
    r->lost_inertia = running_unbalance_inertia(r);
    for (size_t k = 0; k < r->spool_count; k++) r->spools[k].unbalance_inertia = running_spool_unbalance_inertia(r, k);
}

// ---------------------------------------------------------------- the equation of the shaft

/// Returns true if torques on a station twist it. Otherwise they turn the shaft as a whole.
static bool running_twists(const running_rotor *r, size_t station) {
    return r->rotor->twist_count > 0 && station != NO_STATION && r->rotor->twists[station].coordinate != NO_COORDINATE;
}

/// Returns the ratio of a station's twist to the shaft's angle in a rigid turn, positive about z.
static double running_turns_of(const running_rotor *r, size_t station) {
    const station_twist *own = &r->rotor->twists[station];
    return r->rotor->rigid[own->coordinate] * own->share;
}

/// Returns the shaft of a station: 0 the rotor's own, from 1 one with a speed of its own.
static size_t running_shaft_of(const running_rotor *r, size_t station) {
    return station != NO_STATION ? r->rotor->spool_of[station] : 0;
}

/// Returns the time, and the speed and angle of a station in the sense of its rotation.
static torque_place running_place_of(const running_rotor *r, size_t station, const running_state *s) {
    const double *x = s->x;
    torque_place at = {.time = x[r->at_speed + 1] / r->unit, .speed = s->exact * r->unit, .angle = s->angle};
    const size_t spool = running_shaft_of(r, station);
    if (spool > 0) {
        at.angle = x[r->at_spool + 2 * spool - 2];
        at.speed = x[r->at_spool + 2 * spool - 1] * r->unit;
        return at;
    }
    if (!running_twists(r, station)) return at;
    const whirl_rotor *rotor = r->rotor;
    const station_twist *own = &rotor->twists[station];
    const double turns = running_turns_of(r, station), sense = copysign(1.0, turns);
    const double twist = sense * own->share * rotor->unit[own->coordinate];
    at.speed = (fabs(turns) * s->exact + twist * x[rotor->lanes.degrees + own->coordinate] * s->w) * r->unit;
    at.angle = fabs(turns) * s->angle + twist * x[own->coordinate];
    return at;
}

/// Adds a torque on a station, in the sense of its rotation. Returns the part that turns the shaft as a whole.
static double running_add_torque(const running_rotor *r, size_t station, double torque) {
    if (!running_twists(r, station)) return torque;
    const station_twist *own = &r->rotor->twists[station];
    r->torque[own->coordinate] += copysign(own->share, own->share * running_turns_of(r, station)) * torque;
    return 0.0;
}

/// Returns true if the course of the run has this formula.
static bool running_has(const running_rotor *r, whirl_run_formula formula) {
    return r->how.course && r->how.course->has[formula];
}

/// Returns the value of a formula of the course at a time, s, and a speed, rad/s.
static double running_value(const running_rotor *r, whirl_run_formula formula, double time, double speed) {
    const whirl_run_course *course = r->how.course;
    course->variables[WHIRL_VARIABLE_TIME] = time;
    course->variables[WHIRL_VARIABLE_SPEED] = speed;
    return course->value(course->owner, formula);
}

/// Return the torque of the drive's motor, and of its load.
static double running_motor_at(const running_rotor *r, const running_state *s) {
    const shaft_drive *drive = &r->rotor->drive;
    if (!drive->given || r->how.tripped) return 0.0;
    const torque_place at = running_place_of(r, drive->at, s);
    return running_has(r, WHIRL_FORMULA_MOTOR) ? running_value(r, WHIRL_FORMULA_MOTOR, at.time, at.speed)
                                               : drive_torque(drive, at.speed);
}
static double running_load_at(const running_rotor *r, const running_state *s) {
    const shaft_drive *drive = &r->rotor->drive;
    if (!drive->given) return 0.0;
    const torque_place at = running_place_of(r, drive->load_at, s);
    return running_has(r, WHIRL_FORMULA_LOAD) ? -running_value(r, WHIRL_FORMULA_LOAD, at.time, at.speed)
                                              : -drive_load(drive, at.speed, r->slip);
}

/// Returns the torques by shafts of the shaft of a station; those of the machine as a whole if stations twist, and this
/// one does not.
static whirl_shaft_torques *running_ledger_of(const running_rotor *r, size_t station) {
    const whirl_rotor *rotor = r->rotor;
    if (rotor->twist_count > 0 && !running_twists(r, station)) return &r->ledger[rotor->shaft_count];
    return &r->ledger[station == NO_STATION ? 0 : rotor->shaft_of[station]];
}

/// Adds the torques of the motor and load of shaft k with a speed of its own.
static void running_drive_spool(const running_rotor *r, size_t k, const running_state *s, whirl_torques *out) {
    const shaft_drive *drive = &r->rotor->spool_drives[k];
    const whirl_run_formula first = (whirl_run_formula)(WHIRL_FORMULA_SPOOL + WHIRL_SPOOL_FORMULAS * k);
    const whirl_run_formula motor = (whirl_run_formula)(first + WHIRL_SPOOL_MOTOR);
    const whirl_run_formula load = (whirl_run_formula)(first + WHIRL_SPOOL_LOAD);
    const double time = s->x[r->at_speed + 1] / r->unit, speed = s->x[r->at_spool + 2 * k + 1] * r->unit;
    if (!drive->given) return;
    if (!r->how.spools[k].tripped)
        out->motor += running_has(r, motor) ? running_value(r, motor, time, speed) : drive_torque(drive, speed);
    out->load -= running_has(r, load) ? running_value(r, load, time, speed) : drive_load(drive, speed, r->slip);
}

/// Returns the torque with this index. Writes the slopes of its states by time, unless `slopes` is NULL.
static double running_torque_at(const running_rotor *r, size_t index, const double *state, const running_state *s,
                                double *slopes) {
    const shaft_torque *own = &r->rotor->torques[index];
    torque_place at = running_place_of(r, own->station, s);
    at.state = state;
    const double torque = own->law->torque(own, &at, slopes);
    const size_t shaft = running_shaft_of(r, own->station);
    return own->law->motor && (shaft > 0 ? r->how.spools[shaft - 1].tripped : r->how.tripped) ? 0.0 : torque;
}

/// Adds the torque by friction that a contact has on the stator if that turns, of size `brake` in the sense of the
/// rotor. Returns the part that turns the rotor's own shaft as a whole.
static double running_add_reaction(const running_rotor *r, const element *contact, double brake,
                                   whirl_torques *spools) {
    const size_t housing = contact->fluid.housing;
    if (r->spool_count == 0 || !contact->type->slides_by_shaft || housing == GROUND) return 0.0;
    const size_t shaft = running_shaft_of(r, housing);
    if (shaft > 0) {
        spools[shaft - 1].friction += r->spools[shaft - 1].sense * brake;
        return 0.0;
    }
    // The stator of a contact within the rotor's own shaft counts as standing.
    const double turns = running_shaft_of(r, contact->station) > 0 ? r->rotor->housing_turns[housing] : 0.0;
    if (turns != 0.0) running_ledger_of(r, housing)->friction += copysign(brake, turns * brake);
    return turns * brake;
}

/// Adds the friction of contacts; to `spools` the torques on shafts with a speed of their own. Returns the part that
/// turns the rotor's own shaft as a whole.
static double running_add_friction(const running_rotor *r, const double *x, double *numbers, double *sum,
                                   whirl_torques *spools) {
    const size_t contacts = r->rotor->contact_count;
    double whole = 0.0;
    *sum = 0.0;
    if (contacts == 0) return 0.0;
    rotor_contacts_with(r->rotor, numbers, x, r->friction, r->friction + contacts);
    for (size_t c = 0; c < contacts; c++) {
        const double own = r->friction[contacts + 2 * c];
        const element *contact = &r->rotor->elements[r->rotor->contacts[c]];
        const size_t shaft = running_shaft_of(r, contact->station);
        if (!isfinite(own)) continue;
        const double reaction = running_add_reaction(r, contact, own, spools);
        if (shaft > 0) {
            spools[shaft - 1].friction -= r->spools[shaft - 1].sense * own;
            *sum += reaction;
            whole += reaction;
            continue;
        }
        *sum -= own;
        running_ledger_of(r, contact->station)->friction -= own;
        whole += running_add_torque(r, contact->station, -own);
    }
    return whole;
}

/// Notes the drag, about the rotor's axis, on a station that turns `turns` times as fast as the rotor.
static void running_note_drag(const running_rotor *r, size_t station, double turns, double torque) {
    whirl_shaft_torques *ledger = running_ledger_of(r, station);
    const size_t shaft = (size_t)(ledger - r->ledger);
    // A ratio that the element gives itself may differ from that of its station's shaft: the power counts.
    const double of = shaft < r->rotor->shaft_count ? fabs(r->rotor->shafts[shaft].turns) : 1.0;
    ledger->drag += turns * torque / of;
}

/// Adds the drag of films and seals, with the numbers of the present speed; to `spools` that on shafts with a speed of
/// their own. Returns the part that turns the rotor's own shaft as a whole.
static double running_add_drag(const running_rotor *r, const running_state *s, double *sum, whirl_torques *spools) {
    const whirl_rotor *rotor = r->rotor;
    double whole = 0.0;
    *sum = 0.0;
    for (size_t i = 0; i < rotor->element_count && !r->how.dragless; i++) {
        const element *own = &rotor->elements[i];
        const size_t station[2] = {own->station, own->fluid.housing};
        double spin[2], torque[2];
        if (!own->type->drag) continue;
        for (size_t k = 0; k < 2; k++) {
            spin[k] = own->fluid.turns[k] * s->exact * r->unit;
            if (running_twists(r, station[k]))
                spin[k] = copysign(1.0, running_turns_of(r, station[k])) * running_place_of(r, station[k], s).speed;
            if (own->fluid.spool[k] > 0)
                spin[k] = r->spools[own->fluid.spool[k] - 1].sense * r->unit *
                          s->x[r->at_spool + 2 * own->fluid.spool[k] - 1];
        }
        rotor_drag_with(rotor, own, r->numbers, s->x, s->w * r->unit, spin, torque);
        for (size_t k = 0; k < 2; k++) {
            const size_t spool = own->fluid.spool[k];
            if (spool > 0) {
                spools[spool - 1].drag += r->spools[spool - 1].sense * torque[k];
                continue;
            }
            const bool twists = running_twists(r, station[k]);
            const double turns = twists ? running_turns_of(r, station[k]) : own->fluid.turns[k];
            *sum += turns * torque[k];
            running_note_drag(r, station[k], turns, torque[k]);
            whole +=
                twists ? running_add_torque(r, station[k], copysign(torque[k], torque[k] * turns)) : turns * torque[k];
        }
    }
    return whole;
}

/// Finds all torques, with the numbers of the speed w. Those on twists are written to workspace. Writes the slopes of
/// their states by time, unless `slopes` is NULL. spools [spool_count]: torques on shafts with a speed of their own,
/// but for those of their rotors. Returns the part that turns the rotor's own shaft as a whole.
static double running_find_torques(const running_rotor *r, double *numbers, const running_state *s, double *slopes,
                                   whirl_torques *out, whirl_torques *spools) {
    const whirl_rotor *rotor = r->rotor;
    const double *state = s->x + rotor->system.dimension;
    memset(r->torque, 0, rotor->lanes.degrees * sizeof *r->torque);
    memset(r->ledger, 0, (rotor->shaft_count + 1) * sizeof *r->ledger);
    out->motor = running_motor_at(r, s);
    out->load = running_load_at(r, s);
    if (rotor->drive.given) running_ledger_of(r, rotor->drive.at)->motor += out->motor;
    if (rotor->drive.given) running_ledger_of(r, rotor->drive.load_at)->load += out->load;
    double whole = running_add_torque(r, rotor->drive.given ? rotor->drive.at : NO_STATION, out->motor) +
                   running_add_torque(r, rotor->drive.given ? rotor->drive.load_at : NO_STATION, out->load);
    for (size_t i = 0; i < rotor->torque_count; i++) {
        const torque_law *law = rotor->torques[i].law;
        const double torque = running_torque_at(r, i, state, s, slopes);
        const size_t shaft = running_shaft_of(r, rotor->torques[i].station);
        if (shaft > 0) {
            *(law->motor ? &spools[shaft - 1].motor : &spools[shaft - 1].load) += torque;
        } else {
            whirl_shaft_torques *ledger = running_ledger_of(r, rotor->torques[i].station);
            *(law->motor ? &out->motor : &out->load) += torque;
            *(law->motor ? &ledger->motor : &ledger->load) += torque;
            whole += running_add_torque(r, rotor->torques[i].station, torque);
        }
        state += law->states;
        if (slopes) slopes += law->states;
    }
    for (size_t k = 0; k < r->spool_count; k++) running_drive_spool(r, k, s, &spools[k]);
    whole += running_add_friction(r, s->x, numbers, &out->friction, spools);
    return whole + running_add_drag(r, s, &out->drag, spools);
}

/// Adds the levers of unbalances that turn at fixed ratios of the speed w, in a state x by the angle.
static void running_add_geared(const running_rotor *r, double w, const double *x) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    memset(r->geared_force, 0, n * sizeof *r->geared_force);
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        double lever[2] = {0.0, 0.0};
        if (running_geared_lever(r, i, w, x + n + own->state, lever) == 0.0) continue;
        for (size_t p = 0; p < 2; p++)
            if (own->port[p] != NO_COORDINATE)
                r->geared_force[own->port[p]] += own->share[p] * lever[p];
            else
                r->guided_lever[p] += lever[p];
    }
    rotor_accelerate(rotor, r->geared_force, r->geared_acceleration);
    for (size_t i = 0; i < n; i++) {
        r->lever_force[i] += r->geared_force[i];
        r->lever_acceleration[i] += r->geared_acceleration[i];
    }
}

/// Returns the given rate of the rotor's speed, rad/s2.
static double running_rate(const running_rotor *r, const running_state *s) {
    double rate = r->how.rate;
    if (running_has(r, WHIRL_FORMULA_RATE))
        rate += running_value(r, WHIRL_FORMULA_RATE, s->x[r->at_speed + 1] / r->unit, s->exact * r->unit);
    return rate;
}

/// Returns true if torques turn one of the shafts.
static bool running_is_torqued(const running_rotor *r) {
    bool any = r->how.driven;
    for (size_t k = 0; k < r->spool_count; k++) any = any || r->how.spools[k].law == WHIRL_SPOOL_DRIVEN;
    return any;
}

/// Returns a speed within a table over the rotor's speed. Beyond its ends the table has its first and last values.
static double running_in_table(const whirl_spool_course *own, double speed) {
    return fmin(fmax(speed, own->at[0]), own->at[own->count - 1]);
}

/// Returns the derivative of a speed by a table over the rotor's speed.
static double running_table_slope(const whirl_spool_course *own, double speed) {
    const bool within = speed >= own->at[0] && speed <= own->at[own->count - 1];
    return within ? table_rate(own->count, own->at, own->speeds, speed) : 0.0;
}

/// Returns the speed of shaft k, which follows a formula or the rotor's speed, over the unit, at a time, s, and a speed
/// of the rotor over the unit.
static double running_followed(const running_rotor *r, size_t k, double time, double w) {
    const whirl_spool_course *own = &r->how.course->spools[k];
    if (r->how.spools[k].law == WHIRL_SPOOL_BY_ROTOR)
        return table_value(own->count, own->at, own->speeds, running_in_table(own, r->unit * w)) / r->unit;
    const whirl_run_formula formula =
        (whirl_run_formula)(WHIRL_FORMULA_SPOOL + WHIRL_SPOOL_FORMULAS * k + WHIRL_SPOOL_SPEED);
    return running_value(r, formula, time, r->unit * w) / r->unit;
}

/// Returns the derivative of that speed by the time over its unit (by_time) or by the rotor's speed, by differences of
/// the order 4: 1e-12 of the highest speed over a hundredth of a turn.
static double running_followed_slope(const running_rotor *r, size_t k, double time, double w, bool by_time) {
    const double step = by_time ? 0.0625 : 0x1p-10; // units of time, and of speed
    double value[4];
    for (int i = 0; i < 4; i++) {
        const double apart = step * (double)(i < 2 ? i - 2 : i - 1);
        value[i] =
            by_time ? running_followed(r, k, time + apart / r->unit, w) : running_followed(r, k, time, w + apart);
    }
    return (8.0 * (value[2] - value[1]) - (value[3] - value[0])) / (12.0 * step);
}

/// Fills in the row of shaft k with a speed of its own.
static shaft_row running_spool_row(const running_rotor *r, size_t k, const running_state *s,
                                   const whirl_torques *torques) {
    const running_spool *own = &r->spools[k];
    const whirl_spool_turning *how = &r->how.spools[k];
    const double time = s->x[r->at_speed + 1] / r->unit;
    shaft_row row = {.driven = how->law == WHIRL_SPOOL_DRIVEN,
                     .torque = torques->motor + torques->load + torques->friction + torques->drag,
                     .inertia = own->inertia + own->unbalance_inertia,
                     .force = own->lever_force,
                     .acceleration = own->lever_acceleration,
                     .guided = own->guided_lever};
    if (how->law == WHIRL_SPOOL_RATE || how->law == WHIRL_SPOOL_BY_TIME) row.all = how->rate / (r->unit * r->unit);
    if (how->law == WHIRL_SPOOL_BY_ROTOR)
        row.by_first = running_table_slope(&r->how.course->spools[k], r->unit * s->exact);
    if (how->law == WHIRL_SPOOL_BY_FORMULA) {
        row.all = running_followed_slope(r, k, time, s->exact, true);
        row.by_first = running_followed_slope(r, k, time, s->exact, false);
    }
    return row;
}

/// Returns theta'' of all shafts of a machine with shafts that have a speed of their own, as running_faster does.
/// spools [spool_count]: torques on these, completed here.
static faster running_faster_shafts(const running_rotor *r, double *numbers, const running_state *s, const double *a,
                                    double *slopes, whirl_torques *torques, whirl_torques *spools) {
    const double square = r->unit * r->unit, pull[3] = {running_pull(r, 0), running_pull(r, 1), 0.0};
    shaft_row rows[1 + WHIRL_MAX_SPOOLS];
    faster by = {.all = 0.0};
    double whole = 0.0;
    for (size_t k = 0; k < r->spool_count; k++) spools[k] = (whirl_torques){.motor = 0.0};
    if (running_is_torqued(r))
        whole = running_find_torques(r, numbers, s, slopes, torques, spools);
    else if (slopes)
        memset(slopes, 0, r->own * sizeof *slopes);
    rows[0] =
        (shaft_row){.driven = r->how.driven,
                    .torque = whole,
                    .inertia = r->turn_inertia + r->geared_inertia + (r->how.lost ? r->lost_inertia : r->own_inertia),
                    .force = r->lever_force,
                    .acceleration = r->lever_acceleration,
                    .guided = r->guided_lever,
                    .all = running_rate(r, s) / square};
    for (size_t k = 0; k < r->spool_count; k++) rows[1 + k] = running_spool_row(r, k, s, &spools[k]);
    running_solve_shafts(r, s->w, a, pull, 1 + r->spool_count, rows);
    torques->rotor = rows[0].reaction * square;
    by.all = rows[0].all;
    for (size_t k = 0; k < r->spool_count; k++) {
        by.spools[k] = rows[1 + k].all;
        spools[k].rotor = rows[1 + k].reaction * square;
        spools[k].acceleration = by.spools[k] * square;
    }
    return by;
}

/// Returns theta'' with the numbers of the speed w. a [degrees]: accelerations by the angle without theta'', to which
/// those by torques on twists are added. slopes: of the states of torques by time, or NULL. torques: written only if
/// torques drive the shaft.
static faster running_faster(const running_rotor *r, double *numbers, const running_state *s, double *a, double *slopes,
                             whirl_torques *torques) {
    const whirl_rotor *rotor = r->rotor;
    whirl_torques none[WHIRL_MAX_SPOOLS];
    if (r->spool_count > 0) return running_faster_shafts(r, numbers, s, a, slopes, torques, none);
    const double square = r->unit * r->unit, w = s->w;
    const bool driven = r->how.driven, twists = rotor->twist_count > 0;
    double whole = 0.0, reaction = 0.0, inertia = r->turn_inertia, turned = 0.0;
    if (driven)
        whole = running_find_torques(r, numbers, s, slopes, torques, none);
    else if (slopes)
        memset(slopes, 0, r->own * sizeof *slopes);
    // The accelerations of all twists change the angular momentum of the rigid turn.
    if (driven && twists) rotor_accelerate(rotor, r->torque, r->torque_acceleration);
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++) {
        if (driven) a[i] += r->torque_acceleration[i] / (square * w * w);
        turned += rotor->momentum[i] * rotor->unit[i] * w * w * a[i];
    }
    if (!driven) return (faster){.all = running_rate(r, s) / square, .twisted = twists ? turned / inertia : 0.0};
    // Unbalances act as levers.
    inertia += (r->how.lost ? r->lost_inertia : r->own_inertia) + r->geared_inertia;
    for (size_t way = 0; way < 2; way++) reaction -= r->guided_lever[way] * running_pull(r, way) / square;
    for (size_t i = 0; i < rotor->lanes.degrees; i++) {
        const double u = r->lever_force[i];
        if (u == 0.0) continue;
        reaction += u * (rotor->unit[i] * w * w * a[i] - running_pull(r, r->along[i]) / square);
        inertia -= u * rotor->unit[i] * r->lever_acceleration[i];
    }
    torques->rotor = reaction * square;
    return (faster){.all = (whole / square + turned + reaction) / inertia, .twisted = turned / r->turn_inertia};
}

/// Adds the effect of theta'' to the accelerations by the angle a [degrees], with velocities v: q'' = (d2q/dt2 -
/// theta'' q')/theta'^2. Includes the force of unbalances by theta'', and the inertia of twists, which are relative to
/// the turning shaft.
static void running_add_faster(const running_rotor *r, faster by, double w, const double *v, double *a) {
    const whirl_rotor *rotor = r->rotor;
    const double share = by.all / (w * w), twisted = by.twisted / (w * w);
    for (size_t i = 0; i < rotor->lanes.degrees; i++) a[i] += share * (r->lever_acceleration[i] - v[i]);
    for (size_t k = 0; k < r->spool_count; k++)
        for (size_t i = 0; i < rotor->lanes.degrees; i++)
            a[i] += by.spools[k] / (w * w) * r->spools[k].lever_acceleration[i];
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++)
        a[i] -= twisted * rotor->rigid[i] / rotor->unit[i];
}

/// Adds the effect of theta'', times `share`, to the slopes a [rows] of element states that stand for derivatives by
/// the angle, v [rows].
static void running_add_pace(const running_rotor *r, double share, const double *v, double *a) {
    double paced[MAX_ELEMENT_STATES];
    for (size_t i = 0; i < r->rotor->element_count; i++) {
        element own = r->rotor->elements[i];
        if (!own.type->paced || own.states == 0) continue;
        own.number = r->numbers + own.first_number;
        own.type->paced(&own, v + own.state, paced);
        for (size_t k = 0; k < own.states; k++) a[own.state + k] -= share * paced[k];
    }
}

/// Adds the effect of a moving ground on all masses to the accelerations by the angle a [degrees].
static void running_add_shake(const running_rotor *r, double w, const double *x, double *a) {
    const size_t n = r->rotor->lanes.degrees;
    const double by_angle = 1.0 / (r->unit * r->unit * w * w);
    for (size_t way = 0; way < 2; way++) {
        const whirl_run_formula formula = (whirl_run_formula)(WHIRL_FORMULA_GROUND_X + way);
        r->shake[way] = 0.0;
        if (!running_has(r, formula)) continue;
        r->shake[way] = running_value(r, formula, x[r->at_speed + 1] / r->unit, x[r->at_speed] * r->unit);
        for (size_t i = 0; i < n; i++) a[i] -= r->shake[way] * by_angle * r->shaken[way * n + i];
    }
}

/// Computes the levers, and the slopes by the angle dxdt [dimension of the rotor] for a constant speed w, from the
/// state x by the angle. Returns the numbers at w.
static double *running_flow(const running_rotor *r, double w, const double *forcing, const double *sides,
                            const double *x, double *dxdt) {
    double *numbers = running_numbers_at(r, w, x);
    const size_t n = r->rotor->lanes.degrees;
    running_find_levers(r, forcing);
    if (r->spool_count > 0) running_find_spool_levers(r, x);
    if (r->geared_count > 0) running_add_geared(r, fmax(w, slowest), x);
    rotor_flow_with(r->rotor, numbers, forcing, sides, x, dxdt);
    for (size_t i = 0; i < n && r->how.lost; i++)
        dxdt[n + i] += r->lost_cos[i] * forcing[COS_TAU] + r->lost_sin[i] * forcing[SIN_TAU];
    if (r->how.lost) running_add_lost_spools(r, fmax(w, slowest), x, dxdt + n);
    running_add_shake(r, w, x, dxdt + n);
    return numbers;
}

/// Computes the forcing at an angle, with the speeds of shafts that have their own, rad/s about z.
static void running_find_forcing(const running_rotor *r, double angle, const double *x, double *forcing) {
    r->rotor->system.forcing(r->rotor, angle, forcing);
    for (size_t k = 0; k < r->spool_count; k++)
        forcing[FORCING_COUNT + k] = r->rotor->way * r->spools[k].sense * r->unit * x[r->at_spool + 2 * k + 1];
}

/// Computes the slopes dxdt of a state, by the angle, at a given angle.
static void running_slopes_at(const running_rotor *r, double angle, const double *x, const double *sides,
                              double *dxdt) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees, d = rotor->system.dimension, at = r->at_speed;
    const double w = x[at];
    double forcing[FORCING_COUNT + WHIRL_MAX_SPOOLS];
    whirl_torques torques;
    // Compute the slopes of the rotor at constant speed, then theta'' by the torques.
    running_find_forcing(r, angle, x, forcing);
    double *numbers = running_flow(r, w, forcing, sides, x, dxdt);
    const faster by = running_faster(r, numbers, &(running_state){w, w, angle, x}, dxdt + n, dxdt + d, &torques);
    running_add_faster(r, by, w, x + n, dxdt + n);
    running_add_pace(r, by.all / (w * w), x + n, dxdt + n);
    for (size_t i = d; i < r->at_spool; i++) dxdt[i] /= w * r->unit;
    for (size_t k = 0; k < r->spool_count; k++) {
        dxdt[r->at_spool + 2 * k] = x[r->at_spool + 2 * k + 1] / w;
        dxdt[r->at_spool + 2 * k + 1] = by.spools[k] / w;
    }
    dxdt[at] = by.all / w;
    dxdt[at + 1] = 1.0 / w;
}

static void running_rhs_by_angle(const void *model, double t, const double *given, const double *x, const double *sides,
                                 double *dxdt) {
    const running_rotor *r = model;
    (void)given;
    running_slopes_at(r, r->from + t, x, sides, dxdt);
}

static void running_scale_to_angle(const running_rotor *r, double *x) {
    const size_t n = r->rotor->lanes.degrees;
    const double w = fmax(x[r->at_speed], slowest);
    for (size_t i = n; i < 2 * n; i++) x[i] /= w;
}

/// Sets the speeds of shafts that follow a formula or the rotor's speed.
static void running_set_followed(const running_rotor *r, double *x) {
    for (size_t k = 0; k < r->spool_count; k++) {
        const whirl_spool_law law = r->how.spools[k].law;
        if (law == WHIRL_SPOOL_BY_ROTOR || law == WHIRL_SPOOL_BY_FORMULA)
            x[r->at_spool + 2 * k + 1] = running_followed(r, k, x[r->at_speed + 1] / r->unit, x[r->at_speed]);
    }
}

/// Converts a state with derivatives by time to one with derivatives by the angle, in workspace.
static const double *running_placed_by_angle(const running_rotor *r, const double *x) {
    memcpy(r->place, x, (r->at_speed + 2) * sizeof *r->place);
    running_scale_to_angle(r, r->place);
    running_set_followed(r, r->place);
    return r->place;
}

static void running_rhs_by_time(const void *model, double t, const double *given, const double *x, const double *sides,
                                double *dxdt) {
    const running_rotor *r = model;
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees, d = rotor->system.dimension, at = r->at_speed;
    const double w = fmax(x[at], slowest), angle = x[at + 2];
    double forcing[FORCING_COUNT + WHIRL_MAX_SPOOLS];
    whirl_torques torques;
    (void)given, (void)t;
    // Compute the slopes of the rotor at constant speed by the angle, then theta'' by the torques.
    const double *place = running_placed_by_angle(r, x);
    running_find_forcing(r, angle, place, forcing);
    double *numbers = running_flow(r, w, forcing, sides, place, dxdt);
    const faster by =
        running_faster(r, numbers, &(running_state){x[at], w, angle, place}, dxdt + n, dxdt + d, &torques);
    // Convert derivatives by the angle to derivatives by time.
    for (size_t i = 0; i < n; i++) {
        dxdt[i] = x[n + i];
        dxdt[n + i] = w * w * dxdt[n + i] + by.all * r->lever_acceleration[i];
        for (size_t k = 0; k < r->spool_count; k++) dxdt[n + i] += by.spools[k] * r->spools[k].lever_acceleration[i];
    }
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++)
        dxdt[n + i] -= by.twisted * rotor->rigid[i] / rotor->unit[i];
    for (size_t i = 2 * n; i < d; i++) dxdt[i] *= w;
    running_add_pace(r, by.all / w, place + n, dxdt + n);
    for (size_t i = d; i < r->at_spool; i++) dxdt[i] /= r->unit;
    for (size_t k = 0; k < r->spool_count; k++) {
        dxdt[r->at_spool + 2 * k] = place[r->at_spool + 2 * k + 1];
        dxdt[r->at_spool + 2 * k + 1] = by.spools[k];
    }
    dxdt[at] = by.all;
    dxdt[at + 1] = 1.0;
    dxdt[at + 2] = x[at];
}

static void running_free_by_angle(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    running_rhs_by_angle(model, t, forcing, x, NULL, dxdt);
}

/// Right-hand sides of machines in lanes, whose time is the angle.
static void running_rhs_together(const void *model, double t, const double *given, const double *x, const double *sides,
                                 double *dxdt) {
    (void)given;
    running_slopes_at(model, t, x, sides, dxdt);
}

static void running_free_together(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    running_rhs_together(model, t, forcing, x, NULL, dxdt);
}

static void running_forcing_together(const void *model, double t, double *forcing) {
    const running_rotor *r = model;
    r->rotor->system.forcing(r->rotor, t, forcing);
}

static void running_free_by_time(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    running_rhs_by_time(model, t, forcing, x, NULL, dxdt);
}

// ---------------------------------------------------------------- switches

static void running_switches_by_angle(const void *model, double t, const double *x, double *values) {
    const running_rotor *r = model;
    (void)t;
    rotor_switches_with(r->rotor, running_numbers_at(r, x[r->at_speed], x), x, values);
}

static void running_switches_by_time(const void *model, double t, const double *x, double *values) {
    const running_rotor *r = model;
    running_switches_by_angle(r, t, running_placed_by_angle(r, x), values);
}

/// Writes the derivative of a switch by the speed of shaft k with a speed of its own.
static void running_spool_gradient(const running_rotor *r, const double *x, size_t index, size_t k, double *gradient) {
    const size_t at = r->at_spool + 2 * k + 1;
    const double step = 1e-6 * fmax(x[at], slowest);
    double values[2][WHIRL_MAX_SWITCHES];
    for (size_t side = 0; side < 2; side++) {
        memcpy(r->spool_place, x, (r->at_speed + 2) * sizeof *x);
        r->spool_place[at] += side == 0 ? step : -step;
        rotor_switches_with(r->rotor, running_numbers_at(r, x[r->at_speed], r->spool_place), x, values[side]);
    }
    gradient[at] = (values[0][index] - values[1][index]) / (2.0 * step);
}

/// Writes the gradient of a switch. The derivative by the speed is a difference quotient, since switches depend on the
/// speed through the numbers.
static void running_gradient_at(const running_rotor *r, const double *x, size_t index, double *gradient) {
    const size_t at = r->at_speed;
    const double w = x[at], step = 1e-6 * fmax(w, slowest);
    double values[2][WHIRL_MAX_SWITCHES];
    rotor_gradient_with(r->rotor, running_numbers_at(r, w, x), x, index, gradient);
    rotor_switches_with(r->rotor, running_numbers_at(r, w + step, x), x, values[0]);
    rotor_switches_with(r->rotor, running_numbers_at(r, w - step, x), x, values[1]);
    for (size_t i = r->rotor->system.dimension; i < at + 2; i++) gradient[i] = 0.0;
    gradient[at] = (values[0][index] - values[1][index]) / (2.0 * step);
    for (size_t k = 0; k < r->spool_count; k++) running_spool_gradient(r, x, index, k, gradient);
}

static void running_gradient_by_angle(const void *model, double t, const double *x, size_t index, double *gradient,
                                      double *by_time) {
    (void)t;
    *by_time = 0.0;
    running_gradient_at(model, x, index, gradient);
}

static void running_gradient_by_time(const void *model, double t, const double *x, size_t index, double *gradient,
                                     double *by_time) {
    const running_rotor *r = model;
    const size_t n = r->rotor->lanes.degrees, at = r->at_speed;
    const double w = fmax(x[at], slowest);
    (void)t;
    *by_time = 0.0;
    running_gradient_at(r, running_placed_by_angle(r, x), index, gradient);
    gradient[at + 2] = 0.0;
    for (size_t i = n; i < 2 * n; i++) {
        gradient[at] -= gradient[i] * x[i] / (w * w);
        gradient[i] /= w;
    }
}

static bool running_touches(const void *model, size_t index) {
    const running_rotor *r = model;
    return r->rotor->system.switch_touches(r->rotor, index);
}

// ---------------------------------------------------------------- the machine

static void running_fill_systems(running_rotor *r) {
    const whirl_system *own = &r->rotor->system;
    whirl_system both = {.dimension = r->at_speed + 2,
                         .period = own->period,
                         .kinked = own->kinked,
                         .switch_count = own->switch_count,
                         .switch_touches = own->switch_count > 0 ? running_touches : NULL,
                         .probe_count = own->probe_count,
                         .probes = own->probes,
                         .extra_count = own->extra_count,
                         .extras = own->extras,
                         .spool_count = own->spool_count,
                         .spools = own->spools,
                         .shaft_count = own->shaft_count,
                         .model = r,
                         .stop = own->stop};
    r->by_angle = r->by_time = both;
    r->by_time.dimension = r->at_speed + 3;
    r->by_angle.rhs = running_free_by_angle;
    r->by_angle.rhs_on_sides = running_rhs_by_angle;
    r->by_angle.switches = running_switches_by_angle;
    r->by_angle.switch_gradient = running_gradient_by_angle;
    r->by_time.rhs = running_free_by_time;
    r->by_time.rhs_on_sides = running_rhs_by_time;
    r->by_time.switches = running_switches_by_time;
    r->by_time.switch_gradient = running_gradient_by_time;
    r->together = r->by_angle;
    r->together.rhs = running_free_together;
    r->together.rhs_on_sides = running_rhs_together;
    r->together.forcing_count = FORCING_COUNT;
    r->together.forcing = running_forcing_together;
    r->together.lanes = &r->form;
}

static void running_set(whirl_running *running, const whirl_turning *how) {
    ((running_rotor *)running)->how = *how;
}

static void running_part(whirl_running *running, double from, double length) {
    running_rotor *r = (running_rotor *)running;
    r->from = from;
    r->by_angle.period = r->by_time.period = length;
}

static double running_adopt(const whirl_running *running, const whirl_running *from, bool by_time, double *x) {
    const running_rotor *r = (const running_rotor *)running, *other = (const running_rotor *)from;
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees, at = r->at_speed;
    // Units of tilts depend on the inertia.
    for (size_t i = 0; i < n; i++) {
        const double units = other->rotor->unit[i] / rotor->unit[i];
        x[i] *= units;
        x[n + i] *= units;
    }
    if (rotor->twist_count == 0) return 0.0;
    // Twists are relative to a mean turn, weighted by inertia. Another inertia has another mean, by angle and by speed.
    double turned[2] = {0.0, 0.0};
    const double speed = by_time ? 1.0 : fmax(x[at], slowest);
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++)
        for (size_t k = 0; k < 2; k++)
            turned[k] += rotor->momentum[i] * rotor->unit[i] * x[k * n + i] / r->turn_inertia;
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++)
        for (size_t k = 0; k < 2; k++) x[k * n + i] -= rotor->rigid[i] / rotor->unit[i] * turned[k];
    if (by_time) x[at + 2] += turned[0];
    x[at] += turned[1] * speed;
    if (!by_time)
        for (size_t i = n; i < 2 * n; i++) x[i] *= speed / fmax(x[at], slowest);
    return turned[0];
}

static void running_to_angle(const whirl_running *running, double *x) {
    running_scale_to_angle((const running_rotor *)running, x);
}

static void running_torques(const whirl_running *running, const double *x, double angle, whirl_torques *out) {
    const running_rotor *r = (const running_rotor *)running;
    const double exact = x[r->at_speed], w = fmax(exact, slowest);
    double forcing[FORCING_COUNT + WHIRL_MAX_SPOOLS];
    *out = (whirl_torques){.motor = NAN, .load = NAN, .friction = NAN, .rotor = NAN, .drag = NAN};
    running_find_forcing(r, angle, x, forcing);
    double *numbers = running_flow(r, w, forcing, NULL, x, r->slope);
    const faster by =
        running_faster(r, numbers, &(running_state){exact, w, angle, x}, r->slope + r->rotor->lanes.degrees, NULL, out);
    out->acceleration = r->unit * r->unit * by.all;
}

static void running_spool_torques(const whirl_running *running, const double *x, double angle, whirl_torques *out) {
    const running_rotor *r = (const running_rotor *)running;
    const double exact = x[r->at_speed], w = fmax(exact, slowest);
    double forcing[FORCING_COUNT + WHIRL_MAX_SPOOLS];
    whirl_torques own;
    running_find_forcing(r, angle, x, forcing);
    double *numbers = running_flow(r, w, forcing, NULL, x, r->slope);
    running_faster_shafts(r, numbers, &(running_state){exact, w, angle, x}, r->slope + r->rotor->lanes.degrees, NULL,
                          &own, out);
    for (size_t k = 0; k < r->spool_count; k++)
        if (r->how.spools[k].law != WHIRL_SPOOL_DRIVEN)
            out[k].motor = out[k].load = out[k].friction = out[k].drag = out[k].rotor = NAN;
}

static void running_shaft_torques(const whirl_running *running, const double *x, double angle,
                                  whirl_shaft_torques *out) {
    const running_rotor *r = (const running_rotor *)running;
    const running_state s = {x[r->at_speed], fmax(x[r->at_speed], slowest), angle, x};
    double forcing[FORCING_COUNT + WHIRL_MAX_SPOOLS];
    whirl_torques own, spools[WHIRL_MAX_SPOOLS] = {{.motor = 0.0}};
    running_find_forcing(r, angle, x, forcing);
    double *numbers = running_flow(r, s.w, forcing, NULL, x, r->slope);
    double *a = r->slope + r->rotor->lanes.degrees;
    const faster by = r->spool_count > 0 ? running_faster_shafts(r, numbers, &s, a, NULL, &own, spools)
                                         : running_faster(r, numbers, &s, a, NULL, &own);
    running_complete_shafts(r, &s, forcing, a, &by, spools, out);
}

static void running_follow(const whirl_running *running, double *x) {
    running_set_followed((const running_rotor *)running, x);
}

/// Returns the torque of a spring between twists, positive if its first place drives the second in the sense of the
/// rotation.
static double running_link_torque(const running_rotor *r, const twist_link *own, const running_state *s) {
    const whirl_rotor *rotor = r->rotor;
    double twist = 0.0, rate = 0.0;
    for (size_t end = 0; end < 2; end++) {
        const size_t c = own->coordinate[end];
        const double share = (end == 0 ? 1.0 : -1.0) * own->share[end] * rotor->unit[c];
        twist += share * s->x[c];
        rate += share * s->x[rotor->lanes.degrees + c] * s->w * r->unit;
    }
    return copysign(1.0, rotor->rigid[own->coordinate[0]] * own->share[0]) *
           (own->stiffness * twist + own->damping * rate);
}

static void running_watch(const whirl_running *running, const double *x, double angle, double *torque) {
    const running_rotor *r = (const running_rotor *)running;
    const running_state s = {x[r->at_speed], fmax(x[r->at_speed], slowest), angle, x};
    const double *state = x + r->rotor->system.dimension;
    for (size_t i = 0; i < r->rotor->torque_count; i++) {
        *torque++ = running_torque_at(r, i, state, &s, NULL);
        state += r->rotor->torques[i].law->states;
    }
    for (size_t i = 0; i < r->rotor->link_count; i++)
        if (r->rotor->links[i].stiffness > 0.0) *torque++ = running_link_torque(r, &r->rotor->links[i], &s);
    const element *carrier;
    for (size_t i = 0; (carrier = rotor_carrier(r->rotor, i)) != NULL; i++)
        *torque++ = rotor_carried(r->rotor, carrier, running_numbers_at(r, s.w, x), x);
}

/// Returns the station at an end of a spring between twists.
static size_t running_end_of(const running_rotor *r, const twist_link *own, size_t end) {
    size_t found = r->rotor->station_count;
    for (size_t s = r->rotor->station_count; s-- > 0;)
        if (r->rotor->twists[s].coordinate == own->coordinate[end] && r->rotor->twists[s].share == own->share[end])
            found = s;
    return found;
}

static void running_watched(const whirl_running *running, size_t index, size_t station[2], const char **name) {
    const running_rotor *r = (const running_rotor *)running;
    const whirl_rotor *rotor = r->rotor;
    station[0] = station[1] = rotor->station_count;
    if (index < rotor->torque_count) {
        if (rotor->torques[index].station != NO_STATION) station[0] = rotor->torques[index].station;
        *name = rotor->torques[index].law->name;
        return;
    }
    index -= rotor->torque_count;
    for (size_t i = 0; i < rotor->link_count; i++) {
        if (!(rotor->links[i].stiffness > 0.0) || index-- > 0) continue;
        for (size_t end = 0; end < 2; end++) station[end] = running_end_of(r, &rotor->links[i], end);
        *name = "twist";
        return;
    }
    const element *carrier = rotor_carrier(rotor, index);
    for (size_t end = 0; end < 2; end++)
        if (carrier->ends[end] != GROUND) station[end] = carrier->ends[end];
    *name = carrier->type->group.name;
}

static void running_speeds(const whirl_running *running, const double *x, double *speed) {
    const running_rotor *r = (const running_rotor *)running;
    const running_state s = {x[r->at_speed], fmax(x[r->at_speed], slowest), 0.0, x};
    for (size_t p = 0; p < r->rotor->station_count; p++) speed[p] = running_place_of(r, p, &s).speed;
}

static double running_begins(const whirl_running *running, double time) {
    const whirl_rotor *rotor = ((const running_rotor *)running)->rotor;
    double next = INFINITY;
    for (size_t i = 0; i < rotor->torque_count; i++) {
        const shaft_torque *own = &rotor->torques[i];
        const double begins = own->law->begins ? own->law->begins(own) : 0.0;
        if (begins > time) next = fmin(next, begins);
    }
    return next;
}

static size_t running_switch(const whirl_running *running, size_t contact) {
    const whirl_rotor *rotor = ((const running_rotor *)running)->rotor;
    return rotor->elements[rotor->contacts[contact]].first_switch;
}

/// Returns true if all contacts are certainly open, by their gaps alone.
static bool running_is_apart(const whirl_rotor *rotor, const double *x) {
    if (rotor->lanes.damped) return false;
    for (size_t c = 0; c < rotor->contact_count; c++) {
        const element *own = &rotor->elements[rotor->contacts[c]];
        const double gap = own->type->contact_gap(own);
        const size_t *port = own->port;
        if (port[0] == NO_COORDINATE || port[1] == NO_COORDINATE) return false;
        if (!(x[port[0]] * x[port[0]] + x[port[1]] * x[port[1]] < (1.0 - 1e-12) * gap * gap)) return false;
    }
    return true;
}

static void running_contacts(const whirl_running *running, const double *x, double *normal_force) {
    const running_rotor *r = (const running_rotor *)running;
    if (r->rotor->contact_count == 0) return;
    if (running_is_apart(r->rotor, x)) {
        memset(normal_force, 0, r->rotor->contact_count * sizeof *normal_force);
        return;
    }
    rotor_contacts_with(r->rotor, running_numbers_at(r, x[r->at_speed], x), x, normal_force, NULL);
}

static const whirl_system *running_in_lanes(const whirl_running *running, bool derived) {
    const running_rotor *r = (const running_rotor *)running;
    // Contacts do not give the derivative of the torque of their friction.
    if (derived && r->driven && r->rotor->contact_count > 0) return NULL;
    return running_goes_in_lanes(r) ? &r->together : NULL;
}

static void running_release(whirl_running *running) {
    running_rotor *r = (running_rotor *)running;
    running_lanes_free(r);
    if (r->machine.release) r->machine.release(r->machine.owner);
    free(r->numbers);
    free(r->varying);
    free(r->splines);
    free(r->spooled);
    free(r->spool_splines);
    for (size_t k = 0; k < r->spool_count; k++) free(r->spools[k].lever_force);
    free(r->spools);
    free(r->spool_at);
    free(r->ledger);
    free(r->block);
    free(r->along);
    free(r);
}

/// Counts the states of torques and the observed torques, and finds the inertia of all turning parts.
static void running_count(running_rotor *r) {
    const whirl_rotor *rotor = r->rotor;
    bool driven = r->driven;
    for (size_t k = 0; k < r->spool_count; k++) driven = driven || r->spools[k].driven;
    const size_t torques = driven ? rotor->torque_count : 0;
    for (size_t i = 0; i < torques; i++) r->own += rotor->torques[i].law->states;
    r->at_spool = rotor->system.dimension + r->own;
    r->at_speed = r->at_spool + 2 * r->spool_count;
    r->turn_inertia = rotor->drive.inertia;
    for (size_t i = rotor->first_twist; i < rotor->first_twist + rotor->twist_count; i++)
        r->turn_inertia += rotor->momentum[i] * rotor->rigid[i];
    r->shown.in_time = torques > 0 || rotor->twist_count > 0 || r->spool_count > 0;
    r->slip = r->shown.in_time ? slipping * r->unit : 0.0;
    r->shown.driver = rotor->driver;
    r->shown.watched_count = driven ? rotor->system.torque_count : 0;
    r->shown.spool_count = r->spool_count;
    r->shown.shaft_count = rotor->shaft_count;
    r->shown.shaft_of = rotor->shaft_of;
    r->shown.spool_state = r->at_spool;
}

/// Makes the machine at the unit of speed. Its shafts with a speed of their own have that of the base.
static whirl_status running_make_base(running_rotor *r, whirl_machine_at *make, const void *context,
                                      const whirl_spool_range *spools) {
    whirl_status status = make(context, r->unit, NULL, &r->machine);
    if (status.code == WHIRL_OK) status = running_check_machine(r, &r->machine);
    if (status.code != WHIRL_OK || r->machine.system->spool_count == 0) return status;
    double speeds[WHIRL_MAX_SPOOLS] = {0.0};
    r->spool_count = r->machine.system->spool_count;
    for (size_t k = 0; k < r->spool_count; k++) {
        const whirl_spool *own = &r->machine.system->spools[k];
        const double highest = spools ? spools[k].highest : own->speed;
        r->spools[k] = running_spool_of(highest / r->unit, own->sense);
        speeds[k] = r->spools[k].highest * r->unit;
        if (!(highest > 0.0))
            status = whirl_fail(WHIRL_BAD_INPUT, "the highest speed of shaft '%s' is %.6g rad/s, expected one above 0",
                                own->name, highest);
        else if (spools && spools[k].driven && !(rotor_of_system(r->machine.system)->spool_drives[k].inertia > 0.0))
            status = whirl_fail(WHIRL_BAD_INPUT,
                                "torques turn shaft '%s' and its inertia is not known, expected the key inertia of its "
                                "drive",
                                own->name);
    }
    if (r->machine.release) r->machine.release(r->machine.owner);
    r->machine = (whirl_machine){.system = NULL};
    if (status.code == WHIRL_OK) status = make(context, r->unit, speeds, &r->machine);
    return status.code == WHIRL_OK ? running_check_machine(r, &r->machine) : status;
}

whirl_status whirl_running_new(whirl_machine_at *make, const void *context, double lowest, double highest, bool driven,
                               const whirl_spool_range *spools, whirl_running **out) {
    running_rotor *r = calloc(1, sizeof *r);
    *out = NULL;
    if (r) r->spools = calloc(WHIRL_MAX_SPOOLS, sizeof *r->spools);
    if (r) r->spool_at = calloc(WHIRL_MAX_SPOOLS, sizeof *r->spool_at);
    if (r) r->ledger = calloc(WHIRL_MAX_RUN_SHAFTS + 1, sizeof *r->ledger);
    if (!r || !r->spools || !r->spool_at || !r->ledger) {
        if (r) running_release(&r->shown);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine whose speed changes");
    }
    r->unit = highest;
    r->driven = driven;
    r->lowest_node = fmin(fmax(lowest / highest, 1.0 / 256.0), 0.999);
    // Make the machine at the highest speed, and find its numbers as functions of the speed.
    whirl_status status = running_make_base(r, make, context, spools);
    if (status.code == WHIRL_OK) {
        r->rotor = rotor_of_system(r->machine.system);
        for (size_t k = 0; k < r->spool_count; k++) r->spools[k].driven = spools && spools[k].driven;
        running_count(r);
        status = running_find_numbers(r, make, context);
    }
    if (status.code == WHIRL_OK) status = running_add_spools(r);
    if (status.code == WHIRL_OK) status = running_add_turnings(r);
    if (status.code == WHIRL_OK && !running_lanes_fill(r))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine whose speed changes");
    if (status.code != WHIRL_OK) {
        running_release(&r->shown);
        return status;
    }
    running_fill_systems(r);
    // Fill in the members of the public struct.
    r->shown.by_angle = &r->by_angle;
    r->shown.by_time = &r->by_time;
    r->shown.unit = highest;
    r->shown.geared = r->geared_count > 0;
    r->shown.contact_count = r->rotor->contact_count;
    r->shown.turn = running_set;
    r->shown.lose = running_lose;
    r->shown.part = running_part;
    r->shown.adopt = running_adopt;
    r->shown.to_angle = running_to_angle;
    r->shown.torques = running_torques;
    r->shown.spool_torques = running_spool_torques;
    r->shown.shaft_torques = running_shaft_torques;
    r->shown.follow = running_follow;
    r->shown.watch = running_watch;
    r->shown.watched = running_watched;
    r->shown.speeds = running_speeds;
    r->shown.begins = running_begins;
    r->shown.contacts = running_contacts;
    r->shown.contact_switch = running_switch;
    r->shown.in_lanes = running_in_lanes;
    r->shown.release = running_release;
    *out = &r->shown;
    return whirl_ok();
}
