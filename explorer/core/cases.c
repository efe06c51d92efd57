// Cases, and their descriptions for the page.
#include "core.h"
#include "pieces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/version.h"

static text message, answer;

EXPORTED const char *explorer_message(void) {
    return text_bytes(&message);
}

static void begin_message(const char *sentence) {
    text_clear(&message);
    text_add(&message, "{");
    json_name(&message, "message");
    json_text(&message, sentence);
    json_name(&message, "problems");
    text_add(&message, "[");
}

bool explorer_good(const whirl_status *status) {
    if (status->code == WHIRL_OK) return true;
    begin_message(status->message);
    text_add(&message, "]}");
    return false;
}

static void add_problem(const whirl_problem *problem) {
    json_next(&message);
    text_add(&message, "{\"line\":%d,\"column\":%d", problem->line, problem->column);
    json_name(&message, "key");
    json_text(&message, problem->key);
    json_name(&message, "message");
    json_text(&message, problem->message);
    text_add(&message, "}");
}

EXPORTED whirl_case *explorer_case_new(const char *source, size_t length, const char *name) {
    whirl_problems problems = {0};
    whirl_case *object;
    const whirl_status status = whirl_case_parse(source, length, name, &problems, &object);
    if (status.code != WHIRL_OK) {
        begin_message(status.message);
        for (size_t i = 0; problems.items && i < problems.count; i++) add_problem(&problems.items[i]);
        text_add(&message, "]}");
    }
    whirl_problems_free(&problems);
    return object;
}

EXPORTED void explorer_case_free(whirl_case *object) {
    whirl_case_free(object);
}

EXPORTED int explorer_assign(whirl_case *object, const char *assignment) {
    const whirl_status status = whirl_case_assign(object, assignment);
    return explorer_good(&status);
}

EXPORTED const char *explorer_case_text(const whirl_case *object) {
    size_t length;
    const char *source = whirl_case_text(object, &length);
    text_clear(&answer);
    text_add(&answer, "%.*s", (int)length, source);
    return text_bytes(&answer);
}

// ---------------------------------------------------------------- describing

/// Writes every member that has a name as a number or a text; null for numbers that are not finite.
static void add_members(text *t, const whirl_member *member, const void *from) {
    char word[WHIRL_NAME_SIZE];
    for (; member->part; member++) {
        if (!member->name) continue;
        json_name(t, member->name);
        whirl_member_text(member, from, word);
        if (member->type == WHIRL_MEMBER_WORD)
            json_text(t, word);
        else
            text_add(t, "%s", isfinite(whirl_member_number(member, from)) ? word : "null");
    }
}

void add_stations(text *t, const whirl_probe *stations, size_t count) {
    json_name(t, "stations");
    text_add(t, "[");
    for (size_t i = 0; i < count; i++) {
        json_next(t);
        text_add(t, "{");
        json_name(t, "name");
        json_text(t, stations[i].name);
        add_members(t, whirl_probe_members(), &stations[i]);
        text_add(t, "}");
    }
    text_add(t, "]");
}

void add_scales(text *t, double length_scale, double clock, const char *keyphasor) {
    json_name(t, "lengthScale");
    json_number(t, length_scale);
    json_name(t, "speed");
    json_number(t, clock);
    json_name(t, "keyphasor");
    json_text(t, keyphasor);
}

/// Context of add_use, which writes the uses of a parameter.
typedef struct use_list {
    const char *parameter;
    text *to;
} use_list;

/// Writes meaning, unit and range of a key.
static void add_key(text *t, const whirl_key *key) {
    const whirl_range *range = &key->range;
    json_name(t, "meaning");
    json_text(t, key->meaning);
    json_name(t, "unit");
    json_text(t, key->unit);
    json_name(t, "low");
    json_number(t, range->low);
    json_name(t, "high");
    json_number(t, range->high);
    text_add(t, ",\"lowOpen\":%s,\"highOpen\":%s", range->low_open ? "true" : "false",
             range->high_open ? "true" : "false");
}

static void add_use(void *context, const whirl_use *use) {
    const use_list *list = context;
    text *t = list->to;
    if (strcmp(use->parameter, list->parameter) != 0) return;
    json_next(t);
    text_add(t, "{");
    json_name(t, "path");
    json_text(t, use->path);
    add_key(t, use->key);
    text_add(t, ",\"alone\":%s}", use->alone ? "true" : "false");
}

static void add_parameter(text *t, const whirl_case *object, const whirl_parameter *parameter) {
    char comment[256];
    use_list uses = {parameter->name, t};
    text_add(t, "{");
    json_name(t, "name");
    json_text(t, parameter->name);
    json_name(t, "written");
    json_text(t, parameter->text);
    json_name(t, "value");
    json_number(t, parameter->value);
    json_name(t, "unit");
    json_text(t, parameter->unit);
    json_name(t, "expression");
    text_add(t, parameter->text[0] == '=' ? "true" : "false");
    whirl_case_comment(object, parameter->name, comment, sizeof comment);
    json_name(t, "comment");
    json_text(t, comment);
    json_name(t, "uses");
    text_add(t, "[");
    whirl_case_uses(object, add_use, &uses);
    text_add(t, "]}");
}

