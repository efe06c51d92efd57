// Provenance of a result: the build of the library and the machine that it ran on.
#include "build.h"
#include "isa.h"

#include "whirl/engine/result.h"

#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>

// Reads "model name" of the first processor from Linux's /proc/cpuinfo.
static void processor_model(char *text, size_t size) {
    snprintf(text, size, "unknown");
    FILE *stream = fopen("/proc/cpuinfo", "r");
    if (!stream) return;
    char line[512];
    while (fgets(line, sizeof line, stream)) {
        const char *colon = strchr(line, ':');
        if (!colon || strncmp(line, "model name", 10) != 0) continue;
        const char *model = colon + 1 + strspn(colon + 1, " \t");
        snprintf(text, size, "%.*s", (int)strcspn(model, "\n"), model);
        break;
    }
    fclose(stream);
}

static whirl_status add_host(whirl_result *result) {
    struct utsname system;
    char text[256];
    if (uname(&system) < 0) return whirl_ok();
    whirl_status status = whirl_result_add_fact(result, "host", system.nodename);
    if (status.code != WHIRL_OK) return status;
    snprintf(text, sizeof text, "%.80s %.80s %.80s", system.sysname, system.release, system.machine);
    return whirl_result_add_fact(result, "system", text);
}

whirl_status whirl_result_add_provenance(whirl_result *result) {
    for (const build_fact *fact = build_facts(); fact->name; ++fact) {
        const whirl_status status = whirl_result_add_fact(result, fact->name, fact->value);
        if (status.code != WHIRL_OK) return status;
    }
    whirl_status status = add_host(result);
    if (status.code != WHIRL_OK) return status;
    char model[256];
    processor_model(model, sizeof model);
    status = whirl_result_add_fact(result, "processor", model);
    const isa *chosen;
    if (status.code != WHIRL_OK || isa_choose(&chosen).code != WHIRL_OK) return status;
    return whirl_result_add_fact(result, "instruction set", chosen->name);
}
