// Assembly of a rotor: numbers the coordinates, and sums their inertia and the linear terms of their accelerations.
#include "assembly.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// Speed, rad/s, that laws use for a shaft at standstill. It is so low that terms proportional to the speed are lost in
/// rounding, but is not 0, since film laws divide by the speed.
static const double slowest = 0x1p-60;

whirl_status assembly_begin(assembly *to, double speed, double length, size_t station_count) {
    *to = (assembly){.speed = fabs(speed), .length = length, .station_count = station_count};
    to->clock = to->speed > 0.0 ? to->speed : 1.0;
    to->pace = assembly_pace_of(speed);
    to->turn = copysign(to->pace / to->clock, speed);
    to->stations = calloc(station_count, sizeof *to->stations);
    to->numbers = calloc(station_count, sizeof *to->numbers);
    to->inertia = calloc(AXES * station_count, sizeof *to->inertia);
    to->unit = calloc(AXES * station_count, sizeof *to->unit);
    if (!to->stations || !to->numbers || !to->inertia || !to->unit)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu stations", station_count);
    for (size_t s = 0; s < station_count; s++)
        to->stations[s] = (assembly_station){
            .moves_x = true, .moves_y = true, .geared_to = NO_STATION, .gear = 1.0, .shaft = NO_SHAFT, .ratio = 1.0};
    return whirl_ok();
}

void assembly_clear(assembly *to) {
    free(to->stations);
    free(to->numbers);
    free(to->inertia);
    free(to->unit);
    free(to->terms);
    free(to->masses);
    free(to->frequencies);
    free(to->runouts);
    free(to->turnings);
    free(to->weights);
    free(to->torques);
    free(to->asides);
    free(to->links);
    free(to->holds);
    free(to->harmonics);
    free(to->fatigues);
    body_clear(&to->body);
}

double assembly_pace_of(double speed) {
    return speed != 0.0 ? fabs(speed) : slowest;
}

double assembly_spool_spin(const assembly *of, size_t spool) {
    const whirl_spool *own = &of->spools[spool - 1];
    return copysign(own->sense, own->sense * of->turn) * own->speed;
}

int assembly_spool_value(const assembly *of, size_t spool, double *factor) {
    if (of->spools_vary) return FORCING_COUNT + (int)spool - 1;
    *factor *= assembly_spool_spin(of, spool);
    return BODY_STEADY;
}

bool assembly_is_aside(const assembly *of, size_t station) {
    return of->stations[station].spool > 0 || of->stations[station].ratio != 1.0;
}

double assembly_housing_ratio(const assembly *of, size_t station) {
    const assembly_station *at = &of->stations[station];
    return at->shaft != NO_SHAFT || at->lumped ? at->ratio : 0.0;
}

double assembly_spin(const assembly *of) {
    return copysign(of->speed, of->turn);
}

bool assembly_stands(const assembly *of) {
    return of->speed == 0.0 && !of->phased;
}

// ---------------------------------------------------------------- coordinates

static bool in_plane(const assembly_station *station) {
    return station->moves_x && station->moves_y && !station->hidden;
}

static size_t add_coordinate(assembly *to, double inertia, double unit) {
    to->inertia[to->degrees] = inertia;
    to->unit[to->degrees] = unit;
    return to->degrees++;
}

static double inertia_of(const assembly_station *station) {
    return station->mass + station->fluid;
}

static void add_displacements(assembly *to, assembly_station *station) {
    const double inertia = inertia_of(station);
    if (station->moves_x) station->coordinate[AXIS_X] = add_coordinate(to, inertia, to->length);
    if (station->moves_y) station->coordinate[AXIS_Y] = add_coordinate(to, inertia, to->length);
}

static void add_tilts(assembly *to, assembly_station *station) {
    const double gyration = sqrt(station->diametral / station->mass);
    for (axis along = AXIS_TILT_X; along <= AXIS_TILT_Y; along++)
        station->coordinate[along] = add_coordinate(to, station->diametral, to->length / gyration);
}

static double twist_inertia(const assembly_station *station) {
    return station->polar + station->shaft_polar;
}

