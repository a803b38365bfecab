//! The eye: what another person sees of a scene, at another age, by another light, and why.

