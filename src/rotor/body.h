/// What all machines of a block have in common although their speeds differ: linear terms whose numbers are the shaft's
/// own (stiffness, damping, gyroscopic moments in SI), scaled by a few powers of the speed when the machine runs.
///
/// Shafts of finite elements have thousands of such terms. They stand once for all lanes; each lane has but its rates.
#ifndef ROTOR_BODY_H
#define ROTOR_BODY_H

#include <stdbool.h>
#include <stddef.h>

/// What a body's term multiplies.
typedef enum body_source { BODY_PLACE, BODY_VELOCITY, BODY_ONE } body_source;

/// What its number is scaled by when time is tau = clock t.
typedef enum body_rate {
    RATE_STATIC,    ///< 1/clock^2: stiffness, weight
    RATE_DAMPING,   ///< 1/clock
    RATE_GYRO,      ///< speed/clock: moments of velocities, in proportion to the speed
    RATE_FOLLOWING, ///< speed/clock^2: forces of displacements, in proportion to the speed
    RATES
} body_rate;

/// No value of time.
enum { BODY_STEADY = -1 };

/// Where `value` is not BODY_STEADY it is multiplied by that value of time (COS_2TAU, ...), too.
typedef struct body_kind {
    body_source source;
    body_rate rate;
    int value;
} body_kind;

/// The force (N or N m) on coordinate `row` for 1 m or 1 rad of `column`, for its velocity, or by itself.
typedef struct body_term {
    size_t row, column;
    body_kind kind;
    double number;
    size_t run; ///< of the first of those that belong to one sum: how many these are (body_finish)
} body_term;

typedef struct body {
    size_t count, room;
    body_term *terms;
    bool no_memory; ///< a term was lost
} body;

/// Adds a term; one that is zero is left out.
void body_add(body *to, size_t row, size_t column, body_kind kind, double number);
void body_clear(body *of);

/// Puts the terms in order, row by row and kind by kind, adds those that belong together and counts runs. False where
/// one was lost.
bool body_finish(body *of);

/// Below, at or above 0 as one kind comes before, is, or comes after the other.
int body_compare_kinds(body_kind one, body_kind other);

/// The rates of a machine, in the order of body_rate.
void body_rates(double speed, double clock, double rates[RATES]);

#endif
