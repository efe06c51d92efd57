// The main spectral lines off whole orders. They characterize motions whose record is too short for the section, such
// as self-excited whirl with a period of a fraction of a revolution. A fit shows whether they keep their places and
// sizes. See docs/theory.md, "Lines".
#include <math.h>
#include <stdlib.h>

#include "line_fit.h"
#include "main_line.h"
#include "section.h"
#include "spectrum.h"

enum { MIN_REVOLUTIONS = 32, MAX_STATIONS = 64, MAX_MULTIPLE = 8, LOW_MULTIPLE = 3 };

/// Bins within which a line counts as a whole order or as constant.
static const double whole_order_bins = 3.0;

/// Highest order of the search: lines above are combinations of lower ones.
static const double highest = 4.0;

/// Smaller lines than this share of the largest need not be combinations of known frequencies.
static const double matters = 0.01;

static double main_line_amplitude(const whirl_line *line) {
    return hypot(line->x, line->y);
}

/// Makes the spectrum of a station over the record; NULL without one.
static whirl_spectrum *spectrum_at(const whirl_record *record, size_t station) {
    whirl_spectrum *spectrum = NULL;
    const double *x = record->waveform + 2 * station * record->sample_count, *y = x + record->sample_count;
    const whirl_status status =
        spectrum_of(x, y, record->sample_count, record->samples_per_revolution, highest, false, &spectrum);
    return status.code == WHIRL_OK ? spectrum : NULL;
}

static const whirl_line *largest_other_line(const whirl_spectrum *spectrum) {
    const double away = whole_order_bins * spectrum->resolution;
    for (size_t i = 0; i < spectrum->line_count; i++) {
        const double order = spectrum->lines[i].order;
        if (order > away && fabs(order - round(order)) > away) return &spectrum->lines[i];
    }
    return NULL;
}

/// Returns half the diagonal of the box in which a station moves.
static double half_extent(const whirl_record *record, size_t station) {
    const whirl_probe *probe = &record->probes[station];
    return 0.5 * hypot(whirl_probe_value(probe, record->high, 0) - whirl_probe_value(probe, record->low, 0),
                       whirl_probe_value(probe, record->high, 1) - whirl_probe_value(probe, record->low, 1));
}

/// Returns the largest line that matters and is no combination of the frequencies, up to `most` multiples of them; NULL
/// without one.
static const whirl_line *unmatched_line(const whirl_spectrum *spectrum, const line_bases *bases, int most) {
    for (size_t i = 0; i < spectrum->line_count; i++) {
        const whirl_line *line = &spectrum->lines[i];
        if (main_line_amplitude(line) < matters * main_line_amplitude(&spectrum->lines[0])) return NULL;
        const line_combination of = line_combination_of(bases, line->order, spectrum->resolution);
        if (!of.matches || abs(of.times[0]) + abs(of.times[1]) > most) return line;
    }
    return NULL;
}

/// Takes a second line, and fits both to the record, to see how they change and whether they are the whole motion.
/// If the second one is too near to the first, the first one is fitted alone.
static void main_line_fit(main_line *found, const whirl_record *record, size_t station, const whirl_spectrum *spectrum,
                          const whirl_line *second) {
    const double left[] = {[1] = 1e-2, [2] = 1e-3}; // of the mean square, at which lines are the whole motion
    const double half = 0.5 * (double)record->record_count;
    line_bases bases = {.count = 1, .orders = {found->order}};
    line_fit fit = {.found = false};
    if (second) {
        found->second = second->order;
        found->second_share = main_line_amplitude(second) / half_extent(record, station);
        bases = (line_bases){.count = 2, .orders = {found->order, second->order}};
        fit = line_fit_record(record, station, spectrum, &bases);
        if (!fit.found) bases.count = 1;
    }
    if (!fit.found) fit = line_fit_record(record, station, spectrum, &bases);
    if (!fit.found) return;
    found->trend = fit.trend[0];
    found->drift = fit.wander[0] * half;
    if (bases.count > 1) {
        found->second_trend = fit.trend[1];
        found->second_drift = fit.wander[1] * half;
    }
    if (!unmatched_line(spectrum, &bases, MAX_MULTIPLE) && fit.unexplained <= left[bases.count])
        found->frequencies = (int)bases.count + 1;
}

main_line main_line_find(const whirl_record *record) {
    main_line found = {.order = NAN,
                       .share = NAN,
                       .trend = NAN,
                       .drift = NAN,
                       .second = NAN,
                       .second_share = NAN,
                       .second_trend = NAN,
                       .second_drift = NAN};
    size_t station = 0;
    whirl_spectrum *spectrum = NULL;
    if (record->sample_count == 0 || record->record_count < MIN_REVOLUTIONS) return found;
    // Find the station whose spectrum has the strongest line that is no multiple of the speed.
    for (size_t s = 0; s < record->probe_count && s < MAX_STATIONS; s++) {
        whirl_spectrum *own = spectrum_at(record, s);
        const whirl_line *line = own ? largest_other_line(own) : NULL;
        const double extent = half_extent(record, s);
        const double share = line && extent > 0.0 ? main_line_amplitude(line) / extent : 0.0;
        const bool best = share > 0.0 && !(share <= found.share);
        if (best) {
            found.share = share;
            found.order = line->order;
            station = s;
        }
        whirl_spectrum_free(best ? spectrum : own);
        if (best) spectrum = own;
    }
    // Find a second frequency, and see how both change. A high multiple of one frequency may match a line by chance: if
    // the lines found change or do not explain the motion, a line that only a high multiple matches is tried as the
    // second one.
    if (spectrum) {
        const line_bases one = {.count = 1, .orders = {found.order}};
        const whirl_line *second = unmatched_line(spectrum, &one, MAX_MULTIPLE),
                         *other = unmatched_line(spectrum, &one, LOW_MULTIPLE);
        main_line by_other = found;
        main_line_fit(&found, record, station, spectrum, second);
        if (other != second && !main_line_stays(&found, record)) {
            main_line_fit(&by_other, record, station, spectrum, other);
            if (main_line_stays(&by_other, record)) found = by_other;
        }
    }
    whirl_spectrum_free(spectrum);
    return found;
}

bool main_line_stays(const main_line *line, const whirl_record *record) {
    const double bins = 0.05, change = 2e-3, revolutions = (double)record->record_count;
    const bool first = fabs(line->drift) * revolutions <= bins && fabs(line->trend) * revolutions <= change;
    const bool second = fabs(line->second_drift) * revolutions <= bins &&
                        fabs(line->second_trend) * revolutions * line->second_share <= change * line->share;
    return line->frequencies > 0 && first && (line->frequencies == 2 || second);
}
