#version 330
// Normals in the world as colours: x, y and z from -1 to 1 are red, green and blue from 0 to 1.

in vec4 color;
in vec4 trPos;
in vec3 trNor;

out vec4 fragColor;

void main()
{
    fragColor = vec4(0.5 + 0.5 * normalize(trNor), 1.0);
}
