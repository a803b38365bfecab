//! Which SIMD instructions to use.

use fearless_simd::Level;

/// The processor, or the build, does not have a SIMD level of this name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LevelError {
    /// The name that was asked for.
    pub asked: String,
}

impl core::fmt::Display for LevelError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(
            f,
            "the SIMD level is '{}', but must be one of sse2, avx2, avx512, neon, simd128 that this processor has, \
             or scalar where it has none",
            self.asked
        )
    }
}

impl core::error::Error for LevelError {}

/// A set of vector instructions that this machine has. Results are the same bits on every one; the choice is
/// for tests and measurements.
///
/// ```
/// use glanz_math::SimdLevel;
///
/// let (name, narrowest) = SimdLevel::available()[0];
/// assert_eq!(SimdLevel::named(name)?.name(), narrowest.name());
/// # Ok::<(), glanz_math::LevelError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SimdLevel(Level);

/// The names of all levels, from the narrowest vectors to the widest.
const NAMES: [&str; 6] = ["scalar", "sse2", "neon", "simd128", "avx2", "avx512"];

impl Default for SimdLevel {
    fn default() -> Self {
        Self::best()
    }
}

impl SimdLevel {
    /// The best level of this machine.
    pub fn best() -> Self {
        Self(Level::new())
    }

    /// The level with the narrowest vectors: `sse2` on x86-64, which every such processor has; `scalar` on targets
    /// whose vectors Glanz does not know.
    pub fn narrowest() -> Self {
        Self::available()[0].1
    }

    /// All levels of this machine with their names, the narrowest first.
    pub fn available() -> Vec<(&'static str, Self)> {
        NAMES.into_iter().filter_map(|name| Some((name, Self::named(name).ok()?))).collect()
    }

    /// The level of this name.
    pub fn named(name: &str) -> Result<Self, LevelError> {
        let found = match name {
            #[cfg(target_arch = "x86_64")]
            "sse2" => Level::new().as_sse2().map(Level::Sse2),
            #[cfg(not(target_arch = "x86_64"))]
            "scalar" => Some(Level::Fallback(fearless_simd::Fallback::new())),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            "avx2" => Level::new().as_avx2().map(Level::Avx2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            "avx512" => Level::new().as_avx512().map(Level::Avx512),
            #[cfg(target_arch = "aarch64")]
            "neon" => Level::new().as_neon().map(Level::Neon),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            "simd128" => Level::new().as_wasm_simd128().map(Level::WasmSimd128),
            _ => None,
        };
        found.map(Self).ok_or_else(|| LevelError { asked: name.to_owned() })
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self.0 {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512(_) => "avx512",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2(_) => "avx2",
            #[cfg(target_arch = "aarch64")]
            Level::Neon(_) => "neon",
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Level::WasmSimd128(_) => "simd128",
            _ if cfg!(target_arch = "x86_64") => "sse2",
            _ => "scalar",
        }
    }

    /// The level of this token.
    #[inline(always)]
    pub(crate) fn of(level: Level) -> Self {
        Self(level)
    }

    /// What [`at_level!`](crate::at_level) dispatches on.
    #[doc(hidden)]
    #[inline(always)]
    pub fn token(self) -> Level {
        self.0
    }
}

/// Runs `$body` compiled for `$level`, with `$simd` as the level's token, like
/// [`fearless_simd::dispatch!`] but for fewer levels: each is a copy of all code below it. On x86-64 these
/// are SSE2, which every such processor has, AVX2 and AVX-512. A copy without any vectors would take
/// the compiler longer than the other three together, and nobody would run it.
#[macro_export]
macro_rules! at_level {
    ($level:expr, $simd:ident => $body:expr) => {{
        use $crate::simd::{Level, Simd as _};
        match $crate::SimdLevel::token($level) {
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
