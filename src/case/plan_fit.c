// A fit: its unknown parameters, and the tables of measured numbers with the motions to which they belong.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit_run.h"
#include "fit_speed.h"
#include "fit_table.h"
#include "fit_value.h"
#include "plan_batches.h"
#include "plan_fit.h"
#include "plan_names.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"

// ---------------------------------------------------------------- reading the case

static void fit_read_unknown(case_reader *reader, const file_node *where, fit_unknown *out) {
    static const char *const names[] = {"start", "from", "to"};
    number_formula *const values[] = {&out->start, &out->low, &out->high};
    out->place = where;
    out->keys = (setting_list){.name = "unknown", .group = &schema_fit_unknown, .place = where};
    out->parameter = plan_find_named(reader, where);
    settings_read(reader, where, &schema_fit_unknown, &out->keys);
    if (!out->parameter) return;
    const whirl_key key = {
        .name = out->parameter->name, .unit = parameter_expected_unit(out->parameter), .range = WHIRL_ANY};
    for (size_t i = 0; i < 3; i++) {
        const setting *given = settings_find(&out->keys, names[i]);
        if (given) formula_read(reader, given->place, &key, values[i]);
    }
}

static void fit_read_unknowns(case_reader *reader, fit_parts *fit) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(&fit->keys, "unknown");
    if (!given) return; // has been reported
    const file_node *where = given->place;
    if (where->kind != NODE_MAPPING || where->count == 0 || where->count > WHIRL_MAX_UNKNOWNS) {
        problem_at(reader->problems, where, "is %s, expected 1 to %d names of parameters, {e: {from: 0.5, to: 1.2}}",
                   where->kind == NODE_MAPPING ? where->count ? "a longer list" : "empty" : node_shown(where, shown),
                   WHIRL_MAX_UNKNOWNS);
        return;
    }
    for (const file_node *one = where->first; one; one = one->next)
        fit_read_unknown(reader, one, &fit->unknowns[fit->unknown_count++]);
}

/// Returns the key of the noise of a column: the share of the time in contact is no length.
static whirl_key fit_channel_key(const fit_set *set, const fit_channel *channel) {
    whirl_key key = set->noise_key;
    if (strcmp(channel->place->key, "contact") == 0) key.unit = "1";
    return key;
}

/// Reads the noise of a set: one number, or one for each probe.
static void fit_read_noise(case_reader *reader, const setting *given, fit_set *out) {
    const file_node *where = given->place;
    if (where->kind != NODE_MAPPING) {
        formula_read(reader, where, &out->noise_key, &out->noise);
        return;
    }
    if (where->count == 0 || where->count > FIT_MAX_CHANNELS) {
        problem_at(reader->problems, where, "has %zu probes, expected 1 to %d", where->count, FIT_MAX_CHANNELS);
        return;
    }
    for (const file_node *one = where->first; one; one = one->next) {
        fit_channel *channel = &out->channels[out->channel_count++];
        channel->place = one;
        const whirl_key key = fit_channel_key(out, channel);
        formula_read(reader, one, &key, &channel->noise);
    }
}

/// Reads the columns that are chosen from a measured file: headings, each with its dataset.
static void fit_read_columns(case_reader *reader, fit_set *out) {
    const setting *columns = settings_find(&out->keys, "columns"), *record = settings_find(&out->keys, "record");
    char shown[SHOWN_SIZE];
    if (columns && record)
        problem_at_key(reader->problems, columns->place, "is given together with record, whose columns are its probes");
    if (!columns) return;
    const file_node *where = columns->place;
    if (where->kind != NODE_MAPPING || where->count == 0 || where->count > FIT_MAX_COLUMNS) {
        problem_at(reader->problems, where,
                   "is %s, expected 1 to %d headings, each with its dataset, such as disc x [um]: run/x",
                   where->kind == NODE_MAPPING ? where->count ? "a longer list" : "empty" : node_shown(where, shown),
                   FIT_MAX_COLUMNS);
        return;
    }
    for (const file_node *one = where->first; one; one = one->next) {
        if (strlen(one->key) >= CSV_TEXT)
            problem_at_key(reader->problems, one, "is a heading of %zu bytes, expected at most %d", strlen(one->key),
                           CSV_TEXT - 1);
        if (one->kind != NODE_TEXT || node_is_null(one) || strlen(one->text) >= CSV_TEXT)
            problem_at(reader->problems, one, "is %s, expected the path of a dataset, of at most %d bytes",
                       node_shown(one, shown), CSV_TEXT - 1);
    }
    out->columns = where;
}

