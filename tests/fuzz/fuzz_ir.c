/* libFuzzer's entry for the IR's text: any bytes. An IR that is read and passes the check prints
 * and reads back as itself, is optimized, and passes the check afterwards. */
#include "fuzz.h"
#include "compiler/opt/opt.h"
#include <stdlib.h>
#include <string.h>

static const char *printed(Arena *arena, const Ir *ir)
{
    Text text = text_new(arena);
    ir_print(&text, ir);
    return text.at ? text.at : "";
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const Graph none;
    MatcOptions options;
    Arena arena = {0};
    matc_options_init(&options);
    Session session = {.options = &options, .arena = &arena, .optimize = 2, .check = true};
    const char *fault = NULL, *text = arena_string(&arena, (const char *)bytes, size);
    Ir *ir = ir_read(&session, text, &none, &fault);
    if (ir && !ir_check(ir)) {
        opt_dead(ir); /* unreachable nodes are not printed */
        const char *first = printed(&arena, ir);
        const Ir *again = ir_read(&session, first, &none, &fault);
        if (!again || ir_check(again) || strcmp(printed(&arena, again), first) != 0)
            abort();
        ir->simplify = opt_simplify;
        if (opt_run(&session, ir) && ir_check(ir))
            abort();
    }
    if (ir)
        ir_done(ir);
    arena_free(&arena);
    return 0;
}
