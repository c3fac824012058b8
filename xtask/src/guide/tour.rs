//! All pages of the guide, one after the other: their commands are run, their pictures and texts written or compared.

use std::path::{Path, PathBuf};

use super::page::{Page, Step, with_printed};
use super::program::Program;

/// The pages.
const PAGES: &str = "docs/guide";

/// Their pictures.
const PICTURES: &str = "docs/guide/images";

/// Where `check` makes pictures, below the target folder.
const SCRATCH: &str = "guide";

/// Runs the commands of all pages whose name contains `filter`, and keeps what they write and print.
pub(crate) fn write(root: &Path, filter: &str) -> Result<(), String> {
    let mut tour = Tour::new(root, filter)?;
    tour.visit(|tour, page, name, text| {
        let mut printed = Vec::new();
        for step in &page.steps {
            if let Some(folder) =
                step.command.output().and_then(|file| tour.root.join(file).parent().map(Path::to_owned))
            {
                std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
            }
            let output = tour.program.run(&step.command.arguments).map_err(|error| place(name, step, &error))?;
            printed.extend(step.printed.clone().map(|range| (range, output)));
            println!("{}", step.command.output().unwrap_or("(text)"));
        }
        let new = with_printed(text, &printed);
        if new != text {
            std::fs::write(tour.root.join(name), new).map_err(|error| format!("{name}: {error}"))?;
        }
        Ok(())
    })
}

/// Fails if a command of a page writes or prints anything else than what is stored.
pub(crate) fn check(root: &Path, filter: &str) -> Result<(), String> {
    let mut tour = Tour::new(root, filter)?;
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |folder| root.join(folder));
    let scratch = target.join(SCRATCH);
    std::fs::create_dir_all(&scratch).map_err(|error| format!("{}: {error}", scratch.display()))?;
    tour.visit(|tour, page, name, text| {
        for step in &page.steps {
            if let Err(error) = tour.compare(step, &scratch, text) {
                tour.problems.push(place(name, step, &error));
            }
        }
        Ok(())
    })
}

/// `page:line: message`.
fn place(name: &str, step: &Step, message: &str) -> String {
    format!("{name}:{}: {message}", step.line)
}

/// The pages at hand and what is wrong with them.
struct Tour {
    root: PathBuf,
    program: Program,
    /// Relative to the root, in order.
    pages: Vec<String>,
    /// False if some pages are left out.
    is_whole: bool,
    shown: Vec<String>,
    problems: Vec<String>,
}

impl Tour {
    fn new(root: &Path, filter: &str) -> Result<Self, String> {
        let mut pages = names(root, PAGES)?;
        pages.retain(|name| name.ends_with(".md") && name.contains(filter));
        if pages.is_empty() {
            return Err(format!("no page in {PAGES} has '{filter}' in its name"));
        }
        let program = Program::build(root)?;
        Ok(Self {
            root: root.to_owned(),
            program,
            pages,
            is_whole: filter.is_empty(),
            shown: Vec::new(),
            problems: Vec::new(),
        })
    }

    /// Does `work` with each page (its name and text), then looks for pictures that nothing makes or shows.
    fn visit(&mut self, work: impl Fn(&mut Self, &Page, &str, &str) -> Result<(), String>) -> Result<(), String> {
        let mut steps = 0;
        for name in self.pages.clone() {
            let text = std::fs::read_to_string(self.root.join(&name)).map_err(|error| format!("{name}: {error}"))?;
            let page = Page::parse(&text).map_err(|error| format!("{name}: {error}"))?;
            work(self, &page, &name, &text)?;
            self.look_at_pictures(&page, &name);
            steps += page.steps.len();
        }
        if self.is_whole {
            self.look_for_leftovers()?;
        }
        if self.problems.is_empty() {
            println!("guide: {} pages, {steps} commands", self.pages.len());
            Ok(())
        } else {
            Err(format!(
                "{}\nafter an intended change, run `cargo xtask guide` and commit it",
                self.problems.join("\n")
            ))
        }
    }

    /// Runs one command aside.
    fn compare(&self, step: &Step, scratch: &Path, text: &str) -> Result<(), String> {
        let stored = step.command.output();
        let aside = stored.map(|file| scratch.join(file.replace(['/', '\\'], "-")));
        let arguments = match &aside {
            Some(aside) => step.command.arguments_to(&aside.to_string_lossy()),
            None => step.command.arguments.clone(),
        };
        let printed = self.program.run(&arguments)?;
        if let (Some(stored), Some(aside)) = (stored, aside) {
            let read = |path: &Path| std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()));
            if read(&self.root.join(stored))? != read(&aside)? {
                return Err(format!("{stored} is not what the command makes, which is {}", aside.display()));
            }
        }
        let expected: Option<String> = step
            .printed
            .clone()
            .map(|range| text.lines().skip(range.start).take(range.len()).flat_map(|line| [line, "\n"]).collect());
        match expected {
            Some(expected) if expected != printed => Err(format!("the command prints:\n{printed}")),
            _ => Ok(()),
        }
    }

    /// Notes the pictures that a page shows, and those among them that it does not make.
    fn look_at_pictures(&mut self, page: &Page, name: &str) {
        for (line, picture) in &page.pictures {
            let path = format!("{PAGES}/{picture}");
            if !page.steps.iter().any(|step| step.command.output() == Some(&path)) {
                self.problems.push(format!("{name}:{line}: no command on the page makes {path}"));
            }
            self.shown.push(path);
        }
        // Some are only there for a later command, which enlarges them.
        self.shown.extend(page.steps.iter().filter_map(|step| step.command.output()).map(str::to_owned));
    }

    fn look_for_leftovers(&mut self) -> Result<(), String> {
        for name in names(&self.root, PICTURES)? {
            if !self.shown.contains(&name) {
                self.problems.push(format!("{name}: no page makes it"));
            }
        }
        Ok(())
    }
}

/// The files in a folder, relative to the root, with forward slashes, in order; none if there is no folder.
fn names(root: &Path, folder: &str) -> Result<Vec<String>, String> {
    let path = root.join(folder);
    if !path.is_dir() {
        return Ok(Vec::new());
    }
    let failed = |error: std::io::Error| format!("cannot list {folder}: {error}");
    let mut names = Vec::new();
    for entry in std::fs::read_dir(&path).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        if entry.file_type().map_err(failed)?.is_file() {
            names.push(format!("{folder}/{}", entry.file_name().to_string_lossy()));
        }
    }
    names.sort();
    Ok(names)
}
