/// Four journals, each by itself in a bearing of five tilting pads with inertia, by RK4 in 1024 steps per revolution:
/// what whirl and a peer in straightforward C have in common.
///
/// Time is tau = speed t, displacements are in clearances; s is the tilt of a pad times radius over clearance. For a
/// pad with its pivot in its middle, at the angle phi, with ' = d/dtau and X, Y the displacements of the journal:
///
///     x = X cos phi + Y sin phi + PADS_PRELOAD,  y = Y cos phi - X sin phi - s,  A = x - 2 y',  B = y + 2 x',
///     f = V/((1 - v^2) (1 - x)^2) S(t, w, alpha),  s'' = -PADS_TILT f_y,  journal: PADS_FORCE f, turned back,
///
/// with t, v, w and the table S of src/rotor/pads/pad_tables.h, V and alpha the size and the direction of (A, B).
#ifndef BENCH_PADS_H
#define BENCH_PADS_H

#define PADS_SPEED 300.0    ///< rad/s
#define PADS_CLEARANCE 1e-4 ///< m, the unit of length
#define PADS_RADIUS 0.025   ///< m
#define PADS_LENGTH 0.025   ///< m
#define PADS_VISCOSITY 0.04 ///< Pa s
#define PADS_MASS 20.0      ///< kg, of a journal
#define PADS_INERTIA 6.5e-4 ///< kg m2
#define PADS_PRELOAD 0.4
#define PADS_GRAVITY 9.81
#define PADS_ARC 1.04719755119659774615
#define PADS_FIRST_PIVOT 0.4
#define PADS_BETWEEN 1.25663706143591729539 ///< angle from pivot to pivot

enum { PADS_JOURNALS = 4, PADS_COUNT = 5 };

#endif
