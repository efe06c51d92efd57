/// Rotors saved by ROSS as cases, and their modes.
#ifndef SUPPORT_IMPORT_H
#define SUPPORT_IMPORT_H

#include "whirl/engine/case.h"
#include "whirl/engine/linear.h"
#include "whirl/internal/import.h"

/// `text` with every `from` replaced by `to`; at least one is there. Frees it.
char *replace_all(char *text, const char *from, const char *to);

/// The case of an imported rotor, of its whole model and no reduced one. Frees what was imported; freed by free().
char *whole_case(whirl_imported *imported);

whirl_case *parse_case(const char *text);

/// At a speed in rad/s; *clock is that by which the modes are in rad/s.
whirl_modes *modes_at(const whirl_case *object, double speed, double *clock);

#endif
