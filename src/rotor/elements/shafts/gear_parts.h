/// Kernels and functions of gears, for KERNEL_AXES directions in which their motion closes the teeth: x, y and twist
/// (gear.c); tilts along x and y and the axial displacement as well (gear_helical.c).
#define KERNEL_FILE "elements/shafts/gear_kernel.h"
#define KERNEL_STATES 1
#define KERNEL_FEWER_STATES
#define KERNEL_NUMBERS GEAR_NUMBERS
#define KERNEL_SWITCHES 3
#define KERNEL_SWITCHES_BY_STATES
#define KERNEL_SWITCHES_OF(own) GEAR_SWITCHES(own)
#define KERNEL_CURVED
#define KERNEL_TILTS

/// Bits of the law: with play; with a changing number of pairs in contact, and so a changing stiffness; with an error;
/// with a profile of the stiffness. The rest of the law is the number of harmonics of the profile.
enum { GEAR_PLAY = 1, GEAR_PAIRS = 2, GEAR_ERROR = 4, GEAR_PROFILE = 8, GEAR_LAWS = 16 };

/// GEAR_PHASES: number of phases of the mesh over which linear analyses take means. GEAR_HARMONICS: maximum number of
/// harmonics of a profile; up to it the mean over these phases is exact.
enum { GEAR_PHASES = 16, GEAR_HARMONICS = GEAR_PHASES - 1 };

#define GEAR_SWITCHES(own) (((own)->law & GEAR_PLAY ? 2 : 0) + ((own)->law & GEAR_PAIRS ? 1 : 0))

/// Numbers, in newtons and length scales: the line of action along x and y; half the share of more pairs, rad of psi;
/// the error by cos psi and by -sin psi; psi'; levers of the force about the axes of both gears, m; a length scale in
/// m.
enum {
    GEAR_ALONG_X,
    GEAR_ALONG_Y,
    GEAR_STIFFNESS,
    GEAR_STIFFNESS_LESS,
    GEAR_DAMPING,
    GEAR_GAP,
    GEAR_SHARE,
    GEAR_ERROR_COS,
    GEAR_ERROR_SIN,
    GEAR_RATE,
    GEAR_LEVER,
    GEAR_LEVER_SECOND,
    GEAR_LENGTH,
    GEAR_PARTS, ///< stiffness by cos n psi, then by sin n psi, of every harmonic
    GEAR_NUMBERS = GEAR_PARTS + 2 * GEAR_HARMONICS
};

/// Ports of a gear after x and y.
enum { GEAR_TWIST = 2, GEAR_TILT_X, GEAR_TILT_Y, GEAR_AXIAL };

#include "generic.h"
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

static const double pi = 3.14159265358979323846;

/// Returns the stiffness of a mesh at its phase psi, as its kernel computes it.
static double gear_stiffness_at(const element *own, double psi) {
    const double *n = own->number;
    double sum = n[GEAR_STIFFNESS];
    if (own->law & GEAR_PAIRS) return cos(psi - n[GEAR_SHARE]) > cos(n[GEAR_SHARE]) ? sum : n[GEAR_STIFFNESS_LESS];
    for (int k = 0; k < own->law / GEAR_LAWS; k++)
        sum += n[GEAR_PARTS + k] * cos((k + 1) * psi) + n[GEAR_PARTS + GEAR_HARMONICS + k] * sin((k + 1) * psi);
    return sum;
}

static double gear_rounds(const element *own, size_t state) {
    (void)state;
    return own->number[GEAR_RATE];
}

