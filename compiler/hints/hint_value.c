/* Hints for values in the syntax of other languages: foreign.def, FOREIGN_FORM. */
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include "grammar/foreign_table.h"
#include <math.h>
#include <string.h>

enum { BYTE = 255, COLOR_COMPONENTS = 4, FULL_CIRCLE = 360 };

/* -- Colors as functions: rgb(255, 0, 0), hsl(120, 50%, 50%) */

typedef struct {
    int count;
    double number[COLOR_COMPONENTS];
    bool percent[COLOR_COMPONENTS], whole; /* `whole`: no argument has a decimal point */
} Arguments;

/* Parses "(255, 0, 0)" or "(120 50% 50%)"; false unless it has three or four numbers. */
static bool read_arguments(const Session *session, const char *text, Arguments *arguments)
{
    *arguments = (Arguments){.whole = true};
    for (const char *at = text + strspn(text, "( "); *at && *at != ')'; at += strspn(at, ", /")) {
        const size_t size = strcspn(at, ", /)%");
        const char *alone = arena_string(session->arena, at, size);
        const int i = arguments->count;
        if (i == COLOR_COMPONENTS || !text_number(alone, size, &arguments->number[i]))
            return false;
        arguments->percent[i] = at[size] == '%';
        arguments->whole &= !strchr(alone, '.');
        arguments->count++;
        at += size + arguments->percent[i];
        if (!strncmp(at, "deg", 3))
            return false;
    }
    return arguments->count >= 3;
}

static double share(const Arguments *a, int i, double full)
{
    return a->number[i] / (a->percent[i] ? 100 : full);
}

/* Returns red, green or blue (`component` 0, 1, 2) in [0, 1] from the hue in degrees: the
 * triangular ramp of HSL and HSV, scaled by the chroma. */
static double component_of_hue(double hue, int component, double low, double chroma)
{
    /* sector relative to the center of the component's ramp, which is 3 */
    const double sector = fmod(hue / (FULL_CIRCLE / 6.) + 6 - 2 * component + 3, 6);
    const double ramp = 2 - fabs(sector - 3);
    return low + chroma * fmin(fmax(ramp, 0), 1);
}

static void rgb_of_hue(const Arguments *a, bool lightness, double rgb[3])
{
    const double hue = fmod(fmod(a->number[0], FULL_CIRCLE) + FULL_CIRCLE, FULL_CIRCLE);
    const double full = a->number[1] > 1 || a->number[2] > 1 ? 100 : 1;
    const double saturation = share(a, 1, full), last = share(a, 2, full);
    const double chroma = saturation * (lightness ? 1 - fabs(2 * last - 1) : last);
    for (int component = 0; component < 3; component++)
        rgb[component] =
            component_of_hue(hue, component, lightness ? last - chroma / 2 : last - chroma, chroma);
}

static void put_hex(Text *out, const double *rgb, int count)
{
    text_put(out, "\"#");
    for (int i = 0; i < count; i++)
        text_format(out, "%02x", (unsigned)lround(fmin(fmax(rgb[i], 0), 1) * BYTE));
    text_put(out, "\"");
}

/* Writes bytes as a hex color, fractions as a list. */
static void put_color(Text *out, const char *name, const Arguments *a)
{
    double rgb[COLOR_COMPONENTS] = {0};
    const bool red = !strncmp(name, "rgb", 3);
    bool bytes = a->whole;
    for (int i = 0; i < 3; i++)
        bytes |= a->percent[i] || a->number[i] > 1;
    if (!red)
        rgb_of_hue(a, !strncmp(name, "hsl", 3), rgb);
    for (int i = 0; red && i < 3; i++)
        rgb[i] = share(a, i, bytes ? BYTE : 1);
    if (a->count == COLOR_COMPONENTS)
        rgb[3] = share(a, 3, a->number[3] > 1 ? BYTE : 1);
    if (!red || bytes) {
        put_hex(out, rgb, a->count);
        return;
    }
    for (int i = 0; i < a->count; i++) {
        text_put(out, i ? ", " : "[");
        text_plain(out, rgb[i]);
    }
    text_put(out, "]");
}

