/// Numbers of the validation cases with which more than one program is compared.
#ifndef SUPPORT_CASES_H
#define SUPPORT_CASES_H

/// B2: largest modulus of a multiplier per revolution of a shaft with m = 1, k1 = .8, k2 = 1.2 and no damping.
static const struct {
    double speed;
    const char *derived, *printed; ///< with the signs of a shaft that turns, and those of the 2015 paper
} case_b2[] = {{0.9, "1.257484822459", "1.000000000"},
               {1.0, "1.872990869329", "1.557766085"},
               {1.09, "1.205916208597", "1.000000000"}};
enum { CASE_B2_ROWS = sizeof case_b2 / sizeof *case_b2 };

/// C2: radius of the synchronous full annular rub, and its largest real part.
static const struct {
    double speed;
    const char *radius, *growth, *name;
} case_c2[] = {{1.0, "1.078622962500", "-.014538323", "w = 1"},
               {1.2, "1.381926301669", "-.008521731", "w = 1.2, upper branch"},
               {1.2, "1.129114707795", "+.130297887", "w = 1.2, lower branch"}};
enum { CASE_C2_ROWS = sizeof case_c2 / sizeof *case_c2 };

/// x'' + (a - 2 q cos 2t) x = 0.
typedef struct mathieu {
    double a, q;
} mathieu;

/// D3: trace of the monodromy over pi.
static const struct {
    mathieu m;
    const char *trace;
} case_d3[] = {{{1.0, 0.5}, "-2.612418906625"}, {{2.0, 0.5}, "-.797128628431"}, {{4.0, 1.0}, "2.021314397417"}};
enum { CASE_D3_ROWS = sizeof case_d3 / sizeof *case_d3 };

#endif
