// Any bytes as a case file: refused with a problem, or a case whose machines can be built and take a step. Machines are
// outlines (whirl_rotor_outline): a film table takes seconds under the sanitizers, and every mutated pad has its own.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "whirl/engine/case.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

/// Evaluates the right-hand side at the start of a machine, for any numbers of the case.
static void evaluate(const whirl_machine *machine) {
    const whirl_system *system = machine->system;
    double forcing[WHIRL_MAX_FORCING] = {0.0};
    double *derivative = calloc(system->dimension, sizeof *derivative);
    require(derivative != NULL);
    if (system->forcing) system->forcing(system->model, 0.25, forcing);
    system->rhs(system->model, 0.25, forcing, machine->start, derivative);
    free(derivative);
}

static void build_machines(const whirl_case *object) {
    whirl_study study;
    require(whirl_case_study(object, &study).code == WHIRL_OK);
    require(study.batch_count >= 1);
    for (size_t b = 0; b < study.batch_count; b++) {
        whirl_batch *batch = &study.batches[b];
        const size_t middle = batch->count / 2;
        whirl_machine machine;
        batch->outline = true;
        require(batch->count >= 1);
        // The middle of a sweep is not checked when the case is read, so it may be no machine.
        if (study.machine(study.family, batch, batch->values ? batch->values[middle] : NAN, &machine).code != WHIRL_OK)
            continue;
        evaluate(&machine);
        machine.release(machine.owner);
    }
}

static void describe(const whirl_case *object) {
    whirl_result *result = calloc(1, sizeof *result);
    require(result != NULL);
    require(whirl_case_describe_result(object, result).code == WHIRL_OK);
    whirl_result_free(result);
}

static void set_something(whirl_case *object) {
    whirl_study study;
    char assignment[WHIRL_NAME_SIZE + 8];
    require(whirl_case_study(object, &study).code == WHIRL_OK);
    if (!study.batches[0].parameter[0]) return;
    snprintf(assignment, sizeof assignment, "%s=0.5", study.batches[0].parameter);
    whirl_case_set(object, assignment);
    require(whirl_case_set(object, "no such name=1").code == WHIRL_BAD_INPUT);
}

static void read_problems(whirl_problems *problems) {
    char text[1024];
    for (size_t i = 0; i < problems->count; i++) whirl_problem_text(problems, i, text, sizeof text);
    whirl_problems_free(problems);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 16) return 0;
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    const whirl_status status = whirl_case_parse((const char *)data, size, "fuzz.yaml", &problems, &object);
    require((status.code == WHIRL_OK) == (object != NULL));
    require((status.code == WHIRL_OK) == (problems.count == 0));
    read_problems(&problems);
    if (!object) return 0;
    build_machines(object);
    describe(object);
    set_something(object);
    build_machines(object);
    whirl_case_free(object);
    return 0;
}
