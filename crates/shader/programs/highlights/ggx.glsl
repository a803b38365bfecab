// GGX (Trowbridge and Reitz 1975, Walter et al. 2007) with Smith's height-correlated shadowing, without Fresnel's factor,
// which is the specular colour: π D G2 / (4 cosθo).
float lambda(in float cosTheta, in float alpha2)
{
    float cos2 = cosTheta * cosTheta;
    return (sqrt(1.0 + alpha2 * (1.0 - cos2) / cos2) - 1.0) / 2.0;
}

float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    float cosI = dot(N, L);
    float cosO = dot(N, V);
    if (cosI <= 0.0 || cosO <= 0.0)
        return 0.0;
    vec3 H = normalize(L + V);
    float alpha2 = material.alpha * material.alpha;
    vec3 across = cross(N, H);          // its length is the sine: precise where the cosine is nearly 1
    float sin2 = dot(across, across);
    float denominator = sin2 + (1.0 - sin2) * alpha2;
    float D = alpha2 / (denominator * denominator);
    float G2 = 1.0 / (1.0 + lambda(cosI, alpha2) + lambda(cosO, alpha2));
    return D * G2 / (4.0 * cosO);
}
