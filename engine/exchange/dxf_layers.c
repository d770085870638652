#include "exchange/dxf_layers.h"

#include <string.h>
#include <strings.h>

#include "base/text.h"

static const char *const role_names[DXF_ROLES] = {
    [DXF_WALLS] = "walls", [DXF_DOORS] = "doors", [DXF_FURNITURE] = "furniture", [DXF_EXITS] = "exits"};

enum { NAMES_SHOWN = 8 };

/* Parts of names in some languages; the first that is found tells. A window is wall to whoever is inside. */
static const struct {
    const char *word;
    DxfRole role;
} words[] = {
    {"anno", DXF_NOTHING},
    {"dim", DXF_NOTHING},
    {"text", DXF_NOTHING},
    {"txt", DXF_NOTHING},
    {"hatch", DXF_NOTHING},
    {"patt", DXF_NOTHING},
    {"schraff", DXF_NOTHING},
    {"bem", DXF_NOTHING},
    {"defpoints", DXF_NOTHING},
    {"\u5bf8\u6cd5", DXF_NOTHING},
    {"\u6587\u5b57", DXF_NOTHING},
    {"exit", DXF_EXITS},
    {"ausgang", DXF_EXITS},
    {"sortie", DXF_EXITS},
    {"salida", DXF_EXITS},
    {"\u51fa\u53e3", DXF_EXITS},
    {"door", DXF_DOORS},
    {"t\u00fcr", DXF_DOORS},
    {"tuer", DXF_DOORS},
    {"porte", DXF_DOORS},
    {"porta", DXF_DOORS},
    {"puerta", DXF_DOORS},
    {"\u30c9\u30a2", DXF_DOORS},
    {"\u6249", DXF_DOORS},
    {"\u5efa\u5177", DXF_DOORS},
    {"furn", DXF_FURNITURE},
    {"m\u00f6bel", DXF_FURNITURE},
    {"moebel", DXF_FURNITURE},
    {"meuble", DXF_FURNITURE},
    {"mueble", DXF_FURNITURE},
    {"mobil", DXF_FURNITURE},
    {"arredo", DXF_FURNITURE},
    {"equip", DXF_FURNITURE},
    {"fixt", DXF_FURNITURE},
    {"sanit", DXF_FURNITURE},
    {"applian", DXF_FURNITURE},
    {"casework", DXF_FURNITURE},
    {"obstacle", DXF_FURNITURE},
    {"\u5bb6\u5177", DXF_FURNITURE},
    {"\u8a2d\u5099", DXF_FURNITURE},
    {"wall", DXF_WALLS},
    {"wand", DXF_WALLS},
    {"w\u00e4nd", DXF_WALLS},
    {"waend", DXF_WALLS},
    {"mur", DXF_WALLS},
    {"pared", DXF_WALLS},
    {"walkable", DXF_WALLS},
    {"column", DXF_WALLS},
    {"pillar", DXF_WALLS},
    {"st\u00fctz", DXF_WALLS},
    {"window", DXF_WALLS},
    {"glaz", DXF_WALLS},
    {"fenster", DXF_WALLS},
    {"fen\u00eatre", DXF_WALLS},
    {"fenetre", DXF_WALLS},
    {"ventana", DXF_WALLS},
    {"\u58c1", DXF_WALLS},
    {"\u67f1", DXF_WALLS},
    {"\u7a93", DXF_WALLS},
    {"grid", DXF_NOTHING},
    {"axis", DXF_NOTHING},
    {"achse", DXF_NOTHING},
    {"title", DXF_NOTHING},
    {"frame", DXF_NOTHING},
    {"border", DXF_NOTHING},
    {"symb", DXF_NOTHING},
    {"area", DXF_NOTHING},
    {"room", DXF_NOTHING},
    {"raum", DXF_NOTHING},
    {"ceil", DXF_NOTHING},
    {"roof", DXF_NOTHING},
    {"elec", DXF_NOTHING},
    {"light", DXF_NOTHING},
};

/* Without what a drawing within a drawing puts before its layers: "PLAN|WALLS", "PLAN$0$WALLS". */
static const char *bare_name(const char *name) {
    const char *bar = strrchr(name, '|'), *dollar = strrchr(name, '$');
    const char *last = bar && (!dollar || bar > dollar) ? bar : dollar;
    return last && last[1] ? last + 1 : name;
}

static DxfRole role_by_name(const char *name) {
    for (size_t w = 0; w < sizeof words / sizeof *words; w++)
        if (strcasestr(bare_name(name), words[w].word))
            return words[w].role;
    return DXF_UNKNOWN;
}

DxfRole dxf_layers_of_block(const char *name) {
    DxfRole role = role_by_name(name);
    return role == DXF_DOORS || role == DXF_FURNITURE ? role : DXF_UNKNOWN;
}

static bool is_called(const char *name, const char *wanted, size_t length) {
    return strlen(name) == length && strncasecmp(name, wanted, length) == 0;
}

/* "there are A, B and 12 more" */
static bool fault_unknown(const DxfFile *file, HouseBuilder *builder, const char *name, size_t length) {
    Text known = {0};
    for (size_t l = 0; l < file->layer_count && l < NAMES_SHOWN; l++)
        text_format(&known, "%s%.40s", l ? ", " : "", file->layers[l].name);
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

/* The role before an equals sign, whose length goes to `*used`; DXF_UNKNOWN: there is none. */
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

/* walls=NAME,NAME,doors=NAME: a name goes with the role before it. */
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

/* Did some layer get the role? */
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

static void note_choice(const DxfFile *file, HouseBuilder *builder) {
    Text note = {0};
    for (int role = 0; role < DXF_ROLES; role++) {
        size_t count = 0;
        for (size_t l = 0; l < file->layer_count && role_names[role]; l++) {
            if (file->layers[l].role != role || file->layers[l].hidden)
                continue;
            if (count < NAMES_SHOWN)
                text_format(&note, "%s%.40s", count ? ", " : "", file->layers[l].name);
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
    note_choice(file, builder);
    return true;
}
