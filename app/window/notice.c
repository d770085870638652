#include "window/notice.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static void add_note(Window *window, const char *format, va_list arguments) {
    char text[512];
    vsnprintf(text, sizeof text, format, arguments);
    messages_add(&window->messages, MESSAGE_NOTE, NAN, "%s", text);
    window->dirty = true;
}

void notice_post(Window *window, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    add_note(window, format, arguments);
    va_end(arguments);
}

void notice_log(Window *window, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    add_note(window, format, arguments);
    va_end(arguments);
    window->dismissed = messages_last(&window->messages)->number;
}

const Message *notice_shown(Window *window, size_t *faults) {
    const Message *fault = messages_fault(&window->messages, window->fault_dismissed, faults);
    const Message *last = messages_last(&window->messages);
    if (fault)
        return fault;
    return last && last->kind == MESSAGE_NOTE && last->number > window->dismissed ? last : NULL;
}

bool notice_dismiss(Window *window) {
    size_t faults;
    const Message *shown = notice_shown(window, &faults);
    if (!shown)
        return false;
    bool fault = shown->kind == MESSAGE_FAULT;
    if (fault)
        window->fault_dismissed = shown->number;
    else
        window->dismissed = shown->number;
    window->dirty = true;
    return fault;
}

void notice_edit(Window *window) {
    Editor *editor = window_tab(window)->session ? tab_editor(window_tab(window)) : NULL;
    const Message *last = messages_last(&window->messages);
    if (editor && editor_rescaled(editor))
        tab_fit(window_tab(window));
    if (editor && editor_next_step(editor)) {
        bool said = last && last->kind == MESSAGE_NOTE && last->number > window->message_before;
        if (!said && editor_undo_name(editor))
            notice_post(window, "%s", editor_undo_name(editor));
        last = messages_last(&window->messages);
        window->undo_message = last ? last->number : 0;
        window->dismissed = last && last->number == window->dismissed ? last->number - 1 : window->dismissed;
        window->noted = 0; /* it stays for its whole time */
        window->dirty = true;
    }
    window->message_before = last ? last->number : 0;
}

void notice_search(Window *window) {
    const Editor *editor = window_tab(window)->session ? tab_editor(window_tab(window)) : NULL;
    size_t searched = editor ? 2 * editor_proposal_tries(editor) + editor_seeks_proposals(editor) : 0;
    window->dirty |= searched != window->searched;
    window->searched = searched;
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
