/// Comparisons that leave a line in the log: `A3 | what | expected | obtained | difference | tolerance`.
/// scripts/verification-table.sh makes the tables of the verification manual from these lines.
#ifndef SUPPORT_CHECK_H
#define SUPPORT_CHECK_H

#include <stdbool.h>

#include "whirl/status.h"

/// `expected` is printed digits, ".6757879254": agreement to half a unit of the last one.
void check_digits(const char *id, const char *what, const char *expected, double obtained);

/// Half a unit of the last printed digit.
double half_unit(const char *digits);

/// Agreement to within `tolerance`.
void check_within(const char *id, const char *what, double expected, double obtained, double tolerance);

/// Puts a comparison on record without failing, for a published number that independent computations contradict:
/// the verification manual says which, and with what evidence.
void note_within(const char *id, const char *what, double expected, double obtained, double tolerance);

/// Equal texts.
void check_text(const char *id, const char *what, const char *expected, const char *obtained);

/// Checks that a statement holds, and records it.
void check_holds(const char *id, const char *statement, bool holds);

/// Ends the test with the message of a status that is not success.
void require_ok(whirl_status status);

/// Prints into one of a few buffers in turn (as printf), for the `what` of a comparison.
const char *words(const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 1, 2)))
#endif
    ;

#endif
