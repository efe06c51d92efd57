// Tables of measured numbers: their headings, and their rows as numbers of motions.
#include "fit_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit_list.h"
#include "fit_record.h"
#include "fit_run.h"
#include "fit_speed.h"
#include "input.h"
#include "problem.h"
#include "tree.h"
#include "two_pi.h"
#include "whirl/internal/arrays.h"
#include "whirl/signals.h"

enum { FIT_INSTANTS = 64, FIT_MAX_ORDER = 64, FIT_PATH = 4096 };

/// Largest accepted distance of a measured angle from the nearest instant of the motion, as a share of the distance
/// between instants.
#define FIT_OFF_INSTANT 1e-3

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

/// Reads the order of a column, "2X", at the end of a heading, if there is one; `word` becomes the word before it.
static whirl_status fit_read_order(fit_maker *m, size_t column, char *text, char **word) {
    fit_column *own = &m->columns[column];
    char *end;
    if (!*word || !**word || (*word)[strlen(*word) - 1] != 'X') return whirl_ok();
    own->order = strtod(*word, &end);
    if (end == *word || strcmp(end, "X") != 0 || !(own->order > 0.0 && own->order <= FIT_MAX_ORDER))
        return FIT_FAIL(m, column, "'%.20s' is no order, expected 1X, 2X, 0.5X", *word);
    if (m->run && (own->order != round(own->order) || own->order > WHIRL_MAX_FIT_RUN_ORDER))
        return FIT_FAIL(m, column, "order %.20s is not among those of a run, expected 1X to %dX", *word,
                        WHIRL_MAX_FIT_RUN_ORDER);
    if (!m->statistics && !m->run && m->revolutions > 0 &&
        fabs(own->order * m->revolutions - round(own->order * m->revolutions)) > 1e-9)
        return FIT_FAIL(m, column, "order %.20s does not occur in a motion of %d revolution%s", *word, m->revolutions,
                        m->revolutions == 1 ? "" : "s");
    *word = fit_last_word(text);
    return whirl_ok();
}

/// Reads the end of a heading that is neither station nor direction: "lag", "2X", "2X lag", "max", "min".
static whirl_status fit_read_kind(fit_maker *m, size_t column, char *text, char **word) {
    fit_column *own = &m->columns[column];
    const bool highest = *word && strcmp(*word, "max") == 0, lowest = *word && strcmp(*word, "min") == 0;
    own->quantity = m->statistics ? WHIRL_FIT_LINE : WHIRL_FIT_AMPLITUDE;
    if (highest || lowest) {
        if (!m->statistics)
            return FIT_FAIL(m, column, "'%.40s' is a statistic, expected compare: statistics at this table",
                            m->table.columns[column].name);
        own->quantity = highest ? WHIRL_FIT_HIGHEST : WHIRL_FIT_LOWEST;
        *word = fit_last_word(text);
        return whirl_ok();
    }
    if (*word && strcmp(*word, "lag") == 0) {
        if (m->statistics)
            return FIT_FAIL(m, column,
                            "'%.40s' is a lag, which statistics do not have, expected amplitudes of lines alone",
                            m->table.columns[column].name);
        own->kind = FIT_LAG;
        *word = fit_last_word(text);
    }
    return fit_read_order(m, column, text, word);
}

