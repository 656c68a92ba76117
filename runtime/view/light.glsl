// The preview's light pass. It stands behind the text that declares Surface and unpackSurface, lights what the G-buffer
// holds by the Phong shading of a ray tracer, and leaves linear display colours in [0, 1]: the view filters and encodes them.
// A layout may lack any slot: SURFACE_HAS_<slot> tells which members there are, and what is not there costs nothing.
uniform sampler2D light_depth;
uniform mat4 light_eyeFromClip;
uniform vec3 light_up;   // the world's up, in eye space
uniform vec2 light_size; // of the picture, in its pixels
out vec4 light_color;

// Directions towards the lights, in eye space, so that every shape is lit alike: warm key, cool fill, rim from behind.
const int LIGHTS = 3;
const vec3 lightDirection[LIGHTS] = vec3[LIGHTS](
    vec3(-.4968, .6211, .6062), vec3(.8729, .0970, .4783), vec3(.3651, .5477, -.7528));
const vec3 lightColor[LIGHTS] = vec3[LIGHTS](
    vec3(1.04, .99, .91), vec3(.17, .21, .27), vec3(.42, .45, .5));

// Light from all around, as brightness of a diffuse surface that faces up or down.
const vec3 SKY = vec3(.175, .185, .205);
const vec3 GROUND = vec3(.062, .057, .053);

// A lamp is not a point: its disc keeps the sharpest highlight some pixels wide.
const float SHARPEST = 3000.;

vec3 ambient(vec3 direction)
{
    return mix(GROUND, SKY, .5 + .5 * dot(direction, light_up));
}

// What a mirror shows of the same room: its horizon is sharper than what a diffuse surface gathers.
vec3 mirrored(vec3 direction)
{
    return mix(.6 * GROUND, SKY, smoothstep(-.3, .5, dot(direction, light_up)));
}

// A surface as the light pass wants it: what the layout lacks is as slots.def says of absent slots.
struct Lit {
    vec3 normal, kd, ks, through, behind, ambient, emissive;
    float shininess;
};

Lit material(Surface s)
{
    Lit m = Lit(vec3(0., 0., 1.), vec3(0.), vec3(0.), vec3(0.), vec3(0.), vec3(0.), vec3(0.), 4.);
#ifdef SURFACE_HAS_normal
    m.normal = s.normal;
#endif
#ifdef SURFACE_HAS_diffuse
    m.kd = s.diffuse;
#endif
#ifdef SURFACE_HAS_specular
    m.ks = s.specular;
#endif
#ifdef SURFACE_HAS_shininess
    m.shininess = min(s.shininess, SHARPEST);
#endif
#ifdef SURFACE_HAS_transparency
    m.through = clamp(s.transparency, 0., 1.);
    vec3 kept = 1. - s.transparency;
#ifdef SURFACE_HAS_interpolatedTransparency
    kept = mix(vec3(1.), kept, s.interpolatedTransparency);
#endif
    m.kd *= kept;
    m.ks *= kept;
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

// (k_d + k_s max(R.l, 0)^n) |n.l| L in front of the surface, |n.l| k L behind it. What comes straight through from behind
// is the background.
vec3 lit(Lit m, vec3 reflected, int i)
{
    float cosine = dot(m.normal, lightDirection[i]);
    if (cosine <= 0.) return -cosine * m.behind * lightColor[i];
    float lobe = max(dot(reflected, lightDirection[i]), 1e-6); // pow(0., 0.) is undefined
    return (m.kd + m.ks * pow(lobe, m.shininess)) * cosine * lightColor[i];
}

// Light from all around meets the diffuse colour, the ambient one, and what lets it through from behind.
vec3 shade(Lit m, vec3 toEye)
{
    vec3 reflected = reflect(-toEye, m.normal);
    vec3 sum = m.emissive + (m.kd + m.ambient) * ambient(m.normal) + m.behind * ambient(-m.normal);
    sum += m.ks * mirrored(reflected); // without anything to mirror, a metal would be black
    for (int i = 0; i < LIGHTS; i++) sum += lit(m, reflected, i);
    return sum;
}

// Neutral grey, lighter behind the object.
vec3 backdrop(vec2 p)
{
    float glow = exp(-1.6 * dot(p - vec2(0., .1), p - vec2(0., .1)));
    return mix(vec3(.034, .036, .040), vec3(.150, .155, .165), glow);
}

// What shows through a transparent surface.
vec3 checker(vec2 p)
{
    vec2 cell = floor(p * 10.);
    return vec3(mod(cell.x + cell.y, 2.) < .5 ? .22 : .36);
}

// Straight up to the knee, then bent so that nothing clips.
vec3 tone(vec3 c)
{
    const float knee = .7;
    vec3 over = max(c - knee, 0.) / (1. - knee);
    return min(c, knee) + (1. - knee) * over / (1. + over);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 p = (2. * gl_FragCoord.xy - light_size) / min(light_size.x, light_size.y);
    float depth = texelFetch(light_depth, pixel, 0).x;
    light_color = vec4(backdrop(p), 1.);
    if (depth >= 1.) return; // nothing was drawn here

    vec4 eye = light_eyeFromClip * vec4(2. * gl_FragCoord.xy / light_size - 1., 2. * depth - 1., 1.);
    Lit m = material(unpackSurface(pixel));
    vec2 bent = p - .18 * (1. - m.normal.z) * m.normal.xy; // no refraction, a hint of form
    vec3 color = shade(m, -normalize(eye.xyz / eye.w)) + m.through * checker(bent);
    light_color.rgb = tone(max(color, 0.));
}
