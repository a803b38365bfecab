"""Lobe shapes and Fresnel's laws, against Mitsuba 3 as an independent oracle.

`cargo xtask test` runs this; by hand: `cargo build -p glanz-bsdf --example eval`, then
`GLANZ_EVAL=target/debug/examples/eval python -m unittest tests/python/test_models.py` in an environment with
tests/python/requirements-models.txt.

Mitsuba's `eval` includes the cosine of its `wo`, which is the direction of the light, as `f_cos` includes that of `wi`;
its `si.wi` points to the viewer. It multiplies two independent shares G1 where Glanz has the share of correlated heights
in reflection: the quotient of both is formed from Mitsuba's own G1.
"""

import os
import subprocess
import unittest

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")

EVAL = os.environ.get("GLANZ_EVAL", "target/debug/examples/eval")
COUNT = 10_000
# Mitsuba computes in single precision (no variant in double precision is shipped): 6e-8 in a cosine, of which the narrowest
# lobe here, of width 0.1 and with tails down to exp(-25), makes some 1e-5.
RELATIVE = 1e-4
# In 1/sr, where both count as dark.
DARK = 1e-10

# Towards the angle of total reflection 1 - F is a small difference, and single precision keeps less of it.
DARK_THROUGH = 2e-6

KINDS = ["ggx", "beckmann"]
WIDTHS = [(0.1, 0.1), (0.3, 0.3), (0.1, 0.3)]


def glanz(name, wo, wi, **values):
    """f_cos and tint cosine of all pairs; a length that rounding made other than 1 is none of the direction."""
    wo, wi = unit(wo), unit(wi)
    rows = "\n".join(",".join(repr(float(x)) for x in [*o, *i]) for o, i in zip(wo, wi)) + "\n"
    command = [EVAL, name, *(f"{key}={value}" for key, value in values.items())]
    run = subprocess.run(command, input=rows, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: {run.stderr}")
    return np.array([[float(x) for x in line.split(",")] for line in run.stdout.split()]).T


def fresnel(cosines, eta):
    return reflectance("fresnel-dielectric", cosines, eta=eta)


def reflectance(law, cosines, **values):
    tilted = np.stack([np.sqrt(1 - cosines**2), np.zeros_like(cosines), cosines], axis=1)
    return glanz(law, tilted, tilted, **values)[0]


def unit(v):
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def single(v):
    """Rounded to what Mitsuba computes in."""
    return unit(v).astype(np.float32).astype(np.float64)


def facets(random, alpha):
    """Normals with slopes about the width, and some far beyond."""
    slopes = random.normal(0.0, 1.0, (COUNT, 2)) * np.array(alpha) * random.uniform(0.2, 3.0, (COUNT, 1))
    return unit(np.concatenate([slopes, np.ones((COUNT, 1))], axis=1))


def upper(random):
    z = random.uniform(0.02, 1.0, COUNT)
    phi = random.uniform(0.0, 2 * np.pi, COUNT)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=1)


def reflections(seed, alpha):
    """Pairs above the surface: half of them about the mirror direction, half anywhere."""
    random = np.random.default_rng(seed)
    wo, h = upper(random), facets(random, alpha)
    mirrored = 2 * np.sum(wo * h, axis=1, keepdims=True) * h - wo
    about = (mirrored[:, 2] > 0.02) & (random.uniform(size=COUNT) < 0.5)
    return single(wo), single(np.where(about[:, None], mirrored, upper(random)))


def refractions(seed, alpha, eta):
    """Pairs on two sides, through facets about the normal; eta is below over above."""
    random = np.random.default_rng(seed)
    wo, h = upper(random), facets(random, alpha)
    cosine = np.sum(wo * h, axis=1, keepdims=True)
    below = 1 - (1 - cosine**2) / eta**2
    bent = (cosine / eta - np.sqrt(np.maximum(below, 0))) * h - wo / eta
    sound = (below[:, 0] > 0) & (cosine[:, 0] > 0) & (bent[:, 2] < -0.02)
    anywhere = upper(random) * np.array([1, 1, -1])
    return single(wo), single(np.where(sound[:, None], bent, anywhere))


def mitsuba(bsdf, wo, wi):
    context, interaction = mi.BSDFContext(), mi.SurfaceInteraction3f()
    values = np.zeros(len(wo))
    for n, (o, i) in enumerate(zip(wo, wi)):
        interaction.wi = mi.Vector3f(*o)
        values[n] = bsdf.eval(context, interaction, mi.Vector3f(*i))[0]
    return values


def correlated(kind, alpha, wo, wi, h):
    """Share of correlated heights over the product of both shares."""
    types = {"ggx": mi.MicrofacetType.GGX, "beckmann": mi.MicrofacetType.Beckmann}
    distribution = mi.MicrofacetDistribution(types[kind], *alpha, True)
    g = np.array(
        [
            [distribution.smith_g1(mi.Vector3f(*w), mi.Vector3f(*m)) for w in (o, i)]
            for o, i, m in zip(wo, wi, h)
        ]
    )
    g = np.where(g > 0, g, 1.0)
    return 1 / (1 / g[:, 0] + 1 / g[:, 1] - 1) / (g[:, 0] * g[:, 1])