/// Reads a set of measured numbers: the name of a file, or a mapping with more.
static void fit_read_set(case_reader *reader, const machine_parts *machine, const file_node *where, fit_set *out) {
    out->place = where;
    out->keys = (setting_list){.name = "data", .group = &schema_fit_data, .place = where};
    out->noise_key = (whirl_key){.name = "noise", .unit = "m", .range = WHIRL_POSITIVE};
    if (where->kind == NODE_TEXT && !node_is_null(where)) {
        out->file = where;
        return;
    }
    settings_read(reader, where, &schema_fit_data, &out->keys);
    const setting *file = settings_find(&out->keys, "file"), *at = settings_find(&out->keys, "at");
    const setting *noise = settings_find(&out->keys, "noise");
    if (file) out->file = file->place;
    fit_read_columns(reader, out);
    fit_value_read(reader, out);
    fit_run_read(reader, machine, out);
    if (noise) fit_read_noise(reader, noise, out);
    fit_value_check_keys(reader, out);
    if (!at) return;
    if (at->place->kind != NODE_MAPPING || at->place->count == 0 || at->place->count > FIT_MAX_AT) {
        char shown[SHOWN_SIZE];
        problem_at(reader->problems, at->place, "is %s, expected 1 to %d parameters with their values in this file",
                   at->place->kind == NODE_MAPPING ? "a list of another length" : node_shown(at->place, shown),
                   FIT_MAX_AT);
        return;
    }
    for (const file_node *one = at->place->first; one; one = one->next) plan_read_given(reader, one, &out->at);
}

static void fit_read_sets(case_reader *reader, fit_parts *fit) {
    const setting *given = settings_find(&fit->keys, "data");
    if (!given) return; // has been reported
    const file_node *where = given->place;
    if (where->kind == NODE_LIST && (where->count == 0 || where->count > WHIRL_MAX_FIT_SETS)) {
        problem_at(reader->problems, where, "has %zu files, expected 1 to %d", where->count, WHIRL_MAX_FIT_SETS);
        return;
    }
    const file_node *one = where->kind == NODE_LIST ? where->first : where;
    for (; one; one = where->kind == NODE_LIST ? one->next : NULL)
        fit_read_set(reader, fit->machine, one, &fit->sets[fit->set_count++]);
}

/// Reports a parameter along which a number is measured although it is given or an unknown.
static void fit_check_set(case_reader *reader, const fit_parts *fit, const fit_set *set) {
    static const char looked_for[] = "is one of the unknowns, expected another parameter";
    const bool varies = fit_value_varies(set);
    const parameter *along = !varies ? NULL : set->along ? set->along : fit_shaft_parameter(reader, fit);
    const setting *key = settings_find(&set->keys, "along");
    for (size_t u = 0; u < fit->unknown_count; u++) {
        if (along && fit->unknowns[u].parameter == along)
            problem_at(reader->problems, key ? key->place : set->place, "varies along %s, which %s", along->name,
                       looked_for);
        for (size_t i = 0; i < set->at.count; i++)
            if (fit->unknowns[u].parameter == set->at.parameters[i])
                problem_at_key(reader->problems, set->at.places[i], "%s", looked_for);
    }
    for (size_t i = 0; i < set->at.count; i++)
        if (along && set->at.parameters[i] == along)
            problem_at_key(reader->problems, set->at.places[i],
                           "is the parameter along which the number is measured, expected another one");
}

