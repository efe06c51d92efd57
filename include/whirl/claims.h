/// Claims: what a paper or a measurement says of a rotor, to be set beside what is found. Nothing is forced to agree.
#ifndef WHIRL_CLAIMS_H
#define WHIRL_CLAIMS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/case.h"
#include "whirl/result.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { WHIRL_MAX_CLAIM_LINES = 8 };

/// What somebody (a paper, a measurement) says of a point or of a range of a parameter. What is not said is not
/// compared.
typedef struct whirl_claim {
    char where[WHIRL_NAME_SIZE]; ///< "Fig. 4"
    char says[400];              ///< in words
    double from, to;             ///< value or range of the parameter; from = to for one point
    bool has_regime;
    whirl_regime regime;
    int period; ///< 0: any
    int curves; ///< closed curves of a quasi-periodic section; 0: any
    bool has_contact, contact;
    size_t line_count;
    double lines[WHIRL_MAX_CLAIM_LINES]; ///< orders that the spectrum shows
    bool only_lines;                     ///< and no others
    bool has_band;
    double band[2]; ///< orders between which the large lines below the running speed lie
    bool has_whirl;
    char whirl[WHIRL_NAME_SIZE]; ///< "forward", "backward"
} whirl_claim;

/// A list of claims with where they come from.
typedef struct whirl_claims {
    char source[400];
    char parameter[WHIRL_NAME_SIZE];
    char station[WHIRL_NAME_SIZE]; ///< whose spectrum is meant
    size_t count;
    whirl_claim *items;
} whirl_claims;

/// Reads a claims file (YAML, see cases/paper-claims.yaml). Problems as for cases. Freed by whirl_claims_free.
whirl_status whirl_claims_load(const char *path, whirl_problems *problems, whirl_claims **claims);
void whirl_claims_free(whirl_claims *claims);

/// The groups of keys of a claims file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_claims_groups(void);

typedef enum whirl_agreement {
    WHIRL_NOT_COMPARED = 0,
    WHIRL_AGREES,
    WHIRL_AGREES_PARTLY,
    WHIRL_DISAGREES
} whirl_agreement;

/// Sets a claim beside a result: agreement, and what was found in words (at most `size` bytes).
whirl_agreement whirl_claim_compare(const whirl_claims *claims, const whirl_claim *claim, const whirl_result *result,
                                    char *found, size_t size);

#ifdef __cplusplus
}
#endif
#endif
