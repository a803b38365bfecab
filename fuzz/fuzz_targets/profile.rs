//! The readers of luminaire profiles: the first byte chooses between LM-63 and EULUMDAT.

#![no_main]

use glanz_scene::read::read_profile;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((first, bytes)) = bytes.split_first() else { return };
    match read_profile(bytes, if first % 2 == 0 { "file.ies" } else { "file.ldt" }) {
        Ok((profile, _)) => {
            assert_eq!(profile.candela.len(), profile.c_deg.len() * profile.gamma_deg.len());
            assert!(profile.candela.iter().all(|value| value.is_finite() && *value >= 0.0));
            for angles in [&profile.c_deg, &profile.gamma_deg] {
                assert!(!angles.is_empty() && angles.windows(2).all(|pair| pair[0] < pair[1]));
            }
            assert!(profile.at(217.0, 31.0) <= profile.max() * (1.0 + 1e-12));
        }
        Err(error) => assert!(error.to_string().contains(": expected ")),
    }
});
