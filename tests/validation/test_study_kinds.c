// Properties of studies of every kind: files of finished runs, and of runs that were stopped before their first point.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/case.h"
#include "whirl/engine/report.h"
#include "whirl/engine/study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SIZE = 4096 };

static const char machine[] = "whirl: 1\n"
                              "parameters: {omega: 1.5, kappa: 10, x0: 0.1, y0: -0.2}\n"
                              "rotor:\n"
                              "  speed: = omega\n"
                              "  length_scale: 1 m\n"
                              "  stations:\n"
                              "    disc: {mass: 1 kg, damping: 0.2 N.s/m, eccentricity: 0.9 m}\n"
                              "  elements:\n"
                              "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
                              "    - rub: {at: disc, gap: 1 m, stiffness: = kappa, friction: 0.05, law: paper}\n"
                              "    - gravity: 0.5 m/s2\n"
                              "study:\n";

static const char films[] = "whirl: 1\n"
                            "parameters: {r_k: 0.6, omega: 650 rad/s, c: 0.2 mm}\n"
                            "rotor:\n"
                            "  speed: = omega\n"
                            "  length_scale: = c\n"
                            "  stations:\n"
                            "    disc:    {mass: 420 kg, damping: 4300 N.s/m, eccentricity: = 0.08*c}\n"
                            "    journal: {mass: 100 kg, damping: 9300 N.s/m}\n"
                            "  elements:\n"
                            "    - shaft:   {between: [disc, journal], k1: = r_k*50*(650/0.2)^2, k2: = 50*(650/0.2)^2, "
                            "signs: paper}\n"
                            "    - film:    {at: journal, count: 2, law: capone, clearance: = c, load: = "
                            "0.0045*50*c*omega^2}\n"
                            "    - gravity: 9.8 m/s2\n"
                            "study:\n";

static const char train[] = "whirl: 1\n"
                            "parameters: {omega: 100 rad/s}\n"
                            "rotor:\n"
                            "  speed: = omega\n"
                            "  length_scale: 1 mm\n"
                            "  stations:\n"
                            "    a: {polar: 2 kg.m2, moves: twist}\n"
                            "    b: {polar: 3 kg.m2, moves: twist}\n"
                            "  elements:\n"
                            "    - coupling: {between: [a, b], twist: 9e4 N.m/rad, twist_damping: 9 N.m.s/rad}\n"
                            "    - pulsation: {at: a, orders: [1, 3], amplitudes: [20 N.m, 4 N.m]}\n"
                            "study:\n";

static const char beam[] = "whirl: 1\n"
                           "parameters: {kappa: 10, omega: 100 rad/s}\n"
                           "rotor:\n"
                           "  speed: = omega\n"
                           "  length_scale: 1 mm\n"
                           "  stations:\n"
                           "    a: {position: 0 m}\n"
                           "    b: {position: 0.6 m, mass: = kappa}\n"
                           "    c: {position: 1 m}\n"
                           "  elements:\n"
                           "    - segment: {length: 1 m, outer: 50 mm}\n"
                           "    - bearing: {at: a, kxx: 10 MN/m, cxx: 2 kN s/m}\n"
                           "    - bearing: {at: c, kxx: 10 MN/m, cxx: 2 kN s/m}\n"
                           "    - stage: {at: b, power: 100 kW, diameter: 0.4 m, width: 10 mm}\n"
                           "study:\n";

#define MOTION                                                                                                         \
    "  initial: {disc: {x: = x0, y: = y0}}\n  integrate: {method: rk4, steps_per_revolution: 64, transient: 20, "      \
    "record: 10}\n"
#define SETTLE "  initial: {disc: {x: = x0, y: = y0}}\n  integrate: {transient: 100, record: 20}\n"

