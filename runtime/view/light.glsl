// The preview's light pass. It stands behind the texts that declare Surface and unpackSurface, and the surface model Phong; it lights what the
// G-buffer holds, and leaves linear display colours in [0, 1]: the view filters and encodes them.
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

// Light from all around meets the diffuse colour, the ambient one, and what lets it through from behind.
vec3 shade(Lit m)
{
    vec3 sum = surfaceOwn(m, ambient(m.normal)) + m.diffuse * ambient(m.normal) + m.behind * ambient(-m.normal);
    sum += m.specular * mirrored(m.reflected); // without anything to mirror, a metal would be black
    for (int i = 0; i < LIGHTS; i++) sum += lightColor[i] * surfaceLobe(m, lightDirection[i]);
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
    Lit m = surfaceLit(unpackSurface(pixel), -normalize(eye.xyz / eye.w));
    vec3 behind = clamp(m.through, 0., 1.) * checker(p - .18 * (1. - m.normal.z) * m.normal.xy); // no refraction, a hint of form
    m.through = vec3(0.); // what comes straight through is the background alone
    m.shininess = min(m.shininess, SHARPEST);
    vec3 color = shade(m) + behind;
    light_color.rgb = tone(max(color, 0.));
}