class Case(unittest.TestCase):
    def alike(self, got, expected, what, dark=DARK):
        wrong = np.abs(got - expected) - RELATIVE * np.abs(expected)
        n = np.argmax(wrong)
        self.assertLess(wrong[n], dark, f"{what}: {got[n]} for {expected[n]} at pair {n}")
        # The comparison means nothing where all is dark.
        self.assertGreater(np.sum(expected > 1e-3), COUNT / 10, what)


class Reflection(Case):
    def test_rough_conductors_are_microfacets_without_the_energy_of_further_reflections(self):
        for kind in KINDS:
            for alpha in WIDTHS:
                with self.subTest(kind=kind, alpha=alpha):
                    wo, wi = reflections(1, alpha)
                    bsdf = mi.load_dict(
                        {
                            "type": "roughconductor",
                            "distribution": kind,
                            "alpha_u": alpha[0],
                            "alpha_v": alpha[1],
                            "material": "none",
                        }
                    )
                    expected = mitsuba(bsdf, wo, wi) * correlated(kind, alpha, wo, wi, unit(wo + wi))
                    got = glanz(kind, wo, wi, alpha=alpha[0], alpha_y=alpha[1], multiscatter=0)[0]
                    self.alike(got, expected, "reflection")

    def test_the_gloss_of_rough_plastic_is_microfacets_tinted_by_fresnel(self):
        for kind in KINDS:
            for alpha in [0.1, 0.3]:
                with self.subTest(kind=kind, alpha=alpha):
                    wo, wi = reflections(2, (alpha, alpha))
                    bsdf = mi.load_dict(
                        {
                            "type": "roughplastic",
                            "distribution": kind,
                            "alpha": alpha,
                            "int_ior": 1.5,
                            "ext_ior": 1.0,
                            "diffuse_reflectance": {"type": "rgb", "value": 0.0},
                        }
                    )
                    both = (alpha, alpha)
                    expected = mitsuba(bsdf, wo, wi) * correlated(kind, both, wo, wi, unit(wo + wi))
                    f_cos, cosine = glanz(kind, wo, wi, alpha=alpha, multiscatter=0)
                    self.alike(f_cos * fresnel(cosine, 1.5), expected, "gloss")

    def test_rough_glass_reflects_as_microfacets_tinted_by_fresnel(self):
        for kind in KINDS:
            for alpha in [0.1, 0.3]:
                with self.subTest(kind=kind, alpha=alpha):
                    wo, wi = reflections(3, (alpha, alpha))
                    expected = mitsuba(glass(kind, alpha, 1.5), wo, wi)
                    expected *= correlated(kind, (alpha, alpha), wo, wi, unit(wo + wi))
                    f_cos, cosine = glanz(kind, wo, wi, alpha=alpha, multiscatter=0)
                    self.alike(f_cos * fresnel(cosine, 1.5), expected, "glass, reflection")


def glass(kind, alpha, eta):
    return mi.load_dict(
        {"type": "roughdielectric", "distribution": kind, "alpha": alpha, "int_ior": eta, "ext_ior": 1.0}
    )


class Transmission(Case):
    def test_rough_glass_transmits_radiance_from_the_denser_side(self):
        self.through(1.5, lambda wo, wi: (wo, wi))

    def test_rough_glass_transmits_radiance_from_the_thinner_side(self):
        # Mitsuba's viewer is below the surface then: both directions turned over.
        over = np.array([1, 1, -1])
        self.through(1 / 1.5, lambda wo, wi: (wo * over, wi * over))

    def through(self, eta, turned):
        for kind in KINDS:
            for alpha in [0.1, 0.3]:
                with self.subTest(kind=kind, alpha=alpha, eta=eta):
                    wo, wi = refractions(4, (alpha, alpha), eta)
                    expected = mitsuba(glass(kind, alpha, 1.5), *turned(wo, wi))
                    f_cos, cosine = glanz(f"{kind}-transmission", wo, wi, alpha=alpha, eta=eta)
                    self.alike(f_cos * (1 - fresnel(cosine, eta)), expected, "transmission", DARK_THROUGH)


class Fresnel(Case):
    def test_dielectrics_reflect_alike_from_both_sides(self):
        cosines = single_numbers(np.random.default_rng(5).uniform(0.0, 1.0, COUNT))
        for eta in [1.33, 1.5, 2.4, 1 / 1.5]:
            expected = np.array([mi.fresnel(float(c), eta)[0] for c in cosines])
            self.alike(fresnel(cosines, eta), expected, f"eta = {eta}")

    def test_conductors_reflect_alike(self):
        cosines = single_numbers(np.random.default_rng(6).uniform(0.0, 1.0, COUNT))
        for eta, k in [(0.2, 3.4), (1.5, 3.0), (2.9, 3.1), (0.05, 4.2)]:
            complex_eta = mi.Complex2f(eta, k)
            expected = np.array([mi.fresnel_conductor(float(c), complex_eta) for c in cosines])
            self.alike(reflectance("fresnel-conductor", cosines, eta=eta, k=k), expected, f"{eta}, {k}")


def single_numbers(values):
    return values.astype(np.float32).astype(np.float64)


if __name__ == "__main__":
    unittest.main()
