/* The hyperbolic waves. Their limits keep results finite in float. */
#include "compiler/library/reference.h"

REFERENCE(waveCosh)
{
    (void)context;
    result[0] = cosh(clamp(args[0], -WAVE_EXP_LIMIT, WAVE_EXP_LIMIT));
}

REFERENCE(waveSinh)
{
    (void)context;
    result[0] = sinh(clamp(args[0], -WAVE_EXP_LIMIT, WAVE_EXP_LIMIT));
}

REFERENCE(waveTanh)
{
    (void)context;
    result[0] = tanh(args[0]);
}

REFERENCE(waveExpm1)
{
    (void)context;
    result[0] = expm1(fmin(args[0], WAVE_EXP_LIMIT));
}

REFERENCE(waveTanhSlope)
{
    (void)context;
    double c = cosh(clamp(args[0], -WAVE_EXP_LIMIT, WAVE_EXP_LIMIT));
    result[0] = 1 / (c * c);
}

REFERENCE(waveExp)
{
    (void)context;
    result[0] = exp(fmin(args[0], WAVE_EXP_LIMIT));
}
