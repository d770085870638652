/* Names of furniture from the names of a drawing's blocks: "xref-Bishop-Plan$0$FIXT-OVALBATH" is a bath tub. Private to
 * the importers. */
#pragma once

/* Returns the kind of furniture that the last piece of a block's name says, "bath tub"; that piece itself if it is a
 * plain word; otherwise "furniture". Bound drawings put their own name and "$0$", linked ones "|", before a block's.
 * The result is `block`'s own text or constant. */
const char *block_name_of(const char *block);
