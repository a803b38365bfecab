//! Fits as materials of scene files.

use std::fmt::Write as _;

use glanz_measure::{Channels, Fit, FittedLobe};

/// A scene file with the fit as a material; nothing for channels that are no colours.
///
/// A lobe in Schlick's form is two lobes of one shape, of which one is weighed by 1 − u⁵ and the other by u⁵: so both tints
/// may have any colour. Pictures evaluate the shape once.
pub(super) fn material(channels: &Channels, fit: &Fit) -> Option<String> {
    let mut text = String::from("# Fitted by glanz measure fit.\n\n[materials.fitted]\n");
    if let Some(degrees) = fit.aniso_deg {
        writeln!(text, "aniso_deg = {degrees:.3}").expect("a string takes everything");
    }
    text += "lobes = [\n";
    for lobe in &fit.lobes {
        let parts = lobe.tints().zip([(1, 0), (0, 1)]);
        for (tint, (at_zero, at_grazing)) in parts.filter(|(tint, _)| tint.iter().any(|tint| *tint > 0.0)) {
            let layer = format!(
                ", layers = [{{ schlick = {{ angle = \"half\", at_zero = {at_zero}, at_grazing = {at_grazing} }} }}]"
            );
            let layer = if lobe.tint_at_grazing.is_some() { layer } else { String::new() };
            let tint = self::tint(channels, tint)?;
            writeln!(text, "    {{ {}, tint = {tint}{layer} }},", shape(lobe))
                .expect("a string takes everything");
        }
    }
    text += "]\n";
    Some(text)
}

/// `shape = "ggx", alpha = 0.2`
fn shape(lobe: &FittedLobe) -> String {
    let parameters = lobe.parameters.iter().map(|parameter| (parameter.name, parameter.value));
    let set = parameters.map(|(name, value)| format!(", {name} = {value:.6}")).collect::<String>();
    format!("shape = \"{}\"{set}", lobe.shape.info().name)
}

fn tint(channels: &Channels, tint: &[f64]) -> Option<String> {
    let list = |values: &[f64]| values.iter().map(|x| format!("{x:.6}")).collect::<Vec<_>>().join(", ");
    Some(match channels {
        Channels::Luminance => format!("{:.6}", tint[0]),
        Channels::Rgb => format!("[{}]", list(tint)),
        Channels::Wavelengths(nm) => {
            let nm = nm.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
            format!("{{ nm = [{nm}], value = [{}] }}", list(tint))
        }
        Channels::Xyz => return None,
    })
}
