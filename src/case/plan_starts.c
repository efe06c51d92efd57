// The initial states of the points of a study.
#include "plan.h"
#include "schema.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "problem.h"

/// Returns the scale of a coordinate of a state in SI: the length scale; for velocities the length scale times the
/// clock.
static double state_scale(const whirl_rotor *rotor, const char *key) {
    const double length = whirl_rotor_length_scale(rotor);
    return key[0] == 'v' ? length * whirl_rotor_clock(rotor) : length;
}

/// Returns a number of a state in the scales of the machine.
static double scaled_setting(const whirl_rotor *rotor, valuation *v, const setting *given) {
    double number = NAN;
    valuation_number(v, &given->value, &number);
    return given->scaled ? number / state_scale(rotor, given->key->name) : number;
}

static double state_number(const whirl_rotor *rotor, valuation *v, const setting_list *state, const char *key) {
    const setting *given = settings_find(state, key);
    return given ? scaled_setting(rotor, v, given) : settings_number(v, state, key);
}

/// Returns a coordinate of a station that an initial state may give, by index from 0; NULL past the last.
static const whirl_member *coordinate_at(size_t index) {
    for (const whirl_member *member = whirl_probe_members(); member->part; member++)
        if (strcmp(member->part, schema_initial.name) == 0 && index-- == 0) return member;
    return NULL;
}

static whirl_status initial_state(const study_plan *plan, valuation *v, const whirl_rotor *rotor, double *state) {
    const whirl_system *system = whirl_rotor_system(rotor);
    const whirl_member *coordinate;
    for (size_t i = 0; i < plan->start_count; i++) {
        const plan_start *start = &plan->starts[i];
        for (size_t k = 0; (coordinate = coordinate_at(k)) != NULL; k++) {
            double *at = &state[(size_t)whirl_member_number(coordinate, &system->probes[start->station])];
            // A station that moves along one axis has one coordinate for both.
            *at += state_number(rotor, v, &start->state, coordinate->key.name);
            if (isfinite(*at)) continue;
            return whirl_fail(WHIRL_BAD_INPUT, "the initial %s of station %.63s has no finite value",
                              coordinate->key.name, start->state.place->key);
        }
    }
    return whirl_ok();
}

/// Returns the position in a range, from 0 to 1, of further start number `start` (from 1); `which` numbers all ranges.
/// *rest is the grid index in this and the following ranges; the first range varies fastest.
static double place_in_range(const plan_range *range, size_t k, size_t start, size_t which, size_t *rest) {
    if (!range->points) return whirl_halton(start, which);
    const size_t count = range->points[k], at = *rest % count;
    *rest /= count;
    return count > 1 ? (double)at / (double)(count - 1) : 0.5;
}

/// Sets the coordinates that the ranges name to those of a further start, from 1.
static whirl_status start_in_ranges(const study_plan *plan, size_t start, valuation *v, const whirl_rotor *rotor,
                                    double *state) {
    const whirl_system *system = whirl_rotor_system(rotor);
    size_t which = 0, rest = start - 1;
    for (size_t i = 0; i < plan->range_count; i++) {
        const plan_range *range = &plan->ranges[i];
        for (size_t k = 0; k < range->low.count; k++, which++) {
            const setting *one = &range->low.items[k];
            const double low = scaled_setting(rotor, v, one), high = scaled_setting(rotor, v, &range->high.items[k]);
            const whirl_member *coordinate = whirl_member_find(whirl_probe_members(), one->key->name);
            const double at = low + place_in_range(range, k, start, which, &rest) * (high - low);
            if (!coordinate || !isfinite(at))
                return whirl_fail(WHIRL_BAD_INPUT, "the range of %s of station %.63s has no finite value",
                                  one->key->name, range->low.place->key);
            state[(size_t)whirl_member_number(coordinate, &system->probes[range->station])] = at;
        }
    }
    return whirl_ok();
}

