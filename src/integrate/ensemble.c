// Ensembles: lanes of machines in one block of memory, and the kernel that carries them.
#include "whirl/engine/ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "adaptive_lanes.h"
#include "ensemble_alone.h"
#include "isa.h"
#include "method.h"
#include "rk4_lanes.h"
#include "turns.h"
#include "vector.h"
#include "watch.h"

rk4_lanes_revolve *const rk4_lanes_revolves[VECTOR_ISAS] = EVERY_ISA(, rk4_lanes);

struct whirl_ensemble {
    const whirl_system *system; ///< first machine, which defines the structure
    const isa *isa;
    size_t lane_count, contact_count;
    size_t row_count; ///< rows of the block
    double limit;
    rk4_lanes lanes;
    adaptive_lanes *adaptive;  ///< NULL for rk4
    stepper *stepper;          ///< takes steps near switches; NULL: not needed
    whirl_perturbations along; ///< perturbations of the stepper
    double *work;              ///< workspace of the stepper
    /// [lane_count][2] beginning and end of the part of the period over which each lane is carried; NULL: whole periods
    double *parts;
    alone_lanes *alone; ///< lanes that integrators carry; NULL: kernels carry all lanes
    double *ended;      ///< [lane] whirl_motion
    /// [dimension][lane_count] sample at which the observer looks, whose states whirl_ensemble_coordinate returns;
    /// NULL: the present states
    const double *shown;
    const whirl_system **machines; ///< [lane_count] machine of every lane; NULL: empty
    whirl_perturbations **beside;  ///< [lane_count] perturbations carried in the next revolution; NULL: none
    size_t *contact_probe;
    size_t *order;           ///< [lane_count] order in which adaptive methods take the lanes
    double *state;           ///< [dimension] workspace
    double *forcing, *block; ///< block: all arrays of lanes, aligned to 64 bytes
};

/// Returns true if contact is decided by normal forces, not by the gap alone.
static bool by_force(const whirl_ensemble *e) {
    return e->alone || e->lanes.observe.by_force;
}

bool whirl_ensemble_takes(const whirl_system *system, const whirl_integrate_options *options) {
    if (!system->lanes) return false;
    if (adaptive_in_lanes(options)) return true;
    return strcmp(options->method, "rk4") == 0 && !(options->located && system->lanes->slides);
}

/// Maximum number of perturbations. Memory grows with the square of the dimension, and with the number of lanes.
enum { MAX_PERTURBATIONS = 256 };

bool whirl_ensemble_follows(const whirl_system *system, const whirl_integrate_options *options) {
    return whirl_ensemble_takes(system, options) && !adaptive_in_lanes(options) && !options->located &&
           !system->lanes->jumps && !system->lanes->slides && system->dimension <= MAX_PERTURBATIONS;
}

/// Lays out the arrays in a block of rows. Returns the number of rows.
static size_t ensemble_lay_out(whirl_ensemble *e, double *block) {
    const size_t degrees = e->lanes.degrees, probes = whirl_watched_probes(e->system), contacts = e->contact_count;
    const size_t forces = e->alone || e->lanes.observe.contacts ? contacts : 0;
    const size_t rates = e->lanes.rates, fixed = e->adaptive || e->alone ? 0 : 1,
                 located = e->lanes.located.switches ? 1 : 0;
    const size_t switches = e->lanes.located.switch_count, followed = e->lanes.perturbations;
    const size_t sets = 1 + followed, some = followed > 0 ? 1 : 0;
    size_t row = 0;
#define PART(array, extent, columns, ...)                                                                              \
    {&e->lanes.observe.array, WHIRL_WATCHED_SIZE(extent, columns, probes, contacts)},
    const struct {
        double **array;
        size_t rows;
    } parts[] = {
        {&e->lanes.numbers, e->alone ? 0 : e->system->lanes->number_count},
        {&e->lanes.q, sets * degrees},
        {&e->lanes.v, sets * rates},
        {&e->ended, 1},
        {&e->lanes.k[0], fixed * sets * rates},
        {&e->lanes.k[1], fixed * sets * rates},
        {&e->lanes.k[2], fixed * sets * rates},
        {&e->lanes.stage_q, fixed * sets * degrees},
        {&e->lanes.stage_v, fixed * sets * rates},
        {&e->lanes.divergence[0], some},
        {&e->lanes.divergence[1], some},
        {&e->lanes.divergence[2], some},
        {&e->lanes.divergence[3], some},
        {&e->lanes.volume, some},
        {&e->lanes.lengths, followed},
        {&e->lanes.growth, followed},
        {&e->lanes.now, fixed * e->system->forcing_count},
        {&e->lanes.located.begin_q, located * degrees},
        {&e->lanes.located.begin_v, located * rates},
        {&e->lanes.located.value[0], switches},
        {&e->lanes.located.value[1], switches},
        {&e->lanes.located.rate[0], switches},
        {&e->lanes.located.rate[1], switches},
        {&e->lanes.observe.low, degrees + rates},
        {&e->lanes.observe.high, degrees + rates},
        {&e->lanes.observe.gap, contacts},
        {&e->lanes.observe.touching, contacts},
        {&e->lanes.observe.force, forces},
        {&e->lanes.observe.friction, 2 * forces},
        // clang-format off
        WHIRL_WATCHED(PART)
        // clang-format on
    };
#undef PART
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        *parts[i].array = block ? block + row * e->lane_count : NULL;
        row += parts[i].rows;
    }
    return row;
}

