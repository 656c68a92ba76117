/* Box filter and sRGB encoding. The mean is taken of linear values: of encoded ones, edges would come out too dark. */
#include "runtime/view/pixels.h"
#include <math.h>

unsigned char pixels_encode(double linear)
{
    if (!(linear > 0))
        return 0; /* NaN too, which no byte can hold */
    if (linear >= 1)
        return 255;
    double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
    return (unsigned char)(encoded * 255 + 0.5);
}

static double mean(const float *samples, int stride, int n)
{
    double sum = 0;
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++)
            sum += samples[row * stride + column * 4];
    return sum / (n * n);
}

static unsigned char to_byte(double value) { return (unsigned char)(value > 0 ? fmin(value, 1) * 255 + 0.5 : 0); }

void pixels_row(const float *samples, int width, int n, bool encoded, unsigned char *rgb)
{
    int stride = width * n * 4;
    for (int x = 0; x < width; x++)
        for (int lane = 0; lane < 3; lane++) {
            double value = mean(samples + x * n * 4 + lane, stride, n);
            rgb[3 * x + lane] = encoded ? pixels_encode(value) : to_byte(value);
        }
}
