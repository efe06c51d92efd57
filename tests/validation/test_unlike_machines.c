// Studies whose machines differ in more than numbers: check refuses every study that run refuses, in the same words;
// the other studies have the bits of each point alone.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
static const char *const id = "unlike machines";

/// Contents of a case: its stations, elements and the values of the swept parameter p.
typedef struct tempting {
    const char *what, *stations, *elements;
    double values[4];
} tempting;

static const char *text_of(const tempting *of, const char *study, const char *method) {
    static char text[2048];
    const int used =
        snprintf(text, sizeof text,
                 "whirl: 1\nparameters: {p: 1, speed: 100 rad/s}\nrotor:\n  speed: = speed\n  length_scale: 1 mm\n"
                 "  stations: {%s}\n  elements:\n%s"
                 "study:\n  %s\n  integrate: {method: %s, transient: 1, record: 2}\n  analyze: [poincare, orbit]\n",
                 of->stations, of->elements, study, method);
    assert_true(used > 0 && (size_t)used < sizeof text);
    return text;
}

static const char *sweep_of(const tempting *of) {
    return words("sweep: {parameter: p, values: [%g, %g, %g, %g]}", of->values[0], of->values[1], of->values[2],
                 of->values[3]);
}

static const tempting running[] = {
    {"a Black seal between stations, whose fluid has inertia",
     "disc: {mass: 10, eccentricity: 1e-4}, ped: {mass: 5}",
     "    - spring: {between: [disc, ped], stiffness: 1e6, damping: 100}\n"
     "    - spring: {between: [ped, ground], stiffness: 1e6, damping: 100}\n"
     "    - seal: {at: disc, from: ped, law: black, clearance: 2e-4, radius: 0.05, length: 0.03, density: 1000, "
     "viscosity: 1e-3, pressure: = 1e5*p}\n",
     {1.0, 2.0, 3.0, 4.0}},
    {"a Black seal over the speed of a shaft of finite elements",
     "disc: {mass: 10, eccentricity: 1e-4, position: 0.5}, a: {position: 0}, b: {position: 1}",
     "    - segment: {length: 1, elements: 2, outer: 0.04}\n    - bearing: {at: a, kxx: 1e7, cxx: 1e3}\n"
     "    - bearing: {at: b, kxx: 1e7, cxx: 1e3}\n"
     "    - seal: {at: disc, law: black, clearance: 2e-4, radius: 0.05, length: 0.03, density: 1000, "
     "viscosity: 1e-3, pressure: = 1e5*p^2}\n",
     {1.0, 1.5, 2.0, 2.5}},
    {"the diameter of a shaft of finite elements",
     "disc: {mass: 10, eccentricity: 1e-4, position: 0.5}, a: {position: 0}, b: {position: 1}",
     "    - segment: {length: 1, elements: 2, outer: = 0.04+0.005*p}\n    - bearing: {at: a, kxx: 1e7, cxx: 1e3}\n"
     "    - bearing: {at: b, kxx: 1e7, cxx: 1e3}\n",
     {1.0, 2.0, 3.0, 4.0}},
    {"the number of blades",
     "disc: {mass: 10, eccentricity: 5e-4}",
     "    - spring: {between: [disc, ground], stiffness: 1e5, damping: 100}\n"
     "    - blade_rub: {at: disc, blades: = p, gap: 1e-4, stiffness: 1e5, radius: 0.2}\n",
     {3.0, 4.0, 5.0, 6.0}},
    {"machines of one structure",
     "disc: {mass: 10, eccentricity: 1e-4}",
     "    - spring: {between: [disc, ground], stiffness: = 1e5*p, damping: 100}\n",
     {1.0, 2.0, 3.0, 4.0}}};

static whirl_result *run(const char *text, int threads) {
    whirl_case *object = case_of_text(text);
    whirl_result *result;
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = threads}, &result));
    whirl_case_free(object);
    return result;
}

