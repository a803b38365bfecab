"""Small shaders on the lane machine against OpenGL on Mesa's llvmpipe.

Every function and operator of GLSL in its scalar and vector forms, swizzles, matrices, control flow, structs, arrays,
out parameters, whole numbers, derivatives and textures. The numbers of all pixels must agree within 1e-5, relative;
what a texture gives, within 2/255. What is made of logarithms, powers and angles is compared with double precision, too,
and alone where llvmpipe is less exact than that; GLANZ_SHOW_EXACT=1 shows how exact both are.

    GLANZ_ORACLE=program python -m unittest tests/python/test_shaders.py
"""

import os
import pathlib
import subprocess
import tempfile
import unittest

# Before Mesa is loaded.
os.environ.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")
os.environ.setdefault("GALLIUM_DRIVER", "llvmpipe")
# Without its shortcuts: levels per pixel and not per quad, by the logarithm, weights not of 8 bits.
os.environ.setdefault("GALLIVM_PERF", "no_brilinear,no_rho_approx,no_quad_lod,no_aos_sampling")

import moderngl
import numpy as np

SIDE = 16
# Relative to the value, or to this where the value is smaller: sums that cancel have no relative precision.
TOLERANCE, SMALL = 1e-5, 0.1
TEXTURE_TOLERANCE = 2 / 255
# llvmpipe has the level of textures from a logarithm that is linear between powers of two, up to 0.09 levels wrong, and
# the change along the first row for the whole quad: up to 7/255 from double precision, with which these are compared.
BY_LEVEL = {"grad", "smaller", "warped", "proj"}
# These are compared with double precision, too.
BY_DOUBLE = {"exp", "exp2", "log", "log2", "pow", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
             "asin", "acos", "atan", "atan2", "sin", "cos", "tan"}
# And these with nothing else: Mesa's are polynomials, of which GLSL asks for 2^-11 or nothing, up to 4e-4 wrong.
INEXACT = {"asin", "acos", "atan", "atan2"}

# What the machine does not take or does otherwise, and why. A program that begins to agree must leave this list.
KNOWN = {
    "dot1": "the front end has no scalar forms of functions of vectors",
    "faceforward1": "as dot1",
    "normalize1": "as dot1",
    "reflect1": "as dot1",
    "refract1": "as dot1",
    "matrix_column": "the front end writes no swizzle of a column",
    "matrix_outer23": "the front end turns the type of outer products that are not square",
    "structs_equal": "the front end compares no structs",
}

VERTEX = """#version 330
out vec2 uv;
void main() {
    vec2 at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
    uv = at;
    gl_Position = vec4(at * 2.0 - 1.0, 0.0, 1.0);
}
"""

# What the bodies work on: x and y from -1.875 to 1.875, all of them exact.
HEAD = """#version 330
uniform sampler2D image;
in vec2 uv;
out vec4 result;
%s
void main() {
    float x = (gl_FragCoord.x - 8.0) / 4.0;
    float y = (gl_FragCoord.y - 8.0) / 4.0;
    int i = int(gl_FragCoord.x) - 7;
    int j = int(gl_FragCoord.y) - 7;
    uint u = uint(gl_FragCoord.x) * 7u + 3u;
    uint w = uint(gl_FragCoord.y) + 1u;
    vec2 a2 = vec2(x, y); vec3 a3 = vec3(x, y, x * 0.5 + y); vec4 a4 = vec4(x, y, x - y, 1.5);
    vec2 b2 = vec2(y - 0.25, x + 0.5); vec3 b3 = vec3(y, 0.75, x); vec4 b4 = vec4(y, 0.75, x, x + y);
    ivec2 i2 = ivec2(i, j); ivec3 i3 = ivec3(i, j, i - 2 * j); uvec2 u2 = uvec2(u, w);
    mat2 m2 = mat2(x, y, 1.0, 2.0 - x); mat3 m3 = mat3(1.0, x, y, 0.5, 2.0, x, y, 1.0, 3.0);
    mat4 m4 = mat4(2.0, x, 0.0, y, 0.5, 3.0, x, 0.0, y, 1.0, 4.0, x, 0.25, 0.0, y, 5.0);
    result = vec4(0.0);
    %s
}
"""


def wide(expression, size):
    """The expression as a vec4."""
    return f"result = vec4({expression}{', 0.0' * (4 - size)});"


