// A fit: its unknown parameters, and the tables of measured numbers with the motions that they are of.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input.h"
#include "plan_batches.h"
#include "plan_fit.h"
#include "plan_names.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"
#include "two_pi.h"
#include "whirl/internal/csv.h"

enum { FIT_MAX_COLUMNS = 2 + 4 * WHIRL_MAX_PROBES, FIT_INSTANTS = 64, FIT_MAX_ORDER = 64, FIT_PATH = 4096 };

/// Largest distance of an angle from an instant of the motion, as part of the distance of instants.
#define FIT_OFF_INSTANT 1e-3

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

/// Reads a file of measured numbers: its name, or a mapping with more.
static void fit_read_set(case_reader *reader, const file_node *where, fit_set *out) {
    out->place = where;
    out->keys = (setting_list){.name = "data", .group = &schema_fit_data, .place = where};
    if (where->kind == NODE_TEXT && !node_is_null(where)) {
        out->file = where;
        return;
    }
    settings_read(reader, where, &schema_fit_data, &out->keys);
    const setting *file = settings_find(&out->keys, "file"), *at = settings_find(&out->keys, "at");
    if (file) out->file = file->place;
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
        fit_read_set(reader, one, &fit->sets[fit->set_count++]);
}

const fit_parts *fit_read(case_reader *reader, const machine_parts *machine, const setting_list *keys) {
    fit_parts *fit = arena_take(reader->arena, sizeof *fit);
    reader->no_memory = reader->no_memory || !fit;
    if (!fit) return NULL;
    *fit = (fit_parts){.keys = *keys, .machine = machine};
    fit_read_unknowns(reader, fit);
    fit_read_sets(reader, fit);
    // A parameter is either looked for or given.
    for (size_t s = 0; s < fit->set_count; s++)
        for (size_t i = 0; i < fit->sets[s].at.count; i++)
            for (size_t u = 0; u < fit->unknown_count; u++)
                if (fit->unknowns[u].parameter == fit->sets[s].at.parameters[i])
                    problem_at_key(reader->problems, fit->sets[s].at.places[i],
                                   "is one of the unknowns, expected another parameter");
    return fit;
}

// ---------------------------------------------------------------- tables of measured numbers

/// Contents of a column.
typedef struct fit_column {
    enum { FIT_ANGLE, FIT_SPEED, FIT_PARAMETER, FIT_DISPLACEMENT, FIT_LAG } kind;
    size_t station;
    double direction, order; ///< rad; order of vectors
    double size;             ///< SI per unit
    const parameter *parameter;
    size_t lag; ///< column of the lag of a displacement, or its own column
} fit_column;

/// The lists of a fit while its tables are read.
typedef struct fit_maker {
    case_reader *reader;
    valuation *v;
    const fit_parts *parts;
    whirl_fit fit;
    whirl_fit_motion *motions;
    whirl_fit_number *numbers;
    size_t motion_capacity, number_capacity;
    int revolutions;
    double checksum;
    // The present table.
    size_t set;
    csv_table table;
    fit_column columns[FIT_MAX_COLUMNS];
    const whirl_given *at; ///< parameters that the table gives
    size_t at_count;
    double noise; ///< standard deviation of the table's numbers, m; 1 if it is not given
} fit_maker;

/// Fails at a heading.
#define FIT_FAIL(m, column, ...)                                                                                       \
    csv_fail(&(m)->table, (m)->table.heading, (m)->table.columns[column].place, __VA_ARGS__)

/// Cuts the last word off a text and returns it; NULL if there is only one.
static char *fit_last_word(char *text) {
    char *space = strrchr(text, ' ');
    if (!space) return NULL;
    char *word = space + 1;
    while (space > text && space[-1] == ' ') space--;
    *space = '\0';
    return word;
}

