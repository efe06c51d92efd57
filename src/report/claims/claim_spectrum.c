// Spectral lines and bands with which claims are compared.
#include "claim_parts.h"

#include <math.h>

/// Lines below this share of the largest do not count as present.
static const double LINE_SHARE = 0.05;

static double line_amplitude(const double *line) {
    return fmax(line[1], line[2]);
}

numbers claim_lines(const claim_view *view, size_t point) {
    numbers lines = point_lines(view->table, point, view->station);
    double most = 0.0;
    for (size_t i = 0; i < lines.rows; i++) most = fmax(most, line_amplitude(&lines.at[5 * i]));
    // The analysis sorts lines by amplitude, largest first.
    while (lines.rows > 0 && line_amplitude(&lines.at[5 * (lines.rows - 1)]) < LINE_SHARE * most) lines.rows--;
    return lines;
}

claim_band claim_band_of(const claim_view *view, size_t point) {
    const numbers lines = claim_lines(view, point);
    const double *band = view->claim->band;
    double inside = 0.0, all = 0.0;
    claim_band found = {(double)NAN, 0};
    for (size_t i = 0; i < lines.rows; i++) {
        const double order = lines.at[5 * i], x = lines.at[5 * i + 1], y = lines.at[5 * i + 2];
        if (order >= 1.0 - LINE_TOLERANCE) continue;
        all += x * x + y * y;
        if (order < band[0] - LINE_TOLERANCE || order > band[1] + LINE_TOLERANCE) continue;
        inside += x * x + y * y;
        found.lines++;
    }
    if (lines.at) found.share = all > 0.0 ? inside / all : 0.0;
    return found;
}
