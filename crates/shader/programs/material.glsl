struct Material
{
    vec4 ambient;
    vec4 diffuse;
    vec4 specular;
    vec4 emission;
    @PARAMETERS@
};

uniform LightSources lights;        // in the camera's space
uniform Material material;
