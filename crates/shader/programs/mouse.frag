#version 330
// A light that follows the pointer (--mouse X,Y), from the viewer's side.

in vec4 color;
in vec4 trPos;
in vec3 trNor;

uniform vec4 mousePos;              // x, y, width, height in pixels

out vec4 fragColor;

void main()
{
    vec3 lightDir = normalize(vec3(2.0 * mousePos[0] / mousePos[2] - 1.0,
                                   2.0 * mousePos[1] / mousePos[3] - 1.0,
                                   1.0));
    vec3 diffuse = vec3(0.7) * max(dot(normalize(trNor), lightDir), 0.0);
    fragColor = vec4(diffuse + vec3(0.3), 1.0) * color;
}
