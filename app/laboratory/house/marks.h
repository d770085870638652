/* The marks of the displayed run on the time line. */
#pragma once

#include "laboratory/house/session_state.h"

/* Makes them: first contacts, people who are out (of a crowd when half, 95 of 100 and all are), errors and changes on
 * the way, in the order of their times. */
void house_marks_make(HouseSession *session);
