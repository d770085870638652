/* The input is a walkable area. */
#include "exchange/wkt.h"
#include "fuzz.h"
#include "fuzz_import.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_import(fuzz_file(data, size), wkt_read);
    return 0;
}
