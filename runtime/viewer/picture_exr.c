/* Writes OpenEXR files of halves or floats through the library's C core: scan lines in
 * ZIP-compressed blocks of 16. */
#include "runtime/viewer/picture_file.h"
#include "compiler/base/memory.h"
#include "compiler/base/text.h"
#include <OpenEXR/openexr.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    PictureSpec spec;
    FILE *out;
    exr_context_t exr;
    float *rows; /* rows of the current block, four floats per pixel */
    int block;   /* rows per block */
    int held;    /* rows buffered for the current block */
    int done;    /* number of rows written */
} ExrWriter;

static const char *fault(exr_result_t code)
{
    return code == EXR_ERR_SUCCESS ? NULL : exr_get_default_error_message(code);
}

static int64_t write_at(exr_const_context_t exr, void *user, const void *bytes, uint64_t size,
                        uint64_t offset, exr_stream_error_func_ptr_t fail)
{
    FILE *out = ((ExrWriter *)user)->out;
    if (!fseeko(out, (off_t)offset, SEEK_SET) && fwrite(bytes, 1, size, out) == size)
        return (int64_t)size;
    fail(exr, EXR_ERR_WRITE_IO, "%s", text_error(errno));
    return -1;
}

/* Silences the library: errors are also returned as codes. */
static void on_error(exr_const_context_t exr, exr_result_t code, const char *message)
{
    (void)exr, (void)code, (void)message;
}

/* Adds the channels; the library sorts them by name. */
static exr_result_t add_channels(ExrWriter *w)
{
    static const char *const names[] = {[1] = "Y", [3] = "RGB", [4] = "RGBA"};
    const exr_pixel_type_t type = w->spec.bits == 16 ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
    exr_result_t code = EXR_ERR_SUCCESS;
    for (const char *name = names[w->spec.components]; *name && code == EXR_ERR_SUCCESS; name++)
        code = exr_add_channel(
            w->exr, 0, (char[]){*name, 0}, type,
            w->spec.color ? EXR_PERCEPTUALLY_LOGARITHMIC : EXR_PERCEPTUALLY_LINEAR, 1, 1);
    return code;
}

static exr_result_t write_head(ExrWriter *w)
{
    int part;
    int32_t block = 0;
    exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
    init.error_handler_fn = on_error;
    init.user_data = w;
    init.write_fn = write_at;
    exr_result_t code = exr_start_write(&w->exr, "picture", EXR_WRITE_FILE_DIRECTLY, &init);
    if (code == EXR_ERR_SUCCESS)
        code = exr_add_part(w->exr, "picture", EXR_STORAGE_SCANLINE, &part);
    if (code == EXR_ERR_SUCCESS)
        code = exr_initialize_required_attr_simple(w->exr, part, w->spec.width, w->spec.height,
                                                   EXR_COMPRESSION_ZIP);
    if (code == EXR_ERR_SUCCESS)
        code = add_channels(w);
    if (code == EXR_ERR_SUCCESS)
        code = exr_write_header(w->exr);
    if (code == EXR_ERR_SUCCESS)
        code = exr_get_scanlines_per_chunk(w->exr, part, &block);
    w->block = block;
    return code;
}

static void close_exr(void *state)
{
    ExrWriter *w = state;
    exr_finish(&w->exr);
    free(w->rows);
    free(w);
}

static void *open_exr(const PictureSpec *spec, FILE *out, const char **why)
{
    ExrWriter *w = calloc(1, sizeof *w);
    if (!w)
        memory_exhausted();
    w->spec = *spec;
    w->out = out;
    *why = fault(write_head(w));
    w->rows = *why ? NULL : calloc((size_t)spec->width * (size_t)w->block, 4 * sizeof *w->rows);
    if (w->rows)
        return w;
    *why = *why ? *why : "out of memory";
    close_exr(w);
    return NULL;
}

static void set_channel(const ExrWriter *w, exr_coding_channel_info_t *channel)
{
    static const char order[] = "RGBA";
    /* NULL for Y, which is the first component */
    const char *place = strchr(order, *channel->channel_name);
    const float *from = w->rows + (place ? place - order : 0);
    channel->user_data_type = EXR_PIXEL_FLOAT;
    channel->user_bytes_per_element = sizeof(float);
    channel->user_pixel_stride = 4 * (int)sizeof(float);
    channel->user_line_stride = w->spec.width * channel->user_pixel_stride;
    channel->encode_from_ptr = (const uint8_t *)from;
}

static exr_result_t write_block(ExrWriter *w)
{
    exr_chunk_info_t chunk;
    exr_encode_pipeline_t pipe = EXR_ENCODE_PIPELINE_INITIALIZER;
    exr_result_t code = exr_write_scanline_chunk_info(w->exr, 0, w->done, &chunk);
    if (code == EXR_ERR_SUCCESS)
        code = exr_encoding_initialize(w->exr, 0, &chunk, &pipe);
    for (int i = 0; code == EXR_ERR_SUCCESS && i < pipe.channel_count; i++)
        set_channel(w, &pipe.channels[i]);
    if (code == EXR_ERR_SUCCESS)
        code = exr_encoding_choose_default_routines(w->exr, 0, &pipe);
    if (code == EXR_ERR_SUCCESS)
        code = exr_encoding_run(w->exr, 0, &pipe);
    exr_encoding_destroy(w->exr, &pipe);
    w->done += w->held;
    w->held = 0;
    return code;
}

static const char *row_exr(void *state, const float *rgba)
{
    ExrWriter *w = state;
    const size_t floats = (size_t)w->spec.width * 4;
    memcpy(w->rows + (size_t)w->held++ * floats, rgba, floats * sizeof *rgba);
    const bool full = w->held == w->block || w->done + w->held == w->spec.height;
    return full ? fault(write_block(w)) : NULL;
}

/* Completes the file; the library writes the block offset table last. */
static const char *finish_exr(void *state) { return fault(exr_finish(&((ExrWriter *)state)->exr)); }

const PictureWriter picture_exr = {open_exr, row_exr, finish_exr, close_exr};
