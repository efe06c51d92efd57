// Reads, writes and checks members of structs by the tables that describe them (whirl_member).
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number_text.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

const whirl_key *whirl_group_at(const whirl_group *group, size_t index) {
    if (index < group->key_count) return &group->keys[index];
    index -= group->key_count;
    for (size_t t = 0; group->tables && group->tables[t]; t++)
        for (const whirl_member *member = group->tables[t](); member->part; member++)
            if (strcmp(member->part, group->name) == 0 && index-- == 0) return &member->key;
    return NULL;
}

const whirl_key *whirl_group_key(const whirl_group *group, const char *name) {
    const whirl_key *key;
    for (size_t k = 0; (key = whirl_group_at(group, k)) != NULL; k++)
        if (strcmp(key->name, name) == 0) return key;
    return NULL;
}

const whirl_member *whirl_member_find(const whirl_member *table, const char *name) {
    for (; table->part; table++)
        if (table->name && strcmp(table->name, name) == 0) return table;
    return NULL;
}

double whirl_member_number(const whirl_member *member, const void *object) {
    const void *at = (const char *)object + member->offset;
    int whole;
    if (member->type == WHIRL_MEMBER_WORD) return (double)NAN;
    if (member->type == WHIRL_MEMBER_NUMBER) return *(const double *)at;
    if (member->type == WHIRL_MEMBER_FLAG) return *(const bool *)at;
    if (member->type == WHIRL_MEMBER_INDEX) return (double)*(const size_t *)at;
    memcpy(&whole, at, sizeof whole); // enumerations have a type of their own
    return whole;
}

void whirl_member_set(const whirl_member *member, void *object, double value) {
    void *at = (char *)object + member->offset;
    if (member->type == WHIRL_MEMBER_NUMBER)
        *(double *)at = value;
    else if (member->type == WHIRL_MEMBER_FLAG)
        *(bool *)at = value != 0.0;
    else if (member->type == WHIRL_MEMBER_INDEX)
        *(size_t *)at = (size_t)value;
    else if (member->type == WHIRL_MEMBER_WHOLE)
        memcpy(at, &(int){(int)value}, sizeof(int));
}

void whirl_member_say(const whirl_member *member, void *object, const char *word) {
    const bool named = member->name && strcmp(word, member->name) == 0;
    if (member->type == WHIRL_MEMBER_WORD)
        snprintf((char *)object + member->offset, WHIRL_NAME_SIZE, "%s", word);
    else
        whirl_member_set(member, object, named || strcmp(word, "yes") == 0 || strcmp(word, "true") == 0);
}

void whirl_member_text(const whirl_member *member, const void *object, char text[WHIRL_NAME_SIZE]) {
    const double value = whirl_member_number(member, object);
    if (member->type == WHIRL_MEMBER_WORD)
        snprintf(text, WHIRL_NAME_SIZE, "%s", (const char *)object + member->offset);
    else if (member->type == WHIRL_MEMBER_FLAG)
        snprintf(text, WHIRL_NAME_SIZE, "%s", value != 0.0 ? "true" : "false");
    else if (isfinite(value))
        number_text(value, text);
    else
        snprintf(text, WHIRL_NAME_SIZE, "%g", value);
}

void whirl_members_default(const whirl_member *table, void *object) {
    for (; table->part; table++)
        if (!table->name || !*table->key.fallback)
            continue;
        else if (table->key.kind == WHIRL_KEY_CHOICE)
            whirl_member_say(table, object, table->key.fallback);
        else
            whirl_member_set(table, object, strtod(table->key.fallback, NULL));
}

whirl_status whirl_members_check(const whirl_member *table, const void *object) {
    for (; table->part; table++) {
        if (!table->name || table->key.kind == WHIRL_KEY_CHOICE) continue;
        const whirl_status status = whirl_key_check_number(&table->key, whirl_member_number(table, object));
        if (status.code != WHIRL_OK) return whirl_fail(status.code, "%s %s", table->name, status.message);
    }
    return whirl_ok();
}
