/// Wall-clock time for progress reports; never part of a result.
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

/// Seconds since some fixed moment; monotonic.
double clock_seconds(void);

/// Sleeps for a millisecond.
void clock_rest(void);

#endif