def functions():
    """(name, body, what it is about) of calls of functions."""
    one = {
        "radians": "", "degrees": "", "sin": "", "cos": "", "tan": "* 0.5", "asin": "/ 4.0", "acos": "/ 4.0",
        "atan": "", "sinh": "", "cosh": "", "tanh": "", "asinh": "", "acosh": "+ 3.0", "atanh": "/ 3.0",
        "exp": "", "log": "+ 2.5", "exp2": "* 3.0", "log2": "+ 2.5", "sqrt": "+ 2.0", "inversesqrt": "+ 2.0",
        "abs": "", "sign": "", "floor": "* 3.3", "ceil": "* 3.3", "fract": "* 3.3", "trunc": "* 3.3",
        "round": "* 3.3", "roundEven": "* 2.0",
    }
    for name, more in one.items():
        for size, argument in [(1, "x"), (2, "a2"), (3, "a3"), (4, "a4")]:
            # The third component of a3 leaves the domains: halved.
            part = f"({argument} * 0.6) {more}" if size > 2 else f"{argument} {more}"
            yield f"{name}{size}", wide(f"{name}({part})", size), name
    two = {
        "pow": ("abs({0}) + 0.1", "{0}"), "mod": ("{0} * 3.0", "abs({0}) + 0.3"), "min": ("{0}", "{0}"),
        "max": ("{0}", "{0}"), "step": ("{0}", "{0}"), "atan": ("{0}", "{0} + 0.01"),
    }
    for name, (first, second) in two.items():
        for size, a, b in [(1, "x", "y"), (2, "a2", "b2"), (3, "a3", "b3"), (4, "a4", "b4")]:
            call = f"{name}({first.format(a)}, {second.format(b)})"
            yield f"{name}_{size}", wide(call, size), "atan2" if name == "atan" else name
    for name in ["mod", "min", "max"]:
        yield f"{name}_by_number", wide(f"{name}(a3 * 3.0, 0.7)", 3), name
    yield "step_by_number", wide("step(0.3, a3)", 3), "step"
    for size, a, b in [(1, "x", "y"), (2, "a2", "b2"), (3, "a3", "b3"), (4, "a4", "b4")]:
        yield f"clamp{size}", wide(f"clamp({a}, {b} * 0.1 - 0.5, {b} * 0.1 + 0.5)", size), "clamp"
        yield f"mix{size}", wide(f"mix({a}, {b}, {a} * 0.3)", size), "mix"
        yield f"smoothstep{size}", wide(f"smoothstep({a} * 0.0 - 1.0, {a} * 0.0 + 0.8, {b})", size), "smoothstep"
        yield f"length{size}", wide(f"length({a})", 1), "length"
        yield f"distance{size}", wide(f"distance({a}, {b})", 1), "distance"
        yield f"dot{size}", wide(f"dot({a}, {b})", 1), "dot"
        yield f"normalize{size}", wide(f"normalize({a} + 0.01)", size), "normalize"
        yield f"faceforward{size}", wide(f"faceforward({a}, {b}, {a} - 0.3)", size), "faceforward"
        yield f"reflect{size}", wide(f"reflect({a}, {b})", size), "reflect"
        yield f"refract{size}", wide(f"refract(normalize({a} + 0.01), normalize({b} + 0.02), 0.8)", size), "refract"
    yield "clamp_by_numbers", wide("clamp(a4, -0.5, 0.5)", 4), "clamp"
    yield "mix_by_number", wide("mix(a3, b3, 0.3)", 3), "mix"
    yield "mix_by_truth", wide("mix(a3, b3, lessThan(a3, b3))", 3), "mix"
    yield "smoothstep_by_numbers", wide("smoothstep(-0.5, 0.5, a3)", 3), "smoothstep"
    yield "cross", wide("cross(a3, b3)", 3), "cross"
    yield "isnan", "result = vec4(isnan(sqrt(x)), isnan(x), isinf(1.0 / (x - x)), isinf(y));", "isnan"
    yield "modf", "float whole; float part = modf(x * 3.3, whole); result = vec4(part, whole, 0.0, 0.0);", "modf"
    yield "bits", "result = vec4(float(floatBitsToInt(x) >> 20), float(floatBitsToUint(y) >> 20), intBitsToFloat(floatBitsToInt(x)), uintBitsToFloat(floatBitsToUint(y)));", "bits"


