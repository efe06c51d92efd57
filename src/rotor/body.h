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

/// What its number is scaled by when time is tau = clock t. Each rate is the next one's times a number that no speed
/// makes infinite, so that a sum over all of them is taken by Horner's scheme.
typedef enum body_rate {
    RATE_GYRO,      ///< speed/clock: moments of velocities, in proportion to the speed
    RATE_FOLLOWING, ///< speed/clock^2: forces of displacements, in proportion to the speed
    RATE_DAMPING,   ///< 1/clock
    RATE_STATIC,    ///< 1/clock^2: stiffness, weight
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

enum { PANEL_ROWS = 8 };

/// What the rows of a panel take of one kind: columns that they have in common, with zeros where a row has no term, and
/// columns that each has alone.
typedef struct body_part {
    body_kind kind;
    size_t common, lone; ///< columns; of each row
    size_t first_column; ///< of [common], then [lone][rows], in the list of columns
    size_t first_number; ///< of [common + lone][rows] in the list of numbers
} body_part;

/// A few rows that have most of their columns in common, so that each column is read once for all of them and their
/// sums stay at hand. All that depends on one value of time, part by part as the rates follow one another.
typedef struct body_panel {
    int value;
    bool begins; ///< its sums are the first that its rows are given
    size_t rows, row[PANEL_ROWS];
    size_t part_count, first_part;
} body_panel;

/// Where panels go; with panels NULL they are only counted.
typedef struct body_panels {
    size_t count, part_count, column_count, number_count;
    body_panel *panels;
    body_part *parts;
    unsigned *columns;
    double *numbers;
} body_panels;

/// Column c, of the common ones and then of those of row r alone.
static inline size_t body_column(const body_panels *in, const body_part *part, size_t rows, size_t c, size_t r) {
    return in->columns[part->first_column + (c < part->common ? c : part->common + (c - part->common) * rows + r)];
}

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

/// Has the last rows of `rows`, but none before `first`, begun by panels; says from where on they are.
size_t body_begin(body_panels *of, size_t first, size_t rows);

/// Whether they are the same, to the bit.
bool body_alike(const body_panels *one, const body_panels *other);

/// Below, at or above 0 as one kind comes before, is, or comes after the other.
int body_compare_kinds(body_kind one, body_kind other);

/// A machine's numbers: each rate over all that come later, and as it is.
enum { BODY_STEPS = RATES * (RATES + 1) / 2 };
void body_rates(double speed, double clock, double steps[BODY_STEPS]);

/// Where a rate over one that comes later is among them; over RATES the rate itself.
static inline size_t body_step(body_rate rate, body_rate later) {
    return rate * (2 * RATES + 1 - rate) / 2 + later - rate - 1;
}

#endif