static bool ensemble_allocate(whirl_ensemble *e) {
    const size_t table = e->adaptive || e->alone ? 0 : (2 * (size_t)e->lanes.steps + 1) * e->lanes.forcing_count;
    const size_t bytes = ensemble_lay_out(e, NULL) * e->lane_count * sizeof(double);
    e->block = aligned_alloc(64, (bytes + 63) / 64 * 64);
    e->forcing = malloc((table + 1) * sizeof *e->forcing);
    e->machines = calloc(e->lane_count, sizeof *e->machines);
    e->beside = calloc(e->lane_count, sizeof *e->beside);
    e->order = calloc(e->lane_count, sizeof *e->order);
    e->contact_probe = calloc(e->contact_count + 1, sizeof *e->contact_probe);
    e->state = calloc(e->system->dimension, sizeof *e->state);
    if (!e->state || !e->block || !e->forcing || !e->machines || !e->beside || !e->order || !e->contact_probe)
        return false;
    memset(e->block, 0, bytes);
    e->row_count = ensemble_lay_out(e, e->block);
    return true;
}

static void tabulate(whirl_ensemble *e) {
    const whirl_system *system = e->system;
    if (e->adaptive || e->alone) return;
    for (int i = 0; i <= 2 * e->lanes.steps && system->forcing_count > 0; i++)
        system->forcing(system->model, system->period * ((double)i / (2.0 * e->lanes.steps)),
                        e->forcing + (size_t)i * system->forcing_count);
}

/// Fills in the data that all lanes share. Integrators treat all coordinates as rates.
static void fill_shape(whirl_ensemble *e) {
    const whirl_system *system = e->system;
    rk4_lanes *lanes = &e->lanes;
    lanes->degrees = e->alone ? 0 : system->lanes->degrees;
    lanes->rates = system->dimension - lanes->degrees;
    lanes->observe.probe_count = whirl_watched_probes(system);
    lanes->observe.probes = system->probes;
    lanes->observe.contact_count = e->contact_count = system->contact_count;
}

/// Adds the logarithms of all products of lengths to the growth, and sets the products to 1.
static void note_lengths(const rk4_lanes *lanes) {
    for (size_t i = 0; i < lanes->perturbations * lanes->lane_count; i++) {
        lanes->growth[i] += log(lanes->lengths[i]);
        lanes->lengths[i] = 1.0;
    }
}

static void fill_lanes(whirl_ensemble *e, const whirl_integrate_options *options) {
    const whirl_system *system = e->system;
    rk4_lanes *lanes = &e->lanes;
    const size_t places = system->lanes->part_count;
    lanes->model = system->model;
    lanes->places = calloc(places + 1, sizeof *lanes->places);
    if (lanes->places) memcpy(lanes->places, system->lanes->places, places * sizeof *lanes->places);
    lanes->flow = system->lanes->flow[e->isa->number];
    lanes->pair_laws = system->lanes->pair_laws;
    lanes->forcing_count = system->forcing_count;
    lanes->steps = options->steps_per_revolution;
    lanes->stop = system->stop;
    lanes->step = system->period / options->steps_per_revolution;
    lanes->note = note_lengths;
    lanes->observe.by_force = system->lanes->damped;
    lanes->observe.rubs = system->lanes->rubs;
    if (system->lanes->damped || system->lanes->rubs) lanes->observe.contacts = system->lanes->contacts[e->isa->number];
}

