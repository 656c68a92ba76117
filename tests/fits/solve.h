/* Solver of linear equations for fits. */
#ifndef FITS_SOLVE_H
#define FITS_SOLVE_H
/* Solves `count` equations, rows of count + 1 numbers whose last is the right side, by Gauss and
 * Jordan; the solution replaces the right sides. */
void solve_equations(double *rows, int count);
#endif