whirl_status plan_start_state(const study_plan *plan, size_t batch, size_t start, valuation *v,
                              const whirl_rotor *rotor, double *state) {
    memset(state, 0, whirl_rotor_system(rotor)->dimension * sizeof *state);
    const bool rest = batch < plan->batch_count && plan->origins[batch].rest;
    whirl_status status = rest ? whirl_ok() : initial_state(plan, v, rotor, state);
    if (status.code == WHIRL_OK && start > 0) status = start_in_ranges(plan, start, v, rotor, state);
    whirl_rotor_complete(rotor, state);
    return status;
}

/// Returns the axes along which a station with this key `moves` has displacements and velocities; a twist alone counts
/// as along x.
static const char *axes_of(const char *moves) {
    return strcmp(moves, "twist") == 0 ? "x" : strcmp(moves, "all") == 0 ? "xy" : moves;
}

/// Refuses places and velocities along an axis that the station does not move along.
static void check_axes(case_reader *reader, const machine_parts *machine, size_t station, const setting_list *state) {
    const setting *moves = settings_find(&machine->stations.items[station], "moves");
    const whirl_member *coordinate;
    for (size_t k = 0; moves && moves->word && (coordinate = coordinate_at(k)) != NULL; k++) {
        const char *key = coordinate->key.name, *axis = key + strlen(key) - 1;
        const setting *given = settings_find(state, key);
        if (given && !strstr(axes_of(moves->word), axis) && reader_reports(reader, key, state->place->key))
            problem_at_key(reader->problems, given->place, "moves along %s alone, expected no %s", moves->word, key);
    }
}

/// Refuses ends of ranges in wrong order, and starts outside of a bearing.
static void check_range(case_reader *reader, valuation *v, const machine_parts *machine, const whirl_rotor *rotor,
                        const plan_range *range, const setting_list *initial) {
    const double clearance = whirl_rotor_system(rotor)->probes[range->station].clearance;
    double radius = 0.0; // of the coordinates of the initial state, then of the furthest corner
    for (int k = 0; k < 2; k++)
        if (initial && !settings_find(&range->low, k ? "y" : "x"))
            radius = hypot(radius, state_number(rotor, v, initial, k ? "y" : "x"));
    check_axes(reader, machine, range->station, &range->low);
    for (size_t k = 0; k < range->low.count; k++) {
        const setting *one = &range->low.items[k], *other = &range->high.items[k];
        const double low = scaled_setting(rotor, v, one), high = scaled_setting(rotor, v, other);
        if (one->key->name[0] != 'v') radius = hypot(radius, fmax(fabs(low), fabs(high)));
        if (low < high || !reader_reports(reader, one->key->name, range->low.place->key)) continue;
        problem_at(reader->problems, other->place, "is %.10g after %.10g, expected the lower end first", high, low);
    }
    if (clearance > 0 && radius >= clearance && reader_reports(reader, "range", range->low.place->key))
        problem_at_key(reader->problems, range->low.place,
                       "starts up to %.4g clearances from the centre of its bearing, expected less than 1",
                       radius / clearance);
}

void plan_check_start(case_reader *reader, const study_plan *plan, size_t batch, valuation *v,
                      const machine_parts *machine, const whirl_rotor *rotor) {
    const whirl_system *const system = whirl_rotor_system(rotor);
    for (size_t i = 0; i < plan->start_count && !plan->origins[batch].rest; i++) {
        const plan_start *start = &plan->starts[i];
        check_axes(reader, machine, start->station, &start->state);
        const double clearance = system->probes[start->station].clearance;
        const double radius =
            hypot(state_number(rotor, v, &start->state, "x"), state_number(rotor, v, &start->state, "y"));
        if (clearance <= 0 || radius < clearance || !reader_reports(reader, "start", start->state.place->key)) continue;
        problem_at_key(reader->problems, start->state.place,
                       "starts %.4g clearances from the centre of its bearing, expected less than 1",
                       radius / clearance);
    }
    for (size_t i = 0; i < plan->range_count && plan->batches[batch].starts > 1; i++) {
        const setting_list *initial = NULL;
        for (size_t k = 0; k < plan->start_count && !plan->origins[batch].rest; k++)
            if (plan->starts[k].station == plan->ranges[i].station) initial = &plan->starts[k].state;
        check_range(reader, v, machine, rotor, &plan->ranges[i], initial);
    }
}
