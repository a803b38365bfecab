//! Every way to fail: one message that names what is wrong, and the right exit code.

use crate::folder::{Folder, SCENE, command};

/// Snapshots the failure of `glanz render` with these words on the usual scene.
macro_rules! fails {
    ($($name:ident: $words:expr;)+) => {
        $(#[test]
        fn $name() {
            let folder = Folder::with_scene();
            let before = folder.names();
            insta::assert_snapshot!(folder.glanz(&$words).failure());
            assert_eq!(folder.names(), before, "a failure leaves no file behind");
        })+
    };
}

fails! {
    no_command: ["draw", "scene.toml"];
    no_input: ["render"];
    a_missing_scene: ["render", "none.toml", "-o", "a.png"];
    a_missing_model: ["render", "none.glb", "-o", "a.png"];
    a_missing_scene_for_info: ["info", "none.toml"];
    a_file_that_is_neither_scene_nor_model: ["render", ".", "-o", "a.png"];
    a_size_that_is_none: ["render", "scene.toml", "--size", "wide"];
    a_size_of_zero: ["render", "scene.toml", "--size", "0x600"];
    a_size_beyond_all_measure: ["render", "scene.toml", "--size", "1000000000x1000000000"];
    a_size_beyond_all_measure_set_in_the_scene: ["render", "scene.toml", "--set", "image.width=1000000000"];
    an_unknown_model_of_highlights: ["render", "scene.toml", "--model", "blin-phong"];
    an_unknown_view: ["render", "scene.toml", "--show", "normal"];
    a_number_of_samples_that_is_none: ["render", "scene.toml", "--samples", "3"];
    an_assignment_without_a_value: ["render", "scene.toml", "--set", "image.width"];
    a_value_that_does_not_fit: ["render", "scene.toml", "--set", "materials.ball.shininess=high"];
    a_path_that_leads_nowhere: ["render", "scene.toml", "--set", "materials.ball.shinyness=3"];
    an_output_folder_that_is_missing: ["render", "scene.toml", "-o", "none/a.png"];
    an_output_that_is_a_folder: ["render", "scene.toml", "-o", "."];
    an_output_of_unknown_format: ["render", "scene.toml", "-o", "a.bmp"];
    an_output_without_format: ["render", "scene.toml", "-o", "a"];
    sixteen_bits_in_a_gif: ["render", "scene.toml", "-o", "a.gif", "--bit-depth", "16"];
    frames_without_a_place_for_the_number: ["render", "scene.toml", "--frames", "0..3", "--turntable", "-o", "a.png"];
    frames_that_are_all_the_same: ["render", "scene.toml", "--frames", "0..3", "-o", "a{frame}.png"];
    frames_to_stdout: ["render", "scene.toml", "--frames", "0..3", "--turntable", "-o", "-"];
    frames_that_are_none: ["render", "scene.toml", "--frames", "3..3", "--turntable", "-o", "a.gif"];
    a_turntable_without_frames: ["render", "scene.toml", "--turntable"];
    a_field_of_view_beyond_the_half_space: ["render", "scene.toml", "--fov-deg", "180"];
    an_eye_that_is_the_target: ["render", "scene.toml", "--eye", "1,1,1", "--target", "1,1,1"];
    an_up_that_is_no_direction: ["render", "scene.toml", "--up", "0,0,0"];
    a_background_that_is_no_color: ["render", "scene.toml", "--background", "white"];
    an_exposure_beyond_all_measure: ["render", "scene.toml", "--ev", "1000"];
    a_camera_that_is_not_there: ["render", "scene.toml", "--camera", "left"];
    no_threads: ["render", "scene.toml", "--threads", "0"];
    a_sweep_without_values: ["sweep", "scene.toml", "--vary", "materials.ball.shininess"];
    a_sweep_of_nothing: ["sweep", "scene.toml"];
    a_sweep_of_a_path_that_leads_nowhere: ["sweep", "scene.toml", "--vary", "materials.bell.shininess=1,2"];
    a_sweep_larger_than_a_picture: ["sweep", "scene.toml", "--vary", "image.width=1:9:9", "--size", "4000x400", "--columns", "9"];
    a_sweep_of_too_many_pictures: ["sweep", "scene.toml", "--vary", "camera.fov_deg=1:9:5000", "--vary", "render.ev=1:9:5000"];
    a_sheet_as_exr: ["sweep", "scene.toml", "--vary", "render.ev=1,2", "-o", "a.exr"];
    a_comparison_of_one_shading: ["shade-compare", "scene.toml", "--shading", "flat"];
    a_lighting_error_of_one_way: ["lighting-error", "scene.toml", "--lighting", "fast"];
    light_samples_without_exact_lighting: ["render", "scene.toml", "--light-samples", "64"];
    an_unknown_bsdf: ["bsdf", "show", "pong"];
    an_unknown_parameter: ["bsdf", "eval", "phong", "--set", "roughness=1", "--wo", "0,0", "--wi", "0,0"];
    a_parameter_out_of_range: ["bsdf", "eval", "phong", "--set", "shininess=-1", "--wo", "0,0", "--wi", "0,0"];
    a_parameter_that_is_no_number: ["bsdf", "albedo", "phong", "--set", "shininess=high"];
    a_direction_that_is_none: ["bsdf", "eval", "phong", "--wo", "0", "--wi", "0,0"];
    an_albedo_of_emission: ["bsdf", "albedo", "emission"];
    a_check_of_nothing: ["check"];
    a_check_of_all_and_one: ["check", "phong", "--all"];
    an_unknown_model_to_check: ["check", "lamberd"];
    a_parameter_that_no_model_has: ["check", "phong", "lambert", "--set", "shinines=3"];
    a_parameter_of_a_model_that_is_not_named: ["check", "phong", "--set", "lambert.shininess=3"];
    a_plot_of_no_model: ["plot", "-o", "a.svg"];
    a_plot_of_emission: ["plot", "emission", "-o", "a.svg"];
    a_plot_from_below: ["plot", "phong", "--theta", "30,120", "-o", "a.svg"];
    a_plot_of_too_many_lobes: ["plot", "phong", "--set", "shininess=1:99:99", "-o", "a.svg"];
    a_plot_of_factors_of_a_model_without: ["plot", "phong", "--kind", "terms", "-o", "a.svg"];
    a_plot_of_an_unknown_medium: ["plot", "--kind", "fresnel", "--ior", "1.5,Ay", "-o", "a.svg"];
    a_plot_of_an_unknown_kind: ["plot", "phong", "--kind", "polr", "-o", "a.svg"];
    a_plot_of_an_azimuth_for_nothing: ["plot", "phong", "--phi", "30", "-o", "a.svg"];
    an_albedo_of_an_azimuth_for_nothing: ["bsdf", "albedo", "phong", "--phi", "30"];
    a_plot_of_a_named_spectrum_with_a_column: ["color", "plot", "spectra", "D65", "--column", "2", "-o", "a.svg"];
    a_plot_of_a_mirror: ["plot", "mirror", "-o", "a.svg"];
    a_plot_with_an_option_of_other_kinds: ["plot", "phong", "--kind", "albedo", "--theta", "30", "-o", "a.svg"];
    a_plot_of_media_with_a_model: ["plot", "phong", "--kind", "fresnel", "-o", "a.svg"];
    a_plot_of_a_cone_that_is_none: ["plot", "--kind", "spot", "--set", "cutoff_deg=200", "-o", "a.svg"];
    a_plot_of_an_unknown_key_of_lights: ["plot", "--kind", "spot", "--set", "exponant=2", "-o", "a.svg"];
    a_plot_over_no_distance: ["plot", "--kind", "attenuation", "--distance", "0", "-o", "a.svg"];
    a_plot_at_a_wavelength_for_nothing: ["plot", "phong", "--lambda-nm", "500", "-o", "a.svg"];
    a_wavelength_beyond_the_grid: ["bsdf", "albedo", "phong", "--ior", "Au", "--lambda-nm", "900"];
    a_viewer_below_the_surface: ["bsdf", "eval", "phong", "--wo", "100,0", "--wi", "0,0"];
    a_missing_table_of_directions: ["bsdf", "eval", "phong", "--directions", "none.csv"];
    a_table_of_directions_that_is_none: ["bsdf", "eval", "phong", "--directions", "scene.toml"];
    directions_and_a_direction: ["bsdf", "eval", "phong", "--directions", "a.csv", "--wo", "0,0"];
    a_sheet_of_an_unknown_key: ["sheet", "phong", "--vary", "shinyness=1,2"];
    a_sheet_with_a_key_twice: ["sheet", "phong", "--vary", "shininess=1,2", "--set", "shininess=3"];
    a_sheet_with_a_value_out_of_range: ["sheet", "phong", "--vary", "shininess=1,-2"];
    a_sheet_of_an_unknown_metal: ["sheet", "phong", "--vary", "ior=Au,Agg"];
    a_sheet_of_an_unknown_mesh: ["sheet", "phong", "--vary", "shininess=1,2", "--mesh", "spere"];
    an_unknown_light: ["color", "spectrum", "gold", "--light", "FL15"];
    an_unknown_spectrum: ["color", "spectrum", "glod"];
    an_unknown_spectrum_that_is_like_nothing: ["color", "spectrum", "marmalade"];
    a_fluorescent_material_as_a_spectrum: ["color", "spectrum", "paper-note-pink"];
    a_light_that_is_not_possible: ["color", "spectrum", "D(100)"];
    a_missing_spectrum_file: ["color", "spectrum", "none.csv"];
    a_spectrum_that_is_a_folder: ["color", "spectrum", "./"];
    a_spectrum_file_that_is_none: ["color", "spectrum", "scene.toml"];
    an_unknown_observer: ["color", "spectrum", "D65", "--observer", "cie1932"];
    an_unknown_color_model: ["color", "convert", "--from", "hsl", "--to", "lab", "1,2,3"];
    a_color_with_too_few_numbers: ["color", "convert", "--from", "srgb", "--to", "lab", "1,2"];
    a_color_that_a_model_cannot_hold: ["color", "convert", "--from", "xyz", "--to", "hls", "0.1,0.9,0.1"];
    a_color_that_is_no_number: ["color", "convert", "--from", "srgb", "--to", "lab", "1,red,3"];
    a_light_among_metamers: ["color", "metamers", "gold", "D65"];
    metamers_for_an_observer_without_xyz: ["color", "metamers", "gold", "copper", "--observer", "lms2"];
    an_empty_name_of_a_light: ["color", "metamers", "gold", "copper", "--light", "D65,,A"];
    an_unknown_fluorescent_material: ["color", "fluorescence", "paper-note-blue"];
    an_unknown_kind_of_list: ["color", "list", "light"];
    an_unknown_set_of_surfaces: ["color", "efficiency", "--set", "colourchecker"];
    a_plot_of_unknown_format: ["color", "plot", "cones", "-o", "a.jpg"];
    a_plot_in_two_formats: ["color", "plot", "cones", "-o", "a.svg", "--format", "png"];
    a_plot_whose_numbers_have_a_size: ["color", "plot", "cones", "-o", "a.csv", "--size", "300x200"];
    a_plot_whose_table_has_a_title: ["color", "plot", "cones", "-o", "-", "--format", "csv", "--title", "x"];
    a_plot_too_large: ["color", "plot", "cones", "-o", "a.png", "--size", "9000x9000"];
    a_plot_beside_numbers_on_stdout: ["color", "spectrum", "D65", "--plot", "-"];
    a_language_of_no_plot: ["color", "spectrum", "D65", "--lang", "fr"];
    a_plot_without_a_file: ["color", "plot", "cones"];
    a_plot_folder_that_is_missing: ["color", "plot", "cones", "-o", "none/a.svg"];
    a_csv_that_is_a_folder: ["color", "spectrum", "D65", "--csv", "."];
    an_unknown_shell: ["completions", "tcsh"];
}

