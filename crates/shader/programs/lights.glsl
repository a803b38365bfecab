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
