// Phong 1975: the cosine between the mirrored light and the viewer, to the power of the shininess.
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    if (dot(N, L) <= 0.0)
        return 0.0;
    vec3 R = reflect(-L, N);
    return pow(max(dot(R, V), 0.0), material.shininess);
}