/// Returns the station whose coordinate determines the twist of a station, and the ratio of this twist to that
/// coordinate in `share`. Returns NO_STATION for gears in a circle.
static size_t root_of_gears(const assembly *of, size_t station, double *share) {
    *share = 1.0;
    for (size_t steps = 0; of->stations[station].geared_to != NO_STATION; steps++) {
        if (steps == of->station_count) return NO_STATION;
        *share *= of->stations[station].gear;
        station = of->stations[station].geared_to;
    }
    return station;
}

/// Adds the twists: a coordinate for each station that is not geared to another one. Its inertia is that of all
/// stations geared to it.
static whirl_status add_twists(assembly *to) {
    for (size_t s = 0; s < to->station_count; s++)
        if (to->stations[s].twists && to->stations[s].geared_to == NO_STATION)
            to->stations[s].coordinate[AXIS_TWIST] = add_coordinate(to, twist_inertia(&to->stations[s]), to->length);
    for (size_t s = 0; s < to->station_count; s++) {
        assembly_station *at = &to->stations[s];
        double share;
        if (!at->twists || at->geared_to == NO_STATION) continue;
        const size_t root = root_of_gears(to, s, &share);
        if (root == NO_STATION)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "station '%s' is geared to itself by a circle of rigid gears, expected a "
                              "stiffness for one of their meshes",
                              at->name);
        at->coordinate[AXIS_TWIST] = to->stations[root].coordinate[AXIS_TWIST];
        to->inertia[at->coordinate[AXIS_TWIST]] += share * share * twist_inertia(at);
    }
    return whirl_ok();
}

/// Returns the mass that resists axial motion, kg.
static double axial_inertia(const assembly_station *station) {
    return station->mass - station->shaft_mass + station->shaft_axial;
}

/// Adds the axial displacements of stations and of the nodes of shafts.
static void add_axial(assembly *to) {
    for (size_t s = 0; s < to->station_count; s++)
        if (to->stations[s].axial)
            to->stations[s].coordinate[AXIS_AXIAL] = add_coordinate(to, axial_inertia(&to->stations[s]), to->length);
}

static whirl_status check_inertia(const assembly_station *station) {
    // Nodes within a shaft need an inertia of their own.
    if (station->hidden && !(station->mass > 0.0 && station->diametral > 0.0))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "a node of shaft %zu of finite elements has a mass of %.3g kg and a diametral inertia of %.3g "
            "kg m2, expected more than 0: a segment next to it changes its diameter too steeply",
            station->shaft + 1, station->mass, station->diametral);
    // Twists need a polar inertia, and a shaft that twists.
    if (station->shaft != NO_SHAFT && !station->hidden && station->twists && !(station->shaft_polar > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "station '%s' moves: all, and its shaft does not twist, expected the shaft's key twist: yes",
                          station->name);
    if (station->shaft != NO_SHAFT && !station->hidden && station->axial && !(station->shaft_axial > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "station '%s' has axial: yes, and its shaft does not, expected it as a key of the shaft",
                          station->name);
    if (station->geared_to != NO_STATION && !station->twists)
        return whirl_fail(WHIRL_BAD_INPUT, "station '%s' has a gear and does not twist, expected moves: twist or all",
                          station->name);
    if (station->twists && !(twist_inertia(station) > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "station '%s' twists and has no polar inertia, expected its key polar or an element that "
                          "brings one",
                          station->name);
    // Displacements need a mass.
    if (station->moves_x + station->moves_y == 0 && !station->axial) return whirl_ok();
    if (!(station->mass > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "station '%s' has no mass, expected its key mass or an element that brings one",
                          station->name);
    if (station->polar > 0.0 && !(station->diametral > 0.0) && !station->twists)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "station '%s' has a polar inertia and no diametral one, expected both, or neither",
                          station->name);
    return whirl_ok();
}

whirl_status assembly_number(assembly *to, const size_t *order) {
    // Displacements of stations that move along both axes come first, then those of all other stations.
    for (size_t i = 0; i < to->station_count; i++) {
        assembly_station *station = &to->stations[order ? order[i] : i];
        const whirl_status status = check_inertia(station);
        if (status.code != WHIRL_OK) return status;
        for (axis along = AXIS_X; along < AXES; along++) station->coordinate[along] = NO_COORDINATE;
        if (!in_plane(station)) continue;
        station->place = to->plane_count++;
        add_displacements(to, station);
    }
    for (size_t s = 0; s < to->station_count; s++)
        if (!in_plane(&to->stations[s]) && !to->stations[s].hidden) add_displacements(to, &to->stations[s]);
    // Number the twists, then the axial displacements, then the tilts.
    to->first_twist = to->degrees;
    const whirl_status status = add_twists(to);
    if (status.code != WHIRL_OK) return status;
    to->twist_count = to->degrees - to->first_twist;
    to->first_axial = to->degrees;
    add_axial(to);
    to->axial_count = to->degrees - to->first_axial;
    for (size_t s = 0; s < to->station_count; s++) {
        const assembly_station *at = &to->stations[s];
        if (at->diametral > 0.0 && at->moves_x + at->moves_y > 0 && !at->hidden) add_tilts(to, &to->stations[s]);
    }
    // Number the nodes of shafts that are no stations last.
    for (size_t s = 0; s < to->station_count; s++) {
        if (!to->stations[s].hidden) continue;
        add_displacements(to, &to->stations[s]);
        add_tilts(to, &to->stations[s]);
    }
    return whirl_ok();
}

whirl_status assembly_find(const assembly *of, size_t station, axis along, size_t *coordinate) {
    const assembly_station *found = &of->stations[station];
    *coordinate = found->coordinate[along];
    if (*coordinate != NO_COORDINATE) return whirl_ok();
    if (along == AXIS_TILT_X || along == AXIS_TILT_Y)
        return whirl_fail(WHIRL_BAD_INPUT, "needs a station that tilts, and '%s' has no diametral inertia",
                          found->name);
    if (along == AXIS_TWIST)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "needs a station that twists, and '%s' does not, expected moves: twist or all", found->name);
    if (along == AXIS_AXIAL)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "needs a station that moves along its shaft, and '%s' does not, expected axial: yes",
                          found->name);
    return whirl_fail(WHIRL_BAD_INPUT, "needs a station that moves along %s, and '%s' does not",
                      along == AXIS_X ? "x" : "y", found->name);
}