const fit_parts *fit_read(case_reader *reader, const machine_parts *machine, const setting_list *keys) {
    fit_parts *fit = arena_take(reader->arena, sizeof *fit);
    reader->no_memory = reader->no_memory || !fit;
    if (!fit) return NULL;
    *fit = (fit_parts){.keys = *keys, .machine = machine};
    fit_read_unknowns(reader, fit);
    fit_read_sets(reader, fit);
    // A parameter is either looked for, or given, or varies.
    for (size_t s = 0; s < fit->set_count; s++) fit_check_set(reader, fit, &fit->sets[s]);
    return fit;
}

// ---------------------------------------------------------------- making the fit

/// Evaluates the unknowns. Returns false after a problem.
static bool fit_make_unknowns(fit_maker *m) {
    // Make memory for the unknowns.
    whirl_fit_unknown *unknowns = arena_take(m->reader->arena, (m->parts->unknown_count + 1) * sizeof *unknowns);
    m->reader->no_memory = m->reader->no_memory || !unknowns;
    if (!unknowns) return false;
    bool good = true;
    // Evaluate start and bounds; a start that is not given is the parameter's own value.
    for (size_t u = 0; u < m->parts->unknown_count; u++) {
        const fit_unknown *own = &m->parts->unknowns[u];
        const struct {
            const char *key;
            const number_formula *formula;
            double *value;
        } ends[] = {{"start", &own->start, &unknowns[u].start},
                    {"from", &own->low, &unknowns[u].low},
                    {"to", &own->high, &unknowns[u].high}};
        const size_t index = (size_t)(own->parameter - m->reader->parameters->items);
        unknowns[u] = (whirl_fit_unknown){own->parameter->name, index, m->v->values[index], -INFINITY, INFINITY};
        for (size_t i = 0; i < 3; i++) {
            const setting *given = settings_find(&own->keys, ends[i].key);
            if (given) good = plan_formula_value(m->reader, m->v, given->place, ends[i].formula, ends[i].value) && good;
        }
        // Refuse starts that are not between their bounds.
        const bool within = unknowns[u].start >= unknowns[u].low && unknowns[u].start <= unknowns[u].high;
        if (good && !(unknowns[u].low < unknowns[u].high && within)) {
            problem_at_key(m->reader->problems, own->place,
                           "begins at %.10g between %.10g and %.10g, expected a start between two bounds",
                           unknowns[u].start, unknowns[u].low, unknowns[u].high);
            good = false;
        }
    }
    m->fit.unknown_count = m->parts->unknown_count;
    m->fit.unknowns = unknowns;
    return good;
}

/// Evaluates a standard deviation. Returns false after a problem.
static bool fit_make_noise(fit_maker *m, const whirl_key *key, const file_node *where, const number_formula *formula,
                           double *noise) {
    if (!plan_formula_value(m->reader, m->v, where, formula, noise)) return false;
    const whirl_status status = formula_check(m->reader->parameters, key, formula, *noise);
    if (status.code != WHIRL_OK) problem_at(m->reader->problems, where, "%s", status.message);
    return status.code == WHIRL_OK;
}

/// Evaluates the parameters and the noise of a file. Returns false after a problem.
static bool fit_make_set(fit_maker *m, const fit_set *set, whirl_given *given) {
    const setting *noise = settings_find(&set->keys, "noise");
    m->at = given;
    m->at_count = set->at.count;
    m->speed = 0.0;
    m->record.is = false;
    m->noise = set->channel_count > 0 ? 0.0 : 1.0;
    if (noise && set->channel_count == 0 && !fit_make_noise(m, &set->noise_key, noise->place, &set->noise, &m->noise))
        return false;
    for (size_t i = 0; i < set->channel_count; i++) {
        const whirl_key key = fit_channel_key(set, &set->channels[i]);
        if (!fit_make_noise(m, &key, set->channels[i].place, &set->channels[i].noise, &m->channel_noise[i]))
            return false;
    }
    for (size_t i = 0; i < set->at.count; i++) {
        given[i].name = set->at.parameters[i]->name;
        if (!plan_formula_value(m->reader, m->v, set->at.places[i], &set->at.values[i], &given[i].value)) return false;
    }
    return true;
}

