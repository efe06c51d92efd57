/// Numbers with units: "12 mm", "6207 rpm", "18 mPa.s". Everything inside whirl is in SI.
#ifndef CASE_QUANTITY_H
#define CASE_QUANTITY_H

#include "whirl/engine/descriptor.h"

#include <stdbool.h>

enum { WHY_SIZE = 240 };

typedef struct quantity {
    double value;               ///< in SI
    char unit[WHIRL_NAME_SIZE]; ///< the SI unit, "1" without one
} quantity;

/// Reads a number, or a number, a space and a unit. `expected` is the unit it must convert to ("1": a plain number), or
/// "" for any. Plain numbers are in SI. On failure `why` is the reason: "is 3 kg, expected a number in N s/m".
bool quantity_read(const char *text, const char *expected, quantity *result, char why[WHY_SIZE]);

/// Returns true if a value in SI unit `unit` is allowed where `expected` is required; if not, `why` continues "is in
/// s-1, ".
bool quantity_fits(const char *unit, const char *expected, char why[WHY_SIZE]);

/// Finds the powers of m, kg and s in an SI unit ("N/m": 0, 1, -2). Returns false for a text that is no unit; all
/// powers are 0 for "1" and "".
enum { UNIT_BASES = 3 };
bool quantity_unit_powers(const char *unit, double powers[UNIT_BASES]);

/// Reads a plain number that ends at *end. No hexadecimal, no nan, no inf, no locale. Returns false if there is none;
/// overflow gives an infinite value.
bool quantity_number(const char *text, double *value, const char **end);

#endif
