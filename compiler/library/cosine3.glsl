// needs:
// Cosine by lane. As accurate as the cosine.
vec3 cosine3(vec3 x) {
    return cos(x);
}
