// Symbols, words and units as journals set them, in gnuplot's enhanced text: symbols in italics, units and words
// upright.
#ifndef REPORT_TYPESET_H
#define REPORT_TYPESET_H

#include "units.h"

enum { TYPESET_SIZE = 512 };

/// Text in which no letter means anything to gnuplot: "disc_1" becomes "disc\_1". At most `size` bytes, never cut
/// within an escape.
void typeset_text(const char *text, char *markup, size_t size);

/// A name as a symbol: "r_k" becomes r in italics with the subscript k, "k1" likewise, "omega" and "r_delta" get their
/// Greek letters; a name that is a word stays one.
void typeset_symbol(const char *name, char *markup, size_t size);

/// The same units with the scale of lengths in markup, for labels in figures.
whirl_shown_units typeset_units(const whirl_shown_units *units);

/// The axis of a parameter: symbol and unit.
void typeset_parameter(const whirl_shown_units *units, const char *name, char *markup, size_t size);

#endif
