/// Import of rotors from files of other programs, as cases.
#ifndef WHIRL_IMPORT_H
#define WHIRL_IMPORT_H

#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A case converted from a rotor file. Starts as {0}; freed by whirl_imported_free.
typedef struct whirl_imported {
    char *text;        ///< the case, ready for whirl_case_parse, with the notes on the file as comments
    size_t length;     ///< bytes of the text
    size_t note_count; ///< number of notes
    char **notes;      ///< omissions, choices, and differences in computation: one sentence each, safe on a terminal
} whirl_imported;

/// Converts a rotor saved by ROSS (Rotor.save, TOML or JSON, versions up to 3.0: github.com/petrobras/ross): shafts and
/// couplings between them, discs, bearings and seals, magnetic bearings, point masses, supports. WHIRL_BAD_INPUT with a
/// sentence that names the file, the section and the key, what was found and what is expected; also for parts that
/// would change the motion and cannot be converted (gears, torque), files above 16 MiB, rotors larger than a case may
/// be, and converted cases that `whirl check` would reject.
whirl_status whirl_import_load(const char *path, whirl_imported *out);

/// Does the same from memory; `name` is the file's name in messages and in the case's title. Ends soon and never
/// crashes, for any bytes.
whirl_status whirl_import_parse(const char *text, size_t length, const char *name, whirl_imported *out);

/// Frees the contents; the struct is empty afterwards.
void whirl_imported_free(whirl_imported *imported);

#ifdef __cplusplus
}
#endif
#endif
