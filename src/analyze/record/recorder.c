// Records many motions in the lanes of an ensemble: side by side, or one after the other if an integrator carries them.
// A motion takes one lane, and a second one for its perturbed copy while growth is followed. Lanes in use are kept
// together at the front. If no lane is free for the copy, the motion leaves its lane and waits with its state; it then
// goes before new motions. None of this changes a bit of any motion.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approach.h"
#include "archive.h"
#include "at_rest.h"
#include "orbit_search.h"
#include "orbits.h"
#include "perturbed_copy.h"
#include "record_block.h"
#include "settling.h"
#include "steps.h"
#include "whirl/engine/ensemble.h"

#define NO_LANE ((size_t)-1)

/// A motion under way.
typedef struct motion {
    whirl_task task;
    whirl_record *record;
    int revolution; ///< done so far
    size_t lane, copy_lane;
    perturbed_copy copy;
    settling *settling;      ///< NULL if every transient runs to its end
    approach *approach;      ///< NULL if no orbit is searched before the end of the motion
    int first_recorded;      ///< revolution
    orbit_search *search;    ///< search that the motion waits for; or NULL
    double *x;               ///< [2 dimension] states of the motion and its perturbed copy
    double *perturbations;   ///< [perturbed][dimension]
    whirl_perturbations set; ///< `perturbations` while an integrator carries them, else none
    double *saved; ///< [2][numbers of a lane] to be restored into the lanes of the motion and its copy; or NULL
} motion;

struct whirl_recorder {
    const whirl_integrate_options *integrate;
    const whirl_stop *stop; ///< stop of the system
    const whirl_record_options *options;
    whirl_ensemble *ensemble;
    whirl_ensemble *variational; ///< carries all perturbations, next to `ensemble`; or NULL
    orbit_searches *searches;    ///< searches orbits, or NULL
    size_t dimension, lane_count;
    size_t carried;          ///< perturbations of a motion that the Jacobian carries
    int first_watched, last; ///< revolutions
    size_t used;             ///< lanes in use
    motion **owner;          ///< [lane_count] motion in every used lane
    bool *recorded;          ///< [lane_count] whether a lane is watched, set by revolve_lanes for one revolution
    size_t count, max_count; ///< motions under way
    motion **motions;        ///< [max_count], including those that wait
    whirl_ensemble_observe watch;
    const whirl_probe *probes;
    size_t probe_count, sample_count;
    double *samples; ///< [samples of a revolution][probes][2][lane_count]
};

/// Returns true if motions have a perturbed copy while they are watched.
static bool has_copies(const whirl_recorder *r) {
    return r->options->growth == WHIRL_GROWTH_LARGEST && r->carried == 0;
}

/// Returns true if a motion was put on an orbit, whose multipliers give the growth of perturbations.
static bool is_on_orbit(const motion *m) {
    return m->record->orbit.set_at > 0.0;
}

/// Returns true if the growth of perturbations is followed.
static bool is_followed(const whirl_recorder *r, const motion *m) {
    return m->revolution >= r->first_watched && !is_on_orbit(m);
}

static bool recorder_follows(const whirl_recorder *r, const motion *m) {
    return has_copies(r) && is_followed(r, m);
}

static bool recorder_records(const motion *m) {
    return m->revolution >= m->first_recorded;
}

static bool is_over(const whirl_recorder *r, const motion *m) {
    return m->record->motion != WHIRL_BOUNDED || m->revolution == r->last;
}

static bool recorder_waits(const motion *m) {
    return m->lane == NO_LANE;
}

// ---------------------------------------------------------------- lanes

static size_t take_lane(whirl_recorder *r, motion *m) {
    r->owner[r->used] = m;
    return r->used++;
}

/// Frees a lane and moves the last used one there.
static void free_lane(whirl_recorder *r, size_t lane) {
    const size_t last = --r->used;
    if (lane == last) {
        whirl_ensemble_unload(r->ensemble, lane);
        return;
    }
    motion *moved = r->owner[last];
    whirl_ensemble_move(r->ensemble, last, lane);
    r->owner[lane] = moved;
    if (moved->lane == last)
        moved->lane = lane;
    else
        moved->copy_lane = lane;
}

static void leave_copy(whirl_recorder *r, motion *m) {
    if (m->copy_lane == NO_LANE) return;
    const size_t lane = m->copy_lane;
    m->copy_lane = NO_LANE;
    free_lane(r, lane);
}

