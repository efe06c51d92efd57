// The course of a run: its events, its speeds, and its laws of rate, torque, load and motion of the ground. They are
// read from a case, and then evaluated with the parameter values of a point.
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan_batches.h"
#include "plan_course.h"
#include "plan_names.h"
#include "plan_parts.h"
#include "problem.h"
#include "schema.h"
#include "table_file.h"
#include "tree.h"

/// Keys of the laws of a run, in the order of whirl_run_formula.
static const char *const laws[] = {"rate_law", "torque_law", "load_law", "ground_x", "ground_y"};

/// Variables of every station, after its name and '_', in the order of WHIRL_OF_STATION_.
static const char *const of_station[WHIRL_OF_STATION] = {"x",     "y",     "radius",         "vx",   "vy",
                                                         "speed", "axial", "axial_velocity", "twist"};

// ---------------------------------------------------------------- formulas

/// Names that a formula may use.
typedef struct course_names {
    const parameter_table *parameters;
    const machine_parts *machine; ///< with its stations as variables; NULL: time and speed alone
    char name[WHIRL_NAME_SIZE];   ///< the last name
    bool twice;                   ///< true if that name is both a parameter and a variable
} course_names;

/// Returns the index of a variable's name; WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * stations for any other name.
static size_t course_variable(const machine_parts *machine, const char *name) {
    const size_t stations = machine ? machine->stations.count : 0;
    if (strcmp(name, "time") == 0) return WHIRL_VARIABLE_TIME;
    if (strcmp(name, "speed") == 0) return WHIRL_VARIABLE_SPEED;
    for (size_t s = 0; s < stations; s++) {
        const char *station = machine->stations.names[s];
        const size_t length = strlen(station);
        if (strncmp(name, station, length) != 0 || name[length] != '_') continue;
        for (size_t k = 0; k < WHIRL_OF_STATION; k++)
            if (strcmp(name + length + 1, of_station[k]) == 0)
                return WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * s + k;
    }
    return WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * stations;
}

static size_t course_variable_count(const machine_parts *machine) {
    return WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * machine->stations.count;
}

static bool course_knows(void *context, const char *name, size_t length) {
    course_names *c = context;
    snprintf(c->name, sizeof c->name, "%.*s", (int)length, name);
    const size_t none = WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * (c->machine ? c->machine->stations.count : 0);
    const bool known = parameters_find(c->parameters, c->name) < c->parameters->count;
    const bool variable = course_variable(c->machine, c->name) < none;
    c->twice = known && variable;
    return known != variable;
}

/// Returns a condition without its comparison: "a > b" is a - b. NULL after a problem.
static const char *course_without_comparison(case_reader *reader, const file_node *where, const char *text) {
    char shown[SHOWN_SIZE];
    size_t depth = 0, at = 0, count = 0;
    for (size_t i = 0; text[i]; i++) {
        depth += text[i] == '(';
        depth -= text[i] == ')' && depth > 0;
        if (strchr("<>!&|?", text[i]) || (text[i] == '=' && text[i + 1] == '=')) {
            count += depth > 0 || !strchr("<>", text[i]) ? 2 : 1;
            at = i;
        }
    }
    if (count == 0) return text;
    if (count > 1) {
        problem_at(reader->problems, where,
                   "is = %s, expected one comparison by < or >, or a formula that rises above 0",
                   text_shown(text, shown));
        return NULL;
    }
    const bool less = text[at] == '<';
    const char *right = text + at + 1 + (text[at + 1] == '=');
    const size_t size = strlen(text) + sizeof "()-()";
    char *made = arena_take(reader->arena, size);
    if (!made)
        reader->no_memory = true;
    else if (less)
        snprintf(made, size, "(%s)-(%.*s)", right, (int)at, text);
    else
        snprintf(made, size, "(%.*s)-(%s)", (int)at, text, right);
    return made;
}

/// Reads a formula. machine: with the stations whose motion it may use, or NULL. NULL after a problem.
static const char *course_read_formula(case_reader *reader, const file_node *where, const machine_parts *machine) {
    char why[WHY_SIZE], shown[SHOWN_SIZE];
    course_names names = {.parameters = reader->parameters, .machine = machine};
    const char *text = where->kind == NODE_TEXT ? where->text : "";
    if (*text != '=') {
        problem_at(reader->problems, where, "is %s, expected '= ' and a formula", node_shown(where, shown));
        return NULL;
    }
    text += 1 + strspn(text + 1, " ");
    if (expression_check(text, course_knows, &names, why)) return text;
    if (*why)
        problem_at(reader->problems, where, "%s", why);
    else if (names.twice)
        problem_at(reader->problems, where,
                   "is = %s, where %s is a parameter and a variable of the run, expected another name of the parameter",
                   text_shown(text, shown), names.name);
    else
        problem_at(reader->problems, where,
                   "is = %s, but no parameter is called %s, nor is it time%s (formulas are in SI)",
                   text_shown(text, shown), names.name,
                   machine ? ", speed or the motion of a station, such as STATION_radius, STATION_x or STATION_vy"
                           : " or speed");
    return NULL;
}

// ---------------------------------------------------------------- reading

