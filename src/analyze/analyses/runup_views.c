// Spectra, orbits and waveforms of run-ups. A spectrum is that of x + iy over the angle of the shaft, in the last turns
// before its time, with a Hann window and without the mean: so orders remain lines however the speed changes.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "runup_parts.h"
#include "spectrum.h"
#include "two_pi.h"

size_t runup_bins(const whirl_runup_options *options) {
    if (options->spectra == 0) return 0;
    return spectrum_bins((size_t)options->spectrum_turns, (size_t)options->samples, options->highest_order);
}

/// Returns the number of turns that have to be kept.
static size_t views_max_turns(const whirl_runup_options *options) {
    const int spectrum = options->spectra > 0 ? options->spectrum_turns : 0, orbit = options->orbits > 0;
    const int turns = spectrum > options->waveform ? spectrum : options->waveform;
    return (size_t)(turns > orbit ? turns : orbit);
}

whirl_status runup_views_new(const block_view *view, const whirl_runup_options *options, const whirl_system *system,
                             size_t contacts, size_t watched, double duration, runup_views *views) {
    const size_t turns = views_max_turns(options), bins = runup_bins(options), all = system->probe_count + contacts;
    *views = (runup_views){.view = view, .options = options, .system = system, .duration = duration};
    if (turns == 0) return whirl_ok();
    views->clockwise = system->probe_count > 0 && whirl_probe_way(&system->probes[0]) < 0.0;
    // Only orbits need torques within a turn: those on the shaft if torques turn it, and those of each of several
    // shafts also if one of them has a speed of its own.
    const bool torques = options->orbits > 0 && whirl_runup_driven(options);
    const bool shafts = torques || (options->orbits > 0 && options->shaft_count > 0);
    views->samples = turn_samples_new((size_t)options->samples, whirl_watched_probes(system), contacts,
                                      torques ? RUNUP_SHAFT_TORQUES + watched : 0, shafts ? system->shaft_count : 0);
    views->history = turn_history_new(turns, &views->samples);
    views->memory = calloc(2 * turns * views->samples.samples, sizeof *views->memory);
    views->largest = calloc(all + 1, sizeof *views->largest);
    views->due = calloc(WHIRL_RUNUP_WAVEFORMS * all + 1, sizeof *views->due);
    for (size_t bin = 0; bin < bins; bin++)
        view_numbers(view, SPECTRUM_ORDER, 0)[bin] = (double)bin / (double)options->spectrum_turns;
    if (views->samples.numbers && views->history.numbers && views->memory && views->largest && views->due)
        return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for turns of a run");
}

void runup_views_free(runup_views *views) {
    free(views->samples.numbers);
    free(views->history.numbers);
    free(views->memory);
    free(views->largest);
    free(views->due);
}

/// Fills a spectrum from the last turns; it stays missing where there are too few.
static whirl_status runup_fill_spectrum(runup_views *views, size_t row) {
    // Find the last turns, if there are enough.
    const turn_samples *of = &views->samples;
    const size_t turns = (size_t)views->options->spectrum_turns, count = turns * of->samples;
    const size_t bins = runup_bins(views->options);
    const double *numbers = turn_history_last(&views->history, turns);
    if (!numbers) return whirl_ok();
    // The time of a spectrum is the middle of its turns.
    view_numbers(views->view, SPECTRUM_TIME, 0)[row] = 0.5 * (numbers[0] + views->history.end);
    view_numbers(views->view, SPECTRUM_SPEED, 0)[row] = two_pi * (double)turns / (views->history.end - numbers[0]);
    double *x = views->memory, *y = x + count;
    // Transform the motion of each station, and its axial displacement and twist; forward is the sense of the shaft.
    for (size_t p = 0; p < of->probes; p++) {
        whirl_spectrum *made = NULL;
        for (size_t k = 0; k < count; k++) {
            x[k] = numbers[k * of->width + 1 + 2 * p];
            y[k] = numbers[k * of->width + 2 + 2 * p];
        }
        const whirl_status status = spectrum_of(x, y, count, of->samples, views->options->highest_order, false, &made);
        if (status.code != WHIRL_OK) return status;
        const double *ways[] = {views->clockwise ? made->backward : made->forward,
                                views->clockwise ? made->forward : made->backward};
        const size_t stations = views->system->probe_count;
        double *out = p < stations ? view_numbers(views->view, SPECTRUM, p) + 2 * row * bins : NULL;
        if (p >= stations) {
            const whirl_extra *extra = &views->system->extras[p - stations];
            memcpy(view_numbers(views->view, runup_extra_field(extra, AXIAL_SPECTRUM), extra->station) + row * bins,
                   made->x, bins * sizeof *made->x);
        }
        for (size_t bin = 0; out && bin < bins; bin++)
            for (size_t way = 0; way < 2; way++) out[2 * bin + way] = ways[way][bin];
        whirl_spectrum_free(made);
    }
    return whirl_ok();
}

