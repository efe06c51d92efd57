/// Families of machines whose equations a test writes itself, and numbers of their branches.
#ifndef SUPPORT_BRANCH_H
#define SUPPORT_BRANCH_H

#include "whirl/engine/branch.h"
#include "whirl/engine/case.h"
#include "whirl/engine/orbit.h"

enum { FAMILY_NUMBERS = 8 };

/// A family of machines: a system whose model is the numbers p, of which one is the family's parameter.
typedef struct test_family {
    whirl_system system; ///< all but its model
    double p[FAMILY_NUMBERS];
    size_t varied; ///< index in p
    double start[16];
} test_family;

/// The family as the library takes it; borrows the test's.
whirl_family family_of(const test_family *family);

/// The rotors of a case by one of its parameters.
typedef struct case_family {
    const whirl_case *object;
    const char *parameter;
} case_family;

/// The family as the library takes it; borrows the case's.
whirl_family family_of_case(const case_family *family);

/// The machine with the present numbers: a system whose model is p.
whirl_system system_of(const test_family *family);

/// Finds the orbit from the family's start, with the present numbers; fails the test if there is none.
whirl_orbit *find_orbit(const test_family *family, size_t revolutions, const whirl_orbit_options *options);

/// Follows the branch of an orbit; the test ends with the message of an error.
whirl_branch *follow_branch(const test_family *family, const whirl_orbit *start, int direction,
                            const whirl_branch_options *options);

/// Returns special point number `which` of a kind, from 0; NULL if there are fewer.
const whirl_branch_point *special_point(const whirl_branch *branch, whirl_special kind, size_t which);

/// Follows a special point over the family's parameter and another one of its numbers, from `low` to `high`, in the
/// direction given; the test ends with the message of an error.
whirl_branch *follow_curve(const test_family *family, size_t other, const whirl_branch_point *start, int direction,
                           double low, double high, const whirl_branch_options *options);

/// Returns the number of special points of a kind.
size_t count_special(const whirl_branch *branch, whirl_special kind);

/// Returns the word for a kind of special point in the output of the programs in extended precision.
const char *special_word(whirl_special special);

/// Returns the sum of ln|multiplier| over all multipliers.
double sum_of_logarithms(const whirl_orbit *orbit);

#endif