static void leave_lanes(whirl_recorder *r, motion *m) {
    leave_copy(r, m);
    if (m->lane != NO_LANE) {
        const size_t lane = m->lane;
        m->lane = NO_LANE;
        free_lane(r, lane);
    }
}

/// Puts a motion into a lane, and its perturbed copy into another while growth is followed.
static whirl_status enter_lanes(whirl_recorder *r, motion *m) {
    m->lane = take_lane(r, m);
    whirl_status status = whirl_ensemble_load(r->ensemble, m->lane, m->task.system, m->x);
    if (status.code == WHIRL_OK && recorder_follows(r, m)) {
        m->copy_lane = take_lane(r, m);
        status = whirl_ensemble_load(r->ensemble, m->copy_lane, m->task.system, m->copy.x);
    }
    if (m->saved && status.code == WHIRL_OK) whirl_ensemble_restore(r->ensemble, m->lane, m->saved);
    free(m->saved);
    m->saved = NULL;
    return status;
}

static size_t lanes_needed(const whirl_recorder *r, const motion *m) {
    return recorder_follows(r, m) ? 2 : 1;
}

// ---------------------------------------------------------------- motions come and go

static void motion_free(motion *m) {
    if (!m) return;
    whirl_record_free(m->record);
    settling_free(m->settling);
    approach_free(m->approach);
    free(m->saved);
    free(m->search);
    free(m);
}

static motion *motion_new(const whirl_recorder *r, const whirl_task *task) {
    const size_t rows = 2 + r->carried;
    motion *m = calloc(1, sizeof *m + rows * r->dimension * sizeof(double));
    if (!m) return NULL;
    *m = (motion){.task = *task, .lane = NO_LANE, .copy_lane = NO_LANE, .x = (double *)(m + 1)};
    m->perturbations = m->x + 2 * r->dimension;
    m->copy = perturbed_copy_of(r->integrate, task->system, m->x + r->dimension);
    m->record = record_new(task->system, r->integrate, r->options);
    if (m->record && r->carried > 0) record_place_perturbations(m->record, r->carried, m->perturbations);
    memcpy(m->x, task->start, r->dimension * sizeof *m->x);
    m->first_recorded = r->options->transient;
    if (m->record && recorder_follows(r, m)) perturbed_copy_begin(&m->copy, m->x);
    if (r->options->settle) m->settling = settling_new(task->system);
    // With all exponents, motions run to the end: an orbit's smallest multipliers are lost in the rounding of its
    // matrix.
    const bool approaches = m->settling && r->searches && r->options->growth != WHIRL_GROWTH_ALL;
    if (approaches) m->approach = approach_new(task->system, r->integrate, r->options);
    if (m->record && (m->settling || !r->options->settle) && (m->approach || !approaches)) return m;
    motion_free(m);
    return NULL;
}

// ---------------------------------------------------------------- motions are saved and taken up

/// Archives (saves or restores) a motion between two revolutions, with the watched numbers of its lane if it is in one.
/// A perturbed copy has no watched numbers, only its state.
static void motion_archive(const whirl_recorder *r, motion *m, archive *a) {
    record_archive(m->record, r->integrate, r->options, a);
    archive_part(a, &m->revolution, sizeof m->revolution);
    archive_part(a, &m->first_recorded, sizeof m->first_recorded);
    archive_part(a, &m->copy.distance, sizeof m->copy.distance);
    archive_part(a, &m->copy.range, sizeof m->copy.range);
    archive_part(a, m->x, (2 + r->carried) * r->dimension * sizeof *m->x); // perturbations follow
    if (m->settling) settling_archive(m->settling, a);
    if (m->approach) approach_archive(m->approach, a);
    size_t shooting = m->search ? m->search->revolutions : 0;
    archive_count(a, &shooting, WHIRL_MAX_PERIOD);
    if (shooting > 0 && a->sound && !m->search) m->search = orbit_search_new(m->task.system, shooting, m->x);
    a->sound = a->sound && (shooting == 0 || m->search);
    const size_t numbers = whirl_ensemble_numbers(r->ensemble);
    size_t in_lane = m->saved != NULL;
    archive_count(a, &in_lane, 1);
    if (in_lane && !m->saved) m->saved = calloc(numbers, sizeof *m->saved);
    if (in_lane && !m->saved) a->sound = false;
    if (m->saved && a->sound) archive_part(a, m->saved, numbers * sizeof *m->saved);
}

