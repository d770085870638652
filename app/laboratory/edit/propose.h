/* Searches for changes that let all people leave, on a separate thread. */
#pragma once

#include "laboratory/edit/editor_state.h"

/* Starts a search for the present draft; an earlier search is cancelled. */
void edit_propose_ask(Editor *edit);

/* Returns the proposals (count), valid until the draft changes or the next search. `doing`: the progress of the
 * search, or its result if there are no proposals; NULL: no search. */
const Proposal *edit_propose_list(Editor *edit, size_t *count, const char **doing);

/* Applies a proposal as one step. False: the fault says why it is impossible. */
bool edit_propose_drop(Editor *edit);
bool edit_propose_accept(Editor *edit, size_t proposal, Fault *fault);

/* Choose the proposal that is shown beside the plan; return its number, which no other proposal has had; 0: none. */
void edit_propose_choose(Editor *edit, size_t proposal);
uint64_t edit_propose_chosen(Editor *edit, size_t *proposal);

/* Returns how many houses the search has tried so far; true while it searches. */
size_t edit_propose_tries(const Editor *edit);
bool edit_propose_seeks(const Editor *edit);

/* Cancels all searches, and waits for the end of their threads. */
void edit_propose_end(Editor *edit);
