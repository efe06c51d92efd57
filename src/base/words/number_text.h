/// Numbers as text.
#ifndef BASE_NUMBER_TEXT_H
#define BASE_NUMBER_TEXT_H

enum { NUMBER_SIZE = 32 };

/// Writes a finite number with a decimal point in every locale, with the fewest of 15, 16 or 17 significant digits that
/// give the same double back: 0.1, not 0.10000000000000001. A number with at most 15 digits is written with these
/// alone.
void number_text(double value, char text[NUMBER_SIZE]);

#endif