/// Columns of files with tables: the time, and the quantities that a run can have over it; then the rotor's speed, and
/// the speed of another shaft over it.
enum {
    COLUMN_TIME,
    COLUMN_SPEED,
    COLUMN_RATE,
    COLUMN_TORQUE,
    COLUMN_LOAD,
    COLUMN_GROUND_X,
    COLUMN_GROUND_Y,
    COLUMN_ROTOR,
    COLUMN_BY_ROTOR,
    COLUMNS
};
#define COLUMN(index, word, si) [index] = {.name = (word), .unit = (si), .range = WHIRL_ANY}
static const whirl_key columns[COLUMNS] = {COLUMN(COLUMN_TIME, "time", "s"),
                                           COLUMN(COLUMN_SPEED, "speed", "rad/s"),
                                           COLUMN(COLUMN_RATE, "rate", "rad/s2"),
                                           COLUMN(COLUMN_TORQUE, "torque", "N m"),
                                           COLUMN(COLUMN_LOAD, "load", "N m"),
                                           COLUMN(COLUMN_GROUND_X, "ground_x", "m/s2"),
                                           COLUMN(COLUMN_GROUND_Y, "ground_y", "m/s2"),
                                           COLUMN(COLUMN_ROTOR, "rotor_speed", "rad/s"),
                                           COLUMN(COLUMN_BY_ROTOR, "shaft_speed", "rad/s")};
static const whirl_group columns_group = {
    "course_table", "a table over the time of a run", "", columns, COLUMNS, NULL, NULL};

/// Maximum number of rows of a table of a file.
enum { MAX_FILE_ROWS = 200000 };

/// Reads the file of a table with a reader of its own: a list of rows, each with time and the column. NULL after a
/// problem.
static const file_node *course_read_file(case_reader *reader, const file_node *where, case_reader *own) {
    const char *file = reader->problems->file, *slash = strrchr(file, '/');
    const int folder = *where->text == '/' || !slash ? 0 : (int)(slash + 1 - file);
    char path[sizeof own->problems->file];
    if (snprintf(path, sizeof path, "%.*s%s", folder, file, where->text) < (int)sizeof path)
        return table_read(own, path, &columns_group);
    problem_at(reader->problems, where, "is too long for the path of a table");
    return NULL;
}

/// Returns the cell of a column of a row of a file; NULL if the row has none.
static const file_node *course_cell(const file_node *row, size_t column) {
    const file_node *cell = row->first;
    while (cell && strcmp(cell->key, columns[column].name) != 0) cell = cell->next;
    return cell;
}

/// Reads the rows of a table with the reader of the case or the file.
static void course_read_rows(case_reader *reader, const file_node *list, const file_node *filed, size_t column,
                             course_table *table) {
    // Make memory for the rows.
    char shown[SHOWN_SIZE];
    const size_t over = column == COLUMN_BY_ROTOR ? COLUMN_ROTOR : COLUMN_TIME;
    table->rows = arena_take(reader->arena, list->count * sizeof *table->rows);
    reader->no_memory = reader->no_memory || !table->rows;
    // Find both cells of each row: a pair in the case, or two columns of the file.
    for (const file_node *row = list->first; row && table->rows; row = row->next) {
        const bool paired = !filed && row->kind == NODE_LIST && row->count == 2;
        const file_node *cells[] = {filed ? course_cell(row, over) : row->first,
                                    filed ? course_cell(row, column) : row->last};
        if (filed ? !cells[0] || !cells[1] : !paired) {
            if (filed)
                problem_in_file(reader->problems, row->line, 1, "has no %s, expected the columns %s and %s",
                                cells[0] ? columns[column].name : columns[over].name, columns[over].name,
                                columns[column].name);
            else
                problem_at(reader->problems, row, "is %s, expected a pair [%s, %s]", node_shown(row, shown),
                           columns[over].name, columns[column].name);
            return;
        }
        // Read the formulas of both cells.
        course_row *own = &table->rows[table->count++];
        own->place = filed ? filed : row;
        if (!formula_read(reader, cells[0], &columns[over], &own->time) ||
            !formula_read(reader, cells[1], &columns[column], &own->value))
            return;
    }
}

/// Reads a table over the time, from a list of pairs or a file. `column` is its quantity.
static void course_read_table(case_reader *reader, const file_node *where, size_t column, course_table *table) {
    char shown[SHOWN_SIZE];
    const bool filed = where->kind == NODE_TEXT;
    const bool by_rotor = column == COLUMN_BY_ROTOR;
    const size_t most = column == COLUMN_SPEED || by_rotor || !filed ? WHIRL_MAX_SPEEDS : MAX_FILE_ROWS;
    whirl_problems problems = {0};
    case_reader own = {.arena = reader->arena, .problems = &problems, .parameters = reader->parameters};
    const file_node *list = filed ? course_read_file(reader, where, &own) : where;
    if (!list || problems.count > 0 || (filed && list->count >= 2 && list->count <= most)) {
        if (list && problems.count == 0) course_read_rows(&own, list, where, column, table);
        reader->no_memory = reader->no_memory || own.no_memory;
        table_take_problems(reader, where, &problems);
    } else if (filed) {
        problem_at(reader->problems, where, "has %zu rows, expected 2 to %zu", list->count, most);
    } else if (list->kind != NODE_LIST || list->count < 2 || list->count > most) {
        problem_at(reader->problems, where, "is %s, expected 2 to %zu pairs [%s, %s], or a file",
                   where->kind == NODE_LIST ? "a list of another length" : node_shown(where, shown), most,
                   columns[by_rotor ? COLUMN_ROTOR : COLUMN_TIME].name, columns[column].name);
    } else {
        course_read_rows(reader, list, NULL, column, table);
    }
    whirl_problems_free(&problems);
}

