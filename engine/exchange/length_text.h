/* Reads lengths as they are written in drawings: 16'-0", 4'-10 1/2", 4.88 m, 488 cm, 4877. Private to the importers. */
#pragma once

#include <stdbool.h>

typedef struct LengthText {
    double value;  /* as written, or in metres if the text says its unit */
    bool has_unit; /* the text says its unit */
} LengthText;

/* Reads a text of a drawing, without the formatting codes of AutoCAD (\A1; {\fArial;...} \S1/2;). `<>` stands for the
 * number `measured`. Returns false if the text is not a positive length. */
bool length_text_read(const char *text, double measured, LengthText *length);

enum { LENGTH_TEXT_BYTES = 80 };

/* Writes the text without formatting codes. */
void length_text_plain(char plain[LENGTH_TEXT_BYTES], const char *text, double measured);
