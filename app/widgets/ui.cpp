/* The painter of the widgets: text and shapes by Dear ImGui's glyph atlas and its triangle lists. Nothing else of it
 * is used: no windows, no navigation, no input.
 *
 * Glyphs are as high as pango's, with capitals of whole pixels, so that their edges are crisp. The atlas has the
 * glyphs that Western European languages and this program's symbols need; others are added when they first occur, and
 * are visible from the next frame on. */
extern "C" {
#include "paint/paint_gl_screen.h"
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <imgui.h>
#include <vector>

#include "widgets/ui_painter.h"

#define FONTS "/usr/share/fonts/"

namespace {

constexpr const char *REGULAR = FONTS "truetype/dejavu/DejaVuSans.ttf";
constexpr const char *BOLD = FONTS "truetype/dejavu/DejaVuSans-Bold.ttf";
constexpr const char *JAPANESE = FONTS "opentype/ipafont-gothic/ipag.ttf";

/* For DejaVu Sans, in sizes: the height of capitals, and the height from the highest ascender to the lowest descender,
 * which ImGui calls the size. */
constexpr double CAPITAL = 1493.0 / 2048, SPAN = 2384.0 / 2048;

/* clang-format measures the width of such characters differently from version to version. */
/* clang-format off */
constexpr const char *SIGNS = "–—‘’“”„…•′″€™←↑→↓↔↕⇧−∞≈≠≤≥√∑Δ∂■□▪▲△▶▸▼▾◀◂◆◇○●◌✓✔✗✕⚠⏸▮"
                              "∆"
                              "αβγδεζηθκλμνξπρστφχψωΓΘΛΠΣΦΨΩ⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺₀₁₂₃₄₅₆₇₈₉\xEF\xBF\xBD";
/* clang-format on */

struct TextStyle {
    double size;
    bool bold;
};

constexpr TextStyle TEXT_SIZE[UI_TEXT_STYLES] = {{16, false}, {16, false}, {16, true}, {18, true},
                                                 {24, true},  {20, false}, {40, true}};

std::vector<unsigned char> file_bytes(const char *path) {
    std::vector<unsigned char> bytes;
    if (FILE *file = std::fopen(path, "rb")) {
        unsigned char part[65536];
        for (size_t count; (count = std::fread(part, 1, sizeof part, file)) > 0;)
            bytes.insert(bytes.end(), part, part + count);
        std::fclose(file);
    }
    return bytes;
}

ImU32 ink_of(UiInk ink) {
    return IM_COL32(ink & 255, ink >> 8 & 255, ink >> 16 & 255, ink >> 24);
}

/* Returns the next code of UTF-8; the replacement character for a broken one. */
unsigned next_code(const char **text, const char *end) {
    auto first = static_cast<unsigned char>(*(*text)++);
    int more = first < 0x80 ? 0 : first < 0xC0 ? -1 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    if (more < 0)
        return 0xFFFD;
    unsigned code = more == 0 ? first : first & (0x3Fu >> more);
    for (; more > 0; more--) {
        if (*text == end || (static_cast<unsigned char>(**text) & 0xC0) != 0x80)
            return 0xFFFD;
        code = code << 6 | (static_cast<unsigned char>(*(*text)++) & 0x3F);
    }
    return code;
}

bool is_japanese(unsigned code) {
    return code >= 0x2E80 && code < 0xE000;
}

} // namespace

/* A box of one colour, among the commands of a list. */
struct Ground {
    Colour colour;
    int left, top, width, height;
};

struct UiPainter {
    PaintGlScreen *screen;
    std::vector<UiPainted> painted; /* of this frame; their boxes and texts are found by ui_painter_painted */
    std::vector<const ImFont *> painted_fonts;
    std::vector<size_t> begins; /* of their texts in `letters` */
    std::vector<char> letters;
    ImGuiContext *context;
    std::vector<ImDrawList *> lists;
    ImDrawList *list;
    std::vector<ImDrawIdx> indices; /* of one command */
    std::vector<Ground> grounds;
    double unit;                 /* pixels per design point, of places */
    double made_unit, seen_unit; /* pixels per design point, of glyphs; of the frame before */
    std::vector<unsigned char> regular, bold, japanese;
    std::vector<bool> wanted; /* codes that the atlas has, or will have */
    bool wants_more, wants_japanese;
    std::vector<ImVec2> points;
    ImFont *fonts[UI_TEXT_STYLES];
    ScreenTexture atlas;
};

/* Glyphs ---------------------------------------------------------------------------------------------------------- */

namespace {

void want(UiPainter *painter, const char *text, const char *end) {
    while (text < end) {
        unsigned code = next_code(&text, end);
        if (code < 0x20 || code >= painter->wanted.size() || painter->wanted[code])
            continue;
        painter->wanted[code] = painter->wants_more = true;
        painter->wants_japanese |= is_japanese(code);
    }
}

ImVector<ImWchar> wanted_ranges(const UiPainter *painter) {
    ImVector<ImWchar> ranges;
    for (size_t code = 0x20; code < painter->wanted.size(); code++)
        if (painter->wanted[code]) {
            ranges.push_back(static_cast<ImWchar>(code));
            while (code + 1 < painter->wanted.size() && painter->wanted[code + 1])
                code++;
            ranges.push_back(static_cast<ImWchar>(code));
        }
    ranges.push_back(0);
    return ranges;
}

void add_font(ImFontAtlas *atlas, std::vector<unsigned char> &bytes, double size, const ImWchar *ranges, bool merged) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    config.MergeMode = merged;
    config.GlyphRanges = ranges;
    atlas->AddFontFromMemoryTTF(bytes.data(), static_cast<int>(bytes.size()), static_cast<float>(size), &config);
}

/* Without DejaVu, ImGui's built-in font is used, which has one size and no accents: text stays legible. */
void add_glyphs(UiPainter *painter, ImFontAtlas *atlas, const TextStyle &style, const ImWchar *ranges) {
    std::vector<unsigned char> &bytes = style.bold && !painter->bold.empty() ? painter->bold : painter->regular;
    double capital = std::round(CAPITAL * style.size * painter->made_unit);
    if (bytes.empty()) {
        ImFontConfig config;
        config.SizePixels = static_cast<float>(std::round(style.size * painter->made_unit));
        atlas->AddFontDefault(&config);
        return;
    }
    add_font(atlas, bytes, capital / CAPITAL * SPAN, ranges, false);
    if (!painter->japanese.empty())
        add_font(atlas, painter->japanese, capital / CAPITAL, ranges, true);
}

void make_atlas(UiPainter *painter) {
    ImFontAtlas *atlas = ImGui::GetIO().Fonts;
    if (painter->wants_japanese && painter->japanese.empty())
        painter->japanese = file_bytes(JAPANESE);
    ImVector<ImWchar> ranges = wanted_ranges(painter);
    atlas->Clear();
    atlas->Flags = ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    for (const TextStyle &style : TEXT_SIZE)
        add_glyphs(painter, atlas, style, ranges.Data);
    unsigned char *pixels;
    int width, height;
    atlas->GetTexDataAsAlpha8(&pixels, &width, &height);
    paint_gl_screen_fill_mask(painter->screen, &painter->atlas, pixels, width, height);
    atlas->SetTexID(&painter->atlas);
    atlas->ClearTexData();
    for (int i = 0; i < UI_TEXT_STYLES; i++)
        painter->fonts[i] = atlas->Fonts[i];
    painter->wants_more = painter->wants_japanese = false;
}

/* A window that is being resized needs another glyph size in every frame: glyphs are made when the same size is needed
 * twice. */
void renew_atlas(UiPainter *painter) {
    bool settled = painter->made_unit == 0 || painter->unit == painter->seen_unit;
    painter->seen_unit = painter->unit;
    bool other = painter->made_unit != painter->unit && settled;
    if (other)
        painter->made_unit = painter->unit;
    if (other || painter->wants_more)
        make_atlas(painter);
}

float pixel(const UiPainter *painter, double place) {
    return static_cast<float>(std::round(place * painter->unit));
}

/* The first frame has the glyph size at once. */
const ImFont *font_of(UiPainter *painter, UiTextStyle style) {
    if (!painter->fonts[style])
        renew_atlas(painter);
    return painter->fonts[style];
}

ImVec2 exact(const UiPainter *painter, Vec2 place) {
    return ImVec2(static_cast<float>(place.x * painter->unit), static_cast<float>(place.y * painter->unit));
}

ImVec2 snapped(const UiPainter *painter, Vec2 place) {
    return ImVec2(pixel(painter, place.x), pixel(painter, place.y));
}

/* Marks the place of a ground among the commands of a list; never called. */
void mark_ground(const ImDrawList *, const ImDrawCmd *) {
}

float thickness(const UiPainter *painter, double width) {
    return std::fmax(1.0f, pixel(painter, width));
}

const ImVec2 *exact_points(UiPainter *painter, const Vec2 *points, size_t count) {
    painter->points.resize(count);
    for (size_t i = 0; i < count; i++)
        painter->points[i] = exact(painter, points[i]);
    return painter->points.data();
}

} // namespace

