//! Texts below the help of commands: paragraphs that are wrapped where the terminal ends, not where the source does.

use clap::Command;

/// The command with the paragraphs below its help, and that of its subcommands, on one line each.
pub(crate) fn reflowed(command: Command) -> Command {
    let after = command.get_after_help().map(|text| paragraphs(&text.to_string()));
    let command = match after {
        Some(text) => command.after_help(text),
        None => command,
    };
    let names: Vec<_> = command.get_subcommands().map(|sub| sub.get_name().to_owned()).collect();
    names.into_iter().fold(command, |command, name| command.mut_subcommand(name, reflowed))
}

/// The text with the lines of each paragraph joined. Indented lines and the lines above them, such as `Examples:`, stay
/// as they are.
fn paragraphs(text: &str) -> String {
    let mut all = String::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        all.push_str(line);
        let Some(next) = lines.peek() else { break };
        let stays = line.is_empty() || next.is_empty() || line.starts_with(' ') || next.starts_with(' ');
        all.push(if stays { '\n' } else { ' ' });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::paragraphs;

    #[test]
    fn the_lines_of_a_paragraph_are_joined_and_examples_stay() {
        let text = "Examples:\n  glanz a \\\n      b\n  glanz c\n\nOne\ntwo.\n\nThree.";
        assert_eq!(paragraphs(text), "Examples:\n  glanz a \\\n      b\n  glanz c\n\nOne two.\n\nThree.");
    }
}