def operators():
    for size, a, b in [(1, "x", "y"), (2, "a2", "b2"), (3, "a3", "b3"), (4, "a4", "b4")]:
        for name, sign in [("add", "+"), ("sub", "-"), ("mul", "*"), ("div", "/")]:
            yield f"{name}{size}", wide(f"{a} {sign} ({b} + 5.0)", size), name
            if size > 1:
                yield f"{name}{size}_by_number", wide(f"{a} {sign} (x + 5.0)", size), name
                yield f"{name}{size}_of_number", wide(f"x {sign} ({a} + 5.0)", size), name
            yield f"{name}{size}_assigned", f"vec4 r = vec4(0.0); {'float' if size == 1 else f'vec{size}'} v = {a}; v {sign}= {b} + 5.0; " + wide("v", size), name
        yield f"negated{size}", wide(f"-{a}", size), "negated"
    for name, sign in [("less", "<"), ("less_equal", "<="), ("greater", ">"), ("greater_equal", ">="), ("equal", "=="), ("other", "!=")]:
        yield name, wide(f"float(x {sign} y), float(i {sign} j), float(u {sign} w)", 3), name
    for name in ["lessThan", "lessThanEqual", "greaterThan", "greaterThanEqual", "equal", "notEqual"]:
        yield f"{name}_of_vectors", f"result = vec4({name}(a4, b4));", name
        yield f"{name}_whole", wide(f"vec3({name}(i3, ivec3(1, -2, 3)))", 3), name
    yield "truths", "bvec3 t = lessThan(a3, b3); result = vec4(any(t), all(t), not(t).x, x < 0.0 ^^ y < 0.0);", "truths"
    yield "and_or", "result = vec4(x < 0.0 && y < 0.0, x < 0.0 || y < 0.0, !(x < y), x < y ? 2.0 : 3.0);", "and_or"
    yield "vectors_equal", "result = vec4(a2 == b2.yx, a2 != b2, i2 == i2.yx, m2 == m2);", "equal"
    yield "increments", "int k = i; float f = x; result = vec4(k++, ++k, f--, --f);", "increments"
    whole = {"add": "i + j", "sub": "i - j * 3", "mul": "i * j * 1000", "div": "i / (abs(j) + 1)", "mod": "abs(i) % (abs(j) + 1)",
             "and": "i & j", "or": "i | j", "xor": "i ^ j", "not": "~i", "left": "i << (j & 7)", "right": "i >> (j & 3)", "neg": "-i",
             "abs": "abs(i)", "sign": "sign(i)", "min": "min(i, j)", "max": "max(i, j)", "clamp": "clamp(i, -2, j & 7)", "of_float": "int(x * 3.7)"}
    for name, text in whole.items():
        yield f"int_{name}", wide(f"float({text})", 1), "whole"
    natural = {"add": "u + w", "sub": "u - w * 2u", "mul": "u * w * 70001u", "div": "u / w", "mod": "u % w", "and": "u & w", "or": "u | w",
               "xor": "u ^ w", "not": "~u >> 8u", "left": "u << (w & 7u)", "right": "u >> (w & 3u)", "min": "min(u, w)", "max": "max(u, w)",
               "clamp": "clamp(u, 5u, w + 5u)", "of_int": "uint(i + 8)", "hash": "((u * 1103515245u + 12345u) ^ (w << 7u)) >> 9u"}
    for name, text in natural.items():
        yield f"uint_{name}", wide(f"float({text})", 1), "whole"
    yield "whole_vectors", "ivec3 v = i3 * ivec3(1, 2, 3) - i3.zyx; v /= 2; v <<= 1; result = vec4(v, float(v.x == v.y));", "whole"
    yield "natural_vectors", "uvec2 v = u2 * 3u + u2.yx; v ^= uvec2(5u, 6u); result = vec4(v, v % u2);", "whole"