#[test]
fn a_wrong_field_of_directions_is_told_by_line_and_column_and_nothing_is_written() {
    let folder = Folder::new();
    let failures = [
        ("theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg\n30,0,45,180\n30,0,x,180\n", "not-a-number"),
        ("theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg\n30,0,45\n", "too-few"),
        ("theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg\n130,0,45,0\n", "from-below"),
        ("theta_o,phi_o_deg,theta_i_deg,phi_i_deg\n30,0,45,0\n", "header"),
        ("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0,0,2\n", "too-long"),
        ("", "empty"),
    ];
    for (table, name) in failures {
        folder.write("dirs.csv", table);
        let run = folder.glanz(&["bsdf", "eval", "phong", "--directions", "dirs.csv", "-o", "values.csv"]);
        insta::assert_snapshot!(format!("directions_{name}"), run.failure());
        assert_eq!(folder.names(), ["dirs.csv"]);
    }
}

#[test]
fn an_unknown_key_is_shown_in_its_line() {
    let folder = Folder::with_scene();
    folder.write("scene.toml", SCENE.replace("shininess", "shinyness"));
    insta::assert_snapshot!(folder.glanz(&["render", "scene.toml"]).failure());
}

#[test]
fn text_that_is_no_toml_is_shown_in_its_line() {
    let folder = Folder::with_scene();
    folder.write("scene.toml", SCENE.replace("width = 48", "width = = 48"));
    insta::assert_snapshot!(folder.glanz(&["info", "scene.toml"]).failure());
}

