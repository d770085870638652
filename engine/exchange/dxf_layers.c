#include "exchange/dxf_layers.h"

#include <string.h>
#include <strings.h>

#include "base/text.h"

static const char *const role_names[DXF_ROLES] = {
    [DXF_WALLS] = "walls", [DXF_DOORS] = "doors", [DXF_FURNITURE] = "furniture", [DXF_EXITS] = "exits"};

enum { NAMES_SHOWN = 8, NAME_SHOWN = 40 /* bytes */, WORDS_MOST = 24 };

/* Parts of layer names in several languages; the first row that matches decides. A window is a wall to people
 * inside; an obstacle of any shape stays as drawn. */
static const struct {
    DxfRole role;
    const char *words[WORDS_MOST];
} names[] = {
    {DXF_NOTHING,
     {"anno", "dim", "text", "txt", "hatch", "patt", "schraff", "bem", "defpoints", "\u5bf8\u6cd5", "\u6587\u5b57"}},
    {DXF_EXITS, {"exit", "ausgang", "sortie", "salida", "\u51fa\u53e3"}},
    {DXF_DOORS,
     {"door", "t\u00fcr", "t\u00dcr", "tuer", "porte", "porta", "puerta", "\u30c9\u30a2", "\u6249", "\u5efa\u5177"}},
    {DXF_FURNITURE,
     {"furn", "m\u00f6bel", "m\u00d6bel", "moebel", "meuble", "mueble", "mobil", "arredo", "equip", "fixt", "sanit",
      "applian", "casework", "\u5bb6\u5177", "\u8a2d\u5099"}},
    {DXF_WALLS, {"wall",         "wand",    "w\u00e4nd", "w\u00c4nd",  "waend",      "mur",    "pared", "walkable",
                 "obstacle",     "column",  "pillar",    "st\u00fctz", "st\u00dctz", "window", "glaz",  "fenster",
                 "fen\u00eatre", "fenetre", "ventana",   "finestra",   "\u58c1",     "\u67f1", "\u7a93"}},
    {DXF_NOTHING,
     {"grid", "axis", "achse", "title", "frame", "border", "symb", "area", "room", "raum", "ceil", "roof", "elec",
      "light"}},
};

/* Strips the prefixes that nested drawings add to layer names: "PLAN|WALLS", "PLAN$0$WALLS". */
static const char *bare_name(const char *name) {
    const char *bar = strrchr(name, '|'), *dollar = strrchr(name, '$');
    const char *last = bar && (!dollar || bar > dollar) ? bar : dollar;
    return last && last[1] ? last + 1 : name;
}

static DxfRole role_by_name(const char *name) {
    for (size_t n = 0; n < sizeof names / sizeof *names; n++)
        for (size_t w = 0; w < WORDS_MOST && names[n].words[w]; w++)
            if (strcasestr(bare_name(name), names[n].words[w]))
                return names[n].role;
    return DXF_UNKNOWN;
}

static void name_blocks(DxfFile *file) {
    for (size_t b = 0; b < file->block_count; b++) {
        DxfRole role = role_by_name(file->blocks[b].name);
        file->blocks[b].role = (int)(role == DXF_DOORS || role == DXF_FURNITURE ? role : DXF_UNKNOWN);
    }
}

static bool is_called(const char *name, const char *wanted, size_t length) {
    return strlen(name) == length && strncasecmp(name, wanted, length) == 0;
}

/* Appends a name, cut if it is long. */
static void add_name(Text *list, const char *before, const char *name) {
    text_format(list, "%s%.*s", before, text_fitting(name, NAME_SHOWN), name);
}

/* Adds an error such as "there are A, B and 12 more". */
static bool fault_unknown(const DxfFile *file, HouseBuilder *builder, const char *name, size_t length) {
    Text known = {0};
    for (size_t l = 0; l < file->layer_count && l < NAMES_SHOWN; l++)
        add_name(&known, l ? ", " : "", file->layers[l].name);
    if (file->layer_count > NAMES_SHOWN)
        text_format(&known, " and %zu more", file->layer_count - NAMES_SHOWN);
    house_builder_fail(builder, "--layers: there is no layer \"%.*s\", there are %s", (int)(length < 60 ? length : 60),
                       name, known.text);
    memory_free(known.text);
    return false;
}

