/* A picture of a document as the bytes of a file. */
#pragma once

#include "document/document.h"

typedef struct PictureFile {
    const char *type; /* "image/svg+xml" */
    unsigned char *bytes;
    size_t size;
} PictureFile;

/* Makes an SVG or, where an SVG would be too large for a browser, a PNG. picture_clear releases it. */
PictureFile picture_file(const Picture *picture, Theme theme);
void picture_clear(PictureFile *file);
