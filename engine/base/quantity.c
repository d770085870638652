#include "base/quantity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sizes of the units, each relative to the first unit of its kind. */
static const struct {
    const char *name;
    int kind;
    double factor;
} units[] = {
    {"m", 0, 1},          {"mm", 0, 1e-3},
    {"cm", 0, 1e-2},      {"km", 0, 1e3},
    {"um", 0, 1e-6},      {"µm", 0, 1e-6},
    {"ft", 0, 0.3048},    {"'", 0, 0.3048},
    {"in", 0, 0.0254},    {"\"", 0, 0.0254},
    {"s", 1, 1},          {"ms", 1, 1e-3},
    {"min", 1, 60},       {"Hz", 2, 1},
    {"hz", 2, 1},         {"kHz", 2, 1e3},
    {"rpm", 2, 1 / 60.},  {"N", 3, 1},
    {"kN", 3, 1e3},       {"mN", 3, 1e-3},
    {"kg", 4, 1},         {"g", 4, 1e-3},
    {"t", 4, 1e3},        {"deg", 5, 1},
    {"°", 5, 1},          {"rad", 5, 57.29577951308232},
    {"%", 6, 1},          {"m/s", 7, 1},
    {"cm/s", 7, 1e-2},    {"mm/s", 7, 1e-3},
    {"km/h", 7, 1 / 3.6}, {"N/m", 8, 1},
    {"kN/m", 8, 1e3},     {"N/mm", 8, 1e3},
    {"MN/m", 8, 1e6},     {"N s/m", 9, 1},
    {"Ns/m", 9, 1},       {"Pa", 10, 1},
    {"kPa", 10, 1e3},     {"MPa", 10, 1e6},
    {"GPa", 10, 1e9},
};
enum { UNITS = sizeof units / sizeof *units, NONE = -1 };

/* Position of the reader. */
typedef struct Reader {
    const char *at;
    const char *unit;
    char *reason;
} Reader;

static bool refuse(const Reader *reader, const char *why, const char *what, size_t bytes) {
    snprintf(reader->reason, QUANTITY_REASON, why, (int)(bytes < 24 ? bytes : 24), what);
    return false;
}

static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static void skip_spaces(Reader *reader) {
    for (;;) {
        if (is_space(*reader->at))
            reader->at++;
        else if (strncmp(reader->at, "\u00A0", 2) == 0)
            reader->at += 2;
        else
            return;
    }
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* Reads digits with a point or a comma, and an exponent; unlike strtod, nothing else. */
static bool read_digits(Reader *reader, double *value) {
    char text[64];
    size_t size = 0;
    int digits = 0, points = 0;
    const char *at = reader->at;
    for (; is_digit(*at) || *at == '.' || *at == ','; at++) {
        digits += is_digit(*at);
        points += !is_digit(*at);
        if (size < sizeof text - 8)
            text[size++] = *at == ',' ? '.' : *at;
    }
    if (!digits || points > 1 || size >= sizeof text - 8)
        return false;
    if (*at == 'e' || *at == 'E') {
        const char *sign = at + 1, *first = sign + (*sign == '-' || *sign == '+');
        const char *end = first;
        while (is_digit(*end))
            end++;
        if (end > first && end - at < 7) {
            memcpy(text + size, at, (size_t)(end - at));
            size += (size_t)(end - at);
            at = end;
        }
    }
    text[size] = 0;
    *value = strtod(text, NULL);
    reader->at = at;
    return isfinite(*value);
}

static bool is_minus(const char *at) {
    return *at == '-' || strncmp(at, "−", 3) == 0;
}

static bool is_letter(const char *at) {
    return (*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z') || ((unsigned char)*at >= 0x80 && !is_minus(at)) ||
           (*at && strchr("/%'\"^", *at));
}

static int find_unit(const char *name, size_t bytes) {
    for (int i = 0; i < UNITS; i++)
        if (strlen(units[i].name) == bytes && strncmp(units[i].name, name, bytes) == 0)
            return i;
    return NONE;
}

static bool is_quote(char c) {
    return c == '\'' || c == '"';
}

/* Reads the unit that follows, or assumes the reader's own. */
static bool read_unit(Reader *reader, int *unit) {
    skip_spaces(reader);
    size_t own = strlen(reader->unit), bytes = 0;
    int owned = *unit = find_unit(reader->unit, own);
    if (own && strncmp(reader->at, reader->unit, own) == 0 && !is_letter(reader->at + own)) {
        reader->at += own;
        return true;
    }
    while (is_letter(reader->at + bytes) && !(bytes && is_quote(*reader->at)))
        bytes++;
    if (!bytes)
        return true;
    *unit = find_unit(reader->at, bytes);
    if (*unit == NONE)
        return refuse(reader, "not a number or a unit: %.*s", reader->at, bytes);
    if (owned == NONE || units[*unit].kind != units[owned].kind)
        return refuse(reader, "another kind of unit: %.*s", reader->at, bytes);
    reader->at += bytes;
    return true;
}

static bool is_named(int unit, const char *name, const char *sign) {
    return unit != NONE && (strcmp(units[unit].name, name) == 0 || strcmp(units[unit].name, sign) == 0);
}

/* Reads a number and its unit. Two terms are joined by a sign, except feet and inches. */
static bool read_term(Reader *reader, bool joined, int *unit, double *value) {
    int before = *unit, owned = find_unit(reader->unit, strlen(reader->unit));
    if (!read_digits(reader, value))
        return refuse(reader, "not a number%.*s", "", 0);
    if (!read_unit(reader, unit))
        return false;
    if (joined && !(is_named(before, "ft", "'") && is_named(*unit, "in", "\"")))
        return refuse(reader, "not one number%.*s", "", 0);
    if (owned != NONE)
        *value *= units[*unit].factor / units[owned].factor;
    return true;
}

bool quantity_read(const char *words, const char *unit, double *value, char reason[QUANTITY_REASON]) {
    Reader reader = {words, unit ? unit : "", reason};
    double sum = 0, sign = 1, part;
    int last = NONE;
    skip_spaces(&reader);
    if (!*reader.at)
        return refuse(&reader, "nothing is typed%.*s", "", 0);
    for (bool first = true; *reader.at; first = false) {
        bool minus = is_minus(reader.at), joined = !first && !minus && *reader.at != '+';
        if (!joined)
            sign = minus ? -1 : 1;
        if (minus || *reader.at == '+')
            reader.at += *reader.at == '-' || *reader.at == '+' ? 1 : 3;
        skip_spaces(&reader);
        if (!read_term(&reader, joined, &last, &part))
            return false;
        sum += sign * part;
        skip_spaces(&reader);
    }
    if (!isfinite(sum))
        return refuse(&reader, "too large%.*s", "", 0);
    *value = sum;
    return true;
}
