#include "part.h"

/// Returns the time of the whole system at a time of the part.
static double time_at(const part *p, double t) {
    return p->from + p->stretch * t;
}

static void part_scale(const part *p, size_t count, double *slopes) {
    for (size_t i = 0; i < count; i++) slopes[i] *= p->stretch;
}

static void part_forcing(const void *model, double t, double *out) {
    const part *p = model;
    p->whole->forcing(p->whole->model, time_at(p, t), out);
}

static void part_rhs(const void *model, double t, const double *values, const double *x, double *dxdt) {
    const part *p = model;
    p->whole->rhs(p->whole->model, time_at(p, t), values, x, dxdt);
    part_scale(p, p->whole->dimension, dxdt);
}

static void rhs_on_sides(const void *model, double t, const double *values, const double *x, const double *sides,
                         double *dxdt) {
    const part *p = model;
    p->whole->rhs_on_sides(p->whole->model, time_at(p, t), values, x, sides, dxdt);
    part_scale(p, p->whole->dimension, dxdt);
}

static void part_switches(const void *model, double t, const double *x, double *values) {
    const part *p = model;
    p->whole->switches(p->whole->model, time_at(p, t), x, values);
}

static void part_tangent(const void *model, double t, const double *values, const double *x, const double *sides,
                         size_t count, const double *dx, double *ddxdt) {
    const part *p = model;
    p->whole->tangent(p->whole->model, time_at(p, t), values, x, sides, count, dx, ddxdt);
    part_scale(p, count * p->whole->dimension, ddxdt);
}

static double part_divergence(const void *model, double t, const double *values, const double *x, const double *sides) {
    const part *p = model;
    return p->stretch * p->whole->divergence(p->whole->model, time_at(p, t), values, x, sides);
}

static void switch_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                            double *by_time) {
    const part *p = model;
    p->whole->switch_gradient(p->whole->model, time_at(p, t), x, index, gradient, by_time);
    *by_time *= p->stretch;
}

static void switch_curvature(const void *model, double t, const double *x, size_t index, const double *u, double *out) {
    const part *p = model;
    p->whole->switch_curvature(p->whole->model, time_at(p, t), x, index, u, out);
}

void part_of(part *p, const whirl_system *whole, double from, double length, double stretch) {
    *p = (part){.own = *whole, .whole = whole, .from = from, .stretch = stretch};
    whirl_system *own = &p->own;
    own->period = length;
    own->rhs = part_rhs;
    if (whole->forcing) own->forcing = part_forcing;
    if (whole->switches) own->switches = part_switches;
    if (whole->rhs_on_sides) own->rhs_on_sides = rhs_on_sides;
    if (whole->tangent) own->tangent = part_tangent;
    if (whole->divergence) own->divergence = part_divergence;
    if (whole->switch_gradient) own->switch_gradient = switch_gradient;
    if (whole->switch_curvature) own->switch_curvature = switch_curvature;
    own->contact_count = 0;
    own->contacts = NULL;
    own->model = p;
}
