#version 330
// Steps in place of a smooth fall of light, and a dark rim where the surface turns away.

in vec3 eyePosition;
in vec3 eyeNormal;

uniform float steps = 4.0;

out vec4 fragColor;

const int MNL = 10;                 // at most so many lights

struct LightSource
{
    vec4 posDir;                    // a position if its w is 1, a direction towards the light if it is 0
    vec4 ambient;
    vec4 diffuse;
    vec4 specular;
    float constantAttenuation;
    float linearAttenuation;
    float quadraticAttenuation;
    vec3 spotDirection;
    float spotCutoff;               // in degrees; 180 of what is no spot
    float spotExponent;
};

struct LightSources
{
    int nbrLights;
    LightSource source[MNL];
};

struct Material
{
    vec4 ambient;
    vec4 diffuse;
    vec4 specular;
    vec4 emission;
    float shininess;
};

uniform LightSources lights;        // in the camera's space
uniform Material material;

void main()
{
    vec3 N = normalize(eyeNormal);
    vec3 V = -normalize(eyePosition);
    vec3 L = lights.source[0].posDir.xyz - lights.source[0].posDir.w * eyePosition;
    float level = ceil(steps * max(dot(N, normalize(L)), 0.0)) / steps;
    float rim = step(0.25, dot(N, V));
    fragColor = vec4(rim * (material.ambient.rgb + material.diffuse.rgb * level), 1.0);
}
