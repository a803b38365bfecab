#version 330
in vec4 color;
in vec4 trPos;
in vec3 trNor;
out vec4 fragColor;
void main()
{
    // Couleur et direction de la lumiere, normalisee
    vec3 lightColor = vec3(0.6);
    vec3 lightDir = normalize(vec3(0.0, -1.0, 10.0));
    // Normale du fragment, normalisee
    vec3 nor3 = normalize(trNor);
    // Cosinus de l'angle entre la normale et la lumiere
    float cosTheta = dot(nor3, lightDir);
    // Lumiere diffuse
    vec3 diffuse = lightColor * max(cosTheta, 0.0);
    // Lumiere ambiante
    vec3 ambiant = vec3(0.2);
    // Lumiere speculaire
    vec3 eyePos = vec3(0.0, 0.0, 1.0);
    vec3 specColor = vec3(1.0, 1.0, 1.0);
    float spec_S = 0.2;
    float spec_m = 32.0;
    vec3 specular = vec3(0);
    if (cosTheta > 0.0) {
        vec3 R = reflect (-lightDir, nor3);
        vec3 V = eyePos - vec3(trPos);
        float cosGamma = dot(normalize(R), normalize(V));
        specular = specColor * spec_S * pow(max(cosGamma, 0.0), spec_m);
    }
    // Somme des lumieres
    vec3 sumLight = diffuse + specular + ambiant;
    // Couleur et direction de la lumiere, normalisee
    vec4 result = vec4(sumLight, 1.0) * color;
    fragColor = clamp(result, 0.0, 1.0);
}
