/* libFuzzer's entry for layouts: any bytes as a layout file; a valid layout reads back from its
 * own text, and packs a material. */
#include "fuzz.h"
#include "compiler/matc.h"
#include <stdlib.h>
#include <string.h>

static void use_layout(const MatcLayout *layout, MatcOptions *options)
{
    static const char text[] = "material: Phong\ndiffuse: { map: Granite }\ntransparency: 0.5\n";
    MatcLayout *again = matc_layout_read("again.yaml", matc_layout_text(layout),
                                         strlen(matc_layout_text(layout)), options);
    if (!matc_layout_ok(again) || strcmp(matc_layout_text(again), matc_layout_text(layout)) != 0)
        abort();
    matc_layout_free(again);
    options->custom = layout;
    MatcDocument *document = matc_read("fuzz.yaml", text, sizeof text - 1, options);
    matc_program_free(matc_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK, options));
    matc_document_free(document);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = fuzz_no_file;
    options.validate = false;
    const char *name = size && bytes[0] == '{' ? "fuzz.json" : "fuzz.yaml";
    MatcLayout *layout = matc_layout_read(name, (const char *)bytes, size, &options);
    matc_layout_diagnostics(layout, MATC_TEXT);
    if (matc_layout_ok(layout))
        use_layout(layout, &options);
    matc_layout_free(layout);
    return 0;
}
