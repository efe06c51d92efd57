// Facts about the build of this library.
#ifndef BASE_BUILD_H
#define BASE_BUILD_H

typedef struct build_fact {
    const char *name, *value;
} build_fact;

/// "version", "revision", "sources" (a SHA-256 of all of them), "compiler", "flags", "build type", "libraries"; static,
/// terminated by an entry whose name is NULL. Unknown facts (a source archive has no revision) are "unknown".
const build_fact *build_facts(void);

/// Returns a SHA-256 of the sources that film tables depend on, or "unknown".
const char *build_film_sources(void);

#endif
