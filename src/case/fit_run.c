#include "fit_run.h"
#include "fit_list.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan_names.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"

/// Reports keys of a study `runup` that do not belong to the run of a fit: those of its axis and of its results.
static void fit_run_check_keys(case_reader *reader, const setting_list *keys) {
    static const char *const unused[] = {"name",   "spectra",  "spectrum_turns", "highest_order", "slow_roll",
                                         "orbits", "waveform", "sensitivity",    "stationary"};
    for (size_t i = 0; i < schema_axis.key_count + sizeof unused / sizeof *unused; i++) {
        const char *key = i < schema_axis.key_count ? schema_axis.keys[i].name : unused[i - schema_axis.key_count];
        const setting *given = settings_find(keys, key);
        if (given)
            problem_at_key(reader->problems, given->place,
                           "has no meaning for the run of a fit, expected the speeds of the run, its beginning and its "
                           "events");
    }
}

void fit_run_read(case_reader *reader, const machine_parts *machine, fit_set *out) {
    const setting *given = settings_find(&out->keys, "runup");
    if (!given) return;
    const whirl_group *group = &schema_at_rest[SCHEMA_AT_REST_runup];
    setting_list *keys = arena_take(reader->arena, sizeof *keys);
    reader->no_memory = reader->no_memory || !keys;
    if (!keys) return;
    *keys = (setting_list){.name = group->name, .group = group, .place = given->place};
    settings_read(reader, given->place, group, keys);
    plan_read_stations(reader, machine, keys, "loss_at", false);
    fit_run_check_keys(reader, keys);
    out->course = course_read(reader, machine, keys);
    out->runup = keys;
    // Refuse what the rows of a run do not have.
    const setting *compare = settings_find(&out->keys, "compare");
    if (compare && strcmp(settings_word(&out->keys, "compare"), "statistics") == 0)
        problem_at(reader->problems, compare->place,
                   "is statistics, which are of motions at one speed, expected no runup or no compare");
}

/// Returns true if the displacements of a run are compared, not its orders. Records of data sets are displacements.
static bool fit_run_is_waveform(const fit_set *set) {
    return settings_find(&set->keys, "record") || strcmp(settings_word(&set->keys, "compare"), "waveform") == 0;
}

bool fit_run_check(case_reader *reader, valuation *v, const fit_set *set) {
    bool good = !set->runup || settings_check(reader, v, set->runup);
    return (!set->course || course_check(reader, v, set->course)) && good;
}

/// Adds the options of a run to the checksum of the measured numbers.
static void fit_run_sum(fit_maker *m, const whirl_runup_options *options) {
    for (const whirl_member *member = whirl_runup_members(); member->part; member++)
        if (member->type == WHIRL_MEMBER_NUMBER)
            fit_list_sum(m, 1, (double[]){*(const double *)((const char *)options + member->offset) * 1e3});
}

whirl_status fit_run_make(fit_maker *m, const fit_set *set, whirl_fit_run **out) {
    whirl_fit_run *run = arena_take(m->reader->arena, sizeof *run);
    whirl_runup_options *options = arena_take(m->reader->arena, sizeof *options);
    *out = run;
    m->reader->no_memory = m->reader->no_memory || !run || !options;
    if (!run || !options) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    *options = whirl_record_default().runup;
    settings_take(m->v, set->runup, whirl_runup_members(), options);
    // Differences of runs need a smaller tolerance than runs by themselves. No copy is followed.
    if (!settings_find(set->runup, "rtol")) options->rtol = 1e-10;
    snprintf(options->sensitivity, sizeof options->sensitivity, "no");
    options->stationary = 0;
    if (set->course) options->event_count = (int)set->course->event_count;
    if (set->course) course_name_shafts(set->course, options);
    // The run of a record begins with its first sample, as in the data set, and lasts as long as its samples.
    if (m->record.is) {
        if (settings_find(set->runup, "begin") && m->record.speed > 0.0 && strcmp(options->begin, "steady") != 0)
            return csv_fail(&m->table, 0, 0,
                            "its runs begin before their first sample, expected begin: steady or no begin");
        if (!settings_find(set->runup, "duration") && !settings_find(set->runup, "speeds"))
            options->duration = m->record.duration;
        if (!settings_find(set->runup, "angle")) options->angle = m->record.angle;
        if (!settings_find(set->runup, "begin") && m->record.speed > 0.0)
            snprintf(options->begin, sizeof options->begin, "steady");
    }
    *run = (whirl_fit_run){.set = m->set,
                           .first = m->fit.motion_count,
                           .delayed = settings_find(&set->keys, "delay") != NULL,
                           .waveform = fit_run_is_waveform(set),
                           .first_speed = m->record.is ? m->record.speed : 0.0,
                           .sized = settings_find(set->runup, "rows") != NULL,
                           .options = options};
    fit_run_sum(m, options);
    return whirl_ok();
}

bool fit_run_reaches(const whirl_fit_run *run, double speed, double ends[2]) {
    const whirl_runup_options *options = run->options;
    const double passed = options->rate * options->duration;
    ends[0] = options->from;
    ends[1] = options->to;
    // A run without an end is refused when it is made.
    if (!(options->rate > 0.0) || (options->to == 0.0 && options->duration == 0.0)) return true;
    // With a duration the run ends before or at speed_to, which only says in which direction the speed changes.
    if (options->duration > 0.0 && options->to < options->from && options->to > 0.0)
        ends[1] = fmax(options->to, options->from - passed);
    else if (options->duration > 0.0)
        ends[1] = options->to > 0.0 ? fmin(options->to, options->from + passed) : options->from + passed;
    const double slack = 1e-9 * fmax(ends[0], ends[1]);
    return speed >= fmin(ends[0], ends[1]) - slack && speed <= fmax(ends[0], ends[1]) + slack;
}