/// Fills an orbit of a station from a turn.
static void runup_fill_orbit(const runup_views *views, const double *turn, size_t station, double *out) {
    const turn_samples *of = &views->samples;
    for (size_t k = 0; k < of->samples; k++)
        for (size_t axis = 0; axis < 2; axis++) out[2 * k + axis] = turn[k * of->width + 1 + 2 * station + axis];
}

/// Fills the times of the instants of an orbit's turn since its beginning, and the forces, gaps and torques at them.
static void runup_fill_instants(const runup_views *views, const double *turn, size_t row) {
    const turn_samples *of = &views->samples;
    const size_t first = row * of->samples, all = (size_t)views->options->orbits * of->samples;
    for (size_t k = 0; k < of->samples; k++) {
        const double *contact = turn + k * of->width + 1 + 2 * of->probes, *torque = contact + 2 * of->contacts;
        view_numbers(views->view, ORBIT_INSTANT, 0)[first + k] = turn[k * of->width] - turn[0];
        for (size_t c = 0; c < of->contacts; c++) {
            view_numbers(views->view, ORBIT_FORCE, c)[first + k] = contact[2 * c];
            view_numbers(views->view, ORBIT_GAP, c)[first + k] = contact[2 * c + 1];
        }
        for (size_t t = 0; t < of->torques; t++)
            if (t < RUNUP_SHAFT_TORQUES)
                view_numbers(views->view, ORBIT_TORQUE, 0)[(first + k) * RUNUP_SHAFT_TORQUES + t] = torque[t];
            else
                view_numbers(views->view, ORBIT_TORQUE_COURSE, 0)[(t - RUNUP_SHAFT_TORQUES) * all + first + k] =
                    torque[t];
        for (size_t s = 0; s < of->shafts; s++) {
            const double *own = torque + of->torques + RUNUP_SHAFT_NUMBERS * s;
            double *out = view_numbers(views->view, ORBIT_SHAFT_TORQUE, 0) + RUNUP_SHAFT_PARTS * (s * all + first + k);
            memcpy(out, own, RUNUP_SHAFT_PARTS * sizeof *own);
            view_numbers(views->view, ORBIT_SHAFT_SPEED, 0)[s * all + first + k] = own[RUNUP_SHAFT_PARTS];
        }
    }
}

/// Fills the orbits of a time from the last turn; they stay missing before there is one.
static void runup_fill_orbits(runup_views *views, size_t row) {
    const double *turn = turn_history_last(&views->history, 1);
    if (!turn) return;
    view_numbers(views->view, ORBIT_TIME, 0)[row] = 0.5 * (turn[0] + views->history.end);
    view_numbers(views->view, ORBIT_SPEED, 0)[row] = two_pi / (views->history.end - turn[0]);
    const size_t stations = views->system->probe_count, samples = views->samples.samples;
    for (size_t p = 0; p < stations; p++)
        runup_fill_orbit(views, turn, p, view_numbers(views->view, ORBIT, p) + 2 * row * samples);
    for (size_t i = 0; i < views->system->extra_count; i++) {
        const whirl_extra *extra = &views->system->extras[i];
        const size_t field = runup_extra_field(extra, AXIAL_ORBIT);
        double *out = view_numbers(views->view, field, extra->station) + row * samples;
        for (size_t k = 0; k < samples; k++) out[k] = turn[k * views->samples.width + 1 + 2 * (stations + i)];
    }
    runup_fill_instants(views, turn, row);
}

/// Fills the spectra and orbits whose time comes before `end`, the end of a turn, from the turns before this one.
static whirl_status runup_fill_due(runup_views *views, double end) {
    whirl_status status = whirl_ok();
    const double now = end / (1.0 + 1e-12);
    const size_t spectra = (size_t)views->options->spectra, orbits = (size_t)views->options->orbits;
    for (; views->spectra < spectra && status.code == WHIRL_OK; views->spectra++) {
        if (!((double)(views->spectra + 1) / (double)spectra * views->duration < now)) break;
        status = runup_fill_spectrum(views, views->spectra);
    }
    for (; views->orbits < orbits; views->orbits++) {
        if (!((double)(views->orbits + 1) / (double)orbits * views->duration < now)) break;
        runup_fill_orbits(views, views->orbits);
    }
    return status;
}

// ---------------------------------------------------------------- waveforms

/// Fills the axial displacement and the twist of a station in a waveform, from a row of samples.
static void runup_fill_extras(const runup_views *views, size_t station, const double *row, size_t at) {
    const whirl_system *system = views->system;
    for (size_t i = 0; i < system->extra_count; i++)
        if (system->extras[i].station == station)
            view_numbers(views->view, runup_extra_field(&system->extras[i], AXIAL_WAVEFORM), station)[at] =
                row[1 + 2 * (system->probe_count + i)];
}

