/// Documents to be printed, from pages.
#ifndef REPORT_PRINT_H
#define REPORT_PRINT_H

#include "whirl/status.h"

/// Makes FOLDER/PDF of FOLDER/PAGE by weasyprint (`program`; NULL: the one on the PATH). WHIRL_MISSING_PROGRAM where
/// that is not there, WHIRL_IO_ERROR where it fails.
whirl_status document_print(const char *program, const char *folder, const char *page, const char *pdf);

#endif
