#version 330
// Steps in place of a smooth fall of light, and a dark rim where the surface turns away.

in vec3 eyePosition;
in vec3 eyeNormal;

uniform float steps = 4.0;

out vec4 fragColor;

@LIGHTS@
@MATERIAL@
void main()
{
    vec3 N = normalize(eyeNormal);
    vec3 V = -normalize(eyePosition);
    vec3 L = lights.source[0].posDir.xyz - lights.source[0].posDir.w * eyePosition;
    float level = ceil(steps * max(dot(N, normalize(L)), 0.0)) / steps;
    float rim = step(0.25, dot(N, V));
    fragColor = vec4(rim * (material.ambient.rgb + material.diffuse.rgb * level), 1.0);
}