/// Saves one motion in `state`; false without memory.
static bool save_motion(const whirl_recorder *r, motion *m, whirl_motion_state *state) {
    if (!recorder_waits(m)) {
        m->saved = malloc(whirl_ensemble_numbers(r->ensemble) * sizeof *m->saved);
        if (!m->saved) return false;
        whirl_ensemble_save(r->ensemble, m->lane, m->saved);
    }
    archive a = {.way = ARCHIVE_MEASURE, .sound = true};
    motion_archive(r, m, &a);
    a = (archive){ARCHIVE_WRITE, malloc(a.at), a.at, 0, true};
    if (a.bytes) motion_archive(r, m, &a);
    if (!recorder_waits(m)) {
        free(m->saved);
        m->saved = NULL;
    }
    *state = (whirl_motion_state){m->task, m->record->revolutions, a.bytes, a.size};
    return a.bytes != NULL;
}

whirl_motion_state *whirl_recorder_save(whirl_recorder *r, size_t *count) {
    whirl_motion_state *states = r->count > 0 ? calloc(r->count, sizeof *states) : NULL;
    *count = 0;
    while (states && *count < r->count && save_motion(r, r->motions[*count], &states[*count])) ++*count;
    if (*count == r->count) return states;
    whirl_motion_states_free(states, *count);
    *count = 0;
    return NULL;
}

void whirl_motion_states_free(whirl_motion_state *states, size_t count) {
    for (size_t i = 0; i < count; i++) free(states[i].bytes);
    free(states);
}

/// Makes a motion that continues from a saved state, or a new one if the bytes do not fit. NULL without memory.
static motion *motion_restored(const whirl_recorder *r, const whirl_task *task, void *bytes, size_t size) {
    motion *m = motion_new(r, task);
    if (!m || !bytes) return m;
    archive a = {ARCHIVE_READ, bytes, size, 0, true};
    motion_archive(r, m, &a);
    if (!a.sound || a.at != a.size) {
        motion_free(m);
        return motion_new(r, task);
    }
    // The state was saved before the first revolution in which growth is followed.
    if (recorder_follows(r, m) && m->record->growth_count == 0) perturbed_copy_begin(&m->copy, m->x);
    return m;
}

// ---------------------------------------------------------------- motions begin

/// Returns true if a motion waits for a lane, and not for its orbit.
static bool waits_for_lane(const motion *m) {
    return recorder_waits(m) && !m->search;
}

/// Puts motions that wait into free lanes.
static whirl_status recorder_resume(whirl_recorder *r) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < r->count && status.code == WHIRL_OK; i++) {
        motion *m = r->motions[i];
        if (!waits_for_lane(m)) continue;
        if (r->used + lanes_needed(r, m) > r->lane_count) return status;
        status = enter_lanes(r, m);
    }
    return status;
}

bool whirl_recorder_has_room(const whirl_recorder *r) {
    const size_t first = has_copies(r) && r->first_watched == 0 ? 2 : 1;
    for (size_t i = 0; i < r->count; i++)
        if (waits_for_lane(r->motions[i])) return false;
    return r->count < r->max_count && r->used + first <= r->lane_count;
}

whirl_status whirl_recorder_add(whirl_recorder *r, const whirl_task *task, void *bytes, size_t size) {
    motion *m = motion_restored(r, task, bytes, size);
    free(bytes);
    if (!m) return whirl_fail(WHIRL_NO_MEMORY, "no memory to record %d revolutions", r->options->record);
    // A motion that was saved while it waited for its orbit continues to wait.
    whirl_status status = whirl_ok();
    if (!m->search && r->used + lanes_needed(r, m) <= r->lane_count) status = enter_lanes(r, m);
    if (status.code == WHIRL_OK)
        r->motions[r->count++] = m;
    else
        motion_free(m);
    return status;
}

// ---------------------------------------------------------------- a revolution

/// Attaches the perturbations of a motion to a lane of an ensemble.
static void carry_perturbations(const whirl_recorder *r, motion *m, whirl_ensemble *ensemble, size_t lane) {
    whirl_record *record = m->record;
    const size_t count = record->growth_count;
    double *growth = record->growths ? record->growths + count * record->dimension : &record->growth[count];
    m->set = (whirl_perturbations){.count = r->carried, .vectors = m->perturbations, .growth = growth};
    whirl_ensemble_carry(ensemble, lane, &m->set);
}

