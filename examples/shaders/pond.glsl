// A pond under a lamp: another pass makes the waves, this one lights them by Phong's model.

#iChannel0 "file://ripples.glsl"

float height(vec2 at)
{
    return texture(iChannel0, at / iResolution.xy).r;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    float steep = 0.035 * iResolution.y;
    vec2 slope = vec2(height(fragCoord + vec2(1.0, 0.0)) - height(fragCoord - vec2(1.0, 0.0)),
                      height(fragCoord + vec2(0.0, 1.0)) - height(fragCoord - vec2(0.0, 1.0)));
    vec3 N = normalize(vec3(-slope * steep, 1.0));
    vec3 sp = vec3((fragCoord - 0.5 * iResolution.xy) / iResolution.y, 0.0);
    vec3 L = normalize(vec3(-0.5, 0.9, 0.8) - sp);
    vec3 V = normalize(vec3(0.0, -0.4, 1.6) - sp);
    vec3 ground = mix(vec3(0.02, 0.10, 0.13), vec3(0.10, 0.30, 0.32), smoothstep(-0.6, 0.6, sp.y + N.y));
    float highlight = pow(max(dot(reflect(-L, N), V), 0.0), 60.0);
    vec3 color = ground * (0.35 + 0.9 * max(dot(N, L), 0.0)) + vec3(1.0, 0.95, 0.85) * highlight;
    fragColor = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}
