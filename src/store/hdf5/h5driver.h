// How HDF5 reaches its file: by our own calls.
//
// HDF5 1.10 crashes after a failed write of its default driver (seen on a full disk). This one never tells it: what
// follows a failed write is dropped, and the reason is kept for whoever gives the file its name.
#ifndef STORE_H5DRIVER_H
#define STORE_H5DRIVER_H

#include "bytes.h"

#include <hdf5.h>
#include <stdint.h>

/// The bytes of one file of HDF5, to be read or to be made.
typedef struct h5_bytes {
    const byte_source *source; ///< to be read; NULL: to be made
    int descriptor;            ///< of the empty file to be made, open for reading and writing
    uint64_t end;              ///< of what is there
    int reason;                ///< errno of the first call that failed, 0 where none has
    hid_t driver;              ///< registered for this file, 0: none
} h5_bytes;

/// Makes `access` a list of properties for files of these bytes, which must outlive the file. Negative on failure.
herr_t h5_driver_set(hid_t access, h5_bytes *bytes);

/// Gives the driver back. Not before the file is closed: HDF5 1.10 lets go of a file's driver and then calls it once
/// more.
void h5_driver_free(h5_bytes *bytes);

#endif
