#include "document/html.h"

#include <glib.h>

#include "base/file_write.h"
#include "base/text.h"
#include "document/picture.h"

#define POINTS_A_REM 16.4 /* design points: makes the text of pictures as large as the text around them */

/* Sizes follow the reader's own text size, so that 200 % works as well as 100 %. */
static const char style[] =
    "*{box-sizing:border-box}\n"
    "html{font-size:112.5%}\n"
    "body{margin:0;background:var(--paper);color:var(--text);"
    "font-family:'DejaVu Sans',Verdana,system-ui,sans-serif;line-height:1.5;font-variant-numeric:tabular-nums}\n"
    "main{max-width:62rem;margin:0 auto;padding:2rem 1.25rem 4rem}\n"
    "p,li,td,th,caption,figcaption{white-space:pre-line}\n"
    "p{max-width:44rem;margin:.6rem 0}\n"
    "h1{font-size:2.3rem;line-height:1.2;margin:0 0 1rem}\n"
    "h2{font-size:1.5rem;line-height:1.25;margin:2.8rem 0 .8rem;padding-top:.9rem;border-top:2px solid var(--line)}\n"
    "h3{font-size:1.1rem;margin:1.8rem 0 .5rem}\n"
    ".above{color:var(--dim);margin:0 0 .3rem}\n"
    ".note{background:var(--panel);border-left:.35rem solid var(--mark);padding:.7rem 1rem;max-width:none}\n"
    "nav ul{list-style:none;display:flex;flex-wrap:wrap;gap:.3rem 1.4rem;padding:0;margin:1rem 0}\n"
    "a{color:var(--link)}\n"
    "a:focus-visible,div:focus-visible{outline:3px solid var(--link);outline-offset:2px}\n"
    "pre{background:var(--panel);border:1px solid var(--line);padding:.7rem 1rem;white-space:pre-wrap;"
    "overflow-wrap:anywhere;font:.9rem/1.5 'DejaVu Sans Mono',ui-monospace,monospace}\n"
    ".scroll{overflow-x:auto;margin:1rem 0}\n"
    "table{border-collapse:collapse;min-width:min(100%,34rem);font-size:.9rem;line-height:1.35}\n"
    "caption{text-align:left;color:var(--dim);padding:0 0 .4rem}\n"
    "th,td{text-align:left;padding:.4rem .6rem;vertical-align:top;border-bottom:1px solid var(--line)}\n"
    "th:first-child,td:first-child{padding-left:0}\n"
    "thead th{border-bottom:2px solid var(--text);vertical-align:bottom}\n"
    "tbody th{font-weight:400}.quiet{color:var(--dim)}\n"
    ".right{text-align:right}\n"
    ".figures{display:flex;flex-wrap:wrap;gap:1.2rem;margin:1.2rem 0}\n"
    "figure{margin:0;flex:1 1 16rem;min-width:0}\n"
    "img{display:block;width:100%;height:auto;border:1px solid var(--line)}\n"
    "figcaption{color:var(--dim);font-size:.9rem;line-height:1.4;padding-top:.45rem}\n"
    "@media(max-width:40rem){.figures{display:block}figure{max-width:none!important;margin:0 0 1.2rem}"
    "h1{font-size:1.8rem}}\n"
    "@page{size:A4;margin:18mm 17mm}\n"
    "@media print{html{font-size:62.5%}main{max-width:none;padding:0}.scroll{overflow:visible}"
    "h1,h2,h3,caption{break-after:avoid}tr,figure,.note,pre{break-inside:avoid}thead{display:table-header-group}"
    "h2+p,h3+p{break-after:avoid}p,.note,pre{orphans:2;widows:2}}\n";

void html_add_escaped(Text *text, const char *plain) {
    for (const char *at = plain; *at; at++) {
        const char one[2] = {*at, 0};
        text_add(text, *at == '<'    ? "&lt;"
                       : *at == '>'  ? "&gt;"
                       : *at == '&'  ? "&amp;"
                       : *at == '"'  ? "&quot;"
                       : *at == '\'' ? "&#39;"
                                     : one);
    }
}

static void add_element(Text *text, const char *open, const char *plain, const char *close) {
    text_add(text, open);
    html_add_escaped(text, plain);
    text_add(text, close);
}

static void add_colour(Text *text, const char *name, Theme theme, Role role) {
    Colour colour = palette_colour(theme, role);
    text_format(text, "--%s:#%02X%02X%02X;", name, (unsigned)lround(255 * colour.red),
                (unsigned)lround(255 * colour.green), (unsigned)lround(255 * colour.blue));
}

static void add_head(Text *text, const Document *document, Theme theme) {
    text_add(text, "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
                   "<meta charset=\"utf-8\"/>\n"
                   "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>");
    add_element(text, "", document->title, " - ");
    add_element(text, "", document->subject, "</title>\n<meta name=\"generator\" content=\"");
    add_element(text, "", document->creator, "\"/>\n<style>\n:root{");
    add_colour(text, "paper", theme, ROLE_PAPER);
    add_colour(text, "panel", theme, ROLE_PANEL);
    add_colour(text, "text", theme, ROLE_TEXT);
    add_colour(text, "dim", theme, ROLE_DIM_TEXT);
    add_colour(text, "line", theme, ROLE_GRID);
    add_colour(text, "link", theme, ROLE_LOCUS);
    add_colour(text, "mark", theme, ROLE_DANGER_MIDDLE);
    text_format(text, "color-scheme:%s}\n", theme == THEME_BOARD ? "dark" : "light");
    text_add(text, style);
    text_add(text, "</style>\n</head>\n<body>\n<main>\n");
}

