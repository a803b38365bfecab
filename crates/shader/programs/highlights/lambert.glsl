// No highlight.
float highlight(in vec3 L, in vec3 V, in vec3 N)
{
    return 0.0;
}
