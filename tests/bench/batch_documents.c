/* Generates many materials. Distinct materials are numbered in a mixed radix, with one digit for
 * each choice of structure. Materials of a scene are made from templates, one for each family:
 *     $c  a color             $d  a dark color        $n  a number in [0, 1]
 *     $p  a picture's name    $s  a scale in [1, 16]  <? ... ?>  a part in one third of them */
#include "batch_documents.h"
#include <stdio.h>
#include <string.h>

typedef struct {
    unsigned seed;
    Text *out;
} Writer;

static unsigned draw(Writer *w, unsigned below)
{
    w->seed = w->seed * 1664525u + 1013904223u;
    return (unsigned)((unsigned long long)w->seed * below >> 32);
}

void batch_picture(int index, char name[32])
{
    snprintf(name, 32, "picture%d.png", index % SCENE_PICTURES);
}

static void put_value(Writer *w, char what)
{
    char picture[32];
    switch (what) {
    case 'c':
        text_format(w->out, "\"#%02x%02x%02x\"", draw(w, 256), draw(w, 256), draw(w, 256));
        break;
    case 'd':
        text_format(w->out, "\"#%02x%02x%02x\"", draw(w, 48), draw(w, 48), draw(w, 48));
        break;
    case 'n':
        text_format(w->out, "0.%03d", (int)draw(w, 998) + 1);
        break;
    case 's':
        text_format(w->out, "%d.%d", (int)draw(w, 15) + 1, (int)draw(w, 9) + 1);
        break;
    case 'p':
        batch_picture((int)draw(w, SCENE_PICTURES), picture);
        text_put(w->out, picture);
        break;
    }
}

static void fill(Writer *w, const char *text)
{
    for (bool skip = false; *text; text++) {
        bool begin = !strncmp(text, "<?", 2), end = !strncmp(text, "?>", 2);
        if (begin || end) {
            skip = begin && draw(w, 3);
            text++;
        } else if (*text == '$') {
            text++;
            if (!skip)
                put_value(w, *text);
        } else if (!skip) {
            text_char(w->out, *text);
        }
    }
}

/* Maps that a Blend mixes. */
static const char *const layers[8] = {
    "$c",
    "{ map: Checker, color1: $c, color2: $c, input: { map: UVTransform, scaleU: $s, scaleV: $s } }",
    "{ map: VolumeChecker, color1: $c, color2: $d, input: { map: XYZTransform, transform: { scale: "
    "$s } } }",
    "{ map: Wood, frequency: $s, waveForm: Sin01 }",
    "{ map: Granite, input: { map: XYZTransform, transform: { scale: $s } } }",
    "{ map: Leopard, input: { map: XYZTransform, transform: { scale: $s, rotation: [0, $n, 0] } } "
    "}",
    "{ map: ImageMap, image: $p, input: { map: UVTransform, scaleU: $s, scaleV: $s } }",
    "{ map: Blend, blend: [{ value: -$n, input: $d }, { value: $n, input: $c }], "
    "input: { map: VolumeTurbulence, octaves: 3, noiseRatio: 0.6, size: $s } }"};

/* Inputs of a Blend; a wave's name follows. */
static const char *const masks[6] = {
    "{ map: VolumeTurbulence, octaves: 4, noiseRatio: 0.5, size: $s, waveForm: ",
    "{ map: VolumeTurbulence, octaves: 2, size: $s, input: { map: XYZTransform, transform: { "
    "scale: $s } }, waveForm: ",
    "{ map: Wood, frequency: $s, input: { map: Turbulence, octaves: 3, amount: $n }, waveForm: ",
    "{ map: Gradient, direction: [$n, $n, 0], frequency: $s, waveForm: ",
    "{ map: Granite, frequency: $s, waveForm: ",
    "{ map: Leopard, input: { map: XYZTransform, transform: { scale: $s } }, waveForm: "};
static const char *const mask_waves[12] = {"Id",      "Abs", "Sin01", "Ramp", "Cubic", "Triangle",
                                           "Scallop", "Sqr", "Atan",  "Tanh", "Sin",   "Exp"};
static const char *const bumps[4] = {
    "",
    "input: { map: BumpMap, strength: $n, displacement: { map: VolumeTurbulence, octaves: 3, size: "
    "$s } }\n",
    "input: { map: BumpMap, strength: $s, displacement: { map: ImageMap, image: $p } }\n",
    "input: { map: WaveMap, uCount: $s, vCount: $s }\n"};
static const char *const speculars[4] = {
    "", "specular: $n\n",
    "specular: { map: Checker, color1: $n, color2: $n, input: { map: UVTransform, scaleU: $s, "
    "scaleV: $s } }\n",
    "specular: { map: Blend, blend: [{ value: 0, input: $n }, { value: 1, input: $n }], "
    "input: { map: Wood, frequency: $s, waveForm: Triangle } }\n"};
static const char *const glosses[3] = {
    "", "shininess: $n\n",
    "shininess: { map: Granite, input: { map: XYZTransform, transform: { scale: $s "
    "} } }\n"};

/* Removes and returns the lowest digit of *number in that radix. */
static int digit(unsigned *number, unsigned radix)
{
    unsigned lowest = *number % radix;
    *number /= radix;
    return (int)lowest;
}

void batch_different(int index, Text *out)
{
    /* coprime to the count, so that consecutive materials differ in all digits */
    const unsigned stride = 87911;
    Writer w = {(unsigned)index * 2654435761u, out};
    unsigned number =
        (unsigned)((unsigned long long)stride * (unsigned)index % DIFFERENT_DOCUMENTS);
    text_put(out, "material: Phong\n");
    fill(&w, bumps[digit(&number, 4)]);
    fill(&w, "diffuse:\n  map: Blend\n  blend:\n  - { value: 0.1, input: ");
    fill(&w, layers[digit(&number, 8)]);
    fill(&w, " }\n  - { value: 0.8, input: ");
    fill(&w, layers[digit(&number, 8)]);
    fill(&w, " }\n  input: ");
    fill(&w, masks[digit(&number, 6)]);
    text_format(out, "%s }\n", mask_waves[digit(&number, 12)]);
    fill(&w, speculars[digit(&number, 4)]);
    fill(&w, glosses[digit(&number, 3)]);
}

