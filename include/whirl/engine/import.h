/// Rotors that other programs have saved, as cases.
#ifndef WHIRL_IMPORT_H
#define WHIRL_IMPORT_H

#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A case made of a rotor file. Starts as {0}; freed by whirl_imported_free.
typedef struct whirl_imported {
    char *text;        ///< the case, ready for whirl_case_parse; it says in comments what the notes say
    size_t length;     ///< bytes of the text
    size_t note_count; ///< of notes
    char **notes;      ///< what was left out, chosen, or is computed otherwise: a sentence each, safe on a terminal
} whirl_imported;

/// Reads a rotor that ROSS has saved (Rotor.save, TOML or JSON, versions up to 3.0: github.com/petrobras/ross):
/// shafts and the couplings between them, discs, bearings and seals, magnetic bearings, point masses, supports.
/// WHIRL_BAD_INPUT with a sentence that names the file, the section and the key, what was found and what is
/// expected; so are refused what would change the motion and cannot be taken over (gears, torque), files above 16
/// MiB, rotors larger than a case may be, and those whose case is refused: a text that is made is a good case.
whirl_status whirl_import_load(const char *path, whirl_imported *out);

/// The same from memory; `name` stands for the file in messages and in the case's title. Never runs long and never
/// crashes, whatever the bytes.
whirl_status whirl_import_parse(const char *text, size_t length, const char *name, whirl_imported *out);

/// Frees what it holds, not the struct, which is empty afterwards.
void whirl_imported_free(whirl_imported *imported);

#ifdef __cplusplus
}
#endif
#endif
