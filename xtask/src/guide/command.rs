//! One command line of a page: words, and the file that it writes.
//!
//! Understood are words, `'...'`, `"..."` and a comment after `#`. Pipes, redirections and variables are refused: the
//! same words must mean the same on every system.

/// A command with what it writes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Command {
    /// The arguments after the program's name.
    pub(super) arguments: Vec<String>,
    /// Which of them names the file that is written.
    output: Option<usize>,
}

impl Command {
    /// Reads `trigon ...`.
    pub(super) fn parse(line: &str) -> Result<Self, String> {
        let mut words = words(line)?;
        if words.first().is_none_or(|word| word != "trigon") {
            return Err("only commands of 'trigon' can be run here".to_owned());
        }
        words.remove(0);
        let is_hidden = |word: &String| {
            word.starts_with("--output=") || word.starts_with("--json=") || (word.starts_with("-o") && word != "-o")
        };
        if let Some(word) = words.iter().find(|word| is_hidden(word)) {
            return Err(format!("'{word}' names a file within a word; write -o FILE, as two words"));
        }
        let flag = words.iter().position(|word| word == "-o" || word == "--output");
        let output = flag.map(|flag| flag + 1);
        if output.is_some_and(|output| output >= words.len()) {
            return Err("a file is missing after the output option".to_owned());
        }
        Ok(Self { arguments: words, output })
    }

    /// The file that it writes, relative to the workspace's root.
    pub(super) fn output(&self) -> Option<&str> {
        self.output.map(|index| self.arguments[index].as_str())
    }

    /// The arguments with another file to write.
    pub(super) fn arguments_to(&self, output: &str) -> Vec<String> {
        let mut arguments = self.arguments.clone();
        if let Some(index) = self.output {
            output.clone_into(&mut arguments[index]);
        }
        arguments
    }
}

fn words(line: &str) -> Result<Vec<String>, String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for character in line.chars() {
        match (quote, character) {
            (Some(open), _) if character == open => quote = None,
            (Some(_), _) => word.get_or_insert_default().push(character),
            (None, '\'' | '"') => {
                quote = Some(character);
                word.get_or_insert_default();
            }
            (None, '#') if word.is_none() => break,
            (None, '|' | '>' | '<' | '$' | '`' | ';' | '&' | '*' | '\\') => {
                return Err(format!("'{character}' needs a shell, and there is none; put it in quotes if it is meant"));
            }
            (None, _) if character.is_whitespace() => words.extend(word.take()),
            (None, _) => word.get_or_insert_default().push(character),
        }
    }
    if quote.is_some() {
        return Err("a quote is not closed".to_owned());
    }
    words.extend(word);
    Ok(words)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_quotes_and_comments_are_told_apart() {
        let command = Command::parse("trigon render 'a b.svg' -o \"c.png\" --size 4x4 # small").unwrap();
        assert_eq!(command.arguments, ["render", "a b.svg", "-o", "c.png", "--size", "4x4"]);
        assert_eq!(command.output(), Some("c.png"));
        assert_eq!(command.arguments_to("d.png")[3], "d.png");
    }

    #[test]
    fn what_needs_a_shell_is_refused() {
        for line in
            ["trigon render a.svg | cat", "trigon render $A", "cargo run", "trigon 'a", "trigon render a -o", ""]
        {
            assert!(Command::parse(line).is_err(), "{line}");
        }
    }
}