#[test]
fn a_damaged_model_is_one_error() {
    let folder = Folder::new();
    folder.write("a.glb", b"glTF\x02\0\0\0\xff\xff\xff\xff");
    insta::assert_snapshot!(folder.glanz(&["info", "a.glb"]).failure());
}

#[test]
fn an_existing_picture_beside_the_input_stays_as_it_is() {
    let folder = Folder::with_scene();
    folder.write("scene.png", "mine");
    insta::assert_snapshot!(folder.glanz(&["render", "scene.toml"]).failure());
    assert_eq!(folder.read("scene.png"), b"mine");
    assert_eq!(folder.glanz(&["render", "scene.toml", "--force"]).code, 0);
    assert!(folder.read("scene.png").starts_with(b"\x89PNG"));
}

#[test]
fn an_existing_frame_stops_the_film_before_it_begins() {
    let folder = Folder::with_scene();
    folder.write("scene_0002.png", "mine");
    let run = folder.glanz(&["render", "scene.toml", "--frames", "0..3", "--turntable"]);
    insta::assert_snapshot!(run.failure());
    assert_eq!(folder.names(), ["scene.toml", "scene_0002.png"]);
}

#[test]
fn an_unknown_simd_level_is_wrong_use() {
    let folder = Folder::with_scene();
    let run = folder.glanz_with(&["render", "scene.toml"], &[("GLANZ_SIMD", "mmx")]);
    insta::assert_snapshot!(run.failure());
}

#[test]
fn messages_have_no_colors_where_nobody_looks() {
    let folder = Folder::new();
    folder.write("scene.toml", "[image]\nwdth = 3\n");
    for words in [["info", "scene.toml"], ["info", "--wrong"]] {
        assert!(!folder.glanz(&words).stderr.contains('\x1b'));
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure() {
    use std::process::Stdio;
    let folder = Folder::with_scene();
    for words in [&["schema"][..], &["render", "scene.toml", "-o", "-", "--size", "1000x1000"], &["--help"]] {
        let mut child = command(&folder.path(""))
            .args(words)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{words:?}");
        assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}
