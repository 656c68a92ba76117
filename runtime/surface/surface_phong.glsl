// The surface model Phong (semantics.md 4.1), with the functions of surface_model.h: reflection of
// a point with these slots toward the eye. Slots that a layout lacks have the absent values of
// slots.def, and cost nothing.
struct Lit {
    vec3 normal, reflected, diffuse, specular, through, behind, ambient, emissive;
    float shininess, straightness;
};

Lit surfaceLit(Surface s, vec3 toEye)
{
    const vec3 NONE = vec3(0.0);
    Lit m = Lit(vec3(0.0, 0.0, 1.0), NONE, NONE, NONE, NONE, NONE, NONE, NONE, 4.0, 65504.0);
#ifdef SURFACE_HAS_normal
    m.normal = s.normal;
#endif
    m.reflected = reflect(-toEye, m.normal);
#ifdef SURFACE_HAS_diffuse
    m.diffuse = s.diffuse;
#endif
#ifdef SURFACE_HAS_specular
    m.specular = s.specular;
#endif
#ifdef SURFACE_HAS_shininess
    m.shininess = s.shininess;
#endif
#ifdef SURFACE_HAS_transparency
    m.through = s.transparency;
    vec3 kept = 1.0 - s.transparency;
#ifdef SURFACE_HAS_interpolatedTransparency
    kept = mix(vec3(1.0), kept, s.interpolatedTransparency);
#endif
    m.diffuse *= kept;
    m.specular *= kept;
#endif
#ifdef SURFACE_HAS_transparencyShininess
    m.straightness = s.transparencyShininess;
#endif
#ifdef SURFACE_HAS_diffuseTransparency
    m.behind = s.diffuseTransparency;
#endif
#ifdef SURFACE_HAS_ambient
    m.ambient = s.ambient;
#endif
#ifdef SURFACE_HAS_emissive
    m.emissive = s.emissive;
#endif
    return m;
}

vec3 surfaceOwn(Lit m) { return m.emissive; }
vec3 surfaceAmbient(Lit m, vec3 ambient) { return m.ambient * ambient; }

bool surfaceLetsThrough(Lit m) { return any(greaterThan(m.behind + m.through, vec3(0.0))); }
vec3 surfaceEven(Lit m) { return m.diffuse; }
Lit surfaceMatt(Lit m)
{
    m.specular = m.through = vec3(0.0);
    return m;
}

vec3 surfaceSpecular(Lit m) { return m.specular; }
vec3 surfaceMirror(Lit m) { return m.reflected; }
float surfaceExponent(Lit m) { return m.shininess; }

// Returns the share of light from direction l that reaches the eye, including the cosine. Light
// that is transmitted straight has no cosine factor.
vec3 surfaceLobe(Lit m, vec3 l)
{
    float cosine = dot(m.normal, l);
    if (cosine <= 0.0) {
        vec3 sum = -cosine * m.behind;
#ifdef SURFACE_HAS_transparency
        sum += m.through * pow(max(dot(reflect(m.reflected, m.normal), l), 1e-30), m.straightness);
#endif
        return sum;
    }
    vec3 sum = m.diffuse;
#ifdef SURFACE_HAS_specular
    float along = max(dot(m.reflected, l), 1e-30); // avoids pow(0.0, 0.0), which is undefined
    sum += m.specular * pow(along, m.shininess);
#endif
    return cosine * sum;
}

#ifdef LIGHT_HAS_SKY
vec3 surfaceSky(Lit m)
{
    vec3 sum = m.diffuse * skyIrradiance(m.normal);
    if (any(greaterThan(m.specular, vec3(0.0))))
        sum += m.specular * skyLobe(m.normal, m.reflected, m.shininess);
    if (any(greaterThan(m.behind, vec3(0.0)))) sum += m.behind * skyIrradiance(-m.normal);
    return sum;
}
#endif

#ifdef LIGHT_HAS_HEMISPHERE
vec3 surfaceHemisphere(Lit m)
{
    return (m.diffuse + m.ambient) * hemisphereMatt(m.normal) +
        m.specular * hemisphereMirrored(m.reflected) +
           m.behind * hemisphereMatt(-m.normal);
}
#endif

#ifdef LIGHT_HAS_AREAS
// Returns the number of sides. Transmitted light belongs to the other side: one power of the lobe
// is the cosine that the integral includes.
int surfaceAreaSides(Lit m) { return surfaceLetsThrough(m) ? 2 : 1; }
AreaSide surfaceAreaSide(Lit m, int i)
{
    if (i == 0)
        return areaPowers(m.normal, m.diffuse, m.specular, m.reflected, m.normal, m.shininess);
    vec3 on = reflect(m.reflected, m.normal);
    return areaPowers(-m.normal, m.behind, m.through, on, on, max(m.straightness - 1.0, 0.0));
}

vec3 surfaceArea(Lit m, Area light)
{
    vec3 sum = vec3(0.0);
    int sides = surfaceAreaSides(m);
    for (int i = 0; i < sides; i++) sum += areaOfSide(light, surfaceAreaSide(m, i));
    return sum;
}
#endif
