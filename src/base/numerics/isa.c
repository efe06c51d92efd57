#include "isa.h"

#include <stdlib.h>
#include <string.h>

#include "whirl/engine/descriptor.h"

#include "vector.h"

static const isa known[VECTOR_ISAS] = {
    [VECTOR_SCALAR] = {VECTOR_SCALAR, "scalar", 1, false}, [VECTOR_128] = {VECTOR_128, "simd128", 2, false},
    [VECTOR_FMA] = {VECTOR_FMA, "fma", 1, true},           [VECTOR_AVX2] = {VECTOR_AVX2, "avx2", 4, true},
    [VECTOR_AVX512] = {VECTOR_AVX512, "avx512", 8, true},
};

/// Returns true if the processor and the operating system support an instruction set; the compiler's builtins query
/// cpuid.
static bool isa_present(int number) {
#if defined(__x86_64__)
    if (!VECTOR_BUILT(number)) return false;
    switch (number) {
    case VECTOR_SCALAR:
    case VECTOR_128:
        return true;
    case VECTOR_FMA:
        return __builtin_cpu_supports("fma");
    case VECTOR_AVX2:
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case VECTOR_AVX512:
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma");
    default:
        return false;
    }
#else
    return VECTOR_BUILT(number);
#endif
}

const isa *isa_at(int number) {
    return number >= 0 && number < VECTOR_ISAS && isa_present(number) ? &known[number] : NULL;
}

whirl_status isa_choose(const isa **chosen) {
    const char *names[VECTOR_ISAS], *wish = getenv("WHIRL_ISA");
    if (wish && !*wish) wish = NULL; // an empty variable counts as unset
    *chosen = NULL;
    for (int i = 0; i < VECTOR_ISAS; i++) {
        names[i] = known[i].name;
        if (isa_at(i) && (!wish || strcmp(wish, names[i]) == 0)) *chosen = isa_at(i);
    }
    if (*chosen) return whirl_ok();
    for (int i = 0; i < VECTOR_ISAS; i++)
        if (strcmp(wish, names[i]) == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "WHIRL_ISA is %s, which this processor does not have", wish);
    const char *near = whirl_nearest_name(wish, names, VECTOR_ISAS);
    return whirl_fail(WHIRL_BAD_INPUT, "WHIRL_ISA is '%.40s', expected scalar, simd128, fma, avx2 or avx512%s%s%s",
                      wish, near ? ", did you mean '" : "", near ? near : "", near ? "'?" : "");
}
