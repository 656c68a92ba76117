/* Functions shared by the readers of all image formats. */
#include "compiler/images/image_file.h"

const char image_file_cut[] = "the file is truncated",
           image_file_too_large[] = "the image is too large",
           image_file_too_many[] = "the images of the document are too large in total";

const char *image_file_check_side(double width, double height)
{
    if (width < 1 || height < 1)
        return "the image has no pixels";
    return width > LIMIT_IMAGE_SIDE || height > LIMIT_IMAGE_SIDE ? image_file_too_large : NULL;
}

size_t image_file_size(const Image *image)
{
    return (size_t)image->width * (size_t)image->height * 4 * (size_t)(image->bits / 8);
}

const char *image_file_allocate(ImageFile *file)
{
    Image *image = file->image;
    if (image_file_size(image) > file->capacity)
        return image_file_too_many;
    image->texels = arena_alloc(&file->memory, image_file_size(image));
    return NULL;
}
