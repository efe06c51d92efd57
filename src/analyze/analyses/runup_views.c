// Spectra of run-ups. A spectrum is that of x + iy over the angle of the shaft, in the last turns before its time, with
// a Hann window and without the mean: orders are lines whatever the speed does.
#include <math.h>
#include <stdlib.h>

#include "runup_parts.h"

static const double two_pi = 6.283185307179586476925;

size_t runup_bins(const whirl_runup_options *options) {
    if (options->spectra == 0) return 0;
    return spectrum_bins((size_t)options->spectrum_turns, (size_t)options->samples, options->highest_order);
}

whirl_status runup_views_new(const block_view *view, const whirl_runup_options *options, const whirl_system *system,
                             size_t contacts, double duration, runup_views *views) {
    const size_t turns = options->spectra > 0 ? (size_t)options->spectrum_turns : 0, bins = runup_bins(options);
    *views = (runup_views){.view = view, .options = options, .duration = duration};
    if (turns == 0) return whirl_ok();
    views->clockwise = system->probe_count > 0 && whirl_probe_way(&system->probes[0]) < 0.0;
    views->samples = turn_samples_new((size_t)options->samples, system->probe_count, contacts);
    views->history = turn_history_new(turns, &views->samples);
    views->memory = calloc(2 * turns * views->samples.samples, sizeof *views->memory);
    for (size_t bin = 0; bin < bins; bin++) view_numbers(view, SPECTRUM_ORDER, 0)[bin] = (double)bin / (double)turns;
    if (views->samples.numbers && views->history.numbers && views->memory) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for spectra of a run");
}

void runup_views_free(runup_views *views) {
    free(views->samples.numbers);
    free(views->history.numbers);
    free(views->memory);
}

/// Fills a spectrum from the last turns; it stays missing where there are too few.
static whirl_status runup_fill_spectrum(runup_views *views, size_t row) {
    const turn_samples *of = &views->samples;
    const size_t turns = (size_t)views->options->spectrum_turns, count = turns * of->samples;
    const size_t bins = runup_bins(views->options);
    const double *numbers = turn_history_last(&views->history, turns);
    if (!numbers) return whirl_ok();
    view_numbers(views->view, SPECTRUM_TIME, 0)[row] = 0.5 * (numbers[0] + views->history.end);
    view_numbers(views->view, SPECTRUM_SPEED, 0)[row] = two_pi * (double)turns / (views->history.end - numbers[0]);
    double *x = views->memory, *y = x + count;
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
        double *out = view_numbers(views->view, SPECTRUM, p) + 2 * row * bins;
        for (size_t bin = 0; bin < bins; bin++)
            for (size_t way = 0; way < 2; way++) out[2 * bin + way] = ways[way][bin];
        whirl_spectrum_free(made);
    }
    return whirl_ok();
}

/// Fills the spectra whose time comes before the turn that ends at `end`.
static whirl_status runup_fill_due(runup_views *views, double end) {
    whirl_status status = whirl_ok();
    const size_t all = (size_t)views->options->spectra;
    for (; views->spectra < all && status.code == WHIRL_OK; views->spectra++) {
        if (!((double)(views->spectra + 1) / (double)all * views->duration * (1.0 + 1e-12) < end)) break;
        status = runup_fill_spectrum(views, views->spectra);
    }
    return status;
}

whirl_status runup_views_add(runup_views *views, const runup_turn *turn) {
    if (!views->samples.numbers) return whirl_ok();
    const whirl_status status = runup_fill_due(views, turn->end);
    if (turn->samples) turn_history_add(&views->history, turn->samples, turn->end);
    return status;
}

whirl_status runup_views_end(runup_views *views, double time) {
    return views->samples.numbers ? runup_fill_due(views, nextafter(time, INFINITY) * (1.0 + 1e-9)) : whirl_ok();
}
