// Balancing as a text, for programs in other languages.
#include <stdlib.h>

#include "whirl/balance.h"
#include "whirl/case.h"
#include "whirl/handles.h"

static whirl_status write_all(const whirl_balance *balance, const whirl_balance_model *model, char **json) {
    whirl_correction *found;
    size_t size;
    whirl_status status = whirl_balance_solve(balance, model, &found);
    if (status.code != WHIRL_OK) return status;
    FILE *stream = open_memstream(json, &size);
    status = stream ? whirl_balance_write_json(balance, model, found, stream)
                    : whirl_fail(WHIRL_NO_MEMORY, "no memory to balance a rotor");
    if (stream && fclose(stream) != 0 && status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory to balance a rotor");
    whirl_correction_free(found);
    if (status.code == WHIRL_OK) return status;
    free(*json);
    *json = NULL;
    return status;
}

whirl_status whirl_balance_json(const char *text, size_t length, const char *name, char *problems, size_t size,
                                char **json) {
    whirl_problems found = {0};
    whirl_balance *balance;
    whirl_balance_model *model = NULL;
    *json = NULL;
    whirl_status status = whirl_balance_parse(text, length, name, &found, &balance);
    if (status.code == WHIRL_OK) status = whirl_balance_consult(balance, name, &found, &model);
    whirl_problems_text(&found, problems, size);
    whirl_problems_free(&found);
    if (status.code == WHIRL_OK) status = write_all(balance, model, json);
    whirl_balance_model_free(model);
    whirl_balance_free(balance);
    return status;
}