/// Each point of the sweep has the bits of a study of its own, for all other machines in the lanes, on one thread or
/// two.
static void unlike_machines_run(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT_OF(running); i++)
        for (int adaptive = 0; adaptive < 2; adaptive++) {
            const char *const method = adaptive ? "dop853" : "rk4";
            whirl_result *one = run(text_of(&running[i], sweep_of(&running[i]), method), 1);
            whirl_result *two = run(text_of(&running[i], sweep_of(&running[i]), method), 2);
            const whirl_table *all = &one->tables[0];
            const size_t bytes = all->layout.size * sizeof *all->blocks;
            size_t same = memcmp(all->blocks, two->tables[0].blocks, all->count * bytes) == 0;
            for (size_t k = 0; k < all->count; k++) {
                const char *value = words("sweep: {parameter: p, values: [%g]}", running[i].values[k]);
                whirl_result *alone = run(text_of(&running[i], value, method), 1);
                same += memcmp(all->blocks + k * all->layout.size, alone->tables[0].blocks, bytes) == 0;
                whirl_result_free(alone);
            }
            check_within(id, words("%s, %s: points with their bits alone, and of two threads", running[i].what, method),
                         5, (double)same, 0);
            whirl_result_free(one);
            whirl_result_free(two);
        }
}

static const tempting refused[] = {{"tilts that begin within the sweep",
                                    "disc: {mass: 10, diametral: \"= max(0, p-2)\", eccentricity: 1e-4}",
                                    "    - spring: {between: [disc, ground], stiffness: 1e6, damping: 100}\n",
                                    {1.0, 1.5, 2.0, 3.0}},
                                   {"pads without inertia, then with it",
                                    "disc: {mass: 100, eccentricity: 1e-6}",
                                    "    - gravity: {}\n    - tilting_pad: {at: disc, pivots: [3.927, 5.498], arc: "
                                    "1.047, preload: 0.2, clearance: 1e-4, "
                                    "viscosity: 0.02, radius: 0.05, length: 0.05, inertia: \"= max(0, p-1)\"}\n",
                                    {1.0, 2.0, 3.0, 4.0}},
                                   {"a mass that is 0 between the ends",
                                    "disc: {mass: = (p-2.5)^2-0.25, eccentricity: 1e-4}",
                                    "    - spring: {between: [disc, ground], stiffness: 1e6, damping: 100}\n",
                                    {1.0, 2.0, 3.0, 4.0}}};

/// Returns the status of a run of the study of the first point, to which the test adds the other values after the case
/// was checked.
static whirl_status run_unchecked(const tempting *of) {
    whirl_case *object =
        case_of_text(text_of(of, words("sweep: {parameter: p, values: [%g]}", of->values[0]), "dop853"));
    whirl_result *result = NULL;
    whirl_study study;
    require_ok(whirl_case_study(object, &study));
    study.batches[0].values = of->values;
    study.batches[0].count = COUNT_OF(of->values);
    const whirl_status status = whirl_study_run(&study, &(whirl_run_options){.threads = 1}, &result);
    whirl_result_free(result);
    whirl_case_free(object);
    return status;
}

static void they_are_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT_OF(refused); i++) {
        const tempting *of = &refused[i];
        char problems[4096];
        whirl_case *object = NULL;
        const char *text = text_of(of, sweep_of(of), "dop853");
        const whirl_status checked = whirl_case_check(text, strlen(text), "t", problems, sizeof problems, &object);
        const whirl_status ran = run_unchecked(of);
        const char *sentence = strrchr(ran.message, ':') ? strstr(ran.message, ": ") : NULL;
        check_holds(id, words("%s: check refuses it", of->what), checked.code == WHIRL_BAD_INPUT);
        check_holds(id, words("%s: so does a run", of->what), ran.code == WHIRL_BAD_INPUT);
        check_holds(id, words("%s: in the same words: %.60s", of->what, ran.message),
                    strstr(problems, sentence ? sentence + 2 : ran.message) != NULL);
        whirl_case_free(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(unlike_machines_run), cmocka_unit_test(they_are_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
