/// Short names of keys: "disc.mass" of a station, "film.clearance" of an element, "integrate.transient" of the study.
#ifndef CASE_PATH_H
#define CASE_PATH_H

#include "content.h"

enum { PATH_SIZE = 256 };

/// Finds the path of a key by a short name ("rotor.stations.disc.mass"); full paths are allowed. Elements of one kind
/// have numbers: "film[2].clearance". WHIRL_BAD_INPUT suggests the nearest name.
whirl_status path_of_name(const case_content *content, const char *name, char path[PATH_SIZE]);

#endif
