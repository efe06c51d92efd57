// Reading a result from bytes: what whirl_result_read does once it has them.
#ifndef STORE_READ_H
#define STORE_READ_H

#include "whirl/result.h"

// `name` stands for the file in messages. The bytes are only read. WHIRL_BAD_INPUT for whatever is not a result.
whirl_status read_result(unsigned char *bytes, size_t size, const char *name, whirl_result **result);

#endif
