//! A page of the guide: its text in, the commands to run, the printed texts and the pictures shown out.

use std::ops::Range;

use super::command::Command;

/// What of a page is run and shown.
#[derive(Default, Debug)]
pub(super) struct Page {
    pub(super) steps: Vec<Step>,
    /// Pictures that are shown, relative to the page, each with its line, counted from 1.
    pub(super) pictures: Vec<(usize, String)>,
}

/// A command and what it prints.
#[derive(Debug)]
pub(super) struct Step {
    /// Counted from 1.
    pub(super) line: usize,
    pub(super) command: Command,
    /// The lines, counted from 0, that hold what it prints.
    pub(super) printed: Option<Range<usize>>,
}

/// What kind of fence is open.
#[derive(Clone, Copy, PartialEq)]
enum Fence {
    Commands,
    Output { start: usize },
    Other,
}

impl Page {
    /// Reads a page.
    ///
    /// # Errors
    /// The line and what is wrong with it.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let mut page = Self::default();
        let mut fence = None;
        // A command that goes on, and the line that it began on.
        let mut unfinished: Option<(usize, String)> = None;
        for (index, line) in text.lines().enumerate() {
            let place = |message: String| format!("line {}: {message}", index + 1);
            if let Some(info) = line.trim_start().strip_prefix("```") {
                fence = match fence {
                    None => Some(opened(info.trim(), index + 1)),
                    Some(Fence::Output { start }) => {
                        page.set_printed(start..index).map_err(place)?;
                        None
                    }
                    Some(_) if unfinished.is_some() => {
                        return Err(place("the command before goes on, but its block ends".to_owned()));
                    }
                    Some(_) => None,
                };
                continue;
            }
            match fence {
                Some(Fence::Commands) => {
                    let (start, mut command) = unfinished.take().unwrap_or((index + 1, String::new()));
                    command.push_str(line.trim());
                    if let Some(part) = command.strip_suffix('\\') {
                        unfinished = Some((start, part.to_owned()));
                    } else if !command.is_empty() && !command.starts_with('#') {
                        let command = Command::parse(&command).map_err(place)?;
                        page.steps.push(Step { line: start, command, printed: None });
                    }
                }
                Some(_) => {}
                None => page.pictures.extend(pictures(line).map(|picture| (index + 1, picture))),
            }
        }
        if fence.is_some() {
            return Err("the last fence is not closed".to_owned());
        }
        Ok(page)
    }

    fn set_printed(&mut self, lines: Range<usize>) -> Result<(), String> {
        let step = self.steps.last_mut().filter(|step| step.printed.is_none());
        let step = step.ok_or("there is no command before that this could be the output of")?;
        step.printed = Some(lines);
        Ok(())
    }
}

fn opened(info: &str, next_line: usize) -> Fence {
    match info {
        "sh guide" => Fence::Commands,
        "text output" => Fence::Output { start: next_line },
        _ => Fence::Other,
    }
}

/// The files of `![text](file)` and `src="file"` on a line.
fn pictures(line: &str) -> impl Iterator<Item = String> {
    let images = line.match_indices("![").filter_map(|(at, _)| {
        let target = line[at..].split_once("](")?.1;
        Some(target.split_once(')')?.0.to_owned())
    });
    let sources = line.match_indices("src=\"").filter_map(|(at, opening)| {
        let target = &line[at + opening.len()..];
        Some(target.split_once('"')?.0.to_owned())
    });
    images.chain(sources)
}

/// The text with the lines of each range replaced; ranges in order, without overlap. Replacements end with a line feed.
pub(super) fn with_printed(text: &str, replacements: &[(Range<usize>, String)]) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let mut result = String::new();
    let mut next = 0;
    for (range, replacement) in replacements {
        result.extend(lines[next..range.start].iter().copied());
        result.push_str(replacement);
        next = range.end;
    }
    result.extend(lines[next..].iter().copied());
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# A page\n\n```sh guide\n# comment\ntrigon render a.svg \\\n  -o b.png\ntrigon explain a.svg\n```\n\n\
        ```text output\nold\n```\n\n```sh\nrm everything\n```\n![A picture](b.png) <img src=\"c.png\">\n";

    #[test]
    fn commands_outputs_and_pictures_are_found() {
        let page = Page::parse(TEXT).unwrap();
        assert_eq!(page.steps.len(), 2);
        assert_eq!((page.steps[0].line, page.steps[0].command.output()), (5, Some("b.png")));
        assert_eq!(page.steps[0].command.arguments, ["render", "a.svg", "-o", "b.png"]);
        assert_eq!((page.steps[0].printed.clone(), page.steps[1].printed.clone()), (None, Some(10..11)));
        assert_eq!(page.pictures, [(17, "b.png".to_owned()), (17, "c.png".to_owned())]);
    }

    #[test]
    fn printed_lines_are_replaced() {
        let new = with_printed(TEXT, &[(10..11, "one\ntwo\n".to_owned())]);
        assert_eq!(new, TEXT.replace("old\n", "one\ntwo\n"));
    }

    #[test]
    fn broken_pages_say_where() {
        for (text, line) in [
            ("```sh guide\ntrigon a | b\n```\n", "line 2"),
            ("```text output\nx\n```\n", "line 3"),
            ("```sh guide\ntrigon a \\\n```\n", "line 3"),
            ("```sh guide\n", "not closed"),
        ] {
            let error = Page::parse(text).unwrap_err();
            assert!(error.contains(line), "{error}");
        }
    }
}
