// Ambient light that differs by direction, by directional occlusion (Ritschel, Grosch and Seidel
// 2009): light arrives along the rays that hit nothing. The pass combine multiplies ambient
// occlusion by the unoccluded ambient light, which is exact only at full or zero occlusion. The
// pass rays adds the missing correlation of light and visibility to the light of surfaces:
//
//     mean(light let) - mean(let) mean(light)     over a point's rays; let: transmittance, 0 for a
//                                                 hit, else 1
//
// Worked example: half a sky, light 1 along two rays of four and 0 along the others, and a wall
// before both dark ones. Ambient occlusion gives 1/2 of 1/2; the added term is 1/2 - 1/2 1/2, so
// that 1/2 arrives, as if there were no wall. With the wall on the bright side the term is 0 - 1/2
// 1/2, and nothing arrives.
#define INDIRECT_AROUND
// scale of the added term: contrast / gain, since the pass combine applies the gain
uniform float around_share;
uniform float around_level; // mipmap level of the sky's cube map

// Returns the ambient radiance from an eye-space direction.
vec3 aroundAt(vec3 way)
{
    vec3 sum = vec3(0.0);
#ifdef LIGHT_HAS_SKY
    sum += sky_light.xyz * textureLod(sky_map, skyWorld(way), around_level).xyz;
#endif
    return sum AROUND_KINDS(way);
}

struct Around {
    vec3 all, let; // sums over rays: all ambient light, and the unoccluded part
};

void aroundAdd(vec3 light, float let, inout Around around)
{
    around.all += light;
    around.let += let * light;
}

// Correlation term to add to the light of surfaces; `open` is the mean transmittance.
vec3 aroundBeside(Around around, float open)
{
    return around_share * (around.let - open * around.all);
}
