// Writes the table of claims and findings.
#include <math.h>
#include <string.h>

#include "html.h"
#include "page.h"

static const struct {
    const char *text, *style, *mark;
} badges[] = {
    [WHIRL_NOT_COMPARED] = {"not compared", "none", "\u2013"},
    [WHIRL_AGREES] = {"agrees", "agrees", "\u2713"},
    [WHIRL_AGREES_PARTLY] = {"partly", "partly", "\u223c"},
    [WHIRL_DISAGREES] = {"disagrees", "disagrees", "\u2717"},
};

static const claim_outcome *outcome(const page *to, size_t claim, size_t result) {
    return &to->outcomes[claim * to->count + result];
}

static void write_badge(FILE *stream, whirl_agreement agreement) {
    fprintf(stream, "<span class=\"badge %s\">%s</span>", badges[agreement].style, badges[agreement].text);
}

/// Writes a line for each part of a claim; the lines have marks if there are several.
static void write_findings(FILE *stream, const claim_outcome *of) {
    fprintf(stream, "<ul class=\"findings%s\">", of->count > 1 ? " marked" : "");
    for (size_t i = 0; i < of->count; i++) {
        const claim_finding *one = &of->findings[i];
        fputs("<li>", stream);
        if (of->count > 1)
            fprintf(stream, "<span class=\"mark %s\" title=\"%s\">%s</span> ", badges[one->agreement].style,
                    badges[one->agreement].text, badges[one->agreement].mark);
        html_text(stream, one->text);
        fputs("</li>", stream);
    }
    if (*of->note) {
        fputs("<li class=\"soft\">", stream);
        html_text(stream, of->note);
        fputs("</li>", stream);
    }
    fputs("</ul>", stream);
}

/// Writes the value or the range of a claim.
static void write_values(const page *to, const whirl_claim *of) {
    html_printf(to->stream, "%s = %.4g", to->claims->parameter, of->from);
    if (of->from != of->to) html_printf(to->stream, " to %.4g", of->to);
    if (!*of->given) return;
    html_printf(to->stream, ", %s = %.4g", of->given, of->given_from);
    if (of->given_from != of->given_to) html_printf(to->stream, " to %.4g", of->given_to);
}

static void write_where(const page *to, const whirl_claim *claim) {
    html_text(to->stream, claim->where);
    fputs("<br><span class=\"soft small\">", to->stream);
    write_values(to, claim);
    fputs("</span>", to->stream);
}

static void write_table(const page *to) {
    // Write the head: a column for each result.
    html_table(to->stream, "Claims and findings", "claims");
    fputs("<thead><tr><th>Where</th><th>The source says</th>", to->stream);
    for (size_t r = 0; r < to->count; r++) {
        fprintf(to->stream, "<th><a href=\"#result-%zu\">", r + 1);
        html_text(to->stream, to->names[r]);
        fputs("</a></th>", to->stream);
    }
    fputs("</tr></thead>\n<tbody>\n", to->stream);
    // Write a row for each claim, with its outcome in each result.
    for (size_t c = 0; c < to->claims->count; c++) {
        fprintf(to->stream, "<tr id=\"claim-%zu\"><th scope=\"row\">", c + 1);
        write_where(to, &to->claims->items[c]);
        fputs("</th><td class=\"says\">", to->stream);
        html_text(to->stream, to->claims->items[c].says);
        fputs("</td>", to->stream);
        for (size_t r = 0; r < to->count; r++) {
            fputs("<td data-name=\"", to->stream);
            html_text(to->stream, to->names[r]);
            fputs("\">", to->stream);
            write_badge(to->stream, outcome(to, c, r)->agreement);
            write_findings(to->stream, outcome(to, c, r));
            fputs("</td>", to->stream);
        }
        fputs("</tr>\n", to->stream);
    }
    fputs("</tbody></table></div>\n", to->stream);
}

static void write_counts(const page *to) {
    static const whirl_agreement order[] = {WHIRL_AGREES, WHIRL_AGREES_PARTLY, WHIRL_DISAGREES, WHIRL_NOT_COMPARED};
    html_table(to->stream, "How many claims are met", "");
    fputs("<thead><tr><th>Result</th><th class=\"number\">agrees</th><th "
          "class=\"number\">partly</th>"
          "<th class=\"number\">disagrees</th><th class=\"number\">not compared</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t r = 0; r < to->count; r++) {
        size_t counts[4] = {0};
        for (size_t c = 0; c < to->claims->count; c++) counts[outcome(to, c, r)->agreement]++;
        fputs("<tr><th>", to->stream);
        html_text(to->stream, to->names[r]);
        fputs("</th>", to->stream);
        for (int i = 0; i < 4; i++) fprintf(to->stream, "<td class=\"number\">%zu</td>", counts[order[i]]);
        fprintf(to->stream, "</tr>\n");
    }
    fputs("</tbody></table></div>\n", to->stream);
}