static void note_perturbations(motion *m) {
    whirl_record *record = m->record;
    if (m->set.count == 0) return;
    if (record->growths) record->volume[record->growth_count] = m->set.volume;
    record->growth[record->growth_count++] = m->set.growth[0];
    m->set.count = 0;
}

/// Prepares a motion for a revolution, in which it may begin to be watched or recorded.
static whirl_status recorder_prepare(whirl_recorder *r, motion *m) {
    const bool sized_now = recorder_follows(r, m) && m->record->growth_count == 0;
    if (m->revolution == m->first_recorded || sized_now) whirl_ensemble_forget(r->ensemble, m->lane);
    if (r->carried > 0 && !r->variational && is_followed(r, m)) carry_perturbations(r, m, r->ensemble, m->lane);
    if (!recorder_follows(r, m) || m->copy_lane != NO_LANE) return whirl_ok();
    perturbed_copy_begin(&m->copy, m->x);
    if (r->used < r->lane_count) {
        m->copy_lane = take_lane(r, m);
        return whirl_ensemble_load(r->ensemble, m->copy_lane, m->task.system, m->copy.x);
    }
    leave_lanes(r, m);
    return whirl_ok();
}

/// Prepares all motions for a revolution. Motions may change their lanes meanwhile.
static whirl_status prepare_all(whirl_recorder *r) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < r->count && status.code == WHIRL_OK; i++)
        if (!recorder_waits(r->motions[i])) status = recorder_prepare(r, r->motions[i]);
    return status;
}

/// Returns the motion in a lane, if it is recorded in this revolution; NULL for a perturbed copy, an empty lane and a
/// motion that is not recorded yet. Motions move to other lanes whenever one is freed: look lanes up when they are
/// used, never store them.
static motion *recorded_in(const whirl_recorder *r, size_t lane) {
    motion *m = lane < r->used ? r->owner[lane] : NULL;
    return m && m->lane == lane && recorder_records(m) ? m : NULL;
}

/// Returns true in the first revolution with a perturbed copy, which gives the copy its size.
static bool is_sized(const motion *m) {
    return m->copy_lane != NO_LANE && m->record->growth_count == 0;
}

/// Returns true for the lane of a motion whose extremes are wanted in this revolution.
static bool is_observed(const whirl_recorder *r, size_t lane) {
    const motion *m = lane < r->used ? r->owner[lane] : NULL;
    return m && m->lane == lane && (recorder_records(m) || is_sized(m));
}

/// Carries all lanes over one revolution, and watches those whose motions are recorded.
static void revolve_lanes(whirl_recorder *r) {
    bool recording = false;
    for (size_t lane = 0; lane < r->lane_count; lane++) {
        r->recorded[lane] = is_observed(r, lane);
        recording = recording || r->recorded[lane];
    }
    r->watch.extremes = recording;
    r->sample_count = 0;
    whirl_ensemble_revolve(r->ensemble, r->used, recording ? &r->watch : NULL);
}

/// Takes one sample of all lanes' waveforms: rows of the ensemble, which are sorted by motion after the revolution.
static void recorder_sample(void *context) {
    whirl_recorder *r = context;
    double *to = r->samples + r->sample_count++ * 2 * r->probe_count * r->lane_count;
    for (size_t k = 0; k < 2 * r->probe_count; k++, to += r->lane_count) {
        const whirl_probe *probe = &r->probes[k / 2];
        if (whirl_probe_sees(probe, k % 2))
            memcpy(to, whirl_ensemble_coordinate(r->ensemble, k % 2 ? probe->y : probe->x), r->used * sizeof *to);
        else
            memset(to, 0, r->used * sizeof *to);
        for (size_t i = 0; probe->units && i < r->used; i++) to[i] *= probe->units[k % 2];
    }
}

/// Returns the next place in the waveforms of a lane's motion; NULL if nothing is recorded there.
static double *waveform_of(const whirl_recorder *r, size_t lane) {
    const motion *m = recorded_in(r, lane);
    return m ? m->record->waveform + m->record->sample_count : NULL;
}