double ui_painter_size(UiTextStyle style) {
    return TEXT_SIZE[style].size;
}

Vec2 ui_painter_extent(UiPainter *painter, UiTextStyle style, const char *text, size_t bytes) {
    want(painter, text, text + bytes);
    const ImFont *font = font_of(painter, style);
    ImVec2 size = font->CalcTextSizeA(font->FontSize, HUGE_VALF, 0, text, text + bytes);
    return vec2_scale(vec2(size.x, size.y), 1 / painter->unit);
}

size_t ui_painter_wrap(UiPainter *painter, UiTextStyle style, const char *text, double width) {
    size_t line = std::strcspn(text, "\n");
    want(painter, text, text + line);
    const ImFont *font = font_of(painter, style);
    if (ui_painter_extent(painter, style, text, line).x <= width + 0.5 / painter->unit)
        return line;
    const char *end = font->CalcWordWrapPositionA(1, text, text + line, static_cast<float>(width * painter->unit));
    if (end == text) /* no glyph has room: the line gets one all the same */
        next_code(&end, text + line);
    const char *blank = end; /* ImGui would break a line behind a point, too: "0." and "040 m" */
    while (blank > text && *blank != ' ')
        blank--;
    return static_cast<size_t>((blank > text && end < text + line ? blank : end) - text);
}