/// Returns the best agreement of any result.
static whirl_agreement best(const page *to, size_t claim) {
    whirl_agreement found = WHIRL_NOT_COMPARED;
    for (size_t r = 0; r < to->count; r++) {
        const whirl_agreement here = outcome(to, claim, r)->agreement;
        if (here != WHIRL_NOT_COMPARED && (found == WHIRL_NOT_COMPARED || here < found)) found = here;
    }
    return found;
}

/// Writes where a claim fails and where it is met, for the results that come nearest to it.
static void write_missed(const page *to, size_t claim) {
    const whirl_claim *of = &to->claims->items[claim];
    const whirl_agreement reached = best(to, claim);
    fprintf(to->stream, "<li><a href=\"#claim-%zu\">", claim + 1);
    html_printf(to->stream, "%s, ", of->where);
    write_values(to, of);
    fputs("</a>", to->stream);
    bool first = true;
    for (size_t r = 0; r < to->count; r++) {
        char text[512];
        if (outcome(to, claim, r)->agreement != reached) continue;
        claim_whereabouts(to->claims, of, to->results[r], text, sizeof text);
        fputs(first ? ": " : "; ", to->stream);
        if (to->count > 1) html_printf(to->stream, "%s: ", to->names[r]);
        html_text(to->stream, text);
        first = false;
    }
    fputs("</li>\n", to->stream);
}

static void write_all_missed(const page *to) {
    size_t missed = 0;
    for (size_t c = 0; c < to->claims->count; c++) missed += best(to, c) >= WHIRL_AGREES_PARTLY;
    fputs("<h3 id=\"missed\">What was not reproduced</h3>\n", to->stream);
    if (missed == 0) {
        fputs("<p>Every claim that could be compared is met in full by at least one result.</p>\n", to->stream);
        return;
    }
    fprintf(to->stream,
            "<p>No result fully meets %zu of the %zu claims. The table has what was found instead; here is where "
            "along the sweep each fails%s, or how far off it is met:</p>\n<ul>\n",
            missed, to->claims->count, to->count > 1 ? " in the results that come nearest" : "");
    for (size_t c = 0; c < to->claims->count; c++)
        if (best(to, c) >= WHIRL_AGREES_PARTLY) write_missed(to, c);
    fputs("</ul>\n", to->stream);
}

void page_claims(const page *to) {
    // Explain how claims are compared.
    fputs("<section id=\"claims\">\n<h2>What the source says, and what was found</h2>\n"
          "<p>A claim about a range is compared at every point of the sweep within it: it <em>agrees</em> when all "
          "points do, <em>partly</em> when at least half of them do, or when some of the things it states hold and "
          "others do not (\u2713 holds, \u223c holds in part, \u2717 does not hold).</p>\n"
          "<details><summary>The rules of the comparison</summary>\n<ul>\n"
          "<li>A spectral line counts as present within 0.02 orders and from 5&nbsp;% of the largest line up; X is the "
          "running speed.</li>\n"
          "<li>A band of lines is met when three or more lines and three quarters of their power below the running "
          "speed lie in it.</li>\n"
          "<li>\u201cAgainst the rotation\u201d is the share of the time in which the station moves backward about the "
          "centre (0, 0), that is x&nbsp;y\u2032&nbsp;\u2212&nbsp;y&nbsp;x\u2032&nbsp;&lt;&nbsp;0. An orbit "
          "that does not enclose the centre moves so for about half of the time, whatever its sense. Backward whirl is "
          "met above 50&nbsp;%; "
          "\u201cdiverging\u201d where the motion leaves its bounds too.</li>\n"
          "<li>What branches have (folds, Hopf points, ...) is looked for in the range, or within 2&nbsp;% of a single "
          "value; the order of a whirl counts within 5&nbsp;%, and is that of the first Hopf point of the range.</li>\n"
          "</ul></details>\n",
          to->stream);
    // Count the outcomes, and show them.
    write_counts(to);
    write_table(to);
    write_all_missed(to);
    fputs("</section>\n", to->stream);
}
