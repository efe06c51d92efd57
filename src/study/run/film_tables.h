/// The film tables of a study, as a fact of its result.
#ifndef STUDY_FILM_TABLES_H
#define STUDY_FILM_TABLES_H

#include "whirl/engine/study.h"

/// Adds the fact "film tables" (whirl_result_film_tables) to a result of the study. WHIRL_NO_MEMORY.
whirl_status study_add_film_tables(const whirl_study *study, whirl_result *result);

#endif
