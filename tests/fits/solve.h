/* Linear equations, for fits. */
#ifndef FITS_SOLVE_H
#define FITS_SOLVE_H
/* Of `count` rows of count + 1 numbers, the last of a row its right side, by Gauss and Jordan; the
 * solution is in the right sides then. */
void solve_equations(double *rows, int count);
#endif
