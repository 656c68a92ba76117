// Both surface models in one G-buffer: the slot `model` selects the pixel's model. Follows the
// texts of both, whose names have the prefixes phong and principled (surface_model.c).
#undef Lit
#undef surfaceLit
#undef surfaceOwn
#undef surfaceAmbient
#undef surfaceEven
#undef surfaceLobe
#undef surfaceSky
#undef surfaceArea
#undef surfaceHemisphere
#undef surfaceMatt
#undef surfaceAreaSides
#undef surfaceAreaSide
struct Lit {
    vec3 normal;
    bool principled;
    phongLit phong;
    principledLit other;
};

Lit surfaceLit(Surface s, vec3 toEye)
{
    Lit m;
    m.principled = s.model > 0.5;
    if (m.principled) m.other = principledSurfaceLit(s, toEye);
    else m.phong = phongSurfaceLit(s, toEye);
    m.normal = m.principled ? m.other.normal : m.phong.normal;
    return m;
}

vec3 surfaceOwn(Lit m) { return m.principled ? m.other.emissive : m.phong.emissive; }

vec3 surfaceAmbient(Lit m, vec3 ambient)
{
    if (m.principled) return principledAmbient(m.other, ambient);
    return phongAmbient(m.phong, ambient);
}

vec3 surfaceEven(Lit m)
{
    if (m.principled) return principledEven(m.other);
    return phongEven(m.phong);
}

Lit surfaceMatt(Lit m)
{
    if (m.principled) m.other = principledMatt(m.other);
    else m.phong = phongMatt(m.phong);
    return m;
}

vec3 surfaceLobe(Lit m, vec3 l)
{
    if (m.principled) return principledLobe(m.other, l);
    return phongLobe(m.phong, l);
}

#ifdef LIGHT_HAS_SKY
vec3 surfaceSky(Lit m)
{
    if (m.principled) return principledSky(m.other);
    return phongSky(m.phong);
}
#endif

#ifdef LIGHT_HAS_HEMISPHERE
vec3 surfaceHemisphere(Lit m)
{
    if (m.principled) return principledHemisphere(m.other);
    return phongHemisphere(m.phong);
}
#endif

#ifdef LIGHT_HAS_AREAS
vec3 surfaceArea(Lit m, Area light)
{
    vec3 sum = vec3(0.0);
    int sides = m.principled ? principledAreaSides(m.other) : phongAreaSides(m.phong);
    for (int i = 0; i < sides; i++) {
        AreaSide side;
        if (m.principled) side = principledAreaSide(m.other, i);
        else side = phongAreaSide(m.phong, i);
        sum += areaOfSide(light, side);
    }
    return sum;
}
#endif
