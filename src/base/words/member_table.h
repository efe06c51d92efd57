/// Entries of tables of members.
#ifndef BASE_MEMBER_TABLE_H
#define BASE_MEMBER_TABLE_H

#include <stddef.h>

/// Initializes a whirl_member for `field` of STRUCT, of type WHIRL_MEMBER_<TYPE>. Further arguments initialize its
/// whirl_key.
#define MEMBER(STRUCT, TYPE, name, field, part, refined, ...)                                                          \
    { name, WHIRL_MEMBER_##TYPE, offsetof(STRUCT, field), part, {__VA_ARGS__, NULL}, refined }

#endif