/// Reports noise that only some of the sets have, and options that need noise or bounds.
static void fit_check(case_reader *reader, const fit_parts *parts, const whirl_fit *fit, size_t noisy) {
    const setting *loss = settings_find(&parts->keys, "loss"), *starts = settings_find(&parts->keys, "starts");
    for (size_t s = 0; s < parts->set_count; s++)
        if (noisy > 0 && !settings_find(&parts->sets[s].keys, "noise"))
            problem_at(reader->problems, parts->sets[s].place,
                       "has no noise, and other numbers have, expected the standard deviation of all or of none");
    if (loss && strcmp(settings_word(&parts->keys, "loss"), "huber") == 0 && noisy == 0)
        problem_at(reader->problems, loss->place, "is huber, which needs the noise of the measured numbers");
    for (size_t u = 0; u < fit->unknown_count && starts; u++)
        if (!isfinite(fit->unknowns[u].low) || !isfinite(fit->unknowns[u].high))
            problem_at(reader->problems, starts->place, "needs from and to of %s, between which further starts are",
                       fit->unknowns[u].name);
}

void fit_make(case_reader *reader, valuation *v, const fit_parts *parts, whirl_batch *batch) {
    fit_maker *m = arena_take(reader->arena, sizeof *m);
    whirl_fit *fit = arena_take(reader->arena, sizeof *fit);
    reader->no_memory = reader->no_memory || !m || !fit;
    if (!m || !fit) return;
    *m = (fit_maker){.reader = reader, .v = v, .parts = parts, .revolutions = batch->record.fit.revolutions};
    bool good = fit_make_unknowns(m);
    size_t noisy = 0;
    for (size_t s = 0; s < parts->set_count; s++) {
        good = settings_check(reader, v, &parts->sets[s].keys) && good;
        good = fit_run_check(reader, v, &parts->sets[s]) && good;
        noisy += settings_find(&parts->sets[s].keys, "noise") != NULL;
    }
    fit_check(reader, parts, &m->fit, noisy);
    // Tables that cannot be read are no problem of the case: results are shown without them.
    for (size_t s = 0; s < parts->set_count && good && !m->fit.trouble; s++) {
        whirl_given *given = arena_take(reader->arena, (FIT_MAX_AT + 1) * sizeof *given);
        reader->no_memory = reader->no_memory || !given;
        good = given && fit_make_set(m, &parts->sets[s], given);
        m->set = s;
        if (good && !parts->sets[s].file) {
            good = fit_value_make(m, &parts->sets[s]);
            continue;
        }
        const whirl_status status = good ? fit_table_read(m, &parts->sets[s]) : whirl_ok();
        if (status.code == WHIRL_OK) continue;
        reader->no_memory = reader->no_memory || status.code == WHIRL_NO_MEMORY;
        m->fit.trouble = arena_text(reader->arena, status.message, strlen(status.message));
    }
    if (good && !m->fit.trouble && m->fit.number_count < m->fit.unknown_count)
        problem_at(reader->problems, parts->keys.place,
                   "has %zu unknowns and %zu measured numbers, expected more numbers", m->fit.unknown_count,
                   m->fit.number_count);
    m->fit.motions = m->motions;
    m->fit.numbers = m->numbers;
    *fit = m->fit;
    batch->fit = fit;
    batch->count = (size_t)settings_number(v, &parts->keys, "starts");
    whirl_fit_options *options = &batch->record.fit;
    options->unknowns = (int)fit->unknown_count;
    options->motions = (int)fit->motion_count;
    options->numbers = (int)fit->number_count;
    options->noise = noisy > 0 ? 1.0 : 0.0;
    options->data = m->checksum;
}
