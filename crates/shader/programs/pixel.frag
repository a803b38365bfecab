#version 330
// @TITLE@, computed for each pixel.

in vec3 eyePosition;
in vec3 eyeNormal;

out vec4 fragColor;

@LIGHTS@
@MATERIAL@
@HIGHLIGHT@
@SUM@
void main()
{
    vec3 N = normalize(eyeNormal);
    if (!gl_FrontFacing)
        N = -N;
    fragColor = illuminate(eyePosition, N);
}
