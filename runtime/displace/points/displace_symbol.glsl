// Geometry program of points: emits a symbol for each point, as wide as the grid's steps are long.
// All of the symbol has the point's texture coordinates, and shades as the point does except for
// the normal.
#ifdef DISPLACE_VOLUME
layout(points, invocations = 4) in; // one invocation per height
#else
layout(points) in;
#endif
layout(triangle_strip, max_vertices = 42) out;
flat in uint displace_patchOf[];
in vec3 displace_weights[];
// 0: square on the surface; 1: billboard facing the eye; 2: cylinder; 3: sphere
uniform int displace_symbol;
uniform vec3 displace_eye; // position of the eye in object space
uniform int displace_parts;

const float turn = 6.28318530717958647693;
vec3 displace_center, displace_along, displace_across, displace_up;
// the point's attributes, for each emitted vertex
vec3 own_normal, own_tangentU, own_tangentV, own_base;
vec2 own_texcoord;

// Emits the point with its attributes, offset along the frame by `by`.
void put(vec3 by, vec3 normal)
{
    displaced_base = own_base;
    displaced_texcoord = own_texcoord;
    displaced_tangentU = own_tangentU;
    displaced_tangentV = own_tangentV;
    displaced_normal = own_normal;
    displaced_position = displace_center + displace_along * by.x + displace_across * by.y +
        displace_up * by.z;
    if (normal != vec3(0.0) && displace_along != vec3(0.0))
        displaced_normal = normalize(displace_along * normal.x + displace_across * normal.y +
            displace_up * normal.z);
    EmitVertex();
}

void square()
{
    put(vec3(1, -1, 0), vec3(0));
    put(vec3(1, 1, 0), vec3(0));
    put(vec3(-1, -1, 0), vec3(0));
    put(vec3(-1, 1, 0), vec3(0));
    EndPrimitive();
}

void cylinder()
{
    const int sides = 8;
    for (int i = 0; i <= sides; i++) {
        vec3 side = vec3(cos(turn * float(i) / float(sides)), sin(turn * float(i) / float(sides)),
            0);
        put(side + vec3(0, 0, 1), side);
        put(side - vec3(0, 0, 1), side);
    }
    EndPrimitive();
    for (int i = 0; i < sides; i++) { // zigzag between both sides: a strip that covers a disc
        int k = i % 2 == 0 ? i / 2 : sides - (i + 1) / 2;
        put(vec3(cos(turn * float(k) / float(sides)), sin(turn * float(k) / float(sides)), 1),
            vec3(0, 0, 1));
    }
    EndPrimitive();
}

void ball()
{
    const int sides = 6, bands = 3;
    for (int band = 0; band < bands; band++) {
        for (int i = 0; i <= sides; i++)
            for (int k = 0; k < 2; k++) {
                float down = 0.5 * turn * float(band + k) / float(bands),
                    round = turn * float(i) / float(sides);
                vec3 at = vec3(sin(down) * cos(round), sin(down) * sin(round), cos(down));
                put(at, at);
            }
        EndPrimitive();
    }
}

void main()
{
    uvec3 corners = displaceCorners(displace_patchOf[0]);
    vec3 p[3] = vec3[3](displace_rows[4u * corners.x].xyz, displace_rows[4u * corners.y].xyz,
        displace_rows[4u * corners.z].xyz);
    bool there = true;
#ifdef DISPLACE_VOLUME
    there = displaceHeight(displace_patchOf[0], displace_weights[0], gl_InvocationID,
        0.015625 / float(displace_parts));
#else
    displacePoint(displace_patchOf[0], displace_weights[0]);
#endif
    displace_center = displaced_position;
    own_base = displaced_base;
    own_texcoord = displaced_texcoord;
    own_tangentU = displaced_tangentU;
    own_tangentV = displaced_tangentV;
    own_normal = displaced_normal;
    float longest = max(distance(p[0], p[1]), max(distance(p[1], p[2]), distance(p[2], p[0])));
    displace_up = displace_symbol == 1 ? normalize(displace_eye - displace_center) : own_normal;
    vec3 way = p[1] - p[0];
    way -= displace_up * dot(way, displace_up);
    float half_step = 0.5 * longest / float(displace_parts);
    displace_along = normalize(way) * half_step;
    displace_across = cross(displace_up, displace_along);
    displace_up *= half_step;
    if (!there) // degenerate triangles: the capturing draw expects a fixed number
        displace_along = displace_across = displace_up = vec3(0.0);
    if (displace_symbol == 2)
        cylinder();
    else if (displace_symbol == 3)
        ball();
    else
        square();
}
