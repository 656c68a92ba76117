// needs: cosineBounded
// Cosine by lane. Error 1.5e-7 for |x| up to 1e5, whatever the driver.
vec3 cosine3(vec3 x) {
    return vec3(cosineBounded(x.x), cosineBounded(x.y), cosineBounded(x.z));
}