double assembly_share(const assembly *of, size_t station, axis along) {
    double share = 1.0;
    if (along == AXIS_TWIST) root_of_gears(of, station, &share);
    return share;
}

whirl_status assembly_gear(assembly *to, size_t station, size_t other, double ratio) {
    assembly_station *at = &to->stations[station];
    if (at->geared_to != NO_STATION)
        return whirl_fail(WHIRL_BAD_INPUT, "is a second rigid gear of station '%s', expected one", at->name);
    at->geared_to = other;
    at->gear = ratio;
    return whirl_ok();
}

whirl_status assembly_find_plane(const assembly *of, size_t station, size_t port[2]) {
    const whirl_status status = assembly_find(of, station, AXIS_X, &port[0]);
    return status.code == WHIRL_OK ? assembly_find(of, station, AXIS_Y, &port[1]) : status;
}

// ---------------------------------------------------------------- terms

double assembly_inertia(const assembly *of, size_t station) {
    return inertia_of(&of->stations[station]);
}

double assembly_stiffness_scale(const assembly *of, size_t station) {
    return assembly_inertia(of, station) * of->clock * of->clock;
}

double assembly_force_scale(const assembly *of, size_t coordinate) {
    return of->inertia[coordinate] * of->clock * of->clock * of->unit[coordinate];
}

/// Grows a list [count] of items of `size` bytes by one item. Without memory, returns NULL and sets to->no_memory.
static void *assembly_grow(assembly *to, void *list, size_t count, size_t *capacity, size_t size) {
    if (count < *capacity) return list;
    void *longer = realloc(list, (2 * count + 64) * size);
    if (longer)
        *capacity = 2 * count + 64;
    else
        to->no_memory = true;
    return longer;
}

void assembly_term(assembly *to, linear_term term) {
    linear_term *terms = assembly_grow(to, to->terms, to->term_count, &to->term_capacity, sizeof term);
    if (!terms) return;
    to->terms = terms;
    to->terms[to->term_count++] = term;
}

void assembly_stiffness(assembly *to, size_t row, size_t by, double stiffness) {
    if (row == NO_COORDINATE || by == NO_COORDINATE) return;
    const double scale = assembly_force_scale(to, row) / to->unit[by];
    assembly_term(to, (linear_term){row, SOURCE_PLACE, by, -stiffness / scale});
}