/// Writes the text of a table that results and journals store: the number of its rows, and a checksum, which reveals
/// changes (Fowler, Noll, Vo 1991).
static void course_say_table(const file_node *where, const course_table *table, char *text, size_t size) {
    uint64_t sum = 0xcbf29ce484222325u;
    for (size_t i = 0; i < table->count; i++)
        for (size_t k = 0; k < 2; k++) {
            const number_formula *own = k == 0 ? &table->rows[i].time : &table->rows[i].value;
            unsigned char bytes[sizeof own->number];
            memcpy(bytes, &own->number, sizeof bytes);
            for (size_t b = 0; b < sizeof bytes; b++) sum = (sum ^ bytes[b]) * 0x100000001b3u;
        }
    snprintf(text, size, "%zu rows%s%.24s, %08x", table->count, where->kind == NODE_TEXT ? " of " : "",
             where->kind == NODE_TEXT ? where->text : "", (unsigned)(sum ^ sum >> 32));
}

/// Returns the index of the event of a name among the first `count`; `count` if there is none.
static size_t course_event_named(const course_parts *course, size_t count, const char *name) {
    size_t i = 0;
    while (i < count && (!course->events[i].name || strcmp(course->events[i].name, name) != 0)) i++;
    return i;
}

/// Reads the event after which this one may happen.
static void course_read_after(case_reader *reader, course_parts *course, course_event *own) {
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    const char *names[WHIRL_MAX_EVENTS];
    size_t count = 0;
    const setting *after = settings_find(&own->keys, "after");
    if (!after) return;
    const size_t before = (size_t)(own - course->events);
    for (size_t i = 0; i < before; i++)
        if (course->events[i].name) names[count++] = course->events[i].name;
    own->after = course_event_named(course, before, after->word ? after->word : "");
    if (own->after < before) return;
    own->after = WHIRL_NO_EVENT;
    describe_names(after->word ? after->word : "", names, count, advice);
    problem_at(reader->problems, after->place, "is %s, which is the name of no event before, %s",
               node_shown(after->place, shown), count > 0 ? advice : "expected one with a name");
}

/// Returns the index of the shaft of a name among those with a speed of their own; their number if there is none.
static size_t course_shaft_named(const course_parts *course, const char *name) {
    size_t i = 0;
    while (i < course->shaft_count && strcmp(course->shafts[i].name, name) != 0) i++;
    return i;
}

/// Reports a name that is no shaft with a speed of its own.
static void course_report_shaft(case_reader *reader, const course_parts *course, const machine_parts *machine,
                                const file_node *where, const char *name, bool key) {
    char advice[WHY_SIZE], shown[SHOWN_SIZE], text[2 * WHY_SIZE];
    const char *names[WHIRL_MAX_SPOOLS];
    for (size_t i = 0; i < course->shaft_count; i++) names[i] = course->shafts[i].name;
    describe_names(name, names, course->shaft_count, advice);
    if (named_find(&machine->shafts, name) < machine->shafts.count)
        snprintf(text, sizeof text,
                 "is %s, a shaft whose speed follows the rotor's, expected one with the key speed in "
                 "rotor.shafts, in place of ratio",
                 text_shown(name, shown));
    else
        snprintf(text, sizeof text, "is %s, which is no shaft, %s", text_shown(name, shown),
                 course->shaft_count > 0 ? advice : "expected a shaft of rotor.shafts with the key speed");
    if (key)
        problem_at_key(reader->problems, where, "%s", text);
    else
        problem_at(reader->problems, where, "%s", text);
}

/// Reads the shaft of an event.
static void course_read_event_shaft(case_reader *reader, const machine_parts *machine, const course_parts *course,
                                    course_event *own) {
    const setting *shaft = settings_find(&own->keys, "shaft");
    if (!shaft || !shaft->word) return;
    own->spool = course_shaft_named(course, shaft->word) + 1;
    if (own->spool <= course->shaft_count) return;
    own->spool = 0;
    course_report_shaft(reader, course, machine, shaft->place, shaft->word, false);
}

static void course_read_event(case_reader *reader, const file_node *where, const machine_parts *machine,
                              course_parts *course) {
    // Read the keys of the event.
    course_event *own = &course->events[course->event_count];
    *own = (course_event){.place = where, .after = WHIRL_NO_EVENT, .station = machine->stations.count};
    own->keys = (setting_list){.name = "event", .group = &schema_event, .place = where};
    settings_read(reader, where, &schema_event, &own->keys);
    plan_read_stations(reader, machine, &own->keys, "loss_at", false);
    plan_read_change(reader, &own->keys, &own->change);
    const setting *name = settings_find(&own->keys, "name"), *when = settings_find(&own->keys, "when");
    const setting *at = settings_find(&own->keys, "loss_at"), *moment = settings_find(&own->keys, "loss_moment");
    // Read its name, the event that it follows, and its condition.
    own->name = name ? name->word : NULL;
    course_read_after(reader, course, own);
    course->event_count++;
    if (when) own->when = course_read_formula(reader, when->place, machine);
    if (own->when) own->when = course_without_comparison(reader, when->place, own->when);
    // Read its effects.
    if (at && at->word) own->station = named_find(&machine->stations, at->word);
    if (!at != !moment)
        problem_at_key(reader->problems, where, "has %s, expected loss_at and loss_moment together",
                       at ? "loss_at alone" : "loss_moment alone");
    course_read_event_shaft(reader, machine, course, own);
    own->trip = settings_yes(&own->keys, "trip");
    own->end = settings_yes(&own->keys, "end");
    // Refuse events without a condition or an effect.
    if (!when && !settings_find(&own->keys, "time") && !settings_find(&own->keys, "speed") &&
        !settings_find(&own->keys, "after"))
        problem_at_key(reader->problems, where, "has no time, speed, when or after, expected one of them");
    const bool acts = at || own->trip || own->end || settings_find(&own->keys, "change");
    if (!acts && !own->name)
        problem_at_key(reader->problems, where, "changes nothing, expected trip, loss_at, change, end or a name");
}