def values():
    for text in ["a4.xyzw", "a4.wzyx", "a4.xxyy", "a4.rgba", "a4.bgra", "a4.stpq", "vec4(a3.zx, a2.yy)", "vec4(a4.www, a4.z)", "a4.wzyx.xy.yxyx"]:
        yield f"swizzle_{text.replace('(', '_').replace(')', '').replace(', ', '_').replace('.', '_')}", f"result = {text};", "swizzle"
    yield "swizzle_written", "vec4 v = a4; v.xz = b2; v.w += 1.0; v.yx = v.xy; result = v;", "swizzle"
    yield "constructors", "result = vec4(vec2(i2), float(u), vec3(b4).y) + vec4(ivec4(a4 * 3.0)) + vec4(bvec4(i2, 1, 0));", "constructors"
    yield "index_constant", "vec4 v = a4; v[2] = b4[1]; result = vec4(v[0], v[1], v[2], v[3]);", "index"
    yield "index_dynamic", "vec4 v = a4; v[j & 3] = 9.0; result = vec4(v[i & 3], v.xyz);", "index"
    matrices = {
        "times_vector": "result = m4 * a4;", "vector_times": "result = a4 * m4;", "times": "result = (m4 * m4)[1];",
        "times_number": "result = (m4 * x)[2];", "plus": "result = (m4 + m4 * 0.5)[3];", "divided": "result = (m4 / (m4 + 20.0))[1];",
        "transpose": "result = transpose(m4)[1];", "component": "result = matrixCompMult(m4, m4)[2];",
        "inverse4": "result = inverse(m4)[1];", "inverse3": "result = vec4(inverse(m3)[2], 0.0);", "inverse2": "result = vec4(inverse(m2 + mat2(5.0)));",
        "determinants": "result = vec4(determinant(m2), determinant(m3), determinant(m4), 0.0);",
        "outer": "result = outerProduct(a4, b4)[2];", "outer23": "mat2x3 m = outerProduct(a3, b2); result = vec4(m[0], m[1].y);",
        "small": "result = vec4(mat2(m4)) + vec4(mat2(m3));", "large": "result = mat4(m3)[3] + mat4(m2)[1];", "diagonal": "result = mat4(x)[1] + vec4(mat2(y));",
        "column": "mat4 m = m4; m[1] = a4; m[2].zw = b2; m[3][1] = 7.0; result = m[0] + m[1] + m[2] + m[3];",
        "dynamic": "result = m4[i & 3] + vec4(m3[j & 1], 0.0);", "mat2x3": "mat2x3 m = mat2x3(a3, b3); result = vec4(m * a2, (b3 * m).y);",
        "mat4x2": "mat4x2 m = mat4x2(a2, b2, a2.yx, b2.yx); result = vec4(m * a4, transpose(m) [1].xy);", "negated": "result = -m4[0] + (-m4)[1];",
        "assigned": "mat3 m = m3; m *= m3; m += m3; m *= 0.5; result = vec4(m[0], m[2].y); vec3 v = a3; v *= m3; result.w += v.x;",
    }
    for name, body in matrices.items():
        yield f"matrix_{name}", body, "matrix"