/// Understands the heading of a probe: "disc x", "disc 45", "disc x 2X", "disc x lag", "disc x 2X lag".
static whirl_status fit_probe_heading(fit_maker *m, size_t column, bool vectors) {
    char text[CSV_TEXT], advice[WHY_SIZE], *end;
    fit_column *own = &m->columns[column];
    const named_list *stations = &m->parts->machine->stations;
    memcpy(text, m->table.columns[column].name, sizeof text);
    *own = (fit_column){.kind = FIT_DISPLACEMENT, .order = 1.0, .lag = column};
    char *word = fit_last_word(text);
    // Split off the word lag and the order.
    if (word && strcmp(word, "lag") == 0) {
        own->kind = FIT_LAG;
        word = fit_last_word(text);
    }
    if (word && *word && word[strlen(word) - 1] == 'X') {
        own->order = strtod(word, &end);
        if (end == word || strcmp(end, "X") != 0 || !(own->order > 0.0 && own->order <= FIT_MAX_ORDER))
            return FIT_FAIL(m, column, "'%.20s' is no order, expected 1X, 2X, 0.5X", word);
        if (fabs(own->order * m->revolutions - round(own->order * m->revolutions)) > 1e-9)
            return FIT_FAIL(m, column, "order %.20s does not occur in a motion of %d revolution%s", word,
                            m->revolutions, m->revolutions == 1 ? "" : "s");
        word = fit_last_word(text);
    }
    if (!vectors && (own->kind == FIT_LAG || strcmp(m->table.columns[column].name + strlen(text), "") == 0))
        return FIT_FAIL(m, column, "'%.40s' is no column of displacements over the angle, expected 'disc x', 'disc 45'",
                        m->table.columns[column].name);
    // Read the direction, and find the station.
    if (!word)
        return FIT_FAIL(m, column,
                        "'%.40s' is no column, expected angle, speed, a parameter, or a station and the direction of a "
                        "probe: 'disc x', 'disc 45'",
                        m->table.columns[column].name);
    const bool axis = strcmp(word, "x") == 0 || strcmp(word, "y") == 0;
    own->direction = axis ? (*word == 'y' ? 90.0 : 0.0) : strtod(word, &end);
    if (!axis && (end == word || *end || !isfinite(own->direction)))
        return FIT_FAIL(m, column, "'%.20s' is no direction of a probe, expected x, y or degrees from x", word);
    own->direction *= two_pi / 360.0;
    own->station = named_find(stations, text);
    if (own->station == stations->count) {
        machine_advise(m->parts->machine, text, false, advice);
        return FIT_FAIL(m, column, "'%.40s' is no station, %.200s", text, advice);
    }
    return own->kind == FIT_LAG ? csv_unit(&m->table, column, "rad", "deg", &own->size)
                                : csv_unit(&m->table, column, "m", "um", &own->size);
}

/// Understands a heading.
static whirl_status fit_heading(fit_maker *m, size_t column, bool vectors) {
    // An angle of the shaft may be in turns, radians or degrees.
    const csv_column *heading = &m->table.columns[column];
    fit_column *own = &m->columns[column];
    *own = (fit_column){.size = 1.0};
    if (strcmp(heading->name, "turns") == 0) {
        own->kind = FIT_ANGLE;
        return whirl_ok();
    }
    if (strcmp(heading->name, "angle") == 0) {
        own->kind = FIT_ANGLE;
        const whirl_status status = csv_unit(&m->table, column, "rad", "deg", &own->size);
        own->size /= two_pi;
        return status;
    }
    // Speed.
    if (strcmp(heading->name, "speed") == 0) {
        own->kind = FIT_SPEED;
        return csv_unit(&m->table, column, "rad/s", "rpm", &own->size);
    }
    // A parameter, or else a probe.
    const size_t index = parameters_find(m->reader->parameters, heading->name);
    if (index == m->reader->parameters->count) return fit_probe_heading(m, column, vectors);
    own->kind = FIT_PARAMETER;
    own->parameter = &m->reader->parameters->items[index];
    // A parameter that varies in the file cannot be an unknown.
    for (size_t u = 0; u < m->parts->unknown_count; u++)
        if (m->parts->unknowns[u].parameter == own->parameter)
            return FIT_FAIL(m, column, "is one of the unknowns, expected another parameter");
    const char *unit = parameter_expected_unit(own->parameter);
    return *heading->unit ? csv_unit(&m->table, column, unit, unit, &own->size) : whirl_ok();
}