namespace {

/* Notes a text for ui_painter_painted, which measures it: most frames are never asked for. */
void note_painted(UiPainter *painter, const ImFont *font, ImVec2 corner, const char *text, size_t bytes) {
    ImVec2 low = painter->list->GetClipRectMin(), high = painter->list->GetClipRectMax();
    Box clip = {vec2(low.x, low.y), vec2(high.x, high.y)};
    painter->begins.push_back(painter->letters.size());
    painter->letters.insert(painter->letters.end(), text, text + bytes);
    painter->letters.push_back(0);
    painter->painted_fonts.push_back(font);
    painter->painted.push_back({nullptr, {vec2(corner.x, corner.y), vec2(corner.x, corner.y)}, clip});
}

} // namespace

void ui_painter_text(UiPainter *painter, UiTextStyle style, UiInk ink, Vec2 at, const char *text, size_t bytes) {
    const ImFont *font = font_of(painter, style);
    want(painter, text, text + bytes);
    double capital = std::round(CAPITAL * TEXT_SIZE[style].size * painter->made_unit);
    double base = std::round(at.y * painter->unit + capital / 2);
    ImVec2 corner(pixel(painter, at.x), static_cast<float>(base) - font->Ascent);
    painter->list->AddText(font, font->FontSize, corner, ink_of(ink), text, text + bytes);
    note_painted(painter, font, corner, text, bytes);
}

