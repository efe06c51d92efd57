// What this library was built from and with.
#ifndef BASE_BUILD_H
#define BASE_BUILD_H

typedef struct build_fact {
    const char *name, *value;
} build_fact;

/// "version", "revision", "sources" (a SHA-256 of all of them), "compiler", "flags", "build type", "libraries"; static,
/// ended by an entry whose name is NULL.
/// What is not known (a source archive has no revision) is "unknown".
const build_fact *build_facts(void);

/// A SHA-256 of the sources that tables of films follow from, or "unknown".
const char *build_film_sources(void);

#endif