/// Fills a waveform of station number `which`, or of a contact, whose numbers follow those of the stations, from the
/// last turns; from all that are held if they are fewer than a waveform has.
static void runup_fill_waveform(const runup_views *views, size_t which, size_t window) {
    const turn_samples *of = &views->samples;
    size_t turns = (size_t)views->options->waveform;
    const size_t first = window * turns * of->samples;
    if (turns > views->history.held) turns = views->history.held;
    const size_t stations = views->system->probe_count;
    const bool contact = which >= stations;
    const size_t owner = contact ? which - stations : which;
    const size_t column = contact ? 1 + 2 * of->probes + 2 * owner : 1 + 2 * owner;
    const double *numbers = turn_history_last(&views->history, turns);
    double *time = view_numbers(views->view, contact ? CONTACT_TIME : WAVEFORM_TIME, owner) + first;
    for (size_t k = 0; numbers && k < turns * of->samples; k++) {
        const double *row = numbers + k * of->width;
        time[k] = row[0];
        if (contact) {
            view_numbers(views->view, CONTACT_FORCE, owner)[first + k] = row[column];
            view_numbers(views->view, CONTACT_GAP, owner)[first + k] = row[column + 1];
        } else {
            for (size_t axis = 0; axis < 2; axis++)
                view_numbers(views->view, WAVEFORM, owner)[2 * (first + k) + axis] = row[column + axis];
            runup_fill_extras(views, owner, row, first + k);
        }
    }
}

/// Fills the waveforms that are complete after the last turn; with `ended`, also the incomplete ones.
static void runup_fill_waveforms(const runup_views *views, bool ended) {
    const size_t all = views->system->probe_count + views->samples.contacts;
    for (size_t window = 0; window < WHIRL_RUNUP_WAVEFORMS; window++)
        for (size_t which = 0; which < all; which++) {
            size_t *due = &views->due[window * all + which];
            if (*due == 0 || (!ended && *due != views->turns)) continue;
            runup_fill_waveform(views, which, window);
            *due = 0;
        }
}

/// Notes a turn with an event, and stations and contacts whose largest motion or force is in this turn.
static void runup_note_turn(runup_views *views, const runup_turn *turn) {
    const size_t stations = views->system->probe_count;
    const size_t all = stations + views->samples.contacts, waveform = (size_t)views->options->waveform;
    const size_t complete = views->turns + waveform / 2;
    if (turn->parted) views->events++;
    for (size_t which = 0; which < all; which++) {
        const double size = which < stations ? turn->stations[which].radius : turn->force[which - stations];
        const bool larger = size > views->largest[which];
        if (larger) views->largest[which] = size;
        if (larger && which < stations && views->options->orbits > 0)
            runup_fill_orbit(views, turn->samples, which, view_numbers(views->view, PEAK_ORBIT, which));
        if (larger && waveform > 0) views->due[which] = complete;
        if (turn->parted && waveform > 0 && views->events < WHIRL_RUNUP_WAVEFORMS)
            views->due[views->events * all + which] = complete;
    }
}

// ---------------------------------------------------------------- turns

whirl_status runup_views_add(runup_views *views, const runup_turn *turn) {
    if (!views->samples.numbers) return whirl_ok();
    const whirl_status status = runup_fill_due(views, turn->end);
    if (turn->samples) {
        views->turns++;
        turn_history_add(&views->history, turn->samples, turn->end);
        runup_note_turn(views, turn);
        runup_fill_waveforms(views, false);
    }
    return status;
}

void runup_views_archive(runup_views *views, archive *a) {
    const size_t all = views->system->probe_count + views->samples.contacts;
    turn_history *history = &views->history;
    if (!views->samples.numbers) return;
    archive_count(a, &views->spectra, (size_t)views->options->spectra);
    archive_count(a, &views->orbits, (size_t)views->options->orbits);
    archive_part(a, &views->turns, sizeof views->turns);
    archive_part(a, &views->events, sizeof views->events);
    archive_part(a, views->largest, all * sizeof *views->largest);
    archive_part(a, views->due, WHIRL_RUNUP_WAVEFORMS * all * sizeof *views->due);
    archive_count(a, &history->held, 2 * history->capacity);
    archive_part(a, history->numbers, history->held * history->turn * sizeof *history->numbers);
    archive_part(a, &history->end, sizeof history->end);
}

whirl_status runup_views_end(runup_views *views, double time) {
    if (!views->samples.numbers) return whirl_ok();
    runup_fill_waveforms(views, true);
    return runup_fill_due(views, time * (1.0 + 1e-9));
}
