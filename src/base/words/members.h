/// How tables of members are written.
#ifndef BASE_MEMBERS_H
#define BASE_MEMBERS_H

#include <stddef.h>

#include "whirl/engine/descriptor.h"

/// A whirl_member: `field` of STRUCT, of type WHIRL_MEMBER_<TYPE>, with the parts of its key behind the others.
#define MEMBER(STRUCT, TYPE, name, field, part, refined, ...)                                                          \
    { name, WHIRL_MEMBER_##TYPE, offsetof(STRUCT, field), part, {__VA_ARGS__}, refined }

#endif
