// needs:
// Component-wise cosine. Error of cos().
vec3 cosine3(vec3 x) {
    return cos(x);
}
