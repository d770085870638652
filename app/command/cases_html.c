#include "command/cases_html.h"

#include <inttypes.h>

#include "document/html.h"
#include "result/cases.h"

/* The colours are the palette's: blue for passed, orange-brown for failed, with a contrast of at least 4.5:1. */
static const char head[] =
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<title>clearance: verification</title>\n<style>\n"
    ":root{color-scheme:light dark;--paper:#FFFFFF;--panel:#F4F5F6;--text:#1B1D21;--dim:#4A5056;--line:#C9CDD1;"
    "--yes:#0068A8;--no:#A23F00;--band:#BBD6E8}\n"
    "@media(prefers-color-scheme:dark){:root{--paper:#14171B;--panel:#1E2227;--text:#E8EAED;--dim:#A9B3BA;"
    "--line:#3A4149;--yes:#56B4E9;--no:#F08A24;--band:#234A62}}\n"
    "*{box-sizing:border-box}\n"
    "body{margin:0 auto;max-width:100rem;padding:1.5rem;background:var(--paper);color:var(--text);"
    "font:1.25rem/1.4 system-ui,'DejaVu Sans',sans-serif;font-variant-numeric:tabular-nums}\n"
    "h1{font-size:2.6rem;line-height:1.15;margin:0 0 .5rem}\n"
    "h2{font-size:1.8rem;margin:2.5rem 0 .8rem}\n"
    "p{margin:.2rem 0 1rem;color:var(--dim)}\n"
    "table{border-collapse:collapse;width:100%}\n"
    "th{text-align:left;color:var(--dim);font-weight:600}\n"
    "th,td{padding:.55rem .8rem;border-bottom:1px solid var(--line);vertical-align:top}\n"
    "tr.case td{background:var(--panel);border-top:3px solid var(--line)}\n"
    "tr.case b{font-size:1.5rem}\n"
    ".note,.why{color:var(--dim);font-size:1.1rem}\n"
    ".why{color:var(--text)}\n"
    ".ours{font-size:1.6rem;font-weight:700;white-space:nowrap}\n"
    ".verdict{font-size:1.5rem;font-weight:700;white-space:nowrap}\n"
    ".yes{color:var(--yes)}.no{color:var(--no)}.rest{color:var(--dim)}\n"
    "summary{cursor:pointer;color:var(--dim)}\n"
    "svg.ruler{width:15rem;height:3rem;display:block;overflow:visible}\n"
    "svg.sign{width:1.5rem;height:1.5rem;vertical-align:-.25rem;margin-right:.4rem}\n"
    "@media(max-width:60rem){svg.ruler{width:9rem}.wide{display:none}}\n"
    "@media print{details{display:block}}\n"
    "</style></head><body>\n";

static const char *verdict_class(Verdict verdict) {
    return verdict == VERDICT_PASSED ? "yes" : verdict == VERDICT_FAILED ? "no" : "rest";
}

/* Adds a disc with a tick, a square with a cross, or a dash. */
static void add_sign(Text *text, Verdict verdict, const char *passed) {
    static const char *const signs[] = {
        [VERDICT_NOT_RUN] =
            "<path d=\"M3 12h18\" stroke=\"currentColor\" stroke-width=\"4\" stroke-dasharray=\"4 3\"/>",
        [VERDICT_PASSED] = "<circle cx=\"12\" cy=\"12\" r=\"11\" fill=\"currentColor\"/><path d=\"M6 12.5l4 4 8-9\" "
                           "fill=\"none\" stroke=\"var(--paper)\" stroke-width=\"3\"/>",
        [VERDICT_FAILED] = "<rect x=\"1\" y=\"1\" width=\"22\" height=\"22\" fill=\"currentColor\"/><path d=\"M7 7l10 "
                           "10M17 7L7 17\" stroke=\"var(--paper)\" stroke-width=\"3\"/>",
        [VERDICT_DOES_NOT_APPLY] = "<path d=\"M3 12h18\" stroke=\"currentColor\" stroke-width=\"4\"/>"};
    text_format(
        text,
        "<span class=\"verdict %s\"><svg class=\"sign\" viewBox=\"0 0 24 24\" aria-hidden=\"true\">%s</svg>%s</span>",
        verdict_class(verdict), signs[verdict], passed);
}

