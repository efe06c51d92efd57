// Identity of a user's equations: facts of a result, by which a journal recognizes its study.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number_text.h"
#include "user.h"
#include "whirl/status.h"

enum { MAX_SHOWN = 160 }; ///< letters of a fact

whirl_status whirl_user_system_identity(whirl_user_system *system, const char *identity) {
    if (!identity || !*identity)
        return whirl_fail(WHIRL_BAD_INPUT, "the identity of a system is empty, expected a name and a version");
    char *copy = strdup(identity);
    if (!copy) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the identity of a system");
    free(system->identity);
    system->identity = copy;
    return whirl_ok();
}

/// FNV-1a of 64 bits.
static uint64_t identity_checksum(const char *text) {
    uint64_t sum = 0xcbf29ce484222325u;
    for (; *text; text++) sum = (sum ^ (unsigned char)*text) * 0x100000001b3u;
    return sum;
}

/// Adds a fact; a long text is cut, with its checksum behind.
static whirl_status identity_add(whirl_result *result, const char *name, const char *text) {
    char plain[MAX_SHOWN + 32];
    if (strlen(text) <= MAX_SHOWN)
        snprintf(plain, sizeof plain, "%s", text);
    else
        snprintf(plain, sizeof plain, "%.*s ... (%016llx)", MAX_SHOWN, text,
                 (unsigned long long)identity_checksum(text));
    whirl_make_plain(plain);
    return whirl_result_add_fact(result, name, plain);
}

/// Writes the form of the equations: coordinates, angles, period, and the coordinates of stations, whose names results
/// have anyway.
static void put_form(const whirl_user_system *system, FILE *out) {
    char number[NUMBER_SIZE];
    fprintf(out, "%zu coordinates, %zu of them displacements", system->dimension, system->displacements);
    fprintf(out, "%s%s", system->kinked ? ", with kinks" : "", system->tangent ? ", with a derivative" : "");
    for (size_t i = 0; system->angles && i < system->dimension; i++) {
        if (system->angles[i] == 0.0) continue;
        number_text(system->angles[i], number);
        fprintf(out, "; number %zu an angle of turns of %s", i, number);
    }
    if (system->units) user_put_units(system, out);
    number_text(system->period, number);
    if (system->speed < system->parameter_count)
        fprintf(out, "; a revolution of 2 pi/%s", system->parameters[system->speed].name);
    else
        fprintf(out, "; a revolution of %s", number);
    for (size_t i = 0; i < system->station_count; i++) {
        const whirl_probe *one = &system->stations[i];
        fprintf(out, "; %s of %zu and %zu, %zu and %zu", one->name, one->x, one->y, one->vx, one->vy);
    }
}

static void put_start(const whirl_user_system *system, FILE *out) {
    char number[NUMBER_SIZE];
    for (size_t k = 0; k < system->dimension; k++) {
        number_text(system->start[k], number);
        fprintf(out, "%s%s", k > 0 ? ", " : "", number);
    }
}

whirl_status user_add_equations(const whirl_user_system *system, whirl_result *result) {
    static const struct {
        const char *name;
        void (*put)(const whirl_user_system *system, FILE *out);
        bool always;
    } facts[] = {{"equations: form", put_form, true},
                 {"equations: start", put_start, true},
                 {"equations: branches", user_put_branches, false}};
    whirl_status status =
        identity_add(result, "equations", system->identity ? system->identity : "functions of the user's own");
    // Add each fact that applies.
    for (size_t i = 0; i < sizeof facts / sizeof *facts && status.code == WHIRL_OK; i++) {
        char *text = NULL;
        size_t size;
        if (!facts[i].always && !system->branches.wanted) continue;
        FILE *out = open_memstream(&text, &size);
        if (out) facts[i].put(system, out);
        if (!out || fclose(out) != 0 || !text)
            status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the facts of a system");
        else
            status = identity_add(result, facts[i].name, text);
        free(text);
    }
    return status;
}
