#version 330
// Gouraud's shading: the colour of the vertices, interpolated.

in vec4 fColor;

out vec4 fragColor;

void main()
{
    fragColor = fColor;
}
