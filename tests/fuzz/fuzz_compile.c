/* libFuzzer's entry for the whole compiler without glslang: any bytes as a document, compiled
 * for the G-buffer and as IR, with the IR checked after every pass. */
#include "fuzz.h"
#include "compiler/matc.h"
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.check = true;
    options.read_file = fuzz_no_file;
    MatcDocument *document = matc_read(size && bytes[0] == '{' ? "fuzz.json" : "fuzz.yaml",
                                       (const char *)bytes, size, &options);
    for (int i = 0; i < matc_material_count(document) && i < 4; i++)
        for (options.optimize = 0; options.optimize <= 2; options.optimize += 2) {
            MatcProgram *program =
                matc_compile(document, i, MATC_FRAGMENT | MATC_IR | MATC_REFLECT, &options);
            const char *reported = matc_program_diagnostics(program, MATC_TEXT);
            if (strstr(reported, "internal error"))
                abort();
            matc_program_free(program);
        }
    matc_diagnostics(document, MATC_TEXT);
    matc_document_free(document);
    return 0;
}
