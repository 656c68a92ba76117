/* Reads BMP files with the headers BITMAPCOREHEADER (12 bytes), BITMAPINFOHEADER (40) and its
 * successors (52, 56, 108, 124): 1, 4 and 8 bits with a palette; 16, 24 and 32 bits, with or
 * without masks. Colors become bytes. Compressed files are rejected.
 *
 *     "BM", size of the file, 0, offset of the rows
 *     size of the header, width, height, 1, bits, ...; masks; palette
 *     rows, the bottom one first unless height < 0, each a multiple of four bytes */
#include "compiler/images/image_file.h"

enum {
    FILE_HEADER = 14,
    CORE_HEADER = 12,
    INFO_HEADER = 40,
    MASKED_HEADER = 52, /* first header version that includes the masks */
    ALPHA_HEADER = 56,
    LARGEST_HEADER = 1 << 12,
    BI_RGB = 0,
    BI_BITFIELDS = 3,
    BI_ALPHABITFIELDS = 6,
    COMPONENTS = 4,
    BYTE = 255,
};

typedef struct {
    const uint8_t *bytes;
    /* in bytes: sizes of the file and of its header; offset of the rows, size of a row */
    size_t size, header, rows, stride;
    unsigned bits, compression;
    bool from_top;
    const uint8_t *palette;
    size_t entry, colors; /* size of a palette entry in bytes, and number of entries */
    uint32_t masks[COMPONENTS];
} Bmp;

static uint32_t read_two(const Bmp *bmp, size_t at)
{
    return bmp->bytes[at] | (uint32_t)bmp->bytes[at + 1] << 8;
}
static uint32_t read_four(const Bmp *bmp, size_t at)
{
    return read_two(bmp, at) | read_two(bmp, at + 2) << 16;
}

/* Reads width, height, bits and compression. */
static const char *read_sizes(Bmp *bmp, Image *image)
{
    const bool core = bmp->header == CORE_HEADER;
    const size_t at = FILE_HEADER + 4;
    const double width = core ? (double)read_two(bmp, at) : (double)(int32_t)read_four(bmp, at);
    const double height =
        core ? (double)read_two(bmp, at + 2) : (double)(int32_t)read_four(bmp, at + 4);
    bmp->bits = read_two(bmp, at + (core ? 6 : 10));
    bmp->compression = core ? BI_RGB : read_four(bmp, at + 12);
    bmp->from_top = height < 0;
    const char *why = image_file_check_side(width, height < 0 ? -height : height);
    if (why)
        return why;
    *image = (Image){.path = image->path, .index = image->index, .bits = 8, .opaque = true};
    image->width = (int)width;
    image->height = (int)(height < 0 ? -height : height);
    bmp->stride = ((size_t)image->width * bmp->bits + 31) / 32 * 4;
    return NULL;
}

/* Returns true for contiguous set bits; a zero mask means a missing component. */
static bool is_mask(uint32_t mask)
{
    while (mask && !(mask & 1))
        mask >>= 1;
    return !(mask & (mask + 1));
}

/* Sets the component masks of 16 and 32 bit pixels: five or eight bits per color by default, or
 * those in the file. */
static const char *read_masks(Bmp *bmp, Image *image)
{
    static const uint32_t plain[2][COMPONENTS] = {{0x7C00, 0x3E0, 0x1F, 0},
                                                  {0xFF0000, 0xFF00, 0xFF, 0}};
    const bool alpha = bmp->header >= ALPHA_HEADER || bmp->compression == BI_ALPHABITFIELDS;
    for (int i = 0; i < COMPONENTS; i++)
        bmp->masks[i] = plain[bmp->bits == 32][i];
    if (bmp->compression == BI_RGB)
        return NULL;
    if (bmp->size < FILE_HEADER + INFO_HEADER + COMPONENTS * 4)
        return image_file_cut;
    for (int i = 0; i < COMPONENTS; i++) {
        bmp->masks[i] =
            i < 3 || alpha ? read_four(bmp, FILE_HEADER + INFO_HEADER + 4 * (size_t)i) : 0;
        if (!is_mask(bmp->masks[i]))
            return "the bits of a color channel are not contiguous";
    }
    image->opaque = !bmp->masks[3];
    return NULL;
}