void assembly_damping(assembly *to, size_t row, size_t by, double damping) {
    if (row == NO_COORDINATE || by == NO_COORDINATE) return;
    const double scale = assembly_force_scale(to, row) / to->unit[by];
    assembly_term(to, (linear_term){row, SOURCE_VELOCITY, by, -damping * to->clock / scale});
}

void assembly_spring(assembly *to, size_t one, size_t other, double stiffness) {
    assembly_stiffness(to, one, one, stiffness);
    assembly_stiffness(to, one, other, -stiffness);
    assembly_stiffness(to, other, one, -stiffness);
    assembly_stiffness(to, other, other, stiffness);
}

void assembly_damper(assembly *to, size_t one, size_t other, double damping) {
    assembly_damping(to, one, one, damping);
    assembly_damping(to, one, other, -damping);
    assembly_damping(to, other, one, -damping);
    assembly_damping(to, other, other, damping);
}

void assembly_inertance(assembly *to, size_t row, size_t by, double mass) {
    if (row == NO_COORDINATE || by == NO_COORDINATE || mass == 0.0) return;
    mass_term *masses = assembly_grow(to, to->masses, to->mass_count, &to->mass_capacity, sizeof *masses);
    if (!masses) return;
    to->masses = masses;
    to->masses[to->mass_count++] = (mass_term){row, by, mass};
}

void assembly_inerter(assembly *to, size_t one, size_t other, double mass) {
    assembly_inertance(to, one, one, mass);
    assembly_inertance(to, one, other, -mass);
    assembly_inertance(to, other, other, mass);
}

static bool is_twist(const assembly *of, size_t coordinate) {
    return coordinate != NO_COORDINATE && coordinate - of->first_twist < of->twist_count;
}

/// Notes a spring between two twists, or between a twist and the ground.
static void note_link(assembly *to, const size_t coordinate[2], const double share[2], const joining *by) {
    const bool twists[] = {is_twist(to, coordinate[0]), is_twist(to, coordinate[1])};
    if (twists[0] != twists[1] && by->stiffness != 0.0) to->grounded = true;
    if (!twists[0] && !twists[1]) return;
    if (twists[0] != twists[1] && by->stiffness == 0.0 && by->damping == 0.0 && by->inertance == 0.0) return;
    if (twists[0] != twists[1] && coordinate[twists[0]] != NO_COORDINATE) return;
    const size_t first = twists[0] ? 0 : 1; // the ground is the second of the two
    const twist_link own = {{coordinate[first], coordinate[1 - first]},
                            {share[first], share[1 - first]},
                            by->stiffness,
                            by->damping,
                            by->inertance,
                            by->modulus};
    if (twists[0] && twists[1]) {
        twist_link *list = assembly_grow(to, to->links, to->link_count, &to->link_capacity, sizeof *list);
        if (list) to->links = list, to->links[to->link_count++] = own;
    } else {
        twist_link *list = assembly_grow(to, to->holds, to->hold_count, &to->hold_capacity, sizeof *list);
        if (list) to->holds = list, to->holds[to->hold_count++] = own;
    }
}

void assembly_join(assembly *to, const size_t coordinate[2], const double share[2], const joining *by) {
    const double moved[2] = {share[0], 0.0 - share[1]};
    note_link(to, coordinate, share, by);
    for (size_t i = 0; i < 2; i++)
        for (size_t j = 0; j < 2; j++) {
            const double both = moved[i] * moved[j];
            assembly_stiffness(to, coordinate[i], coordinate[j], both * by->stiffness);
            assembly_damping(to, coordinate[i], coordinate[j], both * by->damping);
            // assembly_inertance fills in both triangles of the mass matrix: call it once for each pair of different
            // coordinates.
            if (i <= j || coordinate[0] == coordinate[1])
                assembly_inertance(to, coordinate[i], coordinate[j], both * by->inertance);
        }
}

void assembly_link(assembly *to, axis along, size_t one, size_t other, const joining *by) {
    const size_t station[2] = {one, other};
    size_t coordinate[2] = {NO_COORDINATE, NO_COORDINATE};
    double share[2] = {1.0, 1.0};
    for (size_t i = 0; i < 2; i++) {
        if (station[i] == NO_STATION) continue;
        coordinate[i] = to->stations[station[i]].coordinate[along];
        share[i] = assembly_share(to, station[i], along);
    }
    assembly_join(to, coordinate, share, by);
}

