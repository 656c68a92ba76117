#include "tests/fits/solve.h"
#include <math.h>

void solve_equations(double *rows, int count)
{
    const int width = count + 1;
    for (int k = 0; k < count; k++) {
        int pivot = k;
        for (int i = k; i < count; i++)
            pivot = fabs(rows[i * width + k]) > fabs(rows[pivot * width + k]) ? i : pivot;
        for (int l = 0; l < width; l++) {
            const double held = rows[k * width + l];
            rows[k * width + l] = rows[pivot * width + l], rows[pivot * width + l] = held;
        }
        for (int i = 0; i < count; i++) {
            const double by = i == k ? 0 : rows[i * width + k] / rows[k * width + k];
            for (int l = k; l < width && by != 0; l++)
                rows[i * width + l] -= by * rows[k * width + l];
        }
    }
    for (int k = 0; k < count; k++)
        rows[k * width + count] /= rows[k * width + k];
}