static void course_read_events(case_reader *reader, const file_node *where, const machine_parts *machine,
                               course_parts *course) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_LIST || where->count == 0 || course->event_count + where->count > WHIRL_MAX_EVENTS) {
        problem_at(reader->problems, where, "is %s, expected a list of 1 to %zu events",
                   where->kind == NODE_LIST ? where->count ? "a longer list" : "empty" : node_shown(where, shown),
                   WHIRL_MAX_EVENTS - course->event_count);
        return;
    }
    for (const file_node *one = where->first; one; one = one->next) course_read_event(reader, one, machine, course);
}

/// Finds the shafts with a speed of their own.
static void course_find_shafts(case_reader *reader, const machine_parts *machine, course_parts *course) {
    size_t letters = 0;
    for (size_t i = 0; i < machine->shafts.count && course->shaft_count < WHIRL_MAX_SPOOLS; i++) {
        const setting *speed = settings_find(&machine->shafts.items[i], "speed");
        if (!speed) continue;
        course->shafts[course->shaft_count++] = (course_shaft){.name = machine->shafts.names[i]};
        letters += strlen(machine->shafts.names[i]) + 1; // results store the names in one text
        if (letters > WHIRL_NAME_SIZE)
            problem_at(reader->problems, speed->place,
                       "is given, and the names of shafts with a speed of their own have %zu letters in all, expected "
                       "at most %zu",
                       letters - course->shaft_count, WHIRL_NAME_SIZE - course->shaft_count);
    }
}

/// Returns true if a drive turns a shaft.
static bool course_has_drive(const machine_parts *machine, const char *shaft) {
    for (size_t i = 0; i < machine->element_count; i++) {
        const setting *own = settings_find(&machine->elements[i], "shaft");
        if (strcmp(machine->elements[i].name, "drive") == 0 && own && own->word && strcmp(own->word, shaft) == 0)
            return true;
    }
    return false;
}

/// Reads the laws of a shaft with a speed of its own.
static void course_read_shaft(case_reader *reader, const file_node *where, const machine_parts *machine,
                              course_shaft *own) {
    static const char *const given[] = {"rate", "speeds", "speed_law"};
    static const char *const torques[] = {"torque_law", "load_law"};
    own->place = where;
    settings_read(reader, where, &schema_shaft_run, &own->keys);
    // One law gives the speed, or a drive turns the shaft.
    const char *first = NULL;
    for (size_t i = 0; i < sizeof given / sizeof *given; i++) {
        if (!settings_find(&own->keys, given[i])) continue;
        if (first)
            problem_at_key(reader->problems, where, "has %s and %s, expected one of rate, speeds and speed_law", first,
                           given[i]);
        first = given[i];
    }
    for (size_t i = 0; i < sizeof torques / sizeof *torques; i++)
        if (first && settings_find(&own->keys, torques[i]))
            problem_at_key(reader->problems, where,
                           "has %s and %s, expected one of them: a law of the speed, or a drive", first, torques[i]);
    if (!first && !course_has_drive(machine, own->name))
        problem_at_key(
            reader->problems, where,
            "has nothing that turns it, expected rate, speeds or speed_law, or an element drive with shaft: %s",
            own->name);
    // Read the table or the formulas.
    const setting *speeds = settings_find(&own->keys, "speeds"), *law = settings_find(&own->keys, "speed_law");
    if (speeds) course_read_table(reader, speeds->place, COLUMN_SPEED, &own->speeds);
    own->by_rotor = law && !(law->place->kind == NODE_TEXT && *law->place->text == '=');
    if (own->by_rotor) course_read_table(reader, law->place, COLUMN_BY_ROTOR, &own->speeds);
    if (law && !own->by_rotor) own->formulas[WHIRL_SPOOL_SPEED] = course_read_formula(reader, law->place, NULL);
    for (size_t i = 0; i < sizeof torques / sizeof *torques; i++) {
        const setting *torque = settings_find(&own->keys, torques[i]);
        if (torque) own->formulas[WHIRL_SPOOL_MOTOR + i] = course_read_formula(reader, torque->place, NULL);
    }
}

static void course_read_shafts(case_reader *reader, const file_node *where, const machine_parts *machine,
                               course_parts *course) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_MAPPING || where->count == 0) {
        problem_at(reader->problems, where, "is %s, expected names of shafts with their laws",
                   where->kind == NODE_MAPPING ? "empty" : node_shown(where, shown));
        return;
    }
    for (const file_node *one = where->first; one; one = one->next) {
        const size_t k = course_shaft_named(course, one->key);
        if (k < course->shaft_count)
            course_read_shaft(reader, one, machine, &course->shafts[k]);
        else
            course_report_shaft(reader, course, machine, one, one->key, true);
    }
}