void assembly_harmonic(assembly *to, const harmonic_torque *torque) {
    harmonic_torque *list = assembly_grow(to, to->harmonics, to->harmonic_count, &to->harmonic_capacity, sizeof *list);
    if (!list) return;
    to->harmonics = list;
    to->harmonics[to->harmonic_count++] = *torque;
}

void assembly_fatigue(assembly *to, const twist_fatigue *curve) {
    twist_fatigue *list = assembly_grow(to, to->fatigues, to->fatigue_count, &to->fatigue_capacity, sizeof *list);
    if (!list) return;
    to->fatigues = list;
    to->fatigues[to->fatigue_count++] = *curve;
}

whirl_status assembly_turns(const assembly *of, size_t station) {
    if (station == NO_STATION || of->stations[station].twists || of->stations[station].spool ||
        of->stations[station].ratio == 1.0)
        return whirl_ok();
    return whirl_fail(
        WHIRL_BAD_INPUT,
        "acts on '%s', whose shaft turns at %g times the speed of the rotor and does not twist, expected a "
        "station of the rotor's own speed, or a shaft with twist: yes",
        of->stations[station].name, of->stations[station].ratio);
}

whirl_status assembly_torque(assembly *to, const shaft_torque *torque) {
    const whirl_status status = assembly_turns(to, torque->station);
    if (status.code != WHIRL_OK) return status;
    if (!to->torques) to->torques = calloc(MAX_TORQUES, sizeof *to->torques);
    if (!to->torques) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the torques of a rotor");
    if (to->torque_count == MAX_TORQUES)
        return whirl_fail(WHIRL_BAD_INPUT, "is one torque too many, expected at most %d", MAX_TORQUES);
    to->torques[to->torque_count++] = *torque;
    return whirl_ok();
}

void assembly_forcing(assembly *to, size_t row, size_t value, double force) {
    if (row == NO_COORDINATE) return;
    const double share = assembly_stands(to) ? 0.0 : force / assembly_force_scale(to, row);
    assembly_term(to, (linear_term){row, SOURCE_FORCING, value, share});
}

void assembly_turning(assembly *to, size_t x, size_t y, double force, double angle) {
    assembly_forcing(to, x, COS_TAU, force * cos(angle));
    assembly_forcing(to, x, SIN_TAU, -force * sin(angle));
    assembly_forcing(to, y, COS_TAU, force * sin(angle));
    assembly_forcing(to, y, SIN_TAU, force * cos(angle));
}

/// Appends an item to a list of forces on rows.
static void add_load(assembly *to, turning_inertia **loads, size_t *count, size_t *capacity, turning_inertia one) {
    if (one.row == NO_COORDINATE) return;
    turning_inertia *list = assembly_grow(to, *loads, *count, capacity, sizeof *list);
    if (!list) return;
    *loads = list;
    list[(*count)++] = one;
}

void assembly_inertial(assembly *to, size_t x, size_t y, double moment, double angle) {
    if (moment == 0.0) return;
    const turning_inertia rows[] = {{x, moment * cos(angle), -moment * sin(angle)},
                                    {y, moment * sin(angle), moment * cos(angle)}};
    for (size_t i = 0; i < 2; i++) add_load(to, &to->turnings, &to->turning_count, &to->turning_capacity, rows[i]);
}

/// Notes the parts of an unbalance along directions in which its station does not move. The weight of the unbalance
/// exerts a torque on the shaft there as well.
static void assembly_guide(assembly *to, const size_t *coordinate, double moment, double angle) {
    if (coordinate[AXIS_X] == NO_COORDINATE) {
        to->guided[0].cos += moment * cos(angle);
        to->guided[0].sin -= moment * sin(angle);
    }
    if (coordinate[AXIS_Y] == NO_COORDINATE) {
        to->guided[1].cos += moment * sin(angle);
        to->guided[1].sin += moment * cos(angle);
    }
}

