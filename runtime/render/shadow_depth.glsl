// Draws depth alone, for a shadow map: the vertex program. Nothing of a material is computed.
layout(location = 0) in vec3 position;
uniform mat4 shadow_clipFromLocal;
void main()
{
    gl_Position = shadow_clipFromLocal * vec4(position, 1.0);
}
