// Machines whose speed changes, in vector lanes: their numbers, and which of them have one structure.
#include "running_rotor.h"

#include <stdlib.h>
#include <string.h>

bool running_goes_in_lanes(const running_rotor *r) {
    const whirl_rotor *rotor = r->rotor;
    const whirl_run_course *course = r->how.course;
    // Torques by tables and formulas, and those of stations that twist, are computed for one machine at a time.
    if (r->shown.in_time || r->own > 0 || r->geared_count > 0 || r->splines) return false;
    if (r->driven && rotor->drive.count > 0) return false;
    for (int formula = 0; course && formula < WHIRL_FORMULA_EVENT; formula++)
        if (course->has[formula]) return false;
    // So are the drag of films, and states that stand for derivatives.
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element_type *type = rotor->elements[i].type;
        if (r->driven && type->drag && !r->how.dragless) return false;
        if (type->paced && rotor->elements[i].states > 0) return false;
    }
    return true;
}

// ---------------------------------------------------------------- numbers

static void running_put_factors(const running_rotor *r, double *out) {
    for (size_t i = 0; i < r->varying_count; i++)
        for (size_t k = 0; k < POWERS; k++)
            if (r->varying[i].power[k] != 0.0) *out++ = r->varying[i].power[k];
}

static void running_put_shaft(const running_rotor *r, double *out) {
    const whirl_rotor *rotor = r->rotor;
    const shaft_drive *drive = &rotor->drive;
    const turning_inertia *guided = r->how.lost ? r->lost_guided : rotor->guided;
    const double square = r->unit * r->unit;
    const bool motor = drive->given && !r->how.tripped;
    out[SHAFT_UNIT] = r->unit;
    out[SHAFT_SQUARE] = square;
    out[SHAFT_RATE] = r->how.driven ? 0.0 : r->how.rate / square;
    out[SHAFT_DRIVEN] = r->how.driven ? 1.0 : 0.0;
    out[SHAFT_MOTOR] = motor ? drive->torque : 0.0;
    out[SHAFT_FALL] = motor && drive->no_load > 0.0 ? drive->torque / drive->no_load : 0.0;
    out[SHAFT_LOAD] = drive->given ? drive->load : 0.0;
    out[SHAFT_LINEAR] = drive->given ? drive->linear : 0.0;
    out[SHAFT_QUADRATIC] = drive->given ? drive->quadratic : 0.0;
    // A shaft without an inertia turns at a given rate; the quotient by the inertia is then discarded.
    out[SHAFT_INERTIA] = r->turn_inertia + (r->how.lost ? r->lost_inertia : r->own_inertia);
    if (!r->driven) out[SHAFT_INERTIA] = 1.0;
    for (size_t way = 0; way < 2; way++) {
        out[SHAFT_PULL + way] = rotor->pull[way] / square;
        out[SHAFT_GUIDED + 2 * way] = guided[way].cos;
        out[SHAFT_GUIDED + 2 * way + 1] = guided[way].sin;
    }
}

static void running_put_lever(const running_rotor *r, size_t i, double *out) {
    const double lost = r->how.lost ? 1.0 : 0.0;
    out[LEVER_UNIT] = r->rotor->unit[i];
    out[LEVER_COS] = r->own_cos[i] + lost * r->lost_cos[i];
    out[LEVER_SIN] = r->own_sin[i] + lost * r->lost_sin[i];
    out[LEVER_FORCE_COS] = r->force_cos[i] + lost * r->lost_force_cos[i];
    out[LEVER_FORCE_SIN] = r->force_sin[i] + lost * r->lost_force_sin[i];
    out[LEVER_LOST_COS] = lost * r->lost_cos[i];
    out[LEVER_LOST_SIN] = lost * r->lost_sin[i];
}

static void running_lane_numbers(const void *model, double *out) {
    const running_rotor *r = model;
    memset(out, 0, r->form.number_count * sizeof *out);
    memcpy(out, r->rotor->numbers, r->rotor->lanes.number_count * sizeof *out);
    if (!r->splines) running_put_factors(r, out + r->lanes.powers);
    running_put_shaft(r, out + r->lanes.shaft);
    for (size_t j = 0; j < r->lanes.lever_count; j++)
        running_put_lever(r, r->lanes.lever[j], out + r->lanes.levers + j * LEVER_NUMBERS);
}

static size_t running_lane_part(const void *model, size_t *places) {
    (void)places;
    return ((const running_rotor *)model)->form.number_count;
}

// ---------------------------------------------------------------- structure

