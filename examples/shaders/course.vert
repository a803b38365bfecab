#version 330
// Place, normal and colour in the world.

in vec3 vPos;
in vec4 vCol;
in vec3 vNor;

uniform mat4 matMVP;
uniform mat4 matWorld;
uniform mat3 matNor;

out vec4 color;
out vec4 trPos;
out vec3 trNor;

void main()
{
    gl_Position = matMVP * vec4(vPos, 1.0);
    color = vCol;
    trPos = matWorld * vec4(vPos, 1.0);
    trNor = matNor * vNor;
}
