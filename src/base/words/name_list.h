/// Lists of names in one text, separated by blanks or commas.
#ifndef BASE_NAME_LIST_H
#define BASE_NAME_LIST_H

#include <stdbool.h>

#include "whirl/engine/descriptor.h"

/// Takes the first name off the list (cut to WHIRL_NAME_SIZE - 1 bytes); false if it is empty.
bool name_list_next(const char **list, char name[WHIRL_NAME_SIZE]);

#endif
