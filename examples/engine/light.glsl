// The light pass. It stands behind the code that matc wrote for the layout, struct Surface and
// unpackSurface(), and behind the lobe that is installed with matc: struct Lit, surfaceLit() and
// what it gives.
uniform sampler2D depthBuffer;
uniform float cell; // edge of a sphere's square in samples
out vec4 color;     // linear; the render target encodes it

const vec3 TO_EYE = vec3(0., 0., 1.); // the camera looks along -z, without perspective
const int LIGHTS = 3;                 // warm key, cool fill, rim from behind
const vec3 direction[LIGHTS] = vec3[LIGHTS](vec3(-.50, .62, .60), vec3(.87, .10, .48), vec3(.37, .55, -.75));
const vec3 power[LIGHTS] = vec3[LIGHTS](vec3(1.05, 1., .92), vec3(.16, .20, .27), vec3(.5, .53, .58));

// What comes from all around: a bright ceiling, a dark floor.
vec3 capacity(vec3 to, float sharp) {
    float up = smoothstep(-sharp, sharp, to.y);
    return mix(vec3(.05, .045, .04), vec3(.20, .21, .23), up);
}

// Grey, lighter behind the sphere, with small squares for what is transparent.
vec3 backdrop(vec2 p) {
    vec3 grey = mix(vec3(.070, .074, .080), vec3(.028, .029, .032), smoothstep(0., .75, length(p - .5)));
    ivec2 square = ivec2(p * 16.);
    return grey * ((square.x + square.y & 1) == 0 ? 1. : .82);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 behind = backdrop(fract(gl_FragCoord.xy / cell));
    color = vec4(behind, 1.);
    if (texelFetch(depthBuffer, pixel, 0).x >= 1.) return; // no surface here

    Surface s = unpackSurface(pixel);
    Lit m = surfaceLit(s, TO_EYE);
#ifdef SURFACE_HAS_metalness
    vec3 mirrored = glossAround(m);
#else
    vec3 mirrored = surfaceSpecular(m);
#endif
    vec3 sum = surfaceOwn(m) + surfaceEven(m) * capacity(m.normal, 1.) + mirrored * capacity(m.reflected, .5);
    for (int i = 0; i < LIGHTS; i++) sum += surfaceLobe(m, direction[i]) * power[i];
    sum += surfaceThrough(s, TO_EYE) * backdrop(fract(gl_FragCoord.xy / cell - .08 * m.normal.xy)); // bent a little
    color.rgb = sum / (1. + .25 * max(max(sum.r, sum.g), sum.b)) * 1.25; // bright lights do not clip at once
}
