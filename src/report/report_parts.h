/// Headers of this folder for files that do not yet name those that they use.
#ifndef REPORT_REPORT_PARTS_H
#define REPORT_REPORT_PARTS_H

#include "document.h"
#include "explorer_tables.h"
#include "findings_render.h"
#include "law_range_text.h"
#include "machine_at.h"
#include "regimes.h"
#include "units.h"

#endif