/// Attaches an adaptive method, its stepper for lanes near switches, and memory for their perturbations.
static bool attach_adaptive(whirl_ensemble *e, const lanes_method *own, const whirl_integrate_options *options,
                            size_t lanes) {
    const size_t most = e->lanes.perturbations, n = e->system->dimension;
    e->adaptive = adaptive_lanes_new(own, e->system, options, e->isa, lanes, most);
    e->stepper = stepper_new(own, e->system, options);
    if (!e->adaptive || !e->stepper) return false;
    e->adaptive->stepper = e->stepper;
    if (most == 0) return true;
    e->work = calloc((PERTURBATION_ROWS * (1 + most) + SPARE_ROWS + most) * n, sizeof *e->work);
    if (!e->work) return false;
    stepper_follow(e->stepper, most, e->work + most * n);
    e->along = (whirl_perturbations){.count = most, .vectors = e->work};
    e->adaptive->alongside = &e->along;
    return true;
}

/// Attaches the stepper and the memory that methods with located contacts need.
static bool attach_location(whirl_ensemble *e, const whirl_integrate_options *options, size_t lanes) {
    const whirl_system *system = e->system;
    lanes_located *located = &e->lanes.located;
    const lanes_method *adaptive = adaptive_in_lanes(options);
    if (adaptive) return attach_adaptive(e, adaptive, options, lanes);
    if (!options->located || system->lanes->switch_count == 0) return true;
    e->stepper = stepper_new(NULL, system, options);
    *located = (lanes_located){.switches = system->lanes->switches[e->isa->number],
                               .switch_count = system->lanes->switch_count,
                               .needs_slopes = system->lanes->damped || system->lanes->lags,
                               .stepper = e->stepper};
    return e->stepper != NULL;
}

/// Returns how many vectors rk4 carries together, so that each hides the latency of the others: the largest of 8, 6, 4,
/// 3 and 2 vectors whose numbers and stages fit into the first cache, otherwise 1. With the structure's own loops
/// (rk4_pair.inc) their observations must fit, too.
///
/// The fastest numbers measured with 512 bits are 6 for disc and journal, 4 for ten equal stations, 3 for a shaft of 22
/// coordinates and 1 for fifty stations; with 256 bits 8, 8, 6 and 1.
static size_t fast_vectors(const whirl_ensemble *e) {
    static const size_t choices[] = {8, 6, 4, 3, 2, 1};
    const whirl_system *system = e->system;
    const size_t first_cache = 43008, degrees = system->lanes->degrees;
    const size_t observed = system->lanes->pair_laws ? 7 * degrees + 4 * system->lanes->contact_count : 0;
    const size_t steps = 5 * system->dimension - 3 * degrees; // the state, that of a stage, three slopes
    const size_t numbers = system->lanes->part(system->model, e->lanes.places);
    const size_t rows = numbers + (1 + e->lanes.perturbations) * steps + observed;
    const size_t bytes = rows * e->isa->lanes * sizeof(double);
    size_t i = 0;
    while (choices[i] > 1 && choices[i] * bytes > first_cache) i++;
    return choices[i];
}

/// Returns the number of lanes that is fastest. For adaptive methods this is ROUNDS for each slot, so that few slots
/// are idle while the last lanes finish; for rk4, the lanes of the vectors that hide each other's latency.
static size_t fast_lanes(const whirl_ensemble *e) {
    enum { ROUNDS = 8 };
    return e->adaptive ? e->adaptive->slots * ROUNDS : fast_vectors(e) * e->isa->lanes;
}

/// Completes an ensemble with an attached method.
static whirl_status ensemble_finish(whirl_ensemble *e, size_t lanes, whirl_ensemble **out) {
    e->lanes.stride = (lanes + e->isa->lanes - 1) / e->isa->lanes;
    e->lanes.lane_count = e->lane_count = e->lanes.stride * e->isa->lanes;
    if (!ensemble_allocate(e))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for an ensemble of %zu lanes", e->lane_count);
    tabulate(e);
    e->lanes.forcing = e->forcing;
    e->lanes.observe.contact_probe = e->contact_probe;
    e->lanes.located.machines = e->machines;
    e->lanes.located.ended = e->ended;
    *out = e;
    return whirl_ok();
}

/// Makes an ensemble without a method and without lanes. Returns NULL without memory.
static whirl_ensemble *ensemble_begin(const whirl_system *system, const whirl_integrate_options *options) {
    whirl_ensemble *e = calloc(1, sizeof *e);
    if (!e) return NULL;
    e->system = system;
    e->limit = options->limit;
    return e;
}

/// Returns the narrowest instruction set with the bits of `widest` whose vectors hold that many lanes: its vectors have
/// fewer idle lanes.
static const isa *narrowest_isa(const isa *widest, size_t lanes) {
    for (int number = 0; number < widest->number; number++) {
        const isa *own = isa_at(number);
        if (own && own->fused == widest->fused && own->lanes >= lanes) return own;
    }
    return widest;
}

