#include "laboratory/laboratories.h"

#include <stddef.h>

#include "laboratory/shipped.h"

const LaboratoryRow laboratories[] = {
    {&house_laboratory, "Simulate how people leave a house", "F2", offsetof(Shipped, houses), "ube-techno-house.json",
     "speed,clearance,force,ring,phase", thumbnail_read_house},
    {&beam_laboratory, "Simulate a beam that rattles in its clearance", "F3", offsetof(Shipped, beams), "ibs.json",
     "phase,poincare,force,displacement,velocity,spectrum", thumbnail_read_beam},
    {&crank_laboratory, "Simulate a slider crank with a clearance", "F8", offsetof(Shipped, cranks), "ssc.json",
     "phase,poincare,force,angle,across,slider,spectrum", thumbnail_read_crank},
};
const size_t laboratories_count = sizeof laboratories / sizeof *laboratories;