def flow():
    """(name, body, what, text before main)."""
    yield "if", "if (x < 0.0) result.x = y; else if (y > 1.0) result.x = 2.0; else { result.y = x; }", ""
    yield "for", "for (int k = 0; k < 5; k++) { if (k == 3 && x > 0.0) break; if (k == i) continue; result.x += float(k) * y; }", ""
    yield "for_divergent", "for (int k = 0; k < i + 8; k++) result.x += 1.0 / float(k + 1);", ""
    yield "while", "float t = x + 3.0; while (t > 0.5) { t *= 0.6; result.x += t; }", ""
    yield "do", "int k = 0; do { k += 3; result.x += y; } while (k < i); result.y = float(k);", ""
    yield "nested", "for (int k = 0; k < 4; k++) for (int l = 0; l <= k; l++) { if (l == (j & 3)) break; result[l] += float(k); }", ""
    yield "switch", "switch (i & 3) { case 0: result.x = 1.0; break; case 1: result.y = 2.0; case 2: result.z = 3.0; break; default: result.w = 4.0; }", ""
    yield "switch_default_first", "switch (j) { default: result.x = 9.0; break; case 2: case 3: result.x = y; break; case -1: result.x = x; }", ""
    yield "switch_in_loop", "for (int k = 0; k < 4; k++) { switch (k) { case 1: continue; case 2: result.y += x; break; default: result.x += y; } result.z += 1.0; }", ""
    yield "ternaries", "result.x = x < 0.0 ? (y < 0.0 ? 1.0 : 2.0) : y < 1.0 ? 3.0 : 4.0;", ""
    yield "early_return", "if (x > y) { result = vec4(1.0, x, y, 2.0); return; } result.y = 3.0;", ""
    yield "return_in_loop", "result.x = f(x, y);", "float f(float a, float b) { for (int k = 0; k < 8; k++) { a += 0.5; if (a > b) return a * float(k); } return -1.0; }"
    yield "out_parameters", "float p; float q = y; f(x, p, q); result = vec4(p, q, f2(a3), 0.0);", "void f(in float a, out float b, inout float c) { b = a * 2.0; c += b; a = 9.0; } float f2(vec3 v) { v.x = 5.0; return dot(v, v); }"
    yield "out_of_swizzle", "vec4 v = a4; f(v.yz); float arr[3]; arr[1] = x; g(arr[1]); result = v + arr[1];", "void f(inout vec2 v) { v = v.yx + 1.0; } void g(inout float v) { v *= 3.0; }"
    yield "overloads", "result = vec4(f(x), f(a2), f(i), f(a3).x);", "float f(float a) { return a; } float f(vec2 a) { return a.x + a.y; } float f(int a) { return float(a) * 10.0; } vec3 f(vec3 a) { return a.zyx; }"
    yield "structs", "Light l = Light(a3, y); Light m = l; m.at.y = 4.0; result = vec4(l.at + m.at, change(m).power + m.power);", "struct Light { vec3 at; float power; }; Light change(Light l) { l.power *= 2.0; return l; }"
    yield "struct_in_struct", "B b; b.list[1].v = a2; b.list[0].v = b2; b.one = b.list[i & 1]; result = vec4(b.one.v, b.list[j & 1].v);", "struct A { vec2 v; }; struct B { A list[2]; A one; };"
    yield "structs_equal", "A a = A(a2); A b = A(a2.yx); result.x = float(a == b); result.y = float(a != b);", "struct A { vec2 v; };"
    yield "arrays", "float l[5] = float[5](x, y, 1.0, 2.0, x * y); l[i & 3] += 3.0; for (int k = 0; k < 5; k++) result.x += l[k] * float(k); result.y = l[j & 3]; result.z = float(l.length());", ""
    yield "array_unsized", "float l[] = float[](x, y, 3.0); result = vec4(l[0], l[1], l[i & 1], l.length());", ""
    yield "array_constant", "result.x = table[i & 3]; result.y = table[2]; result.zw = points[j & 1];", "const float table[4] = float[4](0.5, 1.5, 2.5, 4.5); const vec2 points[2] = vec2[2](vec2(1.0, 2.0), vec2(3.0, 4.0));"
    yield "array_returned", "float l[3] = f(x); result = vec4(l[0], l[1], l[2], 0.0);", "float[3] f(float a) { return float[3](a, a * 2.0, a * 3.0); }"
    yield "global", "step_(x); step_(y); result.x = total; result.y = half_;", "float total = 1.0; const float half_ = 0.5; void step_(float a) { total += a * half_; }"
    yield "macros", "result = vec4(TWICE(x), MAD(x, y, 2.0), VALUE, 0.0);", "#define TWICE(a) ((a) * 2.0)\n#define MAD(a, b, c) (a * b + c)\n#if defined(TWICE) && !defined(OTHER)\n#define VALUE 7.0\n#else\n#define VALUE 8.0\n#endif"
    yield "comma", "float k = (x += 1.0, y * x); result = vec4(k, x, 0.0, 0.0);", ""
    yield "short_circuit", "int n = 0; bool t = x < 0.0 && up(n); t = y < 0.0 || up(n); result = vec4(n, t, 0, 0);", "bool up(inout int n) { n++; return n > 0; }"
    yield "short_circuit_loops", "int n = 0; while (x < y && up(n) && n < 4 || n < 1 && up(n)) result.x += 1.0; for (; n < 9 && (y < 0.0 || up(n)); n += 2) result.y += 1.0; result.z = float(n);", "bool up(inout int n) { n++; return n > 0; }"
    yield "short_circuit_global", "bool t = x < 0.0 && next() || y < 0.0 && next() && next(); t = t ^^ (x < y || next()); result = vec4(n, t, 0, 0);", "int n = 0; bool next() { n++; return n > 1; }"
    yield "do_continue", "int k = 0; do { k++; if (k == (i & 3) + 1) continue; result.x += y; } while (k < (i & 3) + 1); result.y = float(k);", ""
    yield "shadowing", "float x2 = x; { float x2 = y; result.x = x2; } result.y = x2; for (int x2 = 0; x2 < 2; x2++) result.z += float(x2);", ""
    yield "dfdx", "result = vec4(dFdx(x * y), dFdy(x * x + y * y), fwidth(x * 0.5), dFdx(a2).y);", ""
    yield "dfdx_of_call", "result = vec4(dFdx(sin(x)), dFdy(floor(y * 2.0)), fwidth(a2));", ""
    yield "varying", "result = vec4(uv, dFdx(uv.x), dFdy(uv.y));", ""


