/// Writes bands of tolerances for the explorer's diagrams: quantiles over all samples.
#ifndef REPORT_EXPLORER_BANDS_H
#define REPORT_EXPLORER_BANDS_H

#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/result.h"

/// Writes `,"bands": [...]`, an item for each number of a station or contact whose quantiles over a parameter the page
/// shades; nothing for a result without any. Returns false without memory.
bool explorer_write_bands(FILE *stream, const whirl_result *result);

#endif
