#include "exchange/block_name.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

enum { WHOLE = 3 /* letters: shorter words of the table must stand alone */, PLAIN_LEAST = 3, PLAIN_MOST = 24 };

/* What blocks are called, and what that is. Of several in a name the last one counts: a bath sink is a washbasin. */
static const struct {
    const char *word, *name;
} kinds[] = {
    {"bathtub", "bath tub"},
    {"bath", "bath tub"},
    {"tub", "bath tub"},
    {"shower", "shower"},
    {"toilet", "toilet"},
    {"watercloset", "toilet"},
    {"lavatory", "washbasin"},
    {"wc", "toilet"},
    {"bidet", "bidet"},
    {"urinal", "urinal"},
    {"washbasin", "washbasin"},
    {"basin", "washbasin"},
    {"lav", "washbasin"},
    {"sink", "sink"},
    {"bedside", "bedside table"},
    {"nightstand", "bedside table"},
    {"bed", "bed"},
    {"sofa", "sofa"},
    {"couch", "sofa"},
    {"settee", "sofa"},
    {"armchair", "armchair"},
    {"chair", "chair"},
    {"stool", "stool"},
    {"desk", "desk"},
    {"table", "table"},
    {"wardrobe", "wardrobe"},
    {"bookcase", "bookcase"},
    {"shelf", "shelf"},
    {"shelves", "shelf"},
    {"shelving", "shelf"},
    {"dresser", "chest of drawers"},
    {"drawers", "chest of drawers"},
    {"cupboard", "cupboard"},
    {"cabinet", "cupboard"},
    {"refrigerator", "refrigerator"},
    {"fridge", "refrigerator"},
    {"stove", "cooker"},
    {"cooker", "cooker"},
    {"range", "cooker"},
    {"oven", "cooker"},
    {"hob", "cooker"},
    {"dishwasher", "dishwasher"},
    {"washer", "washing machine"},
    {"washing", "washing machine"},
    {"dryer", "dryer"},
    {"television", "television"},
    {"tv", "television"},
    {"piano", "piano"},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Returns what follows the last "|" or "$0$", with any number between the signs. */
static const char *last_piece(const char *block) {
    const char *piece = block;
    for (const char *at = block; *at; at++) {
        const char *end = at + 1;
        while (*at == '$' && isdigit((unsigned char)*end))
            end++;
        if (*at == '|')
            piece = at + 1;
        else if (*at == '$' && *end == '$' && end > at + 1)
            piece = end + 1;
    }
    return piece;
}

/* True if the word stands at `at`, alone if it is short. */
static bool stands(const char *piece, const char *at, const char *word) {
    size_t length = strlen(word);
    if (strncasecmp(at, word, length) != 0)
        return false;
    bool alone = (at == piece || !isalpha((unsigned char)at[-1])) && !isalpha((unsigned char)at[length]);
    return alone || length > WHOLE;
}

static bool is_plain(const char *piece) {
    size_t length = strlen(piece);
    for (size_t i = 0; i < length; i++)
        if (!isalpha((unsigned char)piece[i]) && piece[i] != ' ')
            return false;
    return length >= PLAIN_LEAST && length <= PLAIN_MOST;
}

const char *block_name_of(const char *block) {
    const char *piece = last_piece(block), *found = NULL, *end = piece;
    for (const char *at = piece; *at; at++)
        for (size_t k = 0; k < KINDS; k++) {
            const char *behind = at + strlen(kinds[k].word);
            if (!stands(piece, at, kinds[k].word) || behind <= end)
                continue; /* of words that end at one place the longest counts, which stands first */
            found = kinds[k].name;
            end = behind;
        }
    return found ? found : is_plain(piece) ? piece : "furniture";
}
