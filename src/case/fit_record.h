/// Measured numbers of a fit that are a record of a data set.
#ifndef CASE_FIT_RECORD_H
#define CASE_FIT_RECORD_H

#include "fit_table.h"

/// Reads the displacements that a record's proximity probes saw as a table over time, m->table. Adds to m->at the
/// values that the parameters of the case had in the record, unless they are looked for or given; sets m->speed where
/// the speed is no parameter. WHIRL_BAD_INPUT with a sentence, WHIRL_IO_ERROR, WHIRL_NO_MEMORY.
whirl_status fit_record_read(fit_maker *m, const fit_set *set, const char *path, size_t number);

#endif
