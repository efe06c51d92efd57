/// Film tables for bearings with pads in motion: built once, in some seconds, and kept in the user's cache folder
/// ($XDG_CACHE_HOME/whirl or ~/.cache/whirl) for other runs.
#ifndef WHIRL_FILM_TABLES_H
#define WHIRL_FILM_TABLES_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Maximum number of tables of all rotors of a process.
enum { WHIRL_MAX_FILM_TABLES = 4096 };

/// A set of tables: one bit a table of the process. All zero: the empty set.
typedef struct whirl_film_tables {
    uint64_t bits[WHIRL_MAX_FILM_TABLES / 64]; ///< table i of the process: bit i % 64 of bits[i / 64]
} whirl_film_tables;

/// Size of the text of whirl_film_tables_text.
enum { WHIRL_FILM_TABLES_TEXT = 64 };

/// Adds the tables of every rotor that the calling thread builds from now on, outlines included, to *tables, which is
/// borrowed until the next call. NULL ends it.
void whirl_film_tables_watch(whirl_film_tables *tables);

/// Returns the number of tables in a set.
size_t whirl_film_tables_count(const whirl_film_tables *tables);

/// Returns the number of tables of a set that are neither in memory nor in the cache folder; they are built before a
/// rotor moves.
size_t whirl_film_tables_missing(const whirl_film_tables *tables);

/// Describes the contents of a set, "2, checksum 0123456789abcdef": the number of different tables and one checksum of
/// their coefficients; for a single table the checksum in its file. Omits tables that this process has neither built
/// nor read; "" if none remain.
void whirl_film_tables_text(const whirl_film_tables *tables, char text[WHIRL_FILM_TABLES_TEXT]);

#ifdef __cplusplus
}
#endif
#endif
