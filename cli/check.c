/// whirl check: all that is wrong with case files, or what they hold.
#include "command.h"
#include "guard.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case_arguments.h"
#include "files.h"
#include "phases.h"
#include "summary.h"

typedef struct check_arguments {
    case_arguments given; ///< its settings; the cases are argv from `first` on
    int first;
} check_arguments;

static const struct argp_option options[] = {SET_OPTION, {0}};

static error_t parse(int key, char *argument, struct argp_state *state) {
    check_arguments *arguments = state->input;
    switch (key) {
    case KEY_SET:
        return parse_case_argument(&arguments->given, key, argument, state);
    case ARGP_KEY_ARG:
        return ARGP_ERR_UNKNOWN; // all of them at once, below
    case ARGP_KEY_ARGS:
        arguments->first = state->next;
        return 0;
    case ARGP_KEY_NO_ARGS:
        require_option(state, NULL, "CASE.yaml");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/// Looks at the steps after a few revolutions from the machine's start, by a method that is stable: films stiffen as a
/// motion grows.
static whirl_status look_at_steps(const whirl_machine *machine, const whirl_batch *batch, whirl_step_check *check) {
    enum { REVOLUTIONS = 10 };
    whirl_integrate_options stable = batch->integrate;
    whirl_integrator *integrator;
    const size_t bytes = machine->system->dimension * sizeof(double);
    double *x = malloc(bytes);
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    memcpy(x, machine->start, bytes);
    snprintf(stable.method, sizeof stable.method, "rodas5p");
    stable.rtol = 1e-6;
    stable.atol = 1e-9;
    whirl_status status = whirl_integrator_new(machine->system, &stable, &integrator);
    if (status.code == WHIRL_OK) {
        whirl_motion motion = WHIRL_BOUNDED;
        for (int i = 0; i < REVOLUTIONS && motion == WHIRL_BOUNDED; i++)
            motion = whirl_integrator_revolve(integrator, x, NULL, NULL);
        whirl_integrator_free(integrator);
        const double *from = motion == WHIRL_BOUNDED ? x : machine->start;
        status = whirl_step_check_revolution(machine->system, &batch->integrate, from, NULL, 1e-5, check);
    }
    free(x);
    return status;
}

/// Warns where fixed steps are too long for the machine in its first revolutions, at the first, the middle and the last
/// value.
static whirl_status warn_of_steps(const char *path, const whirl_study *study, const whirl_batch *batch) {
    const size_t at[] = {0, batch->count / 2, batch->count - 1};
    whirl_status status = whirl_ok();
    double needed = 0.0;
    if (whirl_method_is_adaptive(batch->integrate.method)) return status;
    for (size_t i = 0; i < 3 && status.code == WHIRL_OK; i++) {
        whirl_machine machine;
        whirl_step_check check = {.growth = 1.0};
        const double value = batch->values ? batch->values[at[i]] : (double)NAN;
        status = study->machine(study->family, batch, value, &machine);
        if (status.code != WHIRL_OK) break;
        status = look_at_steps(&machine, batch, &check);
        if (machine.release) machine.release(machine.owner);
        if (whirl_step_is_unstable(&check)) needed = fmax(needed, check.steps);
    }
    if (needed > 0.0)
        fprintf(stderr,
                "%s: warning: %d steps a revolution are unstable for this machine in its first revolutions (%s): it "
                "needs %.0f or "
                "more, or method auto\n",
                path, batch->integrate.steps_per_revolution, batch->name, needed);
    return status;
}

/// Says where the steps of a sweep do not meet its end.
static whirl_status tell_end(const whirl_case *object, const whirl_batch *batch) {
    whirl_result *const told = calloc(1, sizeof *told);
    if (!told) return whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    const whirl_status status = whirl_case_describe_result(object, told);
    if (status.code == WHIRL_OK && batch->values) summarize_end(told, batch->parameter, batch->values[0]);
    whirl_result_free(told);
    return status;
}

/// "main: 0.75 m, 11.2 kg, 21 nodes, 20 elements; reduced to its 3 stations and ..."
static void tell_shaft(const whirl_shaft_summary *shaft) {
    const double turn = 6.283185307179586476925;
    printf("  shaft %s: %.4g m, %.4g kg, %zu nodes, %zu element%s", shaft->name, shaft->length, shaft->mass,
           shaft->nodes, shaft->elements, shaft->elements == 1 ? "" : "s");
    if (!shaft->reduced) {
        printf(", not reduced\n");
        return;
    }
    printf(", reduced to its stations and %zu of %zu modes a plane", shaft->modes, shaft->all_modes);
    if (shaft->modes > 0) printf(", up to %.4g Hz", shaft->highest / turn);
    printf("\n    beside all nodes: frequencies of the free shaft (%zu compared) err by %.2g, displacements by forces "
           "by %.2g\n",
           shaft->compared, shaft->frequency_error, shaft->flexibility_error);
}

static whirl_status tell_shafts(const whirl_case *object) {
    whirl_shaft_summary shafts[WHIRL_MAX_SHAFTS];
    size_t count;
    const whirl_status status = whirl_case_shafts(object, shafts, &count);
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) tell_shaft(&shafts[i]);
    return status;
}

/// A case that reads well must also give a rotor and a study.
static whirl_status describe_case(const char *path, const whirl_case *object) {
    whirl_rotor *rotor = NULL;
    whirl_status status = whirl_case_rotor(object, NULL, 0, &rotor);
    if (status.code != WHIRL_OK) return status;
    whirl_study study;
    status = whirl_case_study(object, &study);
    if (status.code == WHIRL_OK) status = whirl_study_choose_methods(&study);
    if (status.code == WHIRL_OK) {
        const whirl_system *const system = whirl_rotor_system(rotor);
        char name[WHIRL_MESSAGE_SIZE];
        snprintf(name, sizeof name, "%s", path);
        whirl_make_plain(name);
        printf("%s: good\n", name);
        if (*whirl_case_title(object)) printf("  %s\n", whirl_case_title(object));
        printf("  %zu station%s:", system->probe_count, system->probe_count == 1 ? "" : "s");
        for (size_t i = 0; i < system->probe_count; i++) printf("%s %s", i ? "," : "", system->probes[i].name);
        putchar('\n');
        status = tell_shafts(object);
        summarize_study(&study);
        if (status.code == WHIRL_OK) status = tell_end(object, &study.batches[0]);
        if (status.code == WHIRL_OK) status = tell_phases(&study, &study.batches[0], rotor);
        for (size_t i = 0; i < study.batch_count && status.code == WHIRL_OK; i++)
            status = warn_of_steps(path, &study, &study.batches[i]);
    }
    whirl_rotor_free(rotor);
    return status;
}

enum { LONGEST_CASE = (1 << 20) + 1 }; // one byte more than a case may have, so that a longer one is refused

/// A case from standard input.
static whirl_status load_input(const char *name, whirl_problems *problems, whirl_case **object) {
    char *const text = malloc(LONGEST_CASE);
    if (!text) return whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    const size_t length = fread(text, 1, LONGEST_CASE, stdin);
    const whirl_status status = ferror(stdin) ? whirl_fail(WHIRL_BAD_INPUT, "%s cannot be read", name)
                                              : whirl_case_parse(text, length, name, problems, object);
    free(text);
    return status;
}

static int check_file(const case_arguments *given, const char *argument) {
    const bool input = strcmp(argument, "-") == 0;
    const char *const path = input ? "standard input" : argument;
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    if (!input && is_result_for_case(path)) return EXIT_BAD_INPUT;
    whirl_status status = input ? load_input(path, &problems, &object) : whirl_case_load(path, &problems, &object);
    if (status.code != WHIRL_OK) return complain_of_problems(&problems, &status);
    const int set = apply_settings(given, object);
    if (set == EXIT_DONE) status = describe_case(path, object);
    whirl_case_free(object);
    if (set != EXIT_DONE) return set;
    if (status.code == WHIRL_OK) return EXIT_DONE;
    complain("%s: %s", path, status.message);
    if (status.code == WHIRL_NO_MEMORY) guard_note_exhausted();
    return status.code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
}

static int run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = parse,
        .args_doc = "CASE.yaml...",
        .doc = "Reads case files and says all that is wrong with them: file, line, column, key, what was found and "
               "what is "
               "expected. For a good one: its stations and how much there is to compute. "
               "- stands for standard input.",
    };
    check_arguments arguments = {.first = argc};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    int outcome = EXIT_DONE;
    for (int i = arguments.first; i < argc && outcome != EXIT_FAILED; i++) {
        const int checked = check_file(&arguments.given, argv[i]);
        if (checked != EXIT_DONE) outcome = checked;
    }
    return outcome == EXIT_DONE ? finish_output() : outcome;
}

const command check_command = {"check", "say all that is wrong with case files", run};