/// Copies the samples of a revolution to the records, a few neighbouring lanes at a time, which are adjacent in memory.
static void keep_samples(const whirl_recorder *r) {
    enum { NEIGHBOURS = 8 };
    const size_t rows = 2 * r->probe_count;
    const size_t capacity = (size_t)r->options->record * r->sample_count; // every revolution has as many samples
    for (size_t first = 0; first < r->used && r->sample_count > 0; first += NEIGHBOURS) {
        double *to[NEIGHBOURS];
        for (size_t i = 0; i < NEIGHBOURS; i++) to[i] = waveform_of(r, first + i);
        for (size_t row = 0; row < rows; row++)
            for (size_t n = 0; n < r->sample_count; n++) {
                const double *from = r->samples + (n * rows + row) * r->lane_count + first;
                for (size_t i = 0; i < NEIGHBOURS; i++)
                    if (to[i]) to[i][row * capacity + n] = from[i];
            }
    }
}

static void follow_copy(whirl_recorder *r, motion *m) {
    whirl_ensemble_state(r->ensemble, m->copy_lane, m->copy.x);
    const bool bounded = whirl_ensemble_motion(r->ensemble, m->copy_lane) == WHIRL_BOUNDED;
    const bool first = is_sized(m);
    if (first) {
        whirl_ensemble_read(r->ensemble, m->lane,
                            &(whirl_ensemble_seen){.low = m->record->low, .high = m->record->high});
        perturbed_copy_size(&m->copy, m->record->low, m->record->high);
    }
    m->record->growth[m->record->growth_count++] = perturbed_copy_growth(&m->copy, m->x, first, bounded);
    whirl_ensemble_place(r->ensemble, m->copy_lane, m->copy.x);
}

/// Carries the perturbations of all watched motions if r->variational, an ensemble of their own, exists.
static whirl_status follow_all(whirl_recorder *r) {
    size_t count = 0;
    for (size_t i = 0; r->variational && i < r->count; i++) {
        motion *m = r->motions[i];
        if (recorder_waits(m) || !is_followed(r, m)) continue;
        const whirl_status status = whirl_ensemble_load(r->variational, count, m->task.system, m->x);
        if (status.code != WHIRL_OK) return status;
        carry_perturbations(r, m, r->variational, count++);
        if (count < whirl_ensemble_lanes(r->variational)) continue;
        whirl_ensemble_revolve(r->variational, count, NULL);
        count = 0;
    }
    if (count > 0) whirl_ensemble_revolve(r->variational, count, NULL);
    return whirl_ok();
}

/// Notes if a motion left its bounds only by passing the limit, with all coordinates finite.
static void note_limit(const whirl_recorder *r, const motion *m) {
    whirl_record *record = m->record;
    size_t farthest = 0;
    for (size_t i = 0; i < record->dimension; i++) {
        if (!isfinite(m->x[i])) return;
        if (fabs(m->x[i]) > fabs(m->x[farthest])) farthest = i;
    }
    if (record->motion != WHIRL_DIVERGED || !(fabs(m->x[farthest]) > r->integrate->limit)) return;
    record->limit = r->integrate->limit;
    record->limit_coordinate = farthest;
}

/// Notes the result of a motion's revolution.
static void recorder_note(whirl_recorder *r, motion *m) {
    whirl_record *record = m->record;
    // Take the new state; the record keeps the previous one.
    memcpy(record->end, m->x, record->dimension * sizeof *m->x);
    whirl_ensemble_state(r->ensemble, m->lane, m->x);
    record->motion = whirl_ensemble_motion(r->ensemble, m->lane);
    note_perturbations(m);
    if (recorder_records(m)) record->sample_count += r->sample_count;
    m->revolution++;
    record->revolutions += 1.0;
    // A motion that left its bounds ends here.
    if (record->motion != WHIRL_BOUNDED) {
        record->diverged_at = m->revolution;
        note_limit(r, m);
        return;
    }
    // Note the section, and the growth of a perturbation.
    if (m->revolution > r->first_watched) {
        if (m->copy_lane != NO_LANE) follow_copy(r, m);
        memcpy(record->section + record->section_count++ * record->dimension, m->x, record->dimension * sizeof *m->x);
    }
    // End the transient early if the motion has settled; Newton's method goes on.
    if (!m->settling || is_on_orbit(m)) return;
    const size_t period = settling_note(m->settling, m->x);
    if (period > 0) m->revolution = record_skip(r->options, m->revolution, period);
    if (m->approach) approach_goes_on(m->approach, m->settling);
}

