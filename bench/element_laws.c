#include "element_laws.h"

#include <math.h>
#include <stddef.h>

#define PI 3.14159265358979323846

/// Computes Capone's force of a short film in the direction (A, B), and the angle in his formula; returns sqrt(1 -
/// e^2).
static double short_film(const film_law *film, double x, double y, double A, double B, double *force, double *angle) {
    const double q = 1.0 - x * x - y * y, root = sqrt(q), C = sqrt(A * A + B * B);
    const double ca = -A / C, sa = -B / C, across = y * ca - x * sa, along = x * ca + y * sa;
    *angle = 0.5 * PI + atan(across / root);
    const double G = 2.0 / root * *angle, V = (2.0 + across * G) / q, S = along / (1.0 - along * along);
    const double K = -film->strength * C / q;
    force[0] = K * (3.0 * x * V - sa * G - 2.0 * ca * S);
    force[1] = K * (3.0 * y * V + ca * G - 2.0 * sa * S);
    return root;
}

static double ring_film(const film_law *film, const double *d, const double *w, double speed, double *force) {
    const double over = 1.0 / film->clearance, x = over * d[0], y = over * d[1];
    double angle;
    return short_film(film, x, y, speed * x - 2.0 * over * w[1], speed * y + 2.0 * over * w[0], force, &angle);
}

void ring_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const ring_law *own = law;
    const double speed = s[0] + own->speed;
    const double inner = ring_film(&own->inner, d, w, 1.0 + speed, force);
    const double outer = ring_film(&own->outer, d + 2, w + 2, speed, force + 2);
    slope[0] = own->inner.drag * (1.0 - speed) / inner - own->outer.drag * speed / outer;
}

enum { IN_P = 15, IN_B = 13 }; ///< degrees of the polynomials in p and in b

/// Returns a polynomial in two variables, by Horner's rule. The real part's coefficients, of even powers of p, come
/// first.
static double in_two(const double *coefficients, int first, double p, double b) {
    double row[IN_P + 1], sum = 0.0;
    const double *next = coefficients;
    for (int i = first; i <= IN_P; i += 2) {
        const int count = IN_B * (IN_P - i) / IN_P + 1;
        double of_b = 0.0;
        for (int j = count; j-- > 0;) of_b = of_b * b + next[j];
        next += count;
        row[i] = of_b;
    }
    for (int i = IN_P - (IN_P - first) % 2; i >= first; i -= 2) sum = sum * p * p + row[i];
    return first ? sum * p : sum;
}

/// Returns the number of coefficients of the real part (first: 0) or of the imaginary one (1).
static int count_of(int first) {
    int count = 0;
    for (int i = first; i <= IN_P; i += 2) count += IN_B * (IN_P - i) / IN_P + 1;
    return count;
}

void finite_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const finite_law *own = law;
    const double over = 1.0 / own->film.clearance, x = over * d[0], y = over * d[1];
    const double A = x - 2.0 * over * w[1], B = y + 2.0 * over * w[0];
    double angle, f[2];
    (void)s, (void)slope;
    short_film(&own->film, x, y, A, B, f, &angle);
    const double q = 1.0 - x * x - y * y, z = q < 0.0975 ? 1.0 - q / 0.0975 : 0.0, g = 1.0 - 0.2 * z * z;
    const double p = g * (x * A + y * B) / sqrt(A * A + B * B), b = g * (2.0 / PI * angle - 1.0);
    const double *const even = own->coefficients, *const odd = even + count_of(0), *const under = odd + count_of(1);
    const double R = in_two(even, 0, p, b), I = in_two(odd, 1, p, b), whole = 1.0 + under[0] * p * p + under[1] * b * b;
    force[0] = (R * f[0] - I * f[1]) / whole;
    force[1] = (R * f[1] + I * f[0]) / whole;
}

static double dent(const dent_law *of, double x, double y) {
    const double angle = atan2(y, x);
    if (fabs(angle) > 0.5 * of->width) return 0.0;
    return 0.5 * of->depth * (1.0 + cos(2.0 * PI / of->width * angle));
}

static double all_dents(const rolling_law *own, int ball, const double at[2][2], double x, double y, double angle) {
    double taken = 0.0;
    for (int race = 0; race < 2; race++) {
        const double c = at[race][0], s = at[race][1];
        taken += dent(&own->dents[race], x * c + y * s, y * c - x * s);
    }
    if (ball == 0) {
        const double c = cos(angle), s = sin(angle);
        taken += dent(&own->dents[2], c, s) + dent(&own->dents[2], -c, -s);
    }
    return taken;
}

static void roll(const rolling_law *own, const double *d, const double *s, double at[2][2], double *force) {
    const double c = cos(s[0]), sine = sin(s[0]);
    for (int j = 0; j < own->count; j++) {
        const double *apart = own->apart[j], x = c * apart[0] - sine * apart[1], y = sine * apart[0] + c * apart[1];
        const double r = d[0] * x + d[1] * y;
        double depth = r - own->gap, lever = 1.0;
        if (own->oblique) {
            const double reach = own->radial + r, far = sqrt(reach * reach + own->axial * own->axial);
            depth = far - own->centres;
            lever = reach / far;
        }
        if (own->dented) depth -= all_dents(own, j, at, x, y, s[3]);
        if (!(depth > 0.0)) continue;
        const double push = own->stiffness * lever * (own->line ? pow(depth, 10.0 / 9.0) : depth * sqrt(depth));
        force[0] -= push * x;
        force[1] -= push * y;
    }
}

