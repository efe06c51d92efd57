/// Linear terms that all machines of a block share although their speeds differ: numbers of the shaft (stiffness,
/// damping, gyroscopic moments in SI) that are scaled by powers of the speed when the machine runs.
///
/// Shafts of finite elements have thousands of such terms. They are stored once for all lanes; each lane has only its
/// rates.
#ifndef ROTOR_BODY_H
#define ROTOR_BODY_H

#include <stdbool.h>
#include <stddef.h>

/// Factor of the number of a body's term.
typedef enum body_source { BODY_PLACE, BODY_VELOCITY, BODY_ONE } body_source;

/// Rates that scale a body's numbers when time is tau = clock t. Each rate is the next one times a factor that is
/// finite at every speed, so that the sum over the rates can use Horner's scheme.
typedef enum body_rate {
    RATE_GYRO,      ///< speed/clock: terms of velocities, proportional to the speed (gyroscopic moments)
    RATE_FOLLOWING, ///< speed/clock^2: terms of displacements, proportional to the speed (viscous internal damping)
    RATE_DAMPING,   ///< 1/clock
    RATE_STATIC,    ///< 1/clock^2: stiffness, weight
    RATES
} body_rate;

/// Marks terms that do not depend on time.
enum { BODY_STEADY = -1 };

/// Kind of a term. If `value` is not BODY_STEADY, the term is also multiplied by this number of the forcing (COS_2TAU,
/// ...).
typedef struct body_kind {
    body_source source;
    body_rate rate;
    int value;
} body_kind;

/// The force (N or N m) on coordinate `row` by 1 m or 1 rad of `column`, by its velocity, or constant.
typedef struct body_term {
    size_t row, column;
    body_kind kind;
    double number;
} body_term;

enum { PANEL_ROWS = 8 };

/// The terms of one kind in a panel: columns that all rows share, with zeros for rows without a term, then columns of
/// single rows.
typedef struct body_part {
    body_kind kind;
    size_t common, lone; ///< number of shared columns; number of columns of each row alone
    size_t first_column; ///< first of [common], then [lone][rows], in the list of columns
    size_t first_number; ///< first of [common + lone][rows] in the list of numbers
} body_part;

/// A few rows that share most of their columns, so that each column is read once for all of them and their sums stay in
/// registers. A panel contains the terms of one value of the forcing, part by part in the order of the rates.
typedef struct body_panel {
    int value;
    bool begins; ///< the panel's sums are the first contributions to its rows
    size_t rows, row[PANEL_ROWS];
    size_t part_count, first_part;
} body_panel;

/// Storage of panels. With `panels` NULL they are only counted.
typedef struct body_panels {
    size_t count, part_count, column_count, number_count;
    body_panel *panels;
    body_part *parts;
    unsigned *columns;
    double *numbers; ///< followed by PANEL_ROWS more in a rotor, which kernels may read
} body_panels;

/// Returns the column with index c of row r: shared columns come first, then those of the row alone.
static inline size_t body_column(const body_panels *in, const body_part *part, size_t rows, size_t c, size_t r) {
    return in->columns[part->first_column + (c < part->common ? c : part->common + (c - part->common) * rows + r)];
}

typedef struct body {
    size_t count, capacity;
    body_term *terms;
    bool no_memory; ///< a term was lost
} body;

/// Adds a term, unless it is zero.
void body_add(body *to, size_t row, size_t column, body_kind kind, double number);
void body_clear(body *of);

/// Sorts the terms by row and kind, and merges terms of one row, column and kind. Returns false if a term was lost for
/// lack of memory.
bool body_finish(body *of);

/// Gathers the sorted terms into panels. Returns false without memory.
bool body_gather(const body *of, body_panels *to);

/// Finds the smallest row r >= first for which the rows r to rows - 1 each get a first contribution from some panel,
/// and marks these panels (`begins`). Returns r; `rows` if there is none.
size_t body_begin(body_panels *of, size_t first, size_t rows);

/// Returns true if both are the same, to the bit.
bool body_alike(const body_panels *one, const body_panels *other);

/// Orders kinds: negative, 0 or positive.
int body_compare_kinds(body_kind one, body_kind other);

/// Number of quotients of rates: each rate divided by each later one, and each rate itself.
enum { BODY_STEPS = RATES * (RATES + 1) / 2 };

/// Computes these quotients at a speed and a clock, rad/s. Their order is that of body_step.
void body_rates(double speed, double clock, double steps[BODY_STEPS]);

/// Returns the index of the quotient of a rate and a later one; with RATES as the later one, of the rate itself.
static inline size_t body_step(body_rate rate, body_rate later) {
    return rate * (2 * RATES + 1 - rate) / 2 + later - rate - 1;
}

#endif