static bool give_role(DxfFile *file, HouseBuilder *builder, const char *name, size_t length, DxfRole role) {
    bool found = false;
    for (size_t l = 0; l < file->layer_count; l++) {
        if (!is_called(file->layers[l].name, name, length) && !is_called(bare_name(file->layers[l].name), name, length))
            continue;
        file->layers[l].role = (int)role;
        found = true;
    }
    return found || fault_unknown(file, builder, name, length);
}

/* Returns the role before an equals sign, and its length in `*used`; DXF_UNKNOWN if there is none. */
static DxfRole role_before_equals(const char *word, size_t *used) {
    for (int role = 0; role < DXF_ROLES; role++) {
        size_t length = role_names[role] ? strlen(role_names[role]) : 0;
        if (length && strncmp(word, role_names[role], length) == 0 && word[length] == '=') {
            *used = length + 1;
            return (DxfRole)role;
        }
    }
    return DXF_UNKNOWN;
}

/* Parses walls=NAME,NAME,doors=NAME; a name takes the role before it. */
static bool choose_as_said(DxfFile *file, HouseBuilder *builder, const char *said) {
    DxfRole role = DXF_UNKNOWN;
    for (size_t l = 0; l < file->layer_count; l++)
        file->layers[l].role = DXF_NOTHING;
    while (*said) {
        size_t used = 0;
        DxfRole next = role_before_equals(said, &used);
        role = next != DXF_UNKNOWN ? next : role;
        said += used;
        if (role == DXF_UNKNOWN)
            return house_builder_fail(builder, "--layers must be like walls=NAME,NAME,doors=NAME,furniture=NAME or "
                                               "exits=NAME");
        size_t length = strcspn(said, ",");
        if (length && !give_role(file, builder, said, length, role))
            return false;
        said += length + (said[length] == ',');
    }
    return true;
}

/* True if any layer has the role. */
static bool has(const DxfFile *file, DxfRole role) {
    for (size_t l = 0; l < file->layer_count; l++)
        if (file->layers[l].role == (int)role)
            return true;
    return false;
}

static void choose_by_name(DxfFile *file) {
    for (size_t l = 0; l < file->layer_count; l++)
        file->layers[l].role = (int)role_by_name(file->layers[l].name);
    bool walls = has(file, DXF_WALLS);
    for (size_t l = 0; l < file->layer_count && !walls; l++)
        if (file->layers[l].role == DXF_UNKNOWN)
            file->layers[l].role = DXF_WALLS;
}

/* Marks the layers of windows. */
static void find_windows(DxfFile *file) {
    static const char *const words[] = {"window",  "glaz",    "fenster",  "fen\u00eatre",
                                        "fenetre", "ventana", "finestra", "\u7a93"};
    for (size_t l = 0; l < file->layer_count; l++)
        for (size_t w = 0; w < sizeof words / sizeof *words; w++)
            file->layers[l].window |= strcasestr(bare_name(file->layers[l].name), words[w]) != NULL;
}

static void note_choice(const DxfFile *file, HouseBuilder *builder) {
    Text note = {0};
    for (int role = 0; role < DXF_ROLES; role++) {
        size_t count = 0;
        for (size_t l = 0; l < file->layer_count && role_names[role]; l++) {
            if (file->layers[l].role != role || file->layers[l].hidden)
                continue;
            if (count < NAMES_SHOWN)
                add_name(&note, count ? ", " : "", file->layers[l].name);
            else if (count == NAMES_SHOWN)
                text_add(&note, ", ...");
            count++;
        }
        if (count)
            text_format(&note, " (%s); ", role_names[role]);
    }
    if (note.used > 2)
        import_report_note(builder->report, "layers taken: %.*s", (int)note.used - 2, note.text);
    memory_free(note.text);
}

bool dxf_layers_choose(DxfFile *file, HouseBuilder *builder) {
    if (!builder->options->layers)
        choose_by_name(file);
    else if (!choose_as_said(file, builder, builder->options->layers))
        return false;
    name_blocks(file);
    find_windows(file);
    note_choice(file, builder);
    return true;
}
