// Ward 1992, isotropic: π cosθi exp(−tan²θh / α²) / (4π α² √(cosθi cosθo)).
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    float cosI = dot(N, L);
    float cosO = dot(N, V);
    if (cosI <= 0.0 || cosO <= 0.0)
        return 0.0;
    vec3 H = normalize(L + V);
    float cosH = dot(N, H);
    vec3 across = cross(N, H);          // its length is the sine: precise where the cosine is nearly 1
    float tan2 = dot(across, across) / (cosH * cosH);
    float alpha2 = material.alpha * material.alpha;
    return cosI * exp(-tan2 / alpha2) / (4.0 * alpha2 * sqrt(cosI * cosO));
}
