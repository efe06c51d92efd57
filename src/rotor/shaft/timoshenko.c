// The matrices of a piece of a shaft, by quadrature. They are exact for cylinders, and to rounding for cones.
#include "shafts.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- cross-sections

typedef struct section {
    double area, second[2]; ///< m2, m4: across flats, and along their normal
    double shear;           ///< shear factor; 0: nothing shears
} section;

/// Computes the area and moments of what two flats leave of a circle (integrals over the strip between them).
static void cut_flats(double outer, double flats, section *out) {
    const double radius = 0.5 * outer, fourth = radius * radius * radius * radius;
    const double s = flats < outer ? asin(flats / outer) : 0.5 * pi;
    out->area = radius * radius * (2.0 * s + sin(2.0 * s));
    out->second[0] = fourth * (s / 2.0 + sin(2.0 * s) / 3.0 + sin(4.0 * s) / 24.0);
    out->second[1] = fourth * (s / 2.0 - sin(4.0 * s) / 8.0);
}

/// Returns the shear factor for r = inner/outer (Cowper 1966, table 1; Hutchinson 2001, eq. 49).
static double shear_factor(shear_law law, double r, double nu) {
    const double r2 = r * r, r4 = r2 * r2;
    if (law == SHEAR_NONE) return 0.0;
    if (law == SHEAR_COWPER)
        return 6.0 * (1.0 + nu) * (1.0 + r2) * (1.0 + r2) /
               ((7.0 + 6.0 * nu) * (1.0 + r2) * (1.0 + r2) + (20.0 + 12.0 * nu) * r2);
    return 6.0 * (1.0 + r2) * (1.0 + r2) * (1.0 + nu) * (1.0 + nu) /
           (7.0 + 34.0 * r2 + 7.0 * r4 + nu * (12.0 + 48.0 * r2 + 12.0 * r4) + nu * nu * (4.0 + 16.0 * r2 + 4.0 * r4));
}

static section section_at(const shaft_piece *piece, double at) {
    const double outer = piece->outer[0] + at * (piece->outer[1] - piece->outer[0]);
    const double inner = piece->inner[0] + at * (piece->inner[1] - piece->inner[0]);
    const double bore = pi / 64.0 * inner * inner * inner * inner;
    const double nu = piece->of.modulus / (2.0 * piece->of.shear_modulus) - 1.0;
    section out = {.area = pi / 4.0 * outer * outer, .shear = shear_factor(piece->shear, inner / outer, nu)};
    out.second[0] = out.second[1] = pi / 64.0 * outer * outer * outer * outer;
    if (piece->flats > 0.0) cut_flats(outer, piece->flats, &out);
    out.area -= pi / 4.0 * inner * inner;
    out.second[0] -= bore;
    out.second[1] -= bore;
    return out;
}

double piece_line_mass(const shaft_piece *piece, double at) {
    return piece->of.density * section_at(piece, at).area;
}

double piece_bending(const shaft_piece *piece, double at) {
    return piece->of.modulus * section_at(piece, at).second[1];
}

// ---------------------------------------------------------------- between the ends

enum { NODES = 16 }; ///< nodes of Gauss and Legendre's quadrature, exact up to degree 31

static const double node[NODES] = {
    0.0052995325041750333, 0.02771248846338371, 0.067184398806084122, 0.12229779582249849,
    0.19106187779867811,   0.27099161117138632, 0.35919822461037054,  0.45249374508118129,
    0.54750625491881877,   0.64080177538962946, 0.72900838882861374,  0.80893812220132189,
    0.87770220417750155,   0.93281560119391582, 0.9722875115366163,   0.99470046749582497};
static const double weight[NODES] = {
    0.013576229705877048, 0.031126761969323947, 0.047579255841246393, 0.062314485627766938,
    0.074797994408288368, 0.084578259697501268, 0.091301707522461792, 0.094725305227534251,
    0.094725305227534251, 0.091301707522461792, 0.084578259697501268, 0.074797994408288368,
    0.062314485627766938, 0.047579255841246393, 0.031126761969323947, 0.013576229705877048};

/// Compliance of the piece up to z: integrals over s from 0 to z, for the bending moment M = a + b s and the shear
/// force -b.
typedef struct compliance {
    double turn[2];   ///< integrals of 1/EI and s/EI: the slope
    double bow[2];    ///< integrals of (z - s)/EI and (z - s) s/EI: the displacement
    double square;    ///< integral of s^2/EI
    double slip;      ///< integral of 1/(kappa G A)
    double slip_rate; ///< 1/(kappa G A) at z
} compliance;

static double slip_of(const shaft_piece *piece, const section *at) {
    return at->shear > 0.0 ? 1.0 / (at->shear * piece->of.shear_modulus * at->area) : 0.0;
}

static compliance compliance_to(const shaft_piece *piece, int plane, double z) {
    compliance c = {.slip = 0.0};
    for (int i = 0; i < NODES; i++) {
        const double s = z * node[i], part = z * weight[i];
        const section at = section_at(piece, s / piece->length);
        const double bend = part / (piece->of.modulus * at.second[plane]);
        c.turn[0] += bend;
        c.turn[1] += bend * s;
        c.bow[0] += bend * (z - s);
        c.bow[1] += bend * (z - s) * s;
        c.square += bend * s * s;
        c.slip += part * slip_of(piece, &at);
    }
    const section end = section_at(piece, z / piece->length);
    c.slip_rate = slip_of(piece, &end);
    return c;
}

/// The moment M = a + b z caused by one unit of each coordinate.
typedef struct moments {
    double a[4], b[4];
} moments;

