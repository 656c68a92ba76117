// needs:
// A world direction in eye space; the matrix is a rotation, so that lengths and angles stay.
uniform mat3 matc_eyeFromWorld;
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
}
