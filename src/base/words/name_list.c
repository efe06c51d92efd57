#include "name_list.h"

#include <stdio.h>
#include <string.h>

bool name_list_next(const char **list, char name[WHIRL_NAME_SIZE]) {
    static const char between[] = " ,";
    *list += strspn(*list, between);
    const size_t length = strcspn(*list, between);
    snprintf(name, WHIRL_NAME_SIZE, "%.*s", length < WHIRL_NAME_SIZE ? (int)length : WHIRL_NAME_SIZE, *list);
    *list += length;
    return length > 0;
}
