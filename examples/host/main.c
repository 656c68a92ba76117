/* host SCENE BEFORE.ppm AFTER.ppm: a scene, then the same with its second object moved to the right
 * and painted otherwise. The context is this program's own, by OSMesa; the renderer only draws with
 * it. */
#include <GL/osmesa.h>
#include <matc_render.h>
#include <stdio.h>
#include <stdlib.h>

static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    char *text = malloc(1 << 20);
    *size = file && text ? fread(text, 1, 1 << 20, file) : 0;
    if (file)
        fclose(file);
    return text;
}

static MatcRendererProc load(void *user, const char *name)
{
    (void)user;
    return OSMesaGetProcAddress(name);
}

static OSMesaContext open_context(void)
{
    static unsigned char window[4]; /* OSMesa wants one; the renderer draws to textures */
    static const int wanted[] = {OSMESA_PROFILE,
                                 OSMESA_CORE_PROFILE,
                                 OSMESA_CONTEXT_MAJOR_VERSION,
                                 4,
                                 OSMESA_CONTEXT_MINOR_VERSION,
                                 5,
                                 0};
    OSMesaContext context = OSMesaCreateContextAttribs(wanted, NULL);
    return context && OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, 1, 1) ? context : NULL;
}

/* Rows of PPM go from the top down. */
static int draw(MatcRenderer *render, const char *path)
{
    const int width = matc_renderer_width(render), height = matc_renderer_height(render);
    float *rgba = malloc((size_t)width * (size_t)height * 4 * sizeof *rgba);
    FILE *file = fopen(path, "wb");
    const int done =
        rgba && file && matc_renderer_frame(render) && matc_renderer_read(render, rgba);
    if (done)
        fprintf(file, "P6 %d %d 255\n", width, height);
    for (int y = height - 1; done && y >= 0; y--)
        for (int i = 0; i < 3 * width; i++)
            fputc((int)(rgba[4 * (y * width + i / 3) + i % 3] * 255 + .5f), file);
    if (file)
        fclose(file);
    free(rgba);
    return done;
}

/* Its matrix is by columns: the last one is where it stands. */
static int change(MatcRenderer *render, const MatcScene *scene)
{
    static const float green[3] = {0.1f, 0.6f, 0.2f};
    double matrix[16];
    matc_scene_matrix(scene, 1, matrix);
    matrix[12] += 2;
    return matc_renderer_set_object(render, 1, matrix) &&
           matc_renderer_set_param(render, 1, "paint", green, 3);
}

int main(int count, char **arguments)
{
    char error[1024] = "";
    size_t size;
    MatcDocument *document;
    if (count != 4 || !open_context())
        return fputs("host SCENE BEFORE.ppm AFTER.ppm, with OSMesa's OpenGL 4.5\n", stderr), 2;
    char *text = read_file(arguments[1], &size);
    MatcScene *scene = matc_scene_read(arguments[1], text, size, NULL, &document);
    MatcRenderer *render =
        scene ? matc_renderer_open(
                    &(MatcRendererOptions){.size = sizeof(MatcRendererOptions), .load = load},
                    error, sizeof error)
              : NULL;
    const int done = render && matc_renderer_set_scene(render, scene) &&
                     draw(render, arguments[2]) && change(render, scene) &&
                     draw(render, arguments[3]);
    if (!done)
        fprintf(stderr, "%s%s%s\n", matc_diagnostics(document, MATC_TEXT), error,
                render ? matc_renderer_error(render) : "");
    matc_renderer_close(render);
    matc_scene_free(scene);
    matc_document_free(document);
    free(text);
    return done ? 0 : 1;
}
