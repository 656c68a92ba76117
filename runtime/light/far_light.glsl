// A light as bounded for a group of pixels, for pass_near.glsl and pass_light_cluster.glsl, with
// one work group per group of pixels. Preceded by lighting.glsl, far_group.glsl and far_lobe.glsl.
layout(local_size_x = FAR_INVOCATIONS) in;
// GROUP: invocations; PITCH: row length of partial sums, which puts neighbors in a column into
// different memory banks
const int GROUP = FAR_INVOCATIONS, PITCH = GROUP + 1;

shared float far_group[GROUP_NUMBERS]; // numbers of a group in the layout of pass_groups.glsl

int farCount() { return light_plain + light_points; }

// Returns the min and max transmittance of a spot's cone over the group.
vec2 farCone(int light, vec3 way, float ratio)
{
    vec2 cone = lightTexel(light, LIGHT_CONE).xy;
    float sine = min(ratio, 1.0);
    vec2 cosines = ratio < 1.0 ? farCosines(-dot(way, lightTexel(light, LIGHT_AXIS).xyz),
        sqrt(1.0 - sine * sine), sine)
                               : vec2(-1.0, 1.0);
    return clamp(cone.x * cosines + cone.y, 0.0, 1.0);
}

Far farLight(int light, Group group)
{
    Far far;
    vec4 place = lightTexel(light, LIGHT_PLACE);
    vec3 way = place.xyz - place.w * group.centre;
    float over = inversesqrt(max(dot(way, way), 1e-30)), finite = place.w > 0.0 ? over : 0.0;
    far.way = way * over;
    far.ratio = group.radius * finite;
    far.power = lightTexel(light, LIGHT_POWER).xyz * (place.w > 0.0 ? over * over : 1.0);
    vec2 cosines = farCosines(dot(far.way, group.axis), group.cosine, group.sine);
    far.least = cosines.x - group.above * finite;
    far.most = cosines.y - group.below * finite;
    far.high = max(max(cosines.y, far.most), -cosines.x);
    far.lift = max(group.above, -group.below) * finite;
    far.whole = true;
#ifdef FAR_OTHERS
    if (light >= light_plain) {
        vec2 cone = farCone(light, far.way, far.ratio);
        far.whole = cone.x >= 1.0 && lightTexel(light, LIGHT_CONE).w < 0.0;
        if (cone.y <= 0.0) far.power = vec3(0.0);
    }
#endif
    return far;
}

// Reports whether the light reaches no pixel of the group.
bool farIsDark(Far far, Group group)
{
    return far.power == vec3(0.0) || (far.most <= 0.0 && !group.behind);
}

vec3 farTake(int i) { return vec3(far_group[i], far_group[i + 1], far_group[i + 2]); }

Group farLoad(int number)
{
    for (int i = int(gl_LocalInvocationIndex); i < GROUP_NUMBERS; i += GROUP)
        far_group[i] = far_numbers[farPlace(number) + i];
    barrier();
    return Group(farTake(GROUP_CENTER), farTake(GROUP_AXIS), farTake(GROUP_VIEW),
        far_group[GROUP_RADIUS],
                 far_group[GROUP_COSINE], far_group[GROUP_SINE], far_group[GROUP_ABOVE],
                     far_group[GROUP_BELOW],
                 far_group[GROUP_MIRROR], far_group[GROUP_EXPONENT], far_group[GROUP_TURN],
                     far_group[GROUP_LEAN],
                 far_group[GROUP_SPREAD], farTake(GROUP_EVEN), farTake(GROUP_DIM),
                     farTake(GROUP_SPECULAR),
                 far_group[GROUP_BEHIND] > 0.0);
}