static void add_heading(Text *text, const Document *document, size_t index) {
    const Block *block = &document->blocks[index];
    if (block->level == 1)
        add_element(text, "<p class=\"above\">", document->subject, "</p>\n");
    text_format(text, "<h%d id=\"s%zu\">", block->level, index);
    html_add_escaped(text, block->text);
    text_format(text, "</h%d>\n", block->level);
}

static void add_contents(Text *text, const Document *document) {
    text_add(text, "<nav aria-label=\"Contents\"><ul>\n");
    for (size_t b = 0; b < document->count; b++) {
        const Block *block = &document->blocks[b];
        if (block->kind != BLOCK_HEADING || block->level != 2)
            continue;
        text_format(text, "<li><a href=\"#s%zu\">", b);
        add_element(text, "", block->text, "</a></li>\n");
    }
    text_add(text, "</ul></nav>\n");
}

static void add_row(Text *text, const Table *table, size_t row) {
    const char *const *cells = table->cells + row * table->column_count;
    text_add(text, "<tr>");
    for (size_t c = 0; c < table->column_count; c++) {
        bool right = table->columns[c].align == ALIGN_RIGHT, quiet = document_is_quiet(table, row, c);
        const char *class = right && quiet ? " class=\"right quiet\""
                            : right        ? " class=\"right\""
                            : quiet        ? " class=\"quiet\""
                                           : "";
        text_format(text, c ? "<td%s>" : "<th scope=\"row\"%s>", class);
        add_element(text, "", cells[c], c ? "</td>" : "</th>");
    }
    text_add(text, "</tr>\n");
}

/* A table wider than the window scrolls in its own box, also by the keyboard. */
static void add_table(Text *text, const Table *table) {
    text_add(text, "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"");
    add_element(text, "", table->caption ? table->caption : table->columns[0].head, "\"><table>\n");
    if (table->caption)
        add_element(text, "<caption>", table->caption, "</caption>\n");
    text_add(text, "<thead><tr>");
    for (size_t c = 0; c < table->column_count; c++) {
        text_format(text, "<th scope=\"col\"%s>", table->columns[c].align == ALIGN_RIGHT ? " class=\"right\"" : "");
        add_element(text, "", table->columns[c].head, "</th>");
    }
    text_add(text, "</tr></thead>\n<tbody>\n");
    for (size_t r = 0; r < table->row_count; r++)
        add_row(text, table, r);
    text_add(text, "</tbody></table></div>\n");
}

static void add_picture(Text *text, const Picture *picture, Theme theme) {
    PictureFile file = picture_file(picture, theme);
    char *encoded = g_base64_encode(file.bytes, file.size);
    text_format(text, "<figure style=\"max-width:%.1frem\"><img width=\"%.0f\" height=\"%.0f\" alt=\"",
                picture->size.x / POINTS_A_REM, picture->size.x, picture->size.y);
    html_add_escaped(text, picture->alternative);
    text_format(text, "\" src=\"data:%s;base64,", file.type);
    text_add(text, encoded);
    text_add(text, "\"/>\n");
    if (picture->caption)
        add_element(text, "<figcaption>", picture->caption, "</figcaption>");
    text_add(text, "</figure>\n");
    g_free(encoded);
    picture_clear(&file);
}

static void add_figures(Text *text, const Block *block, Theme theme) {
    text_add(text, "<div class=\"figures\">\n");
    for (size_t p = 0; p < block->picture_count; p++)
        add_picture(text, &block->pictures[p], theme);
    text_add(text, "</div>\n");
}

static void add_block(Text *text, const Document *document, size_t index, Theme theme) {
    const Block *block = &document->blocks[index];
    switch (block->kind) {
    case BLOCK_HEADING:
        add_heading(text, document, index);
        break;
    case BLOCK_CONTENTS:
        add_contents(text, document);
        break;
    case BLOCK_PARAGRAPH:
        add_element(text, "<p>", block->text, "</p>\n");
        break;
    case BLOCK_NOTE:
        add_element(text, "<p class=\"note\" role=\"note\">", block->text, "</p>\n");
        break;
    case BLOCK_COMMAND:
        add_element(text, "<pre><code>", block->text, "</code></pre>\n");
        break;
    case BLOCK_TABLE:
        add_table(text, &block->table);
        break;
    case BLOCK_FIGURES:
        add_figures(text, block, theme);
        break;
    }
}

int html_write(const Document *document, const char *path, Theme theme) {
    Text text = {0};
    add_head(&text, document, theme);
    for (size_t b = 0; b < document->count; b++)
        add_block(&text, document, b, theme);
    text_add(&text, "</main>\n</body>\n</html>\n");
    int error = file_write_bytes(path, text.text, text.used);
    memory_free(text.text);
    return error;
}