def textures():
    looks = {
        "implicit": "texture(image, uv)", "repeated": "texture(image, uv * 2.0 - 0.7)", "smaller": "texture(image, uv * 5.0)",
        "bias": "texture(image, uv, 1.5)", "level0": "textureLod(image, uv * 0.9 + 0.03, 0.0)", "level15": "textureLod(image, uv, 1.5)",
        "level9": "textureLod(image, uv, 9.0)", "grad": "textureGrad(image, uv, vec2(0.2, 0.0), vec2(0.0, 0.1))",
        "fetch": "texelFetch(image, ivec2(gl_FragCoord.xy), 0)", "fetch2": "texelFetch(image, ivec2(gl_FragCoord.xy) / 4, 2)",
        "offset": "textureOffset(image, uv, ivec2(2, -1))", "lod_offset": "textureLodOffset(image, uv, 0.0, ivec2(-3, 1))",
        "proj": "textureProj(image, vec3(uv, 0.5 + uv.x))", "proj4": "textureProj(image, vec4(uv, 0.0, 2.0))",
        "size": "vec4(textureSize(image, 0), textureSize(image, 2))", "warped": "texture(image, uv * uv * 3.0)",
        "called": "look(image, uv.yx)",
    }
    for name, text in looks.items():
        yield f"texture_{name}", f"result = {text};", "vec4 look(sampler2D s, vec2 at) { return texture(s, at + 0.1); }"


def cubes():
    """Looks at directions inside of faces: along their edges filters differ."""
    inside = "vec2 p = (uv - 0.5) * 1.4;"
    faces = ["vec3(1.0, p)", "vec3(-1.3, p * 1.2)", "vec3(p.x, 0.8, p.y * 0.7)", "vec3(p.x, -1.0, p.y)", "vec3(p, 2.0)", "vec3(p.yx, -0.9)"]
    for i, face in enumerate(faces):
        yield f"cube_{i}", f"{inside} result = texture(cube, {face});"
    # The same face in the whole of a quad.
    chosen = "int k = (j + 7) / 2 % 6; vec3 d = k == 0 ? vec3(1.0, p) : k == 1 ? vec3(-1.0, p) : k == 2 ? vec3(p.x, 1.0, p.y) : k == 3 ? vec3(p.x, -1.0, p.y) : k == 4 ? vec3(p, 1.0) : vec3(p, -1.0);"
    yield "cube_level0", f"{inside} {chosen} result = textureLod(cube, d, 0.0);"
    yield "cube_level15", f"{inside} {chosen} result = textureLod(cube, d * 0.1 + d, 1.5);"
    yield "cube_bias", "result = texture(cube, vec3(uv - 0.5, -1.0), 1.5);"
    yield "cube_grad", "vec2 p = (uv - 0.5); result = textureGrad(cube, vec3(p, 1.0), vec3(0.25, 0.0, 0.0), vec3(0.0, 0.2, 0.1));"
    yield "cube_size", "result = vec4(textureSize(cube, 0), textureSize(cube, 2));"
    yield "cube_called", f"{inside} result = look(cube, vec3(p, 1.0));"


def gathers():
    for c in range(4):
        yield f"gather_{c}", f"result = textureGather(image, uv, {c});"
    yield "gather_red", "result = textureGather(image, uv * 2.0 - 0.3);"
    yield "gather_offset", "result = textureGatherOffset(image, uv, ivec2(2, -1)) + textureGatherOffset(image, uv, ivec2(-3, 0), 2);"
    yield "gather_called", "result = look(image, uv.yx);"