/// Finds the lag of every displacement.
static whirl_status fit_join_lags(fit_maker *m) {
    for (size_t c = 0; c < m->table.column_count; c++) {
        const fit_column *lag = &m->columns[c];
        if (lag->kind != FIT_LAG) continue;
        size_t of = m->table.column_count;
        for (size_t k = 0; k < m->table.column_count; k++) {
            const fit_column *own = &m->columns[k];
            if (own->kind == FIT_DISPLACEMENT && own->station == lag->station && own->direction == lag->direction &&
                own->order == lag->order)
                of = k;
        }
        if (of == m->table.column_count) return FIT_FAIL(m, c, "is the lag of no amplitude, expected a column of it");
        m->columns[of].lag = c;
    }
    return whirl_ok();
}

static double fit_cell(const fit_maker *m, size_t column, size_t row) {
    return m->columns[column].size * csv_numbers(&m->table, column)[row];
}

/// Makes room for one more motion or number; NULL without memory.
static void *fit_grow(fit_maker *m, void *list, size_t count, size_t *capacity, size_t size) {
    if (count < *capacity) return list;
    const size_t more = *capacity > 0 ? 2 * *capacity : 64;
    void *out = arena_take(m->reader->arena, more * size);
    if (out && count > 0) memcpy(out, list, count * size);
    if (out) *capacity = more;
    m->reader->no_memory = m->reader->no_memory || !out;
    return out;
}

static whirl_status fit_add_motion(fit_maker *m, size_t given_count, const whirl_given *given, double speed,
                                   size_t instants) {
    if (m->fit.motion_count == WHIRL_MAX_FIT_MOTIONS)
        return whirl_fail(WHIRL_BAD_INPUT, "%.150s: the fit has more than %d motions", m->table.path,
                          WHIRL_MAX_FIT_MOTIONS);
    m->motions = fit_grow(m, m->motions, m->fit.motion_count, &m->motion_capacity, sizeof *m->motions);
    if (!m->motions) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    m->motions[m->fit.motion_count++] =
        (whirl_fit_motion){.given_count = given_count, .given = given, .speed = speed, .instants = instants};
    return whirl_ok();
}