/// Makes an ensemble whose lanes are carried by kernels, with perturbations; narrow: by the narrowest instruction set.
static whirl_status ensemble_make(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                  size_t perturbations, bool narrow, whirl_ensemble **out) {
    whirl_status status = check_options(system, options);
    if (status.code != WHIRL_OK) return status;
    whirl_ensemble *e = ensemble_begin(system, options);
    if (!e) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an ensemble");
    status = isa_choose(&e->isa);
    if (status.code == WHIRL_OK) {
        if (narrow) e->isa = narrowest_isa(e->isa, lanes);
        fill_shape(e);
        fill_lanes(e, options);
        e->lanes.perturbations = perturbations;
        if (e->lanes.places && attach_location(e, options, lanes))
            status = ensemble_finish(e, lanes > 0 ? lanes : fast_lanes(e), out);
        else
            status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an ensemble");
    }
    if (status.code != WHIRL_OK) whirl_ensemble_free(e);
    return status;
}

whirl_status whirl_ensemble_new(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                whirl_ensemble **out) {
    *out = NULL;
    if (whirl_ensemble_takes(system, options)) return ensemble_make(system, options, lanes, 0, false, out);
    return whirl_fail(WHIRL_BAD_INPUT,
                      "method %s of this system does not run in lanes, expected a rotor and rk4, dop853 or rodas5p",
                      options->method);
}

whirl_status whirl_ensemble_variational(const whirl_system *system, const whirl_integrate_options *options,
                                        whirl_ensemble **out) {
    *out = NULL;
    if (whirl_ensemble_follows(system, options))
        return ensemble_make(system, options, 0, system->dimension, false, out);
    return whirl_fail(WHIRL_BAD_INPUT, "perturbations of this system do not go in lanes, expected a rotor without "
                                       "jumps of its forces, and rk4 that does not locate contacts");
}

bool whirl_ensemble_flows(const whirl_system *system, const whirl_integrate_options *options) {
    return system->lanes && system->tangent && adaptive_in_lanes(options) == &dop853_in_lanes &&
           system->dimension <= MAX_PERTURBATIONS;
}

whirl_status whirl_ensemble_flow(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                 size_t followed, whirl_ensemble **out) {
    *out = NULL;
    if (followed > 0 ? !whirl_ensemble_flows(system, options) : !system->lanes || !adaptive_in_lanes(options))
        return whirl_fail(WHIRL_BAD_INPUT, "parts of the period of this system do not go in lanes, expected a rotor of "
                                           "up to 256 coordinates and method dop853, or rodas5p without perturbations");
    if (followed > system->dimension)
        return whirl_fail(WHIRL_BAD_INPUT, "%zu perturbations are to be followed, expected at most the dimension, %zu",
                          followed, system->dimension);
    whirl_status status = ensemble_make(system, options, lanes, followed, followed == 0, out);
    if (status.code != WHIRL_OK) return status;
    (*out)->parts = calloc(2 * (*out)->lane_count, sizeof *(*out)->parts);
    for (size_t i = 0; (*out)->parts && i < (*out)->lane_count; i++) (*out)->parts[2 * i + 1] = system->period;
    if ((*out)->parts) return status;
    whirl_ensemble_free(*out);
    *out = NULL;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for an ensemble");
}

void whirl_ensemble_part(whirl_ensemble *e, size_t lane, double from, double length) {
    e->parts[2 * lane] = from;
    e->parts[2 * lane + 1] = from + length;
    e->ended[lane] = WHIRL_BOUNDED;
}

whirl_status whirl_ensemble_alone(const whirl_system *system, const whirl_integrate_options *options, size_t lanes,
                                  size_t followed, whirl_ensemble **out) {
    *out = NULL;
    // Make an ensemble of scalar lanes, each with an integrator.
    whirl_status status = check_options(system, options);
    if (status.code != WHIRL_OK) return status;
    whirl_ensemble *e = ensemble_begin(system, options);
    if (!e) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an ensemble");
    e->isa = isa_at(VECTOR_SCALAR);
    e->alone = alone_lanes_new(options, followed, system->dimension, lanes);
    if (!e->alone) {
        whirl_ensemble_free(e);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for an ensemble");
    }
    fill_shape(e);
    status = ensemble_finish(e, lanes, out);
    if (status.code != WHIRL_OK) {
        whirl_ensemble_free(e);
        return status;
    }
    // The integrators work on the ensemble's arrays.
    e->alone->x = e->lanes.v;
    e->alone->ended = e->ended;
    e->alone->machines = e->machines;
    e->alone->beside = e->beside;
    e->alone->watched = &e->lanes.observe;
    return status;
}

