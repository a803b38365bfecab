//! Tables of what was measured.

use std::fmt::Write;

use serde_json::Value;

use super::Options;
use crate::workspace::{Workspace, run_quietly};
use crate::{Failure, Result};

/// Below this line `docs/BENCHMARKS.md` is written by the program.
const MARK: &str = "<!-- measured -->";

const LIGHTS: [u64; 3] = [1, 4, 8];

/// All tables, with date, processor and command.
pub(super) fn report(workspace: &Workspace, lines: &[Value], options: &Options) -> String {
    let mut text = format!("Measured on {} with `{}`.\n", date(workspace), command(options));
    let _ = writeln!(text, "Processor: {}, {} threads.", processor(), threads());
    let frames: Vec<&Value> = lines.iter().filter(|line| line["sphere"].is_string()).collect();
    for (sphere, shading) in distinct(&frames, |line| (string(line, "sphere"), shading(line))) {
        text += &frame_table(&frames, &sphere, &shading);
    }
    let rows: Vec<&Value> = lines.iter().filter(|line| line["table"].is_string()).collect();
    for title in distinct(&rows, |line| string(line, "table")) {
        let rows: Vec<&Value> = rows.iter().filter(|row| row["table"] == title.as_str()).copied().collect();
        text += &plain_table(&title, &rows);
    }
    text
}

/// Puts the report into `docs/BENCHMARKS.md`, in place of the last one.
pub(super) fn write(workspace: &Workspace, report: &str) -> Result<()> {
    let path = workspace.path("docs/BENCHMARKS.md");
    let old = std::fs::read_to_string(&path).map_err(Failure::during(path.display()))?;
    let (head, _) = old
        .split_once(MARK)
        .ok_or_else(|| Failure::new(format!("{} has no line '{MARK}'", path.display())))?;
    std::fs::write(&path, format!("{head}{MARK}\n\n{report}")).map_err(Failure::during(path.display()))?;
    println!("{} written", path.display());
    Ok(())
}

/// Milliseconds per frame for one sphere: a row per program, then how often Glanz fits into the others.
fn frame_table(frames: &[&Value], sphere: &str, shading_name: &str) -> String {
    let frames: Vec<&Value> = frames
        .iter()
        .filter(|line| line["sphere"] == sphere && shading(line) == shading_name)
        .copied()
        .collect();
    let cell = |program: &str, lights: u64| {
        frames.iter().find(|line| line["program"] == program && line["lights"] == lights).copied()
    };
    let mut text =
        format!("\n### {sphere} sphere, {shading_name} shading, ms per frame: median (min–max)\n\n");
    text += "| | 1 light | 4 lights | 8 lights |\n|---|---|---|---|\n";
    let programs = distinct(&frames, |line| string(line, "program"));
    for program in &programs {
        let row = LIGHTS.map(|lights| cell(program, lights).map_or("–".to_owned(), spread));
        let _ = writeln!(text, "| {} | {} |", title(&frames, program), row.join(" | "));
    }
    for program in programs.iter().filter(|program| *program != "glanz") {
        let row = LIGHTS.map(|lights| ratio(cell(program, lights), cell("glanz", lights)));
        if row.iter().any(Option::is_some) {
            let row = row.map(|ratio| ratio.map_or("–".to_owned(), |ratio| format!("{ratio:.1}×")));
            let _ = writeln!(text, "| {program} / glanz | {} |", row.join(" | "));
        }
    }
    text
}

/// The program with its version and number of threads.
fn title(frames: &[&Value], program: &str) -> String {
    let line = frames.iter().find(|line| line["program"] == program).expect("the program was measured");
    let version = line["version"].as_str().map(|version| format!(" ({version})")).unwrap_or_default();
    let threads = line["threads"].as_u64().map(|threads| format!(", {threads} threads")).unwrap_or_default();
    format!("{program}{version}{threads}")
}

fn spread(line: &Value) -> String {
    let number = |key: &str| line[key].as_f64().map_or("?".to_owned(), |ms| format!("{ms:.2}"));
    format!("{} ({}–{})", number("median_ms"), number("min_ms"), number("max_ms"))
}

