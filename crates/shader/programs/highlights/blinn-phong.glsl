// Blinn 1977: the cosine between the normal and the half vector, to the power of the shininess.
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    if (dot(N, L) <= 0.0)
        return 0.0;
    vec3 H = normalize(L + V);
    return pow(max(dot(N, H), 0.0), material.shininess);
}
