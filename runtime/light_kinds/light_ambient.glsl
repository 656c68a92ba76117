// Ambient light: each surface reflects its slot `ambient` times the sum of all ambient lights.
#ifdef LIGHT_SENDS
layout(std140) uniform Ambient {
    vec4 ambient_up, ambient_light;
};

vec3 lightFromAmbient(Seen seen) { return surfaceAmbient(seen.m, ambient_light.xyz); }
#endif