void whirl_ensemble_free(whirl_ensemble *e) {
    if (!e) return;
    adaptive_lanes_free(e->adaptive);
    alone_lanes_free(e->alone);
    stepper_free(e->stepper);
    free(e->work);
    free(e->parts);
    free(e->block);
    free(e->forcing);
    free(e->lanes.places);
    free(e->state);
    free(e->machines);
    free(e->order);
    free(e->beside);
    free(e->contact_probe);
    free(e);
}

size_t whirl_ensemble_lanes(const whirl_ensemble *e) {
    return e->lane_count;
}
const char *whirl_ensemble_isa(const whirl_ensemble *e) {
    return e->isa->name;
}

whirl_status whirl_ensemble_check(const whirl_system *first, const whirl_system *other) {
    if (other->dimension == first->dimension && other->probe_count == first->probe_count &&
        other->contact_count == first->contact_count)
        return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "the machine has %zu states, %zu stations and %zu contacts, and that of the first point %zu, %zu "
                      "and %zu, expected as many of each at all points (an inertia of 0 at some of them removes a "
                      "station's tilts)",
                      other->dimension, other->probe_count, other->contact_count, first->dimension, first->probe_count,
                      first->contact_count);
}

bool whirl_ensemble_alike(const whirl_system *one, const whirl_system *other) {
    if (!one->lanes && !other->lanes) return whirl_ensemble_check(one, other).code == WHIRL_OK;
    return one->lanes && other->lanes && one->lanes->alike == other->lanes->alike &&
           one->lanes->alike(one->model, other->model);
}

static bool is_of_structure(const whirl_ensemble *e, const whirl_system *system) {
    if (e->alone) return whirl_ensemble_check(e->system, system).code == WHIRL_OK;
    return system->lanes && whirl_ensemble_alike(e->system, system);
}

/// Loads the numbers of a machine of the ensemble's structure into a lane.
static whirl_status load_numbers(whirl_ensemble *e, size_t lane, const whirl_system *system) {
    const whirl_lanes *form = e->system->lanes;
    double *numbers = malloc(form->number_count * sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    form->numbers(system->model, numbers);
    for (size_t i = 0; i < form->number_count; i++) e->lanes.numbers[i * e->lane_count + lane] = numbers[i];
    free(numbers);
    form->part(system->model, e->lanes.places);
    for (size_t c = 0; c < e->contact_count; c++)
        form->contact(system->model, c, &e->contact_probe[c], &e->lanes.observe.gap[c * e->lane_count + lane]);
    return whirl_ok();
}

whirl_status whirl_ensemble_load(whirl_ensemble *e, size_t lane, const whirl_system *system, const double *x) {
    if (!is_of_structure(e, system))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "the machine has another structure than the ensemble, expected the same stations and "
            "elements and, on shafts of finite elements, the same masses (method cvode-bdf takes machines one by one)");
    const whirl_status status = e->alone ? alone_lanes_load(e->alone, lane, system) : load_numbers(e, lane, system);
    if (status.code != WHIRL_OK) return status;
    e->machines[lane] = system;
    e->ended[lane] = WHIRL_BOUNDED;
    whirl_ensemble_place(e, lane, x);
    whirl_ensemble_forget(e, lane);
    return whirl_ok();
}

/// Copies x [dimension] to a lane, as its state (set 0) or a perturbation.
static void place(whirl_ensemble *e, size_t lane, size_t set, const double *x) {
    const size_t degrees = e->lanes.degrees, rates = e->lanes.rates;
    for (size_t d = 0; d < degrees; d++) e->lanes.q[(set * degrees + d) * e->lane_count + lane] = x[d];
    for (size_t d = 0; d < rates; d++) e->lanes.v[(set * rates + d) * e->lane_count + lane] = x[degrees + d];
}

void whirl_ensemble_place(whirl_ensemble *e, size_t lane, const double *x) {
    place(e, lane, 0, x);
}

/// Returns the row of a coordinate in all lanes.
static double *row_of(const whirl_ensemble *e, size_t index) {
    const size_t degrees = e->lanes.degrees;
    return index < degrees ? e->lanes.q + index * e->lane_count : e->lanes.v + (index - degrees) * e->lane_count;
}

const double *whirl_ensemble_coordinate(const whirl_ensemble *e, size_t index) {
    return e->shown ? e->shown + index * e->lane_count : row_of(e, index);
}

void whirl_ensemble_state(const whirl_ensemble *e, size_t lane, double *x) {
    for (size_t i = 0; i < e->system->dimension; i++) x[i] = whirl_ensemble_coordinate(e, i)[lane];
}

