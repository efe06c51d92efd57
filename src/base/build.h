// Facts about the build of this library.
#ifndef BASE_BUILD_H
#define BASE_BUILD_H

typedef struct build_fact {
    const char *name, *value;
} build_fact;

/// Returns the facts "version", "revision", "sources" (a SHA-256 of all source files), "compiler", "flags", "build
/// type" and "libraries". The list is static and ends with an entry whose name is NULL. The value of an unknown fact is
/// "unknown": a source archive has no revision.
const build_fact *build_facts(void);

/// Returns a SHA-256 of the sources that film tables depend on, or "unknown".
const char *build_film_sources(void);

#endif