/// Sets the text that results store for a key whose value is a list.
static void course_say(case_reader *reader, setting_list *keys, const char *key, const char *text) {
    for (size_t i = 0; i < keys->count; i++)
        if (strcmp(keys->items[i].key->name, key) == 0)
            keys->items[i].word = arena_text(reader->arena, text, strlen(text));
}

const course_parts *course_read(case_reader *reader, const machine_parts *machine, setting_list *keys) {
    // Find out whether the run has a course.
    const setting *change = settings_find(keys, "change"), *events = settings_find(keys, "events");
    const setting *speeds = settings_find(keys, "speeds");
    char text[WHIRL_NAME_SIZE];
    const setting *shafts = settings_find(keys, "shafts");
    course_parts found = {.event_count = 0};
    course_find_shafts(reader, machine, &found);
    bool any = change || events || speeds || shafts || found.shaft_count > 0;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) any = any || settings_find(keys, laws[i]);
    if (!any) return NULL;
    course_parts *course = arena_take(reader->arena, sizeof *course);
    reader->no_memory = reader->no_memory || !course;
    if (!course) return NULL;
    *course = found;
    // A change of the whole run is an event without a condition.
    if (change) {
        course_event *own = &course->events[course->event_count++];
        *own = (course_event){.place = change->place,
                              .after = WHIRL_NO_EVENT,
                              .station = machine->stations.count,
                              .keys = *keys,
                              .alone = true};
        plan_read_change(reader, keys, &own->change);
    }
    // Read the laws of shafts with a speed of their own, events, the table of speeds, and laws as formulas or tables.
    if (shafts) course_read_shafts(reader, shafts->place, machine, course);
    if (events) course_read_events(reader, events->place, machine, course);
    if (speeds) course_read_table(reader, speeds->place, COLUMN_SPEED, &course->speeds);
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        const setting *given = settings_find(keys, laws[i]);
        if (!given) continue;
        if (given->place->kind == NODE_TEXT && *given->place->text == '=') {
            course->laws[i] = course_read_formula(reader, given->place, NULL);
            continue;
        }
        course_read_table(reader, given->place, COLUMN_RATE + i, &course->tables[i]);
        course_say_table(given->place, &course->tables[i], text, sizeof text);
        course_say(reader, keys, laws[i], text);
    }
    // Write the number of events and the speeds to the texts of their keys, which results store.
    snprintf(text, sizeof text, "%zu", course->event_count - (change != NULL));
    course_say(reader, keys, "events", text);
    if (speeds && speeds->place->kind == NODE_TEXT)
        course_say_table(speeds->place, &course->speeds, text, sizeof text);
    else
        snprintf(text, sizeof text, "%zu speeds", course->speeds.count);
    course_say(reader, keys, "speeds", text);
    return course;
}

void course_name_shafts(const course_parts *parts, whirl_runup_options *options) {
    options->shaft_count = (int)parts->shaft_count;
    *options->shafts = '\0';
    for (size_t k = 0; k < parts->shaft_count; k++) {
        const size_t used = strlen(options->shafts);
        snprintf(options->shafts + used, sizeof options->shafts - used, "%s%s", k > 0 ? " " : "",
                 parts->shafts[k].name);
    }
}

// ---------------------------------------------------------------- values

/// A law's table with the parameter values of a point; linear between its rows.
typedef struct course_values {
    size_t count, last;   ///< number of rows; row before the time of the previous look-up
    double *time, *value; ///< [count] in one block, which `time` begins
} course_values;

/// Evaluator of the formulas and tables of a run at a point.
struct course_run {
    whirl_run_course shown;
    expression_evaluator *formulas[WHIRL_FORMULAS]; ///< NULL for those that are not given
    course_values tables[WHIRL_FORMULA_EVENT];
    double lead;     ///< s of the run before the time 0 of formulas
    double values[]; ///< values of parameters, then of variables
};

/// Returns the value of a table at a time; 0 before and after it, where the ground is at rest.
static double course_look_up(course_values *of, double time) {
    size_t low = 0, high = of->count - 1;
    if (!(time >= of->time[0] && time <= of->time[high])) return 0.0;
    // Most times are between the rows of the previous look-up or the next ones.
    if (time >= of->time[of->last] && of->last + 2 < of->count && time <= of->time[of->last + 2])
        low = of->last, high = of->last + 2;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        *(time >= of->time[middle] ? &low : &high) = middle;
    }
    of->last = low;
    const double share = (time - of->time[low]) / (of->time[high] - of->time[low]);
    return of->value[low] + share * (of->value[high] - of->value[low]);
}

static double course_value(void *owner, whirl_run_formula formula) {
    course_run *run = owner;
    run->shown.variables[WHIRL_VARIABLE_TIME] -= run->lead;
    if (run->formulas[formula]) return evaluator_again(run->formulas[formula]);
    return course_look_up(&run->tables[formula], run->shown.variables[WHIRL_VARIABLE_TIME]);
}

void course_free(course_run *run) {
    for (size_t i = 0; run && i < WHIRL_FORMULAS; i++) evaluator_free(run->formulas[i]);
    for (size_t i = 0; run && i < WHIRL_FORMULA_EVENT; i++) free(run->tables[i].time);
    free(run);
}

const whirl_run_course *course_shown(const course_run *run) {
    return run ? &run->shown : NULL;
}

