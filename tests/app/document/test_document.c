#include "check.h"

#include <cairo.h>
#include <errno.h>
#include <glib.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "document/html.h"
#include "document/pdf.h"
#include "scratch.h"
#include "paint/cairo_file.h"
#include "draw/text.h"
#include "base/memory.h"

static const char NASTY[] = "<b>&\"'</b> ]]> -->";

/* Returns a document with all elements and with texts that need escaping. */
static Document nasty_document(void) {
    static const Column columns[] = {{NASTY, ALIGN_LEFT}, {"number", ALIGN_RIGHT}};
    Document document = document_begin("clearance 9");
    document_add_title(&document, NASTY, NASTY);
    document_add_contents(&document);
    document_add_heading(&document, 2, NASTY);
    document_add_paragraph(&document, NASTY);
    document_add_note(&document, NASTY);
    document_add_command(&document, NASTY);
    document_add_heading(&document, 3, "below");
    document_add_table(&document, NASTY, columns, 2);
    document_add_row(&document, (const char *const[]){NASTY, NULL});
    Scene scene = {.box = {{0, 0}, {2, 1}}, .bare = true};
    scene_add_label(&scene, ROLE_TEXT, 17, vec2(1, 0.5), NASTY);
    document_add_figures(&document);
    document_add_scene(&document, &scene, vec2(300, 200), NASTY, NASTY);
    return document;
}

static char *html_of(const Document *document) {
    char path[SCRATCH_PATH];
    scratch_write(path, "");
    CHECK(html_write(document, path, THEME_PAPER) == 0);
    char *text = scratch_read(path);
    unlink(path);
    return text;
}

/* Cairo's files contain zero bytes, so a text cannot hold them. */
static char *pdf_of(const Document *document, time_t created, size_t *size) {
    char path[SCRATCH_PATH];
    scratch_write(path, "");
    CHECK(pdf_write(document, path, created) == 0);
    char *bytes = text_read_file(path, 1 << 24, size);
    CHECK(bytes);
    unlink(path);
    return bytes;
}

static size_t count_of(const char *bytes, size_t size, const char *what) {
    size_t found = 0, length = strlen(what);
    for (size_t i = 0; i + length <= size; i++)
        found += memcmp(bytes + i, what, length) == 0;
    return found;
}

/* True if every element is closed by its own name in the right order. */
static bool is_well_formed(const char *text) {
    const char *open[64];
    size_t depth = 0;
    for (const char *at = strchr(text, '<'); at; at = strchr(at + 1, '<')) {
        const char *end = strchr(at, '>');
        if (!end)
            return false;
        if (at[1] == '!' || end[-1] == '/')
            continue;
        if (at[1] != '/') {
            if (depth == 64)
                return false;
            open[depth++] = at + 1;
            continue;
        }
        size_t length = (size_t)(end - at) - 2;
        if (!depth || strncmp(open[--depth], at + 2, length) != 0 || !strchr(" >", open[depth][length]))
            return false;
    }
    return depth == 0;
}

TEST(texts_are_made_plain) {
    Document document = document_begin("");
    CHECK_TEXT(document_text(&document, "a\x01\tb\x7f"), "a\\u0001 b\\u007f");
    CHECK_TEXT(document_text(&document, "%s", "\xff\xc3"), "\xef\xbf\xbd\xef\xbf\xbd");
    CHECK_TEXT(document_text(&document, "%s", "\xef\xbf\xbe"), "\xef\xbf\xbd");
    CHECK_TEXT(document_text(&document, "%s", "\xef\xb7\x90"), "\xef\xbf\xbd");
    CHECK_TEXT(document_text(&document, "%s", "日本\n2 m\xc2\xb2"), "日本\n2 m\xc2\xb2");
    document_clear(&document);
}

TEST(a_number_stays_with_its_unit_but_in_commands) {
    Document document = document_begin("");
    document_add_paragraph(&document, "18.4 s, 2 metres, 3 m, 5 %");
    document_add_command(&document, "echo 3 m");
    CHECK_TEXT(document.blocks[0].text, "18.4\u00a0s, 2 metres, 3\u00a0m, 5\u00a0%");
    CHECK_TEXT(document.blocks[1].text, "echo 3 m");
    document_clear(&document);
}

TEST(html_holds_texts_as_texts_and_closes_what_it_opens) {
    Document document = nasty_document();
    char *html = html_of(&document);
    CHECK(is_well_formed(html));
    CHECK(!strstr(html, "<b>"));
    CHECK(count_of(html, strlen(html), "&lt;b&gt;&amp;&quot;&#39;&lt;/b&gt; ]]&gt; --&gt;") == 15);
    CHECK(strstr(html, "<th scope=\"row\">") && strstr(html, "<th scope=\"col\">") &&
          strstr(html, "<td class=\"right\">-</td>"));
    CHECK(!is_well_formed("<p><b></p></b>") && !is_well_formed("<p>") && is_well_formed("<p a='b'><br/></p>"));
    memory_free(html);
    document_clear(&document);
}

