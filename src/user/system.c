// Builds a user's system; every call checks its arguments.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "two_pi.h"
#include "user.h"
#include "whirl/engine/case.h"

whirl_status whirl_user_system_new(const char *title, size_t dimension, whirl_user_system **out) {
    *out = NULL;
    if (dimension < 1 || dimension > USER_MAX_STATES)
        return whirl_fail(WHIRL_BAD_INPUT, "a system of %zu coordinates, expected 1 to %d", dimension, USER_MAX_STATES);
    // Allocate.
    whirl_user_system *system = calloc(1, sizeof *system);
    if (system) {
        system->start = calloc(dimension, sizeof *system->start);
        system->failure = calloc(1, sizeof *system->failure);
    }
    if (!system || !system->start || !system->failure) {
        whirl_user_system_free(system);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a system of %zu coordinates", dimension);
    }
    // Set the defaults.
    snprintf(system->title, sizeof system->title, "%s", title ? title : "");
    whirl_make_plain(system->title);
    system->dimension = dimension;
    system->period = two_pi;
    system->speed = USER_MAX_PARAMETERS;
    whirl_members_default(whirl_integrate_members(), &system->integrate);
    system->record = whirl_record_default();
    system->record.settle = true;
    *out = system;
    return whirl_ok();
}

void whirl_user_system_free(whirl_user_system *system) {
    if (!system) return;
    for (size_t i = 0; i < system->axis_count; i++) free(system->axes[i].values);
    free(system->branches.at);
    free(system->identity);
    free(system->start);
    free(system->angles);
    free(system->scales);
    free(system->parameters);
    free(system->events);
    free(system->stations);
    free(system->failure);
    free(system);
}

// ---------------------------------------------------------------- names

static bool is_name(const char *name) {
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", digits[] = "0123456789";
    const size_t length = strlen(name);
    if (length == 0 || length >= WHIRL_NAME_SIZE || !strchr(letters, name[0])) return false;
    for (size_t i = 0; i < length; i++)
        if (!strchr(letters, name[i]) && !strchr(digits, name[i])) return false;
    return true;
}

static size_t find_parameter(const whirl_user_system *system, const char *name) {
    size_t i = 0;
    while (i < system->parameter_count && strcmp(system->parameters[i].name, name) != 0) i++;
    return i;
}

/// Grows a list by one item.
static void *system_grow(void **items, size_t count, size_t size) {
    void *more = realloc(*items, (count + 1) * size);
    if (!more) return NULL;
    *items = more;
    return memset((char *)more + count * size, 0, size);
}

/// Checks that a unit exists and is an SI unit, since values are in SI. WHIRL_BAD_INPUT.
static whirl_status check_unit(const char *name, const char *unit) {
    char one[WHIRL_NAME_SIZE + 8];
    double size;
    if (!unit || !*unit || strcmp(unit, "1") == 0) return whirl_ok();
    const int length = snprintf(one, sizeof one, "1 %s", unit);
    if (length >= (int)sizeof one || whirl_quantity_value(one, "", &size).code != WHIRL_OK)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the unit of %.63s is '%.80s', expected one that UDUNITS knows, such as rad/s", name, unit);
    if (fabs(size - 1.0) <= 1e-12) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "the unit of %.63s is %s, 1 of which is %.10g in SI, expected an SI unit: values are in SI", name,
                      unit, size);
}

