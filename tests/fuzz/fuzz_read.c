/* libFuzzer's entry for the reader: any bytes as a YAML or JSON document, read, resolved, printed as a tree and as diagnostics. */
#include "fuzz.h"
#include "compiler/matc.h"
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = fuzz_no_file;
    const char *name = size && bytes[0] == '{' ? "fuzz.json" : "fuzz.yaml";
    MatcDocument *document = matc_read(name, (const char *)bytes, size, &options);
    matc_tree_text(document);
    matc_diagnostics(document, MATC_TEXT);
    matc_diagnostics(document, MATC_JSON);
    matc_document_free(document);
    return 0;
}
