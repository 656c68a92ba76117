/* The renderer in a program of your own: moves the object "ball" of SCENE, and writes eight frames.
 *     cc draw.c $(pkg-config --cflags --libs matc_render osmesa) -o draw && ./draw scene.yaml */
#include <GL/osmesa.h>
#include <matc_render.h>
#include <stdio.h>
#include <stdlib.h>

static MatcRendererProc load(void *user, const char *name)
{
    (void)user;
    return OSMesaGetProcAddress(name);
}

/* Rows of the renderer go up, those of a PPM file go down. */
static void write_picture(MatcRenderer *renderer, int frame)
{
    const int width = matc_renderer_width(renderer), height = matc_renderer_height(renderer);
    float *rgba = malloc((size_t)width * (size_t)height * 4 * sizeof *rgba);
    char path[32];
    snprintf(path, sizeof path, "frame%d.ppm", frame);
    FILE *file = fopen(path, "wb");
    if (rgba && file && matc_renderer_read(renderer, rgba)) {
        fprintf(file, "P6 %d %d 255\n", width, height);
        for (int y = height - 1; y >= 0; y--)
            for (int i = 0; i < 3 * width; i++)
                fputc((int)(rgba[4 * (y * width + i / 3) + i % 3] * 255 + .5f), file);
    }
    if (file)
        fclose(file);
    free(rgba);
}

int main(int count, char **arguments)
{
    static const int core[] = {OSMESA_PROFILE, OSMESA_CORE_PROFILE, 0};
    static char window[4], text[1 << 16], error[1024];
    FILE *file = count == 2 ? fopen(arguments[1], "rb") : NULL;
    const OSMesaContext context = OSMesaCreateContextAttribs(core, NULL);
    if (!file || !OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, 1, 1))
        return fputs("usage: draw SCENE\n", stderr), 2;
    const size_t size = fread(text, 1, sizeof text, file);
    MatcDocument *document;
    MatcScene *scene = matc_scene_read(arguments[1], text, size, NULL, &document);
    MatcRendererOptions options = {.size = sizeof options, .load = load};
    MatcRenderer *renderer = scene ? matc_renderer_open(&options, error, sizeof error) : NULL;
    bool drawn = renderer && matc_renderer_set_scene(renderer, scene);
    const int ball = drawn ? matc_scene_find_object(scene, "ball", -1) : -1;
    for (int frame = 0; drawn && frame < 8; frame++) {
        double matrix[16]; /* by columns: the fourth is the position */
        matc_scene_matrix(scene, ball, matrix);
        matrix[12] += 0.1;
        drawn = matc_renderer_set_object(renderer, ball, matrix) && matc_renderer_frame(renderer);
        write_picture(renderer, frame);
    }
    fprintf(stderr, "%s%s%s", matc_diagnostics(document, MATC_TEXT), error,
            renderer ? matc_renderer_error(renderer) : "");
    return drawn ? 0 : 1;
}
