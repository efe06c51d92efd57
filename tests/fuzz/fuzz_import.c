// Any bytes as a rotor saved by another program: refused with a sentence, or a case that can be read, of a machine that
// can be built.
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/case.h"
#include "whirl/internal/import.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

/// Checks that the imported case is valid, unless the machine is impossible (shafts without length, masses below 0).
static void check_case(const whirl_imported *imported) {
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    const whirl_status status = whirl_case_parse(imported->text, imported->length, "fuzz", &problems, &object);
    require(status.code == WHIRL_OK || status.code == WHIRL_BAD_INPUT);
    for (size_t i = 0; i < problems.count; i++)
        require(strstr(problems.items[i].message, "YAML") == NULL &&
                strstr(problems.items[i].message, "UTF-8") == NULL &&
                strstr(problems.items[i].message, "no key") == NULL);
    whirl_problems_free(&problems);
    whirl_case_free(object);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 16) return 0;
    whirl_imported imported;
    const whirl_status status = whirl_import_parse((const char *)data, size, "fuzz.toml", &imported);
    require((status.code == WHIRL_OK) == (imported.text != NULL));
    require(status.code == WHIRL_OK || status.message[0] != '\0');
    if (imported.text) {
        require(strlen(imported.text) == imported.length);
        check_case(&imported);
    }
    whirl_imported_free(&imported);
    return 0;
}
