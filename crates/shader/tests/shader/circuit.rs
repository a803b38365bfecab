//! `&&`, `||` and `?:` evaluate what they need and no more.

use glanz_shader::RunError;

use crate::common::{self, expression, value};

/// `n` after statements over `x`, where `up(n)` counts and says whether n is above 0, and `above(a)` counts in `calls`.
fn counted(statements: &str, x: f32) -> f32 {
    value(
        &format!(
            "#version 330\nin float x; out float y; int calls = 0;
             bool up(inout int n) {{ n++; return n > 0; }}
             bool above(float a) {{ calls++; return a > 0.0; }}
             bool twice(float a) {{ return above(a) || above(a + 1.0); }}
             bool pure(float a) {{ return a > 0.0; }}
             void main() {{ int n = 0; bool t = false; {statements} y = float(n + 10 * calls) + (t ? 0.5 : 0.0); }}"
        ),
        x,
    )
}

#[test]
fn the_right_side_is_evaluated_only_where_the_left_one_asks_for_it() {
    for (statements, negative, positive) in [
        ("t = x > 0.0 && up(n);", 0.0, 1.5),
        ("t = x > 0.0 || up(n);", 1.5, 0.5),
        ("t = x > 0.0 && pure(x) && up(n) && pure(x);", 0.0, 1.5),
        ("t = x > 0.0 || pure(x) || up(n) || up(n) || pure(x);", 1.5, 0.5),
        ("t = pure(x) && (up(n) || up(n)) ^^ up(n);", 1.5, 2.0),
        ("t = up(n) && pure(x) || up(n) && !up(n);", 3.0, 1.5),
        ("t = (x > 0.0 && n++ == 0) || (n += 5) > 7;", 5.0, 1.5),
        ("if (pure(x) && up(n)) n += 3; else if (!pure(x) && up(n)) n += 6;", 7.0, 4.0),
        ("while (pure(x) && up(n) && n < 4) t = true;", 0.0, 4.5),
        ("for (bool go = pure(x) && up(n); go && up(n) && n < 6; n += 1) t = !t;", 0.0, 6.0),
        ("do { t = true; } while (pure(x) && up(n) && n < 4);", 0.5, 4.5),
        ("bool l[2] = bool[2](pure(x) && up(n), pure(x) || up(n)); t = l[0] && l[1 - 1];", 1.0, 1.5),
        ("t = pure(x) ? up(n) : above(x);", 10.0, 1.5),
        ("t = pure(x) && up(n) ? up(n) : !pure(x) || up(n);", 0.5, 2.5),
        ("t = pure(x) && twice(x);", 0.0, 10.5),
        ("t = twice(x - 0.5) && twice(x - 2.5);", 20.0, 30.0),
        ("if (x > 0.0) if (pure(x) || up(n)) { t = pure(x) && up(n); }", 0.0, 1.5),
        ("switch (n) { case 0: t = pure(x) && up(n); break; default: t = true; }", 0.0, 1.5),
        ("float i; t = pure(x) && modf(x * 3.0, i) > 0.2 && up(n) && i > 1.0;", 0.0, 1.5),
    ] {
        assert_eq!(counted(statements, -0.75), negative, "below 0: {statements}");
        assert_eq!(counted(statements, 0.75), positive, "above 0: {statements}");
    }
}

#[test]
fn what_is_not_evaluated_neither_discards_nor_loops() {
    let program = common::fragment(
        "#version 330\nin float x; out float y;
         bool gone() { discard; return true; }
         bool reaches(float a) { while (a < 1.0) a *= 2.0; return true; }
         void main() { y = x > 0.0 && reaches(x) ? 1.0 : x < -1.0 && gone() ? 2.0 : 3.0; }",
    );
    let uniforms = program.uniforms();
    let mut machine = glanz_shader::Machine::<1>::new(
        &program,
        &uniforms,
        &glanz_shader::NoTextures,
        glanz_math::SimdLevel::best(),
    );
    machine.set_fuel(1000);
    machine.input(0, 0)[0] = glanz_shader::Row(std::array::from_fn(|i| i as f32 - 3.0));
    assert_eq!(machine.run(), Ok::<(), RunError>(()));
    assert_eq!(machine.discarded()[0], 0b11);
    assert_eq!(&machine.output(0, 0)[0].0[2..5], &[3.0, 3.0, 1.0]);
}

#[test]
fn long_and_deep_ones_pass() {
    // x is 0.75: every term is evaluated up to the first that holds.
    let long = vec!["(n += 1) > 100"; 200];
    assert_eq!(counted(&format!("t = {};", long.join(" || ")), 0.75), 101.5);
    let deep = |depth: usize| (0..depth).fold("up(n)".to_owned(), |inside, _| format!("(up(n) && {inside})"));
    assert_eq!(counted(&format!("t = {};", deep(60)), 0.75), 61.5);
}

#[test]
fn pure_functions_cost_no_branches() {
    let both = |sign: &str| {
        let text = format!(
            "#version 330\nin float x; out float y; bool f(float a) {{ return sin(a) > 0.0; }}
             void main() {{ y = float(f(x) {sign} f(x + 1.0)); }}"
        );
        common::fragment(&text).size().0
    };
    assert_eq!(both("&&"), both("^^"));
    assert_eq!(expression("x > 0.0 && x < 1.0 || x > 2.0", 0.5), 1.0);
}

#[test]
fn wgsl_has_it_too() {
    let program = common::wgsl(
        "var<private> n: i32 = 0;
         fn up() -> bool { n += 1; return true; }
         @fragment fn main(@location(0) x: f32) -> @location(0) f32 {
             let a = x > 0.0 && up();
             let b = x > 0.0 || up() || up();
             return f32(n) + select(0.0, 0.25, a) + select(0.0, 0.5, b);
         }",
    );
    let values = common::outputs(&program, &|_, _, lane| lane as f32 - 1.0)[0];
    assert_eq!(values[..3], [1.5, 1.5, 1.75]);
}

#[test]
fn continue_in_a_do_loop_asks_its_condition() {
    for (statements, expected) in [
        ("int k = 0; do { k++; if (k == 4) continue; n++; } while (k < 4);", 3.0),
        (
            "do { n++; if (n > 1) continue; for (int i = 0; i < 3; i++) { if (i > 0) continue; n++; } } while (up(n) && n < 9);",
            9.0,
        ),
    ] {
        assert_eq!(counted(statements, 0.75), expected, "{statements}");
    }
    let error =
        common::error("void main() {\n int k = 0;\n do if (k > 3) continue; while (k++ < 9);\n}").to_string();
    assert!(error.contains(":3:") && error.contains("braces"), "{error}");
}