/// Understands the heading of a probe: "disc x", "disc 45", "disc x 2X", "disc x lag", "disc x 2X lag", "disc x max".
static whirl_status fit_probe_heading(fit_maker *m, size_t column, bool vectors) {
    char text[CSV_TEXT], advice[WHY_SIZE], *end;
    fit_column *own = &m->columns[column];
    const named_list *stations = &m->parts->machine->stations;
    memcpy(text, m->table.columns[column].name, sizeof text);
    // Variables of MATLAB have no blanks: "disc_x_lag".
    for (char *at = text; m->table.vectors && !strchr(m->table.columns[column].name, ' ') && *at; at++)
        if (*at == '_') *at = ' ';
    *own = (fit_column){.kind = FIT_DISPLACEMENT, .order = 1.0, .lag = column, .noise = m->noise};
    // Recognize the share of the time in contact.
    if (strcmp(text, "contact") == 0) {
        own->quantity = WHIRL_FIT_SHARE;
        own->size = 1.0;
        if (m->statistics && m->noise > 0.0)
            return FIT_FAIL(m, column, "'contact' has no noise in the case, expected noise: {contact: 1 %%, ...}");
        if (m->statistics && *m->table.columns[column].unit) return csv_unit(&m->table, column, "1", "%", &own->size);
        if (m->statistics) return whirl_ok();
        return FIT_FAIL(m, column, "'contact' is a statistic, expected compare: statistics at this table");
    }
    char *word = fit_last_word(text);
    const whirl_status status = fit_read_kind(m, column, text, &word);
    if (status.code != WHIRL_OK) return status;
    if (!vectors && (own->kind == FIT_LAG || strcmp(m->table.columns[column].name + strlen(text), "") == 0))
        return FIT_FAIL(
            m, column, "'%.40s' is no column of displacements over the angle or the time, expected 'disc x', 'disc 45'",
            m->table.columns[column].name);
    // Read the direction, and find the station.
    if (!word)
        return FIT_FAIL(
            m, column,
            "'%.40s' is no column, expected angle, time, speed, a parameter, or a station and the direction of a "
            "probe: 'disc x', 'disc 45'",
            m->table.columns[column].name);
    const bool axis = strcmp(word, "x") == 0 || strcmp(word, "y") == 0;
    own->direction = axis ? (*word == 'y' ? 90.0 : 0.0) : strtod(word, &end);
    if (!axis && (end == word || *end || !isfinite(own->direction)))
        return FIT_FAIL(m, column, "'%.20s' is no direction of a probe, expected x, y or degrees from x", word);
    own->direction *= two_pi / 360.0;
    own->station = named_find(stations, text);
    if (own->station == stations->count) {
        memcpy(text, m->table.columns[column].name, strlen(text)); // stations may have such names
        own->station = named_find(stations, text);
    }
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
    // Recognize the time, of a motion at one speed.
    if (strcmp(heading->name, "time") == 0) {
        own->kind = FIT_TIME;
        return csv_unit(&m->table, column, "s", "s", &own->size);
    }
    // Recognize the pulses of the mark.
    if (strcmp(heading->name, "keyphasor") == 0) {
        own->kind = FIT_KEYPHASOR;
        if (vectors || m->run)
            return FIT_FAIL(m, column,
                            "is a keyphasor, expected displacements over the time of a motion at one speed%s",
                            m->run ? "; in a run the key angle of runup says where the mark is" : "");
        return whirl_ok();
    }
    // Recognize the speed.
    if (strcmp(heading->name, "speed") == 0) {
        own->kind = FIT_SPEED;
        return csv_unit(&m->table, column, "rad/s", "rpm", &own->size);
    }
    // Recognize a parameter, or else a probe.
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

/// Assigns each column of lags to the column of its amplitude. Fails for a lag without an amplitude.
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
        if (of == m->table.column_count)
            return FIT_FAIL(m, c, "is a lag without its amplitude, expected a column of the amplitude, too");
        m->columns[of].lag = c;
    }
    return whirl_ok();
}

static double fit_cell(const fit_maker *m, size_t column, size_t row) {
    return m->columns[column].size * csv_numbers(&m->table, column)[row];
}

static whirl_status fit_add_motion(fit_maker *m, size_t given_count, const whirl_given *given, double speed,
                                   size_t instants) {
    const whirl_fit_motion motion = {
        .given_count = given_count, .given = given, .speed = speed, .run = m->run, .instants = instants};
    const whirl_status status = fit_list_motion(m, &motion);
    return status.code == WHIRL_BAD_INPUT ? whirl_fail(status.code, "%.150s: %.100s", m->table.path, status.message)
                                          : status;
}

static whirl_status fit_add_number(fit_maker *m, const fit_column *column, whirl_fit_quantity what, double at,
                                   double value) {
    const whirl_fit_number number = {.set = m->set,
                                     .station = column->station,
                                     .angle = column->direction,
                                     .quantity = what,
                                     .at = at,
                                     .value = value,
                                     .noise = column->noise};
    const whirl_status status = fit_list_number(m, &number);
    return status.code == WHIRL_BAD_INPUT ? whirl_fail(status.code, "%.150s: %.100s", m->table.path, status.message)
                                          : status;
}

