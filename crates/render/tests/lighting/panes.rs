//! What is seen through surfaces.

use std::sync::Arc;

use common::{glow, pixel_camera, sampled};
use glanz_bsdf::terms::fresnel_slab;
use glanz_color::{Ior, Spectrum, rgb_spectra};
use glanz_render::{DrawOptions, Frame};
use glanz_scene::{Background, Pane, Transmittance};

use super::*;

/// A pane of glass of so many mm; green takes the rest away.
fn glass(mm: f64) -> Material {
    let mut per_m = rgb_spectra::spectrum_of_reflectance(Rgb([0.2, 0.9, 0.3]));
    per_m = per_m.map(|left| -(left.max(1e-3).ln()) * 100.0);
    let pane = Pane { ior: Ior::constant(1.5), thickness: mm * 1e-3, absorption: per_m };
    Material {
        transmittance: Some(Transmittance::Pane(Arc::new(pane))),
        ..Material::of_lobes("glass", Vec::new())
    }
}

/// A glowing wall behind panes at these depths, added to the scene in this order.
fn wall_behind(panes: &[(f32, Material)], samples: u32) -> Frame {
    let mut scene = empty(pixel_camera(8, 8));
    add(&mut scene, rectangle([0.0, 0.0, 8.0, 8.0], -5.0), glow(Rgb([0.8, 0.6, 0.4])), DMat4::IDENTITY);
    for (z, material) in panes {
        add(&mut scene, rectangle([0.3, 0.3, 7.7, 7.7], *z), material.clone(), DMat4::IDENTITY);
    }
    picture(&scene, 8, 8, &sampled(samples))
}

fn middle(frame: &Frame) -> [f32; 3] {
    [0, 1, 2].map(|c: usize| frame.rgb[c][4 * 8 + 4])
}

#[test]
fn clear_glass_lets_through_what_it_does_not_reflect() {
    let pane = Pane { ior: Ior::constant(1.5), thickness: 0.004, absorption: Spectrum::ZERO };
    let clear = Material {
        transmittance: Some(Transmittance::Pane(Arc::new(pane))),
        ..Material::of_lobes("glass", Vec::new())
    };
    let expected = fresnel_slab(1.0, 1.5, 1.0).1;
    for (got, wall) in middle(&wall_behind(&[(0.0, clear)], 1)).iter().zip([0.8, 0.6, 0.4]) {
        assert!((f64::from(*got) - wall * expected).abs() < 1e-5, "{got}");
    }
}

#[test]
fn panes_are_the_same_in_any_order_and_with_any_number_of_samples() {
    let (thin, thick) = ((1.0, glass(2.0)), (2.0, glass(7.0)));
    let one = wall_behind(&[thin.clone(), thick.clone()], 1);
    let other = wall_behind(&[thick.clone(), thin.clone()], 1);
    assert_eq!(one.rgb, other.rgb);
    for samples in [2, 4, 16] {
        let many = wall_behind(&[thin.clone(), thick.clone()], samples);
        for (one, many) in middle(&one).iter().zip(middle(&many)) {
            assert!((one - many).abs() < 1e-6, "{samples}: {many} for {one}");
        }
    }
}

#[test]
fn thickness_absorbs_as_beer_and_lambert_say() {
    let gray = |mm: f64| {
        let pane =
            Pane { ior: Ior::constant(1.5), thickness: mm * 1e-3, absorption: Spectrum::constant(150.0) };
        Material {
            transmittance: Some(Transmittance::Pane(Arc::new(pane))),
            ..Material::of_lobes("gray", Vec::new())
        }
    };
    for mm in [0.0, 2.0, 5.0] {
        let expected = fresnel_slab(1.0, 1.5, f64::exp(-0.15 * mm)).1;
        for (got, wall) in middle(&wall_behind(&[(0.0, gray(mm))], 1)).iter().zip([0.8, 0.6, 0.4]) {
            assert!((f64::from(*got) - wall * expected).abs() < 1e-5, "{mm} mm: {got}");
        }
    }
    let green = middle(&wall_behind(&[(0.0, glass(3.0))], 1));
    assert!(green[0] / 0.8 < 0.9 * green[1] / 0.6 && green[2] / 0.4 < 0.9 * green[1] / 0.6, "{green:?}");
}

#[test]
fn a_tint_lets_through_its_share_of_each_channel() {
    let mut tinted = Material::of_lobes("foil", Vec::new());
    tinted.transmittance = Some(Transmittance::Constant(Rgb([0.5, 0.25, 1.0]).into()));
    for samples in [1, 4] {
        let seen = middle(&wall_behind(&[(0.0, tinted.clone())], samples));
        for (got, expected) in seen.iter().zip([0.4, 0.15, 0.4]) {
            assert!((got - expected).abs() < 1e-6, "{seen:?}");
        }
    }
}

#[test]
fn behind_glass_nothing_but_the_background_is_covered_partly() {
    let mut scene = empty(pixel_camera(4, 4));
    let mut half = Material::of_lobes("foil", Vec::new());
    half.transmittance = Some(Transmittance::Constant(Rgb([0.25, 0.5, 0.75]).into()));
    add(&mut scene, rectangle([0.0, 0.0, 4.0, 4.0], 0.0), half, DMat4::IDENTITY);
    for samples in [1, 4] {
        let frame = picture(&scene, 4, 4, &sampled(samples));
        assert!(
            (frame.alpha[5] - 0.25).abs() < 1e-6,
            "as opaque as its clearest channel: {}",
            frame.alpha[5]
        );
    }
}

#[test]
fn over_an_opaque_background_coloured_panes_leave_no_hole() {
    let foil = |rgb: [f32; 3]| {
        let transmittance = Some(Transmittance::Constant(Rgb(rgb).into()));
        Material { transmittance, ..Material::of_lobes("foil", Vec::new()) }
    };
    let mut scene = empty(pixel_camera(8, 8));
    // The greatest channel is another behind each: coverage must not be counted channel by channel.
    for (z, rgb) in [(0.0, [0.9, 0.5, 0.5]), (1.0, [0.5, 0.5, 0.9])] {
        add(&mut scene, rectangle([0.3, 0.3, 7.7, 6.4], z), foil(rgb), DMat4::IDENTITY);
    }
    for samples in [1, 4, 16] {
        let options = DrawOptions {
            samples: samples.try_into().unwrap(),
            ..DrawOptions::new(Background::Color(Rgb([0.4, 0.6, 0.8])))
        };
        let frame = picture(&scene, 8, 8, &options);
        assert!(frame.alpha.iter().all(|alpha| (alpha - 1.0).abs() < 1e-6), "{samples}: {:?}", frame.alpha);
        for (got, expected) in middle(&frame).iter().zip([0.4 * 0.45, 0.6 * 0.25, 0.8 * 0.45]) {
            assert!((got - expected).abs() < 1e-6, "{samples}: {got} for {expected}");
        }
    }
}
