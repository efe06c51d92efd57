#include "fit_turning.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static whirl_status fit_turning_machine(const void *family, const whirl_batch *batch, double value,
                                        whirl_machine *machine) {
    const fit_turning *t = family;
    whirl_batch own = *batch;
    const bool turns = !*batch->parameter;
    own.speed = turns ? value : t->speed;
    return t->base->machine(t->base->family, &own, turns ? (double)NAN : value, machine);
}

void fit_turning_make(fit_turning *t, const fit_place *p) {
    memset(t, 0, sizeof *t);
    t->base = p->of->study;
    t->batch = p->batch;
    t->study = (whirl_study){.machine = t->base->machine, .family = t->base->family};
    if (p->motion->along) {
        snprintf(t->batch.parameter, sizeof t->batch.parameter, "%s", p->motion->along);
        return;
    }
    t->study.machine = fit_turning_machine;
    t->study.family = t;
}