static moments moments_of(const compliance *whole, double length) {
    const double turned[4] = {0.0, -1.0, 0.0, 1.0}, moved[4] = {-1.0, -length, 1.0, 0.0};
    const double across = whole->bow[1] - whole->slip;
    const double determinant = whole->turn[0] * across - whole->turn[1] * whole->bow[0];
    moments m;
    for (int i = 0; i < 4; i++) {
        m.a[i] = (turned[i] * across - moved[i] * whole->turn[1]) / determinant;
        m.b[i] = (whole->turn[0] * moved[i] - whole->bow[0] * turned[i]) / determinant;
    }
    return m;
}

/// Adds twice the energy of unit displacements of coordinates i and j.
static void add_stiffness(const moments *m, const compliance *whole, matrix4 *out) {
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            out->at[i][j] = m->a[i] * m->a[j] * whole->turn[0] +
                            (m->a[i] * m->b[j] + m->b[i] * m->a[j]) * whole->turn[1] +
                            m->b[i] * m->b[j] * (whole->square + whole->slip);
}

/// Computes displacement, slope of the sections and slope of the axis at z, for one unit of each coordinate.
static void shapes_at(const moments *m, const compliance *to, double z, double moved[4], double turned[4],
                      double leant[4]) {
    for (int i = 0; i < 4; i++) {
        turned[i] = (i == 1 ? 1.0 : 0.0) + m->a[i] * to->turn[0] + m->b[i] * to->turn[1];
        moved[i] = (i == 0 ? 1.0 : 0.0) + (i == 1 ? z : 0.0) + m->a[i] * to->bow[0] + m->b[i] * (to->bow[1] - to->slip);
        leant[i] = turned[i] - m->b[i] * to->slip_rate;
    }
}

static void add_outer(matrix4 *out, double factor, const double shape[4]) {
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) out->at[i][j] += factor * shape[i] * shape[j];
}

/// Adds the slice of length `part` at z.
static void add_slice(const shaft_piece *piece, const moments *m, double z, double part, piece_matrices *out) {
    double moved[4], turned[4], leant[4];
    const compliance to = compliance_to(piece, 0, z);
    const section at = section_at(piece, z / piece->length);
    const double density = piece->of.density, mass = part * density * at.area;
    const double rotary = piece->rotary ? part * density * 0.5 * (at.second[0] + at.second[1]) : 0.0;
    const double share[2] = {1.0 - z / piece->length, z / piece->length};
    shapes_at(m, &to, z, moved, turned, leant);
    add_outer(&out->mass, mass, moved);
    add_outer(&out->mass, rotary, turned);
    add_outer(&out->polar, 2.0 * rotary, turned);
    add_outer(&out->axial, part * (piece->axial[0] + share[1] * (piece->axial[1] - piece->axial[0])), leant);
    for (int i = 0; i < 4; i++) out->weight[i] += mass * moved[i];
    for (int end = 0; end < 2; end++) {
        out->lumped_mass[end] += share[end] * mass;
        out->lumped_diametral[end] += share[end] * (rotary + mass * piece->length * piece->length / 12.0);
        out->lumped_polar[end] += share[end] * 2.0 * rotary;
    }
}

/// Returns the polar second moment of a round section, m4, which resists twist (Saint-Venant 1855).
static double section_polar(const section *at) {
    return at->second[0] + at->second[1];
}

static double section_area(const section *at) {
    return at->area;
}

/// Computes the matrices against twist or along the axis, of the modulus times a property of the sections. The
/// displacement of a section is the share of the whole flexibility that is to its left.
static void fill_line(const shaft_piece *piece, double modulus, double (*property)(const section *at),
                      line_matrices *out) {
    double whole = 0.0;
    for (int i = 0; i < NODES; i++) {
        const section at = section_at(piece, piece->length * node[i] / piece->length);
        whole += piece->length * weight[i] / (modulus * property(&at));
    }
    for (int i = 0; i < NODES; i++) {
        const double z = piece->length * node[i];
        double left = 0.0;
        for (int k = 0; k < NODES; k++) {
            const section before = section_at(piece, z * node[k] / piece->length);
            left += z * weight[k] / (modulus * property(&before));
        }
        const section at = section_at(piece, node[i]);
        const double moved = left / whole, inertia = piece->length * weight[i] * piece->of.density * property(&at);
        out->inertia[0] += inertia * (1.0 - moved) * (1.0 - moved);
        out->inertia[1] += inertia * (1.0 - moved) * moved;
        out->inertia[2] += inertia * moved * moved;
    }
    out->stiffness = 1.0 / whole;
}

void piece_fill(const shaft_piece *piece, piece_matrices *out) {
    *out = (piece_matrices){.weight = {0.0}};
    moments m[2];
    for (int plane = 0; plane < 2; plane++) {
        const compliance whole = compliance_to(piece, plane, piece->length);
        m[plane] = moments_of(&whole, piece->length);
        add_stiffness(&m[plane], &whole, &out->stiffness[plane]);
    }
    for (int i = 0; i < NODES; i++) add_slice(piece, &m[0], piece->length * node[i], piece->length * weight[i], out);
    fill_line(piece, piece->of.shear_modulus, section_polar, &out->twist);
    fill_line(piece, piece->of.modulus, section_area, &out->stretch);
}

void piece_shape(const shaft_piece *piece, double at, double moved[4]) {
    double turned[4], leant[4];
    const compliance whole = compliance_to(piece, 0, piece->length), to = compliance_to(piece, 0, at * piece->length);
    const moments m = moments_of(&whole, piece->length);
    shapes_at(&m, &to, at * piece->length, moved, turned, leant);
}
