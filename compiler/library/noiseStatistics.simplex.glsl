// needs:
// Of noise, measured: its mean and variance, the mean of its magnitude, and how much finer its grain is than that of lattice noise.
const float noiseMean = 0.0;
const float noiseVariance = 0.232;
const float noiseMagnitude = 0.382;
const float noiseGrain = 2.06;