static whirl_status fit_add_number(fit_maker *m, const fit_column *column, whirl_fit_quantity what, double at,
                                   double value) {
    if (m->fit.number_count == WHIRL_MAX_FIT_NUMBERS)
        return whirl_fail(WHIRL_BAD_INPUT, "%.150s: the fit has more than %d numbers", m->table.path,
                          WHIRL_MAX_FIT_NUMBERS);
    m->numbers = fit_grow(m, m->numbers, m->fit.number_count, &m->number_capacity, sizeof *m->numbers);
    if (!m->numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    m->numbers[m->fit.number_count++] = (whirl_fit_number){.set = m->set,
                                                           .motion = m->fit.motion_count - 1,
                                                           .station = column->station,
                                                           .angle = column->direction,
                                                           .quantity = what,
                                                           .at = at,
                                                           .value = value,
                                                           .noise = m->noise};
    m->checksum = fmod(1.618033988749895 * m->checksum + value * 1e6 + at + (double)what + m->noise * 1e3, 4096.0);
    return whirl_ok();
}

/// Adds the displacements over the angle of one motion.
static whirl_status fit_take_samples(fit_maker *m, size_t angle) {
    const csv_table *table = &m->table;
    if (table->count < 2)
        return FIT_FAIL(m, angle, "there is %zu row, expected some instants of a revolution", table->count);
    // The distance of instants is a whole part of a revolution.
    const double apart = fit_cell(m, angle, 1) - fit_cell(m, angle, 0);
    const double instants = round(1.0 / apart);
    if (!(instants >= 4.0 && instants <= 65536.0) || fabs(instants * apart - 1.0) > FIT_OFF_INSTANT)
        return csv_fail(table, table->lines[1], table->columns[angle].place,
                        "the angle is %g revolutions after the one before, expected a whole part of one", apart);
    whirl_status status = fit_add_motion(m, m->at_count, m->at, 0.0, (size_t)instants);
    for (size_t i = 0; i < table->count && status.code == WHIRL_OK; i++) {
        const double place = instants * fit_cell(m, angle, i), nearest = round(place);
        if (fabs(place - nearest) > FIT_OFF_INSTANT * (1.0 + 0.1 * (double)i) || nearest < 0.0)
            return csv_fail(table, table->lines[i], table->columns[angle].place,
                            "%g revolutions is not one of the instants k/%g", fit_cell(m, angle, i), instants);
        const double turn = fmod(nearest, instants * m->revolutions) / instants;
        for (size_t c = 0; c < table->column_count && status.code == WHIRL_OK; c++)
            if (m->columns[c].kind == FIT_DISPLACEMENT)
                status = fit_add_number(m, &m->columns[c], WHIRL_FIT_SAMPLE, turn, fit_cell(m, c, i));
    }
    return status;
}

/// Adds the numbers of one row: amplitudes, or for those with lags both components.
static whirl_status fit_take_row(fit_maker *m, size_t row) {
    whirl_status status = whirl_ok();
    for (size_t c = 0; c < m->table.column_count && status.code == WHIRL_OK; c++) {
        const fit_column *own = &m->columns[c];
        if (own->kind != FIT_DISPLACEMENT) continue;
        const double amplitude = fit_cell(m, c, row);
        if (amplitude < 0.0)
            return csv_fail(&m->table, m->table.lines[row], m->table.columns[c].place,
                            "the amplitude is %g, expected 0 or more", csv_numbers(&m->table, c)[row]);
        if (own->lag == c) {
            status = fit_add_number(m, own, WHIRL_FIT_AMPLITUDE, own->order, amplitude);
            continue;
        }
        const double lag = fit_cell(m, own->lag, row);
        status = fit_add_number(m, own, WHIRL_FIT_COS, own->order, amplitude * cos(lag));
        if (status.code == WHIRL_OK) status = fit_add_number(m, own, WHIRL_FIT_SIN, own->order, amplitude * sin(lag));
    }
    return status;
}

/// Adds orders over the speed or a parameter: every row is one motion.
static whirl_status fit_take_vectors(fit_maker *m, size_t along) {
    const fit_column *axis = &m->columns[along];
    double highest = 1.0;
    for (size_t c = 0; c < m->table.column_count; c++)
        if (m->columns[c].kind == FIT_DISPLACEMENT) highest = fmax(highest, m->columns[c].order);
    const size_t instants = FIT_INSTANTS * (size_t)ceil(highest / 4.0);
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < m->table.count && status.code == WHIRL_OK; i++) {
        const double value = fit_cell(m, along, i);
        if (axis->kind == FIT_SPEED && !(value > 0.0))
            return csv_fail(&m->table, m->table.lines[i], m->table.columns[along].place,
                            "the speed is %g, expected a number above 0", csv_numbers(&m->table, along)[i]);
        whirl_given *given = arena_take(m->reader->arena, (m->at_count + 1) * sizeof *given);
        if (!given) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
        for (size_t k = 0; k < m->at_count; k++) given[k] = m->at[k];
        const bool varies = axis->kind == FIT_PARAMETER;
        if (varies) given[m->at_count] = (whirl_given){axis->parameter->name, value};
        status = fit_add_motion(m, m->at_count + varies, given, varies ? 0.0 : value, instants);
        if (status.code == WHIRL_OK) status = fit_take_row(m, i);
    }
    return status;
}

