// MAT files: limits that tests of the command cannot reach, because a variable would have to be larger than 2 GB.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "mat.h"
#include "synthetic.h"

#include <unistd.h>

static void test_too_large(void **state) {
    char folder[] = "/tmp/whirl-mat-XXXXXX", result[64], path[64];
    (void)state;
    assert_non_null(mkdtemp(folder));
    snprintf(result, sizeof result, "%s/a.h5", folder);
    snprintf(path, sizeof path, "%s/a.mat", folder);
    whirl_result *made = synthetic_result();
    assert_int_equal(whirl_result_write(made, result).code, WHIRL_OK);
    whirl_result_free(made);

    const whirl_status status = mat_export(result, path, 2000);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_non_null(strstr(status.message, "is larger than the 2000 bytes that a variable of a MAT file may have"));
    assert_int_not_equal(access(path, F_OK), 0);
    assert_int_equal(whirl_result_export_mat(result, path).code, WHIRL_OK);
    assert_int_equal(access(path, F_OK), 0);

    unlink(path), unlink(result);
    assert_int_equal(rmdir(folder), 0); // nothing else was left
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_too_large)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
