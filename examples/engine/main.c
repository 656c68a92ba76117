/* Draws every material of a manifest: engine [PICTURE.png [MANIFEST.json]]. */
#include "scene.h"
#include <png.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    int width, height;
    const char *path = argc > 1 ? argv[1] : "engine.png";
    Manifest manifest = manifest_read(argc > 2 ? argv[2] : MANIFEST);
    char *light = read_text(LIGHT);
    gl_open();
    unsigned char *pixels = scene_draw(&manifest, light, &width, &height);
    png_image image = {
        .version = PNG_IMAGE_VERSION, .width = (png_uint_32)width, .height = (png_uint_32)height};
    image.format = PNG_FORMAT_RGBA;
    if (!png_image_write_to_file(&image, path, 0, pixels, -(int)PNG_IMAGE_ROW_STRIDE(image), NULL))
        fail(path, image.message);
    printf("%d materials, %d programs, layout %s: %d bytes a pixel\n", manifest.material_count,
           manifest.program_count, manifest.layout, manifest.bytes);
    free(pixels);
    free(light);
    return 0;
}
