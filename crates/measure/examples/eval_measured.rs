//! The BRDF times the cosine of the detector's angle of a file of measured reflectance, for pairs of directions: each line on
//! standard input has θi, φi, θo and φo in degrees, each line that is printed one number per channel.
//!
//!     cargo run -p glanz-measure --example eval_measured -- FILE < DIRECTIONS

#![expect(clippy::print_stdout, reason = "what is asked for goes to stdout")]

use std::error::Error;
use std::io::BufRead;

use glanz_math::Vec3;
use glanz_measure::Measured;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("a file is expected")?;
    let measured = Measured::read(&std::fs::read(&file)?, &file, &Default::default())?;
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let angles: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse::<f64>).collect();
        let [theta_i, phi_i, theta_o, phi_o] = angles?[..] else {
            return Err("four angles are expected".into());
        };
        let at = |theta: f64, phi: f64| Vec3::from_angles(theta.to_radians(), phi.to_radians());
        let (wi, wo) = (at(theta_i, phi_i), at(theta_o, phi_o));
        let value = measured.value(wi, wo).ok_or("there is no value for these directions")?;
        let words: Vec<String> = value.iter().map(|f| (f * wo.z).to_string()).collect();
        println!("{}", words.join(" "));
    }
    Ok(())
}
