// needs:
// Measured: mean and variance of noise, mean of |noise|, and its frequency relative to lattice
// noise.
const float noiseMean = 0.0;
const float noiseVariance = 0.232;
const float noiseMagnitude = 0.382;
const float noiseGrain = 2.06;
