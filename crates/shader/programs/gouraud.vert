#version 330
// @TITLE@, computed for each vertex; Gouraud 1971 interpolates the colour.

in vec4 pos;
in vec4 normal;

uniform mat4 mvp;
uniform mat4 mv;
uniform mat3 normal_matrix;

out vec4 fColor;

@LIGHTS@
@MATERIAL@
@HIGHLIGHT@
@SUM@
void main()
{
    vec3 sp = vec3(mv * pos);
    vec3 N = normalize(normal_matrix * normal.xyz);
    fColor = illuminate(sp, N);
    gl_Position = mvp * pos;
}
