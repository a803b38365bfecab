//! From the tables of lights to lights: geometry, strength, luminaires and environments.

mod environment;
mod keys;
mod kinds;
mod luminaires;
mod strength;
mod surfaces;
