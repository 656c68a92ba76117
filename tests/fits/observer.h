/* Weights of wavelengths in the components of linear sRGB: the CIE's observer of 1931, fitted by
 * two-sided Gaussians (Wyman, Sloan and Shirley 2013), and sRGB's matrix. */
#ifndef FITS_OBSERVER_H
#define FITS_OBSERVER_H
#include <math.h>

enum { OBSERVER_FIRST = 380, OBSERVER_LAST = 780 }; /* nanometres */

static inline double observer_lobe(double x, double middle, double below, double above)
{
    const double t = (x - middle) / (x < middle ? below : above);
    return exp(-t * t / 2);
}

/* Color matching functions at a wavelength in nanometers; some are negative. Their sums over all
 * wavelengths are white, about equal for each component. */
static inline void observer_components(double nm, double components[3])
{
    const double x = 1.056 * observer_lobe(nm, 599.8, 37.9, 31) +
                     .362 * observer_lobe(nm, 442, 16, 26.7) -
                     .065 * observer_lobe(nm, 501.1, 20.4, 26.2);
    const double y =
        .821 * observer_lobe(nm, 568.8, 46.9, 40.5) + .286 * observer_lobe(nm, 530.9, 16.3, 31.1);
    const double z =
        1.217 * observer_lobe(nm, 437, 11.8, 36) + .681 * observer_lobe(nm, 459, 26, 13.8);
    components[0] = 3.2404542 * x - 1.5371385 * y - .4985314 * z;
    components[1] = -.969266 * x + 1.8760108 * y + .041556 * z;
    components[2] = .0556434 * x - .2040259 * y + 1.0572252 * z;
}
#endif