void rolling_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const rolling_law *own = law;
    double at[2][2] = {{0.0}};
    (void)w;
    for (int race = 0; race < 2 && own->dented; race++) {
        at[race][0] = cos(s[1 + race] + own->dents[race].start);
        at[race][1] = sin(s[1 + race] + own->dents[race].start);
    }
    force[0] = force[1] = 0.0;
    roll(own, d, s, at, force);
    for (int i = 0; i < (own->dented ? 4 : 1); i++) slope[i] = own->rates[i];
}

void seal_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const seal_law *own = law;
    const double square = (d[0] * d[0] + d[1] * d[1]) / (own->clearance * own->clearance);
    double lambda = own->ratio, growth = 1.0;
    (void)s, (void)slope;
    if (own->slowing != 0.0) lambda *= pow(1.0 - sqrt(square), own->slowing);
    if (own->growth != 0.0) growth = pow(1.0 - square, -own->growth);
    const double K = own->stiffness * growth, D = own->damping * growth, m = own->mass;
    force[0] = -((K - m * lambda * lambda) * d[0] + D * lambda * d[1] + D * w[0] + 2.0 * m * lambda * w[1]);
    force[1] = -((K - m * lambda * lambda) * d[1] - D * lambda * d[0] + D * w[1] - 2.0 * m * lambda * w[0]);
}

static double stribeck(const contact_law *own, double slip) {
    const double over = slip / own->stribeck_speed;
    return own->kinetic + own->excess * exp(-over * over);
}

static double rubbing(const contact_law *own, double slip, const double *z, double *rate) {
    if (own->friction == RUB_LUGRE) {
        *rate = slip - own->bristle * fabs(slip) * *z / stribeck(own, slip);
        return own->bristle * *z + own->bristle_damping * *rate;
    }
    const double smooth = slip / sqrt(slip * slip + own->slip_speed * own->slip_speed);
    return smooth * (own->friction == RUB_STRIBECK ? stribeck(own, slip) : own->kinetic);
}

void contact_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const contact_law *own = law;
    const double r = sqrt(d[0] * d[0] + d[1] * d[1]), depth = r - own->gap;
    force[0] = force[1] = 0.0;
    if (own->friction == RUB_LUGRE) slope[0] = -own->bristle / own->bristle_damping * s[0];
    if (!(depth > 0.0)) return;
    double f = 0.0, N = own->stiffness * (own->power == 1.5 ? depth * sqrt(depth) : pow(depth, own->power));
    const double over = 1.0 / r;
    if (own->loss != 0.0) {
        N *= 1.0 + own->loss * (d[0] * w[0] + d[1] * w[1]) * over;
        if (!(N > 0.0)) return;
    }
    if (own->slips) f = rubbing(own, own->surface + (d[0] * w[1] - d[1] * w[0]) * over, s, slope);
    force[0] = -N * over * (d[0] - f * d[1]);
    force[1] = -N * over * (f * d[0] + d[1]);
}

void blade_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const blade_law *own = law;
    const double c = own->length * cos(s[0]), sine = own->length * sin(s[0]);
    (void)w;
    force[0] = force[1] = 0.0;
    slope[0] = 1.0;
    for (int j = 0; j < own->count; j++) {
        const double *apart = own->apart[j];
        const double x = d[0] + c * apart[0] - sine * apart[1], y = d[1] + sine * apart[0] + c * apart[1];
        const double far = sqrt(x * x + y * y), depth = far - own->casing;
        if (!(depth > 0.0)) continue;
        const double push = own->stiffness * (own->power == 1.0 ? depth : pow(depth, own->power)) / far;
        force[0] -= push * (x - own->friction * y);
        force[1] -= push * (y + own->friction * x);
    }
}

static double limited(double current, double most) {
    return fmin(fmax(current, 0.0), most);
}

/// Returns the force along one axis at u, and writes the slopes of its four states.
static double magnet_axis(const magnet_law *own, double u, const double *s, double *slope) {
    const double sensed = s[0];
    slope[0] = own->sensor * (u - sensed);
    // K_p + K_i/p + K_d p/(1 + p T) in observable form.
    const double rate = own->filter, P = own->proportional, I = own->integral, D = own->derivative;
    const double order = s[1] + (P + D * rate) * sensed;
    slope[1] = s[2] + (P * rate + I) * sensed - rate * order;
    slope[2] = I * rate * sensed;
    const double current = -s[3];
    slope[3] = own->amplifier * (order - s[3]);
    const double one = limited(own->bias + current, own->most) / (own->gap - u);
    const double other = limited(own->bias - current, own->most) / (own->gap + u);
    return own->constant * (one * one - other * other);
}

void magnet_force(const void *law, const double *d, const double *w, const double *s, double *force, double *slope) {
    const magnet_law *own = law;
    const double c = own->cosine, sine = own->sine;
    (void)w;
    const double first = magnet_axis(own, c * d[0] + sine * d[1], s, slope);
    const double second = magnet_axis(own, c * d[1] - sine * d[0], s + 4, slope + 4);
    force[0] = c * first - sine * second;
    force[1] = sine * first + c * second;
}
