#version 330
// A light per pixel: the vertex shader gives place and normal in the camera's space.

in vec4 pos;
in vec4 normal;

uniform mat4 mvp;
uniform mat4 mv;
uniform mat3 normal_matrix;

out vec3 eyePosition;
out vec3 eyeNormal;

void main()
{
    eyePosition = vec3(mv * pos);
    eyeNormal = normal_matrix * normal.xyz;
    gl_Position = mvp * pos;
}
