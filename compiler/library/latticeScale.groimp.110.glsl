// needs:
// GroIMP's table needs no scale.
const float latticeScale = 1.0;