whirl_status whirl_user_system_parameter(whirl_user_system *system, const char *name, double value, const char *unit,
                                         const char *text) {
    if (!is_name(name))
        return whirl_fail(WHIRL_BAD_INPUT, "a parameter is called '%.80s', expected letters, digits and _", name);
    if (find_parameter(system, name) < system->parameter_count)
        return whirl_fail(WHIRL_BAD_INPUT, "there are two parameters called %s", name);
    if (!isfinite(value)) return whirl_fail(WHIRL_BAD_INPUT, "%s is %g, expected a finite number", name, value);
    const whirl_status known = check_unit(name, unit);
    if (known.code != WHIRL_OK) return known;
    if (system->parameter_count == USER_MAX_PARAMETERS)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d parameters", USER_MAX_PARAMETERS);
    whirl_parameter *one = system_grow((void **)&system->parameters, system->parameter_count, sizeof *one);
    if (!one) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a parameter");
    system->parameter_count++;
    snprintf(one->name, sizeof one->name, "%s", name);
    snprintf(one->unit, sizeof one->unit, "%s", unit && *unit ? unit : "1");
    snprintf(one->text, sizeof one->text, "%s", text ? text : "");
    whirl_make_plain(one->unit);
    whirl_make_plain(one->text);
    one->value = value;
    return whirl_ok();
}

whirl_status user_require_parameter(const whirl_user_system *system, const char *name, size_t *index) {
    const char *names[USER_MAX_PARAMETERS];
    *index = find_parameter(system, name);
    if (*index < system->parameter_count) return whirl_ok();
    for (size_t i = 0; i < system->parameter_count; i++) names[i] = system->parameters[i].name;
    const char *near = whirl_nearest_name(name, names, system->parameter_count);
    return whirl_fail(WHIRL_BAD_INPUT, "there is no parameter %.63s%s%s%s", name, near ? ", did you mean " : "",
                      near ? near : "", near ? "?" : "");
}

// ---------------------------------------------------------------- equations

static whirl_status check_index(const whirl_user_system *system, size_t index) {
    if (index < system->dimension) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "there is no coordinate %zu, expected 0 to %zu", index, system->dimension - 1);
}

whirl_status whirl_user_system_start(whirl_user_system *system, size_t index, double value) {
    const whirl_status status = check_index(system, index);
    if (status.code != WHIRL_OK) return status;
    if (!isfinite(value))
        return whirl_fail(WHIRL_BAD_INPUT, "coordinate %zu starts from %g, expected a finite number", index, value);
    system->start[index] = value;
    return whirl_ok();
}

whirl_status whirl_user_system_angle(whirl_user_system *system, size_t index, double period) {
    const whirl_status status = check_index(system, index);
    if (status.code != WHIRL_OK) return status;
    if (!(period > 0.0) || !isfinite(period))
        return whirl_fail(WHIRL_BAD_INPUT, "a turn of coordinate %zu is %g, expected a number above 0", index, period);
    if (!system->angles) system->angles = calloc(system->dimension, sizeof *system->angles);
    if (!system->angles) return whirl_fail(WHIRL_NO_MEMORY, "no memory for angles");
    system->angles[index] = period;
    return whirl_ok();
}

whirl_status whirl_user_system_scale(whirl_user_system *system, size_t index, double scale) {
    const whirl_status status = check_index(system, index);
    if (status.code != WHIRL_OK) return status;
    if (!(scale > 0.0) || !isfinite(scale))
        return whirl_fail(WHIRL_BAD_INPUT, "the scale of coordinate %zu is %g, expected a number above 0", index,
                          scale);
    if (!system->scales) system->scales = calloc(system->dimension, sizeof *system->scales);
    if (!system->scales) return whirl_fail(WHIRL_NO_MEMORY, "no memory for scales");
    system->scales[index] = scale;
    return whirl_ok();
}

whirl_status whirl_user_system_station(whirl_user_system *system, const char *name, size_t x, size_t y, size_t vx,
                                       size_t vy) {
    const size_t indices[] = {x, y, vx, vy};
    for (size_t i = 0; i < 4; i++) {
        const whirl_status status = check_index(system, indices[i]);
        if (status.code != WHIRL_OK) return status;
    }
    if (!is_name(name))
        return whirl_fail(WHIRL_BAD_INPUT, "a station is called '%.80s', expected letters, digits and _", name);
    for (size_t i = 0; i < system->station_count; i++)
        if (strcmp(system->stations[i].name, name) == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "there are two stations called %s", name);
    if (system->station_count == WHIRL_MAX_PROBES)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d stations", WHIRL_MAX_PROBES);
    whirl_probe *one = system_grow((void **)&system->stations, system->station_count, sizeof *one);
    if (!one) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a station");
    system->station_count++;
    *one = (whirl_probe){.x = x, .y = y, .vx = vx, .vy = vy};
    snprintf(one->name, sizeof one->name, "%s", name);
    return whirl_ok();
}

