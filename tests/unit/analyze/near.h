/// Comparison of doubles: cmocka's own works in single precision. Include after cmocka.h.
#ifndef TESTS_ANALYZE_NEAR_H
#define TESTS_ANALYZE_NEAR_H

#include <math.h>

#define assert_near(actual, expected, tolerance)                                                                       \
    do {                                                                                                               \
        const double actual_ = (actual), expected_ = (expected);                                                       \
        if (!(fabs(actual_ - expected_) <= (tolerance))) {                                                             \
            fail_msg("%s is %.12g, expected %.12g +- %.2g", #actual, actual_, expected_, (double)(tolerance));         \
        }                                                                                                              \
    } while (0)

#endif