/* Families of a scene, and their weights. */
static const struct {
    const char *name;
    int weight;
    const char *text;
} families[] = {
    {"paint", 90, "diffuse: $c\n<?specular: $n\nshininess: $n\n?>"},
    {"plastic", 50, "diffuse: $c\nspecular: 0.3\nshininess: $n\n"},
    {"plaster", 40,
     "diffuse: { map: Blend, blend: [{ value: -0.5, input: $c }, { value: 0.5, input: $c }], "
     "input: { map: "
     "VolumeTurbulence, octaves: 4, size: $s } }\n<?input: { map: BumpMap, strength: $n, "
     "displacement: { map: "
     "VolumeTurbulence, octaves: 3, size: $s } }\n?>"},
    {"picture", 60,
     "diffuse: { map: ImageMap, image: $p, input: { map: UVTransform, scaleU: $s, scaleV: $s } "
     "}\n<?specular: $n\n"
     "shininess: $n\n?>"},
    {"bumpyPicture", 40,
     "diffuse: { map: ImageMap, image: $p, input: &at { map: UVTransform, scaleU: $s, scaleV: $s } "
     "}\ninput: { map: "
     "BumpMap, strength: $s, displacement: { map: ImageMap, image: $p, input: *at } }\nspecular: "
     "$n\n"},
    {"wood", 40,
     "diffuse: { map: Blend, blend: [{ value: -0.8, input: $c }, { value: 0.8, input: $d }], "
     "input: { map: Wood, "
     "frequency: $s, waveForm: Sin01, input: { map: Turbulence, octaves: 3, amount: 0.1 } } "
     "}\n<?specular: "
     "$n\nshininess: "
     "$n\n?>"},
    {"checker", 20,
     "diffuse: { map: Checker, color1: $c, color2: $c, input: { map: UVTransform, scaleU: $s, "
     "scaleV: $s } "
     "}\n<?specular: "
     "$n\nshininess: $n\n?>"},
    {"metal", 40,
     "diffuse: $d\nspecular: $c\nshininess: { map: Blend, blend: [{ value: -1, input: $n }, { "
     "value: 1, input: $n }], "
     "input: { map: VolumeTurbulence, octaves: 2, size: $s } }\n"},
    {"rust", 20,
     "diffuse: { map: Blend, blend: [{ value: -0.05, input: $d }, { value: 0.1, input: $c }], "
     "input: &mask { map: "
     "VolumeTurbulence, octaves: 5, noiseRatio: 0.6, size: $s } }\nspecular: { map: Blend, blend: "
     "[{ value: -0.05, "
     "input: "
     "0.6 }, { value: 0.1, input: 0.02 }], input: *mask }\nshininess: $n\n"},
    {"stone", 25,
     "diffuse: { map: Blend, blend: [{ value: -0.4, input: $c }, { value: 0.4, input: $c }], "
     "input: { map: Granite, "
     "input: { map: XYZTransform, transform: { scale: $s } } } }\nspecular: $n\nshininess: $n\n"},
    {"marble", 15,
     "diffuse: { map: Blend, blend: [{ value: -1, input: $d }, { value: 1, input: $c }], input: { "
     "map: Gradient, "
     "direction: [1, 0, 0], frequency: $s, waveForm: Sin01, input: { map: Turbulence, octaves: 4, "
     "amount: 0.3 } } }\n"
     "specular: 0.4\nshininess: $n\n"},
    {"cloth", 20,
     "diffuse: { map: Checker, color1: $c, color2: { map: ImageMap, image: $p }, input: { map: "
     "UVTransform, scaleU: "
     "$s, "
     "scaleV: $s } }\n"},
    {"glass", 20, "diffuse: $d\ntransparency: $c\nspecular: 0.9\nshininess: 0.95\n"},
    {"fence", 10,
     "diffuse: $c\ntransparency: { map: Checker, color1: 1, color2: 0, input: { map: UVTransform, "
     "scaleU: $s, scaleV: "
     "$s "
     "} }\ninterpolatedTransparency: true\n"},
    {"leaf", 20,
     "diffuse: { map: ImageMap, image: $p }\ndiffuseTransparency: $c\n<?specular: $n\n?>"},
    {"lamp", 20, "diffuse: $d\nemissive: $c\n"},
    {"screen", 15,
     "diffuse: 0.02\nemissive: { map: ImageMap, image: $p }\nspecular: 0.5\nshininess: 0.9\n"},
    {"lava", 5,
     "diffuse: $d\nemissive: { map: Blend, blend: [{ value: 0, input: [4, 2, 0.5] }, { value: 0.2, "
     "input: 0 }], input: "
     "{ "
     "map: VolumeTurbulence, size: $s, octaves: 5, waveForm: Abs } }\n"},
};

void batch_scene(int index, Text *out, const char **family)
{
    const size_t count = sizeof families / sizeof *families;
    Writer w = {(unsigned)index * 2654435761u + 1, out};
    int all = 0;
    size_t i = 0;
    for (size_t k = 0; k < count; k++)
        all += families[k].weight;
    for (int at = (int)draw(&w, (unsigned)all); at >= families[i].weight; i++)
        at -= families[i].weight;
    *family = families[i].name;
    text_put(out, "material: Phong\n");
    fill(&w, families[i].text);
}
