/* The input is a zip file if it begins like one, otherwise the Home.xml of one. */
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "exchange/sh3d.h"
#include "fuzz.h"
#include "fuzz_import.h"

/* Returns a zip file in memory that holds the input uncompressed. */
static zip_source_t *zip_of(const uint8_t *data, size_t size) {
    zip_source_t *whole = zip_source_buffer_create(NULL, 0, 0, NULL);
    fuzz_expect(whole, "there is memory for a zip file");
    zip_source_keep(whole);
    zip_t *zip = zip_open_from_source(whole, ZIP_TRUNCATE, NULL);
    fuzz_expect(zip, "a zip file is begun");
    zip_source_t *entry = zip_source_buffer(zip, data, size, 0);
    zip_int64_t index = zip_file_add(zip, "Home.xml", entry, 0);
    fuzz_expect(index >= 0 && zip_set_file_compression(zip, (zip_uint64_t)index, ZIP_CM_STORE, 0) == 0 &&
                    zip_close(zip) == 0,
                "a zip file is made");
    return whole;
}

static void import_xml(const uint8_t *data, size_t size) {
    zip_source_t *whole = zip_of(data, size);
    zip_stat_t status;
    fuzz_expect(zip_source_open(whole) == 0 && zip_source_stat(whole, &status) == 0, "a zip file is opened");
    uint8_t *bytes = malloc(status.size);
    fuzz_expect(zip_source_read(whole, bytes, status.size) == (zip_int64_t)status.size, "a zip file is read");
    zip_source_close(whole);
    zip_source_free(whole);
    fuzz_import(fuzz_file(bytes, status.size), sh3d_read);
    free(bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size >= 2 && memcmp(data, "PK", 2) == 0)
        fuzz_import(fuzz_file(data, size), sh3d_read);
    else
        import_xml(data, size);
    return 0;
}