/// Adds the displacements over the angle of one motion.
static whirl_status fit_take_samples(fit_maker *m, size_t angle) {
    const csv_table *table = &m->table;
    if (table->count < 2)
        return FIT_FAIL(m, angle, "there is %zu row, expected some instants of a revolution", table->count);
    // The distance of instants must be a revolution over a whole number.
    const double apart = fit_cell(m, angle, 1) - fit_cell(m, angle, 0);
    const double instants = round(1.0 / apart);
    if (!(instants >= 4.0 && instants <= 65536.0) || fabs(instants * apart - 1.0) > FIT_OFF_INSTANT)
        return csv_fail(table, table->lines[1], table->columns[angle].place,
                        "the angle is %g revolutions after the one before, expected one over a whole number", apart);
    whirl_status status = fit_add_motion(m, m->at_count, m->at, 0.0, (size_t)instants);
    for (size_t i = 0; i < table->count && status.code == WHIRL_OK; i++) {
        const double place = instants * fit_cell(m, angle, i), nearest = round(place);
        if (fabs(place - nearest) > FIT_OFF_INSTANT * (1.0 + 0.1 * (double)i) || nearest < 0.0)
            return csv_fail(table, table->lines[i], table->columns[angle].place,
                            "%g revolutions is not one of the instants k/%g", fit_cell(m, angle, i), instants);
        const double turn = (m->revolutions > 0 ? fmod(nearest, instants * m->revolutions) : nearest) / instants;
        for (size_t c = 0; c < table->column_count && status.code == WHIRL_OK; c++)
            if (m->columns[c].kind == FIT_DISPLACEMENT)
                status = fit_add_number(m, &m->columns[c], WHIRL_FIT_SAMPLE, turn, fit_cell(m, c, i));
    }
    return status;
}

/// Fails for a time of a run's waveform before that of the row before it, or before the run.
static whirl_status fit_check_time(const fit_maker *m, const fit_set *set, size_t time, size_t row) {
    const csv_table *table = &m->table;
    const double *shown = csv_numbers(table, time);
    if (row > 0 && !(shown[row] > shown[row - 1]))
        return csv_fail(table, table->lines[row], table->columns[time].place,
                        "the time is %.10g after %.10g, expected times that rise", shown[row], shown[row - 1]);
    if (shown[row] < 0.0 && !settings_find(&set->keys, "delay"))
        return csv_fail(table, table->lines[row], table->columns[time].place,
                        "the time is %g, expected 0 or more, from the beginning of the run, or delay, the time at "
                        "which it begins",
                        shown[row]);
    return whirl_ok();
}

/// Finds the first pulse of the keyphasor of a waveform, s, if it has one: the mark is at the x axis then. Outside of a
/// fit, the speed of the motion is the mean speed over all pulses.
static whirl_status fit_find_mark(fit_maker *m, size_t time, double *first) {
    const csv_table *table = &m->table;
    size_t column = 0, pulses = 0;
    *first = 0.0;
    while (column < table->column_count && m->columns[column].kind != FIT_KEYPHASOR) column++;
    if (column == table->column_count) return whirl_ok();
    double *times = malloc((table->count + table->count / 2 + 2) * sizeof *times), threshold, hysteresis;
    if (!times) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a keyphasor");
    double *instants = times + table->count;
    for (size_t i = 0; i < table->count; i++) times[i] = fit_cell(m, time, i);
    const double *voltage = csv_numbers(table, column);
    whirl_status status = whirl_signals_threshold(voltage, table->count, &threshold, &hysteresis);
    if (status.code == WHIRL_OK)
        status = whirl_signals_pulses(times, voltage, table->count, threshold, hysteresis, true, instants, &pulses);
    if (status.code == WHIRL_OK && pulses < 2)
        status = whirl_fail(WHIRL_BAD_INPUT, "it has %zu pulse%s, expected at least 2", pulses, pulses == 1 ? "" : "s");
    if (status.code == WHIRL_OK) {
        *first = instants[0];
        if (m->revolutions == 0) m->speed = two_pi * (double)(pulses - 1) / (instants[pulses - 1] - instants[0]);
    }
    free(times);
    return status.code == WHIRL_BAD_INPUT ? FIT_FAIL(m, column, "%.200s", status.message) : status;
}

