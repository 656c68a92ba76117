// Light from all around that is not the same from everywhere: what comes of it to a point is not
// what its openness says, but what comes along the rays that meet nothing (directional occlusion:
// Ritschel, Grosch and Seidel 2009). The pass combine has openness times what would come if nothing
// were around, which is exact where all is open, or nothing is; what is lacking between is how
// light and openness go together, which the pass rays adds to the light of surfaces:
//
//     mean(light let) - mean(let) mean(light)     over a point's rays; let: 0 where something is
//                                                 met, else 1
//
// Worked example: half a sky, light 1 along two rays of four and 0 along the others, and a wall
// before both dark ones. Openness says 1/2 of 1/2; added is 1/2 - 1/2 1/2, so that 1/2 arrives, as
// if there were no wall. With the wall on the bright side it is 0 - 1/2 1/2, and nothing arrives.
#define INDIRECT_AROUND
uniform float around_share; // of what is added: the contrast, over the gain that it will be times
uniform float around_level; // of the sky's cube

// Along a direction of the eye's space.
vec3 aroundAt(vec3 way)
{
    vec3 sum = vec3(0.0);
#ifdef LIGHT_HAS_SKY
    sum += sky_light.xyz * textureLod(sky_map, skyWorld(way), around_level).xyz;
#endif
    return sum AROUND_KINDS(way);
}

struct Around {
    vec3 all, let; // sums over rays
};

void aroundAdd(vec3 light, float let, inout Around around)
{
    around.all += light;
    around.let += let * light;
}

// Term to add to the light of surfaces; `open` is the mean transmittance.
vec3 aroundBeside(Around around, float open) { return around_share * (around.let - open * around.all); }
