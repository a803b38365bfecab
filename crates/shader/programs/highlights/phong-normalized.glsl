// Phong's lobe as a reflectance that gives back no more than it gets (Lewis 1994): (n + 2) / 2 is π (n + 2) / (2π).
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    float cosTheta = dot(N, L);
    if (cosTheta <= 0.0)
        return 0.0;
    vec3 R = reflect(-L, N);
    return (material.shininess + 2.0) / 2.0 * pow(max(dot(R, V), 0.0), material.shininess) * cosTheta;
}
