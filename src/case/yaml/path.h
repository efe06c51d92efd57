/// Short names of keys: "disc.mass" of a station, "film.clearance" of an element, "integrate.transient" of the study.
#ifndef CASE_PATH_H
#define CASE_PATH_H

#include "content.h"

enum { PATH_SIZE = 256 };

/// The path of the key that a short name means ("rotor.stations.disc.mass"); paths themselves stand for what they are.
/// Elements of one kind are told apart by numbers: "film[2].clearance". WHIRL_BAD_INPUT names the nearest name.
whirl_status path_of_name(const case_content *content, const char *name, char path[PATH_SIZE]);

#endif
