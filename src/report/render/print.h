/// Makes documents to be printed from pages.
#ifndef REPORT_PRINT_H
#define REPORT_PRINT_H

#include "whirl/status.h"

/// Makes FOLDER/PDF from FOLDER/PAGE with weasyprint (`program`; NULL: the one on the PATH). Returns
/// WHIRL_MISSING_PROGRAM if that does not exist, WHIRL_IO_ERROR if it fails.
whirl_status document_print(const char *program, const char *folder, const char *page, const char *pdf);

#endif