whirl_status whirl_user_system_oscillates(whirl_user_system *system, size_t displacements) {
    if (2 * displacements > system->dimension)
        return whirl_fail(WHIRL_BAD_INPUT, "%zu displacements with as many velocities, expected at most %zu of both",
                          displacements, system->dimension);
    system->displacements = displacements;
    return whirl_ok();
}

whirl_status whirl_user_system_rates(whirl_user_system *system, whirl_user_rates_fn rates, void *context) {
    system->rates = rates;
    system->lanes = NULL;
    system->context = context;
    return whirl_ok();
}

whirl_status whirl_user_system_lanes(whirl_user_system *system, whirl_user_lanes_fn rates, void *context) {
    system->lanes = rates;
    system->rates = NULL;
    system->context = context;
    return whirl_ok();
}

whirl_status whirl_user_system_tangent(whirl_user_system *system, whirl_user_tangent_fn tangent, void *context) {
    system->tangent = tangent;
    system->tangent_context = context;
    return whirl_ok();
}

whirl_status whirl_user_system_period(whirl_user_system *system, double period) {
    if (!(period > 0.0) || !isfinite(period))
        return whirl_fail(WHIRL_BAD_INPUT, "the period is %g, expected a number above 0", period);
    system->period = period;
    system->speed = USER_MAX_PARAMETERS;
    return whirl_ok();
}

whirl_status whirl_user_system_speed(whirl_user_system *system, const char *parameter) {
    size_t index;
    const whirl_status status = user_require_parameter(system, parameter, &index);
    if (status.code == WHIRL_OK) system->speed = index;
    return status;
}

whirl_status whirl_user_system_kinked(whirl_user_system *system) {
    system->kinked = true;
    return whirl_ok();
}

whirl_status user_period(const whirl_user_system *system, const double *parameters, double *period) {
    *period = system->speed < system->parameter_count ? two_pi / parameters[system->speed] : system->period;
    if (*period > 0.0 && isfinite(*period)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "%s is %g, expected an angular frequency above 0",
                      system->parameters[system->speed].name, parameters[system->speed]);
}

// ---------------------------------------------------------------- the study

whirl_status whirl_user_system_vary(whirl_user_system *system, const char *parameter, const double *values,
                                    size_t count) {
    size_t index;
    // Check the parameter and its values.
    const whirl_status status = user_require_parameter(system, parameter, &index);
    if (status.code != WHIRL_OK) return status;
    if (system->axis_count == USER_AXES)
        return whirl_fail(WHIRL_BAD_INPUT, "%s is a fourth parameter that varies, expected at most three", parameter);
    for (size_t i = 0; i < system->axis_count; i++)
        if (system->axes[i].parameter == index)
            return whirl_fail(WHIRL_BAD_INPUT, "%s varies already, expected another parameter", parameter);
    if (count == 0) return whirl_fail(WHIRL_BAD_INPUT, "%s varies over no values", parameter);
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i]))
            return whirl_fail(WHIRL_BAD_INPUT, "value %zu of %s is %g, expected a finite number", i + 1, parameter,
                              values[i]);
        if (i > 0 && !((values[i] - values[i - 1]) * (values[1] - values[0]) > 0.0))
            return whirl_fail(WHIRL_BAD_INPUT, "%s is %g after %g, expected values that rise or fall throughout",
                              parameter, values[i], values[i - 1]);
    }
    // Copy the values.
    double *copy = malloc(count * sizeof *copy);
    if (!copy) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu values", count);
    memcpy(copy, values, count * sizeof *copy);
    system->axes[system->axis_count++] = (user_axis){.parameter = index, .count = count, .values = copy};
    return whirl_ok();
}

