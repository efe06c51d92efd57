/// whirl check: reports all problems of case files, or their content.
#include "command.h"
#include "cores.h"
#include "estimate.h"
#include "guard.h"
#include "phases.h"
#include "progress.h"
#include "study_summary.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case_arguments.h"
#include "files.h"
#include "limit.h"
#include "output.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/report.h"
#include "whirl/internal/film_tables.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/internal/study_try.h"

typedef struct check_arguments {
    case_arguments given; ///< the values of --set; the paths of the cases are argv from `first` on
    int first;
    const char *figure; ///< file for the drawing of the machine, or NULL
    bool force;
} check_arguments;

enum { KEY_FIGURE = 0x200, KEY_FORCE };

static const struct argp_option options[] = {
    SET_OPTION,
    {.name = "figure",
     .key = KEY_FIGURE,
     .arg = "FILE",
     .doc = "Draw the machine to scale: .png, .pdf, .svg or .json, of one case"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace an existing drawing"},
    {0},
};

static error_t check_parse(int key, char *argument, struct argp_state *state) {
    check_arguments *arguments = state->input;
    switch (key) {
    case KEY_SET:
        return parse_case_argument(&arguments->given, key, argument, state);
    case KEY_FIGURE:
        arguments->figure = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case ARGP_KEY_ARG:
        return ARGP_ERR_UNKNOWN; // ARGP_KEY_ARGS reads all paths together
    case ARGP_KEY_ARGS:
        arguments->first = state->next;
        if (arguments->figure && state->argc - state->next != 1)
            bad_argument(state, "--figure draws one case, %d are given", state->argc - state->next);
        return 0;
    case ARGP_KEY_NO_ARGS:
        require_option(state, NULL, "CASE.yaml");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

enum {
    LOOKED_AT = 3,    ///< number of values of a batch that are tried: the first, the middle and the last
    MAX_SECONDS = 1,  ///< processor time for a trial of motions, s
    STUDY_SECONDS = 3 ///< processor time for the trial of the study's first points, s
};

/// Machines at some values of a batch, with states [dimension] of their motions.
typedef struct look {
    size_t count;
    whirl_machine machines[LOOKED_AT];
    double *x[LOOKED_AT];
    bool carried[LOOKED_AT];
} look;

static void end_look(look *l) {
    for (size_t i = 0; i < l->count; i++) {
        if (l->machines[i].release) l->machines[i].release(l->machines[i].owner);
        free(l->x[i]);
    }
}

static whirl_status begin_look(look *l, const whirl_study *study, const whirl_batch *batch) {
    const size_t at[LOOKED_AT] = {0, batch->count / 2, batch->count - 1};
    whirl_status status = whirl_ok();
    while (l->count < LOOKED_AT && l->count < batch->count && status.code == WHIRL_OK) {
        whirl_machine *machine = &l->machines[l->count];
        status = whirl_study_machine(study, batch, at[l->count], machine);
        if (status.code != WHIRL_OK) break;
        const size_t bytes = machine->system->dimension * sizeof(double);
        double *x = l->x[l->count++] = malloc(bytes);
        if (x)
            memcpy(x, machine->start, bytes);
        else
            status = whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    }
    return status;
}

/// Integrates all machines with the structure of machine `first` over a few revolutions by a stable method, since films
/// stiffen as motions grow. The state of a machine that diverges stays at the last bounded one; if the trial takes too
/// long, all states stay at the last ones reached.
static whirl_status carry_with(look *l, size_t first, const whirl_batch *batch) {
    enum { REVOLUTIONS = 10 };
    whirl_integrate_options stable = batch->integrate;
    whirl_ensemble *lanes;
    size_t in[LOOKED_AT], used = 0;
    // Use rodas5p with wide tolerances, for at most MAX_SECONDS.
    snprintf(stable.method, sizeof stable.method, "rodas5p");
    stable.rtol = 1e-6;
    stable.atol = 1e-9;
    const whirl_stop *over = limit_begin(MAX_SECONDS);
    const whirl_system limited = limit_system(l->machines[first].system, over);
    const whirl_status status = whirl_ensemble_new(&limited, &stable, l->count - first, &lanes);
    if (status.code != WHIRL_OK) {
        limit_end();
        return status;
    }
    // Load the machines of this structure at their starts.
    for (size_t i = first; i < l->count; i++) {
        if (l->carried[i]) continue;
        l->carried[i] = whirl_ensemble_load(lanes, used, l->machines[i].system, l->x[i]).code == WHIRL_OK;
        if (l->carried[i]) in[used++] = i;
    }
    // Keep the last state of each motion that is bounded.
    for (int i = 0; i < REVOLUTIONS && !*over; i++) {
        whirl_ensemble_revolve(lanes, used, NULL);
        for (size_t lane = 0; lane < used && !*over; lane++)
            if (whirl_ensemble_motion(lanes, lane) == WHIRL_BOUNDED) whirl_ensemble_state(lanes, lane, l->x[in[lane]]);
    }
    whirl_ensemble_free(lanes);
    limit_end();
    return l->carried[first] ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
}

/// Finds the number of steps per revolution that a batch needs; 0 if the batch's own number suffices. If a revolution
/// takes too long, the part that was computed counts.
static whirl_status needed_steps(const whirl_study *study, const whirl_batch *batch, double *needed) {
    look l = {0};
    *needed = 0.0;
    whirl_status status = begin_look(&l, study, batch);
    for (size_t i = 0; i < l.count && status.code == WHIRL_OK; i++)
        if (!l.carried[i]) status = carry_with(&l, i, batch);
    const whirl_stop *over = limit_begin(MAX_SECONDS);
    for (size_t i = 0; i < l.count && status.code == WHIRL_OK; i++) {
        whirl_step_check check = {.growth = 1.0};
        const whirl_system limited = limit_system(l.machines[i].system, over);
        status = whirl_step_check_revolution(&limited, &batch->integrate, l.x[i], NULL, 1e-5, &check);
        if (whirl_step_is_unstable(&check)) *needed = fmax(*needed, check.steps);
    }
    limit_end();
    end_look(&l);
    return status;
}

/// Warns if fixed steps are too long for the machine in its first revolutions, at the first, the middle and the last
/// value.
static whirl_status warn_of_steps(const char *path, const whirl_study *study, const whirl_batch *batch) {
    double needed;
    if (whirl_method_is_adaptive(batch->integrate.method)) return whirl_ok();
    const whirl_status status = needed_steps(study, batch, &needed);
    if (needed > 0.0)
        fprintf(stderr,
                "%s: warning: %d steps per revolution are unstable for this machine in its first revolutions (%s): it "
                "needs %.0f or "
                "more, or method auto\n",
                path, batch->integrate.steps_per_revolution, batch->name, needed);
    return status;
}

/// Prints a range, as in "omega from 2000 to 12000 rpm".
static void print_range(const whirl_result *outline, const char *name, double from, double to) {
    const whirl_unit unit = whirl_result_unit(outline, name);
    printf("%s from %.6g to %.6g%s%s", name, from / unit.size, to / unit.size, *unit.name ? " " : "", unit.name);
}

/// Prints an estimated time, as in "about 12 s on 2 cores".
static void print_time(double seconds, bool settle, int cores) {
    char text[32];
    if (isinf(seconds)) {
        fputs("hours, or without an end: a revolution takes over 5 s of processor time", stdout);
        return;
    }
    duration_text(fmax(seconds, 1.0), text, sizeof text);
    printf("%sabout %s on %d core%s", settle ? "at most " : "", text, cores, cores == 1 ? "" : "s");
}

/// Prints the range of a batch and its time, as in " sweep: omega from 2000 to 12000 rpm; about 12 s on 2 cores".
static whirl_status print_extent(const whirl_result *outline, const whirl_study *study, const whirl_batch *batch,
                                 bool timed) {
    const int cores = available_cores();
    const char *parameter;
    size_t count;
    const double *values = whirl_batch_values(batch, 0, &parameter, &count);
    const bool varies = values != NULL;
    double seconds = (double)NAN;
    const whirl_status status = timed ? estimate_seconds(study, batch, cores, &seconds) : whirl_ok();
    if (status.code != WHIRL_OK || (!varies && isnan(seconds))) return status;
    printf("  %s: ", batch->name);
    for (size_t i = 1; values; values = whirl_batch_values(batch, i++, &parameter, &count)) {
        if (i > 1) fputs(", ", stdout);
        print_range(outline, parameter, values[0], values[count - 1]);
    }
    if (varies && !isnan(seconds)) fputs("; ", stdout);
    if (!isnan(seconds))
        print_time(seconds, batch->record.settle && whirl_analysis_kind(batch->analyses)->moves, cores);
    putchar('\n');
    return whirl_ok();
}

/// Reports the range of a study, sweeps whose steps do not reach their end, and warnings about the case.
static whirl_status print_study(const char *path, const whirl_result *outline, const whirl_study *study, bool timed) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < study->batch_count && status.code == WHIRL_OK; i++) {
        const whirl_batch *batch = &study->batches[i];
        status = print_extent(outline, study, batch, timed);
        if (status.code == WHIRL_OK && batch->values)
            whirl_result_write_end(outline, batch->name, batch->parameter, batch->values[0], stdout);
    }
    whirl_shown_units units;
    char said[WHIRL_MESSAGE_SIZE];
    whirl_result_shown_units(outline, NULL, &units); // reading the case has checked its units
    for (size_t i = 0; *whirl_result_warning(outline, i); i++) {
        whirl_shown_sentence(&units, whirl_result_warning(outline, i), said, sizeof said);
        fprintf(stderr, "%s: warning: %s\n", path, said);
    }
    return status;
}

/// Prints a line about a shaft, as in "main: 0.75 m, 11.2 kg, 21 nodes, 20 elements; reduced to its 3 stations and
/// ...".
static void print_shaft(const whirl_shaft_summary *shaft) {
    const double turn = 6.283185307179586476925;
    printf("  shaft %s: %.4g m, %.4g kg, %zu nodes, %zu element%s", shaft->name, shaft->length, shaft->mass,
           shaft->nodes, shaft->elements, shaft->elements == 1 ? "" : "s");
    if (!shaft->reduced) {
        printf(", not reduced\n");
        return;
    }
    printf(", reduced to its stations and %zu of %zu modes a plane", shaft->modes, shaft->all_modes);
    if (shaft->modes > 0) printf(", up to %.4g Hz", shaft->highest / turn);
    printf("\n    reduction error: %.2g (%zu free-free frequencies), %.2g (static flexibility)\n",
           shaft->frequency_error, shaft->compared, shaft->flexibility_error);
}

static whirl_status print_shafts(const whirl_case *object) {
    whirl_shaft_summary shafts[WHIRL_MAX_SHAFTS];
    size_t count;
    const whirl_status status = whirl_case_shafts(object, shafts, &count);
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) print_shaft(&shafts[i]);
    return status;
}

