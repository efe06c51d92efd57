/// Symbols, words and units as journals set them, in labels of figures: letters between dollars are symbols, in italics
/// with subscripts.
#ifndef REPORT_SYMBOLS_H
#define REPORT_SYMBOLS_H

#include "units.h"

enum { SYMBOL_SIZE = 256 };

/// A name as a symbol: "r_k" becomes "$r_{k}$", "k1" likewise, "omega" and "r_delta" get their Greek letters; a name
/// that is a word stays one.
void symbol_of(const char *name, char *text, size_t size);

/// The same units with the scale of lengths as a symbol.
whirl_shown_units symbol_units(const whirl_shown_units *units);

/// The axis of a parameter: symbol and unit.
void symbol_parameter(const whirl_shown_units *units, const char *name, char *text, size_t size);

/// The axis of x or y of a station, "$x$ (mm)", or of another length, "radius (mm)".
void symbol_length(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *text,
                   size_t size);

#endif
