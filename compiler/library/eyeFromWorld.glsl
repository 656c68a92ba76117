// needs:
// Transforms a direction from world to eye space. The matrix is a rotation: lengths and angles are
// kept.
uniform mat3 matc_eyeFromWorld;
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
}