/* Draws the allowed band and the value on a line from `from` to `to`, in the unit of the check. */
static void add_ruler(Text *text, const VerificationCheck *check) {
    bool has_low = check->condition.low > -HUGE_VAL, has_high = check->condition.high < HUGE_VAL;
    double low = has_low ? check->condition.low : fmin(0, fmin(check->condition.high, check->condition.value));
    double high = has_high ? check->condition.high : fmax(2 * fabs(check->condition.low), check->condition.value);
    double from = fmin(low, check->condition.value), to = fmax(high, check->condition.value);
    double room = fmax(0.15 * (to - from), 0.05 * fmax(fabs(to), 1));
    from = has_low || from < 0 ? from - room : from;
    to += room;
    double scale = 240 / (to - from);
    double left = has_low ? (low - from) * scale : 0, right = has_high ? (high - from) * scale : 240;
    double at = (check->condition.value - from) * scale;
    text_format(
        text,
        "<svg class=\"ruler\" viewBox=\"0 0 240 48\" role=\"img\" aria-label=\"the value on a ruler with its limits\">"
        "<path d=\"M0 20h240\" stroke=\"var(--line)\" stroke-width=\"2\"/>");
    text_format(text, "<rect x=\"%.1f\" y=\"12\" width=\"%.1f\" height=\"16\" fill=\"var(--band)\"/>", left,
                fmax(right - left, 3));
    const double limits[2] = {left, right}, numbers[2] = {check->condition.low, check->condition.high};
    const bool has[2] = {has_low, has_high && check->condition.high > check->condition.low};
    for (int l = 0; l < 2; l++)
        if (has[l])
            text_format(text,
                        "<path d=\"M%.1f 8v24\" stroke=\"var(--text)\" stroke-width=\"2\"/><text x=\"%.1f\" y=\"46\" "
                        "font-size=\"14\" text-anchor=\"%s\" fill=\"var(--dim)\">%g</text>",
                        limits[l], limits[l], has[0] && has[1] && right - left < 50 ? l ? "start" : "end" : "middle",
                        numbers[l]);
    bool passed = check->condition.verdict == VERDICT_PASSED;
    if (passed)
        text_format(text, "<circle cx=\"%.1f\" cy=\"20\" r=\"8\" fill=\"var(--yes)\"/>", at);
    else
        text_format(text, "<rect x=\"%.1f\" y=\"12\" width=\"16\" height=\"16\" fill=\"var(--no)\"/>", at - 8);
    text_add(text, "</svg>");
}

static void add_check(Text *text, const VerificationCheck *check, const ResultTable *checks, size_t c) {
    const char *value = result_at(checks, c, CHECK_VALUE)->text;
    text_add(text, "<tr><td>");
    html_add_escaped(text, result_at(checks, c, CHECK_QUESTION)->text);
    if (check->seeds > 1)
        text_format(text, " <span class=\"note\">(mean of %d seeds)</span>", check->seeds);
    if (check->condition.verdict == VERDICT_FAILED) {
        text_add(text, "<div class=\"why\">");
        html_add_escaped(text, result_at(checks, c, CHECK_WHY)->text);
        text_add(text, "</div>");
    }
    text_add(text, "</td><td>");
    html_add_escaped(text, result_at(checks, c, CHECK_CRITERION)->text);
    text_add(text, "</td><td class=\"ours\">");
    html_add_escaped(text, value ? value : "-");
    text_add(text, "</td><td class=\"wide\">");
    if (isfinite(check->condition.value))
        add_ruler(text, check);
    text_add(text, "</td><td>");
    add_sign(text, check->condition.verdict, result_at(checks, c, CHECK_PASSED)->text);
    text_add(text, "</td></tr>\n");
}

static void add_case(Text *text, const Verification *verification) {
    text_add(text, "<tr class=\"case\"><td colspan=\"5\"><b>");
    html_add_escaped(text, verification->suite);
    text_add(text, "</b> ");
    html_add_escaped(text, verification->title);
    if (*verification->note) {
        text_add(text, "<details><summary>source and assumptions</summary><div class=\"note\">");
        html_add_escaped(text, verification->note);
        text_add(text, "</div></details>");
    }
    text_add(text, "</td></tr>\n");
    ResultTable checks = result_cases_checks(verification);
    for (size_t c = 0; c < checks.record_count; c++)
        add_check(text, &verification->checks[c], &checks, c);
    result_clear(&checks);
}

static void add_excluded(Text *text, const ResultTable *excluded) {
    text_add(text,
             "<h2>These do not apply</h2>\n<table><thead><tr><th>Test</th><th>Why not</th></tr></thead><tbody>\n");
    for (size_t i = 0; i < excluded->record_count; i++) {
        text_add(text, "<tr><td><b>");
        html_add_escaped(text, result_at(excluded, i, EXCLUDED_SUITE)->text);
        text_add(text, "</b> ");
        html_add_escaped(text, result_at(excluded, i, EXCLUDED_TITLE)->text);
        text_add(text, "</td><td>");
        html_add_escaped(text, result_at(excluded, i, EXCLUDED_REASON)->text);
        text_add(text, "</td></tr>\n");
    }
    text_add(text, "</tbody></table>\n");
}

void cases_html_add(Text *text, const Verification *cases, size_t count, uint64_t seed) {
    Arena arena = {0};
    ResultTable excluded = result_cases_excluded(cases, count);
    text_add(text, head);
    text_format(text, "<h1>%s</h1>\n", result_cases_summary(cases, count, &arena));
    text_format(
        text,
        "<p>Tests that others published for programs like this one, run by <code>clearance cases</code> %s with seeds "
        "from %" PRIu64 ". The band is what a test allows; a disc lies in it, a square does not.</p>\n",
        CLEARANCE_VERSION, seed);
    text_add(text, "<table><thead><tr><th>Test</th><th>Criterion</th><th>Ours</th><th class=\"wide\"></th>"
                   "<th>Passed</th></tr></thead><tbody>\n");
    for (size_t i = 0; i < count; i++)
        if (cases[i].applies)
            add_case(text, &cases[i]);
    text_add(text, "</tbody></table>\n");
    if (excluded.record_count)
        add_excluded(text, &excluded);
    text_add(text, "</body></html>\n");
    result_clear(&excluded);
    arena_clear(&arena);
}
