/* Kinds of work that a change to a house needs; some insurances pay for some of them. */
#pragma once

typedef enum PlanWork {
    WORK_HINGED_DOOR,  /* a hinged door is widened */
    WORK_SLIDING_DOOR, /* a sliding door is widened */
    WORK_OPENING,      /* an opening without a door is widened */
    WORK_FURNITURE,    /* furniture is moved, turned or stood up */
    PLAN_WORKS
} PlanWork;

#define PLAN_WORK_WORDS "hinged_door_wider|sliding_door_wider|opening_wider|furniture_moved"