whirl_status whirl_user_system_analyze(whirl_user_system *system, const char *analysis) {
    const char *names[64];
    size_t count = 0;
    whirl_analysis_set chosen = system->analyses;
    for (const whirl_analysis *one = whirl_analyses(); one->name && count < 64; one++) names[count++] = one->name;
    if (!whirl_analysis_add(&chosen, analysis)) {
        const char *near = whirl_nearest_name(analysis, names, count);
        return whirl_fail(WHIRL_BAD_INPUT, "there is no analysis %.63s%s%s%s", analysis, near ? ", did you mean " : "",
                          near ? near : "", near ? "?" : "");
    }
    if (!whirl_analysis_kind(chosen)->moves)
        return whirl_fail(WHIRL_BAD_INPUT, "%s is not for custom systems, expected an analysis of motions", analysis);
    system->analyses = chosen;
    return whirl_ok();
}

/// Sets a member of options by the text that it would have in a case.
static whirl_status system_set(const whirl_member *member, void *object, const char *value) {
    const bool words = member->type == WHIRL_MEMBER_WORD || member->type == WHIRL_MEMBER_FLAG;
    if (words && member->key.choices && *member->key.choices && whirl_key_choice(&member->key, value) < 0)
        return whirl_fail(WHIRL_BAD_INPUT, "%s is '%.63s', expected one of %s", member->name, value,
                          member->key.choices);
    if (words) {
        whirl_member_say(member, object, value);
        return whirl_ok();
    }
    char *end;
    const double number = strtod(value, &end);
    if (end == value || *end != '\0')
        return whirl_fail(WHIRL_BAD_INPUT, "%s is '%.63s', expected a number", member->name, value);
    const whirl_status status = whirl_key_check_number(&member->key, number);
    if (status.code != WHIRL_OK) return whirl_fail(status.code, "%s %s", member->name, status.message);
    whirl_member_set(member, object, number);
    return status;
}

static whirl_status set_carry(whirl_user_system *system, const char *value) {
    static const char *const words[] = {"no", "up", "down", "both"};
    static const whirl_carry carries[] = {WHIRL_CARRY_NONE, WHIRL_CARRY_FORWARD, WHIRL_CARRY_REVERSE, WHIRL_CARRY_BOTH};
    for (size_t i = 0; i < 4; i++)
        if (strcmp(words[i], value) == 0) {
            system->carry = carries[i];
            return whirl_ok();
        }
    return whirl_fail(WHIRL_BAD_INPUT, "carry is '%.63s', expected one of no, up, down, both", value);
}

whirl_status whirl_user_system_set(whirl_user_system *system, const char *option, const char *value) {
    const struct {
        const whirl_member *members;
        void *object;
    } groups[] = {{whirl_integrate_members(), &system->integrate},
                  {whirl_record_members(), &system->record},
                  {whirl_trace_members(), &system->record.trace},
                  {whirl_batch_members(), &system->options}};
    const char *names[128] = {"carry"};
    size_t count = 1;
    if (strcmp(option, "carry") == 0) return set_carry(system, value);
    for (size_t g = 0; g < sizeof groups / sizeof *groups; g++) {
        const whirl_member *found = whirl_member_find(groups[g].members, option);
        if (found && *found->part) return system_set(found, groups[g].object, value);
        for (const whirl_member *one = groups[g].members; one->part && count < 128; one++)
            if (one->name && *one->part) names[count++] = one->name;
    }
    const char *near = whirl_nearest_name(option, names, count);
    return whirl_fail(WHIRL_BAD_INPUT, "there is no option %.63s%s%s%s", option, near ? ", did you mean " : "",
                      near ? near : "", near ? "?" : "");
}
