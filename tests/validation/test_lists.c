// Expressions in lists: a machine whose lists hold parameters is, bit for bit, the one with the numbers written by
// hand.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_study.h"
#include "whirl/engine/rotor.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
static const char *const id = "lists";

/// An element with %s where a number stands in a list, twice at most, its number at p = 0.3 by hand, and the
/// expression.
typedef struct entry {
    const char *element, *number, *expression;
} entry;

static const entry entries[] = {
    {"blade_rub: {at: disc, blades: 3, radius: 0.3, gap: 1e-5, stiffness: 2e6, extension: [0 um, %s, 3 um]}", "3e-06",
     "= 1e-5*p"},
    {"blade_rub: {at: disc, blades: 3, radius: 0.3, gap: 1e-5, stiffness: [%s, %s, 2e6]}", "300000", "= p*1e6"},
    {"bearing: {at: disc, speeds: [100 rad/s, 300 rad/s], kxx: [%s, 2 MN/m], cxx: [500, 400]}", "0.6 MN/m",
     "= 2*p*1e6"},
    {"bearing: {at: disc, speeds: [100, %s], kxx: [1e6, 2e6], cxx: [500, 400]}", "600", "= 2000*p"},
    {"bearing: {at: disc, frequencies: [0, 150, 300], poles: 2, fit_error: 0.5, speeds: [100, 300], kxx: [[1e6, 1.1e6, "
     "1.2e6], [2e6, %s, 2.4e6]], cxx: 500}",
     "2200000", "= 1.9e6+p*1e6"},
    {"coupling_load: {between: [disc, ped], x1: 1e-4, bending_stiffness: 150, distance: 0.05, orders: [1, "
     "%s]}",
     "0.3", "= p"},
    {"pad_bearing: {at: disc, pivots: [%s, 110 deg, 230 deg], arc: 60 deg, clearance: 1e-4, viscosity: 0.01, radius: "
     "0.02, length: 0.02}",
     "0.3", "= p"},
    {"film: {at: disc, clearance: 1e-4, radius: 0.02, length: 0.02, temperatures: [40 degC, 100 degC], viscosities: "
     "[40 "
     "mPa.s, %s], temperature: 60 degC, density: 870}",
     "0.006", "= 0.02*p"},
};

/// Writes the rates of change of the machine at p into dx; returns how many there are.
static size_t rates(const entry *of, const char *number, double p, double *dx) {
    char element[512], text[2048];
    double x[MAX_DIMENSION];
    snprintf(element, sizeof element, of->element, number, number);
    const int used =
        snprintf(text, sizeof text,
                 "whirl: 1\nparameters: {p: 0.3}\nrotor:\n  speed: 200\n  length_scale: 1e-5\n  stations:\n"
                 "    disc: {mass: 10, diametral: 0.1, eccentricity: 1e-5}\n    ped: {mass: 60, diametral: 0.2}\n"
                 "  elements:\n    - spring: {between: [disc, ground], stiffness: 1e6, damping: 100}\n"
                 "    - spring: {between: [ped, ground], stiffness: 3e6, damping: 300}\n    - %s\n"
                 "study: {response: {}, integrate: {method: rk4}}\n",
                 element);
    assert_true(used > 0 && (size_t)used < sizeof text);
    whirl_case *object = case_of_text(text);
    whirl_rotor *rotor;
    require_ok(whirl_case_rotor(object, "p", p, &rotor));
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t n = system->dimension;
    for (size_t i = 0; i < n; i++) x[i] = 0.9 - 0.11 * (double)i;
    evaluate_rhs(system, 0.4, x, dx);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
    return n;
}

static void as_by_hand(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT_OF(entries); i++) {
        double hand[MAX_DIMENSION], expression[MAX_DIMENSION], other[MAX_DIMENSION];
        const size_t n = rates(&entries[i], entries[i].number, 0.3, hand);
        assert_int_equal(n, rates(&entries[i], entries[i].expression, 0.3, expression));
        assert_int_equal(n, rates(&entries[i], entries[i].expression, 0.31, other));
        check_holds(id,
                    words("%.24s ... %s: the bits of the number by hand", entries[i].element, entries[i].expression),
                    memcmp(hand, expression, n * sizeof *hand) == 0);
        check_holds(id,
                    words("%.24s ... %s: another machine by another value", entries[i].element, entries[i].expression),
                    memcmp(hand, other, n * sizeof *hand) != 0);
    }
}

/// The message about a wrong number of a list names its place.
static void wrong_numbers(void **state) {
    static const struct {
        const char *extension, *sentence;
    } wrong[] = {{"= q", "extension[2]: is = q, but no parameter is called q, did you mean p?"},
                 {"= 1/(p-p)", "extension[2]: = 1/(p-p) is infinite, expected a finite number"}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(wrong); i++) {
        char text[1024], problems[2048];
        whirl_case *object = NULL;
        snprintf(
            text, sizeof text,
            "whirl: 1\nparameters: {p: 0.3}\nrotor:\n  speed: 200\n  length_scale: 1e-5\n  stations: {disc: {mass: "
            "10}}\n"
            "  elements:\n    - blade_rub: {at: disc, blades: 2, radius: 0.3, gap: 1e-5, stiffness: 2e6, extension: "
            "[0, %s]}\nstudy: {response: {}}\n",
            wrong[i].extension);
        const whirl_status status = whirl_case_check(text, strlen(text), "t", problems, sizeof problems, &object);
        check_holds(id, wrong[i].sentence,
                    status.code == WHIRL_BAD_INPUT && strstr(problems, wrong[i].sentence) != NULL);
        whirl_case_free(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_by_hand), cmocka_unit_test(wrong_numbers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