/// Adds the displacements over the time of one motion.
static whirl_status fit_take_waveform(fit_maker *m, const fit_set *set, size_t time) {
    enum { INSTANTS = 256 };
    double mark;
    whirl_status status = fit_find_mark(m, time, &mark);
    if (status.code == WHIRL_OK) status = fit_add_motion(m, m->at_count, m->at, m->run ? 0.0 : m->speed, INSTANTS);
    if (status.code == WHIRL_OK && m->run) m->run->count = 1;
    for (size_t i = 0; i < m->table.count && status.code == WHIRL_OK; i++) {
        if (m->run) status = fit_check_time(m, set, time, i);
        for (size_t c = 0; c < m->table.column_count && status.code == WHIRL_OK; c++)
            if (m->columns[c].kind == FIT_DISPLACEMENT)
                status = fit_add_number(m, &m->columns[c], WHIRL_FIT_WAVEFORM, fit_cell(m, time, i) - mark,
                                        fit_cell(m, c, i));
    }
    return status;
}

/// Adds the numbers of one row: an amplitude, or, if it has a lag, its cosine and sine part.
static whirl_status fit_take_row(fit_maker *m, size_t row) {
    whirl_status status = whirl_ok();
    for (size_t c = 0; c < m->table.column_count && status.code == WHIRL_OK; c++) {
        const fit_column *own = &m->columns[c];
        if (own->kind != FIT_DISPLACEMENT) continue;
        const double amplitude = fit_cell(m, c, row);
        const bool size = own->quantity == WHIRL_FIT_AMPLITUDE || own->quantity == WHIRL_FIT_LINE;
        if (own->quantity == WHIRL_FIT_SHARE && !(amplitude >= 0.0 && amplitude <= 1.0))
            return csv_fail(&m->table, m->table.lines[row], m->table.columns[c].place,
                            "the share of the time in contact is %g, expected 0 to 1", amplitude);
        if (size && amplitude < 0.0)
            return csv_fail(&m->table, m->table.lines[row], m->table.columns[c].place,
                            "the amplitude is %g, expected 0 or more%s", csv_numbers(&m->table, c)[row],
                            m->run ? ", or compare: waveform for displacements" : "");
        if (own->lag == c) {
            status = fit_add_number(m, own, own->quantity, own->order, amplitude);
            continue;
        }
        const double lag = fit_cell(m, own->lag, row);
        status = fit_add_number(m, own, WHIRL_FIT_COS, own->order, amplitude * cos(lag));
        if (status.code == WHIRL_OK) status = fit_add_number(m, own, WHIRL_FIT_SIN, own->order, amplitude * sin(lag));
    }
    return status;
}

/// Fails for a row of a run that its speed, rad/s, or its time, s, does not allow.
static whirl_status fit_check_row(const fit_maker *m, size_t along, size_t row, double value) {
    const csv_table *table = &m->table;
    const int line = table->lines[row], place = table->columns[along].place;
    double ends[2];
    if (m->run->by_time && !(value >= 0.0) && !m->run->delayed)
        return csv_fail(table, line, place, "the time is %g, expected 0 or more, from the beginning of the run",
                        csv_numbers(table, along)[row]);
    if (!m->run->by_time && !fit_run_reaches(m->run, value, ends))
        return csv_fail(table, line, place, "the speed is %g rad/s, expected one of the run, %g to %g rad/s", value,
                        ends[0], ends[1]);
    return whirl_ok();
}

/// Adds orders over the speed or a parameter: every row is one motion.
static whirl_status fit_take_vectors(fit_maker *m, size_t along) {
    const fit_column *axis = &m->columns[along];
    double highest = 1.0;
    for (size_t c = 0; c < m->table.column_count; c++)
        if (m->columns[c].kind == FIT_DISPLACEMENT) highest = fmax(highest, m->columns[c].order);
    const size_t instants = (m->statistics ? 2u : 1u) * (size_t)FIT_INSTANTS * (size_t)ceil(highest / 4.0);
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < m->table.count && status.code == WHIRL_OK; i++) {
        const double value = fit_cell(m, along, i);
        const whirl_status good = m->run ? fit_check_row(m, along, i, value) : whirl_ok();
        if (good.code != WHIRL_OK) return good;
        if (axis->kind == FIT_SPEED && !(value > 0.0))
            return csv_fail(&m->table, m->table.lines[i], m->table.columns[along].place,
                            "the speed is %g, expected a number above 0", csv_numbers(&m->table, along)[i]);
        whirl_given *given = arena_take(m->reader->arena, (m->at_count + 1) * sizeof *given);
        if (!given) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
        for (size_t k = 0; k < m->at_count; k++) given[k] = m->at[k];
        const bool varies = axis->parameter != NULL;
        if (varies) given[m->at_count] = (whirl_given){axis->parameter->name, value};
        const bool timed = axis->kind == FIT_TIME;
        status = fit_add_motion(m, m->at_count + varies, given, varies || timed ? 0.0 : value, instants);
        if (status.code == WHIRL_OK) m->motions[m->fit.motion_count - 1].statistics = m->statistics;
        if (status.code == WHIRL_OK && timed) m->motions[m->fit.motion_count - 1].time = value;
        if (status.code == WHIRL_OK && m->run) m->run->count++;
        if (status.code == WHIRL_OK) status = fit_take_row(m, i);
    }
    return status;
}

