// needs:
// Measured: mean and variance of noise, mean of |noise|, and its frequency relative to lattice
// noise.
const float noiseMean = -0.0206;
const float noiseVariance = 0.25;
const float noiseMagnitude = 0.412;
const float noiseGrain = 1.0;