/// Writes the names of all variables to `names`, with `texts` as their memory. NULL for a station whose name has
/// characters that formulas do not allow.
static void course_name_variables(const machine_parts *machine, const char **names,
                                  char (*texts)[2 * WHIRL_NAME_SIZE]) {
    static const char in_names[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    const size_t count = course_variable_count(machine);
    for (size_t i = 0; i < count; i++) {
        const size_t station = i < WHIRL_VARIABLE_STATIONS ? 0 : (i - WHIRL_VARIABLE_STATIONS) / WHIRL_OF_STATION;
        if (i < WHIRL_VARIABLE_STATIONS)
            snprintf(texts[i], sizeof *texts, "%s", i == WHIRL_VARIABLE_TIME ? "time" : "speed");
        else
            snprintf(texts[i], sizeof *texts, "%.63s_%s", machine->stations.names[station],
                     of_station[(i - WHIRL_VARIABLE_STATIONS) % WHIRL_OF_STATION]);
        const bool named = !isdigit((unsigned char)*texts[i]) && !texts[i][strspn(texts[i], in_names)];
        names[i] = named ? texts[i] : NULL;
    }
}

/// Makes the evaluator of a formula of a key. names [count] of its parameters and variables.
static whirl_status course_add_formula(course_run *run, whirl_run_formula formula, const char *key, const char *text,
                                       const char *const *names, size_t count) {
    char why[WHY_SIZE];
    run->formulas[formula] = evaluator_new(names, run->values, count);
    if (!run->formulas[formula]) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the formulas of a run");
    if (!evaluator_take(run->formulas[formula], text, why)) return whirl_fail(WHIRL_BAD_INPUT, "%s %s", key, why);
    run->shown.has[formula] = true;
    return whirl_ok();
}

whirl_status course_covers(const course_run *run, double speed, double end) {
    run->shown.variables[WHIRL_VARIABLE_TIME] = 0.0;
    run->shown.variables[WHIRL_VARIABLE_SPEED] = speed;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++)
        if (run->formulas[i] && !isfinite(evaluator_again(run->formulas[i])))
            return whirl_fail(WHIRL_BAD_INPUT, "%s has no value at 0 s and %.6g rad/s, expected a finite one", laws[i],
                              speed);
    for (size_t i = 0; i < WHIRL_FORMULA_GROUND_X; i++) {
        const course_values *own = &run->tables[i];
        if (own->count > 0 && !(own->time[0] <= 0.0 && own->time[own->count - 1] >= end))
            return whirl_fail(
                WHIRL_BAD_INPUT,
                "%s is known from %.6g to %.6g s and the run goes from 0 to %.6g s, expected a table that covers "
                "the run",
                laws[i], own->time[0], own->time[own->count - 1], end);
    }
    return whirl_ok();
}

/// Evaluates a number of an event; NaN if it is not given.
static double course_number(valuation *v, const course_event *own, const char *key) {
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, own->alone ? "change_%s" : "%s", key);
    const setting *given = settings_find(&own->keys, name);
    double number = NAN;
    if (given && valuation_number(v, &given->value, &number).code != WHIRL_OK) number = NAN;
    // Without a list of events, a change_time or change_speed of 0 is no condition.
    return own->alone && number == 0.0 ? (double)NAN : number;
}

static void course_make_event(valuation *v, const course_event *own, size_t stations, whirl_run_event *out) {
    const char *passing = own->alone ? "either" : settings_word(&own->keys, "passing");
    const bool rises = strcmp(passing, "rising") == 0, falls = strcmp(passing, "falling") == 0;
    *out = (whirl_run_event){.time = course_number(v, own, "time"),
                             .speed = course_number(v, own, "speed"),
                             .spool = own->spool,
                             .passing = rises   ? 1
                                        : falls ? -1
                                                : 0,
                             .when = own->when != NULL,
                             .after = own->after,
                             .trip = own->trip,
                             .end = own->end,
                             .changes = own->change.count > 0};
    if (own->station == stations) return;
    const double angle = course_number(v, own, "loss_angle");
    out->lost = (whirl_placed){own->station, course_number(v, own, "loss_moment"), isnan(angle) ? 0.0 : angle};
}

/// Evaluates the rows of a table: times [count], or speeds of the rotor, and values [count].
static whirl_status course_make_rows(const course_table *from, valuation *v, double *times, double *values) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < from->count && status.code == WHIRL_OK; i++) {
        status = valuation_number(v, &from->rows[i].time, &times[i]);
        if (status.code == WHIRL_OK) status = valuation_number(v, &from->rows[i].value, &values[i]);
    }
    return status;
}

/// Evaluates a law's table.
static whirl_status course_make_table(const course_table *from, const char *key, valuation *v, course_run *run,
                                      size_t law) {
    course_values *out = &run->tables[law];
    whirl_status status = whirl_ok();
    if (from->count == 0) return status;
    out->time = malloc(2 * from->count * sizeof *out->time);
    if (!out->time) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a table of %zu rows", from->count);
    out->value = out->time + from->count;
    status = course_make_rows(from, v, out->time, out->value);
    for (size_t i = 1; i < from->count && status.code == WHIRL_OK; i++)
        if (!(out->time[i] > out->time[i - 1]))
            status = whirl_fail(WHIRL_BAD_INPUT, "%s has %.6g s after a later time, expected times that rise", key,
                                out->time[i]);
    out->count = from->count;
    run->shown.has[law] = true;
    return status;
}