const UiPainted *ui_painter_painted(UiPainter *painter, size_t *count) {
    *count = painter->painted.size();
    for (size_t i = 0; i < *count; i++) {
        UiPainted &one = painter->painted[i];
        const ImFont *font = painter->painted_fonts[i];
        one.text = painter->letters.data() + painter->begins[i];
        ImVec2 size = font->CalcTextSizeA(font->FontSize, HUGE_VALF, 0, one.text);
        one.box.high = vec2(one.box.low.x + size.x, one.box.low.y + size.y);
    }
    return painter->painted.data();
}

/* Shapes ----------------------------------------------------------------------------------------------------------- */

void ui_painter_ground(UiPainter *painter, Box box, Colour colour) {
    ImVec2 low = snapped(painter, box.low), high = snapped(painter, box.high);
    int left = static_cast<int>(low.x), top = static_cast<int>(low.y);
    painter->list->AddCallback(mark_ground, reinterpret_cast<void *>(painter->grounds.size()));
    painter->grounds.push_back({colour, left, top, static_cast<int>(high.x) - left, static_cast<int>(high.y) - top});
}

void ui_painter_box(UiPainter *painter, Box box, UiInk ink) {
    painter->list->AddRectFilled(snapped(painter, box.low), snapped(painter, box.high), ink_of(ink));
}

void ui_painter_frame(UiPainter *painter, Box box, double width, UiInk ink) {
    ImVec2 low = snapped(painter, box.low), high = snapped(painter, box.high);
    float wide = thickness(painter, width);
    ImU32 colour = ink_of(ink);
    painter->list->AddRectFilled(low, ImVec2(high.x, low.y + wide), colour);
    painter->list->AddRectFilled(ImVec2(low.x, high.y - wide), high, colour);
    painter->list->AddRectFilled(ImVec2(low.x, low.y + wide), ImVec2(low.x + wide, high.y - wide), colour);
    painter->list->AddRectFilled(ImVec2(high.x - wide, low.y + wide), ImVec2(high.x, high.y - wide), colour);
}

void ui_painter_polyline(UiPainter *painter, const Vec2 *points, size_t count, bool closed, double width, UiInk ink) {
    painter->list->AddPolyline(exact_points(painter, points, count), static_cast<int>(count), ink_of(ink),
                               closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                               static_cast<float>(std::fmax(1, width * painter->unit)));
}

void ui_painter_convex(UiPainter *painter, const Vec2 *points, size_t count, UiInk ink) {
    painter->list->AddConvexPolyFilled(exact_points(painter, points, count), static_cast<int>(count), ink_of(ink));
}

void ui_painter_disc(UiPainter *painter, Vec2 middle, double radius, UiInk ink) {
    painter->list->AddCircleFilled(exact(painter, middle), static_cast<float>(radius * painter->unit), ink_of(ink));
}

void ui_painter_image(UiPainter *painter, const ScreenTexture *texture, Box box) {
    painter->list->AddImage(const_cast<ScreenTexture *>(texture), snapped(painter, box.low),
                            snapped(painter, box.high));
}

void ui_painter_picture(UiPainter *painter, const ScreenTexture *texture, const Vec2 corners[4], double opacity) {
    painter->list->AddImageQuad(const_cast<ScreenTexture *>(texture), exact(painter, corners[3]),
                                exact(painter, corners[2]), exact(painter, corners[1]), exact(painter, corners[0]),
                                ImVec2(0, 0), ImVec2(1, 0), ImVec2(1, 1), ImVec2(0, 1),
                                IM_COL32(255, 255, 255, static_cast<int>(std::lround(255 * opacity))));
}

void ui_painter_clip(UiPainter *painter, Box box) {
    painter->list->PushClipRect(snapped(painter, box.low), snapped(painter, box.high), true);
}

void ui_painter_unclip(UiPainter *painter) {
    painter->list->PopClipRect();
}

bool ui_painter_is_stale(const UiPainter *painter) {
    return painter->wants_more || painter->unit != painter->made_unit;
}

