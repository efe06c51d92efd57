// Any bytes as a result file: refused with a sentence, or a result whose every number is there.
//
// Nearly every change of a byte breaks a checksum of HDF5 and goes no further. So changes are made in place and the
// checksums put right again, as an attacker would (checksums.h); every fourth input is left broken.
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "checksums.h"
#include "read.h"
#include "whirl/engine/result.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

/// HDF5 1.10 loses memory of its own when it meets a wrong checksum.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libhdf5";
}

static void require(int condition) {
    if (!condition) abort();
}

static void require_text(const char *text, size_t size) {
    require(memchr(text, '\0', size) != NULL);
}

/// Reads all numbers of a field, so that the sanitizers see whether they are there.
static double sum_of(const whirl_table *table, size_t point, const whirl_field *field) {
    double sum = 0.0;
    for (size_t which = 0; which < field->repeat; which++) {
        const double *numbers = whirl_table_field(table, point, field->name, which);
        require(numbers != NULL);
        for (size_t i = 0; i < field->rows * field->columns; i++) sum += numbers[i];
    }
    return sum;
}

static void walk_table(const whirl_table *table) {
    static volatile double sink;
    char text[WHIRL_MESSAGE_SIZE];
    double sum = 0.0;
    for (size_t point = 0; point < table->count; point++) {
        require(table->branch[point] >= -1 && table->branch[point] <= 1);
        for (size_t f = 0; f < table->layout.field_count; f++) sum += sum_of(table, point, &table->layout.fields[f]);
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        whirl_verdict_name(&verdict, text, sizeof text);
        whirl_verdict_reason(&verdict, text, sizeof text);
        sum += table->values[point] + whirl_table_done(table, point);
    }
    sink = sum;
    (void)sink;
}

static void walk(const whirl_result *result) {
    require_text(result->title, sizeof result->title);
    require(result->case_text != NULL && strlen(result->case_text) <= 1 << 20);
    for (size_t i = 0; i < result->parameter_count; i++)
        require_text(result->parameters[i].text, sizeof result->parameters[i].text);
    for (size_t i = 0; i < result->station_count; i++) require_text(result->stations[i].name, WHIRL_NAME_SIZE);
    for (size_t i = 0; i < result->contact_count; i++) require_text(result->contacts[i], WHIRL_NAME_SIZE);
    for (size_t i = 0; i < result->fact_count; i++) require_text(result->facts[i].value, sizeof result->facts[i].value);
    for (size_t i = 0; i < result->table_count; i++) walk_table(&result->tables[i]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 16) return 0;
    // A block of just this size, so that reading past its end is seen.
    unsigned char *bytes = malloc(size ? size : 1);
    whirl_result *result = NULL;
    require(bytes != NULL);
    memcpy(bytes, data, size);
    const byte_source source = bytes_of_memory(bytes, size);
    const whirl_status status = read_result(&source, "fuzz.h5", NULL, &result);
    require((status.code == WHIRL_OK) == (result != NULL));
    require(status.code == WHIRL_OK || status.message[0] != '\0');
    if (result) walk(result);
    whirl_result_free(result);
    free(bytes);
    return 0;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed) {
    const checksum_list *sums = checksums_of(data, size);
    if (!sums || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
    // Within one structure, for a change anywhere else would be one of numbers. The length stays, and so do the places.
    for (unsigned change = 0; change < 1 + seed / 4 % 3; change++) {
        const checksum *one = &sums->items[(seed / 12 + 7919u * change) % sums->count];
        uint8_t part[CHECKSUM_MAX];
        memcpy(part, data + one->start, one->length);
        const size_t length = LLVMFuzzerMutate(part, one->length, one->length);
        memcpy(data + one->start, part, length);
    }
    checksums_mend(sums, data);
    return size;
}