static whirl_status course_make_speeds(const course_parts *parts, valuation *v, whirl_run_course *out) {
    const whirl_status status = course_make_rows(&parts->speeds, v, out->speed_times, out->speeds);
    for (size_t i = 0; i < parts->speeds.count && status.code == WHIRL_OK; i++) {
        if (i == 0 ? out->speed_times[i] != 0.0 : !(out->speed_times[i] > out->speed_times[i - 1]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              i == 0 ? "the speeds of the run begin at %.6g s, expected 0"
                                     : "the speeds of the run have %.6g s after a later time, expected "
                                       "times that rise",
                              out->speed_times[i]);
        if (i > 0 && !(out->speeds[i] > 0.0))
            return whirl_fail(WHIRL_BAD_INPUT, "the speed of the run is %.6g rad/s at %.6g s, expected one above 0",
                              out->speeds[i], out->speed_times[i]);
    }
    out->speed_count = parts->speeds.count;
    return status;
}

/// Evaluates the table of a shaft.
static whirl_status course_make_shaft_table(const course_shaft *from, valuation *v, whirl_spool_course *out) {
    const whirl_status status = course_make_rows(&from->speeds, v, out->at, out->speeds);
    out->count = from->speeds.count;
    for (size_t i = 0; i < out->count && status.code == WHIRL_OK; i++) {
        if (i == 0 && !from->by_rotor && out->at[0] != 0.0)
            return whirl_fail(WHIRL_BAD_INPUT, "the speeds of shaft '%s' begin at %.6g s, expected 0", from->name,
                              out->at[0]);
        if (i > 0 && !(out->at[i] > out->at[i - 1]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the speeds of shaft '%s' have %.6g %s after a larger one, expected "
                              "them to rise",
                              from->name, out->at[i], from->by_rotor ? "rad/s of the rotor" : "s");
        if (!(out->speeds[i] >= 0.0))
            return whirl_fail(WHIRL_BAD_INPUT, "the speed of shaft '%s' is %.6g rad/s, expected one not below 0",
                              from->name, out->speeds[i]);
        out->highest = fmax(out->highest, out->speeds[i]);
    }
    if (!from->by_rotor) out->from = out->speeds[0];
    return status;
}

/// Evaluates a number of a shaft's law.
static whirl_status course_shaft_number(const course_shaft *from, const char *key, valuation *v, double *out) {
    const setting *given = settings_find(&from->keys, key);
    *out = 0.0;
    return given ? valuation_number(v, &given->value, out) : whirl_ok();
}

static whirl_status course_make_shaft(const course_shaft *from, const whirl_spool *spool, double duration, valuation *v,
                                      whirl_spool_course *out) {
    *out = (whirl_spool_course){.law = WHIRL_SPOOL_RATE, .from = spool->speed, .highest = spool->speed};
    if (!from->place) return whirl_ok();
    whirl_status status = course_shaft_number(from, "speed_from", v, &out->from);
    if (status.code == WHIRL_OK) status = course_shaft_number(from, "speed_to", v, &out->to);
    if (status.code == WHIRL_OK) status = course_shaft_number(from, "rate", v, &out->rate);
    if (status.code != WHIRL_OK) return status;
    out->highest = fmax(out->from, out->to);
    if (from->speeds.count > 0) {
        if (out->from > 0.0 || out->to > 0.0)
            return whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' has a table of its speed and %s, expected one of them",
                              from->name, out->from > 0.0 ? "speed_from" : "speed_to");
        out->law = from->by_rotor ? WHIRL_SPOOL_BY_ROTOR : WHIRL_SPOOL_BY_TIME;
        return course_make_shaft_table(from, v, out);
    }
    if (from->formulas[WHIRL_SPOOL_SPEED]) {
        out->law = WHIRL_SPOOL_BY_FORMULA;
        if (out->to == 0.0)
            status = whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' has speed_law and no highest speed, expected speed_to",
                                from->name);
        return status;
    }
    if (settings_find(&from->keys, "rate")) {
        if (out->to == 0.0) out->highest = out->from + out->rate * duration;
        if (out->rate > 0.0 && out->to > 0.0 && out->to == out->from)
            status = whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' begins and ends at %.10g rad/s, expected two speeds",
                                from->name, out->to);
        return status;
    }
    // Its drive turns it.
    out->law = WHIRL_SPOOL_DRIVEN;
    if (!from->formulas[WHIRL_SPOOL_MOTOR]) out->highest = fmax(out->highest, spool->drive_speed);
    if (!(out->highest > 0.0))
        status =
            whirl_fail(WHIRL_BAD_INPUT, "the highest speed of shaft '%s' is not known, expected speed_to", from->name);
    return status;
}

whirl_status course_make_shafts(const course_parts *parts, valuation *v, const whirl_system *system, double duration,
                                course_run *run) {
    whirl_run_course *out = &run->shown;
    whirl_status status = whirl_ok();
    out->spool_count = parts->shaft_count;
    if (out->spool_count != system->spool_count) out->spool_count = 0;
    const double length = out->speed_count > 0 && duration == 0.0 ? out->speed_times[out->speed_count - 1] : duration;
    for (size_t k = 0; k < out->spool_count && status.code == WHIRL_OK; k++) {
        status = course_make_shaft(&parts->shafts[k], &system->spools[k], length, v, &out->spools[k]);
        if (status.code == WHIRL_OK && !(out->spools[k].highest > 0.0))
            status = whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' never turns in the run, expected a speed above 0",
                                parts->shafts[k].name);
    }
    return status;
}

