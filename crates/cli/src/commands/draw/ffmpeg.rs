//! Films by the program ffmpeg, where it is installed: MP4 and WebM.

use std::io::{Read, Write};
use std::path::Path;
use std::process::{ChildStderr, ChildStdin, Command, Stdio};

use glanz_picture::output::{Animation, Metadata, TargetFile};

use crate::interrupt::Ended;
use crate::print::failure::{Failure, Report};

/// The program.
const PROGRAM: &str = "ffmpeg";
/// Endings, the container that each stands for, and the codec.
const CONTAINERS: [(&str, &str, &[&str]); 4] = [
    ("mp4", "mp4", &["-c:v", "libx264", "-crf", "16", "-movflags", "+faststart"]),
    ("mov", "mov", &["-c:v", "libx264", "-crf", "16"]),
    ("mkv", "matroska", &["-c:v", "libx264", "-crf", "16"]),
    ("webm", "webm", &["-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0"]),
];

/// Whether it is ffmpeg that writes a file of this name.
pub(in crate::commands) fn writes(path: &Path) -> bool {
    container(path).is_some()
}

fn container(path: &Path) -> Option<&'static (&'static str, &'static str, &'static [&'static str])> {
    let ending = path.extension()?.to_str()?;
    CONTAINERS.iter().find(|(known, ..)| ending.eq_ignore_ascii_case(known))
}

/// That the program is there, before anything is drawn.
pub(in crate::commands) fn check(path: &Path) -> Result<(), Failure> {
    let mut command = Command::new(PROGRAM);
    command.arg("-version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    match command.status() {
        Ok(_) => Ok(()),
        Err(_) => Err(missing(path)),
    }
}

fn missing(path: &Path) -> Failure {
    let message =
        format_args!("cannot write '{}': the program ffmpeg, which writes it, is not found", path.display());
    let help = "install the package ffmpeg (apt install ffmpeg, brew install ffmpeg, winget install ffmpeg), or write a \
                .gif or .apng";
    Report::new(message).file(path).help(help).into()
}

/// Writes the frames, RGBA by rows, by way of ffmpeg.
pub(in crate::commands) fn write(
    out: &mut TargetFile,
    animation: &Animation,
    fps: f64,
    frames: impl Iterator<Item = Result<Vec<u8>, Failure>>,
    metadata: &Metadata,
) -> Result<(), Failure> {
    let path = out.written_path().to_owned();
    let named = out.path().to_owned();
    let (child, stdin, stderr) = start(&path, &named, animation, fps, metadata)?;
    let mut stdin = stdin.expect("it was asked for");
    let mut stderr = stderr.expect("it was asked for");
    let errors = std::thread::spawn(move || {
        let mut text = String::new();
        let _ = stderr.read_to_string(&mut text);
        text
    });
    // Where it takes no more, its own words say why.
    let mut taken = Ok(());
    for frame in frames {
        taken = stdin.write_all(&frame?);
        if taken.is_err() {
            break;
        }
    }
    drop(stdin);
    let status = child.wait();
    let said = errors.join().unwrap_or_default();
    match status {
        Ok(status) if status.success() && taken.is_ok() => Ok(()),
        _ => Err(failed(&named, &said)),
    }
}

fn start(
    path: &Path,
    named: &Path,
    animation: &Animation,
    fps: f64,
    metadata: &Metadata,
) -> Result<(Ended, Option<ChildStdin>, Option<ChildStderr>), Failure> {
    let (_, format, codec) = container(named).expect("it was asked before");
    let comment = format!("comment={}", metadata.text().trim_end().replace('\n', "; "));
    let size = format!("{}x{}", animation.width, animation.height);
    let mut command = Command::new(PROGRAM);
    command
        .args(["-nostdin", "-hide_banner", "-loglevel", "error", "-y"])
        .args([
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgba",
            "-video_size",
            &size,
            "-framerate",
            &fps.to_string(),
        ])
        .args(["-i", "pipe:0"])
        .args(*codec)
        // Players want 4:2:0, which needs even sides.
        .args(["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-metadata", &comment])
        .args(["-f", format])
        .arg(path)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    Ended::start(&mut command).map_err(|_| missing(named))
}

fn failed(path: &Path, said: &str) -> Failure {
    let last = said.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("it says nothing about it");
    Report::new(format_args!("cannot write '{}': ffmpeg failed: {}", path.display(), last.trim()))
        .file(path)
        .into()
}
