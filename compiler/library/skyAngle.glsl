// needs:
// Angle between two unit vectors in [0, pi], given its cosine. atan, since acos is imprecise near
// 0.
float skyAngle(vec3 view, vec3 sun, float cosine) {
    return atan(length(cross(view, sun)), cosine);
}
