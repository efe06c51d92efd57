/// whirl verify: finds out how far the verdicts of a case depend on numerics.
#include "command.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case_arguments.h"
#include "cores.h"
#include "interrupt.h"
#include "progress.h"
#include "whirl/internal/verify.h"

enum { SAMPLE = 9, MAX_POINTS = 10000, MAX_REVOLUTIONS = 1000000, NAME_SIZE = 64 };

typedef struct verify_arguments {
    case_arguments given;
    whirl_verify_options options;
    int points; ///< number of points of the sweep; 0: all points of the detail or of the response, or a few of the
                ///< sweep
    bool json, quiet;
} verify_arguments;

// ---------------------------------------------------------------- arguments

enum { KEY_JSON = KEY_OWN, KEY_POINTS, KEY_METHOD, KEY_REVOLUTIONS };

static const struct argp_option options[] = {
    {.name = "points",
     .key = KEY_POINTS,
     .arg = "N",
     .doc = "Use N points of the sweep, equally spaced (default: all points of the detail or the response, or 9 of the "
            "sweep)"},
    {.name = "method",
     .key = KEY_METHOD,
     .arg = "NAME",
     .doc = "The second method, an adaptive one (default: the first adaptive method that is not the case's)"},
    {.name = "revolutions",
     .key = KEY_REVOLUTIONS,
     .arg = "N",
     .doc = "Compare states after N revolutions from the start (default: 20)"},
    SET_OPTION,
    {.name = "threads", .key = KEY_THREADS, .arg = "N", .doc = "Compute on N threads (default: all cores)"},
    {.name = "json", .key = KEY_JSON, .doc = "Print one JSON document on standard output in place of the table"},
    {.name = "quiet", .key = 'q', .doc = "No progress"},
    {0},
};

static error_t verify_parse(int key, char *argument, struct argp_state *state) {
    verify_arguments *arguments = state->input;
    switch (key) {
    case 'q':
        arguments->quiet = true;
        return 0;
    case KEY_JSON:
        arguments->json = true;
        return 0;
    case KEY_POINTS:
        arguments->points = take_whole("--points", argument, MAX_POINTS, state);
        return 0;
    case KEY_REVOLUTIONS:
        arguments->options.revolutions = take_whole("--revolutions", argument, MAX_REVOLUTIONS, state);
        return 0;
    case KEY_METHOD:
        snprintf(arguments->options.method, sizeof arguments->options.method, "%s", argument);
        return 0;
    default:
        return parse_case_argument(&arguments->given, key, argument, state);
    }
}

// ---------------------------------------------------------------- which points

static const whirl_batch *find_batch(const whirl_study *study, whirl_role role) {
    for (size_t i = 0; i < study->batch_count; i++)
        if (study->batches[i].role == role) return &study->batches[i];
    return NULL;
}

/// Reduces a batch to `count` of its points, the first and the last among them. values [3 count]: memory for their
/// values.
static void sample(whirl_batch *batch, size_t count, double *values) {
    for (size_t i = 0; i < count; i++) {
        const size_t at = count > 1 ? i * (batch->count - 1) / (count - 1) : 0;
        values[i] = batch->values[at];
        if (batch->second_values) values[count + i] = batch->second_values[at];
        if (batch->third_values) values[2 * count + i] = batch->third_values[at];
    }
    batch->values = values;
    if (batch->second_values) batch->second_values = values + count;
    if (batch->third_values) batch->third_values = values + 2 * count;
    if (batch->row > 0) batch->row = count;
    if (batch->plane > 0) batch->plane = count;
    batch->refine = 0; // no points are added
    batch->count = count;
}

/// Returns the batch of points over one or two parameters; NULL if there is none.
static const whirl_batch *find_many(const whirl_study *study) {
    static const whirl_role roles[] = {WHIRL_ROLE_SURVEY, WHIRL_ROLE_MAP, WHIRL_ROLE_BASIN};
    const whirl_batch *found = NULL;
    for (size_t i = 0; i < sizeof roles / sizeof *roles && !found; i++) found = find_batch(study, roles[i]);
    return found;
}

/// Reduces the study to the points to verify. Returns the exit status.
static int choose_points(const verify_arguments *arguments, whirl_study *study, double values[2 * MAX_POINTS]) {
    const whirl_batch *sweep = find_many(study), *detail = find_batch(study, WHIRL_ROLE_DETAIL);
    const size_t wanted = (size_t)arguments->points;
    if (wanted > 0 && (!sweep || wanted > sweep->count)) {
        if (sweep)
            complain("--points is %zu, expected at most %zu, the points of the %s", wanted, sweep->count, sweep->name);
        else
            complain("--points is given, but the case has no sweep or map");
        return EXIT_BAD_INPUT;
    }
    whirl_batch chosen = wanted > 0 || !detail ? study->batches[0] : *detail;
    if (wanted > 0)
        sample(&chosen, wanted, values);
    else if (!detail && sweep && sweep->count > SAMPLE)
        sample(&chosen, SAMPLE, values);
    study->batches[0] = chosen;
    study->batch_count = 1;
    return EXIT_DONE;
}