/// Records the orbit of a motion that was put on it and has completed it once.
static void close_orbit(const whirl_recorder *r, const motion *m) {
    const orbit_search *orbit = approach_orbit(m->approach);
    orbits_record(m->record, orbit, orbit_search_distance(orbit, m->x));
    record_repeat_orbit(m->record, r->options);
}

static void close_record(const whirl_recorder *r, const motion *m) {
    whirl_record *record = m->record;
#define SEEN(array, ...) .array = record->array,
    const whirl_ensemble_seen seen = {.low = record->low, .high = record->high, WHIRL_WATCHED(SEEN)};
#undef SEEN
    whirl_ensemble_read(r->ensemble, m->lane, &seen);
    if (is_on_orbit(m)) close_orbit(r, m);
    whirl_seen_end(m->task.system, (size_t)r->options->record * (size_t)r->integrate->steps_per_revolution, &seen);
    memcpy(record->end, m->x, record->dimension * sizeof *m->x);
}

/// Completes the records of finished motions.
static whirl_status recorder_complete(const whirl_recorder *r) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < r->count && status.code == WHIRL_OK; i++) {
        const motion *m = r->motions[i];
        if (!is_over(r, m)) continue;
        if (m->record->motion == WHIRL_BOUNDED) close_record(r, m);
        status = at_rest_look(m->task.system, r->integrate, m->record);
        if (status.code == WHIRL_OK) status = steps_look(m->task.system, r->integrate, m->record);
        record_close_turns(m->record);
    }
    return status;
}

// ---------------------------------------------------------------- orbits

/// Returns the period of an orbit to be searched near the motion; 0: none.
static size_t orbit_to_try(const whirl_recorder *r, const motion *m) {
    if (recorder_waits(m) || m->record->motion != WHIRL_BOUNDED || is_on_orbit(m)) return 0;
    if (m->revolution == r->last) return orbits_settled_period(m->record, r->options);
    if (!m->approach || m->revolution >= r->options->transient) return 0;
    return approach_tries(m->approach, m->settling, m->revolution);
}

/// Starts the searches of motions near an orbit. They leave their lanes and wait until there are enough: Newton's
/// method is cheapest side by side.
static whirl_status recorder_start_searches(whirl_recorder *r) {
    for (size_t i = 0; i < r->count && r->searches; i++) {
        motion *m = r->motions[i];
        const size_t k = orbit_to_try(r, m);
        if (k == 0) continue;
        m->search = orbit_search_new(m->task.system, k, m->x);
        if (!m->search) return whirl_fail(WHIRL_NO_MEMORY, "no memory to look for an orbit");
        leave_lanes(r, m);
    }
    return whirl_ok();
}

/// Puts a motion on the orbit that it approaches, for one recorded period.
static void set_on_orbit(whirl_recorder *r, motion *m) {
    const orbit_search *orbit = approach_orbit(m->approach);
    m->record->orbit.set_at = m->revolution;
    leave_copy(r, m);
    memcpy(m->x, orbit->nodes, r->dimension * sizeof *m->x);
    if (!recorder_waits(m)) whirl_ensemble_place(r->ensemble, m->lane, m->x);
    m->revolution = m->first_recorded = r->last - (int)orbit->revolutions;
    record_begin_orbit(m->record, r->options, orbit->revolutions);
}

/// Takes the result of a motion's search.
static whirl_status take_search(const whirl_recorder *r, motion *m) {
    orbit_search *s = m->search;
    m->search = NULL;
    m->record->orbit.revolutions += s->carried;
    if (m->revolution < r->last) return approach_take(m->approach, s, m->settling, m->revolution);
    orbits_record(m->record, s, orbit_search_distance(s, m->x));
    free(s);
    return whirl_ok();
}

/// Returns how many of `count` motions may continue to wait for Newton's method: fewer than half of the lanes of the
/// searches, and fewer than a quarter of the other motions; none once a waiting motion has reached its last revolution
/// or has diverged.
static size_t may_wait(const whirl_recorder *r, size_t count) {
    const size_t lanes = orbit_searches_lanes(r->searches) / 2, others = (r->count - count) / 4;
    const size_t most = lanes < others ? lanes : others;
    for (size_t i = 0; i < r->count; i++)
        if (r->motions[i]->search && is_over(r, r->motions[i])) return 0;
    return most > 0 ? most - 1 : 0;
}

