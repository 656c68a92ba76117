// Geometry program with loops: emits the rows of a part of a patch, and skirts. DISPLACE_VERTICES
// is the maximum number of emitted points. A patch with displace_rowCount * displace_parts parts
// along an edge consists of displace_parts^2 parts, in rows; strip i joins rows i and i + 1,
// alternating between them from the lower row on. The displacement is called in only two places,
// since compilers inline it at each.
layout(points) in;
layout(triangle_strip, max_vertices = DISPLACE_VERTICES) out;
flat in int displace_item[];
uniform int displace_first; // index of the draw's first patch in displace_drawn
uniform int displace_rowCount;
uniform int displace_parts;
uniform int displace_skirts; // kind of skirts: a SKIRTS_... constant
const int SKIRTS_COPY = 1, SKIRTS_OUTLINE = 2, SKIRTS_ALL = 3;

uvec2 displace_patch;
ivec3 displace_corners[3]; // corners of the part, in units of the patch's parts

// Emits a point with integer weights, whose sum is the number of parts of an edge; `lower`: the
// point below it.
void put(ivec3 weights, bool lower)
{
    ivec3 fitted = displaceFitted(weights, displace_patch.y, displace_rowCount * displace_parts);
    displaceAt(displace_patch.x, vec3(fitted) / float(displace_rowCount * displace_parts), lower);
    EmitVertex();
}

// Returns the weights of point `place` in row `row` of the part.
ivec3 inRows(int row, int place)
{
    return displace_corners[0] * (displace_rowCount - row) + displace_corners[1] * place +
        displace_corners[2] * (row - place);
}

void setPart(int part)
{
    int row = 0;
    while ((row + 1) * (row + 1) <= part)
        row++;
    int place = part - row * row, column = place / 2, turned = place % 2;
    ivec3 first = ivec3(displace_parts - row - turned, column + turned, row - column),
        way = ivec3(1 - 2 * turned);
    displace_corners = ivec3[3](first, first + way * ivec3(-1, 1, 0),
        first + way * ivec3(-1, 0, 1));
}

// Returns corner k of small triangle t; row i has 2 i + 1 triangles.
ivec3 corner(int t, int k)
{
    int i = 0;
    while ((i + 1) * (i + 1) <= t)
        i++;
    int place = t - i * i, j = place / 2;
    if (place % 2 == 0)
        return inRows(i + min(k, 1), j + int(k == 1));
    return inRows(i + int(k == 2), j + int(k > 0));
}

// Returns the number of points of skirts: two for each edge of a band, whose outside is to the
// right of its direction.
int skirtPoints()
{
    return displace_skirts == SKIRTS_OUTLINE ? 6 * (displace_rowCount + 1)
         : displace_skirts == SKIRTS_ALL     ? 8 * displace_rowCount * displace_rowCount
         : displace_skirts == SKIRTS_COPY    ? 3
                                             : 0;
}

void main()
{
    int parts = displace_parts * displace_parts, part = displace_item[0] % parts;
    displace_patch = displace_drawn[displace_first + displace_item[0] / parts];
    setPart(part);
    for (int i = 0; i < displace_rowCount; i++) {
        for (int k = 0; k < 2 * i + 3; k++)
            put(inRows(i + 1 - k % 2, k / 2), false);
        EndPrimitive();
    }
    int count = skirtPoints(), band = displace_skirts == SKIRTS_OUTLINE
        ? 2 * (displace_rowCount + 1)
                                    : displace_skirts == SKIRTS_ALL     ? 8
                                                                        : 3;
    for (int s = 0; s < count; s++) {
        int number = s / band, at = s % band / 2;
        ivec3 weights = ivec3(0);
        bool there = true, lower = s % 2 == 1;
        if (displace_skirts == SKIRTS_OUTLINE) {
            ivec3 from = displace_corners[number], to = displace_corners[(number + 1) % 3];
            weights = from * (displace_rowCount - at) + to * at;
            // both corners are on the same edge of the patch
            there = any(equal(from + to, ivec3(0)));
        } else if (displace_skirts == SKIRTS_ALL) {
            weights = corner(number, at % 3);
        } else {
            weights[s] = displace_rowCount * displace_parts;
            there = part == 0;
            lower = true;
        }
        if (there)
            put(weights, lower);
        if (there && s % band == band - 1)
            EndPrimitive();
    }
}
