/* Unit normals as two integers in [0, levels): references of the encodings, in double precision.
 * 2^b levels use b bits; 2^b - 1 levels also use b bits but hold the axes exactly ("snorm"),
 * which is what matc packs. */
#ifndef MATC_LIB_NORMAL_H
#define MATC_LIB_NORMAL_H

/* Returns the levels of an octahedral code of b bits. */
static inline int octahedral_levels(int bits) { return (1 << bits) - 1; }

/* The octahedral map to [-1, 1]^2 and its inverse; (0, 0, 0) maps like +z. */
void normal_octahedral_map(const double n[3], double e[2]);
void normal_octahedral_unmap(const double e[2], double n[3]);
void normal_octahedral_encode(const double n[3], int levels, int code[2]);
/* Returns the most accurate of the four adjacent codes ("precise"). */
void normal_octahedral_encode_precise(const double n[3], int levels, int code[2]);
void normal_octahedral_decode(const int code[2], int levels, double n[3]);

/* The spheremap of the thesis, to [0, 1]^2, and its inverse. */
void normal_spheremap_map(const double n[3], double e[2]);
void normal_spheremap_unmap(const double e[2], double n[3]);
void normal_spheremap_encode(const double n[3], int levels, int code[2]);
void normal_spheremap_decode(const int code[2], int levels, double n[3]);

/* Returns the angle between two directions in degrees, accurate for small angles. */
double normal_angle(const double a[3], const double b[3]);
#endif
