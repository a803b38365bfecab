#version 330
// The mistake that everybody makes once: normals by the matrix of positions. Scaled along one axis they lean the wrong way.

in vec3 aPos;
in vec3 aNormal;

uniform mat4 MVP;
uniform mat4 model;

out vec3 normal;

void main()
{
    normal = mat3(model) * aNormal;
    gl_Position = MVP * vec4(aPos, 1.0);
}