/// Fails at a place of the case.
static whirl_status fit_fail_at(const fit_maker *m, const file_node *where, const char *sentence) {
    char text[WHIRL_MESSAGE_SIZE] = "";
    whirl_problems one = {.count = 0};
    memcpy(one.file, m->reader->problems->file, sizeof one.file);
    problem_at(&one, where, "%s", sentence);
    if (one.count > 0) whirl_problem_text(&one, 0, text, sizeof text);
    whirl_problems_free(&one);
    return *text ? whirl_fail(WHIRL_BAD_INPUT, "%s", text) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
}

/// Sets the noise of columns that have a channel in the case. The channel's name is the heading of the column without
/// its unit.
static whirl_status fit_share_noise(fit_maker *m, const fit_set *set) {
    char sentence[WHIRL_MESSAGE_SIZE];
    for (size_t k = 0; k < set->channel_count; k++) {
        bool found = false;
        for (size_t c = 0; c < m->table.column_count; c++) {
            if (m->columns[c].kind != FIT_DISPLACEMENT ||
                strcmp(m->table.columns[c].name, set->channels[k].place->key) != 0)
                continue;
            m->columns[c].noise = m->channel_noise[k];
            found = true;
        }
        if (found) continue;
        snprintf(sentence, sizeof sentence, "is no probe of %.100s", m->table.path);
        return fit_fail_at(m, set->channels[k].place, sentence);
    }
    for (size_t c = 0; c < m->table.column_count && set->channel_count > 0; c++)
        if (m->columns[c].kind == FIT_DISPLACEMENT && !(m->columns[c].noise > 0.0))
            return FIT_FAIL(m, c, "'%.40s' has no noise in the case, expected the standard deviation of all probes",
                            m->table.columns[c].name);
    return whirl_ok();
}

/// Takes the numbers of a table that was read.
static whirl_status fit_take_table(fit_maker *m, const fit_set *set) {
    // Find the column over which the others were measured.
    const csv_table *table = &m->table;
    size_t along = table->column_count;
    bool any = false;
    if (table->count == 0)
        return csv_fail(table, 1, 1, "there is no row of numbers, expected a line of headings and some");
    for (size_t c = 0; c < table->column_count; c++) {
        const char *name = table->columns[c].name;
        const bool axis = strcmp(name, "angle") == 0 || strcmp(name, "turns") == 0 || strcmp(name, "time") == 0 ||
                          strcmp(name, "speed") == 0 ||
                          parameters_find(m->reader->parameters, name) < m->reader->parameters->count;
        if (axis && along < table->column_count)
            return FIT_FAIL(m, c,
                            "is a second column without a probe, expected one of angle, time, speed, or a parameter");
        if (axis) along = c;
    }
    if (along == table->column_count)
        return csv_fail(table, table->heading, 1,
                        "there is no column 'angle [deg]', 'time [s]', 'speed [rpm]' or of a parameter");
    // Over angles or times there are samples, over speeds or parameters vectors.
    const char *axis = table->columns[along].name;
    const bool timed = strcmp(axis, "time") == 0;
    whirl_status status = whirl_ok();
    m->run = NULL;
    if (set->runup && !timed && strcmp(axis, "speed") != 0)
        return FIT_FAIL(m, along, "is no column of a run, expected speed or time");
    if (set->runup) status = fit_run_make(m, set, &m->run);
    if (status.code != WHIRL_OK) return status;
    if (m->run) m->run->by_time = timed;
    if (m->run && m->run->waveform && !timed)
        return FIT_FAIL(m, along, "is no column of a run's waveform, expected time");
    if (m->run && m->run->delayed && !timed)
        return fit_fail_at(m, settings_find(&set->keys, "delay")->place,
                           "is given for a table over the speed, expected one over the time");
    const bool waveform = timed && (!m->run || m->run->waveform);
    const bool vectors = !waveform && strcmp(axis, "angle") != 0 && strcmp(axis, "turns") != 0;
    m->statistics = set->place && strcmp(settings_word(&set->keys, "compare"), "statistics") == 0;
    if (m->statistics && !vectors)
        return FIT_FAIL(m, along,
                        "is a column of instants, which statistics do not have, expected largest and smallest "
                        "displacements, lines and contact over the speed or a parameter");
    // Understand all headings.
    for (size_t c = 0; c < table->column_count && status.code == WHIRL_OK; c++) {
        status = fit_heading(m, c, vectors);
        any = any || m->columns[c].kind == FIT_DISPLACEMENT;
    }
    if (status.code == WHIRL_OK) status = fit_join_lags(m);
    if (status.code == WHIRL_OK && !any)
        return csv_fail(table, table->heading, 1, "there is no probe, expected columns such as 'disc x [um]'");
    if (status.code == WHIRL_OK) status = fit_share_noise(m, set);
    if (status.code != WHIRL_OK) return status;
    // Take the numbers.
    if (waveform) return fit_take_waveform(m, set, along);
    if (m->columns[along].kind == FIT_SPEED && m->revolutions > 0 && !m->run)
        m->columns[along].parameter = fit_speed_parameter(m->reader, m->parts, set);
    return vectors ? fit_take_vectors(m, along) : fit_take_samples(m, along);
}