fn ratio(other: Option<&Value>, own: Option<&Value>) -> Option<f64> {
    let median = |line: Option<&Value>| line?["median_ms"].as_f64();
    Some(median(other)? / median(own)?)
}

fn plain_table(title: &str, rows: &[&Value]) -> String {
    let mut columns: Vec<&String> =
        rows.iter().filter_map(|row| row.as_object()).flat_map(|row| row.keys()).collect();
    columns.sort();
    columns.dedup();
    columns.retain(|column| !matches!(column.as_str(), "table" | "name"));
    let mut text = format!("\n### {title}\n\n| |");
    columns.iter().for_each(|column| text += &format!(" {column} |"));
    text += &format!("\n|---|{}\n", "---|".repeat(columns.len()));
    for row in rows {
        text += &format!("| {} |", string(row, "name"));
        for column in &columns {
            let value = &row[column.as_str()];
            let shown = match value.as_f64() {
                Some(number) if value.is_f64() => format!("{number:.2}"),
                _ => value.as_str().map_or_else(|| value.to_string(), str::to_owned),
            };
            text += &format!(" {} |", if value.is_null() { "–" } else { &shown });
        }
        text.push('\n');
    }
    text
}

fn string(line: &Value, key: &str) -> String {
    line[key].as_str().unwrap_or("?").to_owned()
}

fn shading(line: &Value) -> String {
    line["shading"].as_str().unwrap_or("phong").to_owned()
}

/// The different keys, in the order in which they first occur.
fn distinct<T: PartialEq>(lines: &[&Value], key: impl Fn(&Value) -> T) -> Vec<T> {
    let mut keys = Vec::new();
    for line in lines {
        let key = key(line);
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    keys
}

fn command(options: &Options) -> String {
    let flags =
        [(options.peers, " --peers"), (options.only_peers, " --only-peers"), (options.quick, " --quick")];
    let flags: String = flags.iter().filter(|(given, _)| *given).map(|(_, flag)| *flag).collect();
    format!("cargo xtask bench{flags}")
}

fn date(workspace: &Workspace) -> String {
    let date = run_quietly(workspace.command("date").args(["-u", "+%Y-%m-%d"])).unwrap_or_default();
    let date = String::from_utf8_lossy(&date).trim().to_owned();
    if date.is_empty() { "an unknown day".to_owned() } else { date }
}

/// As Linux names it.
fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or("unknown", |(_, name)| name.trim()).to_owned()
}

fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn lines() -> Vec<Value> {
        vec![
            json!({"program": "glanz", "sphere": "64x32", "lights": 1, "median_ms": 2.0, "min_ms": 1.5, "max_ms": 3.0}),
            json!({"program": "euc", "version": "0.5.3", "threads": 1, "sphere": "64x32", "lights": 1,
                   "median_ms": 5.0, "min_ms": 4.0, "max_ms": 9.0}),
            json!({"table": "Throughput", "name": "lambert", "Mfragments/s": 812.25}),
            json!({"table": "Throughput", "name": "phong", "Mfragments/s": 401.0, "of limit": "90 %"}),
        ]
    }

    #[test]
    fn the_table_tells_who_is_how_much_slower() {
        let text = report(&Workspace::find(), &lines(), &Options { peers: true, ..Options::default() });
        assert!(text.contains("`cargo xtask bench --peers`"), "{text}");
        assert!(text.contains("| glanz | 2.00 (1.50–3.00) | – | – |"), "{text}");
        assert!(text.contains("| euc (0.5.3), 1 threads | 5.00 (4.00–9.00) | – | – |"), "{text}");
        assert!(text.contains("| euc / glanz | 2.5× | – | – |"), "{text}");
    }

    #[test]
    fn other_rows_stand_under_their_title() {
        let text = report(&Workspace::find(), &lines(), &Options::default());
        let expected = "### Throughput\n\n| | Mfragments/s | of limit |\n|---|---|---|\n\
                        | lambert | 812.25 | – |\n| phong | 401.00 | 90 % |\n";
        assert!(text.contains(expected), "{text}");
    }
}
