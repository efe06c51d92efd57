/// The vector type of the kernels: VECTOR_LANES independent numbers side by side.
///
/// VECTOR_ISA is one of the numbers below, and the including file is compiled for it; the default is the first. Every
/// operation rounds as in IEEE 754, and multiply-adds are explicit: in fused builds v_fma rounds once, in others twice.
/// All fused builds give the same bits, and so do all others, whatever their width and compiler. Intrinsics are used in
/// this file only.
#ifndef BASE_VECTOR_H
#define BASE_VECTOR_H

#include <limits.h>
#include <math.h>
#include <string.h>

/// Functions that must be inlined: a call would store and load all their operands.
#define VECTOR_INLINE static inline __attribute__((always_inline))

/// VECTOR_FOR begins a loop of a constant number of rounds, at most 8, and unrolls it, so that arrays of vectors stay
/// in registers. VECTOR_WHOLE before a loop unrolls up to 32 rounds; VECTOR_BY_TWO before a loop takes two rounds at
/// once.
#if defined(__clang__)
#define VECTOR_FOR(i, rounds) _Pragma("unroll") for (size_t i = 0; i < (rounds); i++)
#define VECTOR_WHOLE _Pragma("unroll")
#define VECTOR_BY_TWO _Pragma("unroll 2")
#else
#define VECTOR_FOR(i, rounds) _Pragma("GCC unroll 8") for (size_t i = 0; i < (rounds); i++)
#define VECTOR_WHOLE _Pragma("GCC unroll 32")
#define VECTOR_BY_TWO _Pragma("GCC unroll 2")
#endif

#ifndef VECTOR_ISA
#define VECTOR_ISA 0
#endif

#define VECTOR_SCALAR 0 ///< one lane, unfused: any machine
#define VECTOR_128 1    ///< two lanes, unfused: SSE2, NEON, WebAssembly
#define VECTOR_FMA 2    ///< one lane, fused: the same bits as the next two
#define VECTOR_AVX2 3   ///< four lanes, fused
#define VECTOR_AVX512 4 ///< eight lanes, fused
#define VECTOR_ISAS 5

/// Name of a function compiled once for every instruction set: name_avx2, ...
#define ISA_JOIN(name, set) name##_##set
#define ISA_NAME(name, set) ISA_JOIN(name, set)
#define ISA(name) ISA_NAME(name, ISA_SUFFIX)

/// Instruction sets of a build for x86-64: all; with WHIRL_PORTABLE scalar and 128 only; with WHIRL_WIDE these two and
/// the one that WHIRL_WIDE names, of number WHIRL_WIDE_ISA, which compiles faster than all. Builds for other processors
/// have scalar and 128.
#if !defined(__x86_64__) || defined(WHIRL_PORTABLE)
#define VECTOR_BUILT(number) ((number) <= VECTOR_128)
#elif defined(WHIRL_WIDE)
#define VECTOR_BUILT(number) ((number) <= VECTOR_128 || (number) == WHIRL_WIDE_ISA)
#else
#define VECTOR_BUILT(number) ((number) < VECTOR_ISAS)
#endif

/// FOR_EVERY_ISA declares a function of every instruction set of the build. EVERY_ISA is the table of these functions
/// by the number of the set, with NULL for sets that are not built.
#if VECTOR_BUILT(VECTOR_FMA) && VECTOR_BUILT(VECTOR_AVX2)
#define FOR_EVERY_ISA(type, name) extern type name##_scalar, name##_128, name##_fma, name##_avx2, name##_avx512
#define EVERY_ISA(address, name)                                                                                       \
    {                                                                                                                  \
        [VECTOR_SCALAR] = address name##_scalar, [VECTOR_128] = address name##_128, [VECTOR_FMA] = address name##_fma, \
        [VECTOR_AVX2] = address name##_avx2, [VECTOR_AVX512] = address name##_avx512                                   \
    }