/// Finds the force of the mesh, as its kernel computes it.
static void gear_carry(const element *own, const element_place *at, element_carried *out) {
    const double *n = own->number, along[] = {n[GEAR_ALONG_X], n[GEAR_ALONG_Y], 1.0, 1.0, 1.0, 1.0};
    const double cosine = cos(at->s[0]), sine = sin(at->s[0]);
    const bool errs = own->law & GEAR_ERROR;
    *out = (element_carried){.unit = n[GEAR_LENGTH], .damping = n[GEAR_DAMPING]};
    double closing = 0.0, rate = 0.0;
    for (size_t port = 0; port < (size_t)KERNEL_PORTS; port++) {
        const size_t a = port % KERNEL_AXES;
        out->closing[port] = (port < KERNEL_AXES ? 1.0 : -1.0) * along[a] * unit_of(own, (int)port);
        closing += out->closing[port] * at->q[port];
        rate += out->closing[port] * at->v[port];
    }
    for (size_t i = 0; i < 2; i++) out->lever[i] = n[GEAR_LEVER + i];
    if (errs) {
        out->error_order = n[GEAR_RATE];
        out->error[0] = n[GEAR_ERROR_COS];
        out->error[1] = n[GEAR_ERROR_SIN];
        closing -= n[GEAR_ERROR_COS] * cosine - n[GEAR_ERROR_SIN] * sine;
        rate += n[GEAR_RATE] * (n[GEAR_ERROR_COS] * sine + n[GEAR_ERROR_SIN] * cosine);
    }
    // The stiffness is the mean that linear analyses use: over the phases from that of the state on.
    for (int k = 0; k < GEAR_PHASES; k++)
        out->stiffness += gear_stiffness_at(own, at->s[0] + 2.0 * pi * k / GEAR_PHASES) / GEAR_PHASES;
    const double gap = own->law & GEAR_PLAY ? n[GEAR_GAP] : 0.0;
    out->open = (own->law & GEAR_PLAY) && fabs(closing) <= gap;
    out->play = gap;
    if (!out->open)
        out->force = gear_stiffness_at(own, at->s[0]) * (closing - copysign(gap, closing)) + n[GEAR_DAMPING] * rate;
}

/// Returns true if the force may jump: the stiffness jumps, or a damper acts where teeth meet.
static bool gear_jumps(const element *own) {
    return (own->law & GEAR_PAIRS) || ((own->law & GEAR_PLAY) && own->number[GEAR_DAMPING] > 0.0);
}

static bool gear_touches(const element *own, size_t index) {
    return (own->law & GEAR_PLAY) && index == 0;
}

/// Computes the second derivatives, which are by psi alone: those of the error, and of the share of more pairs.
static void gear_curvature(const element *own, const element_place *at, size_t index, const element_place *along,
                           element_place *by) {
    const double c = cos(at->s[0]), s = sin(at->s[0]);
    *by = (element_place){.q = {0.0}};
    if ((own->law & GEAR_PLAY) && index < 2) {
        if (own->law & GEAR_ERROR)
            by->s[0] = along->s[0] * (own->number[GEAR_ERROR_COS] * c - own->number[GEAR_ERROR_SIN] * s);
    } else {
        by->s[0] = -along->s[0] * cos(at->s[0] - own->number[GEAR_SHARE]);
    }
}

static bool gear_named_order(const element *own, size_t index, double *order, const char **name) {
    *order = own->number[GEAR_RATE];
    *name = "mesh";
    return index == 0 && own->states > 0;
}

/// Members of an element_type that all gears have.
#define GEAR_TYPE                                                                                                      \
    .number_count = KERNEL_NUMBERS + 2 * KERNEL_PORTS, .kernels = kernels, GENERIC_SWITCHES,                           \
    .switch_curvature = gear_curvature, .touches = gear_touches, .jumps = gear_jumps, .carry = gear_carry,             \
    .carries_as = WHIRL_TORQUE_MESH

/// Additional members of a gear whose mesh varies: the phase of the mesh is a state.
#define GEAR_TURNING .state_count = KERNEL_STATES, .turning = 1, .rounds = gear_rounds, .named_order = gear_named_order

/// Gears whose tilts and axial displacements close the teeth, too; with a mesh that varies.
extern const element_type gear_helical, gear_helical_turning;

/// Fills in the conversions of forces and units for helical gears, as generic_tilts (generic.h) does for other gears.
void gear_helical_scale(element *own, const assembly *to);
#endif
