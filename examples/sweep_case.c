// A study from a case file: load, change, run, read.
#include <stdio.h>

#include "whirl/engine.h"

static int complain(whirl_status status) {
    fprintf(stderr, "%s\n", status.message);
    return 1;
}

int main(void) {
    whirl_problems problems = {0};
    whirl_case *rotor_case;
    whirl_study study;
    whirl_result *result;

    whirl_status status = whirl_case_load("cases/jeffcott-rub.yaml", &problems, &rotor_case);
    if (status.code == WHIRL_OK) status = whirl_case_set(rotor_case, "mu=0.02");
    if (status.code == WHIRL_OK) status = whirl_case_study(rotor_case, &study);
    if (status.code != WHIRL_OK) return complain(status);

    study.batch_count = 1; // the sweep alone, coarse and short
    study.batches[0].count = 16;
    study.batches[0].integrate.steps_per_revolution = 256;
    status = whirl_study_run(&study, &(whirl_run_options){0}, &result);
    if (status.code != WHIRL_OK) return complain(status);

    const whirl_table *sweep = whirl_result_table(result, "sweep");
    for (size_t i = 0; i < sweep->count; i++) {
        char regime[64];
        const whirl_verdict verdict = whirl_table_verdict(sweep, i);
        whirl_verdict_name(&verdict, regime, sizeof regime);
        printf("%s = %.4f: largest radius %.4f, in contact %4.1f %% of the time, %s\n", sweep->parameter,
               sweep->values[i], *whirl_table_field(sweep, i, WHIRL_FIELD_ORBIT_MAX_RADIUS, 0),
               100 * *whirl_table_field(sweep, i, WHIRL_FIELD_RUB_SHARE, 0), regime);
    }
    whirl_result_free(result);
    whirl_case_free(rotor_case);
    return 0;
}