whirl_status course_make(const course_parts *parts, const machine_parts *machine, valuation *v, double length,
                         course_run **out) {
    // Make memory: values of parameters and variables one after the other, and their names.
    const size_t parameters = v->parameters->count, variables = course_variable_count(machine);
    const size_t count = parameters + variables;
    course_run *run = calloc(1, sizeof *run + count * sizeof *run->values);
    const char **names = malloc(count * sizeof *names);
    char(*texts)[2 * WHIRL_NAME_SIZE] = malloc(variables * sizeof *texts);
    *out = run;
    whirl_status status =
        run && names && texts ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the course of a run");
    // Fill in what laws and events share.
    if (status.code == WHIRL_OK) {
        memcpy(run->values, v->values, parameters * sizeof *run->values);
        if (parameters > 0) memcpy(names, v->parameters->names, parameters * sizeof *names);
        course_name_variables(machine, names + parameters, texts);
        run->shown.length = length;
        run->shown.variables = run->values + parameters;
        run->shown.owner = run;
        run->shown.value = course_value;
        run->shown.event_count = parts->event_count;
        status = course_make_speeds(parts, v, &run->shown);
    }
    // Add the laws over time.
    for (size_t i = 0; i < sizeof laws / sizeof *laws && status.code == WHIRL_OK; i++)
        if (parts->laws[i])
            status = course_add_formula(run, (whirl_run_formula)i, laws[i], parts->laws[i], names, count);
        else
            status = course_make_table(&parts->tables[i], laws[i], v, run, i);
    // Add the events with their conditions.
    for (size_t i = 0; i < parts->event_count && status.code == WHIRL_OK; i++) {
        const course_event *own = &parts->events[i];
        course_make_event(v, own, machine->stations.count, &run->shown.events[i]);
        if (own->when)
            status =
                course_add_formula(run, WHIRL_FORMULA_EVENT + (whirl_run_formula)i, "when", own->when, names, count);
    }
    for (size_t k = 0; k < parts->shaft_count && status.code == WHIRL_OK; k++)
        for (size_t i = 0; i < WHIRL_SPOOL_FORMULAS && status.code == WHIRL_OK; i++) {
            static const char *const formula_keys[] = {"speed_law", "torque_law", "load_law"};
            const size_t formula = WHIRL_FORMULA_SPOOL + WHIRL_SPOOL_FORMULAS * k + i;
            if (parts->shafts[k].formulas[i])
                status = course_add_formula(run, (whirl_run_formula)formula, formula_keys[i],
                                            parts->shafts[k].formulas[i], names, count);
        }
    free(names);
    free(texts);
    return status;
}

void course_set_rate(course_run *run, double from, double to, double rate) {
    whirl_run_course *own = &run->shown;
    own->speed_count = 2;
    own->speed_times[0] = 0.0;
    own->speed_times[1] = fabs(to - from) / rate;
    own->speeds[0] = from;
    own->speeds[1] = to;
}

whirl_status course_lead(course_run *run, double lead) {
    whirl_run_course *own = &run->shown;
    if (lead == 0.0) return whirl_ok();
    if (own->speed_count == WHIRL_MAX_SPEEDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the speeds of the run have %d rows, expected at most %d", WHIRL_MAX_SPEEDS,
                          WHIRL_MAX_SPEEDS - 1);
    for (size_t i = own->speed_count; i > 0; i--) {
        own->speed_times[i] = own->speed_times[i - 1] + lead;
        own->speeds[i] = own->speeds[i - 1];
    }
    own->speed_times[0] = 0.0;
    own->speed_count++;
    run->lead = lead;
    for (size_t i = 0; i < own->event_count; i++)
        if (own->events[i].after == WHIRL_NO_EVENT) own->events[i].time += lead; // NaN stays
    return whirl_ok();
}

whirl_status course_given(const course_parts *parts, size_t event, valuation *v, whirl_given *given, size_t *count) {
    const condition_parts *change = &parts->events[event].change;
    for (size_t i = 0; i < change->count; i++) {
        whirl_given *own = &given[*count];
        own->name = change->parameters[i]->name;
        const whirl_status status = valuation_number(v, &change->values[i], &own->value);
        if (status.code != WHIRL_OK) return status;
        ++*count;
    }
    return whirl_ok();
}

bool course_check(case_reader *reader, valuation *v, const course_parts *parts) {
    bool good = true;
    for (size_t i = 0; i < parts->event_count; i++) {
        const course_event *own = &parts->events[i];
        if (!own->alone) good = settings_check(reader, v, &own->keys) && good;
        for (size_t k = 0; k < own->change.count; k++) {
            double value;
            good = plan_formula_value(reader, v, own->change.places[k], &own->change.values[k], &value) && good;
        }
    }
    for (size_t k = 0; k < parts->shaft_count; k++)
        if (parts->shafts[k].place) good = settings_check(reader, v, &parts->shafts[k].keys) && good;
    for (size_t i = 0; i <= WHIRL_FORMULA_EVENT + parts->shaft_count; i++) {
        const course_table *own = i < WHIRL_FORMULA_EVENT    ? &parts->tables[i]
                                  : i == WHIRL_FORMULA_EVENT ? &parts->speeds
                                                             : &parts->shafts[i - WHIRL_FORMULA_EVENT - 1].speeds;
        for (size_t k = 0; k < own->count && good; k++) {
            double value;
            good = plan_formula_value(reader, v, own->rows[k].place, &own->rows[k].time, &value);
            good = good && plan_formula_value(reader, v, own->rows[k].place, &own->rows[k].value, &value);
        }
    }
    return good;
}
