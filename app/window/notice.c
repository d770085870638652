#include "window/notice.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

void notice_post(Window *window, const char *format, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    messages_add(&window->messages, MESSAGE_NOTE, NAN, "%s", text);
    window->dirty = true;
}

void notice_fault(Window *window, Fault *fault, double time) {
    if (fault->count)
        messages_add_fault(&window->messages, fault, time);
    window->dirty = true;
}

char *notice_folder(Window *window) {
    Fault fault = {0};
    char *folder = export_folder(&fault);
    notice_fault(window, &fault, NAN);
    return folder;
}
