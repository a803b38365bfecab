//! The eye: what another person sees of a scene, at another age, by another light, and why.

/// Formulas of the eye in closed form: pupil, mesopic luminance, glare, contrast sensitivity, response, Mach bands, retina.
pub mod curves;