static bool running_lane_alike(const void *one, const void *other) {
    const running_rotor *a = one, *b = other;
    const running_lanes *x = &a->lanes, *y = &b->lanes;
    if (a->driven != b->driven || a->rotor->way != b->rotor->way || x->factor_count != y->factor_count ||
        a->form.number_count != b->form.number_count || x->lever_count != y->lever_count ||
        !a->rotor->lanes.alike(a->rotor, b->rotor))
        return false;
    for (size_t i = 0; i < x->factor_count; i++)
        if (x->factors[i].number != y->factors[i].number || x->factors[i].power != y->factors[i].power) return false;
    return memcmp(x->lever, y->lever, x->lever_count * sizeof *x->lever) == 0 &&
           memcmp(a->along, b->along, a->rotor->lanes.degrees) == 0;
}

/// Marks what slopes depend on: the rotor's slopes on what they depend on at a constant speed, on their velocities and
/// on the speed; with torques, all slopes on all coordinates.
static void running_lane_depends(const void *model, bool *table) {
    const running_rotor *r = model;
    const whirl_rotor *rotor = r->rotor;
    const size_t degrees = rotor->lanes.degrees, rows = degrees + rotor->lanes.states, own = degrees + rows;
    const size_t width = r->form.degrees + r->form.degrees + r->form.states, speed = r->at_speed;
    if (r->driven) {
        for (size_t i = 0; i < (width - degrees) * width; i++) table[i] = true;
        return;
    }
    // The rotor fills a narrower table, which is spread from its end on.
    rotor->lanes.depends(rotor, table);
    for (size_t i = rows; i-- > 0;) {
        bool *row = table + i * width;
        memmove(row, table + i * own, own * sizeof *row);
        memset(row + own, 0, (width - own) * sizeof *row);
        row[speed] = true;
        if (i < degrees) row[degrees + i] = true;
    }
    for (size_t i = rows; i < width - degrees; i++) {
        memset(table + i * width, 0, width * sizeof *table);
        table[i * width + speed] = true;
    }
}

/// Lists the coordinates on which unbalances of the machine, or those that appear in a run, act.
static void running_find_lever_rows(running_rotor *r) {
    const size_t degrees = r->rotor->lanes.degrees;
    for (size_t i = 0; i < degrees; i++) {
        const bool own =
            r->own_cos[i] != 0.0 || r->own_sin[i] != 0.0 || r->force_cos[i] != 0.0 || r->force_sin[i] != 0.0;
        // With masses that couple, an unbalance accelerates other coordinates, too.
        if (own || r->along[i] < 2 || r->rotor->coupled.count > 0) r->lanes.lever[r->lanes.lever_count++] = i;
    }
}

bool running_lanes_fill(running_rotor *r) {
    static lanes_flow *const flow[VECTOR_ISAS] = EVERY_ISA(, running_flow);
    static lanes_switches *const switches[VECTOR_ISAS] = EVERY_ISA(, running_switches);
    static lanes_forcing *const forcing[VECTOR_ISAS] = EVERY_ISA(, running_forcing);
    static const size_t none[1] = {0};
    const whirl_rotor *rotor = r->rotor;
    running_lanes *own = &r->lanes;
    own->lever = calloc(rotor->lanes.degrees + 1, sizeof *own->lever);
    own->factors = calloc(POWERS * r->varying_count + 1, sizeof *own->factors);
    if (!own->lever || !own->factors) return false;
    // Lay out the numbers. Machines with splines do not run in lanes.
    for (size_t i = 0; i < r->varying_count && !r->splines; i++) {
        bool begins = true;
        for (size_t k = 0; k < POWERS; k++) {
            if (r->varying[i].power[k] == 0.0) continue;
            own->factors[own->factor_count++] = (running_factor){r->varying[i].index, k, begins};
            begins = false;
        }
    }
    running_find_lever_rows(r);
    own->powers = rotor->lanes.number_count;
    own->shaft = own->powers + own->factor_count;
    own->levers = own->shaft + SHAFT_NUMBERS;
    own->now = own->levers + own->lever_count * LEVER_NUMBERS;
    own->contacts = own->now + own->lever_count;
    own->switches = own->contacts + 3 * rotor->contact_count;
    own->nearby = own->switches + 2 * rotor->lanes.switch_count;
    // Describe the system: states of the shaft follow those of the rotor.
    r->form = (whirl_lanes){.degrees = rotor->lanes.degrees,
                            .states = r->at_speed + 2 - 2 * rotor->lanes.degrees,
                            .number_count = own->nearby + rotor->lanes.degrees + rotor->lanes.states,
                            .numbers = running_lane_numbers,
                            .alike = running_lane_alike,
                            .places = none,
                            .part = running_lane_part,
                            .depends = running_lane_depends,
                            .switch_count = rotor->lanes.switch_count,
                            .group_count = rotor->lanes.group_count,
                            .groups = rotor->lanes.groups,
                            .modulated = r->driven || rotor->lanes.modulated,
                            .slides = rotor->lanes.slides,
                            .jumps = rotor->lanes.jumps,
                            .flow = flow,
                            .switches = switches,
                            .forcing = forcing};
    return true;
}

void running_lanes_free(running_rotor *r) {
    free(r->lanes.lever);
    free(r->lanes.factors);
}