/// Reads the columns of a measured file that the case chooses.
static whirl_status fit_read_chosen(fit_maker *m, const fit_set *set, const char *path) {
    csv_chosen chosen[FIT_MAX_COLUMNS];
    size_t count = 0;
    for (const file_node *one = set->columns->first; one; one = one->next)
        chosen[count++] = (csv_chosen){one->key, one->text};
    return csv_load_chosen(path, chosen, count, FIT_MAX_COLUMNS, &m->table);
}

whirl_status fit_table_read(fit_maker *m, const fit_set *set) {
    char sentence[WHIRL_MESSAGE_SIZE];
    const char *name = set->file && set->file->kind == NODE_TEXT ? set->file->text : "";
    const setting *record = settings_find(&set->keys, "record");
    char *path = arena_take(m->reader->arena, FIT_PATH);
    if (!path) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    if (!input_path_from(m->reader->problems->file, name, path, FIT_PATH)) {
        snprintf(sentence, sizeof sentence, "%.100s is too long for the path of a table", name);
        return fit_fail_at(m, set->file, sentence);
    }
    const bool arrays = arrays_is_file(path) || csv_is_measured(name);
    whirl_status status;
    if (arrays && record) {
        status = fit_record_read(m, set, path, (size_t)settings_number(m->v, &set->keys, "record"));
    } else if (set->columns) {
        status = fit_read_chosen(m, set, path);
    } else if (arrays) {
        status = csv_load_vectors(path, NULL, 0, FIT_MAX_COLUMNS, &m->table);
    } else {
        status = csv_load(path, FIT_MAX_COLUMNS, &m->table);
        if (status.code == WHIRL_OK && record)
            status = fit_fail_at(m, record->place,
                                 "is given for a table of comma-separated values, expected a file in HDF5");
    }
    // A file that is not there has no places: the error is at its name in the case.
    if ((status.code == WHIRL_BAD_INPUT || status.code == WHIRL_IO_ERROR) && m->table.column_count == 0 &&
        strncmp(status.message, "cannot read", 11) == 0) {
        snprintf(sentence, sizeof sentence, "%s", status.message);
        status = fit_fail_at(m, set->file, sentence);
    }
    if (status.code == WHIRL_OK) status = fit_take_table(m, set);
    csv_free(&m->table);
    return status;
}

whirl_status fit_bytes_read(fit_maker *m, const char *name, const void *bytes, size_t size, const csv_chosen *chosen,
                            size_t count) {
    static const fit_set alone = {.place = NULL}; // without noise
    whirl_status status = csv_read_chosen(name, bytes, size, chosen, count, FIT_MAX_COLUMNS, &m->table);
    if (status.code == WHIRL_OK) status = fit_take_table(m, &alone);
    return status;
}
