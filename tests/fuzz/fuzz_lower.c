/* libFuzzer's entry for lowering and optimizer: the bytes are choices of the generator of valid
 * documents (tests/stress), so that no input is wasted on text that does not parse. The first
 * two bytes choose the target and the pass. */
#include "fuzz.h"
#include "compiler/matc.h"
#include "grammar/tables.h"
#include "tests/stress/generate.h"
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    uint32_t script[MAX_CHOICES];
    int count = 0;
    for (size_t i = 2; i < size && count < MAX_CHOICES; i++)
        script[count++] =
            /* small numbers, and multiples of 2^17 */
            bytes[i] < 128 ? bytes[i] : (uint32_t)(bytes[i] - 127) << 17;
    Choices choices;
    Arena arena = {0};
    Text text = text_new(&arena);
    choices_script(&choices, script, count);
    generate_document(&choices, &text);
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.check = true;
    options.read_file = generate_file;
    options.target = target_table[size > 0 ? bytes[0] % TARGET_COUNT : 0].name;
    options.pass = pass_table[size > 1 ? bytes[1] % PASS_COUNT : 0].name;
    MatcDocument *document = matc_read("fuzz.yaml", text.at, text.size, &options);
    for (options.optimize = 0; options.optimize <= 2; options.optimize += 2) {
        MatcProgram *program =
            matc_compile(document, 0, MATC_FRAGMENT | MATC_VERTEX | MATC_IR, &options);
        if (!matc_ok(program)) {
            fprintf(stderr, "%s%s%s", text.at, matc_diagnostics(document, MATC_TEXT),
                    matc_program_diagnostics(program, MATC_TEXT));
            abort();
        }
        matc_program_free(program);
    }
    matc_document_free(document);
    arena_free(&arena);
    return 0;
}
