#include "h5file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <errno.h>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

/// The driver's data of an open file; they begin with HDF5's own struct.
typedef struct h5_file {
    H5FD_t base;
    h5_bytes *bytes;
    haddr_t allocated; ///< end of the space allocated by HDF5
} h5_file;

/// The driver's entry in a property list: the bytes of the file.
typedef struct h5_access {
    h5_bytes *bytes;
} h5_access;

static H5FD_t *open_bytes(const char *name, unsigned flags, hid_t access, haddr_t most) {
    (void)name, (void)flags, (void)most;
    const h5_access *place = H5Pget_driver_info(access);
    h5_file *file = place ? calloc(1, sizeof *file) : NULL;
    if (!file) return NULL;
    file->bytes = place->bytes;
    return &file->base;
}

static herr_t close_bytes(H5FD_t *base) {
    free(base);
    return 0;
}

static int compare_bytes(const H5FD_t *a, const H5FD_t *b) {
    const h5_bytes *one = ((const h5_file *)a)->bytes, *other = ((const h5_file *)b)->bytes;
    return (one > other) - (one < other);
}

static herr_t report_features(const H5FD_t *base, unsigned long *features) {
    (void)base;
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
                H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

static haddr_t end_of_allocated(const H5FD_t *base, H5FD_mem_t kind) {
    (void)kind;
    return ((const h5_file *)base)->allocated;
}

static herr_t allocate(H5FD_t *base, H5FD_mem_t kind, haddr_t end) {
    (void)kind;
    ((h5_file *)base)->allocated = end;
    return 0;
}

static haddr_t end_of_bytes(const H5FD_t *base, H5FD_mem_t kind) {
    (void)kind;
    return ((const h5_file *)base)->bytes->end;
}

static int read_some(h5_bytes *bytes, haddr_t address, void *to, size_t size) {
    if (bytes->source) return bytes->source->read(bytes->source->context, address, to, size);
    return bytes_read_at(bytes->descriptor, address, to, size);
}

/// Reads bytes of the file; those beyond its end are zeros.
static herr_t read_bytes(H5FD_t *base, H5FD_mem_t kind, hid_t transfer, haddr_t address, size_t size, void *to) {
    (void)kind, (void)transfer;
    h5_bytes *bytes = ((h5_file *)base)->bytes;
    const uint64_t left = address < bytes->end ? bytes->end - address : 0;
    const size_t there = left < size ? (size_t)left : size;
    const int reason = there > 0 ? read_some(bytes, address, to, there) : 0;
    if (reason && !bytes->reason) bytes->reason = reason;
    if (reason) return -1;
    memset((unsigned char *)to + there, 0, size - there);
    return 0;
}

static herr_t write_bytes(H5FD_t *base, H5FD_mem_t kind, hid_t transfer, haddr_t address, size_t size,
                          const void *from) {
    (void)kind, (void)transfer;
    h5_bytes *bytes = ((h5_file *)base)->bytes;
    if (bytes->source) return -1;
    if (!bytes->reason) bytes->reason = bytes_write_at(bytes->descriptor, address, from, size);
    if (address + size > bytes->end) bytes->end = address + size;
    return 0;
}

/// Sets the file's length to the end of the space that HDF5 has allocated, whose last bytes may be unwritten.
static herr_t truncate_bytes(H5FD_t *base, hid_t transfer, hbool_t closing) {
    (void)transfer, (void)closing;
    const h5_file *file = (const h5_file *)base;
    h5_bytes *bytes = file->bytes;
    if (bytes->source || bytes->end == file->allocated) return 0;
    int failed = bytes->reason;
    while (!failed && ftruncate(bytes->descriptor, (off_t)file->allocated) != 0)
        if (errno != EINTR) failed = errno;
    bytes->reason = failed;
    bytes->end = file->allocated;
    return 0;
}

static const H5FD_class_t driver = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = 512, // first number that HDF5 leaves for private use
#endif
    .name = "whirl",
    .maxaddr = INT64_MAX,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(h5_access),
    .open = open_bytes,
    .close = close_bytes,
    .cmp = compare_bytes,
    .query = report_features,
    .get_eoa = end_of_allocated,
    .set_eoa = allocate,
    .get_eof = end_of_bytes,
    .read = read_bytes,
    .write = write_bytes,
    .truncate = truncate_bytes,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

herr_t h5_driver_set(hid_t access, h5_bytes *bytes) {
    const h5_access place = {bytes};
    const hid_t registered = H5FDregister(&driver);
    if (registered < 0) return -1;
    bytes->driver = registered;
    return H5Pset_driver(access, registered, &place);
}

void h5_driver_free(h5_bytes *bytes) {
    if (bytes->driver > 0) H5FDunregister(bytes->driver);
    bytes->driver = 0;
}
