// One pass of feedback: a triangle is divided into four at the midpoints of its edges while it is
// large and near; otherwise it becomes final, and later passes copy it. A vertex is a patch and
// barycentric weights: midpoints of weights are exact, so that both sides of an edge agree, and all
// attributes, tangents included, are interpolated from the patch.
layout(triangles) in;
// 8 for four triangles, 14 for a skirt around six points
layout(triangle_strip, max_vertices = 22) out;
flat in uvec2 divide_state[];
in vec2 divide_weights[];
flat out uvec2 feedback_state;
out vec2 feedback_weights;

uniform mat4 matc_worldFromLocal;
uniform vec3 displace_eye; // position of the eye in world space
uniform float displace_near;
uniform float displace_detail;
uniform int displace_skirts; // kind of skirts: a SKIRTS_... constant
uniform int displace_last;   // 1 in the last pass; 0 in others
uniform int displace_uneven; // 1: triangles of the mesh differ in area
const int SKIRTS_ALL = 1, SKIRTS_BORDERS = 2, SKIRTS_EARLY = 3;
const uint FINAL = 1u, LOWER = 2u;

void put(vec2 weights, uint flags)
{
    feedback_state = uvec2(divide_state[0].x, flags);
    feedback_weights = weights;
    EmitVertex();
}

vec3 worldOf(vec2 w)
{
    vec3 local = displaceMixed(displaceCorners(divide_state[0].x), vec3(w, 1.0 - w.x - w.y),
        0u).xyz;
    return (matc_worldFromLocal * vec4(local, 1.0)).xyz;
}

bool onEdge(vec2 a, vec2 b)
{
    return (a.x == 0.0 && b.x == 0.0) || (a.y == 0.0 && b.y == 0.0) ||
        (a.x + a.y == 1.0 && b.x + b.y == 1.0);
}

void skirt(vec2 around[6], int count)
{
    for (int i = 0; i <= count; i++) {
        put(around[i % count], FINAL);
        put(around[i % count], FINAL | LOWER);
    }
    EndPrimitive();
}

void four(vec2 around[6], uint flags)
{
    put(around[0], flags);
    put(around[1], flags);
    put(around[5], flags);
    put(around[3], flags);
    put(around[4], flags);
    EndPrimitive();
    put(around[1], flags);
    put(around[2], flags);
    put(around[3], flags);
    EndPrimitive();
}

void main()
{
    vec2 a = divide_weights[0], b = divide_weights[1], c = divide_weights[2];
    if ((divide_state[0].y & FINAL) != 0u) {
        put(a, divide_state[0].y);
        put(b, divide_state[1].y);
        put(c, divide_state[2].y);
        EndPrimitive();
        return;
    }
    vec3 p = worldOf(a), q = worldOf(b), r = worldOf(c);
    float ab = distance(p, q), bc = distance(q, r), ca = distance(r, p), s = 0.5 * (ab + bc + ca);
    float area = sqrt(max(s * (s - ab) * (s - bc) * (s - ca), 0.0)); // Heron's formula
    float away = distance((p + q + r) / 3.0, displace_eye) - displace_near,
        longest = max(max(ab, bc), ca);
    bool divided = away < displace_detail * area, again = away < 0.25 * displace_detail * area;
    bool early = divided && !again && displace_skirts == SKIRTS_EARLY && displace_last == 0;
    vec2 around[6] = vec2[6](a, 0.5 * (a + b), b, 0.5 * (b + c), c, 0.5 * (c + a));
    if (early) { // the triangle's parts are final: borders are detected by the area of the parts
        area *= 0.25;
        longest *= 0.5;
    }
    // the neighbor may be larger and divided although it is nearer
    bool rim = displace_uneven != 0 && (onEdge(a, b) || onEdge(b, c) || onEdge(c, a));
    bool border = rim || abs(away - displace_detail * area) <
        max(0.5 * area + displace_near, longest);
    if (divided) {
        four(around, early ? FINAL : 0u);
        if (early ? border : displace_last != 0 &&
            (displace_skirts == SKIRTS_ALL || (displace_skirts != 0 && rim)))
            skirt(around, 6);
        return;
    }
    put(a, FINAL);
    put(b, FINAL);
    put(c, FINAL);
    EndPrimitive();
    if (displace_skirts == SKIRTS_ALL || (displace_skirts != 0 && border))
        skirt(vec2[6](a, b, c, a, b, c), 3);
}
