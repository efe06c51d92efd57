/// Macros for tables of keys: a whirl_key by its kind, without the members that the kind does not use.
///
/// `presence` is REQUIRED, OPTIONAL (the key may be left out) or DEFAULT("0"): the value of a key that is left out, as
/// a text in the key's unit. Ranges are those of whirl/engine/descriptor.h; CITED_ keys name the source of their
/// definition; of: the key without which this one has no effect, or NULL.
#ifndef BASE_KEYS_H
#define BASE_KEYS_H

#include <math.h>

#include "whirl/engine/descriptor.h"

#define REQUIRED true, ""
#define OPTIONAL false, ""
#define DEFAULT(text) false, text

#define CITED_NUMBER_KEY(name, symbol, unit, presence, range, meaning, source)                                         \
    { name, symbol, unit, WHIRL_KEY_NUMBER, presence, range, NULL, meaning, source, NULL }
#define NUMBER_KEY(name, symbol, unit, presence, range, meaning)                                                       \
    { name, symbol, unit, WHIRL_KEY_NUMBER, presence, range, NULL, meaning, "", NULL }
#define ANGLE_KEY(name, symbol, of, meaning)                                                                           \
    { name, symbol, "rad", WHIRL_KEY_NUMBER, DEFAULT("0"), WHIRL_ANY, NULL, meaning, "", of }
#define CITED_NUMBERS_KEY(name, symbol, unit, presence, range, meaning, source)                                        \
    { name, symbol, unit, WHIRL_KEY_NUMBERS, presence, range, NULL, meaning, source, NULL }
#define WHOLE_KEY(name, symbol, presence, range, meaning)                                                              \
    { name, symbol, "1", WHIRL_KEY_WHOLE, presence, range, NULL, meaning, "", NULL }
#define CITED_CHOICE_KEY(name, presence, choices, meaning, source)                                                     \
    { name, "", "", WHIRL_KEY_CHOICE, presence, WHIRL_ANY, choices, meaning, source, NULL }
#define CHOICE_KEY(name, presence, choices, meaning)                                                                   \
    { name, "", "", WHIRL_KEY_CHOICE, presence, WHIRL_ANY, choices, meaning, "", NULL }
#define CHOICE_OF_KEY(name, presence, choices, of, meaning)                                                            \
    { name, "", "", WHIRL_KEY_CHOICE, presence, WHIRL_ANY, choices, meaning, "", of }
#define STATION_KEY(name, presence, meaning)                                                                           \
    { name, "", "", WHIRL_KEY_STATION, presence, WHIRL_ANY, NULL, meaning, "", NULL }
#define STATIONS_KEY(name, presence, meaning)                                                                          \
    { name, "", "", WHIRL_KEY_STATIONS, presence, WHIRL_ANY, NULL, meaning, "", NULL }
#define NAME_KEY(name, presence, choices, meaning)                                                                     \
    { name, "", "", WHIRL_KEY_NAME, presence, WHIRL_ANY, choices, meaning, "", NULL }

#endif
