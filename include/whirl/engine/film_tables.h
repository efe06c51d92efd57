/// Tables of films, which bearings of pads read while they move: made once, in some seconds, kept in the user's cache
/// folder ($XDG_CACHE_HOME/whirl or ~/.cache/whirl) for other runs.
#ifndef WHIRL_FILM_TABLES_H
#define WHIRL_FILM_TABLES_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The most tables that the rotors of a process may ask for.
enum { WHIRL_MAX_FILM_TABLES = 4096 };

/// Begins to watch which tables the rotors of this process ask for that are built from now on, outlines included.
void whirl_film_tables_watch(void);

/// How many of these (*asked) are neither in memory nor in the cache folder, so that they are to be made before a rotor
/// moves.
size_t whirl_film_tables_missing(size_t *asked);

#ifdef __cplusplus
}
#endif
#endif
