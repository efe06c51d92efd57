#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_fit.h"
#include "whirl/engine.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/whirl-fit-XXXXXX";

int fit_make_folder(void **unused) {
    (void)unused;
    return mkdtemp(folder) ? 0 : -1;
}

int fit_remove_folder(void **unused) {
    (void)unused;
    DIR *open = opendir(folder);
    char path[256];
    for (const struct dirent *one = open ? readdir(open) : NULL; one; one = readdir(open)) {
        if (one->d_name[0] == '.') continue;
        fit_path(one->d_name, path);
        unlink(path);
    }
    if (open) closedir(open);
    return rmdir(folder);
}

void fit_path(const char *name, char path[256]) {
    snprintf(path, 256, "%s/%.200s", folder, name);
}

whirl_result *fit_of_text(const char *text, int threads) {
    char path[256];
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    whirl_result *result = NULL;
    fit_path("fit.yaml", path);
    const whirl_status status = whirl_case_parse(text, strlen(text), path, &problems, &object);
    if (status.code != WHIRL_OK) print_error("%s\n", problems.count > 0 ? problems.items[0].message : status.message);
    require_ok(status);
    whirl_problems_free(&problems);
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = threads}, &result));
    whirl_case_free(object);
    return result;
}
