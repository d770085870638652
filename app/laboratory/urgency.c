#include "laboratory/urgency.h"

#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

void urgency_set(Urgency urgency) {
    static const int nice_values[] = {[URGENCY_ANSWER] = 10, [URGENCY_AFTERWARDS] = 15};
    if (!getenv("CLEARANCE_EQUAL_THREADS"))
        setpriority(PRIO_PROCESS, (id_t)gettid(), nice_values[urgency]);
}
