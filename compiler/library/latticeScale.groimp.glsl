// needs:
// GroIMP's numbers are what they are.
const float latticeScale = 1.0;
