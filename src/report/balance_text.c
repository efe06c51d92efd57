// Balances a rotor for programs in other languages: reads the text of a job, and returns the result as a text (JSON).
#include "text_written.h"
#include "whirl/engine/case.h"
#include "whirl/handles.h"
#include "whirl/internal/balance.h"
#include "whirl/status.h"

/// A balancing job and its result.
typedef struct answer {
    const whirl_balance *balance;
    const whirl_balance_model *model;
    const whirl_correction *found;
    const char *units; ///< units in which it is shown
} answer;

static whirl_status write_answer(const void *of, FILE *stream) {
    const answer *own = of;
    return whirl_balance_write_json(own->balance, own->model, own->found, own->units, stream);
}

static whirl_status write_all(const whirl_balance *balance, const whirl_balance_model *model, const char *units,
                              char **json) {
    whirl_correction *found;
    whirl_status status = whirl_balance_solve(balance, model, &found);
    if (status.code != WHIRL_OK) return status;
    status = text_written(write_answer, &(answer){balance, model, found, units}, "to balance a rotor", json);
    whirl_correction_free(found);
    return status;
}

whirl_status whirl_balance_json(const char *text, size_t length, const char *name, const char *units, char *problems,
                                size_t size, char **json) {
    whirl_problems found = {0};
    whirl_balance *balance;
    whirl_balance_model *model = NULL;
    *json = NULL;
    whirl_status status = whirl_balance_parse(text, length, name, &found, &balance);
    if (status.code == WHIRL_OK) status = whirl_balance_consult(balance, name, &found, &model);
    whirl_problems_text(&found, problems, size);
    whirl_problems_free(&found);
    if (status.code == WHIRL_OK) status = write_all(balance, model, units, json);
    whirl_balance_model_free(model);
    whirl_balance_free(balance);
    return status;
}
