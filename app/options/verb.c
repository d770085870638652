#include "options/verb.h"

#include <stdint.h>
#include <string.h>

const Verb verb_rows[VERBS] = {
    [VERB_OPEN] = {"open", 0, 1, "[HOUSE|BEAM|CRANK]", ".json", "",
                   "Open the interactive window; `clearance` alone does so, too.",
                   "clearance\n"
                   "clearance open houses/ube-techno-house.json\n"
                   "clearance open assets/beams/ibs.json --set drive.frequency=290 --theme board\n"
                   "clearance open assets/cranks/ssc.json\n"},
    [VERB_RUN] = {"run", 1, 1, "HOUSE|BEAM|CRANK", ".json", "",
                  "Simulate an evacuation to its end, or a beam or a crank in its clearance, and print the answer.",
                  "clearance run houses/ube-techno-house.json --out out\n"
                  "clearance run houses/ube-techno-house.json --route C --driving miura --json\n"
                  "clearance run houses/ube-techno-house.json --report --out out\n"
                  "clearance run houses/corner-0.90-0.90.json --set profile.manual-chair.width=0.70\n"
                  "clearance run assets/beams/ibs.json --set drive.frequency=290 --out out\n"
                  "clearance run assets/cranks/ssc.json --set drive.frequency=10 --out out\n"},
    [VERB_CHECK] =
        {"check", 1, 1, "HOUSE", ".json", "",
         "List the errors of a house, then say for each person whether there is a way out, and if not, why. A "
         "way that is planned is not tried by simulation: see run.",
         "clearance check houses/flat-0.910-module.json\n"
         "clearance check houses/flat-0.910-module.json --set door.d1.width=0.90 --json\n"
         "clearance check houses/flat-0.910-module.json --suggest\n"
         "clearance check houses/flat-0.910-module.json --suggest --rules jp-care-insurance\n"},
    [VERB_COMPARE] = {"compare", 2, 2, "HOUSE_A HOUSE_B", ".json", "", "Run two houses and print how they differ.",
                      "clearance compare houses/flat-0.910-module.json houses/flat-0.910-widened.json\n"
                      "clearance compare houses/flat-0.910-module.json houses/flat-0.910-widened.json --report "
                      "--out out\n"},
    [VERB_ABLATE] = {"ablate", 1, 1, "HOUSE", ".json", "",
                     "Drive a house with the same drivers through the whole driving law, with one part of it left out "
                     "at a time, and through the paper's model: what each part is worth.",
                     "clearance ablate houses/straight-corridor.json --drivers 100\n"
                     "clearance ablate houses/ube-techno-house.json --population manual-jp --out out\n"},
    [VERB_STUDY] =
        {"study", 1, 1, "HOUSE|BEAM|CRANK", ".json", "",
         "Repeat runs over a range of one or two parameters, or by chance, and say where the answer changes.",
         "clearance study houses/flat-0.910-module.json --vary door.d3.width=0.7:1:31 --out out\n"
         "clearance study houses/ube-techno-house.json --runs 100 \\\n"
         "    --spread profile.manual-chair.free_speed=0.1\n"
         "clearance study houses/ube-techno-house.json --shake 100 --report --out out\n"
         "clearance study assets/beams/ibs.json --vary drive.frequency=20:320:301 --out out\n"
         "clearance study assets/cranks/ssc.json --vary drive.frequency=5:25:121 --out out\n"},
    [VERB_LOCI] = {"loci", 1, SIZE_MAX, "HOUSE ...", ".json", "",
                   "Run each house with both driving models, miura and driver: times, and how far the loci are apart.",
                   "clearance loci houses/corner-*.json\n"},
    [VERB_FIT] =
        {"fit", 1, 1, "HOUSE|BEAM", ".json", "",
         "Fit parameters to measurements: times of routes, or peaks and natural frequencies of a beam; with intervals, "
         "and what the data do not tell.",
         "clearance fit houses/ube-techno-house.json --observed times.csv --leave-out --out out\n"
         "clearance fit assets/beams/ibs-r.json --measured frequencies.csv \\\n"
         "    --fit shaker.position,shaker.moving_mass\n"},
    [VERB_RULES] =
        {"rules", 1, 1, "HOUSE", ".json", "",
         "Hold rules of accessibility against a house: widths, doors, space to turn, and whether the chairs "
         "get through where the rules are kept.",
         "clearance rules houses/corner-0.78-0.78.json\n"
         "clearance rules houses/corner-0.90-0.90.json --drivers 100 --population whm\n"
         "clearance rules houses/flat-0.910-module.json --rules ada-2010,jp-senior-housing-1414 --out out\n"},
    [VERB_CASES] = {"cases", 1, SIZE_MAX, "DIR|FILE ...", ".json", "",
                    "Run public verification tests: which pass, and why the others do not.",
                    "clearance cases tests/cases --out out\n"
                    "clearance cases tests/cases/rimea-01.json\n"},
    [VERB_LESSON] = {"lesson", 1, SIZE_MAX, "list|play|check|sheet [NAME|FILE ...]", ".json", "list|play|check|sheet",
                     "Lessons for a class: list them, give one in the window, try each goal by its script, or print a "
                     "sheet for pupils.",
                     "clearance lesson list\n"
                     "clearance lesson play legal-no-way\n"
                     "clearance lesson check legal-no-way\n"
                     "clearance lesson sheet legal-no-way --answers --out out\n"},
    [VERB_IMPORT] =
        {"import", 2, 2, "FILE HOUSE", ".sh3d,.dxf,.wkt,.scenario,.json", "",
         "Convert a file of another program to a house: Sweet Home 3D (.sh3d), a drawing (.dxf), a walkable "
         "area (.wkt), or Vadere (.scenario).",
         "clearance import flat.sh3d flat.json\n"
         "clearance import flat.dxf flat.json --layers walls=A-WALL,doors=A-DOOR --unit mm\n"},
    [VERB_EXPORT] = {"export", 1, 1, "HOUSE", ".json", "",
                     "Write the walkable area of a house, or a picture of its plan, for other programs.",
                     "clearance export houses/ube-techno-house.json --out ube.wkt\n"
                     "clearance export houses/ube-techno-house.json --to png\n"},
    [VERB_SCHEMA] =
        {"schema", 1, 2, "house|profile|beam|crank|rules|lesson|man|completion SHELL|names FILE", "",
         "house|profile|beam|crank|rules|lesson|man|completion|names",
         "Print the JSON Schema of a kind of file, for editors that complete and check; the manual page; the "
         "completion of command lines for bash, zsh or fish; or the names that --set takes for a file.",
         "clearance schema house > house.schema.json\n"
         "clearance schema completion bash > ~/.local/share/bash-completion/completions/clearance\n"
         "clearance schema names houses/flat-0.910-module.json\n"},
    [VERB_HELP] = {"help", 0, 3, "[TOPIC|VERB]", "", "", "Explain a topic at length; without a topic, list the topics.",
                   "clearance help house-file\n"
                   "clearance help studies\n"},
};

const Verb *verb_find(const char *name) {
    for (size_t v = 0; v < VERBS; v++)
        if (strcmp(verb_rows[v].name, name) == 0)
            return &verb_rows[v];
    return NULL;
}