/// Prints the notes of elements, as in "seal at disc: in the fluid K 3.686e+06 N/m, ...".
static void print_notes(const whirl_rotor *rotor) {
    char text[WHIRL_MESSAGE_SIZE];
    for (size_t i = 0; whirl_rotor_note(rotor, i, text); i++) printf("  %s\n", text);
}

/// Counts the film tables that a run makes before its first point, except tables that depend on forces of motions. It
/// builds outlines of machines for all values, which takes some tenths of a second.
static whirl_status count_tables(const whirl_study *study, size_t *missing) {
    enum { SHORT_TIME = 1 };
    const whirl_stop *over = limit_begin(SHORT_TIME);
    whirl_status status = whirl_ok();
    whirl_film_tables asked = {0};
    whirl_film_tables_watch(&asked);
    for (size_t b = 0; b < study->batch_count && status.code == WHIRL_OK; b++) {
        whirl_batch batch = study->batches[b];
        batch.outline = true;
        for (size_t point = 0; point < batch.count && status.code == WHIRL_OK && !*over; point++) {
            whirl_machine machine;
            status = whirl_study_machine(study, &batch, point, &machine);
            if (status.code == WHIRL_OK && machine.release) machine.release(machine.owner);
            if (whirl_film_tables_count(&asked) == 0) break; // machines of this batch have no pads
        }
    }
    limit_end();
    whirl_film_tables_watch(NULL);
    *missing = whirl_film_tables_missing(&asked);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

/// Finds errors that a run would report: those of the outline, then, if film tables are ready, those of the first
/// points at rest.
static whirl_status try_study(const whirl_case *object, const whirl_study *study, bool ready, whirl_result *outline) {
    whirl_status status = whirl_case_describe_result(object, outline);
    if (status.code != WHIRL_OK || !ready) return status;
    status = whirl_study_try(study, limit_begin(STUDY_SECONDS));
    limit_end();
    return status;
}

/// Prints the content of a good case.
static whirl_status print_case(const char *path, const whirl_case *object, const whirl_rotor *rotor,
                               const whirl_study *study, const whirl_result *outline, size_t missing) {
    const whirl_system *const system = whirl_rotor_system(rotor);
    char name[WHIRL_MESSAGE_SIZE];
    snprintf(name, sizeof name, "%s", path);
    whirl_make_plain(name);
    printf("%s: good\n", name);
    if (*whirl_case_title(object)) printf("  %s\n", whirl_case_title(object));
    printf("  %zu station%s:", system->probe_count, system->probe_count == 1 ? "" : "s");
    for (size_t i = 0; i < system->probe_count; i++) printf("%s %s", i ? "," : "", system->probes[i].name);
    putchar('\n');
    whirl_status status = print_shafts(object);
    print_notes(rotor);
    summarize_study(study);
    if (missing > 0)
        printf("  before the first point: %zu film table%s to be made, about a second of processor time each; how "
               "long points take and whether steps are short enough is not known until then\n",
               missing, missing == 1 ? " is" : "s are");
    if (status.code == WHIRL_OK) status = print_study(path, outline, study, missing == 0);
    if (status.code == WHIRL_OK) status = print_phases(study, &study->batches[0], rotor);
    return status;
}

/// Checks that a case without errors of reading also gives a rotor and a study that a run accepts, and prints its
/// content.
static whirl_status describe_case(const char *path, const whirl_case *object) {
    whirl_rotor *rotor = NULL;
    size_t missing = 0;
    whirl_status status = whirl_case_rotor_outline(object, NULL, 0, &rotor);
    if (status.code != WHIRL_OK) return status;
    whirl_study study;
    whirl_result *const outline = calloc(1, sizeof *outline);
    if (!outline) status = whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    if (status.code == WHIRL_OK) status = whirl_case_study(object, &study);
    if (status.code == WHIRL_OK) status = count_tables(&study, &missing);
    if (status.code == WHIRL_OK && missing == 0) status = whirl_study_choose_methods(&study);
    if (status.code == WHIRL_OK) status = try_study(object, &study, missing == 0, outline);
    for (size_t i = 0; status.code == WHIRL_OK && i < study.batch_count && missing == 0; i++)
        status = warn_of_steps(path, &study, &study.batches[i]);
    if (status.code == WHIRL_OK) status = print_case(path, object, rotor, &study, outline, missing);
    whirl_result_free(outline);
    whirl_rotor_free(rotor);
    return status;
}

/// Writes the drawing of the machine to the file of --figure.
static int draw_machine(const check_arguments *arguments, const char *path, const whirl_case *object) {
    whirl_result *outline = calloc(1, sizeof *outline);
    whirl_figure *figure = NULL;
    whirl_status status = outline ? whirl_case_describe_result(object, outline)
                                  : whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    if (status.code == WHIRL_OK) status = whirl_figure_new(outline, "rotor", NULL, &figure);
    int outcome = EXIT_DONE;
    if (status.code == WHIRL_OK &&
        !may_write_file(arguments->figure, path, "the case itself, expected another file", arguments->force)) {
        outcome = EXIT_FAILED;
    } else if (status.code == WHIRL_OK) {
        guard_output(arguments->figure);
        status = whirl_figure_write(figure, arguments->figure, NULL);
        if (status.code == WHIRL_OK) printf("%s: %s\n", arguments->figure, figure->title);
    }
    whirl_figure_free(figure);
    whirl_result_free(outline);
    return status.code == WHIRL_OK ? outcome : complain_of(&status);
}

static int check_file(const check_arguments *arguments, const char *argument) {
    const case_arguments *given = &arguments->given;
    const char *const path = is_standard_input(argument) ? standard_input : argument;
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    if (is_other_than_case(argument)) return EXIT_BAD_INPUT;
    whirl_status status = read_case(argument, &problems, &object);
    if (status.code != WHIRL_OK) return complain_of_problems(&problems, &status);
    const int set = apply_settings(given, object);
    if (set == EXIT_DONE) status = describe_case(path, object);
    int drawn = EXIT_DONE;
    if (set == EXIT_DONE && status.code == WHIRL_OK && arguments->figure) drawn = draw_machine(arguments, path, object);
    whirl_case_free(object);
    if (set != EXIT_DONE) return set;
    if (drawn != EXIT_DONE) return drawn;
    if (status.code == WHIRL_OK) return EXIT_DONE;
    // Put the path in front of the message, unless the message begins with it.
    const size_t length = strlen(path);
    if (strncmp(status.message, path, length) == 0 && status.message[length] == ':')
        complain("%s", status.message);
    else
        complain("%s: %s", path, status.message);
    if (status.code == WHIRL_NO_MEMORY) guard_note_exhausted();
    return status.code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
}

static int check_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = check_parse,
        .args_doc = "CASE.yaml...",
        .doc = "Reads case files and reports all errors in them: file, line, column, key, what was found and what is "
               "expected. For a good case it prints the stations and the amount of computation. CASE.yaml may be - for "
               "standard input.",
    };
    check_arguments arguments = {.first = argc};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    int outcome = EXIT_DONE;
    for (int i = arguments.first; i < argc && outcome != EXIT_FAILED; i++) {
        const int checked = check_file(&arguments, argv[i]);
        if (checked != EXIT_DONE) outcome = checked;
    }
    return outcome == EXIT_DONE ? finish_output() : outcome;
}

const command check_command = {"check", "report all errors of case files", check_run};
