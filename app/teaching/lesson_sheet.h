/* The sheet of a lesson for paper: for pupils with the start, questions, boxes and empty cells; with answers for the
 * teacher. */
#pragma once

#include "document/document.h"
#include "lesson/lesson.h"

/* What a sheet is made from: the lesson, whose numbers are computed. */
typedef struct SheetOptions {
    bool answers;         /* the teacher's sheet */
    const char *program;  /* with its version */
    const char *profiles; /* directory of the shipped profiles */
    int jobs;             /* threads */
} SheetOptions;

/* Returns the sheet, to be released by document_clear; faults say which picture could not be made. */
Document lesson_sheet_make(const Lesson *lesson, const SheetOptions *options, Fault *fault);
