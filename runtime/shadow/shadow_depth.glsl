// Vertex program that draws depth only, for a shadow map, independent of the material. Matrices are
// laid out as in matc's own programs.
layout(location = 0) in vec3 position;
#ifdef INSTANCES
layout(location = 5) in uint matc_instance;
struct Instance {
    mat4 worldFromLocal;
    mat3 worldNormalFromLocal;
    uint material;
};
layout(std140, binding = 0) readonly buffer Instances {
    Instance matc_instances[];
};
layout(std140, binding = 0) uniform View {
    mat4 matc_clipFromWorld;
    mat3 matc_eyeNormalFromWorld;
};
#define matc_worldFromLocal matc_instances[matc_instance].worldFromLocal
#else
uniform mat4 matc_worldFromLocal, matc_clipFromWorld;
#endif
void main()
{
    gl_Position = matc_clipFromWorld * (matc_worldFromLocal * vec4(position, 1.0));
}