/// Studies of every kind, by the first word.
static const struct {
    const char *machine, *study;
} studies[] = {
    {machine, "  response: {}\n  initial: {disc: {x: = x0, y: = y0}}\n  integrate: {method: rk4, steps_per_revolution: "
              "64, transient: 20, record: 300}\n  keep: {waveform: 300}\n  analyze: [poincare, regime, waveform]\n"},
    {machine, "  sweep: {parameter: omega, from: 1, to: 4, points: 3}\n" MOTION},
    {machine, "  sweep: {parameter: omega, from: 1, to: 4, points: 3, start: carry, direction: both}\n  confirm: yes\n"
              "  detail: {at: [2, 3], record: 300, waveform: 300}\n" MOTION},
    {machine, "  sweep: {parameter: omega, from: 1, to: 4, points: 3}\n"
              "  starts: {count: 3, within: {disc: {x: [-1, 1]}}, neighbours: 2}\n" MOTION},
    {machine,
     "  map: {x: {parameter: omega, from: 1, to: 4, points: 3}, y: {parameter: kappa, values: [5, 20]}}\n" MOTION},
    {machine, "  map: {x: {parameter: omega, from: 1, to: 4, points: 9}, y: {parameter: kappa, from: 5, to: 20, "
              "points: 9}, refine: 4}\n" MOTION},
    {machine, "  basin: {x: {parameter: x0, from: -1, to: 1, points: 3}, y: {parameter: y0, from: -1, to: 1, "
              "points: 2}}\n" MOTION},
    {machine,
     "  dataset: {machines: 3, samples_per_revolution: 16, revolutions: 10, vary: {kappa: +- 10 %}, labels: "
     "{healthy: , rub: {grade: {kappa: {from: 5, to: 20}}}}, channels: [{sensor: proximity, at: disc}, {sensor: "
     "keyphasor}]}\n  initial: {disc: {x: = x0, y: = y0}}\n  integrate: {method: rk4, steps_per_revolution: 64, "
     "transient: 20}\n"},
    {machine, "  branch: {parameter: omega, from: 1.4, to: 1.6, at: [1.5], switches: 0}\n" SETTLE},
    {machine, "  branch: {parameter: omega, from: 3.2, to: 3.29, switches: 0}\n"
              "  curves: {parameter: kappa, from: 9.9, to: 10.1}\n" SETTLE},
    {films, "  branch: {parameter: r_k, from: 0.48, to: 0.44, switches: 0, revolutions: 1, tori: yes, torus_accuracy: "
            "1e-3, torus_points: 2}\n  initial: {disc: {y: -0.9}, journal: {y: -0.8}}\n"
            "  integrate: {transient: 200, record: 20}\n"},
    {machine, "  modes: {parameter: omega, from: 1, to: 4, points: 3}\n"},
    {machine, "  unbalance: {parameter: omega, from: 1, to: 4, points: 3}\n"},
    {machine, "  critical_speeds: {parameter: kappa, from: 5, to: 20, points: 3}\n"},
    {beam, "  stability: {parameter: kappa, from: 5, to: 20, points: 3}\n"},
    {beam, "  statics: {parameter: kappa, from: 5, to: 20, points: 3}\n"},
    {train, "  torsion: {parameter: omega, from: 100, to: 200, points: 3}\n"},
    {beam,
     "  runup: {parameter: kappa, from: 5, to: 20, points: 3, rate: 40 rad/s2, speed_from: 50 rad/s, duration: 1 s, "
     "rows: 8, spectra: 3, spectrum_turns: 2}\n"},
    {beam, "  unbalance: {parameter: omega, from: 100, to: 200, points: 3, antinodes_of: 1, running_to: 200 rad/s}\n"},
    {machine, "  fit: {unknown: {kappa: {from: 1, to: 30}}, data: kind-fit.csv, steps: 3, starts: 2}\n"},
};
enum { STUDIES = sizeof studies / sizeof *studies };

