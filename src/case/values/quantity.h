/// Numbers with units: "12 mm", "6207 rpm", "18 mPa.s". Everything inside whirl is in SI.
#ifndef CASE_QUANTITY_H
#define CASE_QUANTITY_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/system.h"

enum { WHY_SIZE = 240 };

typedef struct quantity {
    double value;               ///< in SI
    char unit[WHIRL_NAME_SIZE]; ///< the SI unit, "1" where there was none
} quantity;

/// Reads a number, or a number, a space and a unit. `expected` is the unit it must convert to ("1": a plain number),
/// or "" for any. Plain numbers are in SI. On false `why` says what is wrong: "is 3 kg, expected a number in N s/m".
bool quantity_read(const char *text, const char *expected, quantity *result, char why[WHY_SIZE]);

/// Whether a value in SI unit `unit` can stand where `expected` is; if not, `why` says so, after "is in s-1, ".
bool quantity_fits(const char *unit, const char *expected, char why[WHY_SIZE]);

/// The powers of m, kg and s in an SI unit ("N/m": 0, 1, -2). false where it is no unit; all 0 for "1" and "".
enum { UNIT_BASES = 3 };
bool quantity_unit_powers(const char *unit, double powers[UNIT_BASES]);

/// Reads a plain number that ends at *end. No hexadecimal, no nan, no inf, no locale.
/// false where there is none; overflow gives an infinite value.
bool quantity_number(const char *text, double *value, const char **end);

#endif