// ---------------------------------------------------------------- the table

/// Writes the tolerance of a run: "1024 steps", "rtol 1e-09".
static void tolerance_text(const whirl_integrate_options *how, char text[NAME_SIZE]) {
    if (whirl_method_is_adaptive(how->method))
        snprintf(text, NAME_SIZE, "rtol %.3g", how->rtol);
    else
        snprintf(text, NAME_SIZE, "%d steps", how->steps_per_revolution);
}

/// Prints a value, or a dash for NaN.
static void print_number(const char *format, int width, double value) {
    char text[NAME_SIZE] = "-";
    if (isfinite(value)) snprintf(text, sizeof text, format, value);
    printf(" %*s", width, text);
}

/// Prints the observed order in the line of the last level.
static void print_order(const whirl_verification *v, const whirl_verify_point *point, int m, int level) {
    char text[NAME_SIZE] = "";
    if (level == WHIRL_VERIFY_LEVELS - 1)
        snprintf(text, sizeof text,
                 isnan(point->order[m])                                ? "-"
                 : whirl_method_is_adaptive(v->integrate[m][0].method) ? "rtol^%.2f"
                                                                       : "%.2f",
                 point->order[m]);
    printf(" %9s", text);
}

static void print_run(const whirl_verification *v, const whirl_verify_point *point, double unit, int m, int level) {
    const whirl_verify_run *run = &point->runs[m][level];
    char tolerance[NAME_SIZE], verdict[NAME_SIZE], value[NAME_SIZE] = "";
    tolerance_text(&v->integrate[m][level], tolerance);
    whirl_verdict_name(&run->verdict, verdict, sizeof verdict);
    if (m == 0 && level == 0 && *v->parameter) snprintf(value, sizeof value, "%.6g", point->value / unit);
    if (m == 0 && level == 1 && *v->second) snprintf(value, sizeof value, "%.6g", point->second);
    if (m == 0 && level == 2 && *v->third) snprintf(value, sizeof value, "%.6g", point->third);
    const char *method = level == 0                                 ? v->integrate[m][0].method
                         : level == 1 && v->integrate[m][0].located ? "located"
                                                                    : "";
    printf("%10s  %-11s  %-11s", value, method, tolerance);
    const bool reference = m == WHIRL_VERIFY_METHODS - 1 && level == WHIRL_VERIFY_LEVELS - 1;
    if (reference)
        printf(" %10s", "reference");
    else
        print_number("%.1e", 10, run->difference);
    print_order(v, point, m, level);
    print_number("%.1e", 8, reference ? (double)NAN : run->section);
    print_number("%.4f", 9, run->verdict.exponent.value);
    printf("  %s\n", verdict);
}

/// Prints the verdicts of a point, with the number of runs that give them: "P-1 (4), P-2 (2)".
static void print_verdicts(const whirl_verify_point *point) {
    const whirl_verify_run *const runs = point->runs[0];
    enum { RUNS = WHIRL_VERIFY_METHODS * WHIRL_VERIFY_LEVELS };
    char names[RUNS][NAME_SIZE];
    // Write the names of all verdicts.
    for (int i = 0; i < RUNS; i++) {
        const whirl_verdict short_verdict = {.regime = runs[i].verdict.regime, .period = runs[i].verdict.period};
        if (short_verdict.regime == WHIRL_PERIODIC)
            whirl_verdict_name(&short_verdict, names[i], NAME_SIZE);
        else
            snprintf(names[i], NAME_SIZE, "%s", whirl_regime_name(short_verdict.regime));
    }
    // Print each name once, with its count.
    const char *separator = "";
    for (int i = 0; i < RUNS; i++) {
        int count = 0;
        bool first = true;
        for (int k = 0; k < RUNS; k++) {
            const bool same = strcmp(names[i], names[k]) == 0;
            count += same;
            first = first && !(same && k < i);
        }
        if (first) printf("%s%s (%d)", separator, names[i], count);
        if (first) separator = ", ";
    }
    putchar('\n');
}