void assembly_gyroscopic(assembly *to, size_t station, double polar) {
    const size_t *at = to->stations[station].coordinate, x = at[AXIS_TILT_X], y = at[AXIS_TILT_Y];
    if (to->stations[station].shaft != NO_SHAFT && to->stations[station].spool) {
        double turned = polar;
        const int value = assembly_spool_value(to, to->stations[station].spool, &turned);
        const body_kind gyroscopic = {BODY_VELOCITY, RATE_DAMPING, value};
        body_add(&to->body, x, y, gyroscopic, -turned);
        body_add(&to->body, y, x, gyroscopic, turned);
        return;
    }
    if (to->stations[station].shaft != NO_SHAFT) {
        const double turned = polar * to->stations[station].ratio;
        const body_kind gyroscopic = {BODY_VELOCITY, RATE_GYRO, BODY_STEADY};
        body_add(&to->body, x, y, gyroscopic, -turned);
        body_add(&to->body, y, x, gyroscopic, turned);
        return;
    }
    const assembly_station *own = &to->stations[station];
    const double spin = own->spool ? assembly_spool_spin(to, own->spool) : own->ratio * assembly_spin(to);
    assembly_damping(to, x, y, polar * spin);
    assembly_damping(to, y, x, -polar * spin);
}

void assembly_unbalance(assembly *to, size_t station, double moment, double angle) {
    const assembly_station *at = &to->stations[station];
    if (to->balanced) return;
    if (assembly_is_aside(to, station) && moment != 0.0) to->aside = at->name;
    assembly_inertial(to, at->coordinate[AXIS_X], at->coordinate[AXIS_Y], moment, angle);
    assembly_guide(to, at->coordinate, moment, angle);
    if (!in_plane(at) || to->phased) {
        assembly_turning(to, at->coordinate[AXIS_X], at->coordinate[AXIS_Y], moment * to->speed * to->speed, angle);
        return;
    }
    const double acceleration = assembly_stands(to) ? 0.0 : moment / (inertia_of(at) * to->length);
    to->numbers[at->place][STATION_UNBALANCE_COS] += acceleration * cos(angle);
    to->numbers[at->place][STATION_UNBALANCE_SIN] += acceleration * sin(angle);
}

void assembly_eccentric(assembly *to, size_t station, double moment, double angle, bool given) {
    if (!assembly_is_aside(to, station)) {
        assembly_unbalance(to, station, moment, angle);
        return;
    }
    if (to->balanced || !given) return;
    aside_unbalance *list = assembly_grow(to, to->asides, to->aside_count, &to->aside_capacity, sizeof *list);
    if (!list) return;
    to->asides = list;
    to->asides[to->aside_count++] = (aside_unbalance){station, moment, angle};
}

void assembly_runout(assembly *to, size_t station, whirl_runout seen) {
    station_runout *list = assembly_grow(to, to->runouts, to->runout_count, &to->runout_capacity, sizeof *list);
    if (!list) return;
    to->runouts = list;
    to->runouts[to->runout_count++] = (station_runout){station, seen};
}

/// Returns the force on a station by gravity of 1 m/s2: kg along a displacement, kg m on a tilt.
static double weight_along(const assembly_station *at, axis along) {
    const bool tilts = along == AXIS_TILT_X || along == AXIS_TILT_Y;
    return !tilts ? at->mass : at->shaft != NO_SHAFT ? at->pull_moment : 0.0;
}

static bool is_along_y(axis along) {
    return along == AXIS_Y || along == AXIS_TILT_Y;
}

/// Adds the weight of a shaft at a node. It does not include the weight of the design's stations.
static void pull_node(assembly *to, const assembly_station *at, double x, double y) {
    for (axis along = at->hidden ? AXIS_X : AXIS_TILT_X; along <= AXIS_TILT_Y; along++)
        body_add(&to->body, at->coordinate[along], 0, (body_kind){BODY_ONE, RATE_STATIC, BODY_STEADY},
                 (is_along_y(along) ? y : x) * weight_along(at, along));
}

static int assembly_by_size(const void *a, const void *b) {
    const double *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

whirl_status assembly_frequencies(assembly *to, size_t count, const double *frequencies) {
    const size_t before = to->frequency_count;
    // Find the range that both tables cover.
    double low = frequencies[0], high = frequencies[count - 1];
    if (before > 0) {
        low = fmax(low, to->frequencies[0]);
        high = fmin(high, to->frequencies[before - 1]);
    }
    if (!(low < high))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "is known at frequencies of whirl from %g to %g rad/s, and another table from %g to %g rad/s, "
            "expected tables with frequencies in common",
            frequencies[0], frequencies[count - 1], to->frequencies[0], to->frequencies[before - 1]);
    // Merge the frequencies, each once.
    double *all = realloc(to->frequencies, (before + count) * sizeof *all);
    if (!all) return whirl_fail(WHIRL_NO_MEMORY, "no memory for frequencies of whirl");
    memcpy(all + before, frequencies, count * sizeof *all);
    qsort(all, before + count, sizeof *all, assembly_by_size);
    to->frequencies = all;
    to->frequency_count = 0;
    for (size_t i = 0; i < before + count; i++)
        if (all[i] >= low && all[i] <= high && (to->frequency_count == 0 || all[i] > all[to->frequency_count - 1]))
            all[to->frequency_count++] = all[i];
    return whirl_ok();
}

