/// Tables of measured numbers of a fit, and the motion to which each number belongs.
#ifndef CASE_FIT_TABLE_H
#define CASE_FIT_TABLE_H

#include "plan_fit.h"
#include "whirl/internal/csv.h"

enum { FIT_MAX_COLUMNS = 2 + 4 * WHIRL_MAX_PROBES };

/// Contents of a column.
typedef struct fit_column {
    enum { FIT_ANGLE, FIT_TIME, FIT_SPEED, FIT_PARAMETER, FIT_KEYPHASOR, FIT_DISPLACEMENT, FIT_LAG } kind;
    whirl_fit_quantity quantity; ///< quantity of a number without a lag: an amplitude, or a statistic
    size_t station;
    double direction, order; ///< rad; order of vectors
    double size;             ///< SI per unit
    const parameter *parameter;
    size_t lag;   ///< column of the lag of a displacement, or its own column
    double noise; ///< standard deviation of its numbers, m; 1 if it is not given
} fit_column;

/// The lists of a fit while its tables are read.
typedef struct fit_maker {
    case_reader *reader;
    valuation *v;
    const fit_parts *parts;
    whirl_fit fit;
    whirl_fit_motion *motions;
    whirl_fit_number *numbers;
    size_t motion_capacity, number_capacity;
    int revolutions; ///< revolutions of the fit's orbits; 0: there is no fit, samples and orders are those of the table
    bool statistics; ///< the present table is compared by statistics
    whirl_fit_run *run; ///< the present table's run; NULL: motions at one speed
    double checksum;
    // The present table.
    size_t set;
    csv_table table;
    fit_column columns[FIT_MAX_COLUMNS];
    const whirl_given *at; ///< parameters that the table gives
    double speed;          ///< speed of a record where it is no parameter, rad/s; 0: that of the case
    struct {
        bool is;         ///< the present table is the record of a run
        double angle;    ///< rad, of the shaft at its first sample
        double speed;    ///< rad/s, at its first sample
        double duration; ///< s
    } record;
    size_t at_count;
    double noise;                           ///< standard deviation of its numbers, m; 1 if it is not given
    double channel_noise[FIT_MAX_CHANNELS]; ///< standard deviations of fit_set.channels, m
} fit_maker;

/// Reads the table of a file, and adds its motions and numbers. WHIRL_BAD_INPUT with the place of the error, in the
/// case or in the table; WHIRL_NO_MEMORY.
whirl_status fit_table_read(fit_maker *m, const fit_set *set);

/// Reads the bytes of a file that belongs to no fit, as fit_table_read does; `name` is the name of the file in
/// messages. chosen [count]: columns that are read; all if `count` is 0. The caller frees m->table, also after a
/// failure.
whirl_status fit_bytes_read(fit_maker *m, const char *name, const void *bytes, size_t size, const csv_chosen *chosen,
                            size_t count);

#endif
