/* Coefficients of the library function skyRadiance(). */
#ifndef MATC_SKY_H
#define MATC_SKY_H

/* Fills the rows of out. Components Y, x, y of the first six rows: zenith over F(0, sun angle);
 * Perez' A, B, C, D, E. Row 6 is the unit vector to the sun. The zenith's Y is in W/(m2 sr),
 * times radiance_factor, times 10 / (total irradiance of sky and sun), the scale of the sky as a
 * material. Turbidity is clamped to [1.7, 64]: below 1.7, F has a zero where the model divides
 * by F. */
void sky_coefficients(const double sun[3], double turbidity, double radiance_factor,
                      double out[7][3]);

/* Irradiance of the sun's disc on a surface that faces the sun, in linear RGB, on the scale of
 * the coefficients: on the horizontal plane the sky plus this irradiance times the sun's z is 10
 * times radiance_factor, averaged over the components. 0 below the horizon. */
void sky_sun(const double sun[3], double turbidity, double radiance_factor, double irradiance[3]);
#endif
