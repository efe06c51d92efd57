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
} body_term;

enum { PANEL_ROWS = 4 };

/// A few rows of one kind that have most of their columns in common: a small dense matrix, with zeros where a row has
/// no term, so that each column is read once for all of them.
typedef struct body_panel {
    body_kind kind;
    size_t rows, row[PANEL_ROWS];
    size_t columns;
    size_t first_column; ///< of [columns] in the list of columns
    size_t first_number; ///< of [columns][rows] in the list of numbers
} body_panel;

/// Where panels go; with panels NULL they are only counted.
typedef struct body_panels {
    size_t count, column_count, number_count;
    body_panel *panels;
    unsigned *columns;
    double *numbers;
} body_panels;

typedef struct body {
    size_t count, room;
    body_term *terms;
    bool no_memory; ///< a term was lost
} body;

/// Adds a term; one that is zero is left out.
void body_add(body *to, size_t row, size_t column, body_kind kind, double number);
void body_clear(body *of);

/// Puts the terms in order, row by row and kind by kind, and adds those that belong together. False where one was lost.
bool body_finish(body *of);

/// Gathers the terms, which are in order, into panels. False without memory.
bool body_gather(const body *of, body_panels *to);

/// Below, at or above 0 as one kind comes before, is, or comes after the other.
int body_compare_kinds(body_kind one, body_kind other);

/// The rates of a machine, in the order of body_rate.
void body_rates(double speed, double clock, double rates[RATES]);

#endif