void whirl_ensemble_carry(whirl_ensemble *e, size_t lane, whirl_perturbations *set) {
    e->beside[lane] = set;
}

whirl_motion whirl_ensemble_motion(const whirl_ensemble *e, size_t lane) {
    if (e->alone) return (whirl_motion)e->ended[lane];
    for (size_t i = 0; i < e->system->dimension; i++)
        if (!(fabs(whirl_ensemble_coordinate(e, i)[lane]) <= e->limit)) return WHIRL_DIVERGED; // NaN too
    return (whirl_motion)e->ended[lane];
}

size_t whirl_ensemble_numbers(const whirl_ensemble *e) {
    return e->row_count;
}

void whirl_ensemble_save(const whirl_ensemble *e, size_t lane, double *numbers) {
    for (size_t row = 0; row < e->row_count; row++) numbers[row] = e->block[row * e->lane_count + lane];
}

void whirl_ensemble_restore(whirl_ensemble *e, size_t lane, const double *numbers) {
    for (size_t row = 0; row < e->row_count; row++) e->block[row * e->lane_count + lane] = numbers[row];
}

void whirl_ensemble_unload(whirl_ensemble *e, size_t lane) {
    e->machines[lane] = NULL;
    e->beside[lane] = NULL;
    if (e->alone) alone_lanes_load(e->alone, lane, NULL);
}

void whirl_ensemble_move(whirl_ensemble *e, size_t from, size_t to) {
    if (from == to) return;
    for (size_t row = 0; row < e->row_count; row++)
        e->block[row * e->lane_count + to] = e->block[row * e->lane_count + from];
    whirl_ensemble_unload(e, to);
    e->machines[to] = e->machines[from];
    e->beside[to] = e->beside[from];
    if (e->alone) alone_lanes_move(e->alone, from, to);
    whirl_ensemble_unload(e, from);
}

/// Lists the rows that are exchanged between a lane and its slot: machine and state, and for observed motions their
/// observations.
static void fill_exchange(const whirl_ensemble *e, adaptive_lanes *lanes) {
    const lanes_observe *own = &lanes->observe, *theirs = &e->lanes.observe;
    const size_t dimension = lanes->dimension, probes = own->probe_count, contacts = own->contact_count;
    const size_t sets = 1 + lanes->tangents;
#define PART(array, extent, columns, ...)                                                                              \
    {own->array, theirs->array, WHIRL_WATCHED_SIZE(extent, columns, probes, contacts), false, true},
    const lane_rows rows[] = {
        {lanes->numbers, e->lanes.numbers, lanes->number_count, true, false},
        {lanes->q, e->lanes.q, sets * lanes->degrees, false, false},
        {lanes->v, e->lanes.v, sets * lanes->rates, false, false},
        {lanes->ended, e->ended, 1, false, false},
        {lanes->volume, e->lanes.volume, sets > 1 ? 1 : 0, false, false},
        {own->low, theirs->low, dimension, false, true},
        {own->high, theirs->high, dimension, false, true},
        {own->gap, theirs->gap, contacts, true, true},
        {own->touching, theirs->touching, contacts, false, true},
        // clang-format off
        WHIRL_WATCHED(PART)
        // clang-format on
    };
#undef PART
    lanes->exchanged_count = sizeof rows / sizeof *rows;
    memcpy(lanes->exchanged, rows, sizeof rows);
}

/// Passes the samples [samples][dimension][lane_count] of a revolution to the observer.
static void hand_out(whirl_ensemble *e, const double *samples, size_t count, const whirl_ensemble_observe *observe) {
    for (size_t i = 0; i < count; i++) {
        e->shown = samples + i * e->system->dimension * e->lane_count;
        observe->sample(observe->context);
    }
    e->shown = NULL;
}

static void revolve_alone(whirl_ensemble *e, size_t count, const whirl_ensemble_observe *observe) {
    const size_t samples = alone_lanes_revolve(e->alone, count, observe);
    hand_out(e, e->alone->samples, samples, observe);
}

/// Copies perturbations to their lanes. Returns true if there are any.
static bool begin_perturbations(whirl_ensemble *e, size_t count) {
    const rk4_lanes *lanes = &e->lanes;
    bool any = false;
    for (size_t lane = 0; lane < count; lane++) any = any || e->beside[lane];
    memset(e->state, 0, e->system->dimension * sizeof *e->state);
    for (size_t lane = 0; any && lane < count; lane++) {
        const whirl_perturbations *set = e->beside[lane];
        if (!set && !e->adaptive) continue; // adaptive steps depend on perturbations: unused ones must be cleared
        lanes->volume[lane] = 0.0;
        for (size_t k = 0; k < lanes->perturbations; k++) {
            place(e, lane, k + 1, set ? set->vectors + k * e->system->dimension : e->state);
            lanes->lengths[k * e->lane_count + lane] = 1.0;
            lanes->growth[k * e->lane_count + lane] = 0.0;
        }
    }
    return any;
}

