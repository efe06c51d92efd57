// Facts of the build. CMake writes two headers (cmake/build_info.cmake): build_info.h when it configures, and
// build_revision.h whenever the git revision or a source has changed. A build by other means knows its version only.
#include "build.h"

#include "whirl/version.h"

#include <stddef.h>

#ifdef BUILD_INFO
#include "build_info.h"
#include "build_revision.h"
#else
#define BUILD_COMPILER "unknown"
#define BUILD_FLAGS "unknown"
#define BUILD_TYPE "unknown"
#define BUILD_LIBRARIES "unknown"
#define BUILD_REVISION "unknown"
#define BUILD_SOURCES "unknown"
#define BUILD_FILM_SOURCES "unknown"
#endif

const build_fact *build_facts(void) {
    static const build_fact facts[] = {
        {"version", WHIRL_VERSION},     {"revision", BUILD_REVISION},
        {"sources", BUILD_SOURCES},     {"compiler", BUILD_COMPILER},
        {"flags", BUILD_FLAGS},         {"build type", BUILD_TYPE},
        {"libraries", BUILD_LIBRARIES}, {NULL, NULL},
    };
    return facts;
}

const char *whirl_revision(void) {
    return BUILD_REVISION;
}

const char *build_film_sources(void) {
    return BUILD_FILM_SOURCES;
}