#elif defined(WHIRL_WIDE)
#define FOR_EVERY_ISA(type, name) extern type name##_scalar, name##_128, ISA_NAME(name, WHIRL_WIDE)
#define EVERY_ISA(address, name)                                                                                       \
    {                                                                                                                  \
        [VECTOR_SCALAR] = address name##_scalar, [VECTOR_128] = address name##_128,                                    \
        [WHIRL_WIDE_ISA] = address ISA_NAME(name, WHIRL_WIDE)                                                          \
    }
#else
#define FOR_EVERY_ISA(type, name) extern type name##_scalar, name##_128
#define EVERY_ISA(address, name)                                                                                       \
    { [VECTOR_SCALAR] = address name##_scalar, [VECTOR_128] = address name##_128 }
#endif

#if VECTOR_ISA == VECTOR_AVX512
#define ISA_SUFFIX avx512
#elif VECTOR_ISA == VECTOR_AVX2
#define ISA_SUFFIX avx2
#elif VECTOR_ISA == VECTOR_FMA
#define ISA_SUFFIX fma
#elif VECTOR_ISA == VECTOR_128
#define ISA_SUFFIX 128
#else
#define ISA_SUFFIX scalar
#endif

#if VECTOR_ISA == VECTOR_AVX512

#include <immintrin.h>
enum { VECTOR_LANES = 8 };
typedef __m512d vec;
typedef __mmask8 vec_mask;
static inline vec v_set(double a) {
    return _mm512_set1_pd(a);
}
static inline vec v_add(vec a, vec b) {
    return _mm512_add_pd(a, b);
}
static inline vec v_sub(vec a, vec b) {
    return _mm512_sub_pd(a, b);
}
static inline vec v_mul(vec a, vec b) {
    return _mm512_mul_pd(a, b);
}
static inline vec v_div(vec a, vec b) {
    return _mm512_div_pd(a, b);
}
static inline vec v_sqrt(vec a) {
    return _mm512_sqrt_pd(a);
}
static inline vec v_fma(vec a, vec b, vec c) {
    return _mm512_fmadd_pd(a, b, c);
}
static inline vec v_fms(vec a, vec b, vec c) {
    return _mm512_fmsub_pd(a, b, c);
}
static inline vec v_fnma(vec a, vec b, vec c) {
    return _mm512_fnmadd_pd(a, b, c);
}
static inline vec v_min(vec a, vec b) {
    return _mm512_min_pd(a, b);
}
static inline vec v_max(vec a, vec b) {
    return _mm512_max_pd(a, b);
}
static inline vec v_abs(vec a) {
    return _mm512_abs_pd(a);
}
static inline vec_mask v_less(vec a, vec b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
static inline vec v_select(vec_mask mask, vec yes, vec no) {
    return _mm512_mask_blend_pd(mask, no, yes);
}
static inline int v_any(vec_mask mask) {
    return mask != 0;
}
/// a, with its sign changed if `sign` is negative.
static inline vec v_flip(vec a, vec sign) {
    const __m512i bit = _mm512_castpd_si512(_mm512_set1_pd(-0.0));
    enum { EXCLUSIVE_OR_OF_AND = 0x78 };
    return _mm512_castsi512_pd(
        _mm512_ternarylogic_epi64(_mm512_castpd_si512(a), _mm512_castpd_si512(sign), bit, EXCLUSIVE_OR_OF_AND));
}

/// Subtracts the bit pattern of a, read as a 64-bit integer, from `magic`: the first guess of a Newton iteration.
static inline vec v_seed(long long magic, vec a) {
    return _mm512_castsi512_pd(_mm512_sub_epi64(_mm512_set1_epi64(magic), _mm512_castpd_si512(a)));
}
/// Subtracts half of that integer from `magic`.
static inline vec v_seed_half(long long magic, vec a) {
    return _mm512_castsi512_pd(
        _mm512_sub_epi64(_mm512_set1_epi64(magic), _mm512_srli_epi64(_mm512_castpd_si512(a), 1)));
}

/// The whole number k of a = m 2^k, 1 <= m < 2, for normal a > 0: the bits of the exponent, put into those of 2^52.
static inline vec v_exponent(vec a) {
    const __m512i bits = _mm512_srli_epi64(_mm512_castpd_si512(a), 52);
    const __m512i magic = _mm512_castpd_si512(_mm512_set1_pd(0x1p52));
    return _mm512_sub_pd(_mm512_castsi512_pd(_mm512_or_si512(bits, magic)), _mm512_set1_pd(0x1p52 + 1023.0));
}
/// 2^k for a whole number k from -1022 to 1023.
static inline vec v_power_of_2(vec k) {
    const __m512i bits = _mm512_castpd_si512(_mm512_add_pd(k, _mm512_set1_pd(0x1p52 + 1023.0)));
    return _mm512_castsi512_pd(_mm512_slli_epi64(bits, 52));
}

/// Transposes eight numbers of every lane to eight vectors.
static inline void v_transpose(const double from[VECTOR_LANES][8], vec to[8]) {
    enum { LOW = 0x88, HIGH = 0xdd };
    vec pair[8], four[8];
    for (int i = 0; i < 8; i += 2) {
        const vec one = _mm512_loadu_pd(from[i]), next = _mm512_loadu_pd(from[i + 1]);
        pair[i] = _mm512_unpacklo_pd(one, next);
        pair[i + 1] = _mm512_unpackhi_pd(one, next);
    }
    for (int i = 0; i < 8; i += 4)
        for (int k = 0; k < 2; k++) {
            four[i + k] = _mm512_shuffle_f64x2(pair[i + k], pair[i + k + 2], LOW);
            four[i + k + 2] = _mm512_shuffle_f64x2(pair[i + k], pair[i + k + 2], HIGH);
        }
    for (int k = 0; k < 4; k++) {
        to[k] = _mm512_shuffle_f64x2(four[k], four[k + 4], LOW);
        to[k + 4] = _mm512_shuffle_f64x2(four[k], four[k + 4], HIGH);
    }
}

#elif VECTOR_ISA == VECTOR_AVX2

#include <immintrin.h>
enum { VECTOR_LANES = 4 };
typedef __m256d vec;
typedef __m256d vec_mask;
static inline vec v_set(double a) {
    return _mm256_set1_pd(a);
}
static inline vec v_add(vec a, vec b) {
    return _mm256_add_pd(a, b);
}
static inline vec v_sub(vec a, vec b) {
    return _mm256_sub_pd(a, b);
}
static inline vec v_mul(vec a, vec b) {
    return _mm256_mul_pd(a, b);
}
static inline vec v_div(vec a, vec b) {
    return _mm256_div_pd(a, b);
}
static inline vec v_sqrt(vec a) {
    return _mm256_sqrt_pd(a);
}
static inline vec v_fma(vec a, vec b, vec c) {
    return _mm256_fmadd_pd(a, b, c);
}
static inline vec v_fms(vec a, vec b, vec c) {
    return _mm256_fmsub_pd(a, b, c);
}
static inline vec v_fnma(vec a, vec b, vec c) {
    return _mm256_fnmadd_pd(a, b, c);
}
static inline vec v_min(vec a, vec b) {
    return _mm256_min_pd(a, b);
}
static inline vec v_max(vec a, vec b) {
    return _mm256_max_pd(a, b);
}
static inline vec v_abs(vec a) {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}
static inline vec_mask v_less(vec a, vec b) {
    return _mm256_cmp_pd(a, b, _CMP_LT_OQ);
}
static inline vec v_select(vec_mask mask, vec yes, vec no) {
    return _mm256_blendv_pd(no, yes, mask);
}
static inline int v_any(vec_mask mask) {
    return _mm256_movemask_pd(mask) != 0;
}
static inline vec v_flip(vec a, vec sign) {
    return _mm256_xor_pd(a, _mm256_and_pd(_mm256_set1_pd(-0.0), sign));
}

static inline vec v_seed(long long magic, vec a) {
    return _mm256_castsi256_pd(_mm256_sub_epi64(_mm256_set1_epi64x(magic), _mm256_castpd_si256(a)));
}
static inline vec v_seed_half(long long magic, vec a) {
    return _mm256_castsi256_pd(
        _mm256_sub_epi64(_mm256_set1_epi64x(magic), _mm256_srli_epi64(_mm256_castpd_si256(a), 1)));
}

static inline vec v_exponent(vec a) {
    const __m256i bits = _mm256_srli_epi64(_mm256_castpd_si256(a), 52);
    const __m256d whole = _mm256_or_pd(_mm256_castsi256_pd(bits), _mm256_set1_pd(0x1p52));
    return _mm256_sub_pd(whole, _mm256_set1_pd(0x1p52 + 1023.0));
}
static inline vec v_power_of_2(vec k) {
    const __m256i bits = _mm256_castpd_si256(_mm256_add_pd(k, _mm256_set1_pd(0x1p52 + 1023.0)));
    return _mm256_castsi256_pd(_mm256_slli_epi64(bits, 52));
}

#elif VECTOR_ISA == VECTOR_128 && defined(__SSE2__)

#include <emmintrin.h>
enum { VECTOR_LANES = 2 };
typedef __m128d vec;
typedef __m128d vec_mask;
static inline vec v_set(double a) {
    return _mm_set1_pd(a);
}
static inline vec v_add(vec a, vec b) {
    return _mm_add_pd(a, b);
}
static inline vec v_sub(vec a, vec b) {
    return _mm_sub_pd(a, b);
}
static inline vec v_mul(vec a, vec b) {
    return _mm_mul_pd(a, b);
}
static inline vec v_div(vec a, vec b) {
    return _mm_div_pd(a, b);
}
static inline vec v_sqrt(vec a) {
    return _mm_sqrt_pd(a);
}
static inline vec v_fma(vec a, vec b, vec c) {
    return _mm_add_pd(_mm_mul_pd(a, b), c);
}
static inline vec v_fms(vec a, vec b, vec c) {
    return _mm_sub_pd(_mm_mul_pd(a, b), c);
}
static inline vec v_fnma(vec a, vec b, vec c) {
    return _mm_sub_pd(c, _mm_mul_pd(a, b));
}
static inline vec v_min(vec a, vec b) {
    return _mm_min_pd(a, b);
}
static inline vec v_max(vec a, vec b) {
    return _mm_max_pd(a, b);
}
static inline vec v_abs(vec a) {
    return _mm_andnot_pd(_mm_set1_pd(-0.0), a);
}
static inline vec_mask v_less(vec a, vec b) {
    return _mm_cmplt_pd(a, b);
}
static inline vec v_select(vec_mask mask, vec yes, vec no) {
    return _mm_or_pd(_mm_and_pd(mask, yes), _mm_andnot_pd(mask, no));
}
static inline int v_any(vec_mask mask) {
    return _mm_movemask_pd(mask) != 0;
}
static inline vec v_flip(vec a, vec sign) {
    return _mm_xor_pd(a, _mm_and_pd(_mm_set1_pd(-0.0), sign));
}

static inline vec v_seed(long long magic, vec a) {
    return _mm_castsi128_pd(_mm_sub_epi64(_mm_set1_epi64x(magic), _mm_castpd_si128(a)));
}
static inline vec v_seed_half(long long magic, vec a) {
    return _mm_castsi128_pd(_mm_sub_epi64(_mm_set1_epi64x(magic), _mm_srli_epi64(_mm_castpd_si128(a), 1)));
}

static inline vec v_exponent(vec a) {
    const __m128i bits = _mm_srli_epi64(_mm_castpd_si128(a), 52);
    const __m128d whole = _mm_or_pd(_mm_castsi128_pd(bits), _mm_set1_pd(0x1p52));
    return _mm_sub_pd(whole, _mm_set1_pd(0x1p52 + 1023.0));
}
static inline vec v_power_of_2(vec k) {
    const __m128i bits = _mm_castpd_si128(_mm_add_pd(k, _mm_set1_pd(0x1p52 + 1023.0)));
    return _mm_castsi128_pd(_mm_slli_epi64(bits, 52));
}

#elif VECTOR_ISA == VECTOR_128

/// The compiler's vector type, for NEON and WebAssembly. Nothing is fused, as in the SSE2 version above.
enum { VECTOR_LANES = 2 };
typedef double vec __attribute__((vector_size(16)));
typedef long long vec_mask __attribute__((vector_size(16)));
static inline vec v_set(double a) {
    return (vec){a, a};
}
static inline vec v_add(vec a, vec b) {
    return a + b;
}
static inline vec v_sub(vec a, vec b) {
    return a - b;
}
static inline vec v_mul(vec a, vec b) {
    return a * b;
}
static inline vec v_div(vec a, vec b) {
    return a / b;
}
static inline vec v_sqrt(vec a) {
    return (vec){sqrt(a[0]), sqrt(a[1])};
}
static inline vec v_fma(vec a, vec b, vec c) {
    return a * b + c;
}
static inline vec v_fms(vec a, vec b, vec c) {
    return a * b - c;
}
static inline vec v_fnma(vec a, vec b, vec c) {
    return c - a * b;
}
static inline vec_mask v_less(vec a, vec b) {
    return a < b;
}
static inline vec v_select(vec_mask mask, vec yes, vec no) {
    return (vec)((mask & (vec_mask)yes) | (~mask & (vec_mask)no));
}
static inline int v_any(vec_mask mask) {
    return (mask[0] | mask[1]) != 0;
}
static inline vec v_min(vec a, vec b) {
    return v_select(v_less(a, b), a, b);
}
static inline vec v_max(vec a, vec b) {
    return v_select(v_less(b, a), a, b);
}
static inline vec v_abs(vec a) {
    return (vec){fabs(a[0]), fabs(a[1])};
}
static inline vec v_flip(vec a, vec sign) {
    return (vec)((vec_mask)a ^ ((vec_mask)sign & (vec_mask)v_set(-0.0)));
}

static inline vec v_seed(long long magic, vec a) {
    return (vec)((vec_mask){magic, magic} - (vec_mask)a);
}
static inline vec v_seed_half(long long magic, vec a) {
    return (vec)((vec_mask){magic, magic} - (((vec_mask)a >> 1) & (vec_mask){LLONG_MAX, LLONG_MAX}));
}

static inline vec v_exponent(vec a) {
    const vec whole = (vec)((((vec_mask)a >> 52) & (vec_mask){0xfff, 0xfff}) | (vec_mask)v_set(0x1p52));
    return whole - v_set(0x1p52 + 1023.0);
}
static inline vec v_power_of_2(vec k) {
    return (vec)((vec_mask)(k + v_set(0x1p52 + 1023.0)) << 52);
}

#else

enum { VECTOR_LANES = 1, VECTOR_FUSED = VECTOR_ISA == VECTOR_FMA };
typedef double vec;
typedef int vec_mask;
static inline vec v_set(double a) {
    return a;
}
static inline vec v_add(vec a, vec b) {
    return a + b;
}
static inline vec v_sub(vec a, vec b) {
    return a - b;
}
static inline vec v_mul(vec a, vec b) {
    return a * b;
}
static inline vec v_div(vec a, vec b) {
    return a / b;
}
static inline vec v_sqrt(vec a) {
    return sqrt(a);
}
static inline vec v_fma(vec a, vec b, vec c) {
    return VECTOR_FUSED ? fma(a, b, c) : a * b + c;
}
static inline vec v_fms(vec a, vec b, vec c) {
    return VECTOR_FUSED ? fma(a, b, -c) : a * b - c;
}
static inline vec v_fnma(vec a, vec b, vec c) {
    return VECTOR_FUSED ? fma(-a, b, c) : c - a * b;
}
/// Minimum and maximum. If an operand is not a number, the result is the second operand, as with the instructions of
/// x86 processors.
static inline vec v_min(vec a, vec b) {
    return a < b ? a : b;
}
static inline vec v_max(vec a, vec b) {
    return a > b ? a : b;
}
static inline vec v_abs(vec a) {
    return fabs(a);
}
static inline vec_mask v_less(vec a, vec b) {
    return a < b;
}
static inline vec v_select(vec_mask mask, vec yes, vec no) {
    return mask ? yes : no;
}
static inline int v_any(vec_mask mask) {
    return mask;
}
static inline vec v_flip(vec a, vec sign) {
    return a * copysign(1.0, sign);
}

static inline vec v_seed(long long magic, vec a) {
    unsigned long long bits;
    memcpy(&bits, &a, sizeof bits);
    bits = (unsigned long long)magic - bits;
    memcpy(&a, &bits, sizeof bits);
    return a;
}
static inline vec v_seed_half(long long magic, vec a) {
    unsigned long long bits;
    memcpy(&bits, &a, sizeof bits);
    bits = (unsigned long long)magic - (bits >> 1);
    memcpy(&a, &bits, sizeof bits);
    return a;
}

static inline vec v_exponent(vec a) {
    unsigned long long bits;
    memcpy(&bits, &a, sizeof bits);
    bits = bits >> 52 | 0x4330000000000000; // bits of 2^52
    memcpy(&a, &bits, sizeof bits);
    return a - (0x1p52 + 1023.0);
}
static inline vec v_power_of_2(vec k) {
    unsigned long long bits;
    k += 0x1p52 + 1023.0;
    memcpy(&bits, &k, sizeof bits);
    bits <<= 52;
    memcpy(&k, &bits, sizeof bits);
    return k;
}

#endif

/// Loads VECTOR_LANES numbers from any address, aligned or not.
static inline vec v_load(const double *from) {
    vec out;
    memcpy(&out, from, sizeof out);
    return out;
}

#if VECTOR_ISA != VECTOR_AVX512
static inline void v_transpose(const double from[VECTOR_LANES][8], vec to[8]) {
    for (int i = 0; i < 8; i++) {
        double column[VECTOR_LANES];
        for (int lane = 0; lane < VECTOR_LANES; lane++) column[lane] = from[lane][i];
        memcpy(&to[i], column, sizeof to[i]);
    }
}
#endif

// ---------------------------------------------------------------- rows of one machine

/// Sets of one lane have quads, too: four rows of one machine side by side, each of which takes the operations that
/// vec takes.
#define VECTOR_QUADS (VECTOR_ISA == VECTOR_SCALAR || VECTOR_ISA == VECTOR_FMA)

#if VECTOR_ISA == VECTOR_FMA
#include <immintrin.h>
typedef __m256d quad;
static inline quad q_set(double a) {
    return _mm256_set1_pd(a);
}
static inline quad q_load(const double *from) {
    return _mm256_loadu_pd(from);
}
static inline void q_store(double *to, quad a) {
    _mm256_storeu_pd(to, a);
}
static inline quad q_add(quad a, quad b) {
    return _mm256_add_pd(a, b);
}
static inline quad q_mul(quad a, quad b) {
    return _mm256_mul_pd(a, b);
}
static inline quad q_fma(quad a, quad b, quad c) {
    return _mm256_fmadd_pd(a, b, c);
}
#elif VECTOR_ISA == VECTOR_SCALAR
typedef struct quad {
    double of[4];
} quad;
static inline quad q_set(double a) {
    return (quad){{a, a, a, a}};
}
static inline quad q_load(const double *from) {
    quad out;
    memcpy(&out, from, sizeof out);
    return out;
}
static inline void q_store(double *to, quad a) {
    memcpy(to, &a, sizeof a);
}
static inline quad q_add(quad a, quad b) {
    for (int i = 0; i < 4; i++) a.of[i] += b.of[i];
    return a;
}
static inline quad q_mul(quad a, quad b) {
    for (int i = 0; i < 4; i++) a.of[i] *= b.of[i];
    return a;
}
static inline quad q_fma(quad a, quad b, quad c) {
    for (int i = 0; i < 4; i++) c.of[i] = v_fma(a.of[i], b.of[i], c.of[i]);
    return c;
}
#endif

#endif
