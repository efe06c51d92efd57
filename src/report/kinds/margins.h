/// Critical speeds as peaks of a response to unbalance, and their margins.
#ifndef REPORT_MARGINS_H
#define REPORT_MARGINS_H

#include "whirl/analyze.h"
#include "whirl/result.h"

enum { MARGIN_PEAKS = 32, MARGIN_TEXT = 160 };

/// The peaks that probe 0 or 1 of a station sees, in the case's length scale; 0 where speeds do not rise along the
/// table, or too few points are there.
size_t margin_peaks(const whirl_table *table, size_t station, size_t probe, whirl_response_peak peaks[MARGIN_PEAKS]);

/// "margin 31.2 % above, 24.5 % asked for: holds"; "" where the running speeds are not said.
void margin_text(const whirl_table *table, const whirl_response_peak *peak, char text[MARGIN_TEXT]);

/// "half power", ...; "half power, of 1.2 points: compute more there".
void margin_way(const whirl_response_peak *peak, char text[MARGIN_TEXT]);

#endif
