// Cook and Torrance 1982 with Beckmann's slopes of width m, without Fresnel's factor, which is the specular colour:
// π D G / (4 cosθo).
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    float cosI = dot(N, L);
    float cosO = dot(N, V);
    if (cosI <= 0.0 || cosO <= 0.0)
        return 0.0;
    vec3 H = normalize(L + V);
    float cosH = dot(N, H);
    float cos2 = cosH * cosH;
    float tan2 = (1.0 - cos2) / cos2;
    float m2 = material.m * material.m;
    float D = exp(-tan2 / m2) / (m2 * cos2 * cos2);
    float G = min(1.0, 2.0 * cosH * min(cosI, cosO) / max(dot(V, H), 1e-6));
    return D * G / (4.0 * cosO);
}
