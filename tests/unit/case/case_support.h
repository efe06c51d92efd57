/// Cases for the tests, and how they expect problems.
#ifndef TEST_CASE_SUPPORT_H
#define TEST_CASE_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/case.h"

static const char good_case[] = "whirl: 1\n"                                                                   // 1
                                "title: A rotor\n"                                                             // 2
                                "parameters:\n"                                                                // 3
                                "  omega: 100 rad/s\n"                                                         // 4
                                "  kappa: 10\n"                                                                // 5
                                "  c: 0.2 mm\n"                                                                // 6
                                "rotor:\n"                                                                     // 7
                                "  speed: = omega\n"                                                           // 8
                                "  length_scale: = c\n"                                                        // 9
                                "  stations:\n"                                                                // 10
                                "    disc: {mass: 4 kg, damping: 20 N.s/m, eccentricity: = 0.1*c}\n"           // 11
                                "    journal: {mass: 2 kg}\n"                                                  // 12
                                "  elements:\n"                                                                // 13
                                "    - shaft: {between: [disc, journal], k1: 1 kN/mm, k2: 1 MN/m}\n"           // 14
                                "    - film: {at: journal, clearance: = c, load: 200 N}\n"                     // 15
                                "    - rub: {at: disc, gap: = 1.2*c, stiffness: = kappa*1e6, friction: 0.1}\n" // 16
                                "    - gravity: 9.81 m/s2\n"                                                   // 17
                                "study:\n"                                                                     // 18
                                "  sweep: {parameter: kappa, from: 1, to: 20, points: 5, start: state}\n"      // 19
                                "  initial: {disc: {y: -0.5}, journal: {x: 0.1, y: -0.5, vx: 0.25}}\n"         // 20
                                "  integrate: {steps_per_revolution: 64, transient: 20, record: 10}\n"         // 21
                                "  analyze: [poincare, regime, spectrum]\n";                                   // 22

/// Returns good_case with every `old` replaced by `new`. Freed by the caller.
static inline char *edited(const char *text, const char *old, const char *new) {
    const char *at = strstr(text, old);
    assert_non_null(at); // an edit that changes nothing would test nothing
    char *result = malloc(strlen(text) + strlen(new) + 1);
    assert_non_null(result);
    memcpy(result, text, (size_t)(at - text));
    strcpy(result + (at - text), new);
    strcat(result, at + strlen(old));
    return result;
}

static inline whirl_case *parse_good(const char *text) {
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    const whirl_status status = whirl_case_parse(text, strlen(text), "t.yaml", &problems, &object);
    if (status.code != WHIRL_OK) print_error("%s\n", status.message);
    assert_int_equal(status.code, WHIRL_OK);
    assert_int_equal(problems.count, 0);
    whirl_problems_free(&problems);
    assert_non_null(object);
    return object;
}

static inline whirl_case *parse_edited(const char *old, const char *new) {
    char *text = edited(good_case, old, new);
    whirl_case *object = parse_good(text);
    free(text);
    return object;
}

/// Checks that the bytes give exactly one problem with this text.
static inline void expect_bytes_problem(const char *text, size_t length, const char *expected) {
    char found[sizeof(whirl_problem)];
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    const whirl_status status = whirl_case_parse(text, length, "t", &problems, &object);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_null(object);
    assert_true(problems.count >= 1);
    whirl_problem_text(&problems, 0, found, sizeof found);
    assert_string_equal(found, expected);
    assert_string_equal(status.message, expected);
    assert_int_equal(problems.count, 1);
    whirl_problems_free(&problems);
}

static inline void expect_problem(const char *old, const char *new, const char *expected) {
    char *text = edited(good_case, old, new);
    expect_bytes_problem(text, strlen(text), expected);
    free(text);
}

#endif
