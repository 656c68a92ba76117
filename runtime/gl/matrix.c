/* Products, inverses and camera matrices, summed in double. */
#include "runtime/gl/matrix.h"
#include <math.h>

Mat4 mat4_identity(void) { return (Mat4){{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}; }

static void multiply(int n, const float *a, const float *b, float *result)
{
    for (int column = 0; column < n; column++) {
        for (int row = 0; row < n; row++) {
            double sum = 0;
            for (int k = 0; k < n; k++)
                sum += (double)a[n * k + row] * b[n * column + k];
            result[n * column + row] = (float)sum;
        }
    }
}

Mat4 mat4_multiply(const Mat4 *a, const Mat4 *b)
{
    Mat4 result;
    multiply(4, a->m, b->m, result.m);
    return result;
}

Mat3 mat3_multiply(const Mat3 *a, const Mat3 *b)
{
    Mat3 result;
    multiply(3, a->m, b->m, result.m);
    return result;
}

Mat4 mat4_perspective(float height, float aspect, float near, float far)
{
    Mat4 result = {{0}};
    result.m[0] = 1 / (height * aspect);
    result.m[5] = 1 / height;
    result.m[10] = (far + near) / (near - far);
    result.m[11] = -1;
    result.m[14] = 2 * far * near / (near - far);
    return result;
}

static void cross(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(double a[3])
{
    double length = sqrt(dot(a, a));
    for (int i = 0; length > 0 && i < 3; i++)
        a[i] /= length;
}

Mat4 mat4_look_at(const float eye[3], const float target[3], const float up[3])
{
    double x[3], y[3] = {up[0], up[1], up[2]}, from[3] = {eye[0], eye[1], eye[2]};
    double z[3] = {from[0] - target[0], from[1] - target[1], from[2] - target[2]};
    normalize(z);
    cross(y, z, x);
    normalize(x);
    cross(z, x, y);
    const double *axes[3] = {x, y, z};
    Mat4 result = mat4_identity();
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            result.m[4 * column + row] = (float)axes[row][column];
        result.m[12 + row] = (float)-dot(axes[row], from);
    }
    return result;
}

/* Swaps two rows of [a | inverse], to select the largest pivot. */
static void swap_rows(double rows[4][8], int first, int second)
{
    for (int i = 0; i < 8; i++) {
        double kept = rows[first][i];
        rows[first][i] = rows[second][i];
        rows[second][i] = kept;
    }
}

/* Performs one step of Gauss-Jordan elimination: the column becomes that of the identity. */
static bool eliminate(double rows[4][8], int column)
{
    int best = column;
    for (int row = column + 1; row < 4; row++)
        if (fabs(rows[row][column]) > fabs(rows[best][column]))
            best = row;
    double pivot = rows[best][column];
    if (!(fabs(pivot) > 0))
        return false; /* the matrix is singular, or has a NaN */
    swap_rows(rows, column, best);
    for (int i = 0; i < 8; i++)
        rows[column][i] /= pivot;
    for (int row = 0; row < 4; row++) {
        double factor = rows[row][column];
        for (int i = 0; row != column && i < 8; i++)
            rows[row][i] -= factor * rows[column][i];
    }
    return true;
}

bool mat4_inverse(const Mat4 *a, Mat4 *inverse)
{
    double rows[4][8] = {{0}};
    for (int row = 0; row < 4; row++) {
        for (int column = 0; column < 4; column++)
            rows[row][column] = a->m[4 * column + row];
        rows[row][4 + row] = 1;
    }
    for (int column = 0; column < 4; column++)
        if (!eliminate(rows, column))
            return false;
    for (int i = 0; i < 16; i++)
        inverse->m[i] = (float)rows[i % 4][4 + i / 4];
    return true;
}

Mat3 mat3_from_mat4(const Mat4 *a)
{
    Mat3 result;
    for (int i = 0; i < 9; i++)
        result.m[i] = a->m[4 * (i / 3) + i % 3];
    return result;
}

/* The cofactor matrix is the inverse transpose times the determinant, whose sign is removed for
 * mirrored matrices. */
Mat3 mat3_normal(const Mat4 *a)
{
    double columns[3][3], cofactors[3][3];
    for (int i = 0; i < 9; i++)
        columns[i / 3][i % 3] = a->m[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; i++)
        cross(columns[(i + 1) % 3], columns[(i + 2) % 3], cofactors[i]);
    double sign = dot(columns[0], cofactors[0]) < 0 ? -1 : 1;
    Mat3 result;
    for (int i = 0; i < 9; i++)
        result.m[i] = (float)(sign * cofactors[i / 3][i % 3]);
    return result;
}
