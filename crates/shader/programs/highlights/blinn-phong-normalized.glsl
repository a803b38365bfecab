// Blinn's lobe as a reflectance that gives back no more than it gets: π (n + 2) (n + 4) / (8π (2^(−n/2) + n)).
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    float cosTheta = dot(N, L);
    if (cosTheta <= 0.0)
        return 0.0;
    float n = material.shininess;
    vec3 H = normalize(L + V);
    float scale = (n + 2.0) * (n + 4.0) / (8.0 * (exp2(-0.5 * n) + n));
    return scale * pow(max(dot(N, H), 0.0), n) * cosTheta;
}
