#include "whirl/version.h"

const char *whirl_version(void) {
    return WHIRL_VERSION;
}

whirl_status whirl_version_check(int major, int minor, int patch) {
    const int own[] = {WHIRL_VERSION_MAJOR, WHIRL_VERSION_MINOR, WHIRL_VERSION_PATCH};
    const int least[] = {major, minor, patch};
    for (int i = 0; i < 3 && own[i] <= least[i]; i++)
        if (own[i] < least[i])
            return whirl_fail(WHIRL_BAD_INPUT, "the library is whirl %s, expected %d.%d.%d or a later version",
                              WHIRL_VERSION, major, minor, patch);
    return whirl_ok();
}
