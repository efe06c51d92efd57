// Files of HDF5 as whirl makes and reads them: in one format, by our own calls (h5driver.h), plain (plain.h).
#ifndef STORE_H5FILE_H
#define STORE_H5FILE_H

#include "h5driver.h"
#include "whirl/status.h"

#include <hdf5.h>
#include <stddef.h>

/// Keeps HDF5 from printing its errors, until `h5_loud` with what was returned.
typedef struct h5_errors {
    H5E_auto2_t function;
    void *data;
} h5_errors;
h5_errors h5_quiet(void);
void h5_loud(h5_errors errors);

/// The innermost reason of HDF5's last failure in at most `size` bytes. To be called before any other HDF5 call.
void h5_reason(char *text, size_t size);

/// The most attributes or links that stand in the header of their object itself, and so all of them: the other way to
/// store them (fractal heaps, B-trees) is larger for files like these, and HDF5 1.10 crashes where such a heap or tree
/// is damaged and its checksum right.
enum { H5_MOST_COMPACT = 65535 };

/// Settings of all objects (file, group, dataset) in the list by which they are created: attributes in the object's
/// header, and no times, so that equal results are equal files.
herr_t h5_keep_plain(hid_t creation);

/// Starts a file in the format of HDF5 1.10, whose metadata all carry checksums, in the empty file that `descriptor` is
/// open for (reading and writing). Closed by h5_finish; `bytes` must stay where it is until then.
whirl_status h5_create(h5_bytes *bytes, int descriptor, hid_t *file);

/// Closes a file that was made. WHIRL_IO_ERROR where a call failed, now or before.
whirl_status h5_finish(h5_bytes *bytes, hid_t file);

/// Opens bytes as a file for reading; they must live until it is closed by h5_close. WHIRL_BAD_INPUT when they are not
/// one of h5_create, WHIRL_IO_ERROR when they cannot be read.
whirl_status h5_open(h5_bytes *bytes, const byte_source *source, hid_t *file);

/// Closes a file that was read; also where it could not be opened.
void h5_close(h5_bytes *bytes, hid_t file);

#endif