def programs():
    """Name → (text, tolerance, the numbers in double precision or None, whether OpenGL's are exact enough)."""
    all = {}
    for name, body, about in [*functions(), *operators(), *values()]:
        all[name] = (HEAD % ("", body), TOLERANCE, by_double(body) if about in BY_DOUBLE else None, about not in INEXACT)
    for name, body, before in flow():
        all[name] = (HEAD % (before, body), TOLERANCE, None, True)
    for name, body, before in textures():
        short = name.removeprefix("texture_")
        all[name] = (HEAD % (before, body), TEXTURE_TOLERANCE, by_levels(short) if short in BY_LEVEL else None, short not in BY_LEVEL)
    for name, body in cubes():
        before = "uniform samplerCube cube; vec4 look(samplerCube s, vec3 at) { return texture(s, at); }"
        all[name] = (HEAD % (before, body), TEXTURE_TOLERANCE, None, True)
    for name, body in gathers():
        text = HEAD % ("vec4 look(sampler2D s, vec2 at) { const int g = 1; return textureGather(s, at, g); }", body)
        all[name] = (text.replace("330", "400"), TEXTURE_TOLERANCE, None, True)
    return all


def by_double(body):
    """What `result = vec4(f(…), 0.0…);` is, f in double precision of arguments in single precision."""
    call = body.removeprefix("result = vec4(").removesuffix(");")
    while call.endswith(", 0.0"):
        call = call.removesuffix(", 0.0")
    row, column = np.mgrid[0:SIDE, 0:SIDE].astype("f4")
    x, y = (column + np.float32(0.5) - 8) / 4, (row + np.float32(0.5) - 8) / 4
    half, three_quarters = np.float32(0.5), np.full_like(x, 0.75)
    names = {
        "x": [x], "y": [y], "a2": [x, y], "a3": [x, y, x * half + y], "a4": [x, y, x - y, np.full_like(x, 1.5)],
        "b2": [y - np.float32(0.25), x + half], "b3": [y, three_quarters, x], "b4": [y, three_quarters, x, x + y],
    }
    names = {name: np.stack(parts, axis=-1) for name, parts in names.items()}

    def double(function):
        return lambda *arguments: function(*(argument.astype("f8") for argument in arguments))

    numpy_names = {"asin": "arcsin", "acos": "arccos", "asinh": "arcsinh", "acosh": "arccosh", "atanh": "arctanh", "pow": "power"}
    for name in BY_DOUBLE - {"atan", "atan2"}:
        names[name] = double(getattr(np, numpy_names.get(name, name)))
    names["atan"] = lambda *arguments: double(np.arctan if len(arguments) == 1 else np.arctan2)(*arguments)
    with np.errstate(invalid="ignore", divide="ignore"):
        value = eval(call, {"abs": np.abs}, names)
    return np.concatenate([value, np.zeros((SIDE, SIDE, 4 - value.shape[-1]))], axis=-1)


