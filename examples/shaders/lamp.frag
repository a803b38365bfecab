#version 330
// Matte, under a light from above the viewer's left shoulder.

in vec3 normal;

uniform vec3 lightDir = vec3(-0.4, 0.8, 0.6);
uniform vec3 surface = vec3(0.8, 0.7, 0.5);

out vec4 color;

void main()
{
    float cosTheta = dot(normalize(normal), normalize(lightDir));
    color = vec4(surface * (0.1 + 0.9 * max(cosTheta, 0.0)), 1.0);
}
