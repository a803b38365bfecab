//! The numbers of a figure, as CSV and JSON.

use serde::Serialize;

/// The version of the JSON document. It grows when a key goes or changes its meaning.
const VERSION: u32 = 1;

/// The numbers of a figure.
///
/// ```
/// use glanz_plot::data::{DataCurve, DataPanel, PlotData};
///
/// let curve = DataCurve { name: "cosine".to_owned(), points: vec![vec![0.0, 1.0], vec![90.0, 0.0]] };
/// let columns = vec!["angle in °".to_owned(), "part".to_owned()];
/// let panel = DataPanel { title: String::new(), columns, curves: vec![curve] };
/// let data = PlotData::new("Lambert's law", "", vec![panel]);
/// assert_eq!(data.csv(), "curve,angle in °,part\ncosine,0,1\ncosine,90,0\n");
/// assert!(data.json().contains("\"points\":[[0.0,1.0],[90.0,0.0]]"));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema))]
pub struct PlotData {
    #[cfg_attr(feature = "schemars", schemars(skip))]
    version: u32,
    /// The title of the plot
    pub title: String,
    /// The line below the title
    pub subtitle: String,
    /// The parts of the plot that have axes of their own
    pub panels: Vec<DataPanel>,
}

/// Curves that share their axes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema))]
pub struct DataPanel {
    /// What stands above it; empty where a plot has one panel
    pub title: String,
    /// What the numbers of a point are, with their units
    pub columns: Vec<String>,
    /// The curves
    pub curves: Vec<DataCurve>,
}

/// A curve, or the cells of a map.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema))]
pub struct DataCurve {
    /// Its name in the legend
    pub name: String,
    /// Its points, each with a number for every column; null where there is none
    #[cfg_attr(feature = "schemars", schemars(with = "Vec<Vec<Option<f64>>>"))]
    pub points: Vec<Vec<f64>>,
}

impl DataCurve {
    /// A curve of pairs.
    pub(crate) fn of_pairs(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { name: name.into(), points: points.into_iter().map(|(x, y)| vec![x, y]).collect() }
    }
}

impl PlotData {
    /// The numbers of these panels.
    pub fn new(title: impl Into<String>, subtitle: impl Into<String>, panels: Vec<DataPanel>) -> Self {
        Self { version: VERSION, title: title.into(), subtitle: subtitle.into(), panels }
    }

    /// A table with a row for each point (RFC 4180, UTF-8): the curve's name and its numbers, with what they are and
    /// their units in the first row. Where there are several panels, the first column names the panel, and a row has
    /// nothing in the columns of other panels.
    pub fn csv(&self) -> String {
        let named = self.panels.len() > 1;
        let mut columns: Vec<&str> = Vec::new();
        for column in self.panels.iter().flat_map(|panel| &panel.columns) {
            if !columns.contains(&column.as_str()) {
                columns.push(column);
            }
        }
        let head = if named { "panel,curve" } else { "curve" };
        let mut text = columns.iter().fold(head.to_owned(), |head, column| head + "," + &quoted(column));
        text.push('\n');
        for panel in &self.panels {
            let place = |column: &&str| panel.columns.iter().position(|own| own == column);
            let places: Vec<_> = columns.iter().map(place).collect();
            for curve in &panel.curves {
                let name = quoted(&curve.name);
                let head = if named { format!("{},{name}", quoted(&panel.title)) } else { name };
                for point in &curve.points {
                    text.push_str(&head);
                    for place in &places {
                        let value =
                            place.and_then(|place| point.get(place)).filter(|value| value.is_finite());
                        text.push(',');
                        text.push_str(&value.map_or(String::new(), f64::to_string));
                    }
                    text.push('\n');
                }
            }
        }
        text
    }

    /// A JSON object with the keys `version`, `title`, `subtitle` and `panels`; numbers that are not finite are null.
    pub fn json(&self) -> String {
        serde_json::to_string(self).expect("texts and numbers have no failing parts") + "\n"
    }
}

fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(title: &str, columns: [&str; 2], name: &str) -> DataPanel {
        let curves = vec![DataCurve::of_pairs(name, [(0.5, 1.0), (1.0, f64::NAN)])];
        DataPanel { title: title.to_owned(), columns: columns.map(str::to_owned).to_vec(), curves }
    }

    #[test]
    fn a_table_quotes_commas_and_leaves_out_what_is_no_number() {
        let data = PlotData::new("", "", vec![panel("", ["x in °", "y"], "a, \"b\"")]);
        assert_eq!(data.csv(), "curve,x in °,y\n\"a, \"\"b\"\"\",0.5,1\n\"a, \"\"b\"\"\",1,\n");
    }

    #[test]
    fn panels_share_the_columns_that_are_called_the_same() {
        let data = PlotData::new("", "", vec![panel("D", ["x", "d"], "a"), panel("G", ["x", "g"], "a")]);
        assert_eq!(data.csv(), "panel,curve,x,d,g\nD,a,0.5,1,\nD,a,1,,\nG,a,0.5,,1\nG,a,1,,\n");
    }

    #[test]
    fn json_has_null_for_what_is_no_number() {
        let data = PlotData::new("t", "", vec![panel("", ["x", "y"], "a")]);
        let value: serde_json::Value = serde_json::from_str(&data.json()).unwrap();
        assert_eq!(value["panels"][0]["curves"][0]["points"], serde_json::json!([[0.5, 1.0], [1.0, null]]));
        assert_eq!(value["version"], 1);
    }
}
