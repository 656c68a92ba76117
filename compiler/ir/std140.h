/* The std140 layout of uniform blocks. Example: float, vec3, float have the offsets 0, 16, 28,
 * and the block has 32 bytes. */
#ifndef MATC_STD140_H
#define MATC_STD140_H

/* Returns the offset of a member of a GLSL type in a std140 block of *size bytes, and adds the
 * member to *size. */
int std140_offset(const char *type, int *size);
/* Returns the size of a block whose last member ends at `end`: rounded up to whole vec4s, as
 * drivers require of buffers. */
int std140_size(int end);
#endif
