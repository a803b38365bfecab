//! Which laws of physics does a model keep with these parameters?
//!
//!     cargo run --example certify [-- MODEL]
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use glanz::bsdf::laws::{Law, Verdict, certify};
use glanz::{Error, Shape};

fn main() -> Result<(), Error> {
    let model = std::env::args().nth(1).unwrap_or_else(|| "phong".to_owned());
    let certificate = certify(&Shape::named(&model, &[])?);
    println!("{certificate}");
    let reciprocity = &certificate.finding(Law::Reciprocity).verdict;
    if let Verdict::Broken { known: Some(reason) } = reciprocity {
        println!("It is known that it is not reciprocal: {reason}");
    }
    Ok(())
}
