/// Entries of tables of members.
#ifndef BASE_MEMBER_TABLE_H
#define BASE_MEMBER_TABLE_H

#include <stddef.h>

/// A whirl_member: `field` of STRUCT, of type WHIRL_MEMBER_<TYPE>, with the parts of its key behind the others.
#define MEMBER(STRUCT, TYPE, name, field, part, refined, ...)                                                          \
    { name, WHIRL_MEMBER_##TYPE, offsetof(STRUCT, field), part, {__VA_ARGS__, NULL}, refined }

#endif
