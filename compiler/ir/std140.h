/* The std140 layout of uniform blocks. Worked example: float, vec3, float lie at 0, 16, 28, and the
 * block has 32 bytes. */
#ifndef MATC_STD140_H
#define MATC_STD140_H

/* Offset of a member of that GLSL type in a std140 block that is `size` bytes so far, which
 * grows. */
int std140_offset(const char *type, int *size);
/* Bytes of a block whose last member ends there: whole vectors, as drivers want a buffer to
 * have. */
int std140_size(int end);
#endif
