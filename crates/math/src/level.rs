//! Which SIMD instructions to use.

use fearless_simd::Level;

/// `GLANZ_SIMD` names a level that this machine or this build does not have.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LevelError {
    /// What the variable held.
    pub asked: String,
}

impl core::fmt::Display for LevelError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(
            f,
            "GLANZ_SIMD is '{}', but must be one of scalar, sse4.2, avx2, avx512, neon, simd128 that this processor has",
            self.asked
        )
    }
}

impl core::error::Error for LevelError {}

/// The best level of this machine, or the one that `asked` (the variable `GLANZ_SIMD`) forces.
///
/// Pictures are the same bits on every level; the variable exists to test that, and to measure.
pub fn simd_level(asked: Option<&str>) -> Result<Level, LevelError> {
    let best = Level::new();
    let Some(name) = asked.filter(|name| !name.is_empty()) else {
        return Ok(best);
    };
    let found = match name {
        "scalar" => Some(scalar()),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        "sse4.2" => best.as_sse4_2().map(Level::Sse4_2),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        "avx2" => best.as_avx2().map(Level::Avx2),
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        "avx512" => best.as_avx512().map(Level::Avx512),
        #[cfg(target_arch = "aarch64")]
        "neon" => best.as_neon().map(Level::Neon),
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        "simd128" => best.as_wasm_simd128().map(Level::WasmSimd128),
        _ => None,
    };
    found.ok_or_else(|| LevelError { asked: name.to_owned() })
}

/// Plain Rust without any SIMD instruction.
fn scalar() -> Level {
    Level::Fallback(fearless_simd::Fallback::new())
}

/// Runs `$body` compiled for `$level`, with `$simd` as the level's token, like
/// [`fearless_simd::dispatch!`] but for the levels that Glanz distinguishes only: SSE2, which every
/// x86-64 has, counts as scalar. Each level is a copy of all code below it, so fewer are better.
#[macro_export]
macro_rules! at_level {
    ($level:expr, $simd:ident => $body:expr) => {{
        use $crate::simd::{Level, Simd as _};
        match $level {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512($simd) => $simd.vectorize(
                #[inline(always)]
                || $body,
            ),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2($simd) => $simd.vectorize(
                #[inline(always)]
                || $body,
            ),
            #[cfg(target_arch = "aarch64")]
            Level::Neon($simd) => $simd.vectorize(
                #[inline(always)]
                || $body,
            ),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Level::WasmSimd128($simd) => $simd.vectorize(
                #[inline(always)]
                || $body,
            ),
            level => {
                let $simd = $crate::narrowest(level);
                $simd.vectorize(
                    #[inline(always)]
                    || $body,
                )
            }
        }
    }};
}

/// The level for machines, or builds, without any that [`at_level!`] names.
#[cfg(target_arch = "x86_64")]
#[doc(hidden)]
#[inline(always)]
pub fn narrowest(_: Level) -> fearless_simd::Sse2 {
    Level::baseline().as_sse2().expect("every x86-64 has SSE2")
}

/// The level for machines, or builds, without any that [`at_level!`] names.
#[cfg(not(target_arch = "x86_64"))]
#[doc(hidden)]
#[inline(always)]
pub fn narrowest(_: Level) -> fearless_simd::Fallback {
    fearless_simd::Fallback::new()
}
