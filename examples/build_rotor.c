// A rotor without a case file: a rigid rotor in a short journal bearing, and its whirl above the threshold speed.
#include <math.h>
#include <stdio.h>

#include "whirl/engine.h"

static whirl_status build(double speed, whirl_rotor **rotor) {
    const double clearance = 100e-6;
    whirl_design *design;
    whirl_status status = whirl_design_new(speed, clearance, &design);
    if (status.code != WHIRL_OK) return status;
    const whirl_setting journal[] = {{"mass", 100, NULL}, {"eccentricity", 2e-6, NULL}};
    const whirl_setting film[] = {{"at", 0, "journal"},
                                  {"clearance", clearance, NULL},
                                  {"viscosity", 0.02, NULL},
                                  {"radius", 50e-3, NULL},
                                  {"length", 25e-3, NULL}};
    status = whirl_design_station(design, "journal", journal, 2);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, "film", film, 5);
    if (status.code == WHIRL_OK) status = whirl_design_element(design, "gravity", NULL, 0);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

int main(void) {
    const double pi = acos(-1.0);
    for (int rpm = 3000; rpm <= 12000; rpm += 3000) {
        whirl_rotor *rotor;
        whirl_record *record;
        whirl_status status = build(rpm * pi / 30, &rotor);
        const whirl_integrate_options integrate = whirl_integrate_default();
        whirl_record_options options = whirl_record_default();
        options.transient = 300;
        const double start[4] = {0, -0.5, 0, 0};
        if (status.code == WHIRL_OK)
            status = whirl_record_motion(whirl_rotor_system(rotor), &integrate, &options, start, NULL, &record);
        if (status.code != WHIRL_OK) {
            fprintf(stderr, "%s\n", status.message);
            return 1;
        }
        char regime[64];
        const whirl_verdict verdict = whirl_judge(record);
        whirl_verdict_name(&verdict, regime, sizeof regime);
        printf("%5d rpm: eccentricity ratio up to %.3f, %s\n", rpm, record->max_radius[0], regime);
        whirl_record_free(record);
        whirl_rotor_free(rotor);
    }
    return 0;
}
