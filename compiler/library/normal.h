/* Unit normals as two whole numbers in [0, levels): the references of the encodings, in double
 * precision. 2^b levels are b bits; 2^b - 1 are b bits that hold the axes exactly ("snorm"), which
 * is what matc packs. */
#ifndef MATC_LIB_NORMAL_H
#define MATC_LIB_NORMAL_H

/* Levels of an octahedral code of b bits. */
static inline int octahedral_levels(int bits) { return (1 << bits) - 1; }

/* The octahedral map to [-1, 1]^2 and back; (0, 0, 0) is +z. */
void normal_octahedral_map(const double n[3], double e[2]);
void normal_octahedral_unmap(const double e[2], double n[3]);
void normal_octahedral_encode(const double n[3], int levels, int code[2]);
/* The best of the four codes around: "precise". */
void normal_octahedral_encode_precise(const double n[3], int levels, int code[2]);
void normal_octahedral_decode(const int code[2], int levels, double n[3]);

/* The thesis' spheremap, to [0, 1]^2 and back. */
void normal_spheremap_map(const double n[3], double e[2]);
void normal_spheremap_unmap(const double e[2], double n[3]);
void normal_spheremap_encode(const double n[3], int levels, int code[2]);
void normal_spheremap_decode(const int code[2], int levels, double n[3]);

/* Degrees between two directions, exact for small angles. */
double normal_angle(const double a[3], const double b[3]);
#endif
