#include "exchange/length_text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const double FOOT = 0.3048, INCH = 0.0254; /* m */

/* Formatting codes ------------------------------------------------------------------------------------------------ */

typedef struct Plain {
    char *text;
    size_t used;
} Plain;

static void put(Plain *plain, const char *text, size_t count) {
    for (size_t i = 0; i < count && plain->used + 1 < LENGTH_TEXT_BYTES; i++)
        plain->text[plain->used++] = text[i];
    plain->text[plain->used] = 0;
}

/* Copies a stacked fraction, \S1/2; or \S1#2; or \S1^2;. Returns the text after it. */
static const char *put_stacked(Plain *plain, const char *at) {
    put(plain, " ", 1);
    for (; *at && *at != ';'; at++)
        put(plain, *at == '#' || *at == '^' ? "/" : at, 1);
    return *at ? at + 1 : at;
}

/* Handles the code after a backslash. Returns the text after it. */
static const char *put_code(Plain *plain, const char *at) {
    if (*at == 'S')
        return put_stacked(plain, at + 1);
    if (*at && strchr("ACcFfHhQTWp", *at)) {
        const char *end = strchr(at, ';');
        return end ? end + 1 : at + strlen(at);
    }
    if (*at == 'P' || *at == '~')
        put(plain, " ", 1);
    else if (*at && strchr("\\{}", *at))
        put(plain, at, 1);
    return *at ? at + 1 : at;
}

void length_text_plain(char text[LENGTH_TEXT_BYTES], const char *from, double measured) {
    Plain plain = {text, 0};
    text[0] = 0;
    while (*from) {
        if (*from == '\\') {
            from = put_code(&plain, from + 1);
        } else if (strncmp(from, "<>", 2) == 0) {
            char number[32];
            snprintf(number, sizeof number, "%.10g", measured);
            put(&plain, number, strlen(number));
            from += 2;
        } else {
            if (*from != '{' && *from != '}')
                put(&plain, from, 1);
            from++;
        }
    }
}

/* Lengths --------------------------------------------------------------------------------------------------------- */

/* Skips one of the words, regardless of case, and returns true if the text begins with it. */
static bool skip(const char **at, const char *const *words) {
    for (; *words; words++)
        if (strncasecmp(*at, *words, strlen(*words)) == 0) {
            *at += strlen(*words);
            return true;
        }
    return false;
}

static void skip_space(const char **at) {
    while (isspace((unsigned char)**at))
        ++*at;
}

/* Reads digits with a point or a comma. */
static bool read_decimal(const char **at, double *value) {
    double number = 0, place = 1;
    bool digits = false, fraction = false;
    for (;; ++*at) {
        if (isdigit((unsigned char)**at)) {
            number = 10 * number + (**at - '0');
            place *= fraction ? 10 : 1;
            digits = true;
        } else if (!fraction && (**at == '.' || **at == ',') && isdigit((unsigned char)(*at)[1])) {
            fraction = true;
        } else {
            break;
        }
    }
    *value = number / place;
    return digits && number < 1e12;
}

/* Reads "10", "10.5", "1/2", "10 1/2" or "10-1/2". */
static bool read_number(const char **at, double *value) {
    if (!read_decimal(at, value))
        return false;
    const char *next = *at;
    double over, under;
    if (*next == '/') {
        next++;
        if (!read_decimal(&next, &under) || under <= 0)
            return false;
        *value /= under;
        *at = next;
        return true;
    }
    while (*next == ' ' || *next == '-')
        next++;
    if (next > *at && read_decimal(&next, &over) && *next == '/') {
        next++;
        if (read_decimal(&next, &under) && under > 0) {
            *value += over / under;
            *at = next;
        }
    }
    return true;
}

static const char *const feet[] = {"'", "\u2032", "\u2019", "feet", "foot", "ft", NULL};
static const char *const inches[] = {"\"", "\u2033", "\u201d", "''", "inches", "inch", "in", NULL};

/* Reads inches after feet, if there are any. */
static bool read_inches(const char **at, double *metres) {
    const char *next = *at;
    double value;
    while (*next == ' ' || *next == '-')
        next++;
    if (!read_number(&next, &value))
        return true;
    skip_space(&next);
    if (!skip(&next, inches))
        return false;
    *metres += value * INCH;
    *at = next;
    return true;
}

static bool read_length(const char *at, LengthText *length) {
    static const struct {
        const char *words[3];
        double metres;
    } units[] = {{{"mm", NULL}, 0.001}, {{"cm", NULL}, 0.01}, {{"dm", NULL}, 0.1}, {{"mtr", "m", NULL}, 1}};
    while (*at && strchr("~=+ \t", *at))
        at++;
    if (!read_number(&at, &length->value))
        return false;
    skip_space(&at);
    length->has_unit = true;
    if (skip(&at, inches)) { /* before feet: two single quotation marks are inches */
        length->value *= INCH;
    } else if (skip(&at, feet)) {
        length->value *= FOOT;
        if (!read_inches(&at, &length->value))
            return false;
    } else {
        length->has_unit = false;
        for (size_t u = 0; u < sizeof units / sizeof *units && !length->has_unit; u++)
            if (skip(&at, units[u].words)) {
                length->value *= units[u].metres;
                length->has_unit = true;
            }
    }
    while (*at == '.' || isspace((unsigned char)*at))
        at++;
    return !*at && length->value > 0;
}

bool length_text_read(const char *text, double measured, LengthText *length) {
    char plain[LENGTH_TEXT_BYTES];
    length_text_plain(plain, text, measured);
    *length = (LengthText){.value = 0};
    return strlen(plain) + 1 < LENGTH_TEXT_BYTES && read_length(plain, length);
}
