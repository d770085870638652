#include "laboratory/edit/trial.h"

#include <math.h>

bool trial_follow(Trial *trial, const Laboratory *laboratory, void *session, Fault *fault) {
    size_t proposal = 0;
    Editor *editor = session && laboratory->open_proposal ? laboratory->editor(session) : NULL;
    uint64_t number = editor ? editor_chosen_proposal(editor, &proposal) : 0;
    if (number == trial->number)
        return false;
    trial_clear(trial);
    *trial = (Trial){.laboratory = laboratory, .number = number, .proposal = proposal};
    if (number)
        trial->session = laboratory->open_proposal(session, proposal, fault);
    return true;
}

unsigned trial_update(Trial *trial, double time) {
    if (!trial->session)
        return 0;
    double own = trial_time(trial->laboratory, trial->session, time);
    trial->laboratory->reach(trial->session, own);
    return trial->laboratory->update(trial->session, own);
}

RecordSpan trial_span(const Trial *trial, RecordSpan span) {
    if (!trial->session)
        return span;
    RecordSpan other = trial->laboratory->span(trial->session);
    span.end = fmax(span.end, other.end);
    span.complete = span.complete && other.complete;
    return span;
}

double trial_time(const Laboratory *laboratory, const void *session, double time) {
    RecordSpan span = laboratory->span(session);
    return fmin(fmax(time, span.begin), fmax(span.end, span.begin));
}

Item trial_item(const Trial *trial, Editor *editor, const char **label) {
    size_t count;
    const char *doing;
    const Proposal *proposals = editor_proposals(editor, &count, &doing);
    bool there = trial->session && trial->proposal < count;
    *label = there ? proposals[trial->proposal].label : NULL;
    return there ? proposals[trial->proposal].item : (Item){0, 0};
}

void trial_clear(Trial *trial) {
    if (trial->session)
        trial->laboratory->close(trial->session);
    *trial = (Trial){0};
}
