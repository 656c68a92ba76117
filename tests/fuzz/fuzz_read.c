/* libFuzzer's entry for the reader: any bytes as a YAML, JSON or glTF document, read, resolved,
 * printed as a tree and as diagnostics. */
#include "fuzz.h"
#include "compiler/matc.h"
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = fuzz_no_file;
    const char *name = size >= 4 && !memcmp(bytes, "glTF", 4) ? "fuzz.glb"
                       : size && bytes[0] == '{' && memmem(bytes, size, "\"asset\"", 7)
                           ? "fuzz.gltf"
                       : size && bytes[0] == '{' ? "fuzz.json"
                                                 : "fuzz.yaml";
    options.pixels = true;
    MatcDocument *document = matc_read(name, (const char *)bytes, size, &options);
    matc_tree_text(document);
    matc_diagnostics(document, MATC_TEXT);
    matc_diagnostics(document, MATC_JSON);
    matc_document_free(document);
    return 0;
}
