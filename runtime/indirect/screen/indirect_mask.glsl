// Ambient occlusion and light by visibility bit masks (Therrien, Levesque and Gilet 2023), a
// screen-space method. For several half planes through the line of sight, samples of the depth
// buffer on both sides cover angles of the half circle over the surface, from an occluder's front
// to its back, INDIRECT_THICK behind. The half circle has 32 sectors, a bit each; the sample that
// first sets a bit also sends its light through that sector. So light passes behind a post, unlike
// with horizons.
//
// Sectors are equal not in angle but in weight: with t the angle from the line of sight and g that
// of the normal, all light of a half plane is the integral of cos(t - g) |sin t|, whose primitive
// is (cos g - cos(2 t - g)) / 4 + t sin(g) / 2; a sector is a 32nd of the integral. Unoccluded,
// means over half planes then equal those of a cosine over the hemisphere (Jimenez et al. 2016),
// and counting bits needs no weights.
//
// Worked example: viewed from above, g = 0, a wall that covers t from 60 to 90 degrees. The
// primitive is (1 - cos 2t) / 4: 3/8 at 60 and 1/2 at 90 degrees, on this side a fourth of 1/2: 4
// bits of 32.
float indirectPrimitive(float t, float g)
{
    return 0.25 * (cos(g) - cos(2.0 * t - g)) + 0.5 * t * sin(g);
}

struct IndirectSlice {
    vec3 sight, aside; // perpendicular unit vectors; the slice extends to both sides of `sight`
    float g, left, all; // the normal's angle; the integral up to `sight`; the whole integral
};

// Returns the position of an angle among the sectors, from 0 to 32.
float indirectSector(IndirectSlice slice, float t)
{
    t = clamp(t, slice.g - 1.57079632679490, slice.g + 1.57079632679490);
    float p = indirectPrimitive(t, slice.g);
    return 32.0 * clamp((t < 0.0 ? slice.left - p : slice.left + p) / slice.all, 0.0, 1.0);
}

// Returns the angle from the line of sight, times `side`: 0 to pi in absolute value.
float indirectAngle(vec3 way, IndirectSlice slice, float side)
{
    return side * atan(max(side * dot(way, slice.aside), 0.0), dot(way, slice.sight));
}

uint indirectBits(float low, float high)
{
    int from = int(clamp(floor(low), 0.0, 32.0)), count = int(clamp(floor(high), 0.0, 32.0)) - from;
    return count <= 0 ? 0u : count >= 32 ? 0xFFFFFFFFu : ((1u << uint(count)) - 1u) << uint(from);
}

// Counts bits, for GLSL before 4.00.
float indirectCount(uint bits)
{
    bits = bits - (bits >> 1u & 0x55555555u);
    bits = (bits & 0x33333333u) + (bits >> 2u & 0x33333333u);
    return float(((bits + (bits >> 4u) & 0x0F0F0F0Fu) * 0x01010101u) >> 24u);
}

vec4 indirectAround(ivec2 pixel, IndirectShift shifts, vec3 point, vec3 normal, out vec3 open)
{
    vec3 sight = indirectIsOrthographic() ? vec3(0.0, 0.0, 1.0) : -normalize(point),
        light = vec3(0.0);
    vec3 shift = fract(shifts.at + shifts.more);
    float kept = 0.0, sum = 0.0;
    vec3 from = point + (indirect_reach.y + indirect_reach.z * indirectPixelSize(point)) * normal;
    vec2 middle = vec2(pixel) + 0.5;
    open = vec3(0.0);
#ifdef INDIRECT_AROUND
    Around around = Around(vec3(0.0), vec3(0.0));
#endif
    for (int i = 0; i < INDIRECT_SLICES; i++) {
        float turn = 3.14159265358979 * (float(i) + fract(shift.x)) / float(INDIRECT_SLICES);
        vec3 along = vec3(cos(turn), sin(turn), 0.0);
        IndirectSlice slice;
        slice.sight = sight;
        slice.aside = normalize(along - dot(along, sight) * sight);
        vec3 flat_ = vec3(dot(normal, slice.aside), dot(normal, sight), 0.0);
        slice.g = atan(flat_.x, max(flat_.y, 1e-4));
        slice.left = indirectPrimitive(slice.g - 1.57079632679490, slice.g);
        slice.all = slice.left + indirectPrimitive(slice.g + 1.57079632679490, slice.g);
        float share = length(flat_.xy) * slice.all;
        uint bits = 0u;
        for (int side = -1; side <= 1; side += 2) {
            vec3 end = point + indirect_reach.x * float(side) * slice.aside;
            if (!indirectIsOrthographic() && end.z > -indirect_view.x)
                end = mix(point, end, (-indirect_view.x * 1.001 - point.z) / (end.z - point.z));
            vec2 whole = indirectPlace(end) - middle;
            for (int j = 0; j < INDIRECT_STEPS; j++) {
                float s = (float(j) + 1.0 - INDIRECT_JITTER *
                    fract(shift.z + 0.618034 * float(2 * i + (side + 1) / 2))) /
                    float(INDIRECT_STEPS);
                vec2 place = middle + s * s * whole;
                if (!indirectIsShown(place)) break;
                ivec2 at = ivec2(place);
                float depth = texelFetch(indirect_depth, at, 0).x;
                if (depth <= 0.0 || at == pixel) continue;
                vec3 way = indirectPoint(at, depth) - from;
                // skips points below the half plane, even if the pixel's center seems higher
                if (dot(way, normal) <= 0.0) continue;
                float far = length(way);
                if (far > indirect_reach.x) continue;
                float a = indirectSector(slice, indirectAngle(way, slice, float(side))),
                    b = indirectSector(slice, indirectAngle(way - indirect_models.y * sight, slice,
                    float(side)));
                uint more = indirectBits(min(a, b) + fract(shift.y),
                    max(a, b) + fract(shift.y)) & ~bits;
                bits |= more;
                float part = share * indirectCount(more) / 32.0;
                kept += part * indirectWeight(far / indirect_reach.x);
#ifdef INDIRECT_LIGHT
                if (more != 0u) light += part * indirectSent(at, way);
#endif
            }
        }
#ifdef INDIRECT_BENT
        for (int b = 0; b < 32; b++) {
            // approximate center of the sector
            float t = slice.g + 3.14159265358979 * ((float(b) + 0.5) / 32.0 - 0.5);
            if ((bits >> uint(b) & 1u) == 0u)
                open += share * (cos(t) * sight + sin(t) * slice.aside);
        }
#endif
#ifdef INDIRECT_AROUND
        for (int b = 0; b < 4; b++) {
            // center of eight sectors
            float t = slice.g + 3.14159265358979 * ((float(b) + 0.5) / 4.0 - 0.5);
            aroundAdd(0.25 * share * aroundAt(cos(t) * sight + sin(t) * slice.aside),
                indirectCount(~bits >> uint(8 * b) & 0xFFu) / 8.0, around);
        }
#endif
        sum += share;
    }
    sum = max(sum, 1e-6);
#ifdef INDIRECT_AROUND
    light += aroundBeside(around, 1.0 - kept / sum);
#endif
    return vec4(light / sum, kept / sum);
}
