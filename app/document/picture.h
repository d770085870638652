/* A picture of a document as the bytes of a file. */
#pragma once

#include "document/document.h"

typedef struct PictureFile {
    const char *type; /* "image/svg+xml" */
    unsigned char *bytes;
    size_t size;
} PictureFile;

/* As SVG or, where that would be larger than is good for whoever opens it, as PNG. picture_clear releases it. */
PictureFile picture_file(const Picture *picture, Theme theme);
void picture_clear(PictureFile *file);