void assembly_pull(assembly *to, double x, double y) {
    const double scale = to->clock * to->clock * to->length;
    to->pull[0] += x;
    to->pull[1] += y;
    for (size_t s = 0; s < to->station_count; s++) {
        const assembly_station *at = &to->stations[s];
        if (at->shaft != NO_SHAFT) pull_node(to, at, x, y);
        if (at->hidden) continue;
        const double part = at->mass / inertia_of(at), pull_x = x / scale * part, pull_y = y / scale * part;
        if (in_plane(at)) {
            to->numbers[at->place][STATION_PULL_X] += pull_x;
            to->numbers[at->place][STATION_PULL_Y] += pull_y;
        } else {
            if (at->moves_x) assembly_term(to, (linear_term){at->coordinate[AXIS_X], SOURCE_ONE, 0, pull_x});
            if (at->moves_y) assembly_term(to, (linear_term){at->coordinate[AXIS_Y], SOURCE_ONE, 0, pull_y});
        }
    }
}

void assembly_pull_axially(assembly *to, size_t shaft, double pull) {
    const double scaled = pull / (to->clock * to->clock * to->length);
    for (size_t s = 0; s < to->station_count; s++) {
        const assembly_station *at = &to->stations[s];
        if (at->coordinate[AXIS_AXIAL] == NO_COORDINATE || (shaft != NO_SHAFT && at->shaft != shaft)) continue;
        assembly_term(to, (linear_term){at->coordinate[AXIS_AXIAL], SOURCE_ONE, 0, scaled});
    }
}

void assembly_weigh(assembly *to) {
    for (size_t s = 0; s < to->station_count; s++) {
        const assembly_station *at = &to->stations[s];
        for (axis along = AXIS_X; along <= AXIS_TILT_Y; along++) {
            const double force = weight_along(at, along);
            if (force == 0.0) continue;
            const turning_inertia own = {at->coordinate[along], is_along_y(along) ? 0.0 : force,
                                         is_along_y(along) ? force : 0.0};
            add_load(to, &to->weights, &to->weight_count, &to->weight_capacity, own);
        }
    }
}

void assembly_ground_damping(assembly *to, size_t station, double damping) {
    const assembly_station *at = &to->stations[station];
    if (in_plane(at)) {
        to->numbers[at->place][STATION_DAMPING] += damping / (inertia_of(at) * to->clock);
        return;
    }
    assembly_damper(to, at->coordinate[AXIS_X], NO_COORDINATE, damping);
    assembly_damper(to, at->coordinate[AXIS_Y], NO_COORDINATE, damping);
}

static int compare_terms(const void *one, const void *other) {
    const linear_term *a = one, *b = other;
    if (a->row != b->row) return a->row < b->row ? -1 : 1;
    if (a->source != b->source) return a->source < b->source ? -1 : 1;
    if (a->column != b->column) return a->column < b->column ? -1 : 1;
    // Sort equal terms by size, so that the sum does not depend on the order in which elements are listed.
    return a->number < b->number ? -1 : a->number > b->number;
}

bool assembly_finish(assembly *to) {
    size_t kept = 0;
    if (to->no_memory || !body_finish(&to->body)) return false;
    if (to->term_count > 0) qsort(to->terms, to->term_count, sizeof *to->terms, compare_terms);
    for (size_t i = 0; i < to->term_count; i++) {
        const linear_term *term = &to->terms[i];
        linear_term *last = kept > 0 ? &to->terms[kept - 1] : NULL;
        if (last && last->row == term->row && last->source == term->source && last->column == term->column)
            last->number += term->number;
        else
            to->terms[kept++] = *term;
    }
    to->term_count = kept;
    return true;
}