/// Copies perturbations from their lanes.
static void end_perturbations(whirl_ensemble *e, size_t count) {
    const rk4_lanes *lanes = &e->lanes;
    const size_t degrees = lanes->degrees, rates = lanes->rates;
    for (size_t lane = 0; lane < count; lane++) {
        whirl_perturbations *set = e->beside[lane];
        if (!set) continue;
        double *out = set->vectors;
        for (size_t k = 1; k <= lanes->perturbations; k++) {
            for (size_t d = 0; d < degrees; d++) *out++ = lanes->q[(k * degrees + d) * e->lane_count + lane];
            for (size_t d = 0; d < rates; d++) *out++ = lanes->v[(k * rates + d) * e->lane_count + lane];
            if (set->growth) set->growth[k - 1] = lanes->growth[(k - 1) * e->lane_count + lane];
        }
        set->volume = lanes->volume[lane];
        e->beside[lane] = NULL;
    }
}

/// Puts lanes in order, observed ones first: as long as one of them is in a slot, every step also computes its
/// interpolant. Returns the number of observed lanes.
static size_t put_in_order(whirl_ensemble *e, size_t count, const whirl_ensemble_observe *observe) {
    const bool *which = observe ? observe->lanes : NULL;
    size_t observed = 0;
    for (size_t lane = 0; lane < count; lane++)
        if (observe && (!which || which[lane])) e->order[observed++] = lane;
    for (size_t lane = 0, at = observed; lane < count; lane++)
        if (!observe || (which && !which[lane])) e->order[at++] = lane;
    return observed;
}

/// Carries a revolution in which every lane has its own time. Samples are passed to the observer when all lanes are
/// finished.
static void revolve_adaptive(whirl_ensemble *e, size_t count, const whirl_ensemble_observe *observe) {
    // Allocate samples if an observer wants them.
    const size_t wanted = observe && observe->stride > 0 ? (size_t)e->adaptive->instants / observe->stride : 0;
    const size_t samples = adaptive_lanes_make_room(e->adaptive, wanted, e->lane_count) ? wanted : 0;
    const size_t size = e->system->dimension * e->lane_count;
    // Describe the revolution to the kernel.
    adaptive_lanes lanes = *e->adaptive;
    lanes.lane_count = e->lane_count;
    lanes.machines = e->machines;
    lanes.observe.contact_probe = e->contact_probe;
    lanes.observing = observe && (observe->extremes || samples > 0);
    lanes.sample_stride = samples > 0 ? observe->stride : 0;
    lanes.parts = e->parts;
    lanes.tangents = begin_perturbations(e, count) ? e->lanes.perturbations : 0;
    lanes.queue->next = 0;
    lanes.queue->count = count;
    lanes.queue->order = e->order;
    lanes.queue->observed = put_in_order(e, count, lanes.observing ? observe : NULL);
    fill_exchange(e, &lanes);
    // Carry all lanes, then pass their samples to the observer.
    for (size_t i = 0; i < samples * size; i++) lanes.samples[i] = NAN; // remains for lanes whose motion ends early
    for (size_t lane = 0; samples < wanted && lane < count; lane++)
        e->ended[lane] = WHIRL_STUCK; // no memory for its samples
    lanes.method->revolves[e->isa->number](&lanes);
    hand_out(e, lanes.samples, samples, observe);
    if (lanes.tangents > 0) end_perturbations(e, count);
}

/// Brings angles back to their first turn.
static void wrap(whirl_ensemble *e, size_t count) {
    const double *turns = e->system->turns, *angles = e->system->angles;
    for (size_t i = 0; (turns || angles) && i < e->system->dimension; i++) {
        double *row = row_of(e, i);
        if (!turns_on(turns, i) && !turns_on(angles, i)) continue;
        for (size_t lane = 0; lane < count; lane++) row[lane] = part_wrapped(turns, angles, i, row[lane]);
    }
}

/// Returns true if perturbations are to stay orthonormal and their growth is requested.
static bool are_measured(const whirl_ensemble *e, size_t count) {
    bool any = false;
    for (size_t lane = 0; lane < count; lane++) any = any || (e->beside[lane] && e->beside[lane]->growth);
    return any;
}

