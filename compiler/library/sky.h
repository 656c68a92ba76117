/* Coefficients of skyRadiance. */
#ifndef MATC_SKY_H
#define MATC_SKY_H

/* Rows of out, components Y, x, y of the first six: zenith over F(0, angle of the sun); Perez' A,
 * B, C, D, E; the unit vector to the sun. The zenith's Y is in W/(m2 sr), times radiance_factor,
 * times 10 / (total irradiance of sky and sun), which is how the sky looks as a material. Turbidity
 * is taken to [1.7, 64]: below, F has a zero where the model divides by it. */
void sky_coefficients(const double sun[3], double turbidity, double radiance_factor,
                      double out[7][3]);

/* Irradiance by the sun's disc on a surface that faces it, as linear red, green and blue, on the
 * scale of the coefficients: on the horizontal plane, sky and this times the sun's z together give
 * 10 times radiance_factor, on the mean of the components. 0 below the horizon. */
void sky_sun(const double sun[3], double turbidity, double radiance_factor, double irradiance[3]);
#endif
