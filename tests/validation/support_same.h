/// Compares two results that must be equal: all fields of all points of all tables.
#ifndef SUPPORT_SAME_H
#define SUPPORT_SAME_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"

/// Allowed differences of two results.
typedef struct same_rule {
    double tolerance; ///< of numbers, over the largest of their field; of rates over the fastest one; 0: bits
    /// Tolerance of numbers that are measured on a perturbed copy of a motion (exponents, growth, settling), whose
    /// distance has 8 digits.
    double of_growth;
    bool mirrored;               ///< the other one is of the machine seen in a mirror, by x -> -x
    const char *const *left_out; ///< names of fields that are not compared, or their beginnings; NULL ends them
} same_rule;

/// Compares point `at` of a table of `one` with point `there` of the table of `other` of the same name. Stations and
/// contacts belong together by their names, lengths are compared in m and forces in N. Prints what differs, and returns
/// how many numbers do.
size_t same_points(const char *what, const whirl_result *one, size_t table, size_t at, const whirl_result *other,
                   size_t there, const same_rule *rule);

/// Compares all points of all tables.
size_t same_results(const char *what, const whirl_result *one, const whirl_result *other, const same_rule *rule);

#endif
