#include "oil.h"

#include "mineral_oil.h"

static const char *const names[OIL_KEYS] = {[OIL_DYNAMIC] = "viscosity",       [OIL_KINEMATIC] = "kinematic_viscosity",
                                            [OIL_DENSITY] = "density",         [OIL_GRADE] = "grade",
                                            [OIL_HOT] = "kinematic_100",       [OIL_TEMPERATURES] = "temperatures",
                                            [OIL_VISCOSITIES] = "viscosities", [OIL_TEMPERATURE] = "temperature"};
static const int ways[] = {OIL_DYNAMIC, OIL_KINEMATIC, OIL_GRADE, OIL_TEMPERATURES};

bool oil_given(const oil *of) {
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++)
        if (of->keys[ways[i]].given) return true;
    return false;
}

/// Finds the only way in which the viscosity is given.
static whirl_status way_of(const oil *of, int *way) {
    int count = 0;
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        if (!of->keys[ways[i]].given) continue;
        if (count++ > 0)
            return whirl_fail(WHIRL_BAD_INPUT, "has both %s and %s, expected one of them", names[*way], names[ways[i]]);
        *way = ways[i];
    }
    if (count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "has no viscosity, expected one, or kinematic_viscosity and density, or "
                                           "grade, temperature and density");
    return whirl_ok();
}

/// Rejects keys that belong to another way of giving the viscosity.
static whirl_status check_strays(const oil *of, int way) {
    const bool warm = way == OIL_GRADE || way == OIL_TEMPERATURES;
    if (of->keys[OIL_TEMPERATURE].given && !warm)
        return whirl_fail(WHIRL_BAD_INPUT, "has a temperature and %s, expected grade or temperatures with it",
                          names[way]);
    if (of->keys[OIL_HOT].given && way != OIL_GRADE)
        return whirl_fail(WHIRL_BAD_INPUT, "has kinematic_100 without a grade, expected that of the oil, too");
    if (of->keys[OIL_VISCOSITIES].given != (way == OIL_TEMPERATURES))
        return whirl_fail(WHIRL_BAD_INPUT, "has temperatures or viscosities alone, expected both");
    if (warm && !of->keys[OIL_TEMPERATURE].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s without a temperature, expected that of the film, too", names[way]);
    if (way != OIL_DYNAMIC && !of->keys[OIL_DENSITY].given)
        return whirl_fail(WHIRL_BAD_INPUT, "has %s without a density, expected that of the oil, too", names[way]);
    return whirl_ok();
}

static whirl_status by_grade(const oil *of, double *kinematic) {
    static const double temperatures[] = {OIL_40_DEGREES, OIL_100_DEGREES};
    const double own = of->keys[OIL_GRADE].number * 1e-6;
    const double hot = of->keys[OIL_HOT].given ? of->keys[OIL_HOT].number : mineral_oil_at_100(own);
    const double viscosities[] = {own, hot};
    if (!(hot < own))
        return whirl_fail(WHIRL_BAD_INPUT, "has a kinematic_100 of %g mm2/s, expected less than at 40 degC, %g",
                          hot * 1e6, own * 1e6);
    *kinematic = mineral_oil_viscosity(temperatures, viscosities, 2, of->keys[OIL_TEMPERATURE].number);
    return whirl_ok();
}

static whirl_status by_table(const oil *of, double *kinematic) {
    const key_value *rows = &of->keys[OIL_TEMPERATURES], *values = &of->keys[OIL_VISCOSITIES];
    double viscosities[WHIRL_MAX_LIST];
    if (rows->count < 2 || rows->count != values->count || rows->rows > 1 || values->rows > 1)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %zu temperatures and %zu viscosities, expected equal numbers, two or more", rows->count,
                          values->count);
    for (size_t i = 0; i < rows->count; i++) {
        viscosities[i] = values->list[i] / of->keys[OIL_DENSITY].number;
        if (i > 0 && !(rows->list[i] > rows->list[i - 1] && values->list[i] < values->list[i - 1]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "has a viscosity of %g Pa s at %g K after %g at %g K, expected one that falls as "
                              "temperatures rise",
                              values->list[i], rows->list[i], values->list[i - 1], rows->list[i - 1]);
    }
    *kinematic = mineral_oil_viscosity(rows->list, viscosities, rows->count, of->keys[OIL_TEMPERATURE].number);
    return whirl_ok();
}

whirl_status oil_viscosity(const oil *of, double *viscosity) {
    int way = OIL_DYNAMIC;
    double kinematic = of->keys[OIL_KINEMATIC].number;
    whirl_status status = way_of(of, &way);
    if (status.code == WHIRL_OK) status = check_strays(of, way);
    if (status.code == WHIRL_OK && way == OIL_GRADE) status = by_grade(of, &kinematic);
    if (status.code == WHIRL_OK && way == OIL_TEMPERATURES) status = by_table(of, &kinematic);
    if (status.code == WHIRL_OK)
        *viscosity = way == OIL_DYNAMIC ? of->keys[OIL_DYNAMIC].number : kinematic * of->keys[OIL_DENSITY].number;
    return status;
}

double oil_reynolds(const oil *of, double speed, double length) {
    double viscosity;
    if (!of->keys[OIL_DENSITY].given || oil_viscosity(of, &viscosity).code != WHIRL_OK) return 0.0;
    return of->keys[OIL_DENSITY].number * speed * length * length / viscosity;
}
