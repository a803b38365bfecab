// The surface of a pond: its height in red, its speed in green, step by step by the wave equation.
// Drops fall where the pointer is, else here and there.

#iChannel0 "self"

const float SPEED = 0.45;           // squared, in pixels per frame; below 0.5 it is stable
const float LOSS = 0.992;           // of the speed that is left after a frame

float height(ivec2 at)
{
    ivec2 edge = ivec2(iResolution.xy) - 1;
    return texelFetch(iChannel0, clamp(at, ivec2(0), edge), 0).r;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    ivec2 at = ivec2(fragCoord);
    vec2 before = texelFetch(iChannel0, at, 0).rg;
    float around = height(at + ivec2(1, 0)) + height(at - ivec2(1, 0))
                 + height(at + ivec2(0, 1)) + height(at - ivec2(0, 1));
    float speed = (before.g + SPEED * (around - 4.0 * before.r)) * LOSS;
    float h = before.r + speed;
    if (iFrame % 12 == 0)
    {
        float n = float(iFrame / 12);
        vec2 drop = fract(vec2(0.7549, 0.5698) * n + 0.5) * iResolution.xy;
        if (iMouse.z > 0.0)
            drop = iMouse.xy;
        vec2 d = (fragCoord - drop) / (0.02 * iResolution.y);
        h -= 0.6 * exp(-dot(d, d));
    }
    fragColor = vec4(h, speed, 0.0, 1.0);
}
