// The keys of materials and shafts, and the settings from them.
#include "shafts.h"

#include <math.h>

const material shaft_steel = {.modulus = 2.11e11, .shear_modulus = 8.12e10, .density = 7810.0};

static const whirl_key material_keys[MATERIAL_KEYS] = {
    [MATERIAL_MODULUS] = NUMBER_KEY("modulus", "E", "Pa", DEFAULT("2.11e11"), WHIRL_POSITIVE, "Young's modulus"),
    [MATERIAL_SHEAR_MODULUS] = NUMBER_KEY("shear_modulus", "G", "Pa", DEFAULT("8.12e10"), WHIRL_POSITIVE,
                                          "shear modulus; required with modulus, or poisson in its place"),
    [MATERIAL_POISSON] = NUMBER_KEY("poisson", "nu", "1", OPTIONAL, WHIRL_FROM_TO(0.0, 0.5),
                                    "Poisson's ratio, in place of shear_modulus"),
    [MATERIAL_DENSITY] = NUMBER_KEY("density", "rho", "kg/m3", DEFAULT("7810"), WHIRL_POSITIVE, "density"),
};

const whirl_group material_group = {
    "materials", "a material of shafts; `steel` is predefined", "", material_keys, MATERIAL_KEYS, NULL, NULL};

static const whirl_key shaft_keys[SHAFT_KEYS] = {
    [SHAFT_MATERIAL] =
        NAME_KEY("material", DEFAULT("steel"), "materials", "name of the segments' material in `materials`"),
    [SHAFT_MASS] = CITED_CHOICE_KEY(
        "mass", DEFAULT("consistent"), "consistent|lumped",
        "consistent: the mass moves with the bending between nodes; lumped: half a piece at each of its ends",
        "Friswell et al. 2010, sec. 5.4"),
    [SHAFT_SHEAR] = CITED_CHOICE_KEY("shear", DEFAULT("cowper"), "cowper|hutchinson|none",
                                     "shear factor of hollow circles; none: sections stay square to the axis",
                                     "Cowper 1966; Hutchinson 2001"),
    [SHAFT_ROTARY] =
        CHOICE_KEY("rotary_inertia", DEFAULT("yes"), "yes|no", "yes: sections have inertia against tilting"),
    [SHAFT_GYROSCOPIC] =
        CHOICE_KEY("gyroscopic", DEFAULT("yes"), "yes|no", "yes: the shaft's own inertia causes gyroscopic moments"),
    [SHAFT_RATIO] = NUMBER_KEY("ratio", "rho", "1", DEFAULT("1"), WHIRL_ANY,
                               "speed of the shaft over the rotor's; below 0 against the rotation"),
    [SHAFT_SPEED] = NUMBER_KEY("speed", "", "rad/s", OPTIONAL, WHIRL_ANY,
                               "speed of the shaft if it does not depend on the rotor's, in place of ratio; below 0 "
                               "against the rotation; run-ups let it change by a law or a drive of its own"),
    [SHAFT_TWIST] = CITED_CHOICE_KEY("twist", DEFAULT("no"), "no|yes",
                                     "yes: the shaft twists, with all of its stations and nodes (torsion); no: it is "
                                     "rigid against torsion",
                                     "Friswell et al. 2010, sec. 9.7"),
    [SHAFT_AXIAL] = CITED_CHOICE_KEY("axial", DEFAULT("no"), "no|yes",
                                     "yes: the shaft stretches, and moves along its axis with all of its stations and "
                                     "nodes; no: nothing of it moves along its axis",
                                     "Rao 2007, sec. 9.3"),
    [SHAFT_MASS_DAMPING] = NUMBER_KEY("mass_damping", "alpha", "1/s", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                                      "proportional damping: C = alpha M + beta K of the shaft"),
    [SHAFT_STIFFNESS_DAMPING] =
        NUMBER_KEY("stiffness_damping", "beta", "s", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
                   "proportional damping: beta of mass_damping; it does not turn with the shaft"),
    [SHAFT_VISCOUS] = CITED_NUMBER_KEY(
        "viscous_damping", "eta_V", "s", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
        "viscous internal damping, which turns with the shaft: viscosity of the material divided by its modulus",
        "Zorzi, Nelson 1977"),
    [SHAFT_HYSTERETIC] = CITED_NUMBER_KEY(
        "hysteretic_damping", "eta_H", "1", DEFAULT("0"), WHIRL_NOT_NEGATIVE,
        "hysteretic internal damping, loss factor; for whirl slower than the shaft turns", "Zorzi, Nelson 1977"),
    [SHAFT_MESH_TO] = NUMBER_KEY("mesh_to", "", "Hz", OPTIONAL, WHIRL_POSITIVE,
                                 "highest natural frequency that the mesh resolves to 1e-4; absent: nodes at stations "
                                 "and ends of segments alone"),
    [SHAFT_REDUCE] = CITED_CHOICE_KEY("reduce", DEFAULT("yes"), "yes|no",
                                      "yes: coordinates are the displacements of its stations and the lowest modes "
                                      "between them; no: those of all its nodes",
                                      "Craig, Bampton 1968"),
    [SHAFT_MODES] = WHOLE_KEY("modes", "", DEFAULT("8"), WHIRL_FROM_TO(0, 512),
                              "with reduce: number of modes that are kept in each plane"),
    [SHAFT_MODES_TO] = NUMBER_KEY("modes_to", "", "Hz", OPTIONAL, WHIRL_POSITIVE,
                                  "with reduce: highest frequency of the modes that are kept, in place of modes"),
};