/// Keys of the case, at any place in it, whose numbers the page can change while a run is shown.
static const char *const moved_keys[] = {"rate",   "torque",      "load_quadratic", "eccentricity",
                                         "moment", "loss_moment", "friction",       NULL};

/// Writes a number of the case in the form of a parameter, if its key is in moved_keys.
static void add_lever(void *context, const whirl_written_number *number) {
    text *t = context;
    const char *const *key = moved_keys;
    while (*key && strcmp(*key, number->key->name) != 0) key++;
    if (!*key) return;
    json_next(t);
    text_add(t, "{");
    json_name(t, "name");
    json_text(t, number->name);
    json_name(t, "written");
    json_text(t, number->text);
    json_name(t, "value");
    json_number(t, number->value);
    json_name(t, "unit");
    json_text(t, number->key->unit);
    text_add(t, ",\"expression\":false,\"comment\":\"\",\"uses\":[{");
    json_name(t, "path");
    json_text(t, number->name);
    add_key(t, number->key);
    text_add(t, ",\"alone\":true}]}");
}

static void add_methods(text *t) {
    json_name(t, "methods");
    text_add(t, "[");
    const whirl_method *method;
    for (size_t i = 0; (method = whirl_method_at(i)) != NULL; i++) {
        json_next(t);
        text_add(t, "{");
        json_name(t, "name");
        json_text(t, method->name);
        json_name(t, "meaning");
        json_text(t, method->meaning);
        text_add(t, ",\"adaptive\":%s}", method->adaptive ? "true" : "false");
    }
    text_add(t, "]");
}

void add_options(text *t, const whirl_batch *batch) {
    json_name(t, "options");
    text_add(t, "{");
    add_members(t, whirl_integrate_members(), &batch->integrate);
    add_members(t, whirl_record_members(), &batch->record);
    if (whirl_analysis_has(batch->analyses, "runup")) add_members(t, whirl_runup_members(), &batch->record.runup);
    text_add(t, "}");
}

static const char *carry_name(whirl_carry carry) {
    switch (carry) {
    case WHIRL_CARRY_FORWARD:
        return "forward";
    case WHIRL_CARRY_REVERSE:
        return "reverse";
    case WHIRL_CARRY_BOTH:
        return "both";
    default:
        return "none";
    }
}

static void add_batch(text *t, const whirl_batch *batch) {
    const size_t along = batch->row ? batch->row : batch->count; // for a map: one row
    json_next(t);
    text_add(t, "{");
    json_name(t, "name");
    json_text(t, batch->name);
    json_name(t, "parameter");
    json_text(t, batch->parameter);
    json_name(t, "values");
    text_add(t, "[");
    for (size_t i = 0; batch->values && i < along; i++) {
        json_next(t);
        json_number(t, batch->values[i]);
    }
    text_add(t, "]");
    json_name(t, "carry");
    json_text(t, carry_name(batch->carry));
    text_add(t, ",\"runup\":%s", whirl_analysis_has(batch->analyses, "runup") ? "true" : "false");
    add_options(t, batch);
    text_add(t, "}");
}

static void add_case(text *t, const whirl_case *object, const whirl_result *described) {
    // Write title and parameters.
    whirl_study study;
    json_name(t, "version");
    json_text(t, WHIRL_VERSION);
    json_name(t, "title");
    json_text(t, described->title);
    json_name(t, "parameters");
    text_add(t, "[");
    for (size_t i = 0; i < described->parameter_count; i++) {
        json_next(t);
        add_parameter(t, object, &described->parameters[i]);
    }
    text_add(t, "]");
    // Write the numbers that the user can change in the page.
    json_name(t, "levers");
    text_add(t, "[");
    whirl_case_numbers(object, add_lever, t);
    text_add(t, "]");
    // Write stations, contacts and scales.
    add_stations(t, described->stations, described->station_count);
    json_name(t, "contacts");
    text_add(t, "[");
    for (size_t i = 0; i < described->contact_count; i++) {
        json_next(t);
        json_text(t, described->contacts[i]);
    }
    text_add(t, "]");
    add_scales(t, described->length_scale, whirl_result_clock(described), whirl_result_keyphasor(described));
    // Write the batches, and the available methods.
    json_name(t, "batches");
    text_add(t, "[");
    whirl_case_study(object, &study);
    for (size_t i = 0; i < study.batch_count; i++) add_batch(t, &study.batches[i]);
    text_add(t, "]");
    add_methods(t);
}

EXPORTED const char *explorer_describe(const whirl_case *object) {
    whirl_result *described = calloc(1, sizeof *described);
    whirl_status status =
        described ? whirl_case_describe_result(object, described) : whirl_fail(WHIRL_NO_MEMORY, "no memory");
    const bool good = explorer_good(&status);
    if (good) {
        text_clear(&answer);
        text_add(&answer, "{");
        add_case(&answer, object, described);
        text_add(&answer, "}");
    }
    whirl_result_free(described);
    return good ? text_bytes(&answer) : NULL;
}

EXPORTED const char *explorer_edit(const char *source, size_t length, const char *path, const char *value) {
    char *edited;
    const whirl_status status = whirl_case_edit(source, length, path, value, &edited);
    if (!explorer_good(&status)) return NULL;
    text_clear(&answer);
    text_add(&answer, "%s", edited);
    free(edited);
    return text_bytes(&answer);
}
