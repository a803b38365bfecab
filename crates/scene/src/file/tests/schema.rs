//! The JSON Schema against the reader: both come from the same types and must agree.

use serde_json::{Value, json};

use super::*;

/// Checks a value against the part of JSON Schema that the scene's schema uses. Keywords that are not
/// known here fail the test, so that none is passed over.
fn check(schema: &Value, value: &Value, root: &Value) -> Result<(), String> {
    let Some(rules) = schema.as_object() else {
        return if schema == &json!(true) { Ok(()) } else { Err("nothing is allowed".into()) };
    };
    for (keyword, rule) in rules {
        let fits = match keyword.as_str() {
            "$schema" | "$defs" | "title" | "description" | "default" | "format" => true,
            "$ref" => {
                let pointer = rule.as_str().and_then(|r| r.strip_prefix('#')).expect("a local reference");
                check(root.pointer(pointer).expect("the reference leads somewhere"), value, root)?;
                true
            }
            "type" => match rule {
                Value::Array(types) => types.iter().any(|t| is_of_type(value, t)),
                one => is_of_type(value, one),
            },
            "const" => value == rule,
            "enum" => rule.as_array().expect("a list").contains(value),
            "anyOf" => rule.as_array().expect("a list").iter().any(|s| check(s, value, root).is_ok()),
            "oneOf" => {
                rule.as_array().expect("a list").iter().filter(|s| check(s, value, root).is_ok()).count() == 1
            }
            "minimum" => value.as_f64().is_none_or(|v| v >= number(rule)),
            "maximum" => value.as_f64().is_none_or(|v| v <= number(rule)),
            "exclusiveMinimum" => value.as_f64().is_none_or(|v| v > number(rule)),
            "exclusiveMaximum" => value.as_f64().is_none_or(|v| v < number(rule)),
            "minItems" => value.as_array().is_none_or(|v| v.len() as f64 >= number(rule)),
            "maxItems" => value.as_array().is_none_or(|v| v.len() as f64 <= number(rule)),
            "items" => {
                value.as_array().into_iter().flatten().try_for_each(|v| check(rule, v, root))?;
                true
            }
            "pattern" => {
                assert_eq!(rule, "^#[0-9a-fA-F]{6}$");
                value.as_str().is_none_or(|text| tables::values::Color::parse_hex(text).is_some())
            }
            "required" => value.as_object().is_none_or(|table| {
                rule.as_array()
                    .expect("a list")
                    .iter()
                    .all(|key| table.contains_key(key.as_str().expect("a key")))
            }),
            "properties" => {
                for (key, value) in value.as_object().into_iter().flatten() {
                    rule.get(key).map_or(Ok(()), |rule| check(rule, value, root))?;
                }
                true
            }
            "additionalProperties" => {
                for (key, value) in value.as_object().into_iter().flatten() {
                    if rules.get("properties").and_then(|p| p.get(key)).is_none() {
                        check(rule, value, root).map_err(|error| format!("{key}: {error}"))?;
                    }
                }
                true
            }
            other => panic!("the keyword {other} is not known to this test"),
        };
        if !fits {
            return Err(format!("{value} does not fit {keyword}: {rule}"));
        }
    }
    Ok(())
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn is_of_type(value: &Value, name: &Value) -> bool {
    match name.as_str().expect("a type's name") {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "null" => value.is_null(),
        other => panic!("{other} is no type of JSON Schema"),
    }
}

fn valid(text: &str) -> Result<(), String> {
    let value: Value = toml::from_str(text).expect("TOML");
    let schema = schema();
    check(&schema, &value, &schema)
}

#[test]
fn the_examples_fit_the_schema() {
    for path in example_files() {
        let text = std::fs::read_to_string(&path).expect("readable");
        valid(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

/// What the reader refuses by its form the schema refuses, too.
#[test]
fn the_schema_refuses_what_the_reader_refuses() {
    let texts = [
        "[imag]",
        "[image]\nwidth = 0",
        "[image]\nsamples = 3",
        "[image]\nbackground = 'clear'",
        "[camera]\nfov_deg = 40",
        "[camera]\neye = [0, 0]",
        "[camera]\neye = [0, 0, 1]\nfov_deg = 180",
        "[render]\nshading = 'gourad'",
        "[ambient]\ncolor = [1, 1, -1]",
        "[[lights]]\nname = 'a'",
        "[[lights]]\nkind = 'lamp'",
        "[[lights]]\nkind = 'spot'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\ncutoff_deg = 181",
        "[[lights]]\nkind = 'point'\nposition = [0, 0, 0]\nattenuation = 'fysical'",
        "[[lights]]\nkind = 'disk'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\nradius = -1",
        "[[lights]]\nkind = 'rectangle'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\nsize = [1]",
        "[[lights]]\nkind = 'environment'\nrotate_deg = 'up'",
        "[render]\nshadows = 'soft'",
        "[materials.a]\nshinines = 3",
        "[materials.a]\nmodel = 'emission'",
        "[materials.a]\nlobes = [{ tint = [1, 1, 1] }]",
        "[materials.a]\nlobes = [{ shape = 'lambert', shininess = 3 }]",
        "[materials.a]\nlobes = [{ shape = 'phong', shininess = 1e9 }]",
        "[[objects]]\nmaterial = 'a'",
        "[[objects]]\nmesh = { sphere = { slizes = 3 } }",
        "[[objects]]\nmesh = { file = 3 }",
        "[[objects]]\nmesh = 'quad'\nsubdivide = 11",
        "[[objects]]\nmesh = 'quad'\nrotate_deg = { axis = [0, 0, 1] }",
        "[[objects]]\nmesh = 'quad'\nmatrix = [[1, 0, 0, 0]]",
        "[[objects]]\nmesh = 'quad'\ncolors = 'some'",
    ];
    for text in texts {
        assert!(parse_str(text, Path::new("."), &LoadOptions::default()).is_err(), "the reader takes {text}");
        assert!(valid(text).is_err(), "the schema takes {text}");
    }
}

#[test]
fn every_key_is_described() {
    fn undescribed(schema: &Value, path: &str, found: &mut Vec<String>) {
        let Some(rules) = schema.as_object() else { return };
        for (key, rule) in rules.get("properties").and_then(Value::as_object).into_iter().flatten() {
            // The description of a choice with a single key is that of the key.
            let single = rules.contains_key("description")
                && rules["properties"].as_object().is_some_and(|p| p.len() == 1);
            let described =
                ["description", "const", "$ref"].iter().any(|keyword| rule.get(keyword).is_some());
            if !described && !single {
                found.push(format!("{path}.{key}"));
            }
        }
        for (key, rule) in rules {
            undescribed(rule, &format!("{path}/{key}"), found);
        }
        for (key, rule) in rules.iter().filter_map(|(k, v)| Some((k, v.as_array()?))) {
            rule.iter().for_each(|rule| undescribed(rule, &format!("{path}/{key}"), found));
        }
    }
    let mut found = Vec::new();
    undescribed(&schema(), "", &mut found);
    assert_eq!(found, Vec::<String>::new());
}
