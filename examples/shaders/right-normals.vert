#version 330
// Normals by the inverse transpose of the matrix of positions.

in vec3 aPos;
in vec3 aNormal;

uniform mat4 MVP;
uniform mat4 model;
uniform mat3 normalMatrix;

out vec3 normal;

void main()
{
    normal = normalMatrix * aNormal;
    gl_Position = MVP * vec4(aPos, 1.0);
}