const whirl_group shaft_group = {"shafts",
                                 "a shaft of finite elements, which its segments make up",
                                 "Nelson 1980; Friswell et al. 2010, ch. 5",
                                 shaft_keys,
                                 SHAFT_KEYS,
                                 NULL,
                                 NULL};

whirl_status material_from(const key_value *values, material *out) {
    const key_value *shear = &values[MATERIAL_SHEAR_MODULUS], *poisson = &values[MATERIAL_POISSON];
    *out = (material){values[MATERIAL_MODULUS].number, shear->number, values[MATERIAL_DENSITY].number};
    if (shear->given && poisson->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both shear_modulus and poisson, expected one of them");
    if (values[MATERIAL_MODULUS].given && !shear->given && !poisson->given)
        return whirl_fail(WHIRL_BAD_INPUT, "has a modulus alone, expected shear_modulus or poisson as well");
    if (poisson->given) out->shear_modulus = out->modulus / (2.0 * (1.0 + poisson->number));
    if (!(out->shear_modulus >= out->modulus / 3.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has a shear modulus of %g Pa with a modulus of %g Pa, expected a third of that at least "
                          "(Poisson's ratio up to 0.5)",
                          out->shear_modulus, out->modulus);
    return whirl_ok();
}

whirl_status shaft_settings_from(const key_value *values, shaft_settings *out) {
    *out = (shaft_settings){.lumped = values[SHAFT_MASS].choice == 1,
                            .rotary = values[SHAFT_ROTARY].choice == 0,
                            .gyroscopic = values[SHAFT_GYROSCOPIC].choice == 0,
                            .shear = (shear_law)values[SHAFT_SHEAR].choice,
                            .ratio = values[SHAFT_RATIO].number,
                            .twists = values[SHAFT_TWIST].choice == 1,
                            .axial = values[SHAFT_AXIAL].choice == 1,
                            .alpha = values[SHAFT_MASS_DAMPING].number,
                            .beta = values[SHAFT_STIFFNESS_DAMPING].number,
                            .viscous = values[SHAFT_VISCOUS].number,
                            .hysteretic = values[SHAFT_HYSTERETIC].number,
                            .mesh_to = values[SHAFT_MESH_TO].given ? values[SHAFT_MESH_TO].number : 0.0,
                            .reduced = values[SHAFT_REDUCE].choice == 0,
                            .modes = (size_t)values[SHAFT_MODES].number,
                            .modes_to = values[SHAFT_MODES_TO].given ? values[SHAFT_MODES_TO].number : 0.0};
    if (values[SHAFT_RATIO].given && values[SHAFT_SPEED].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both ratio and speed, expected one of them");
    if (values[SHAFT_MODES].given && values[SHAFT_MODES_TO].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has both modes and modes_to, expected one of them");
    return whirl_ok();
}

shaft_settings segment_settings_from(const key_value *values, const shaft_settings *shaft) {
    shaft_settings own = *shaft;
    if (values[SEGMENT_SHEAR].given) own.shear = (shear_law)values[SEGMENT_SHEAR].choice;
    if (values[SEGMENT_ROTARY].given) own.rotary = values[SEGMENT_ROTARY].choice == 0;
    if (values[SEGMENT_GYROSCOPIC].given) own.gyroscopic = values[SEGMENT_GYROSCOPIC].choice == 0;
    if (values[SEGMENT_MASS_DAMPING].given) own.alpha = values[SEGMENT_MASS_DAMPING].number;
    if (values[SEGMENT_STIFFNESS_DAMPING].given) own.beta = values[SEGMENT_STIFFNESS_DAMPING].number;
    return own;
}