static void print_table(const whirl_verification *v, const whirl_unit *unit) {
    // Print the head of the table.
    char named[WHIRL_NAME_SIZE + 4] = "";
    if (*unit->name) snprintf(named, sizeof named, " (%s)", unit->name);
    printf("%s%s%s%s%s%s%s%s: %zu point%s by %s and %s; differences in length scales after %d revolutions\n\n",
           v->table, *v->parameter ? " of " : "", v->parameter, named, *v->second ? " and, below it, " : "", v->second,
           *v->third ? " and " : "", v->third, v->count, v->count == 1 ? "" : "s", v->integrate[0][0].method,
           v->integrate[1][0].method, v->revolutions);
    printf("%10s  %-11s  %-11s %10s %9s %8s %9s  %s\n", v->parameter, "method", "tolerance", "difference", "order",
           "section", "exponent", "verdict");
    // Print every method and level of each point.
    size_t agreed = 0;
    for (size_t i = 0; i < v->count; i++) {
        for (int m = 0; m < WHIRL_VERIFY_METHODS; m++)
            for (int level = 0; level < WHIRL_VERIFY_LEVELS; level++) print_run(v, &v->points[i], unit->size, m, level);
        agreed += v->points[i].agreed;
    }
    // Sum up, and explain the points whose verdicts differ.
    printf("\nverdicts that do not depend on numerics: %zu of %zu\n", agreed, v->count);
    if (*v->film_tables) printf("film tables: %s\n", v->film_tables);
    for (size_t i = 0; i < v->count; i++) {
        if (v->points[i].agreed) continue;
        if (*v->parameter)
            printf("  %s = %.6g%s%s: ", v->parameter, v->points[i].value / unit->size, *unit->name ? " " : "",
                   unit->name);
        else
            printf("  ");
        print_verdicts(&v->points[i]);
    }
}

// ---------------------------------------------------------------- command

static int verify(const verify_arguments *arguments, const whirl_study *study, whirl_verification **verification) {
    progress_view view = progress_begin();
    const whirl_run_options how = {
        .threads = arguments->given.threads,
        .progress = arguments->quiet ? NULL : progress_show,
        .context = &view,
        .stop = interrupt_watch(),
    };
    const whirl_status status = whirl_study_verify(study, &arguments->options, &how, verification);
    progress_end(&view);
    if (status.code != WHIRL_STOPPED) return complain_of(&status);
    complain("stopped, nothing is verified (%s)", interrupt_text());
    return EXIT_FAILED;
}

/// Returns the unit in which the case writes a parameter.
static whirl_unit unit_of(const whirl_case *object, const char *parameter) {
    whirl_result *outline = NULL;
    whirl_unit unit = {.name = "", .size = 1.0};
    if (*parameter && whirl_case_outline(object, &outline).code == WHIRL_OK)
        unit = whirl_result_unit(outline, parameter);
    whirl_result_free(outline);
    return unit;
}

static int verify_case(const verify_arguments *arguments) {
    // Load the case, and make its study.
    whirl_case *object = NULL;
    whirl_study study;
    whirl_verification *verification = NULL;
    double *const values = malloc((size_t)3 * MAX_POINTS * sizeof *values);
    int outcome = load_case(&arguments->given, &object);
    if (!values) {
        complain("%s", whirl_code_text(WHIRL_NO_MEMORY));
        outcome = EXIT_FAILED;
    }
    if (outcome == EXIT_DONE) {
        const whirl_status status = whirl_case_study(object, &study);
        outcome = complain_of(&status);
    }
    // Choose and compute the points.
    if (outcome == EXIT_DONE) outcome = choose_points(arguments, &study, values);
    if (outcome == EXIT_DONE) outcome = verify(arguments, &study, &verification);
    // Print the comparison.
    if (outcome == EXIT_DONE && arguments->json) {
        const whirl_status status = whirl_verification_write_json(verification, stdout);
        outcome = complain_of(&status);
    } else if (outcome == EXIT_DONE) {
        if (*whirl_case_title(object)) puts(whirl_case_title(object));
        const whirl_unit unit = unit_of(object, verification->parameter);
        print_table(verification, &unit);
    }
    whirl_verification_free(verification);
    whirl_case_free(object);
    free(values);
    return outcome == EXIT_DONE ? finish_output() : outcome;
}

static int verify_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = verify_parse,
        .args_doc = "CASE.yaml",
        .doc = "Computes points of a case by two methods at three tolerances each, prints how far states, sections, "
               "exponents and verdicts agree and which order is observed, and says which verdicts do not depend on "
               "numerics. Every point starts from the initial state.",
    };
    verify_arguments arguments = {.given.threads = available_cores(), .options.revolutions = 20};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    interrupt_watch();
    return verify_case(&arguments);
}

const command verify_command = {"verify", "find out which verdicts of a case depend on numerics", verify_run};