static whirl_case *case_of(size_t i) {
    char text[SIZE], problems[SIZE];
    whirl_case *object = NULL;
    snprintf(text, sizeof text, "%s%s", studies[i].machine, studies[i].study);
    if (whirl_case_check(text, strlen(text), "kind.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    return object;
}

/// The kinds of studies are those of the message that lists them.
static void every_kind_of_study_is_run(void **state) {
    static const char before[] = "has none of ";
    char text[SIZE], problems[SIZE], *rest = NULL;
    whirl_case *object = NULL;
    size_t kinds = 0;
    (void)state;
    snprintf(text, sizeof text, "%s  initial: {}\n", machine);
    whirl_case_check(text, strlen(text), "none.yaml", problems, sizeof problems, &object);
    assert_null(object);
    char *names = strstr(problems, before), *end = strstr(problems, ", expected one of them");
    assert_true(names && end);
    *end = '\0';
    for (char *kind = strtok_r(names + sizeof before - 1, ", ", &rest); kind; kind = strtok_r(NULL, ", ", &rest)) {
        bool known = strcmp(kind, "and") == 0;
        kinds += !known;
        for (size_t i = 0; i < STUDIES && !known; i++)
            known = strncmp(studies[i].study + 2, kind, strlen(kind)) == 0 && studies[i].study[2 + strlen(kind)] == ':';
        if (!known) fail_msg("no study here is of the kind %s", kind);
    }
    assert_true(kinds >= 7);
}

/// Writes a result, makes sure of it, and gives what is read of the file.
static whirl_result *written(const whirl_result *result) {
    char path[] = "/tmp/whirl-kind-XXXXXX";
    whirl_result *read = NULL;
    const int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    require_ok(whirl_result_write(result, path));
    require_ok(whirl_result_verify(result, path));
    require_ok(whirl_result_read_outline(path, &read));
    unlink(path);
    return read;
}

/// Returns the text of all files of a folder, and removes the folder; to be freed.
static char *text_of(const char *folder) {
    char command[SIZE], *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    snprintf(command, sizeof command, "find %s -type f -exec cat {} +; rm -r %s", folder, folder);
    FILE *in = popen(command, "r");
    assert_non_null(in);
    for (int c; (c = fgetc(in)) != EOF;) fputc(c == '\0' ? ' ' : c, out);
    assert_int_equal(pclose(in), 0);
    fclose(out);
    return text;
}

/// Checks that no renderer calls points undetermined that were not judged: summary, JSON, CSV, report with its figures.
static void check_no_verdict_is_printed(const whirl_result *result, const char *study) {
    static const char *const name[] = {"kind"};
    char folder[] = "/tmp/whirl-kind-XXXXXX", path[64];
    for (size_t t = 0; t < result->table_count; t++) {
        if (whirl_layout_has_verdict(&result->tables[t].layout)) return;
        for (size_t i = 0; i < result->tables[t].count; i++)
            assert_int_equal(whirl_table_verdict(&result->tables[t], i).regime, WHIRL_NOT_JUDGED);
    }
    assert_non_null(mkdtemp(folder));
    for (int json = 0; json < 2; json++) {
        snprintf(path, sizeof path, "%s/%d", folder, json);
        FILE *out = fopen(path, "w");
        assert_non_null(out);
        require_ok(json ? whirl_result_write_json(result, out) : whirl_result_write_summary(result, out));
        fclose(out);
    }
    snprintf(path, sizeof path, "%s/csv", folder);
    require_ok(whirl_result_export_csv(result, path));
    snprintf(path, sizeof path, "%s/report", folder);
    // The program that would draw prints the scripts of the figures.
    require_ok(whirl_report_write(&result, name, 1, path, &(whirl_report_options){.gnuplot = "true"}));
    char *text = text_of(folder);
    assert_true(strlen(text) > 5000);
    if (strstr(text, "ndetermined")) fail_msg("undetermined, but nobody judged: %s", study);
    free(text);
}

/// A resumed run has the outline of its study, and the existing file.
static void finished_files_are_recognised(void **state) {
    (void)state;
    for (size_t i = 0; i < STUDIES; i++) {
        char difference[WHIRL_MESSAGE_SIZE] = "";
        size_t done, total;
        whirl_case *object = case_of(i);
        whirl_result *outline, *result;
        require_ok(whirl_case_outline(object, &outline));
        require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result));
        whirl_result *read = written(result);
        assert_false(whirl_result_partial(read, &done, &total));
        for (size_t t = 0; t < result->table_count; t++)
            if (result->tables[t].count == 0)
                fail_msg("there is no point in the %s of: %s", result->tables[t].name, studies[i].study);
        if (!whirl_result_same_study(read, outline, difference, sizeof difference))
            fail_msg("%s: %s", difference, studies[i].study);
        check_no_verdict_is_printed(result, studies[i].study);
        // A result of another machine is not of the same study.
        read->parameters[0].value += 0.1;
        assert_false(whirl_result_same_study(read, outline, difference, sizeof difference));
        whirl_result_free(read);
        whirl_result_free(result);
        whirl_result_free(outline);
        whirl_case_free(object);
    }
}

