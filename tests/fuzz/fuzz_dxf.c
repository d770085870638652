/* The input is a drawing. */
#include "exchange/dxf.h"
#include "fuzz.h"
#include "fuzz_import.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_import(fuzz_file(data, size), dxf_read);
    return 0;
}
