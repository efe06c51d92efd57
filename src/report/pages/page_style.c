#include "page.h"

void page_style(FILE *stream) {
    static const char *const rules[] = {
        ":root{color-scheme:light dark;--paper:#fff;--ink:#1c1e21;--soft:#5d646c;--line:#d9dde2;--wash:#f5f6f8;"
        "--link:#00588f;--good:#00664a;--half:#8a5a00;--bad:#a63a00}",
        "@media (prefers-color-scheme:dark){:root{--paper:#16181b;--ink:#e4e6e9;--soft:#a0a7af;--line:#363b41;"
        "--wash:#1e2125;--link:#7cc0f0;--good:#4fc79b;--half:#e6b04d;--bad:#f0875a}}",
        "*{box-sizing:border-box}",
        "body{margin:0 auto;max-width:76rem;padding:2rem 1.5rem 5rem;background:var(--paper);color:var(--ink);"
        "font:16px/1.55 system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif}",
        "h1{font-size:1.7rem;line-height:1.25;margin:0 0 .5rem}",
        "h2{font-size:1.35rem;line-height:1.3;margin:3.2rem 0 .6rem;padding-top:1rem;border-top:2px solid var(--ink)}",
        "h3{font-size:1.05rem;margin:2.2rem 0 .5rem}",
        "p{max-width:46rem;margin:.6rem 0}",
        "a{color:var(--link)}",
        "li{max-width:60rem}li li{font-size:.9rem}",
        ".found{padding-left:1.1rem}.found>li{max-width:46rem;margin:.5rem 0}.notes{padding-left:1.1rem;margin:.2rem 0;"
        "color:var(--soft)}",
        ".soft{color:var(--soft)}.small{font-size:.86rem}",
        "nav ul{list-style:none;padding:0;margin:1rem 0;display:flex;flex-wrap:wrap;gap:.3rem 1.4rem}",
        "nav ul ul{margin:.1rem 0 0;gap:0 1rem;font-size:.86rem}",
        ".scroll{overflow-x:auto}.scroll:focus-visible{outline:2px solid var(--link);outline-offset:2px}",
        "h4{font-size:.95rem;margin:1.6rem 0 .3rem}",
        "tr:target{background:var(--wash)}",
        "table{border-collapse:collapse;font-size:.86rem;line-height:1.4;margin:.8rem "
        "0;font-variant-numeric:tabular-nums}",
        "th,td{text-align:left;vertical-align:top;padding:.38rem .75rem .38rem 0;border-bottom:1px solid var(--line)}",
        "thead th{border-bottom:1.5px solid var(--ink);font-weight:600;vertical-align:bottom}"
        "thead .whole{display:inline-block}",
        "tbody th{font-weight:600;white-space:nowrap}",
        ".number{text-align:right;white-space:nowrap}thead "
        ".number{white-space:normal}.whole{white-space:nowrap}.wide{min-width:13rem}",
        ".why{min-width:20rem;color:var(--soft)}",
        "tr.open td,tr.open th{border-bottom:0}",
        ".claims td{min-width:14rem;padding-top:.5rem;padding-bottom:.5rem}.claims td.says{min-width:11rem}"
        ".claims th{padding-top:.5rem}",
        ".findings{list-style:none;margin:.25rem 0 0;padding:0}.findings li{font-size:1em;margin:.1rem 0}"
        ".marked li{padding-left:1.25em;text-indent:-1.25em}"
        ".mark{display:inline-block;width:1.25em;text-indent:0;font-weight:700}.soft{font-weight:400}",
        ".badge{display:inline-block;font-weight:600;font-size:.8rem;padding:0 .45rem;border:1.5px "
        "solid;border-radius:.6rem;"
        "margin-bottom:.2rem;white-space:nowrap}",
        ".agrees{color:var(--good)}.partly{color:var(--half)}.disagrees{color:var(--bad)}.none{color:var(--soft)}",
        ".swatch{display:inline-block;width:.75em;height:.75em;border-radius:50%;margin-right:.45em;"
        "border:1px solid var(--soft);vertical-align:-.03em}",
        "dl{display:grid;grid-template-columns:max-content 1fr;gap:.2rem 1.2rem;font-size:.92rem;margin:.8rem 0}",
        "dt{color:var(--soft)}dd{margin:0;overflow-wrap:anywhere}",
        "figure{margin:1.6rem 0 2.4rem}",
        "figure img{display:block;width:100%;max-width:46rem;height:auto;background:#fff;border:1px solid var(--line)}",
        "figcaption{max-width:52rem;font-size:.86rem;margin-top:.5rem}",
        ".pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(26rem,1fr));gap:0 1.6rem}",
        ".missing{border:1px dashed var(--line);background:var(--wash);padding:2rem;max-width:52rem}",
        "details{margin:.8rem 0}summary{cursor:pointer;color:var(--link)}",
        "pre{overflow-x:auto;background:var(--wash);padding:1rem;font-size:.82rem;line-height:1.4}",
        // Put the contents next to the text on wide screens.
        "@media (min-width:90rem){body{max-width:96rem;display:grid;grid-template-columns:13rem minmax(0,1fr);"
        "column-gap:3rem}header{grid-column:2}nav{grid-column:1;grid-row:2;align-self:start;position:sticky;top:1.5rem;"
        "max-height:calc(100vh - 3rem);overflow-y:auto;font-size:.9rem}nav ul{display:block;margin:0}"
        "nav li{margin:.35rem 0}nav ul ul{display:block;padding-left:.9rem}main{grid-column:2}"
        "main>section:first-child>h2{margin-top:0}}",
        "@media screen and (max-width:45rem){body{padding:1rem 1rem 3rem}.claims thead{display:none}"
        ".claims,.claims tbody,.claims tr,.claims th,.claims td{display:block;min-width:0;border:0;padding:.1rem 0}"
        ".claims tr{padding:.8rem 0;border-bottom:1px solid var(--line)}.claims th br{display:none}.claims th "
        ".small{margin-left:.6em}"
        ".claims td[data-name]{padding-top:.5rem}.claims td[data-name]::before{content:attr(data-name)': "
        "';color:var(--soft)}"
        ".pair{grid-template-columns:1fr}dl{grid-template-columns:1fr;gap:0}dd{margin-bottom:.4rem}ul{padding-left:1."
        "2rem}}",
        "@media print{:root{color-scheme:light;--paper:#fff;--ink:#000;--soft:#444;--line:#bbb;--wash:#fff;--link:#000;"
        "--good:#00664a;--half:#8a5a00;--bad:#a63a00}body{font-size:10pt;max-width:none;padding:0}section+section>h2{"
        "break-before:page}"
        "figure,tr{break-inside:avoid}h2,h3,h4,h2+p,h3+p,h4+p,thead{break-after:avoid}nav,summary{display:none}"
        "a{text-decoration:none}figure img{width:auto;max-width:18cm;max-height:9.3cm;border:0}"
        "figure{margin:.6rem 0 1rem}figcaption .soft{display:none}.pair{display:block}.scroll{overflow:visible}"
        "dl{display:block}dt{float:left;clear:left;white-space:nowrap;margin-right:.4cm}dd{margin:0 0 .1rem 5.4cm}"
        ".claims td,.why,.wide{min-width:0}table{font-size:7.5pt}th,td{padding:.16rem .5rem .16rem 0}"
        "pre{font-size:7pt;white-space:pre-wrap}}",
        "@page{size:A4;margin:16mm 15mm 18mm;@bottom-right{content:counter(page) ' / ' counter(pages);font-size:8pt}}",
    };
    fputs("<style>\n", stream);
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) fprintf(stream, "%s\n", rules[i]);
    fputs("</style>\n", stream);
}
