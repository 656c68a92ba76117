// needs: safeNormalize skyAngle
// Preetham's sky in a direction of any length, z up: linear sRGB, no component below 0, black below
// the horizon. The arguments' components are luminance Y and chromaticity x, y, from
// sky_coefficients (lib/sky.h): zenithOverF0 is the zenith's value over F(0, sun angle), Y in W/(m2
// sr) times the desired scale; A to E are Perez' coefficients of F; sun is a unit vector. Relative
// error 8e-6.
vec3 skyRadiance(vec3 direction, vec3 sun, vec3 zenithOverF0, vec3 A, vec3 B, vec3 C, vec3 D, vec3 E) {
    vec3 view = safeNormalize(direction);
    if (view.z < 0.0) return vec3(0.0);
    view = normalize(vec3(view.xy, max(view.z, 0.001)));
    float cosine = dot(view, sun);
    float angle = skyAngle(view, sun, cosine);
    vec3 sky = zenithOverF0 * (1.0 + A * exp(B / view.z)) * (1.0 + C * exp(D * angle) + E * cosine * cosine);
    vec3 XYZ = max(sky.x, 0.0) * vec3(sky.y, sky.z, 1.0 - sky.y - sky.z) / max(sky.z, 0.001);
    vec3 rgb = XYZ.x * vec3(3.2404542, -0.9692660, 0.0556434) + XYZ.y * vec3(-1.5371385, 1.8760108, -0.2040259)
             + XYZ.z * vec3(-0.4985314, 0.0415560, 1.0572252);
    return rgb - min(min(min(rgb.r, rgb.g), rgb.b), 0.0);
}
