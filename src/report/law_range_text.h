/// Describes points outside the validity range of an element's law, and points at rest with a peculiarity.
#ifndef REPORT_LAW_RANGE_TEXT_H
#define REPORT_LAW_RANGE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

enum { RANGE_TEXT_SIZE = 1024 };

/// Describes validity range `index` of a table: "film at journal: eccentricity ratio up to 0.95, to which its
/// coefficients were found; reached 0.97 (37 of 256 points, first at 6400 rpm)". Returns false if no point has left it.
bool law_range_text(const whirl_shown_units *units, const whirl_table *table, size_t index, char text[RANGE_TEXT_SIZE]);

/// Describes points of studies at rest without an equilibrium: "3 of 53 points, first at 1000 rpm: it could be followed
/// up to 74.3 % of the static load, ...". Returns false if all points have an equilibrium.
bool no_equilibrium_text(const whirl_shown_units *units, const whirl_table *table, char text[RANGE_TEXT_SIZE]);

/// Describes points at rest with another equilibrium: "there is another one, up to 0.12 mm away, to which that of the
/// value before or after leads, stable (2 of 53 points, first at 8 MN/m)". Returns false if there are none.
bool other_equilibrium_text(const whirl_shown_units *units, const whirl_table *table, char text[RANGE_TEXT_SIZE]);

/// Describes a contact (index) that is closed at rest: "rub at disc with up to 120 N (14 of 171 points, first at 500
/// rpm), which small motions leave as it is there". Returns false if it is open everywhere.
bool closed_contact_text(const whirl_shown_units *units, const whirl_table *table, size_t contact,
                         char text[RANGE_TEXT_SIZE]);

#endif
