// The main spectral line off whole orders. It characterizes motions whose record is too short for the section, such as
// self-excited whirl with a period of a fraction of a revolution. Two halves of the record show whether the line keeps
// its place and size. See docs/theory.md, "Lines".
#include <math.h>

#include "analysis.h"
#include "main_line.h"
#include "section.h"

enum { MIN_REVOLUTIONS = 32, MAX_STATIONS = 64, MAX_MULTIPLE = 8 };

/// Bins within which a line counts as a whole order or as constant; and within which the lines of both halves are the
/// same.
static const double beside = 3.0, same_line = 1.0;

/// Highest order of the search: lines above are combinations of lower ones.
static const double highest = 4.0;

static double main_line_amplitude(const whirl_line *line) {
    return hypot(line->x, line->y);
}

/// Makes the spectrum of a station over `count` samples from `first`; NULL without one.
static whirl_spectrum *spectrum_part(const whirl_record *record, size_t station, size_t first, size_t count) {
    whirl_spectrum *spectrum = NULL;
    const double *x = record->waveform + 2 * station * record->sample_count + first, *y = x + record->sample_count;
    const whirl_status status = spectrum_of(x, y, count, record->samples_per_revolution, highest, false, &spectrum);
    return status.code == WHIRL_OK ? spectrum : NULL;
}

static bool is_beside(double order, double resolution) {
    return order > beside * resolution && fabs(order - round(order)) > beside * resolution;
}

static const whirl_line *largest_beside(const whirl_spectrum *spectrum) {
    for (size_t i = 0; i < spectrum->line_count; i++)
        if (is_beside(spectrum->lines[i].order, spectrum->resolution)) return &spectrum->lines[i];
    return NULL;
}

static const whirl_line *nearest_line(const whirl_spectrum *spectrum, double order) {
    const whirl_line *nearest = NULL;
    for (size_t i = 0; spectrum && i < spectrum->line_count; i++)
        if (!nearest || fabs(spectrum->lines[i].order - order) < fabs(nearest->order - order))
            nearest = &spectrum->lines[i];
    return nearest && fabs(nearest->order - order) <= same_line * spectrum->resolution ? nearest : NULL;
}

/// Returns true if all significant lines are at sums of multiples of the order and of whole orders.
static bool are_of_two(const whirl_spectrum *spectrum, double order) {
    const double matters = 0.01, bins = 0.2;
    for (size_t i = 0; i < spectrum->line_count; i++) {
        const whirl_line *line = &spectrum->lines[i];
        double away = INFINITY;
        if (main_line_amplitude(line) < matters * main_line_amplitude(&spectrum->lines[0])) continue;
        for (int k = -MAX_MULTIPLE; k <= MAX_MULTIPLE; k++) {
            const double off = line->order - k * order;
            away = fmin(away, fabs(off - round(off)));
        }
        if (away > bins * spectrum->resolution) return false;
    }
    return true;
}

/// Share of the samples' mean square that the lines leave unexplained.
static double main_line_unexplained(const whirl_record *record, size_t station, const whirl_spectrum *spectrum) {
    const size_t count = record->sample_count;
    double squares = 0.0, lines = 0.0;
    for (size_t c = 0; c < 2; c++) {
        const double *x = record->waveform + (2 * station + c) * count;
        double mean = 0.0;
        for (size_t j = 0; j < count; j++) mean += x[j] / (double)count;
        for (size_t j = 0; j < count; j++) squares += (x[j] - mean) * (x[j] - mean) / (double)count;
    }
    for (size_t i = 0; i < spectrum->line_count; i++) lines += 0.5 * pow(main_line_amplitude(&spectrum->lines[i]), 2.0);
    return fabs(squares - lines) / squares;
}

main_line main_line_find(const whirl_record *record) {
    main_line found = {.order = NAN, .share = NAN, .trend = NAN};
    size_t station = 0;
    if (record->sample_count == 0 || record->record_count < MIN_REVOLUTIONS) return found;
    // Find the station whose spectrum has the strongest line that is no multiple of the speed.
    for (size_t s = 0; s < record->probe_count && s < MAX_STATIONS; s++) {
        whirl_spectrum *spectrum = spectrum_part(record, s, 0, record->sample_count);
        const whirl_line *line = spectrum ? largest_beside(spectrum) : NULL;
        const double extent = hypot(whirl_probe_value(&record->probes[s], record->high, 0) -
                                        whirl_probe_value(&record->probes[s], record->low, 0),
                                    whirl_probe_value(&record->probes[s], record->high, 1) -
                                        whirl_probe_value(&record->probes[s], record->low, 1));
        const double share = line && extent > 0.0 ? main_line_amplitude(line) / (0.5 * extent) : 0.0;
        if (share > 0.0 && !(share <= found.share)) {
            found.share = share;
            found.order = line->order;
            found.two = are_of_two(spectrum, line->order) && main_line_unexplained(record, s, spectrum) <= 0.01;
            station = s;
        }
        whirl_spectrum_free(spectrum);
    }
    // Compare that line in the first half of the record and in the second.
    if (isnan(found.order)) return found;
    const size_t half = record->record_count / 2 * record->samples_per_revolution;
    whirl_spectrum *early = spectrum_part(record, station, 0, half),
                   *late = spectrum_part(record, station, record->sample_count - half, half);
    const whirl_line *first = nearest_line(early, found.order), *second = nearest_line(late, found.order);
    if (first && second) {
        const double revolutions = (double)record->record_count - 0.5 * (double)record->record_count;
        found.trend = log(main_line_amplitude(second) / main_line_amplitude(first)) / revolutions;
        found.drift = second->order - first->order;
    } else {
        found.two = false;
    }
    whirl_spectrum_free(early);
    whirl_spectrum_free(late);
    return found;
}

bool main_line_stays(const main_line *line, const whirl_record *record) {
    const double bins = 0.05, change = 2e-3, revolutions = (double)record->record_count;
    return line->two && fabs(line->drift) * revolutions <= bins && fabs(line->trend) * revolutions <= change;
}
