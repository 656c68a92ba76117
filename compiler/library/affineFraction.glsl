// needs: affineSum
// M root + offset minus affineWhole, in [-1/2, 1/2]. Error 3e-8, relative near 0.
vec3 affineFraction(vec3 root, vec3 a0, vec3 b0, vec3 c0, vec3 a1, vec3 b1, vec3 c1, vec3 a2, vec3 b2, vec3 c2,
                    vec3 a3, vec3 b3, vec3 c3) {
    vec3 whole, fraction;
    affineSum(root, a0, b0, c0, a1, b1, c1, a2, b2, c2, a3, b3, c3, whole, fraction);
    return fraction;
}
