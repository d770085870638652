/* The input is a scenario of Vadere. */
#include "exchange/vadere.h"
#include "fuzz.h"
#include "fuzz_import.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_import(fuzz_file(data, size), vadere_read);
    return 0;
}
