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
            "GLANZ_SIMD is '{}', but must be one of sse2, avx2, avx512, neon, simd128 that this processor has, or scalar where it has none",
            self.asked
        )
    }
}

impl core::error::Error for LevelError {}

/// The name of the level with the narrowest vectors that this build has.
pub const NARROWEST_LEVEL: &str = if cfg!(target_arch = "x86_64") { "sse2" } else { "scalar" };

/// The best level of this machine, or the one that `asked` (the variable `GLANZ_SIMD`) forces.
///
/// Pictures are the same bits on every level; the variable exists to test that, and to measure. The
/// narrowest level is `sse2` on x86-64, `scalar` on targets whose vectors Glanz does not know.
pub fn simd_level(asked: Option<&str>) -> Result<Level, LevelError> {
    let best = Level::new();
    let Some(name) = asked.filter(|name| !name.is_empty()) else {
        return Ok(best);
    };
    let found = match name {
        #[cfg(target_arch = "x86_64")]
        "sse2" => best.as_sse2().map(Level::Sse2),
        #[cfg(not(target_arch = "x86_64"))]
        "scalar" => Some(Level::Fallback(fearless_simd::Fallback::new())),
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

/// Runs `$body` compiled for `$level`, with `$simd` as the level's token, like
/// [`fearless_simd::dispatch!`] but for fewer levels: each is a copy of all code below it. On x86-64 these
/// are SSE2, which every such processor has, AVX2 and AVX-512. A copy without any vectors would take
/// the compiler longer than the other three together, and nobody would run it.
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