def by_levels(name):
    """What a look into the texture is in double precision, each row of a quad with its own change (OpenGL 4.6, §8.14)."""
    row, column = np.mgrid[0:SIDE, 0:SIDE]
    uv = (np.stack([column, row], axis=-1) + 0.5) / SIDE
    at = {"smaller": uv * 5.0, "warped": uv * uv * 3.0, "proj": uv / (0.5 + uv[..., :1]), "grad": uv}[name]
    even, odd = (row // 2 * 2, row // 2 * 2 + 1), (column // 2 * 2, column // 2 * 2 + 1)
    dx, dy = at[row, odd[1]] - at[row, odd[0]], at[even[1], column] - at[even[0], column]
    if name == "grad":
        dx, dy = np.broadcast_to([0.2, 0.0], at.shape), np.broadcast_to([0.0, 0.1], at.shape)
    moved = np.maximum(np.hypot(*np.moveaxis(dx, -1, 0)), np.hypot(*np.moveaxis(dy, -1, 0))) * SIDE
    levels = [texels().astype("i8")]
    while len(levels[-1]) > 1:
        last = levels[-1]
        levels.append((last[::2, ::2] + last[1::2, ::2] + last[::2, 1::2] + last[1::2, 1::2] + 2) // 4)
    level = np.clip(np.log2(moved), 0, len(levels) - 1)

    def bilinear(texels):
        side = len(texels)
        place = at * side - 0.5
        left = np.floor(place).astype("i8")
        part = (place - left)[..., None]
        texel = lambda i, j: texels[(left[..., 1] + j) % side, (left[..., 0] + i) % side] / 255
        mix = lambda a, b, t: a + (b - a) * t
        return mix(mix(texel(0, 0), texel(1, 0), part[..., 0, :]), mix(texel(0, 1), texel(1, 1), part[..., 0, :]), part[..., 1, :])

    all = np.stack([bilinear(texels) for texels in levels + levels[-1:]])
    fine = np.floor(level).astype("i8")
    pick = lambda n: np.take_along_axis(all, n[None, ..., None], axis=0)[0]
    return pick(fine) + (pick(fine + 1) - pick(fine)) * (level - fine)[..., None]


def texels():
    """By rows from the bottom; the same as in the example `oracle`."""
    y, x = np.mgrid[0:SIDE, 0:SIDE]
    return np.stack([x * 15 + y, y * 15 + x, x * y % 200, 255 - x * 3 - y * 5], axis=-1).astype("u1")


def faces():
    """Of a cube map, by rows from t = 0; the same as in the example `oracle`."""
    return np.stack([texels() // 2 + np.array([20 * face, 100 - 15 * face, 25 * face, 10], "u1") for face in range(6)])


def by_opengl(context, texts):
    cube = context.texture_cube((SIDE, SIDE), 4, faces().tobytes())
    cube.build_mipmaps()
    cube.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
    cube.use(1)
    image = context.texture((SIDE, SIDE), 4, texels().tobytes())
    image.build_mipmaps()
    image.filter = (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR)
    image.repeat_x = image.repeat_y = True
    image.use(0)
    target = context.framebuffer([context.texture((SIDE, SIDE), 4, dtype="f4")])
    target.use()
    for name, (text, *_) in texts.items():
        program = context.program(vertex_shader=VERTEX, fragment_shader=text)
        if "cube" in program:
            program["cube"] = 1
        context.vertex_array(program, []).render(moderngl.TRIANGLES, vertices=3)
        yield name, np.frombuffer(target.read(components=4, dtype="f4"), "f4").reshape(SIDE, SIDE, 4)


def by_us(texts):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, (text, *_) in texts.items():
            (folder / f"{name}.frag").write_text(text)
        subprocess.run([os.environ["GLANZ_ORACLE"], folder], check=True)
        for name in texts:
            error = folder / f"{name}.error"
            if error.exists():
                yield name, error.read_text()
            else:
                yield name, np.fromfile(folder / f"{name}.f32", "f4").reshape(SIDE, SIDE, 4)


def difference(ours, theirs, tolerance):
    """The greatest difference, 1 for the tolerance."""
    ours, theirs = ours.astype("f8"), theirs.astype("f8")
    same = (ours == theirs) | (np.isnan(ours) & np.isnan(theirs))
    scale = np.ones_like(theirs) if tolerance == TEXTURE_TOLERANCE else np.maximum(np.abs(theirs), SMALL)
    with np.errstate(invalid="ignore"):
        part = np.abs(ours - theirs) / (scale * tolerance)
    return float(np.where(same, 0.0, np.where(np.isnan(part), np.inf, part)).max())


class Shaders(unittest.TestCase):
    def test_all_programs_give_the_numbers_of_opengl(self):
        texts = programs()
        context = moderngl.create_standalone_context(backend="egl")
        print(f"{len(texts)} programs against {context.info['GL_RENDERER']}")
        theirs = dict(by_opengl(context, texts))
        wrong = []
        for name, ours in by_us(texts):
            if isinstance(ours, str):
                wrong.extend([] if name in KNOWN else [f"{name}: {ours}"])
                continue
            _, tolerance, exact, agrees = texts[name]
            references = {"OpenGL": theirs[name]} if agrees else {}
            references |= {} if exact is None else {"double precision": exact}
            if exact is not None and "GLANZ_SHOW_EXACT" in os.environ:
                errors = [difference(values, exact, tolerance) * tolerance for values in (ours, theirs[name])]
                print(f"{name}: ours {errors[0]:.2g}, OpenGL's {errors[1]:.2g} from double precision")
            worst = max(difference(ours, expected, tolerance) for expected in references.values())
            if name in KNOWN:
                wrong.extend([f"{name} agrees now: take it off the list"] if worst <= 1.0 else [])
            for reference, expected in references.items() if name not in KNOWN else []:
                worst = difference(ours, expected, tolerance)
                if worst > 1.0:
                    at = np.unravel_index(np.argmax(np.nan_to_num(np.abs(ours - expected), nan=np.inf)), ours.shape)
                    wrong.append(f"{name}: {worst:.3g} tolerances, at {at}: {ours[at]!r} for {expected[at]!r} of {reference}")
        self.assertEqual([], wrong, "\n" + "\n".join(wrong))


if __name__ == "__main__":
    unittest.main()