/// Runs the searches of the motions that wait.
static whirl_status look_for_orbits(whirl_recorder *r) {
    orbit_search **searches = r->searches ? calloc(r->count + 1, sizeof(orbit_search *)) : NULL;
    if (!searches) return r->searches ? whirl_fail(WHIRL_NO_MEMORY, "no memory to look for orbits") : whirl_ok();
    size_t count = 0;
    for (size_t i = 0; i < r->count; i++)
        if (r->motions[i]->search) searches[count++] = r->motions[i]->search;
    whirl_status status = orbit_searches_run(r->searches, searches, count, may_wait(r, count) + 1);
    for (size_t i = 0; i < r->count && status.code == WHIRL_OK; i++)
        if (r->motions[i]->search && r->motions[i]->search->done) status = take_search(r, r->motions[i]);
    free(searches);
    return status;
}

/// Ends the transients of motions that must settle on their orbits.
static void end_transients(whirl_recorder *r) {
    for (size_t i = 0; i < r->count; i++) {
        motion *m = r->motions[i];
        const bool transient = !m->search && m->revolution < r->options->transient && !is_on_orbit(m);
        if (m->approach && transient && approach_arrives(m->approach, m->settling)) set_on_orbit(r, m);
    }
}

// ---------------------------------------------------------------- the four steps of a revolution

whirl_status whirl_recorder_begin(whirl_recorder *r) {
    const whirl_status status = look_for_orbits(r); // of restored motions that waited for it
    end_transients(r);
    return status.code == WHIRL_OK ? recorder_resume(r) : status;
}

whirl_status whirl_recorder_revolve(whirl_recorder *r, size_t *turned) {
    *turned = 0;
    whirl_status status = prepare_all(r);
    if (status.code != WHIRL_OK || r->count == 0) return status;
    status = follow_all(r);
    if (status.code != WHIRL_OK) return status;
    revolve_lanes(r);
    keep_samples(r);
    for (size_t i = 0; i < r->count; i++) {
        if (recorder_waits(r->motions[i])) continue;
        recorder_note(r, r->motions[i]);
        ++*turned;
    }
    status = recorder_complete(r);
    if (status.code == WHIRL_OK) status = recorder_start_searches(r);
    if (status.code == WHIRL_OK) status = look_for_orbits(r);
    end_transients(r);
    // Results since a stop are invalid: no record may be taken, and no state saved.
    if (status.code == WHIRL_OK && whirl_stop_is_set(r->stop)) return whirl_fail(WHIRL_STOPPED, "stopped");
    return status;
}

/// Removes a motion from the list; the others keep their order.
static motion *recorder_remove(whirl_recorder *r, size_t index) {
    motion *m = r->motions[index];
    r->count--;
    for (size_t i = index; i < r->count; i++) r->motions[i] = r->motions[i + 1];
    return m;
}

bool whirl_recorder_take(whirl_recorder *r, whirl_task *task, whirl_record **record) {
    size_t i = 0;
    while (i < r->count && !is_over(r, r->motions[i])) i++;
    if (i == r->count) return false;
    motion *m = recorder_remove(r, i);
    leave_lanes(r, m);
    *task = m->task;
    *record = m->record;
    m->record = NULL;
    motion_free(m);
    return true;
}

bool whirl_recorder_drop(whirl_recorder *r, whirl_task *task) {
    if (r->count == 0) return false;
    motion *m = recorder_remove(r, r->count - 1);
    leave_lanes(r, m);
    *task = m->task;
    motion_free(m);
    return true;
}

// ---------------------------------------------------------------- making

/// Returns how many perturbations an integrator carries with a motion. A perturbed copy gives the largest growth,
/// except with methods whose steps change abruptly, or systems with kinks.
static size_t count_carried(const whirl_system *system, const whirl_integrate_options *integrate,
                            const whirl_record_options *options) {
    const whirl_method *own;
    if (options->growth == WHIRL_GROWTH_ALL) return system->dimension;
    if (options->growth == WHIRL_GROWTH_NONE || !system->tangent) return 0;
    if (whirl_method_find(integrate->method, &own).code != WHIRL_OK) return 0;
    return own->follows_one || (system->kinked && own->follows) ? 1 : 0;
}