/// Takes the numbers of a table that was read.
static whirl_status fit_take_table(fit_maker *m) {
    // Find the column over which the others were measured.
    const csv_table *table = &m->table;
    size_t along = table->column_count;
    bool any = false;
    if (table->count == 0)
        return csv_fail(table, 1, 1, "there is no row of numbers, expected a line of headings and some");
    for (size_t c = 0; c < table->column_count; c++) {
        const char *name = table->columns[c].name;
        const bool axis = strcmp(name, "angle") == 0 || strcmp(name, "turns") == 0 || strcmp(name, "speed") == 0 ||
                          parameters_find(m->reader->parameters, name) < m->reader->parameters->count;
        if (axis && along < table->column_count)
            return FIT_FAIL(m, c, "is a second column without a probe, expected one of angle, speed, or a parameter");
        if (axis) along = c;
    }
    if (along == table->column_count)
        return csv_fail(table, table->heading, 1, "there is no column 'angle [deg]', 'speed [rpm]' or of a parameter");
    // Over angles there are samples, over speeds or parameters vectors.
    const bool vectors =
        strcmp(table->columns[along].name, "angle") != 0 && strcmp(table->columns[along].name, "turns") != 0;
    whirl_status status = whirl_ok();
    // Understand all headings.
    for (size_t c = 0; c < table->column_count && status.code == WHIRL_OK; c++) {
        status = fit_heading(m, c, vectors);
        any = any || m->columns[c].kind == FIT_DISPLACEMENT;
    }
    if (status.code == WHIRL_OK) status = fit_join_lags(m);
    if (status.code == WHIRL_OK && !any)
        return csv_fail(table, table->heading, 1, "there is no probe, expected columns such as 'disc x [um]'");
    if (status.code != WHIRL_OK) return status;
    // Take the numbers.
    return vectors ? fit_take_vectors(m, along) : fit_take_samples(m, along);
}

static whirl_status fit_take_set(fit_maker *m, const fit_set *set) {
    const char *name = set->file && set->file->kind == NODE_TEXT ? set->file->text : "";
    char *path = arena_take(m->reader->arena, FIT_PATH);
    if (!path) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    if (!input_beside(m->reader->problems->file, name, path, FIT_PATH))
        return whirl_fail(WHIRL_BAD_INPUT, "%.100s is too long for the path of a table", name);
    whirl_status status = csv_load(path, FIT_MAX_COLUMNS, &m->table);
    if (status.code == WHIRL_OK) status = fit_take_table(m);
    csv_free(&m->table);
    return status;
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

/// Evaluates the parameters and the noise of a file. Returns false after a problem.
static bool fit_make_set(fit_maker *m, const fit_set *set, whirl_given *given) {
    const setting *noise = settings_find(&set->keys, "noise");
    m->at = given;
    m->at_count = set->at.count;
    m->noise = noise ? settings_number(m->v, &set->keys, "noise") : 1.0;
    for (size_t i = 0; i < set->at.count; i++) {
        given[i].name = set->at.parameters[i]->name;
        if (!plan_formula_value(m->reader, m->v, set->at.places[i], &set->at.values[i], &given[i].value)) return false;
    }
    return true;
}

/// Reports noise that only some of the files have, and options that need noise or bounds.
static void fit_check(case_reader *reader, const fit_parts *parts, const whirl_fit *fit, size_t noisy) {
    const setting *loss = settings_find(&parts->keys, "loss"), *starts = settings_find(&parts->keys, "starts");
    for (size_t s = 0; s < parts->set_count; s++)
        if (noisy > 0 && !settings_find(&parts->sets[s].keys, "noise"))
            problem_at(reader->problems, parts->sets[s].place,
                       "has no noise, and another file has, expected the standard deviation of all or of none");
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
        noisy += settings_find(&parts->sets[s].keys, "noise") != NULL;
    }
    fit_check(reader, parts, &m->fit, noisy);
    // Tables that cannot be read are no problem of the case: results are shown without them.
    for (size_t s = 0; s < parts->set_count && good && !m->fit.trouble; s++) {
        whirl_given *given = arena_take(reader->arena, (FIT_MAX_AT + 1) * sizeof *given);
        reader->no_memory = reader->no_memory || !given;
        good = given && fit_make_set(m, &parts->sets[s], given);
        m->set = s;
        const whirl_status status = good ? fit_take_set(m, &parts->sets[s]) : whirl_ok();
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
