#include "image.h"

#include "plain.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    GROWTH = 1 << 20, // bytes by which a file in memory grows

    // HDF5 File Format Specification 3.0, III.A, superblock version 3; all addresses are of 8 bytes.
    SUPERBLOCK_VERSION = 8,
    SUPERBLOCK_OFFSET_SIZE = 9,
    SUPERBLOCK_END_OF_FILE = 28,
    SUPERBLOCK_SIZE = 48
};

// HDF5 looks whether there is a file of the name that a file in memory has; of this one there cannot be.
#define NO_PATH "/dev/null/whirl"

image_errors image_quiet(void) {
    image_errors errors = {0};
    H5Eget_auto2(H5E_DEFAULT, &errors.function, &errors.data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return errors;
}

void image_loud(image_errors errors) {
    H5Eset_auto2(H5E_DEFAULT, errors.function, errors.data);
}

typedef struct reason {
    char *text;
    size_t size;
} reason;

static herr_t innermost(unsigned depth, const H5E_error2_t *error, void *data) {
    const reason *to = data;
    if (depth == 0) snprintf(to->text, to->size, "%s", error->desc ? error->desc : "no reason given");
    return 0;
}

void image_reason(char *text, size_t size) {
    reason to = {text, size};
    snprintf(text, size, "no reason given");
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &to);
}

static uint64_t little_endian(const unsigned char *bytes) {
    uint64_t value = 0;
    for (int i = 7; i >= 0; --i) value = value << 8 | bytes[i];
    return value;
}

static void *image_malloc(size_t size, H5FD_file_image_op_t operation, void *data) {
    (void)operation, (void)data;
    return malloc(size);
}

static void *image_realloc(void *bytes, size_t size, H5FD_file_image_op_t operation, void *data) {
    (void)operation;
    void *grown = realloc(bytes, size);
    if (grown) ((image *)data)->size = size;
    return grown;
}

// The driver frees its memory when the file is closed: the moment at which the bytes are complete, and ours.
static herr_t keep_at_close(void *bytes, H5FD_file_image_op_t operation, void *data) {
    image *out = data;
    if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
        out->bytes = bytes;
    } else {
        free(bytes);
    }
    return 0;
}

static void *same_data(void *data) {
    return data;
}

static herr_t leave_data(void *data) {
    (void)data;
    return 0;
}

// Access to files in memory, written so that HDF5 1.10 and later read it.
static hid_t memory_access(void) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    if (access < 0) return access;
    if (H5Pset_fapl_core(access, GROWTH, false) < 0 || H5Pset_fclose_degree(access, H5F_CLOSE_STRONG) < 0 ||
        H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) < 0) {
        H5Pclose(access);
        return H5I_INVALID_HID;
    }
    return access;
}

herr_t image_keep_plain(hid_t creation) {
    const herr_t timeless = H5Pset_obj_track_times(creation, false);
    return timeless < 0 ? timeless : H5Pset_attr_phase_change(creation, IMAGE_MOST_COMPACT, 0);
}

whirl_status image_create(image *out) {
    *out = (image){.file = H5I_INVALID_HID};
    H5FD_file_image_callbacks_t callbacks = {.image_malloc = image_malloc,
                                             .image_realloc = image_realloc,
                                             .image_free = keep_at_close,
                                             .udata_copy = same_data,
                                             .udata_free = leave_data,
                                             .udata = out};
    const hid_t access = memory_access(), creation = H5Pcreate(H5P_FILE_CREATE);
    if (access >= 0 && creation >= 0 && H5Pset_file_image_callbacks(access, &callbacks) >= 0 &&
        image_keep_plain(creation) >= 0 && H5Pset_link_phase_change(creation, IMAGE_MOST_COMPACT, 0) >= 0)
        out->file = H5Fcreate(NO_PATH, H5F_ACC_TRUNC, creation, access);
    char text[200];
    image_reason(text, sizeof text);
    H5Pclose(access);
    H5Pclose(creation);
    return out->file < 0 ? whirl_fail(WHIRL_NO_MEMORY, "cannot begin a result file: %s", text) : whirl_ok();
}

whirl_status image_finish(image *out) {
    const herr_t closed = H5Fclose(out->file);
    out->file = H5I_INVALID_HID;
    if (closed < 0 || !out->bytes || out->size < SUPERBLOCK_SIZE) {
        char text[200];
        image_reason(text, sizeof text);
        return whirl_fail(WHIRL_NO_MEMORY, "cannot finish a result file: %s", text);
    }
    // The memory is larger than the file: the superblock says where the file ends.
    const uint64_t end = little_endian(out->bytes + SUPERBLOCK_END_OF_FILE);
    if (end > out->size) return whirl_fail(WHIRL_NO_MEMORY, "cannot finish a result file: it is incomplete");
    out->size = (size_t)end;
    return whirl_ok();
}

void image_free(image *out) {
    if (out->file >= 0) H5Fclose(out->file);
    free(out->bytes);
    *out = (image){.file = H5I_INVALID_HID};
}

// HDF5 looks for its signature at several places and reads formats without checksums; only the one written here is let
// through, and only when all of it is there.
static whirl_status check_superblock(const unsigned char *bytes, size_t size) {
    static const unsigned char signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    if (size < SUPERBLOCK_SIZE || memcmp(bytes, signature, sizeof signature) != 0)
        return whirl_fail(WHIRL_BAD_INPUT, "is not an HDF5 file");
    if (bytes[SUPERBLOCK_VERSION] != 3 || bytes[SUPERBLOCK_OFFSET_SIZE] != 8)
        return whirl_fail(WHIRL_BAD_INPUT, "is an HDF5 file, but not one that whirl wrote");
    const uint64_t end = little_endian(bytes + SUPERBLOCK_END_OF_FILE);
    if (end > size)
        return whirl_fail(WHIRL_BAD_INPUT, "is cut off: %zu bytes, expected %llu", size, (unsigned long long)end);
    return whirl_ok();
}

// The bytes are lent to HDF5, which would copy them twice.
static void *lend(size_t size, H5FD_file_image_op_t operation, void *data) {
    (void)size, (void)operation;
    return data;
}

static void *lend_copy(void *to, const void *from, size_t size, H5FD_file_image_op_t operation, void *data) {
    (void)operation, (void)data;
    return to == from ? to : memcpy(to, from, size);
}

static herr_t lend_end(void *bytes, H5FD_file_image_op_t operation, void *data) {
    (void)bytes, (void)operation, (void)data;
    return 0;
}

whirl_status image_open(unsigned char *bytes, size_t size, hid_t *file) {
    *file = H5I_INVALID_HID;
    whirl_status status = check_superblock(bytes, size);
    if (status.code == WHIRL_OK) status = plain_check(bytes, size);
    if (status.code != WHIRL_OK) return status;
    H5FD_file_image_callbacks_t callbacks = {.image_malloc = lend,
                                             .image_memcpy = lend_copy,
                                             .image_free = lend_end,
                                             .udata_copy = same_data,
                                             .udata_free = leave_data,
                                             .udata = bytes};
    const hid_t access = memory_access();
    if (access >= 0 && H5Pset_file_image_callbacks(access, &callbacks) >= 0 &&
        H5Pset_file_image(access, bytes, size) >= 0)
        *file = H5Fopen(NO_PATH, H5F_ACC_RDONLY, access);
    char text[200];
    image_reason(text, sizeof text);
    H5Pclose(access);
    return *file < 0 ? whirl_fail(WHIRL_BAD_INPUT, "is damaged: %s", text) : whirl_ok();
}
