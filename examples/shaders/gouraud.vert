#version 330
// Phong's highlights at the vertices, colours interpolated (Gouraud 1971), computed for each vertex; Gouraud 1971 interpolates the colour.

in vec4 pos;
in vec4 normal;

uniform mat4 mvp;
uniform mat4 mv;
uniform mat3 normal_matrix;

out vec4 fColor;

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

// Phong 1975: the cosine between the mirrored light and the viewer, to the power of the shininess.
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    if (dot(N, L) <= 0.0)
        return 0.0;
    vec3 R = reflect(-L, N);
    return pow(max(dot(R, V), 0.0), material.shininess);
}

// What reaches a point from a light: its direction L, and the factor of distance and cone; cone is that of the cone alone.
void arrive(in int i, in vec3 sp, out vec3 L, out float factor, out float cone)
{
    cone = 1.0;
    factor = 1.0;
    if (lights.source[i].posDir.w == 0.0)
    {
        L = lights.source[i].posDir.xyz;
        return;
    }
    L = lights.source[i].posDir.xyz - sp;
    float d = length(L);
    L = L / d;
    factor = 1.0 / (lights.source[i].constantAttenuation +
                    lights.source[i].linearAttenuation * d +
                    lights.source[i].quadraticAttenuation * d * d);
    if (lights.source[i].spotCutoff != 180.0)
    {
        float spotDot = dot(-L, lights.source[i].spotDirection);
        cone = 0.0;
        if (spotDot >= cos(radians(lights.source[i].spotCutoff)))
            cone = pow(max(spotDot, 0.0), lights.source[i].spotExponent);
        factor *= cone;
    }
}

// The light of all sources at the point sp, with its unit normal N.
vec4 illuminate(in vec3 sp, in vec3 N)
{
    vec3 V = -normalize(sp);
    vec4 ambient = vec4(0.0);
    vec4 diffuse = vec4(0.0);
    vec4 specular = vec4(0.0);
    for (int i = 0; i < lights.nbrLights; i++)
    {
        vec3 L;
        float factor;
        float cone;
        arrive(i, sp, L, factor, cone);
        ambient += lights.source[i].ambient * cone;
        diffuse += lights.source[i].diffuse * max(dot(N, L), 0.0) * factor;
        specular += lights.source[i].specular * highlight(L, V, N) * factor;
    }
    vec4 sum = material.ambient * ambient + material.diffuse * diffuse + material.specular * specular;
    return vec4(sum.rgb + material.emission.rgb, 1.0);
}

void main()
{
    vec3 sp = vec3(mv * pos);
    vec3 N = normalize(normal_matrix * normal.xyz);
    fColor = illuminate(sp, N);
    gl_Position = mvp * pos;
}
