// needs: latticeCorners latticeNext latticeRise latticeScale
// Derivative of vectorNoise(cell, d) along a direction.
vec3 vectorNoiseAlong(vec3 cell, vec3 d, vec3 direction) {
    vec3 sum;
    vec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = dot(latticeRise(low, high, d).xyz, direction);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.y = dot(latticeRise(low, high, d).xyz, direction);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.z = dot(latticeRise(low, high, d).xyz, direction);
    return sum * latticeScale;
}
