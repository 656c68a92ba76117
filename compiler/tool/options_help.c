/* What --help prints. Lists of targets, passes and layouts are those of the tables. */
#include "compiler/tool/options.h"
#include "compiler/base/text.h"
#include "grammar/layout_tables.h"

static const char before_target[] =
    "usage: matc [options] document...\n"
    "\n"
    "Compiles material trees (YAML, JSON; - is standard input) to GLSL.\n"
    "\n"
    "output\n"
    "  -o FILE              write there; - and the default are standard output. A suffix selects the\n"
    "                       output, .spv SPIR-V, where no option does\n"
    "  -d DIR               write NAME.frag and so on there, for all materials of all documents, each program once,\n"
    "                       and manifest.json, which says what uses which; several passes may be named\n"
    "  -j N                 by so many threads; all processors without it\n"
    "  @FILE                documents named in a file, one a line; a line that begins with # is none\n"
    "  --cache DIR          with -d: keep there what the next run can use; MATC_CACHE says the same\n"
    "  --cache-limit=MIB    of the folder: 1024; the least recently used goes first\n"
    "  --cache-stats        what the cache holds and how often it helped\n"
    "  --emit=LIST          glsl (default), vertex, tessvertex, tesscontrol, tesseval,\n"
    "                       geometryvertex, geometry, compute, displace, unpack, reflect, layout,\n"
    "                       spirv, ir, dot, tree; several need -d. Of --target=spirv all stages are SPIR-V\n"
    "  --textures DIR       write the textures that matc makes there, as KTX\n"
    "  --watch              with -o or -d: stay, and do it again whenever a file changes that it was made from\n"
    "  -I DIR               where `include:` looks for files that are not beside the document; after that, among\n"
    "                       those that come with matc\n"
    "  --root=DIR           read nothing outside DIR that a document names, links resolved: for documents of others\n"
    "  -MD, -MF FILE, -MT T write a depfile for make and ninja; its name; its target\n"
    "program\n";

static const char before_layout[] =
    "  --slot=S             for --pass=value: diffuse (default), normal, specular, ...\n";

static const char after_layout[] =
    "                       auto: the smallest that holds all materials given. --explain L shows its fields\n"
    "  --layout-error=E     of auto: what a colour's square root may be off (0.00196), other slots in proportion\n"
    "  --cases=C            with -d, what the unpacking text reads of the layout: used (default), the cases that the\n"
    "                       materials write; all, so that it holds for materials that come later\n"
    "  --normals=N          of a G-buffer: of eye space (default) or the world\n"
    "  --precision=P        fast (default), balanced, exact: sets the next four; each can still be named\n"
    "  --constants=C        baked, uniform: numbers of the document come from a uniform block; auto (default): with "
    "-d,\n"
    "                       those in which materials that can share a program differ\n"
    "  --noise=N            lattice (default), groimp, simplex\n"
    "  --coordinates=C      plain (default), long: no accuracy lost to scales and offsets\n"
    "  --powers=P           squaring (default), pow, compensated\n"
    "  --trigonometry=T     native (default), bounded\n"
    "  --aa=A               auto (default), none, box, aniso: what is averaged over the pixel\n"
    "  --derivatives=D      auto (default), finite, analytic: the slopes of BumpMap\n"
    "  --material=NAME      of `materials:`; without it, the only one\n"
    "  -O0, -O1, -O2        as written; optimised (default); -O, -O3 and -Os are -O2\n"
    "measuring\n"
    "  --max-error=E        the fastest choices, among those not named, that keep every slot within E of the "
    "reference\n"
    "  --pareto             run time and error of every choice not named; -o BASENAME: also as .csv, .svg and .png\n"
    "  --range=R            coordinates that count are in [-R, R]: 4\n"
    "  --gl=KIND            measure on osmesa (default), or on egl: a GPU where there is one\n"
    "questions\n"
    "  --eval \"u=.3 v=.4\"   values of all slots at a point, by the C reference\n"
    "  --list[=KIND]        materials, maps, waves, channels, slots ...; one kind of them\n"
    "  --list FILE          the definitions that a document has, or includes\n"
    "  --explain NAME       one of them; with a FILE, a definition\n"
    "  --schema[=OF]        JSON Schema of document (default), layout, manifest or reflection\n"
    "  --schema FILE        that of documents, with the definitions that the file has, or includes\n"
    "  --stats              times, nodes and cost of every stage, choices and their reasons, on standard error\n"
    "  --diagnostics=FORM   text (default), json\n"
    "  -Wno-NAME            do not give that warning; -Werror, -Werror=NAME: all, or that one, are errors.\n"
    "                       --explain warnings lists them\n"
    "  --no-validate        do not ask glslang\n"
    "  --check              check the IR after every pass\n"
    "  --help, --version\n"
    "\n"
    "Exit status: 0 fine, 1 a fault in a document or file, 2 wrong usage.\n";

/* ", name", or "name" as the first of a list; ` (default)` behind the default. */
static void put_name(Text *out, bool first, const char *name, bool is_default)
{
    text_format(out, "%s%s%s", first ? "" : ", ", name, is_default ? " (default)" : "");
}

/* The target whose default the layout is, but for the default target; NULL: it is none's. */
static const char *default_of(int layout)
{
    for (int i = 0; i < TARGET_COUNT; i++)
        if (i != TARGET_DEFAULT && target_table[i].layout == layout)
            return target_table[i].name;
    return NULL;
}

/* The default, then those of other targets, then the rest. */
static void put_layouts(Text *out)
{
    const int first = target_table[TARGET_DEFAULT].layout;
    put_name(out, true, layout_table[first].name, true);
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (i != first && default_of(i))
            text_format(out, ", %s (default of %s)", layout_table[i].name, default_of(i));
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (i != first && !default_of(i))
            put_name(out, false, layout_table[i].name, false);
}

const char *options_help(Arena *arena)
{
    Text out = text_new(arena);
    text_put(&out, before_target);
    text_put(&out, "  --target=T           ");
    for (int i = 0; i < TARGET_COUNT; i++)
        put_name(&out, i == 0, target_table[i].name, i == TARGET_DEFAULT);
    text_put(&out, "\n  --pass=P             ");
    for (int i = 0; i < PASS_COUNT; i++)
        put_name(&out, i == 0, pass_table[i].name, i == PASS_gbuffer);
    text_put(&out, "\n");
    text_put(&out, before_layout);
    text_put(&out, "  --layout=L           ");
    put_layouts(&out);
    text_put(&out, "; a file;\n");
    text_put(&out, after_layout);
    return out.at;
}
