/* The pencil of the widgets: letters and shapes by Dear ImGui's atlas of letters and its lists of triangles. Nothing
 * else of it is used: no windows, no navigation, no input.
 *
 * Letters are as high as pango's, with capitals of whole pixels, so that their edges are crisp. The atlas has the
 * letters that Western European languages and our own signs need; others are added when they are first seen, and are
 * there from the next frame on. */
extern "C" {
#include "paint/paint_gl_screen.h"
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <imgui.h>
#include <vector>

#include "widgets/ui_inside.h"

#define FONTS "/usr/share/fonts/"

namespace {

constexpr const char *REGULAR = FONTS "truetype/dejavu/DejaVuSans.ttf";
constexpr const char *BOLD = FONTS "truetype/dejavu/DejaVuSans-Bold.ttf";
constexpr const char *JAPANESE = FONTS "opentype/ipafont-gothic/ipag.ttf";

/* Of DejaVu Sans, times its size: how high capitals are, and from the highest ascender to the lowest descender, which
 * is what ImGui calls the size. */
constexpr double CAPITAL = 1493.0 / 2048, SPAN = 2384.0 / 2048;

/* It measures such signs differently from one time to the next. */
/* clang-format off */
constexpr const char *SIGNS = "–—‘’“”„…•′″€™←↑→↓↔↕⇧−∞≈≠≤≥√∑Δ∂■□▪▲△▶▸▼▾◀◂◆◇○●◌✓✔✗✕⚠⏸▮"
                              "∆"
                              "αβγδεζηθκλμνξπρστφχψωΓΘΛΠΣΦΨΩ⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺₀₁₂₃₄₅₆₇₈₉\xEF\xBF\xBD";
/* clang-format on */

struct Letters {
    double size;
    bool bold;
};

constexpr Letters LETTERS[UI_LETTERS] = {{17, false}, {15, false}, {17, true}, {19, true},
                                         {26, true},  {22, false}, {40, true}};

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

/* The next code of UTF-8; a broken one is the sign of replacement. */
unsigned next_code(const char **words, const char *end) {
    auto first = static_cast<unsigned char>(*(*words)++);
    int more = first < 0x80 ? 0 : first < 0xC0 ? -1 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    if (more < 0)
        return 0xFFFD;
    unsigned code = more == 0 ? first : first & (0x3Fu >> more);
    for (; more > 0; more--) {
        if (*words == end || (static_cast<unsigned char>(**words) & 0xC0) != 0x80)
            return 0xFFFD;
        code = code << 6 | (static_cast<unsigned char>(*(*words)++) & 0x3F);
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

struct UiPencil {
    PaintGlScreen *screen;
    ImGuiContext *context;
    std::vector<ImDrawList *> lists;
    ImDrawList *list;
    std::vector<ImDrawIdx> indices; /* of one command */
    std::vector<Ground> grounds;
    double unit;                 /* pixels a design point, of places */
    double made_unit, seen_unit; /* of letters; of the frame before */
    std::vector<unsigned char> regular, bold, japanese;
    std::vector<bool> wanted; /* codes that the atlas has, or is to have */
    bool wants_more, wants_japanese;
    std::vector<ImVec2> points;
    ImFont *fonts[UI_LETTERS];
    ScreenTexture atlas;
};

/* Letters ---------------------------------------------------------------------------------------------------------- */

namespace {

void want(UiPencil *pencil, const char *words, const char *end) {
    while (words < end) {
        unsigned code = next_code(&words, end);
        if (code < 0x20 || code >= pencil->wanted.size() || pencil->wanted[code])
            continue;
        pencil->wanted[code] = pencil->wants_more = true;
        pencil->wants_japanese |= is_japanese(code);
    }
}

ImVector<ImWchar> wanted_ranges(const UiPencil *pencil) {
    ImVector<ImWchar> ranges;
    for (size_t code = 0x20; code < pencil->wanted.size(); code++)
        if (pencil->wanted[code]) {
            ranges.push_back(static_cast<ImWchar>(code));
            while (code + 1 < pencil->wanted.size() && pencil->wanted[code + 1])
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

/* Without DejaVu there is ImGui's own letters, which are of one size and have no accents: words stay legible. */
void add_letters(UiPencil *pencil, ImFontAtlas *atlas, const Letters &letters, const ImWchar *ranges) {
    std::vector<unsigned char> &bytes = letters.bold && !pencil->bold.empty() ? pencil->bold : pencil->regular;
    double capital = std::round(CAPITAL * letters.size * pencil->made_unit);
    if (bytes.empty()) {
        ImFontConfig config;
        config.SizePixels = static_cast<float>(std::round(letters.size * pencil->made_unit));
        atlas->AddFontDefault(&config);
        return;
    }
    add_font(atlas, bytes, capital / CAPITAL * SPAN, ranges, false);
    if (!pencil->japanese.empty())
        add_font(atlas, pencil->japanese, capital / CAPITAL, ranges, true);
}

void make_atlas(UiPencil *pencil) {
    ImFontAtlas *atlas = ImGui::GetIO().Fonts;
    if (pencil->wants_japanese && pencil->japanese.empty())
        pencil->japanese = file_bytes(JAPANESE);
    ImVector<ImWchar> ranges = wanted_ranges(pencil);
    atlas->Clear();
    atlas->Flags = ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    for (const Letters &letters : LETTERS)
        add_letters(pencil, atlas, letters, ranges.Data);
    unsigned char *pixels;
    int width, height;
    atlas->GetTexDataAsAlpha8(&pixels, &width, &height);
    paint_gl_screen_fill_mask(pencil->screen, &pencil->atlas, pixels, width, height);
    atlas->SetTexID(&pencil->atlas);
    atlas->ClearTexData();
    for (int i = 0; i < UI_LETTERS; i++)
        pencil->fonts[i] = atlas->Fonts[i];
    pencil->wants_more = pencil->wants_japanese = false;
}

/* A window that is being resized asks for other letters in every frame: they are made when it asks for the same twice.
 */
void renew_atlas(UiPencil *pencil) {
    bool settled = pencil->made_unit == 0 || pencil->unit == pencil->seen_unit;
    pencil->seen_unit = pencil->unit;
    bool other = pencil->made_unit != pencil->unit && settled;
    if (other)
        pencil->made_unit = pencil->unit;
    if (other || pencil->wants_more)
        make_atlas(pencil);
}

float pixel(const UiPencil *pencil, double place) {
    return static_cast<float>(std::round(place * pencil->unit));
}

/* Before the first frame letters are as large as at first sight. */
const ImFont *font_of(UiPencil *pencil, UiLetters letters) {
    if (!pencil->fonts[letters])
        renew_atlas(pencil);
    return pencil->fonts[letters];
}

ImVec2 exact(const UiPencil *pencil, Vec2 place) {
    return ImVec2(static_cast<float>(place.x * pencil->unit), static_cast<float>(place.y * pencil->unit));
}

ImVec2 snapped(const UiPencil *pencil, Vec2 place) {
    return ImVec2(pixel(pencil, place.x), pixel(pencil, place.y));
}

/* Its place among the commands of a list says when a ground is drawn; it is never called. */
void mark_ground(const ImDrawList *, const ImDrawCmd *) {
}

float thickness(const UiPencil *pencil, double width) {
    return std::fmax(1.0f, pixel(pencil, width));
}

const ImVec2 *exact_points(UiPencil *pencil, const Vec2 *points, size_t count) {
    pencil->points.resize(count);
    for (size_t i = 0; i < count; i++)
        pencil->points[i] = exact(pencil, points[i]);
    return pencil->points.data();
}

} // namespace

double ui_pencil_size(UiLetters letters) {
    return LETTERS[letters].size;
}

Vec2 ui_pencil_extent(UiPencil *pencil, UiLetters letters, const char *words, size_t bytes) {
    want(pencil, words, words + bytes);
    const ImFont *font = font_of(pencil, letters);
    ImVec2 size = font->CalcTextSizeA(font->FontSize, HUGE_VALF, 0, words, words + bytes);
    return vec2_scale(vec2(size.x, size.y), 1 / pencil->unit);
}

size_t ui_pencil_wrap(UiPencil *pencil, UiLetters letters, const char *words, double width) {
    size_t line = std::strcspn(words, "\n");
    want(pencil, words, words + line);
    const ImFont *font = font_of(pencil, letters);
    if (ui_pencil_extent(pencil, letters, words, line).x <= width + 0.5 / pencil->unit)
        return line;
    const char *end = font->CalcWordWrapPositionA(1, words, words + line, static_cast<float>(width * pencil->unit));
    if (end == words) /* not even one letter has room: the line has one, all the same */
        next_code(&end, words + line);
    const char *blank = end; /* ImGui parts words behind a point, too: "0." and "040 m" */
    while (blank > words && *blank != ' ')
        blank--;
    return static_cast<size_t>((blank > words && end < words + line ? blank : end) - words);
}

void ui_pencil_words(UiPencil *pencil, UiLetters letters, UiInk ink, Vec2 at, const char *words, size_t bytes) {
    const ImFont *font = font_of(pencil, letters);
    want(pencil, words, words + bytes);
    double capital = std::round(CAPITAL * LETTERS[letters].size * pencil->made_unit);
    double base = std::round(at.y * pencil->unit + capital / 2);
    ImVec2 corner(pixel(pencil, at.x), static_cast<float>(base) - font->Ascent);
    pencil->list->AddText(font, font->FontSize, corner, ink_of(ink), words, words + bytes);
}

/* Shapes ----------------------------------------------------------------------------------------------------------- */

void ui_pencil_ground(UiPencil *pencil, Box box, Colour colour) {
    ImVec2 low = snapped(pencil, box.low), high = snapped(pencil, box.high);
    int left = static_cast<int>(low.x), top = static_cast<int>(low.y);
    pencil->list->AddCallback(mark_ground, reinterpret_cast<void *>(pencil->grounds.size()));
    pencil->grounds.push_back({colour, left, top, static_cast<int>(high.x) - left, static_cast<int>(high.y) - top});
}

void ui_pencil_box(UiPencil *pencil, Box box, UiInk ink) {
    pencil->list->AddRectFilled(snapped(pencil, box.low), snapped(pencil, box.high), ink_of(ink));
}

void ui_pencil_frame(UiPencil *pencil, Box box, double width, UiInk ink) {
    ImVec2 low = snapped(pencil, box.low), high = snapped(pencil, box.high);
    float wide = thickness(pencil, width);
    ImU32 colour = ink_of(ink);
    pencil->list->AddRectFilled(low, ImVec2(high.x, low.y + wide), colour);
    pencil->list->AddRectFilled(ImVec2(low.x, high.y - wide), high, colour);
    pencil->list->AddRectFilled(ImVec2(low.x, low.y + wide), ImVec2(low.x + wide, high.y - wide), colour);
    pencil->list->AddRectFilled(ImVec2(high.x - wide, low.y + wide), ImVec2(high.x, high.y - wide), colour);
}

void ui_pencil_polyline(UiPencil *pencil, const Vec2 *points, size_t count, bool closed, double width, UiInk ink) {
    pencil->list->AddPolyline(exact_points(pencil, points, count), static_cast<int>(count), ink_of(ink),
                              closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                              static_cast<float>(std::fmax(1, width * pencil->unit)));
}

void ui_pencil_convex(UiPencil *pencil, const Vec2 *points, size_t count, UiInk ink) {
    pencil->list->AddConvexPolyFilled(exact_points(pencil, points, count), static_cast<int>(count), ink_of(ink));
}

void ui_pencil_disc(UiPencil *pencil, Vec2 middle, double radius, UiInk ink) {
    pencil->list->AddCircleFilled(exact(pencil, middle), static_cast<float>(radius * pencil->unit), ink_of(ink));
}

void ui_pencil_image(UiPencil *pencil, const ScreenTexture *texture, Box box) {
    pencil->list->AddImage(const_cast<ScreenTexture *>(texture), snapped(pencil, box.low), snapped(pencil, box.high));
}

void ui_pencil_picture(UiPencil *pencil, const ScreenTexture *texture, const Vec2 corners[4], double opacity) {
    pencil->list->AddImageQuad(const_cast<ScreenTexture *>(texture), exact(pencil, corners[3]),
                               exact(pencil, corners[2]), exact(pencil, corners[1]), exact(pencil, corners[0]),
                               ImVec2(0, 0), ImVec2(1, 0), ImVec2(1, 1), ImVec2(0, 1),
                               IM_COL32(255, 255, 255, static_cast<int>(std::lround(255 * opacity))));
}

void ui_pencil_clip(UiPencil *pencil, Box box) {
    pencil->list->PushClipRect(snapped(pencil, box.low), snapped(pencil, box.high), true);
}

void ui_pencil_unclip(UiPencil *pencil) {
    pencil->list->PopClipRect();
}

bool ui_pencil_is_stale(const UiPencil *pencil) {
    return pencil->wants_more || pencil->unit != pencil->made_unit;
}

void ui_pencil_layer(UiPencil *pencil, UiLayer layer) {
    pencil->list = pencil->lists[layer];
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

UiPencil *ui_pencil_create(PaintGlScreen *screen) {
    auto *pencil = new UiPencil();
    pencil->screen = screen;
    pencil->context = ImGui::CreateContext();
    pencil->regular = file_bytes(REGULAR);
    pencil->bold = file_bytes(BOLD);
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    pencil->wanted.resize(0x10000);
    for (size_t code = 0x20; code < 0x100; code++)
        pencil->wanted[code] = code < 0x7F || code >= 0xA0;
    want(pencil, SIGNS, SIGNS + std::strlen(SIGNS));
    for (int i = 0; i < UI_LAYER_COUNT; i++)
        pencil->lists.push_back(new ImDrawList(ImGui::GetDrawListSharedData()));
    pencil->list = pencil->lists[0];
    pencil->unit = 1;
    return pencil;
}

void ui_pencil_destroy(UiPencil *pencil) {
    paint_gl_screen_forget(pencil->screen, &pencil->atlas);
    for (ImDrawList *list : pencil->lists)
        delete list;
    ImGui::DestroyContext(pencil->context);
    delete pencil;
}

void ui_pencil_begin(UiPencil *pencil, int width, int height, double unit, double seconds) {
    ImGui::SetCurrentContext(pencil->context);
    pencil->unit = unit;
    renew_atlas(pencil);
    ImGuiIO &io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    io.DeltaTime = static_cast<float>(std::fmax(seconds, 1e-4));
    ImGui::NewFrame();
    for (ImDrawList *list : pencil->lists) {
        list->_ResetForNewFrame();
        list->PushTextureID(&pencil->atlas);
        list->PushClipRect(ImVec2(0, 0), io.DisplaySize);
    }
    pencil->list = pencil->lists[UI_LAYER_PANES];
}

namespace {

void draw_ground(UiPencil *pencil, const Ground &ground) {
    paint_gl_screen_box(pencil->screen, ground.colour, ground.left, ground.top, ground.width, ground.height);
}

/* A command's triangles know only few of the list's vertices: those are sent. */
void send(UiPencil *pencil, const ImDrawList *list, const ImDrawCmd &command) {
    const ImDrawIdx *from = list->IdxBuffer.Data + command.IdxOffset;
    ImDrawIdx low = 0xFFFF, high = 0;
    for (unsigned i = 0; i < command.ElemCount; i++) {
        low = std::min(low, from[i]);
        high = std::max(high, from[i]);
    }
    pencil->indices.resize(command.ElemCount);
    for (unsigned i = 0; i < command.ElemCount; i++)
        pencil->indices[i] = static_cast<ImDrawIdx>(from[i] - low);
    const ImDrawVert *vertices = list->VtxBuffer.Data + command.VtxOffset + low;
    static_assert(sizeof(ImDrawVert) == sizeof(ScreenVertex) && sizeof(ImDrawIdx) == sizeof(unsigned short),
                  "as ImGui");
    int left = static_cast<int>(command.ClipRect.x), top = static_cast<int>(command.ClipRect.y);
    paint_gl_screen_mesh(pencil->screen, reinterpret_cast<const ScreenVertex *>(vertices), size_t(high - low) + 1,
                         pencil->indices.data(), command.ElemCount,
                         static_cast<const ScreenTexture *>(command.TextureId), left, top,
                         static_cast<int>(command.ClipRect.z) - left, static_cast<int>(command.ClipRect.w) - top);
}

} // namespace

void ui_pencil_end(UiPencil *pencil) {
    for (const ImDrawList *list : pencil->lists)
        for (const ImDrawCmd &command : list->CmdBuffer)
            if (command.UserCallback == mark_ground)
                draw_ground(pencil, pencil->grounds[reinterpret_cast<size_t>(command.UserCallbackData)]);
            else if (command.ElemCount)
                send(pencil, list, command);
    pencil->grounds.clear();
    ImGui::EndFrame();
}
