// Writes the figures with their captions, and links to their pictures, scripts and data.
#include "html.h"
#include "page.h"

static void write_links(const page *to, const drawn_figure *what) {
    const char *folder = to->folders[what->result];
    fputs(" <span class=\"soft\">", to->stream);
    if (what->drawn) fprintf(to->stream, "<a href=\"%s/%s.pdf\">PDF</a>, ", folder, what->name.name);
    fprintf(to->stream, "<a href=\"%s/%s.gp\">script</a>", folder, what->name.name);
    fprintf(to->stream, ", <a href=\"%s/%s.dat\">data</a>", folder, what->name.name);
    fputs("</span>", to->stream);
}

void page_figure(const page *to, const drawn_figure *what) {
    const char *folder = to->folders[what->result];
    fputs("<figure>\n", to->stream);
    if (what->drawn) {
        fprintf(to->stream, "<a href=\"%s/%s.png\"><img%s src=\"%s/%s.png\" alt=\"", folder, what->name.name,
                to->printed ? "" : " loading=\"lazy\"", folder, what->name.name);
        html_text(to->stream, what->name.title);
        fputs("\"></a>\n", to->stream);
    } else {
        fputs("<div class=\"missing\">This figure was not drawn; its script and data are next to this page.</div>\n",
              to->stream);
    }
    fputs("<figcaption>", to->stream);
    html_text(to->stream, what->caption);
    write_links(to, what);
    fputs("</figcaption>\n</figure>\n", to->stream);
}

/// Returns true if a figure is a diagram of a result.
static bool is_diagram(const drawn_figure *of, size_t index) {
    return of->result == index && of->name.point < 0 && !of->whole;
}

const drawn_figure *page_main_figure(const page *to, size_t index) {
    for (size_t i = 0; i < to->figures->count; i++)
        if (is_diagram(&to->figures->items[i], index)) return &to->figures->items[i];
    return NULL;
}

void page_machine(const page *to, size_t index) {
    for (size_t i = 0; i < to->figures->count; i++)
        if (to->figures->items[i].result == index && to->figures->items[i].whole)
            page_figure(to, &to->figures->items[i]);
}

const char *page_diagrams_title(const whirl_result *result) {
    return whirl_result_role(result, WHIRL_ROLE_MAP)     ? "Maps"
           : whirl_result_role(result, WHIRL_ROLE_BASIN) ? "Basins"
                                                         : "Diagrams";
}

void page_figures(const page *to, size_t index) {
    bool points = false, diagrams = false;
    // Write figures of diagrams, then of single points; the main figure is shown elsewhere.
    for (size_t i = 0; i < to->figures->count; i++) {
        const drawn_figure *what = &to->figures->items[i];
        if (what->result != index || what->whole || what == page_main_figure(to, index)) continue;
        // Begin each of the two groups with a heading.
        if (what->name.point < 0) {
            if (!diagrams)
                fprintf(to->stream, "<h3 id=\"diagrams-%zu\">%s</h3>\n<div class=\"pair\">\n", index + 1,
                        page_diagrams_title(to->results[index]));
            diagrams = true;
        } else {
            if (!points && diagrams) fputs("</div>\n", to->stream);
            if (!points)
                fprintf(to->stream,
                        "<h3 id=\"motions-%zu\">Motion at single points</h3>\n<p>One figure a station; its caption "
                        "explains "
                        "the letters of the panels.</p>\n<div class=\"pair\">\n",
                        index + 1);
            points = true;
        }
        page_figure(to, what);
    }
    if (points || diagrams) fputs("</div>\n", to->stream);
}
