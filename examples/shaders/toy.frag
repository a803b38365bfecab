// A ball over a chequered floor, as Shadertoy has it: no scene, rays by hand. The pointer moves the lamp.
//
//     glanz shader run toy.frag -o toy.png
//     glanz shader run toy.frag --size 320x180 --frames 0..50 -o toy.gif

const vec3 BALL = vec3(0.0, 1.0, 0.0);

// How far it is along a ray to the ball, and to the floor; below 0 where it is not met.
float ball(vec3 from, vec3 along)
{
    vec3 c = from - BALL;
    float b = dot(c, along);
    float d = b * b - dot(c, c) + 1.0;
    return d < 0.0 ? -1.0 : -b - sqrt(d);
}

float floorAt(vec3 from, vec3 along)
{
    return along.y < 0.0 ? -from.y / along.y : -1.0;
}

// Blinn 1977, with a shadow.
vec3 lit(vec3 at, vec3 N, vec3 V, vec3 color, float gloss, vec3 lamp)
{
    vec3 L = normalize(lamp - at);
    float shadow = ball(at + 0.001 * N, L) > 0.0 ? 0.0 : 1.0;
    vec3 H = normalize(L + V);
    float matte = max(dot(N, L), 0.0);
    return color * (0.1 + 0.9 * shadow * matte) + vec3(shadow * gloss * pow(max(dot(N, H), 0.0), 80.0));
}

vec3 surface(vec3 at, vec3 N, vec3 V, vec3 lamp, bool isFloor)
{
    if (!isFloor)
        return lit(at, N, V, vec3(0.7, 0.15, 0.08), 0.6, lamp);
    float squares = mod(floor(at.x) + floor(at.z), 2.0);
    return lit(at, N, V, mix(vec3(0.15), vec3(0.6), squares), 0.0, lamp);
}

vec3 sky(vec3 along)
{
    return mix(vec3(0.55, 0.6, 0.65), vec3(0.15, 0.3, 0.6), clamp(along.y * 2.0, 0.0, 1.0));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 p = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec2 pointer = iMouse.xy / iResolution.xy;
    float turn = iMouse.x > 0.0 ? 6.28 * pointer.x : 0.8 + iTime;
    vec3 lamp = vec3(4.0 * cos(turn), 4.0, 4.0 * sin(turn));
    vec3 from = vec3(0.0, 1.6, 4.5);
    vec3 along = normalize(vec3(p.x, p.y - 0.15, -2.0));
    vec3 color = vec3(0.0);
    float rest = 1.0;
    // The ball mirrors what is around by Schlick's Fresnel, once.
    for (int bounce = 0; bounce < 2; bounce++)
    {
        float t = ball(from, along);
        float f = floorAt(from, along);
        if (t <= 0.0 && f <= 0.0)
        {
            color += rest * sky(along);
            break;
        }
        bool isFloor = t <= 0.0;
        vec3 at = from + along * (isFloor ? f : t);
        vec3 N = isFloor ? vec3(0.0, 1.0, 0.0) : at - BALL;
        float far = exp(-0.02 * length(at - BALL) * length(at - BALL));
        float mirrored = isFloor ? 0.0 : 0.04 + 0.96 * pow(1.0 - max(dot(-along, N), 0.0), 5.0);
        vec3 own = surface(at, N, -along, lamp, isFloor);
        color += rest * (1.0 - mirrored) * (isFloor ? mix(sky(along), own, far) : own);
        rest *= mirrored;
        if (isFloor)
            break;
        from = at + 0.001 * N;
        along = reflect(along, N);
    }
    fragColor = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}
