// HDF5 files as whirl makes and reads them: by whirl's own driver (h5driver.c), in one format (h5file.c), after a check
// that they have nothing else (plain.c).
#ifndef STORE_H5FILE_H
#define STORE_H5FILE_H

#include "bytes.h"
#include "plain_part.h"
#include "whirl/status.h"

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// ---------------------------------------------------------------- h5driver
// A driver through which HDF5 reads and writes its file.
//
// HDF5 1.10 crashes after a failed write of its default driver (seen on a full disk). This driver hides failures from
// it: later writes are dropped, and the reason is kept for the code that renames the file.

/// The bytes of one HDF5 file, to be read or to be made.
typedef struct h5_bytes {
    const byte_source *source; ///< to be read; NULL: to be made
    int descriptor;            ///< empty file to be made, open for reading and writing
    uint64_t end;              ///< end of the written bytes
    int reason;                ///< errno of the first call that failed, 0 if none has
    hid_t driver;              ///< registered for this file, 0: none
} h5_bytes;

/// Sets this driver and these bytes, which must outlive the file, in the property list `access`. Negative on failure.
herr_t h5_driver_set(hid_t access, h5_bytes *bytes);

/// Unregisters the driver, after the file was closed: HDF5 1.10 calls a file's driver once more after releasing it.
void h5_driver_free(h5_bytes *bytes);

/// State of HDF5's error printing, which h5_quiet turns off and h5_loud restores.
typedef struct h5_errors {
    H5E_auto2_t function;
    void *data;
} h5_errors;
h5_errors h5_quiet(void);
void h5_loud(h5_errors errors);

/// Writes the innermost reason of HDF5's last failure in at most `size` bytes. Must be called before any other HDF5
/// call.
void h5_reason(char *text, size_t size);

/// Number of attributes or links up to which HDF5 stores them in the object's header. It is high enough for all of
/// whirl's: the other storage (fractal heaps, B-trees) is larger for these files, and HDF5 1.10 crashes on a damaged
/// heap or tree with a valid checksum.
enum { H5_MAX_COMPACT = 65535 };

/// Sets in a creation property list what all objects (file, group, dataset) have: attributes in the object's header,
/// and no times, so that equal results are equal files.
herr_t h5_keep_plain(hid_t creation);

/// Starts a file in the format of HDF5 1.10, in which all metadata have checksums, in the empty file of `descriptor`
/// (open for reading and writing). Close it with h5_finish; `bytes` must not move until then.
whirl_status h5_create(h5_bytes *bytes, int descriptor, hid_t *file);

/// Closes a file that was made. WHIRL_IO_ERROR if a call failed, now or before.
whirl_status h5_finish(h5_bytes *bytes, hid_t file);

/// Opens bytes as a file for reading; they must live until it is closed by h5_close. WHIRL_BAD_INPUT if they are no
/// file of h5_create, WHIRL_IO_ERROR if they cannot be read.
whirl_status h5_open(h5_bytes *bytes, const byte_source *source, hid_t *file);

/// Closes a file that was read, even if it could not be opened.
void h5_close(h5_bytes *bytes, hid_t file);

// ---------------------------------------------------------------- plain
// Checks that a file has only the few structures of HDF5 that whirl writes.
//
// HDF5 1.10 crashes on many files with damaged metadata and valid checksums, as in a malicious file
// (tests/fuzz/fuzz_result.c finds such within seconds). So the file is checked before HDF5 opens it: every object
// header, every message in it, and all addresses. Everything that whirl does not write is refused: other types, links
// and storage, heaps and trees.
//
// Numbers of sections are those of the HDF5 File Format Specification 3.0.

/// Content of the messages of one object.
typedef struct plain_object {
    unsigned found;           ///< bits of the message types found, of those that may occur once
    size_t type_size, rank;   ///< size of a dataset's elements; number of its dimensions
    size_t chunk_rank, chunk; ///< number of dimensions of its chunks; bytes of an element according to its chunks
    int reason;               ///< errno of a read that failed
} plain_object;

/// Object or continuation that a message points to.
typedef struct plain_lead {
    enum { PLAIN_NONE, PLAIN_CONTINUATION, PLAIN_OBJECT } kind;
    uint64_t address, length;
} plain_lead;

/// Checks a message (IV.A.2) of `type` and notes its content. Returns false for one that whirl does not write.
bool plain_message(const byte_source *source, unsigned type, plain_part message, plain_object *object,
                   plain_lead *lead);

/// Returns true if the messages of an object make a complete group or dataset.
bool plain_object_whole(const plain_object *object);

/// Checks the whole file, whose superblock must be known to be of version 3 with addresses of 8 bytes. WHIRL_IO_ERROR
/// if it cannot be read.
whirl_status plain_check(const byte_source *source);

#endif
