/// Writes a number as readers see it.
#ifndef REPORT_NUMBER_SHOWN_H
#define REPORT_NUMBER_SHOWN_H

#include <stddef.h>

/// Writes a number with `digits` significant digits; up to ten million without a power of ten: "140280".
void number_shown(double number, int digits, char *text, size_t size);

#endif
