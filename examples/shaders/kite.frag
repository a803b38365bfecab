#version 330
// One light of its own, ambient, diffuse and with a highlight, times the colour of the vertices.

in vec4 color;
in vec4 trPos;
in vec3 trNor;

uniform vec3 eyePos;

out vec4 fragColor;

void main()
{
    vec3 N = normalize(trNor);
    vec3 L = normalize(vec3(0.0, -1.0, 10.0));
    float cosTheta = dot(N, L);
    vec3 sum = vec3(0.2) + vec3(0.6) * max(cosTheta, 0.0);
    if (cosTheta > 0.0)
    {
        vec3 R = reflect(-L, N);
        vec3 V = normalize(eyePos - trPos.xyz);
        sum += 0.2 * pow(max(dot(R, V), 0.0), 32.0);
    }
    fragColor = vec4(sum, 1.0) * color;
}