TEST(the_same_document_is_the_same_bytes) {
    Document document = nasty_document(), again = nasty_document();
    char *html[] = {html_of(&document), html_of(&again)};
    CHECK_TEXT(html[0], html[1]);
    size_t sizes[3];
    char *pdf[] = {pdf_of(&document, 1000, &sizes[0]), pdf_of(&again, 1000, &sizes[1]),
                   pdf_of(&again, 2000, &sizes[2])};
    CHECK(sizes[0] == sizes[1] && memcmp(pdf[0], pdf[1], sizes[0]) == 0);
    CHECK(sizes[0] != sizes[2] || memcmp(pdf[0], pdf[2], sizes[0]) != 0); /* the file states its time */
    for (int i = 0; i < 3; i++)
        memory_free(pdf[i]);
    memory_free(html[0]);
    memory_free(html[1]);
    document_clear(&document);
    document_clear(&again);
}

/* Arguments of a requested picture. */
typedef struct Asked {
    Vec2 size;
    Theme theme;
    int lines, released;
} Asked;

static void paint_lines(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    Asked *asked = (Asked *)(uintptr_t)context;
    asked->size = size;
    asked->theme = theme;
    for (int i = 0; i < asked->lines; i++) {
        cairo_move_to(cairo, 0, i % 97);
        cairo_line_to(cairo, size.x, i % 89);
        cairo_stroke(cairo);
    }
}

static void release_lines(void *context) {
    ((Asked *)context)->released++;
}

/* Returns the first picture of a page, decoded. */
static guchar *picture_in(const char *html, const char *type, gsize *size) {
    const char *from = strstr(html, type);
    CHECK(from);
    from = strchr(from ? from : ",", ',') + 1;
    char *text = g_strndup(from, strcspn(from, "\""));
    guchar *bytes = g_base64_decode(text, size);
    g_free(text);
    return bytes;
}

static void check_lines(int lines, const char *type, const char *begin, size_t length) {
    Asked asked = {.lines = lines};
    Document document = document_begin("");
    document_add_figures(&document);
    document_add_picture(&document, paint_lines, &asked, vec2(120, 100), NULL, "lines")->release = release_lines;
    char *html = html_of(&document);
    gsize size;
    guchar *bytes = picture_in(html, type, &size);
    CHECK(size > length && memcmp(bytes, begin, length) == 0);
    CHECK(asked.size.x == 120 && asked.size.y == 100 && asked.theme == THEME_PAPER);
    g_free(bytes);
    memory_free(html);
    document_clear(&document);
    CHECK(asked.released == 1);
}

TEST(a_picture_is_inside_as_svg_and_one_of_very_many_lines_as_png) {
    check_lines(3, "image/svg+xml;base64", "<?xml", 5);
    check_lines(20000, "image/png;base64", "\x89PNG", 4);
}

static size_t pages_of(const Document *document) {
    size_t size;
    char *pdf = pdf_of(document, 0, &size);
    size_t pages = count_of(pdf, size, "/Type /Page %");
    memory_free(pdf);
    return pages;
}

TEST(what_does_not_fit_on_a_page_goes_on_on_the_next) {
    Document document = document_begin("");
    document_add_title(&document, "subject", "title");
    CHECK(pages_of(&document) == 1);
    for (int i = 0; i < 60; i++)
        document_add_paragraph(&document, "a line on the first page or the second");
    CHECK(pages_of(&document) == 2);
    document_clear(&document);
}

TEST(a_cell_or_a_note_longer_than_a_page_does_no_harm) {
    static const Column columns[] = {{"a", ALIGN_LEFT}, {"b", ALIGN_LEFT}};
    enum { LONG = 40000 };
    char *text = memory_zeroed(LONG + 1, 1);
    for (int i = 0; i < LONG; i++)
        text[i] = i % 9 == 8 ? ' ' : 'm';
    Document document = document_begin("");
    document_add_title(&document, text, text);
    document_add_note(&document, text);
    document_add_table(&document, NULL, columns, 2);
    document_add_row(&document, (const char *const[]){text, "short"});
    document_add_row(&document, (const char *const[]){"short", "short"});
    size_t pages = pages_of(&document);
    CHECK(pages > 10 && pages < 120);
    memory_free(text);
    document_clear(&document);
}

TEST(a_place_that_cannot_be_written_is_told) {
    Document document = nasty_document();
    CHECK(html_write(&document, "/nowhere/report.html", THEME_PAPER) == ENOENT);
    CHECK(pdf_write(&document, "/nowhere/report.pdf", 0) == ENOENT);
    document_clear(&document);
}

static void paint_letters(cairo_t *cairo, Vec2 page, const void *what) {
    text_show(cairo, what, 12, false, vec2_scale(page, 0.5));
}

TEST(a_pdf_that_lacks_an_object_is_seen_not_to_be_whole) {
    Bytes pdf = {0};
    CHECK(cairo_file_bytes(CAIRO_FILE_PDF, &pdf, 200, 100, 1, paint_letters, "letters") == 0);
    CHECK(cairo_file_pdf_is_whole(&pdf));
    for (char *entry = strstr(pdf.at + pdf.size - 40, "startxref"); entry > pdf.at; entry--) {
        if (strncmp(entry, " 00000 n", 8) != 0)
            continue;
        entry[-1] ^= 1; /* its place is another one, as that of a font that was left out */
        CHECK(!cairo_file_pdf_is_whole(&pdf));
        entry[-1] ^= 1;
    }
    pdf.size /= 2;
    CHECK(!cairo_file_pdf_is_whole(&pdf));
    memory_free(pdf.at);
}