/// Motions whose analyses have no regime are run; options that need one (confirm, refine, several starts) refuse that.
static void motions_without_a_verdict(void **state) {
    size_t looked = 0;
    (void)state;
    for (size_t i = 0; i < STUDIES; i++) {
        char text[SIZE], problems[SIZE];
        whirl_case *object = NULL;
        whirl_result *result;
        if (!strstr(studies[i].study, "record: 10}")) continue;
        snprintf(text, sizeof text, "%s%s  analyze: [poincare, orbit, spectrum, rub]\n", studies[i].machine,
                 studies[i].study);
        if (whirl_case_check(text, strlen(text), "kind.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
            continue;
        require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 1}, &result));
        assert_false(whirl_layout_has_verdict(&result->tables[0].layout));
        check_no_verdict_is_printed(result, studies[i].study);
        looked++;
        whirl_result_free(result);
        whirl_case_free(object);
    }
    assert_true(looked >= 3);
}

/// A run that stopped before its first point, as one that gathers points that no run has computed, leaves a file that
/// says so.
static void stopped_before_the_first_point(void **state) {
    (void)state;
    for (size_t i = 0; i < STUDIES; i++) {
        size_t done, total;
        whirl_case *object = case_of(i);
        whirl_result *result;
        const whirl_status status = whirl_case_run(object, &(whirl_run_options){.threads = 1, .gather = true}, &result);
        assert_int_equal(status.code, WHIRL_STOPPED);
        whirl_result *read = written(result);
        assert_true(whirl_result_partial(read, &done, &total));
        assert_int_equal(done, 0);
        assert_true(total > 0);
        assert_int_equal(read->table_count, result->table_count);
        for (size_t t = 0; t < read->table_count; t++) {
            assert_int_equal(read->tables[t].count, 0);
            assert_int_equal(read->tables[t].layout.size, result->tables[t].layout.size);
        }
        whirl_result_free(read);
        whirl_result_free(result);
        whirl_case_free(object);
    }
}

static const char measured[] = "kind-fit.csv";

static int write_measured(void **state) {
    FILE *file = fopen(measured, "w");
    (void)state;
    if (!file) return -1;
    fprintf(file, "omega, disc x [m], disc y [m]\n1.2, 1.1, 1.2\n1.5, 1.2, 1.1\n");
    return fclose(file);
}

static int remove_measured(void **state) {
    (void)state;
    return remove(measured);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_study_is_run),
        cmocka_unit_test(finished_files_are_recognised),
        cmocka_unit_test(motions_without_a_verdict),
        cmocka_unit_test(stopped_before_the_first_point),
    };
    return cmocka_run_group_tests(tests, write_measured, remove_measured);
}
