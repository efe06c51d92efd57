#include "h5file.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    /// Offsets in the superblock, version 3 (HDF5 File Format Specification 3.0, III.A); all addresses have 8 bytes.
    SUPERBLOCK_VERSION = 8,
    SUPERBLOCK_OFFSET_SIZE = 9,
    SUPERBLOCK_END_OF_FILE = 28,
    SUPERBLOCK_SIZE = 48
};

// Name that HDF5 requires and no message shows: the driver finds the file by its bytes.
#define NO_PATH "result"

h5_errors h5_quiet(void) {
    h5_errors errors = {0};
    H5Eget_auto2(H5E_DEFAULT, &errors.function, &errors.data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return errors;
}

void h5_loud(h5_errors errors) {
    H5Eset_auto2(H5E_DEFAULT, errors.function, errors.data);
}

typedef struct reason_text {
    char *text;
    size_t size;
} reason_text;

static herr_t innermost(unsigned depth, const H5E_error2_t *error, void *data) {
    const reason_text *to = data;
    if (depth == 0) snprintf(to->text, to->size, "%s", error->desc ? error->desc : "no reason given");
    return 0;
}

void h5_reason(char *text, size_t size) {
    reason_text to = {text, size};
    snprintf(text, size, "no reason given");
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &to);
}

herr_t h5_keep_plain(hid_t creation) {
    const herr_t timeless = H5Pset_obj_track_times(creation, false);
    return timeless < 0 ? timeless : H5Pset_attr_phase_change(creation, H5_MAX_COMPACT, 0);
}

/// Returns a property list for access to these bytes, in a format that HDF5 1.10 and later read.
static hid_t access_to(h5_bytes *bytes) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    if (access < 0) return access;
    if (h5_driver_set(access, bytes) < 0 || H5Pset_fclose_degree(access, H5F_CLOSE_STRONG) < 0 ||
        H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) < 0) {
        H5Pclose(access);
        return H5I_INVALID_HID;
    }
    return access;
}

whirl_status h5_create(h5_bytes *bytes, int descriptor, hid_t *file) {
    *bytes = (h5_bytes){.descriptor = descriptor};
    *file = H5I_INVALID_HID;
    const hid_t access = access_to(bytes), creation = H5Pcreate(H5P_FILE_CREATE);
    if (access >= 0 && creation >= 0 && h5_keep_plain(creation) >= 0 &&
        H5Pset_link_phase_change(creation, H5_MAX_COMPACT, 0) >= 0)
        *file = H5Fcreate(NO_PATH, H5F_ACC_TRUNC, creation, access);
    char text[200];
    h5_reason(text, sizeof text);
    H5Pclose(access);
    H5Pclose(creation);
    if (*file < 0) h5_driver_free(bytes);
    return *file < 0 ? whirl_fail(WHIRL_NO_MEMORY, "cannot begin a result file: %s", text) : whirl_ok();
}

void h5_close(h5_bytes *bytes, hid_t file) {
    if (file >= 0) H5Fclose(file);
    h5_driver_free(bytes);
}

whirl_status h5_finish(h5_bytes *bytes, hid_t file) {
    char text[200] = "";
    const herr_t closed = H5Fclose(file);
    if (closed < 0) h5_reason(text, sizeof text);
    h5_driver_free(bytes);
    if (bytes->reason) return whirl_fail(WHIRL_IO_ERROR, "%s", strerror(bytes->reason));
    if (closed >= 0) return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "cannot finish a result file: %s", text);
}

/// Accepts only the format that whirl writes, and only a file of full length. HDF5 itself looks for its signature at
/// several places, and reads formats without checksums.
static whirl_status check_superblock(const byte_source *source) {
    unsigned char bytes[SUPERBLOCK_SIZE];
    if (source->size < SUPERBLOCK_SIZE) return whirl_fail(WHIRL_BAD_INPUT, "is not an HDF5 file");
    const int reason = source->read(source->context, 0, bytes, sizeof bytes);
    if (reason) return whirl_fail(WHIRL_IO_ERROR, "%s", strerror(reason));
    if (memcmp(bytes, h5_signature, sizeof h5_signature) != 0)
        return whirl_fail(WHIRL_BAD_INPUT, "is not an HDF5 file");
    if (bytes[SUPERBLOCK_VERSION] != 3 || bytes[SUPERBLOCK_OFFSET_SIZE] != 8)
        return whirl_fail(WHIRL_BAD_INPUT, "is an HDF5 file, but not one that whirl wrote");
    plain_part end = {bytes + SUPERBLOCK_END_OF_FILE, 8, false};
    const uint64_t expected = plain_number(&end, 8);
    if (expected > source->size)
        return whirl_fail(WHIRL_BAD_INPUT, "is cut off: %llu bytes, expected %llu", (unsigned long long)source->size,
                          (unsigned long long)expected);
    return whirl_ok();
}

whirl_status h5_open(h5_bytes *bytes, const byte_source *source, hid_t *file) {
    *file = H5I_INVALID_HID;
    *bytes = (h5_bytes){.source = source, .descriptor = -1, .end = source->size};
    whirl_status status = check_superblock(source);
    if (status.code == WHIRL_OK) status = plain_check(source);
    if (status.code != WHIRL_OK) return status;
    const hid_t access = access_to(bytes);
    if (access >= 0) *file = H5Fopen(NO_PATH, H5F_ACC_RDONLY, access);
    char text[200];
    h5_reason(text, sizeof text);
    H5Pclose(access);
    if (*file >= 0) return whirl_ok();
    return bytes->reason ? whirl_fail(WHIRL_IO_ERROR, "%s", strerror(bytes->reason))
                         : whirl_fail(WHIRL_BAD_INPUT, "is damaged: %s", text);
}
