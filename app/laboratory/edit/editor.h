/* Editing a house while it runs: see editing.h. Its state is the member `edit` of a house at work. */
#pragma once

#include "laboratory/editing.h"

extern const EditorFunctions house_editor;