void ui_painter_layer(UiPainter *painter, UiLayer layer) {
    painter->list = painter->lists[layer];
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

UiPainter *ui_painter_create(PaintGlScreen *screen) {
    auto *painter = new UiPainter();
    painter->screen = screen;
    painter->context = ImGui::CreateContext();
    painter->regular = file_bytes(REGULAR);
    painter->bold = file_bytes(BOLD);
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    painter->wanted.resize(0x10000);
    for (size_t code = 0x20; code < 0x100; code++)
        painter->wanted[code] = code < 0x7F || code >= 0xA0;
    want(painter, SIGNS, SIGNS + std::strlen(SIGNS));
    for (int i = 0; i < UI_LAYER_COUNT; i++)
        painter->lists.push_back(new ImDrawList(ImGui::GetDrawListSharedData()));
    painter->list = painter->lists[0];
    painter->unit = 1;
    return painter;
}

void ui_painter_destroy(UiPainter *painter) {
    paint_gl_screen_release(painter->screen, &painter->atlas);
    for (ImDrawList *list : painter->lists)
        delete list;
    ImGui::DestroyContext(painter->context);
    delete painter;
}

void ui_painter_begin(UiPainter *painter, int width, int height, double unit, double seconds) {
    ImGui::SetCurrentContext(painter->context);
    painter->unit = unit;
    renew_atlas(painter);
    ImGuiIO &io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    io.DeltaTime = static_cast<float>(std::fmax(seconds, 1e-4));
    ImGui::NewFrame();
    for (ImDrawList *list : painter->lists) {
        list->_ResetForNewFrame();
        list->PushTextureID(&painter->atlas);
        list->PushClipRect(ImVec2(0, 0), io.DisplaySize);
    }
    painter->list = painter->lists[UI_LAYER_PANES];
    painter->painted.clear();
    painter->painted_fonts.clear();
    painter->begins.clear();
    painter->letters.clear();
}

namespace {

void draw_ground(UiPainter *painter, const Ground &ground) {
    paint_gl_screen_box(painter->screen, ground.colour, ground.left, ground.top, ground.width, ground.height);
}

/* A command's triangles use only a few vertices of the list: only those are sent. */
void send(UiPainter *painter, const ImDrawList *list, const ImDrawCmd &command) {
    const ImDrawIdx *from = list->IdxBuffer.Data + command.IdxOffset;
    ImDrawIdx low = 0xFFFF, high = 0;
    for (unsigned i = 0; i < command.ElemCount; i++) {
        low = std::min(low, from[i]);
        high = std::max(high, from[i]);
    }
    painter->indices.resize(command.ElemCount);
    for (unsigned i = 0; i < command.ElemCount; i++)
        painter->indices[i] = static_cast<ImDrawIdx>(from[i] - low);
    const ImDrawVert *vertices = list->VtxBuffer.Data + command.VtxOffset + low;
    static_assert(sizeof(ImDrawVert) == sizeof(ScreenVertex) && sizeof(ImDrawIdx) == sizeof(unsigned short),
                  "as ImGui");
    int left = static_cast<int>(command.ClipRect.x), top = static_cast<int>(command.ClipRect.y);
    paint_gl_screen_mesh(painter->screen, reinterpret_cast<const ScreenVertex *>(vertices), size_t(high - low) + 1,
                         painter->indices.data(), command.ElemCount,
                         static_cast<const ScreenTexture *>(command.TextureId), left, top,
                         static_cast<int>(command.ClipRect.z) - left, static_cast<int>(command.ClipRect.w) - top);
}

} // namespace

void ui_painter_end(UiPainter *painter) {
    for (const ImDrawList *list : painter->lists)
        for (const ImDrawCmd &command : list->CmdBuffer)
            if (command.UserCallback == mark_ground)
                draw_ground(painter, painter->grounds[reinterpret_cast<size_t>(command.UserCallbackData)]);
            else if (command.ElemCount)
                send(painter, list, command);
    painter->grounds.clear();
    ImGui::EndFrame();
}
