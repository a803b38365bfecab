//! The document of the command, and its schema.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// The colour numbers of a light or a surface.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub(crate) struct Document(pub(super) Map<String, Value>);

/// The keys follow from what the spectrum is of and who sees it, so the schema is written here.
impl JsonSchema for Document {
    fn schema_name() -> Cow<'static, str> {
        "Spectrum".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let number = json!({ "type": "number" });
        let nullable = json!({ "type": ["number", "null"] });
        let text = json!({ "type": "string" });
        let numbers = |count: usize| json!({ "type": "array", "items": { "type": "number" }, "minItems": count, "maxItems": count });
        json_schema!({
            "description": "The colour numbers of a light or a surface",
            "type": "object",
            "required": ["name", "title", "observer", "kind", "nm", "values"],
            "properties": {
                "name": text, "title": text, "observer": text, "kind": { "enum": ["light", "surface"] },
                "nm": { "type": "array", "items": { "type": "number" } },
                "values": { "type": "array", "items": { "type": ["number", "null"] } },
                "under": text, "xyz": numbers(3), "xy": numbers(2), "uv1976": numbers(2), "lab": numbers(3),
                "srgb": {
                    "type": "object",
                    "required": ["values", "code", "in_gamut"],
                    "properties": { "values": numbers(3), "code": text, "in_gamut": { "type": "boolean" } },
                    "additionalProperties": false,
                },
                "dominant_nm": nullable, "purity": number, "complementary_nm": number, "cct_k": nullable,
                "duv": number, "cct_is_meaningful": { "type": "boolean" }, "ra": number,
                "r": { "type": "array", "items": { "type": "number" } }, "tm30": tm30_schema(),
                "ssi": {
                    "description": "Likeness to the reference of TM-30; 100 is the same light",
                    "type": "number",
                },
                "efficacy_lm_per_w": nullable,
                "sp_ratio": nullable, "unit": text, "luminous": nullable, "scotopic": nullable,
                "luminous_unit": text,
                "interpolation": {
                    "description": "Of a table with coarse steps, whose values are joined by lines: how far Sprague's polynomials would be",
                    "type": "object",
                    "required": ["step_nm", "sprague_de2000"],
                    "properties": { "step_nm": number, "sprague_de2000": number },
                    "additionalProperties": false,
                },
                "drawn_by_5_nm": {
                    "description": "How far the colour of a picture, whose grid has steps of 5 nm, is from these numbers",
                    "type": "object",
                    "required": ["de2000"],
                    "properties": { "de2000": number, "cct_shift_k": nullable },
                    "additionalProperties": false,
                },
            },
            "patternProperties": { "^response_": { "type": ["number", "null"] } },
            "additionalProperties": false,
        })
    }
}

/// The schema of TM-30's numbers.
fn tm30_schema() -> Value {
    let number = json!({ "type": "number" });
    let bin = json!({
        "type": "object",
        "required": ["rf", "rcs", "rhs"],
        "properties": { "rf": number, "rcs": number, "rhs": number },
        "additionalProperties": false,
    });
    json!({
        "description": "ANSI/IES TM-30-20: fidelity and gamut, the fidelity of each of 99 samples, and of each of 16 bins of \
            hue fidelity, chroma shift (-0.1 is 10 % less) and hue shift in radians; rf is that of CIE 224:2017 too",
        "type": "object",
        "required": ["rf", "rg", "rf_ces", "bins"],
        "properties": {
            "rf": number, "rg": number,
            "rf_ces": { "type": "array", "items": number, "minItems": 99, "maxItems": 99 },
            "bins": { "type": "array", "items": bin, "minItems": 16, "maxItems": 16 },
        },
        "additionalProperties": false,
    })
}