/* Finds the palette after the header. */
static const char *read_palette(Bmp *bmp)
{
    const size_t at = FILE_HEADER + bmp->header, most = (size_t)1 << bmp->bits;
    const uint32_t used = bmp->header == CORE_HEADER ? 0 : read_four(bmp, FILE_HEADER + 32);
    bmp->entry = bmp->header == CORE_HEADER ? 3 : 4;
    bmp->colors = used && used < most ? used : most;
    bmp->palette = bmp->bytes + at;
    return bmp->size - at < bmp->colors * bmp->entry ? image_file_cut : NULL;
}

static const char *read_header(Bmp *bmp, Image *image)
{
    if (bmp->size < FILE_HEADER + CORE_HEADER)
        return image_file_cut;
    bmp->rows = read_four(bmp, 10);
    bmp->header = read_four(bmp, FILE_HEADER);
    if (bmp->header != CORE_HEADER && (bmp->header < INFO_HEADER || bmp->header > LARGEST_HEADER))
        return "unknown kind of BMP; save it as PNG";
    if (bmp->size - FILE_HEADER < bmp->header)
        return image_file_cut;
    const char *why = read_sizes(bmp, image);
    const bool masked = bmp->bits == 16 || bmp->bits == 32,
               palette = bmp->bits == 1 || bmp->bits == 4 || bmp->bits == 8;
    if (why)
        return why;
    if (bmp->compression != BI_RGB &&
        !(masked && (bmp->compression == BI_BITFIELDS || bmp->compression == BI_ALPHABITFIELDS)))
        return "compressed BMP is not supported; save it without compression, or as PNG";
    if (!masked && !palette && bmp->bits != 24)
        return "unknown kind of BMP; save it as PNG";
    why = masked ? read_masks(bmp, image) : palette ? read_palette(bmp) : NULL;
    if (!why &&
        (bmp->rows > bmp->size || bmp->size - bmp->rows < bmp->stride * (size_t)image->height))
        why = image_file_cut;
    return why;
}

/* Returns a component of 1 to 32 bits, rounded to a byte. */
static uint8_t masked_component(uint32_t pixel, uint32_t mask)
{
    uint64_t value = pixel & mask, most = mask;
    while (!(most & 1)) {
        value >>= 1;
        most >>= 1;
    }
    return (uint8_t)((value * BYTE + most / 2) / most);
}

/* Reads a pixel. Returns false if its index is outside the palette. */
static bool read_pixel(const Bmp *bmp, const uint8_t *row, size_t x, uint8_t rgba[COMPONENTS])
{
    const uint8_t *at = row + x * bmp->bits / 8;
    rgba[3] = BYTE;
    if (bmp->bits == 16 || bmp->bits == 32) {
        const uint32_t low = at[0] | (uint32_t)at[1] << 8;
        const uint32_t pixel =
            bmp->bits == 16 ? low : low | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
        for (int i = 0; i < COMPONENTS; i++)
            rgba[i] = bmp->masks[i] ? masked_component(pixel, bmp->masks[i]) : i == 3 ? BYTE : 0;
        return true;
    }
    if (bmp->bits < 24) {
        const unsigned shift = 8 - bmp->bits - (unsigned)(x * bmp->bits % 8);
        const size_t color = (size_t)at[0] >> shift & (((size_t)1 << bmp->bits) - 1);
        if (color >= bmp->colors)
            return false;
        at = bmp->palette + color * bmp->entry;
    }
    for (int i = 0; i < 3; i++)
        rgba[i] = at[2 - i]; /* blue comes first */
    return true;
}

const char *image_bmp(ImageFile *file)
{
    Bmp bmp = {.bytes = (const uint8_t *)file->at, .size = (size_t)(file->end - file->at)};
    Image *image = file->image;
    const char *why = read_header(&bmp, image);
    if (why || !file->session->options->pixels)
        return why;
    if ((why = image_file_allocate(file)))
        return why;
    uint8_t *texel = image->texels;
    for (int y = 0; y < image->height; y++) {
        const int row = bmp.from_top ? image->height - 1 - y : y;
        for (int x = 0; x < image->width; x++, texel += COMPONENTS)
            if (!read_pixel(&bmp, bmp.bytes + bmp.rows + bmp.stride * (size_t)row, (size_t)x,
                            texel))
                return "a pixel's palette index is out of range";
    }
    return NULL;
}
