#include "cycle/motion_class.h"

const char *const motion_class_names[MOTION_CLASSES] = {
    [MOTION_CLASS_FREE] = "without contact",
    [MOTION_CLASS_PERIODIC] = "periodic",
    [MOTION_CLASS_QUASI_PERIODIC] = "quasi-periodic",
    [MOTION_CLASS_CHAOTIC] = "chaotic",
    [MOTION_CLASS_TRANSIENT] = "transient",
    [MOTION_CLASS_UNDETERMINED] = "undetermined",
    [MOTION_CLASS_CHATTERS] = "chatters",
    [MOTION_CLASS_DIVERGED] = "diverged",
    [MOTION_CLASS_NOT_PERIODIC] = "not periodic",
};

MotionClass motion_class_of(const Response *response) {
    switch (response->verdict) {
    case RESPONSE_PERIODIC:
        return response->peaks.count ? MOTION_CLASS_PERIODIC : MOTION_CLASS_FREE;
    case RESPONSE_QUASI_PERIODIC:
        return MOTION_CLASS_QUASI_PERIODIC;
    case RESPONSE_CHAOTIC:
        return MOTION_CLASS_CHAOTIC;
    case RESPONSE_TRANSIENT:
        return MOTION_CLASS_TRANSIENT;
    case RESPONSE_CHATTERS:
        return MOTION_CLASS_CHATTERS;
    case RESPONSE_DIVERGED:
        return MOTION_CLASS_DIVERGED;
    case RESPONSE_UNDETERMINED:
    case RESPONSE_INTERRUPTED:
        break;
    }
    return MOTION_CLASS_UNDETERMINED;
}

MotionClass motion_class_of_record(CycleStatus status, int period, bool touches) {
    if (status != CYCLE_GOOD)
        return status == CYCLE_CHATTERS ? MOTION_CLASS_CHATTERS : MOTION_CLASS_DIVERGED;
    if (period == SECTION_UNDECIDED)
        return MOTION_CLASS_UNDETERMINED;
    if (period == SECTION_NONE)
        return MOTION_CLASS_NOT_PERIODIC;
    return touches ? MOTION_CLASS_PERIODIC : MOTION_CLASS_FREE;
}
