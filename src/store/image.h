// HDF5 files in memory. The library never touches the disk: after a failed write to a full disk HDF5 1.10 crashes
// (seen with its default driver), whereas bytes in memory are written and read by calls that report every error.
#ifndef STORE_IMAGE_H
#define STORE_IMAGE_H

#include "whirl/status.h"

#include <hdf5.h>
#include <stddef.h>

// A file being made in memory, and its bytes when it is finished.
typedef struct image {
    hid_t file;
    unsigned char *bytes; // freed by image_free
    size_t size;
} image;

// Keeps HDF5 from printing its errors, until `image_loud` with what was returned.
typedef struct image_errors {
    H5E_auto2_t function;
    void *data;
} image_errors;
image_errors image_quiet(void);
void image_loud(image_errors errors);

// The innermost reason of HDF5's last failure in at most `size` bytes. To be called before any other HDF5 call.
void image_reason(char *text, size_t size);

// Starts an empty file in the format of HDF5 1.10, whose metadata all carry checksums. `out` must not move until
// image_finish.
whirl_status image_create(image *out);

// The most attributes or links that stand in the header of their object itself, and so all of them: the other way to
// store them (fractal heaps, B-trees) is larger for files like these, and HDF5 1.10 crashes where such a heap or tree
// is damaged and its checksum right.
enum { IMAGE_MOST_COMPACT = 65535 };

// Settings of all objects (file, group, dataset) in the list by which they are created: attributes in the object's
// header, and no times, so that equal results are equal files.
herr_t image_keep_plain(hid_t creation);

// Closes the file; its bytes then lie in `out`.
whirl_status image_finish(image *out);

// Frees the bytes, and closes the file where it was not finished.
void image_free(image *out);

// Opens bytes as a file for reading; they must live until it is closed by H5Fclose. WHIRL_BAD_INPUT when they are not one of image_create.
whirl_status image_open(unsigned char *bytes, size_t size, hid_t *file);

#endif