static void revolve_rk4(whirl_ensemble *e, size_t count, const whirl_ensemble_observe *observe) {
    rk4_lanes lanes = e->lanes;
    if (!are_measured(e, count)) lanes.lengths = NULL;
    if (!begin_perturbations(e, count)) lanes.perturbations = 0;
    lanes.used = count;
    lanes.vectors = (count + e->isa->lanes - 1) / e->isa->lanes;
    if (observe) {
        lanes.observing = observe->extremes;
        lanes.sample_stride = observe->stride;
        lanes.sample = observe->sample;
        lanes.context = observe->context;
    }
    rk4_lanes_revolves[e->isa->number](&lanes);
    if (lanes.perturbations > 0) end_perturbations(e, count);
}

void whirl_ensemble_revolve(whirl_ensemble *e, size_t count, const whirl_ensemble_observe *observe) {
    if (e->alone)
        revolve_alone(e, count, observe);
    else if (e->adaptive)
        revolve_adaptive(e, count, observe);
    else
        revolve_rk4(e, count, observe);
    wrap(e, count);
}

// ---------------------------------------------------------------- what is observed

static void set(double *array, const whirl_ensemble *e, size_t rows, size_t lane, double value) {
    for (size_t i = 0; i < rows; i++) array[i * e->lane_count + lane] = value;
}

static void get(const double *array, const whirl_ensemble *e, size_t rows, size_t lane, double *out) {
    for (size_t i = 0; out && i < rows; i++) out[i] = array[i * e->lane_count + lane];
}

/// Returns true if the gap of contact c is closed.
static bool is_closed(const whirl_ensemble *e, size_t c, size_t lane) {
    const whirl_probe *probe = &e->lanes.observe.probes[e->contact_probe[c]];
    const double x = whirl_ensemble_coordinate(e, probe->x)[lane], y = whirl_ensemble_coordinate(e, probe->y)[lane];
    const double gap = e->lanes.observe.gap[c * e->lane_count + lane];
    return x * x + y * y > gap * gap;
}

/// Notes which contacts are closed now.
static void note_contacts(const whirl_ensemble *e, size_t lane) {
    const lanes_observe *w = &e->lanes.observe;
    const bool forces = by_force(e) && w->contact_count > 0;
    double force[WHIRL_MAX_CONTACTS];
    if (forces) {
        whirl_ensemble_state(e, lane, e->state);
        e->machines[lane]->contacts(e->machines[lane]->model, e->state, force);
    }
    for (size_t c = 0; c < w->contact_count; c++) {
        const size_t at = c * e->lane_count + lane;
        w->touching[at] = (forces ? force[c] > 0.0 : is_closed(e, c, lane)) ? 1.0 : 0.0;
    }
}

/// Computes the normal forces at the largest radii. These are the largest forces if forces depend on the displacement
/// alone. (max_radius holds squares of radii.)
static void largest_forces(const whirl_ensemble *e, size_t lane, double *force) {
    const lanes_observe *w = &e->lanes.observe;
    memset(e->state, 0, e->system->dimension * sizeof *e->state);
    for (size_t p = 0; p < e->system->probe_count; p++)
        e->state[w->probes[p].x] = sqrt(w->max_radius[p * e->lane_count + lane]);
    if (w->contact_count > 0) e->machines[lane]->contacts(e->machines[lane]->model, e->state, force);
}

void whirl_ensemble_forget(whirl_ensemble *e, size_t lane) {
    const lanes_observe *w = &e->lanes.observe;
    set(w->low, e, e->system->dimension, lane, fold_none(WHIRL_SMALLEST));
    set(w->high, e, e->system->dimension, lane, fold_none(WHIRL_LARGEST));
#define BEGIN(array, extent, columns, fold, ...)                                                                       \
    set(w->array, e, WHIRL_WATCHED_SIZE(extent, columns, w->probe_count, w->contact_count), lane, fold_none(fold));
    WHIRL_WATCHED(BEGIN)
#undef BEGIN
    note_contacts(e, lane);
}

void whirl_ensemble_read(const whirl_ensemble *e, size_t lane, const whirl_ensemble_seen *seen) {
    const lanes_observe *w = &e->lanes.observe;
    get(w->low, e, e->system->dimension, lane, seen->low);
    get(w->high, e, e->system->dimension, lane, seen->high);
#define GET(array, extent, columns, ...)                                                                               \
    get(w->array, e, WHIRL_WATCHED_SIZE(extent, columns, w->probe_count, w->contact_count), lane, seen->array);
    WHIRL_WATCHED(GET)
#undef GET
    if (seen->contact_force && !by_force(e)) largest_forces(e, lane, seen->contact_force);
}
