// A system that is no rotor, with equations of your own: Duffing's oscillator x'' + 0.3 x' - x + x^3 = gamma cos 1.2 t.
// Integrators and analyses need only its whirl_system.
#include <math.h>
#include <stdio.h>

#include "whirl/engine.h"

static void duffing(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double gamma = *(const double *)model;
    (void)t;
    dxdt[0] = x[1];
    dxdt[1] = gamma * forcing[0] - 0.3 * x[1] + x[0] - x[0] * x[0] * x[0];
}

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    forcing[0] = cos(1.2 * t);
}

int main(void) {
    const double amplitudes[] = {0.20, 0.28, 0.29, 0.37, 0.50, 0.65};
    for (size_t i = 0; i < sizeof amplitudes / sizeof *amplitudes; i++) {
        const whirl_system system = {.dimension = 2,
                                     .period = 2 * acos(-1.0) / 1.2,
                                     .forcing_count = 1,
                                     .forcing = cosine,
                                     .rhs = duffing,
                                     .model = &amplitudes[i]};
        const whirl_integrate_options integrate = whirl_integrate_default();
        whirl_record_options options = whirl_record_default();
        whirl_record *record;
        options.record = 400;
        options.waveform = false;
        const whirl_status status = whirl_record_motion(&system, &integrate, &options, (double[]){1, 0}, NULL, &record);
        if (status.code != WHIRL_OK) {
            fprintf(stderr, "%s\n", status.message);
            return 1;
        }
        char regime[64], reason[256];
        const whirl_verdict verdict = whirl_judge(record);
        whirl_verdict_name(&verdict, regime, sizeof regime);
        whirl_verdict_reason(&verdict, reason, sizeof reason);
        printf("gamma = %.2f: %s (%s)\n", amplitudes[i], regime, reason);
        whirl_record_free(record);
    }
    return 0;
}
