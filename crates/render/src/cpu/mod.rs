//! The rasteriser.