static bool hint_function(Resolver *r, const Tree *tree)
{
    static const char *const names[] = {"rgba(", "rgb(", "hsla(", "hsl(", "hsva(", "hsv("};
    Arguments arguments;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const size_t size = strlen(names[i]);
        if (!text_same_start(tree->text, names[i], size) ||
            !read_arguments(r->session, tree->text + size - 1, &arguments))
            continue;
        Text meant = text_new(r->session->arena);
        put_color(&meant, names[i], &arguments);
        diag_add(r->session, tree->span, DIAG_color_form, tree->text, meant.at);
        return true;
    }
    return false;
}

/* Reports a hexadecimal number such as 0xff8800 in the place of a color. */
static bool hint_hexadecimal(Resolver *r, const Tree *tree)
{
    const char *digits = tree->text + 2;
    const size_t size = tree->count > 2 ? tree->count - 2 : 0;
    if (!text_same_start(tree->text, "0x", 2) || strspn(digits, "0123456789abcdefABCDEF") != size ||
        (size != 3 && size != 6 && size != 8))
        return false;
    Text meant = text_new(r->session->arena);
    text_format(&meant, "\"#%s\"", digits);
    diag_add(r->session, tree->span, DIAG_color_form, tree->text, meant.at);
    return true;
}

/* -- Numbers */

/* Reports "0,5", a number with a decimal comma; "1, 2" with a space is a list. */
static bool hint_decimal(Resolver *r, const Tree *tree, bool one)
{
    const size_t sign = strspn(tree->text, "+-"), whole = strspn(tree->text + sign, "0123456789");
    const char *comma = tree->text + sign + whole;
    if (sign > 1 || !whole || *comma != ',' || !comma[1] ||
        comma[1 + strspn(comma + 1, "0123456789")])
        return false;
    Text number = text_new(r->session->arena), list = text_new(r->session->arena);
    text_format(&number, "%.*s.%s", (int)(sign + whole), tree->text, comma + 1);
    text_put(&list, "");
    if (!one)
        text_format(&list, ", and a list has brackets: [%.*s, %s]", (int)(sign + whole), tree->text,
                    comma + 1);
    diag_add(r->session, tree->span, DIAG_decimal_comma, number.at, list.at);
    return true;
}

static bool hint_truth(Resolver *r, const char *what, const Tree *tree)
{
    static const char *const words[] = {"true", "yes", "on", "false", "no", "off"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (text_same(tree->text, words[i])) {
            diag_add(r->session, tree->span, DIAG_truth_number, what, tree->text);
            return true;
        }
    return false;
}

bool hint_value(Resolver *r, const char *what, const Tree *tree, ComponentCount components)
{
    if (tree->kind != TREE_scalar || !tree->count || strlen(tree->text) != tree->count ||
        tree->count > LIMIT_NAME)
        return false;
    if (hint_truth(r, what, tree) || hint_decimal(r, tree, r->one_number || components.most == 1))
        return true;
    return components.most >= 3 && (hint_function(r, tree) || hint_hexadecimal(r, tree));
}

/* -- Names of colors and maps */

bool hint_color_name(Resolver *r, const Tree *tree, const char *text)
{
    const char *here = foreign_name(FOREIGN_COLOR, KIND_COUNT, text);
    Text near = text_new(r->session->arena);
    if (!here)
        return false;
    text_format(&near, "; here it is %s", here);
    diag_add(r->session, tree->span, DIAG_unknown_color, text, near.at);
    return true;
}

bool hint_map_name(Resolver *r, const Tree *tree)
{
    const char *here = foreign_name(FOREIGN_MAP, KIND_COUNT, tree->text);
    const size_t size = here ? strcspn(here, " ,:") : 0;
    Kind kind = KIND_COUNT;
    for (int i = 0; size && i < KIND_COUNT; i++)
        if (strlen(kind_table[i].name) == size && !strncmp(kind_table[i].name, here, size))
            kind = (Kind)i;
    if (kind == KIND_COUNT)
        return false;
    diag_add(r->session, tree->span, DIAG_bare_name, tree->text, "a map, not a color; write", "map",
             kind_table[kind].name);
    return true;
}