/// Returns true if motions and their copies run side by side: then a perturbed copy gives the largest growth.
static bool go_side_by_side(const whirl_system *system, const whirl_integrate_options *integrate,
                            const whirl_record_options *options) {
    if (!whirl_ensemble_takes(system, integrate)) return false;
    if (options->growth == WHIRL_GROWTH_ALL) return whirl_ensemble_follows(system, integrate);
    return options->growth == WHIRL_GROWTH_NONE || !system->kinked || !whirl_method_is_adaptive(integrate->method);
}

static whirl_status start_ensemble(whirl_recorder *r, const whirl_system *system, size_t lanes) {
    if (!go_side_by_side(system, r->integrate, r->options)) {
        r->carried = count_carried(system, r->integrate, r->options);
        r->max_count = 1; // one after the other
        return whirl_ensemble_alone(system, r->integrate, has_copies(r) ? 2 : 1, r->carried, &r->ensemble);
    }
    const whirl_status status = whirl_ensemble_new(system, r->integrate, lanes, &r->ensemble);
    if (status.code != WHIRL_OK || r->options->growth != WHIRL_GROWTH_ALL) return status;
    r->carried = system->dimension;
    return whirl_ensemble_variational(system, r->integrate, &r->variational);
}

static whirl_status recorder_start(whirl_recorder *r, const whirl_system *system, size_t lanes) {
    // Begin the ensemble and, if asked, the searches of orbits.
    const whirl_status status = start_ensemble(r, system, lanes);
    if (status.code != WHIRL_OK) return status;
    if (r->options->orbits && system->tangent) {
        const whirl_status orbits = orbit_searches_new(system, r->integrate, &r->searches);
        if (orbits.code == WHIRL_NO_MEMORY) return orbits;
    }
    // Allocate a motion for each lane, and more that wait while others search their orbit.
    r->lane_count = whirl_ensemble_lanes(r->ensemble);
    r->owner = calloc(r->lane_count, sizeof(motion *));
    r->recorded = calloc(r->lane_count, sizeof *r->recorded);
    if (r->max_count == 0) r->max_count = r->searches ? 2 * r->lane_count : r->lane_count; // some wait for their orbit
    r->motions = calloc(r->max_count, sizeof(motion *));
    r->probes = system->probes;
    r->probe_count = whirl_watched_probes(system);
    // Describe to the ensemble which instants are wanted.
    r->watch = (whirl_ensemble_observe){.sample = recorder_sample, .context = r, .lanes = r->recorded};
    if (r->options->waveform)
        r->watch.stride = (size_t)(r->integrate->steps_per_revolution /
                                   whirl_record_samples(r->options, r->integrate->steps_per_revolution));
    const size_t samples = r->watch.stride > 0 ? (size_t)r->integrate->steps_per_revolution / r->watch.stride : 0;
    r->samples = calloc(samples * 2 * r->probe_count * r->lane_count + 1, sizeof *r->samples);
    if (!r->owner || !r->recorded || !r->motions || !r->samples)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu lanes", r->lane_count);
    return whirl_ok();
}

void whirl_recorder_free(whirl_recorder *r) {
    if (!r) return;
    for (size_t i = 0; i < r->count; i++) motion_free(r->motions[i]);
    free(r->motions);
    free(r->owner);
    free(r->recorded);
    free(r->samples);
    whirl_ensemble_free(r->ensemble);
    whirl_ensemble_free(r->variational);
    orbit_searches_free(r->searches);
    free(r);
}

whirl_status whirl_recorder_new(const whirl_system *system, const whirl_integrate_options *integrate,
                                const whirl_record_options *options, size_t lanes, whirl_recorder **out) {
    *out = NULL;
    whirl_status status = whirl_record_check(system, integrate, options);
    if (status.code != WHIRL_OK) return status;
    whirl_recorder *r = calloc(1, sizeof *r);
    if (!r) return whirl_fail(WHIRL_NO_MEMORY, "no memory to record motions");
    r->integrate = integrate;
    r->options = options;
    r->stop = system->stop;
    r->dimension = system->dimension;
    r->last = options->transient + options->record;
    r->first_watched = r->last - whirl_record_watch(options);
    status = recorder_start(r, system, lanes);
    if (status.code == WHIRL_OK)
        *out = r;
    else
        whirl_recorder_free(r);
    return status;
}
